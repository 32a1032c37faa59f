// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork draw: chosen patterns on one sheet.
#include "options/file_options.hpp"
#include "verbs.hpp"

#include <fretwork/base/files/file.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/exports/drawings/pattern_drawing.hpp>

#include <memory>

namespace fretwork::app {
namespace {

struct DrawOptions {
    std::vector<std::string> ids;
    std::string layout = "paper7";
    std::string beam_width;
    std::string tile_side;
    std::string out;
};

void run(const DrawOptions& options) {
    const pattern::NodeLayout layout = pattern::find_node_layout(options.layout);
    std::vector<pattern::Pattern> patterns;
    for (const std::string& id : options.ids) patterns.push_back(pattern::parse_pattern_id(layout, id));
    exports::PatternDrawingOptions drawing;
    if (!options.beam_width.empty())
        drawing.beam_width = base::parse_length_above_zero("--beam-width", options.beam_width);
    if (!options.tile_side.empty())
        drawing.tile_side = base::parse_length_above_zero("--tile-side", options.tile_side);
    base::write_file_atomically(options.out, exports::pattern_sheet_svg(layout, patterns, drawing));
}

}  // namespace

void add_draw(CLI::App& app, ExitCode&) {
    CLI::App* verb = app.add_subcommand("draw", "Draw patterns by their ids, at true scale");
    const auto options = std::make_shared<DrawOptions>();
    verb->add_option("pattern", options->ids, "Ids of patterns")->required();
    verb->add_option("--layout", options->layout, "Node layout: a name or a file")->capture_default_str();
    verb->add_option("--tile-side", options->tile_side, "Side of the hexagon (default: the paper's, 26 mm)");
    verb->add_option("--beam-width", options->beam_width, "Width of the bars (default: 2mm)");
    verb->add_option("--out", options->out, "Drawing to write (.svg)")->required();
    declare_files(*verb, {input("--layout"), output("--out", kSvgFile)});
    verb->footer("Example: fretwork draw 0-1+1-6 2-4+4-6 --out patterns.svg");
    verb->callback([options] { run(*options); });
}

}  // namespace fretwork::app
