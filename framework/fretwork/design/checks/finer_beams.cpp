// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/design/checks/finer_beams.hpp>
#include <fretwork/mechanics/node_states.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/mechanics/results/section_stress.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/simulation_options.hpp>
#include <fretwork/simulation/surface_frame.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace fretwork::design::detail {
namespace {

using mechanics::Beam;
using mechanics::Frame;
using mechanics::NodeIndex;

/// The frame with one beam for each element, so that results include the ends of the elements.
Frame with_elements(Frame frame, int elements) {
    const auto beams = std::exchange(frame.beams, {});
    for (const Beam& beam : beams) {
        const Eigen::Vector3d start = frame.nodes[beam.nodes[0]];
        const Eigen::Vector3d whole = frame.nodes[beam.nodes[1]] - start;
        Beam part = beam;
        for (int k = 1; k <= elements; ++k) {
            part.nodes[1] = beam.nodes[1];
            if (k < elements) {
                part.nodes[1] = NodeIndex(frame.nodes.size());
                frame.nodes.push_back(start + whole * (static_cast<double>(k) / elements));
            }
            frame.beams.push_back(part);
            part.nodes[0] = part.nodes[1];
        }
    }
    return frame;
}

}  // namespace

std::optional<double> largest_stress(const simulation::Surface& surface,
                                     const simulation::LoadCase& load_case, const FinerBeams& options,
                                     const base::Control& control) {
    const Frame frame =
        with_elements(simulation::surface_frame(surface, simulation::reference_choice({}),
                                                simulation::resolve(load_case, surface), control),
                      options.elements);
    const std::array<double, 1> whole_load = {1.0};
    const mechanics::Solution solution =
        mechanics::follow_load_path(
            mechanics::assemble(frame), whole_load,
            {.branch = options.branch, .threads = options.threads, .control = control})
            .back();
    if (!solution.is_stable_equilibrium()) return std::nullopt;
    const mechanics::SectionPoints bar(surface.setting.section);
    const auto states = mechanics::node_states(solution.displacements);
    double largest = 0.0;
    for (const Beam& beam : frame.beams) {
        const auto [from, to] = beam.nodes;
        const mechanics::BeamSection section(beam, {frame.nodes[from], frame.nodes[to]});
        for (const mechanics::SectionForces& forces : section.large(states[from], states[to]))
            largest = std::max(largest, bar.largest(forces).von_mises);
    }
    return largest;
}

}  // namespace fretwork::design::detail
