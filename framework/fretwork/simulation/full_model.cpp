// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/model_catalogue.hpp>

namespace fretwork::simulation {

mechanics::Frame full_model_frame(const Surface& surface, const Conditions& conditions) {
    mechanics::Frame frame;
    for (const pattern::Point2& node : surface.fan.nodes) frame.nodes.emplace_back(node.x, node.y, 0.0);
    for (const tiling::TessellationFan::Edge& edge : surface.fan.edges) {
        mechanics::Beam beam;
        beam.nodes = {mechanics::NodeIndex(edge.nodes[0].value), mechanics::NodeIndex(edge.nodes[1].value)};
        beam.section = surface.setting.section;
        beam.material = surface.setting.material;
        frame.beams.push_back(std::move(beam));
    }
    frame.supports = conditions.supports;
    frame.prescribed = conditions.prescribed;
    frame.loads = conditions.loads;
    return frame;
}

mechanics::Assembly build_full_model(const Surface& surface, const Conditions& conditions) {
    return mechanics::assemble(full_model_frame(surface, conditions));
}

}  // namespace fretwork::simulation
