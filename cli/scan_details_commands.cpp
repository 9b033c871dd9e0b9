// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/scans/scan_details.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"

namespace planum::cli {

using nlohmann::ordered_json;
using store::OpenMode;

namespace {

struct ImageOptions {
    std::string scan;
    std::size_t number = 1;
    std::string output;
};

ordered_json text_or_null(const std::string& text) { return text.empty() ? ordered_json(nullptr) : ordered_json(text); }

ordered_json bounds_json(const std::optional<app::ScanExtent>& bounds) {
    if (!bounds) return nullptr;
    return {{"minimum", bounds->minimum}, {"maximum", bounds->maximum}};
}

ordered_json intensity_json(const std::optional<app::ScanIntensity>& intensity) {
    if (!intensity) return nullptr;
    return {{"offset", intensity->offset},
            {"step", intensity->step},
            {"limits", intensity->limits ? ordered_json(*intensity->limits) : ordered_json(nullptr)}};
}

ordered_json original_json(const app::OriginalDetails& original) {
    ordered_json images = ordered_json::array();
    for (const app::ScanImage& image : original.images) {
        images.push_back({{"type", image.type},
                          {"width", image.width},
                          {"height", image.height},
                          {"bytes", image.bytes},
                          {"representation", image.representation}});
    }
    return {{"variant", original.variant},
            {"clouds", original.clouds},
            {"records", original.records},
            {"attributes", original.attributes},
            {"channels", original.channels},
            {"intensity", intensity_json(original.intensity)},
            {"stated_bounds", bounds_json(original.stated_bounds)},
            {"time_zero", text_or_null(original.time_zero)},
            {"software", text_or_null(original.software)},
            {"created_at", text_or_null(original.created_at)},
            {"coordinate_system", text_or_null(original.coordinate_system)},
            {"column_guess", text_or_null(original.column_guess)},
            {"images", images},
            {"notes", original.notes}};
}

ordered_json to_json(const app::ScanDetails& details) {
    const model::Scan& scan = details.scan;
    const bool placed = details.listed.status == "registered";
    return {{"scan", scan.name},
            {"day", scan.day},
            {"surface", details.listed.surface},
            {"file", scan.path},
            {"sha256", scan.sha256},
            {"format", scan.format},
            {"cloud", scan.cloud},
            {"points", scan.points},
            {"rows", scan.rows},
            {"columns", scan.columns},
            {"bounds", bounds_json(details.store.bounds)},
            {"channels", details.store.channels},
            {"sensor", text_or_null(scan.sensor)},
            {"acquired_at", text_or_null(scan.acquired_at)},
            {"header_pose", scan.header_pose ? ordered_json(*scan.header_pose) : ordered_json(nullptr)},
            {"status", details.listed.status},
            {"site_from_scan", placed ? ordered_json(details.listed.site_from_scan) : ordered_json(nullptr)},
            {"verdict", text_or_null(details.listed.verdict)},
            {"store",
             {{"file", details.store.file},
              {"bytes", details.store.file_bytes},
              {"nodes", details.store.nodes},
              {"levels", details.store.levels}}},
            {"original", details.original ? original_json(*details.original) : ordered_json(nullptr)},
            {"original_trouble", text_or_null(details.original_trouble)}};
}

// Lines of a name and what it is, one under the other; what is empty is left out.
class Lines {
  public:
    explicit Lines(std::ostream& out) : out_(&out) {}

    void line(std::string_view name, const std::string& what) {
        if (!what.empty()) *out_ << fmt::format("  {:<12} {}\n", name, what);
    }

