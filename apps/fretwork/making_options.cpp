// SPDX-License-Identifier: GPL-3.0-or-later
#include "ignored_options.hpp"
#include "making_options.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>

namespace fretwork::app {
namespace {

double read_length(const std::string& option, const std::string& text) {
    try {
        const double length = base::parse_length(text);
        if (length > 0.0) return length;
    } catch (const base::InputError& error) {
        throw base::InputError(option, "", error.what());
    }
    throw base::InputError(option, "", "'" + text + "' is not a length above zero, such as 0.5mm");
}

void set_length(double& value, const std::string& option, const std::string& text) {
    if (!text.empty()) value = read_length(option, text);
}

/// "600x400" in millimetres, or with units: "60cmx40cm".
fabrication::Bed read_bed(const std::string& text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos)
        throw base::InputError("--bed", "",
                               "'" + text + "' is not WIDTHxHEIGHT in millimetres, such as 600x400");
    const auto side = [](const std::string& word) {
        if (const auto number = base::read_number<double>(word)) return read_length("--bed", word + "mm");
        return read_length("--bed", word);
    };
    fabrication::Bed bed;
    bed.width = side(text.substr(0, cross));
    bed.height = side(text.substr(cross + 1));
    return bed;
}

std::vector<fabrication::TessellationNodeIndex> supported_nodes(const simulation::Conditions& conditions) {
    std::vector<fabrication::TessellationNodeIndex> nodes;
    for (const mechanics::Support& support : conditions.supports) nodes.emplace_back(support.node.value);
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

}  // namespace

void add_making_options(CLI::App& verb, MakingTexts& texts) {
    const std::string group = "Cutting and printing";
    const auto add = [&](const char* name, std::string& text, const char* words) {
        return verb.add_option(name, text, words)->type_name("LENGTH")->group(group);
    };
    add("--fillet", texts.fillet, "Radius of inner corners between bars (default: sharp)");
    add("--kerf", texts.kerf, "Width that the cutter takes away; lines run half of it outside");
    add("--frame", texts.frame, "Width of a frame along the rim");
    add("--bolts", texts.bolts, "Diameter of holes at the supports of --case");
    add("--eye", texts.eye, "Diameter of the discs around these holes (default: twice theirs)");
    add("--bed", texts.bed,
        "Cut into parts with joints that fit sheets of WIDTHxHEIGHT millimetres, and nest these")
        ->type_name("WxH");
    add("--fit", texts.fit, "Gap that is left in the joints of parts (default: 0.05mm)");
    add("--clearance", texts.clearance, "Facts warn of gaps and openings that are narrower (default: 0.5mm)");
    add("--layer", texts.layer, "Height of a print's layers, for facts (default: 0.2mm)");
}

void refuse_ignored_making(const CLI::App& verb, std::span<const exports::WriterRow* const> writers) {
    const auto has_content = [&](exports::Content content) {
        return std::ranges::any_of(writers, [&](const auto* writer) { return writer->content == content; });
    };
    if (std::ranges::none_of(writers, [](const auto* writer) { return writer->is_made(); }))
        refuse_given(
            verb, {"--fillet", "--kerf", "--frame", "--bolts", "--eye"},
            "is for what is cut or printed, and no --to names such a file (.dxf, .stl, .3mf, or --content)");
    if (!has_content(exports::Content::Cut))
        refuse_given(verb, {"--bed", "--fit"},
                     "is for what is cut, and no --to names such a file (.dxf, --content cut)");
    if (!has_content(exports::Content::Facts))
        refuse_given(verb, {"--clearance", "--layer"}, "is for --content facts");
}

exports::Making read_making(const MakingTexts& texts, const simulation::Conditions* conditions) {
    exports::Making making;
    set_length(making.shape.fillet, "--fillet", texts.fillet);
    set_length(making.shape.kerf, "--kerf", texts.kerf);
    set_length(making.shape.frame_width, "--frame", texts.frame);
    set_length(making.shape.bolt_diameter, "--bolts", texts.bolts);
    set_length(making.shape.eye_diameter, "--eye", texts.eye);
    set_length(making.facts.clearance, "--clearance", texts.clearance);
    set_length(making.facts.layer_height, "--layer", texts.layer);
    if (!texts.bed.empty()) making.bed = read_bed(texts.bed);
    if (!texts.fit.empty()) {
        if (!making.bed)
            throw base::InputError("--fit", "", "is for the joints of --bed, which is not given");
        making.bed->fit = read_length("--fit", texts.fit);
    }
    if (texts.bolts.empty()) {
        if (!texts.eye.empty()) throw base::InputError("--eye", "", "is for --bolts, which is not given");
        return making;
    }
    if (conditions == nullptr)
        throw base::InputError("--bolts", "", "needs --case: holes are at the supports of a load case");
    making.shape.bolts = supported_nodes(*conditions);
    return making;
}

}  // namespace fretwork::app
