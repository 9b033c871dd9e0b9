// SPDX-License-Identifier: MIT
#pragma once

namespace planum::paint {

/// Makes sure that Qt can measure and draw text. Where the program has made no application object yet (the
/// command line, tests), one without a display is made and kept to the end of the process. To be called
/// from the main thread first; drawing afterwards may happen in any thread. Every function of paint/ does it.
void ensure_qt_runtime();

} // namespace planum::paint