  private:
    std::ostream* out_;
};

std::string megabytes(std::uint64_t bytes) { return fmt::format("{:.2f} MB", static_cast<double>(bytes) / 1e6); }

std::string extent(const std::optional<app::ScanExtent>& bounds) {
    if (!bounds) return "no points";
    const auto axis = [&](std::size_t i) {
        return fmt::format("{:.3f} to {:.3f}", bounds->minimum[i], bounds->maximum[i]);
    };
    return fmt::format("x {}, y {}, z {} m in the scanner's frame", axis(0), axis(1), axis(2));
}

std::string header_pose(const model::Scan& scan) {
    if (!scan.header_pose) return "none in the file";
    const auto& pose = *scan.header_pose;
    return fmt::format("stands at {:.3f} {:.3f} {:.3f} by the file; a start value, not believed", pose[3], pose[7],
                       pose[11]);
}

std::string standing(const app::ListedScan& listed) {
    if (listed.status != "registered") return "not registered yet";
    const auto& pose = listed.site_from_scan;
    return fmt::format("at {:.3f} {:.3f} {:.3f} on the site grid by {}, position within {:.1f} mm, turn within {:.3f} "
                       "degrees",
                       pose[3], pose[7], pose[11], listed.method, listed.sigma_position * 1e3,
                       listed.sigma_rotation_deg);
}

void print_original(Lines& lines, const app::OriginalDetails& original) {
    lines.line("in the file", fmt::format("{}; of each: {}", text::counted(original.records, "record", "records"),
                                          text::join(original.attributes, ", ")));
    lines.line("columns", original.column_guess);
    if (original.intensity) {
        const app::ScanIntensity& intensity = *original.intensity;
        std::string meaning = fmt::format("in steps of {:.6g} from {:.6g}", intensity.step, intensity.offset);
        if (intensity.limits) {
            meaning +=
                fmt::format(", by the file from {:.6g} to {:.6g}", (*intensity.limits)[0], (*intensity.limits)[1]);
        }
        lines.line("intensity", meaning);
    }
    lines.line("times", original.time_zero);
    lines.line("written", original.created_at);
    lines.line("software", original.software);
    lines.line("coordinates", original.coordinate_system);
    for (std::size_t i = 0; i < original.images.size(); ++i) {
        const app::ScanImage& image = original.images[i];
        lines.line(fmt::format("image {}", i + 1),
                   fmt::format("{} {} x {}, {}, {}", image.type, image.width, image.height, megabytes(image.bytes),
                               image.representation));
    }
    for (const std::string& note : original.notes) lines.line("note", note);
}

void run_show(const Context& context, const std::string& name) {
    app::Project project = context.open(OpenMode::ReadOnly);
    const app::ScanDetails details = app::scan_details(project, name, *context.progress);
    if (context.json) return context.print(to_json(details));
    const model::Scan& scan = details.scan;
    *context.out << scan.name << '\n';
    Lines lines(*context.out);
    std::string kind = scan.format;
    if (details.original && !details.original->variant.empty()) kind += " " + details.original->variant;
    if (details.original && details.original->clouds > 1) {
        kind += fmt::format(", cloud {} of {}", scan.cloud + 1, details.original->clouds);
    }
    lines.line("file", fmt::format("{} ({})", scan.path, kind));
    lines.line("day", fmt::format("{}, surface {}", scan.day, details.listed.surface));
    lines.line("points", fmt::format("{}{}", scan.points,
                                     scan.rows > 0 ? fmt::format(", grid {} x {}", text::counted(scan.rows, "row"),
                                                                 text::counted(scan.columns, "column"))
                                                   : ""));
    lines.line("extent", extent(details.store.bounds));
    const std::vector<std::string>& kept = details.store.channels;
    lines.line("kept", kept.empty() ? "coordinates only" : "coordinates, " + text::join(kept, ", "));
    lines.line("scanner", scan.sensor);
    lines.line("acquired", scan.acquired_at);
    lines.line("header pose", header_pose(scan));
    lines.line("registered", standing(details.listed));
    lines.line("verdict", details.listed.verdict);
    lines.line("store", fmt::format("{}, {}, {} in {}", details.store.file, megabytes(details.store.file_bytes),
                                    text::counted(details.store.nodes, "block", "blocks"),
                                    text::counted(details.store.levels, "level", "levels")));
    if (details.original) print_original(lines, *details.original);
    lines.line("original", details.original_trouble);
}

void run_image(const Context& context, const ImageOptions& options) {
    app::Project project = context.open(OpenMode::ReadOnly);
    const std::string bytes = app::scan_image(project, options.scan, options.number, *context.progress);
    // It is written as it is, so that its name must say what it is.
    const bool jpeg = bytes.starts_with("\xFF\xD8");
    const std::string ending = text::fold_case(std::filesystem::path(options.output).extension().string());
    if (jpeg ? ending != ".jpg" && ending != ".jpeg" : ending != ".png") {
        throw Error(ErrorCode::Usage, fmt::format("{}: the image is a {} file; name it {}", options.output,
                                                  jpeg ? "JPEG" : "PNG", jpeg ? ".jpg" : ".png"));
    }
    write_file_atomically(options.output, bytes);
    context.say(fmt::format("wrote {}, {}", options.output, megabytes(bytes.size())));
}

} // namespace

void add_scan_details_commands(CLI::App& root, Context& context) {
    CLI::App* scan = root.get_subcommand("scan");
    auto name = std::make_shared<std::string>();
    CLI::App* show = add_command(*scan, context, "show", "say all that is known of one scan and its file");
    show->add_option("SCAN", *name, "DAY/STEM")->required();
    show->callback([&context, name] { run_show(context, *name); });

    auto options = std::make_shared<ImageOptions>();
    CLI::App* image = add_command(*scan, context, "image", "write a photograph that the scan's file holds (E57)");
    image->add_option("SCAN", options->scan, "DAY/STEM")->required();
    image->add_option("--number", options->number, "which of the images (default: the first)");
    image->add_option("-o,--output", options->output, "file to write: the JPEG or PNG as it is in the scan")
        ->required();
    image->callback([&context, options] { run_image(context, *options); });
}

} // namespace planum::cli
