// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <typed/making_choice.hpp>

namespace fretwork::typed {
namespace {

double read_length(const std::string& name, const std::string& text) {
    constexpr double kLarge = 0.05;  // m; without a unit, this length or a larger one is refused
    base::refuse_missing_unit(name, text, kLarge);
    return base::parse_length_above_zero(name, text);
}

void set_length(double& value, const std::string& name, const std::string& text) {
    if (!text.empty()) value = read_length(name, text);
}

fabrication::Bed read_bed(const std::string& name, const std::string& text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos)
        throw base::InputError(name, "",
                               "'" + text + "' is not WIDTHxHEIGHT in millimetres, such as 600x400");
    const auto side = [&](const std::string& word) {
        if (const auto number = base::read_number<double>(word))
            return base::parse_length_above_zero(name, word + "mm");
        return base::parse_length_above_zero(name, word);
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

exports::Making read_making(const MakingChoice& choice, const simulation::Conditions* conditions) {
    const auto name = [&](const char* entry) { return choice.prefix + entry; };
    exports::Making making;
    set_length(making.shape.fillet, name("fillet"), choice.fillet);
    set_length(making.shape.kerf, name("kerf"), choice.kerf);
    set_length(making.shape.frame_width, name("frame"), choice.frame);
    set_length(making.shape.bolt_diameter, name("bolts"), choice.bolts);
    set_length(making.shape.eye_diameter, name("eye"), choice.eye);
    set_length(making.facts.clearance, name("clearance"), choice.clearance);
    set_length(making.facts.layer_height, name("layer"), choice.layer);
    if (!choice.bed.empty()) making.bed = read_bed(name("bed"), choice.bed);
    if (!choice.fit.empty()) {
        if (!making.bed)
            throw base::InputError(name("fit"), "",
                                   "is for the connectors of " + name("bed") + ", which is not given");
        making.bed->fit = read_length(name("fit"), choice.fit);
    }
    if (choice.bolts.empty()) {
        if (!choice.eye.empty())
            throw base::InputError(name("eye"), "", "is for " + name("bolts") + ", which is not given");
        return making;
    }
    if (conditions == nullptr)
        throw base::InputError(name("bolts"), "",
                               "needs " + (choice.prefix.empty() ? "a load case" : name("case")) +
                                   ": holes are at the supports of a load case");
    making.shape.bolts = supported_nodes(*conditions);
    return making;
}

}  // namespace fretwork::typed
