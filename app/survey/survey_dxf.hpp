// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "app/survey/survey_point.hpp"

namespace planum::app {

/// Whether bytes look like a DXF drawing, text or binary.
[[nodiscard]] bool is_dxf(std::string_view bytes) noexcept;

/// Reads measured points from the entities of a DXF drawing (Autodesk's text form): a POINT, with the layer as code and
/// the nearest TEXT or MTEXT of its layer within 0.25 m as label; an INSERT, with the block (else the layer) as
/// code and its attributes as label; a TEXT that no point took, when it is a code with a number. Label texts are
/// codes or numbers. Throws BadInput for a binary drawing, a broken one, or one without points.
[[nodiscard]] SurveyFile read_survey_dxf(std::string_view bytes, std::string_view file_name);

} // namespace planum::app
