// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sample.hpp"

#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/linear_element.hpp>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace fretwork::mechanics::sample {

inline constexpr double kLength = 0.01;

inline Frame one_beam() {
    Frame frame;
    frame.nodes = {{0, 0, 0}, kLength * Eigen::Vector3d(0.6, -0.48, 0.64)};
    frame.beams.push_back(beam_between(0, 1));
    frame.beams[0].section = rectangle_section(0.002, 0.003);
    frame.beams[0].normal = Eigen::Vector3d(0.3, 1.0, 0.2);
    clamp(frame, 0);
    return frame;
}

inline std::shared_ptr<const Element> only_element(const Frame& frame) {
    return assemble(frame).elements.front();
}

/// A stiffness of three nodes with nothing special about it.
inline std::unique_ptr<const Element> some_linear_element() {
    Random random(7);
    Eigen::MatrixXd root(18, 18);
    for (double& entry : root.reshaped()) entry = random.next();
    return linear_element({NodeIndex(0), NodeIndex(1), NodeIndex(2)}, {.stiffness = root.transpose() * root});
}

/// One of each kind, under its name.
inline std::vector<std::pair<std::string, std::shared_ptr<const Element>>> every_kind() {
    std::vector<std::pair<std::string, std::shared_ptr<const Element>>> elements;
    Frame frame = one_beam();
    elements.emplace_back("Euler-Bernoulli", only_element(frame));
    frame.beams[0].releases = {{0, {{true, false, true, false, true, true}}},
                               {1, {{false, true, false, true, false, true}}}};
    elements.emplace_back("hinged", only_element(frame));
    frame.beams[0].section.shear_area2 = 1e-6;
    frame.beams[0].section.shear_area3 = 3e-6;
    elements.emplace_back("hinged Timoshenko", only_element(frame));
    frame.beams[0].releases.clear();
    elements.emplace_back("Timoshenko", only_element(frame));
    elements.emplace_back("linear", some_linear_element());
    return elements;
}

/// Nodes moved and turned at random, by up to `amplitude` in radians and lengths; then all but hinges turned
/// together.
inline std::vector<NodeState> random_states(std::size_t count, double amplitude, Random& random) {
    std::vector<NodeState> states(count);
    const Eigen::Quaterniond common = random.rotation();
    for (std::size_t i = 0; i < count; ++i) {
        states[i].displacement = amplitude * kLength * random.vector(1.0);
        states[i].rotation = geometry::exponential(amplitude * random.vector(1.0));
        if (i >= 2) continue;
        const Eigen::Vector3d rest = static_cast<double>(i) * kLength * Eigen::Vector3d(0.6, -0.48, 0.64);
        states[i].displacement += common * rest - rest;
        states[i].rotation = common * states[i].rotation;
    }
    return states;
}

inline void move(NodeState& state, int dof, double by) {
    if (dof < 3) {
        state.displacement[dof] += by;
    } else {
        state.rotation =
            (geometry::exponential(by * Eigen::Vector3d::Unit(dof - 3)) * state.rotation).normalized();
    }
}

/// Forces times the length, so that they and moments are of one kind.
inline Eigen::MatrixXd scaled(Eigen::MatrixXd values) {
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
        if (i % kDofsPerNode < 3) values.row(i) *= kLength;
        if (values.cols() > 1 && i % kDofsPerNode < 3) values.col(i) *= kLength;
    }
    return values;
}

}  // namespace fretwork::mechanics::sample
