// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <string>

namespace planum::gui {

/// What a service says (an error, a note, a verdict, a step of a job) as the window says it: in the language of the
/// window, and with what to press where the service names a command. A sentence that is not known stays as it is, but
/// for its advice on commands, which is left out: nobody can type it into a window.
[[nodiscard]] QString service_sentence(const QString& english);
[[nodiscard]] QString service_sentence(const std::string& english);

} // namespace planum::gui
