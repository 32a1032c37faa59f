// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/checks.hpp"
#include "options/making_options.hpp"

#include <algorithm>

namespace fretwork::app {

void add_making_options(CLI::App& verb, typed::MakingChoice& texts) {
    const std::string group = "Cutting and printing";
    const auto add = [&](const char* name, std::string& text, const char* words) {
        return verb.add_option(name, text, words)->type_name("LENGTH")->group(group);
    };
    add("--fillet", texts.fillet, "Radius of inner corners between bars (default: sharp)");
    add("--kerf", texts.kerf,
        "Width that the cutter removes. The cutting lines are moved out of the material by half of it, so "
        "that parts get their true size. Solids are not changed");
    add("--frame", texts.frame, "Width of a border along the rim");
    add("--bolts", texts.bolts, "Diameter of holes at the supports of --case");
    add("--eye", texts.eye,
        "Diameter of the disc of material around each hole of --bolts (default: twice that of the hole)");
    add("--bed", texts.bed,
        "Cut the surface into parts that fit on sheets of WIDTHxHEIGHT millimetres, with connectors between "
        "them, and arrange the parts on the sheets")
        ->type_name("WxH");
    add("--fit", texts.fit, "Gap in the connectors between parts (default: 0.05mm)");
    add("--clearance", texts.clearance,
        "Facts warn of gaps and openings narrower than this (default: 0.5mm)");
    add("--layer", texts.layer, "Height of a print's layers, for facts (default: 0.2mm)");
}

void refuse_ignored_making(const CLI::App& verb, std::span<const exports::WriterRow* const> writers) {
    const auto has_content = [&](exports::Content content) {
        return std::ranges::any_of(writers, [&](const auto* writer) { return writer->content == content; });
    };
    if (std::ranges::none_of(writers, [](const auto* writer) { return writer->is_made(); }))
        refuse_given(
            verb, {"--fillet", "--frame", "--bolts", "--eye"},
            "is for what is cut or printed, and no --to names such a file (.dxf, .stl, .3mf, or --content)");
    if (!has_content(exports::Content::Cut))
        refuse_given(verb, {"--bed", "--fit"},
                     "is for what is cut, and no --to names such a file (.dxf, --content cut)");
    if (!has_content(exports::Content::Cut) && !has_content(exports::Content::Facts))
        refuse_given(verb, {"--kerf"}, "is for what is cut and for facts, and no --to names such a file");
    if (!has_content(exports::Content::Facts))
        refuse_given(verb, {"--clearance", "--layer"}, "is for --content facts");
}

}  // namespace fretwork::app
