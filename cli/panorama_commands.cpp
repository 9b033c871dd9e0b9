// SPDX-License-Identifier: MIT
#include "cli/context.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/scans/panorama_file.hpp"
#include "core/base/text.hpp"

namespace planum::cli {

using nlohmann::ordered_json;

namespace {

struct Options {
    std::string scan;
    std::string file;
    app::PanoramaRequest request;
};

void run_panorama(const Context& context, const Options& options) {
    app::Project project = context.open(store::OpenMode::ReadOnly);
    const app::WrittenPanorama made =
        app::write_scan_panorama(project, options.scan, options.file, options.request, *context.progress);
    if (context.json) {
        const ordered_json pose = made.site_from_scan ? ordered_json(*made.site_from_scan) : ordered_json(nullptr);
        return context.print({{"scan", made.scan},
                              {"file", made.picture.string()},
                              {"description", made.description.string()},
                              {"projection", options.request.projection},
                              {"channel", made.channel},
                              {"width", made.width},
                              {"height", made.height},
                              {"azimuth_left_deg", made.azimuth_left_deg},
                              {"azimuth_right_deg", made.azimuth_right_deg},
                              {"elevation_top_deg", made.elevation_top_deg},
                              {"elevation_bottom_deg", made.elevation_bottom_deg},
                              {"points", made.points},
                              {"points_outside", made.outside},
                              {"filled", made.filled},
                              {"from_grid", made.from_grid},
                              {"site_from_scan", pose}});
    }
    const double share = 100.0 * static_cast<double>(made.filled) / (static_cast<double>(made.width) * made.height);
    *context.out << fmt::format("{}: {} of {}, {}, {} x {} pixels, {:.0f} % of them filled, from {}\n", options.file,
                                made.channel, made.scan, options.request.projection, made.width, made.height, share,
                                text::counted(made.points, "point"));
    if (made.outside > 0) {
        context.say(fmt::format("{} above or below what this projection shows",
                                text::counted(made.outside, "point lies", "points lie")));
    }
}

} // namespace

void add_panorama_commands(CLI::App& root, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* panorama = add_command(root, context, "panorama", "unroll a scan around its scanner into a picture");
    panorama->add_option("SCAN", options->scan, "DAY/STEM, as planum scan list shows it")->required();
    panorama
        ->add_option("-o,--output", options->file, "picture to write (.png); what it shows goes into .json beside it")
        ->required();
    panorama
        ->add_option("--projection", options->request.projection,
                     "equirectangular, cylindrical, mercator, miller, equal-area, rectilinear, pannini, stereographic")
        ->capture_default_str();
    panorama->add_option("--channel", options->request.channel,
                         "reflectance, range, colour or normals (default: the first the scan has)");
    panorama
        ->add_option("--width", options->request.width,
                     "pixels across (default: one for each cell of the scanner's grid, or for a point)")
        ->check(CLI::Range(1, 100000));
    panorama->add_option("--views", options->request.views,
                         "pictures side by side in rectilinear, pannini and stereographic (default: as needed)");
    panorama->callback([&context, options] { run_panorama(context, *options); });
}

} // namespace planum::cli
