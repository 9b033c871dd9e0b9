// SPDX-License-Identifier: MIT
// Measured points as a table, as a drawing and as a table of codes: refused with an Error, or read; all
// coordinates that were read are finite.
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "app/survey/code_table.hpp"
#include "app/survey/survey_csv.hpp"
#include "app/survey/survey_dxf.hpp"
#include "core/base/error.hpp"

namespace {

void use(const planum::app::SurveyFile& file, const planum::app::CodeTable& codes) {
    for (const auto& point : file.points) {
        if (!std::isfinite(point.x) || !std::isfinite(point.y)) std::abort();
        if (point.z && !std::isfinite(*point.z)) std::abort();
        (void)codes.read(point.code);
        (void)codes.read(point.name);
    }
}

template<class Work>
void attempt(Work work) {
    try {
        work();
    } catch (const planum::Error&) {
        // Refused in a sentence, which is what is wanted.
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size); // bytes are bytes
    planum::app::CodeTable codes;
    attempt([&] { codes.add_table(bytes, "codes.csv"); });
    attempt([&] { use(planum::app::read_survey_csv(bytes, "points.csv", ""), codes); });
    if (planum::app::is_dxf(bytes)) attempt([&] { use(planum::app::read_survey_dxf(bytes, "plan.dxf"), codes); });
    return 0;
}
