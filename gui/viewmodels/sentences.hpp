// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <string>

namespace planum::gui {

/// A sentence of the services (checks, reasons of suspicion, suggestions) in the language of the window. The services
/// speak English, in the project, on paper and on the command line alike, so that what is kept of them reads the same
/// for everybody; here their sentences are known by their fixed words, and what stands between these is translated
/// likewise. A sentence that is not known stays as it is.
[[nodiscard]] QString in_window_language(const QString& english);
[[nodiscard]] QString in_window_language(const std::string& english);

/// What a number of a problem's evidence is: `thickness_m` → `thickness [m]`.
[[nodiscard]] QString evidence_word(const std::string& name);

} // namespace planum::gui
