// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/reduction/effective_properties.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fretwork::reduction {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr std::array<Eigen::Index, 3> kMembraneDofs = {0, 1, 5};  // ux uy rz
constexpr std::array<Eigen::Index, 3> kBendingDofs = {2, 3, 4};   // uz rx ry

/// The displacements (ux, uy, rz) of a point under unit strains e_xx, e_yy, 2 e_xy; one column each.
Matrix3d strained(const Vector3d& x) {
    return Matrix3d{{x.x(), 0.0, x.y() / 2.0}, {0.0, x.y(), x.x() / 2.0}, {0.0, 0.0, 0.0}};
}

/// The displacements (uz, rx, ry) of a point under unit curvatures w_xx, w_yy, 2 w_xy: uz = w, rx = w_y and
/// ry = -w_x, with w = x.k x / 2.
Matrix3d curved(const Vector3d& x) {
    return Matrix3d{{x.x() * x.x() / 2.0, x.y() * x.y() / 2.0, x.x() * x.y() / 2.0},
                    {0.0, x.y(), x.x() / 2.0},
                    {-x.x(), 0.0, -x.y() / 2.0}};
}

/// The matrix that gives the fluctuations of all nodes (three components each) from the fluctuations of the
/// nodes on the first half of the sides. A node and its opposite node have the same fluctuation, because the
/// node coincides with the opposite node of the neighbouring tile.
MatrixXd periodic_fluctuations(int nodes, int nodes_a_side) {
    const int half = nodes / 2;
    MatrixXd result = MatrixXd::Zero(3 * nodes, 3 * half);
    for (int node = 0; node < half; ++node) {
        const int mirrored = nodes_a_side - 1 - node % nodes_a_side;
        const int opposite = half + node - node % nodes_a_side + mirrored;
        result.block<3, 3>(3 * node, 3 * node).setIdentity();
        result.block<3, 3>(3 * opposite, 3 * node).setIdentity();
    }
    return result;
}

/// The second derivatives of the energy per area with respect to the amplitudes of the macroscopic modes,
/// with the energy minimized over periodic fluctuations.
Matrix3d homogenized(const MatrixXd& K, const MatrixXd& macroscopic, const MatrixXd& periodic, double area) {
    // The matrix is singular, because translations cost no energy. The system is still solvable, and any
    // solution is valid.
    const MatrixXd coupling = periodic.transpose() * K * macroscopic;
    const MatrixXd fluctuation =
        (periodic.transpose() * K * periodic).completeOrthogonalDecomposition().solve(-coupling);
    const Matrix3d energy = macroscopic.transpose() * K * macroscopic + coupling.transpose() * fluctuation;
    return (energy + energy.transpose()) / (2.0 * area);
}

std::vector<Eigen::Index> dofs_of(int nodes, const std::array<Eigen::Index, 3>& components) {
    std::vector<Eigen::Index> result;
    for (int node = 0; node < nodes; ++node) {
        for (const Eigen::Index component : components) result.push_back(6 * node + component);
    }
    return result;
}

double beam_length(const mechanics::Frame& frame) {
    double sum = 0.0;
    for (const mechanics::Beam& beam : frame.beams) {
        sum += (frame.nodes[beam.nodes[0]] - frame.nodes[beam.nodes[1]]).norm();
    }
    return sum;
}

double anisotropy(const Matrix3d& tensor) {
    double least = directional_stiffness(tensor, 0.0);
    double most = least;
    for (int degree = 1; degree < 180; ++degree) {
        const double stiffness = directional_stiffness(tensor, degree * std::numbers::pi / 180.0);
        least = std::min(least, stiffness);
        most = std::max(most, stiffness);
    }
    return most / least;
}

void add_values(const std::string& prefix, const Matrix3d& tensor,
                std::vector<std::pair<std::string, double>>& values) {
    const Matrix3d compliance = tensor.inverse();
    values.emplace_back(prefix + "_stiffness", 1.0 / compliance(0, 0));
    values.emplace_back(prefix + "_poisson", -compliance(0, 1) / compliance(0, 0));
    values.emplace_back(prefix + "_shear", 1.0 / compliance(2, 2));
    values.emplace_back(prefix + "_anisotropy", anisotropy(tensor));
}

void add_components(const std::string& name, const Matrix3d& tensor,
                    std::vector<std::pair<std::string, double>>& values) {
    constexpr std::array kVoigt = {"1", "2", "6"};
    for (int i = 0; i < 3; ++i) {
        for (int j = i; j < 3; ++j) {
            values.emplace_back(name + kVoigt[i] + kVoigt[j], tensor(i, j));
        }
    }
}

}  // namespace

EffectiveProperties effective_properties(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                                         const Setting& setting) {
    if (setting.sides != 4 && setting.sides != 6) {
        throw base::InputError("regular polygons of " + std::to_string(setting.sides) +
                               " sides do not tile the plane by translations; four or six sides do");
    }
    const mechanics::Frame frame = pattern_frame(layout, pattern, setting);
    const auto nodes_a_side = static_cast<int>(layout.interface_nodes().size());
    const int nodes = setting.sides * nodes_a_side;
    const MatrixXd K = condensed_frame(frame, nodes);
    MatrixXd membrane(3 * nodes, 3);
    MatrixXd bending(3 * nodes, 3);
    for (int node = 0; node < nodes; ++node) {
        membrane.middleRows<3>(3 * node) = strained(frame.nodes[node]);
        bending.middleRows<3>(3 * node) = curved(frame.nodes[node]);
    }
    const double area = geometry::signed_area(geometry::regular_polygon(setting.sides, setting.tile_side));
    const MatrixXd periodic = periodic_fluctuations(nodes, nodes_a_side);
    const auto membrane_dofs = dofs_of(nodes, kMembraneDofs);
    const auto bending_dofs = dofs_of(nodes, kBendingDofs);
    return {homogenized(K(membrane_dofs, membrane_dofs), membrane, periodic, area),
            homogenized(K(bending_dofs, bending_dofs), bending, periodic, area),
            setting.material.density * setting.section.area * beam_length(frame) / area};
}

double directional_stiffness(const Matrix3d& tensor, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    // A unit stress along the direction, in Voigt's notation.
    const Vector3d stress(c * c, s * s, c * s);
    return 1.0 / stress.dot(tensor.inverse() * stress);
}

std::vector<std::pair<std::string, double>> property_values(const EffectiveProperties& properties) {
    std::vector<std::pair<std::string, double>> values;
    add_values("membrane", properties.A, values);
    add_values("bending", properties.D, values);
    values.emplace_back("mass_per_area", properties.mass_per_area);
    add_components("A", properties.A, values);
    add_components("D", properties.D, values);
    return values;
}

}  // namespace fretwork::reduction
