// SPDX-License-Identifier: GPL-3.0-or-later
// How many numbers span the condensed stiffness of all patterns in a hexagon, counted by singular values; and
// the stiffness of some patterns as JSON, for bounds.py. derivation.md, sections 2 and 5.
#include "instances.hpp"

#include <fretwork/simulation/derivatives/candidate_tiles.hpp>
#include <fretwork/simulation/surface.hpp>

#include <CLI/CLI.hpp>
#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <complex>
#include <cstdio>

namespace {

using namespace fretwork;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

constexpr Index kNodes = 6;
constexpr std::array<std::array<Index, 3>, 2> kDofs = {{{0, 1, 5}, {2, 3, 4}}};

/// Motions of the six nodes under one sixth of a turn about z: a motion is moved to the next node and turned.
MatrixXd sixth_of_a_turn() {
    const double c = 0.5;
    const double s = std::sqrt(0.75);
    Eigen::Matrix3d turn;
    turn << c, -s, 0, s, c, 0, 0, 0, 1;
    MatrixXd result = MatrixXd::Zero(6 * kNodes, 6 * kNodes);
    for (Index i = 0; i < kNodes; ++i) {
        const Index next = (i + 1) % kNodes;
        result.block<3, 3>(6 * next, 6 * i) = turn;
        result.block<3, 3>(6 * next + 3, 6 * i + 3) = turn;
    }
    return result;
}

/// Rotations as displacements at a length, so that all entries are of one size.
MatrixXd scaled(const MatrixXd& stiffness, double length) {
    Eigen::VectorXd scale = Eigen::VectorXd::Ones(stiffness.rows());
    for (Index i = 0; i < scale.size(); ++i) {
        if (i % 6 >= 3) scale[i] = 1.0 / length;
    }
    return scale.asDiagonal() * stiffness * scale.asDiagonal();
}

std::vector<Index> rows_of(const std::array<Index, 3>& dofs) {
    std::vector<Index> rows;
    for (Index i = 0; i < kNodes; ++i) {
        for (const Index dof : dofs) rows.push_back(6 * i + dof);
    }
    return rows;
}

/// Singular values of a family of matrices, as vectors, over the largest one.
Eigen::VectorXd spectrum(const std::vector<MatrixXd>& family) {
    MatrixXd columns(family.front().size(), std::ssize(family));
    for (Index i = 0; i < columns.cols(); ++i)
        columns.col(i) =
            family[static_cast<std::size_t>(i)].reshaped() / family[static_cast<std::size_t>(i)].norm();
    const Eigen::VectorXd values = Eigen::BDCSVD<MatrixXd>(columns).singularValues();
    return values / values[0];
}

int rank_of(const std::vector<MatrixXd>& family) {
    return static_cast<int>((spectrum(family).array() > 1e-10).count());
}

/// The projector onto motions that a sixth of a turn multiplies by exp(+-i pi k / 3).
MatrixXd projector(const MatrixXd& turn, int k) {
    MatrixXcd sum = MatrixXcd::Zero(turn.rows(), turn.cols());
    MatrixXd power = MatrixXd::Identity(turn.rows(), turn.cols());
    for (int j = 0; j < 6; ++j) {
        const double angle = 2.0 * 3.14159265358979323846 * k * j / 6.0;
        sum += std::complex<double>(std::cos(angle), -std::sin(angle)) * power / 6.0;
        power = turn * power;
    }
    return (k == 0 || k == 3 ? 1.0 : 2.0) * sum.real();
}

void print_numbers(const simulation::CandidateTiles& tiles, double length) {
    const MatrixXd turn = sixth_of_a_turn();
    const std::array<const char*, 2> names = {"in the plane", "out of the plane"};
    double commutator = 0.0;
    for (std::size_t p = 0; p < tiles.patterns().size(); ++p) {
        const MatrixXd stiffness = scaled(tiles.stiffness(0, p), length);
        commutator = std::max(commutator, (turn * stiffness - stiffness * turn).norm() / stiffness.norm());
    }
    std::printf("%zu patterns; commutator with a sixth of a turn at most %.1e\n", tiles.patterns().size(),
                commutator);
    for (std::size_t part = 0; part < 2; ++part) {
        const std::vector<Index> rows = rows_of(kDofs[part]);
        std::vector<MatrixXd> family;
        for (std::size_t p = 0; p < tiles.patterns().size(); ++p)
            family.emplace_back(scaled(tiles.stiffness(0, p), length)(rows, rows));
        const Eigen::VectorXd values = spectrum(family);
        std::printf("%s: %d numbers; singular values 21 to 24: %.1e %.1e %.1e %.1e; by k = 0, 1, 2, 3:",
                    names[part], rank_of(family), values[20], values[21], values[22], values[23]);
        const MatrixXd own_turn = turn(rows, rows);
        for (int k = 0; k < 4; ++k) {
            const MatrixXd project = projector(own_turn, k);
            std::vector<MatrixXd> projected;
            for (const MatrixXd& own : family) projected.emplace_back(project * own * project);
            std::printf(" %d", rank_of(projected));
        }
        std::printf("\n");
    }
}

/// Stiffness out of the plane, rotations scaled, node by node (uz rx ry).
void print_matrices(const simulation::CandidateTiles& tiles, double length) {
    const std::vector<Index> rows = rows_of(kDofs[1]);
    std::printf("{\"length\": %.17g, \"nodes\": [", length);
    for (std::size_t i = 0; i < 6; ++i) {
        const Eigen::Vector3d node = tiles.interface_nodes(0)[i];
        std::printf("%s[%.17g, %.17g]", i > 0 ? ", " : "", node.x(), node.y());
    }
    std::printf("], \"patterns\": [");
    for (std::size_t p = 0; p < tiles.patterns().size(); ++p)
        std::printf("%s\"%s\"", p > 0 ? ", " : "", tiles.patterns()[p].id.c_str());
    std::printf("], \"stiffness\": [");
    for (std::size_t p = 0; p < tiles.patterns().size(); ++p) {
        const MatrixXd own = scaled(tiles.stiffness(0, p), length)(rows, rows);
        std::printf("%s\n[", p > 0 ? "," : "");
        for (Index i = 0; i < own.size(); ++i) std::printf("%s%.17g", i > 0 ? ", " : "", own.reshaped()[i]);
        std::printf("]");
    }
    std::printf("]}\n");
}

}  // namespace

int main(int argc, char** argv) {
    std::string patterns = "all";
    std::uint64_t seed = 1;
    bool json = false;
    CLI::App app("The numbers that span the stiffness of patterns in a regular hexagon");
    app.add_option("--patterns", patterns, "A number drawn at random, or all");
    app.add_option("--seed", seed, "Of the draw");
    app.add_flag("--json", json, "Print the matrices instead");
    CLI11_PARSE(app, argc, argv);
    const simulation::Project project = experiments::lattice(1, 1);
    const simulation::Surface surface = simulation::make_surface(project, nullptr);
    const simulation::CandidateTiles tiles(surface, experiments::palette(patterns, seed));
    const double length = project.setting->tile_side;
    if (json)
        print_matrices(tiles, length);
    else
        print_numbers(tiles, length);
    return 0;
}
