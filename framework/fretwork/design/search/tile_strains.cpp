// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/design/search/tile_strains.hpp>
#include <fretwork/geometry/rotation.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <array>

namespace fretwork::design::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index kTileDofs = 6;
constexpr std::array<Index, 3> kInPlane = {0, 1, 5};
constexpr std::array<Index, 3> kOutOfPlane = {2, 3, 4};
/// A smaller relative coupling is rounding.
constexpr double kCoupling = 1e-7;

std::vector<Index> places(Index nodes, const std::array<Index, 3>& dofs) {
    std::vector<Index> result;
    for (Index i = 0; i < nodes; ++i) {
        for (const Index dof : dofs) result.push_back(kTileDofs * i + dof);
    }
    return result;
}

/// Orthonormal strains of some dofs: all motions that are orthogonal to the rigid ones.
MatrixXd strains_of(const MatrixXd& rigid, const std::vector<Index>& rows,
                    const std::array<Index, 3>& motions) {
    const MatrixXd own = rigid(rows, std::vector<Index>(motions.begin(), motions.end()));
    const MatrixXd all = Eigen::HouseholderQR<MatrixXd>(own).householderQ();
    MatrixXd result = MatrixXd::Zero(rigid.rows(), all.cols() - 3);
    result(rows, Eigen::all) = all.rightCols(all.cols() - 3);
    return result;
}

MatrixXd logarithm_of(const MatrixXd& stiffness) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(stiffness);
    const double floor = 1e-12 * modes.eigenvalues().maxCoeff();
    const Eigen::VectorXd logs = modes.eigenvalues().cwiseMax(floor).array().log();
    return modes.eigenvectors() * logs.asDiagonal() * modes.eigenvectors().transpose();
}

}  // namespace

TileStrains::TileStrains(const simulation::CandidateTiles& candidates, int threads,
                         const base::Control& control)
    : classes_(candidates.class_count()) {
    for (std::size_t c = 0; c < classes_.size(); ++c) {
        const auto& places_of_nodes = candidates.interface_nodes(c);
        const Index nodes = std::ssize(places_of_nodes);
        const MatrixXd rigid = geometry::rigid_motions(
            Eigen::Map<const Eigen::Matrix3Xd>(places_of_nodes.front().data(), 3, nodes));
        const MatrixXd in_plane = strains_of(rigid, places(nodes, kInPlane), kInPlane);
        const MatrixXd out_of_plane = strains_of(rigid, places(nodes, kOutOfPlane), kOutOfPlane);
        classes_[c].basis.resize(rigid.rows(), in_plane.cols() + out_of_plane.cols());
        classes_[c].basis << in_plane, out_of_plane;
        classes_[c].stiffness.resize(candidates.patterns().size());
    }
    const std::size_t patterns = candidates.patterns().size();
    base::parallel_for(classes_.size() * patterns, threads, [&](std::size_t i) {
        control.check();
        Class& own = classes_[i / patterns];
        const MatrixXd reduced =
            own.basis.transpose() * candidates.stiffness(i / patterns, i % patterns) * own.basis;
        const Index half = reduced.rows() / 2;
        const double coupled = reduced.topRightCorner(half, half).cwiseAbs().maxCoeff();
        if (coupled > kCoupling * reduced.diagonal().cwiseAbs().maxCoeff())
            throw base::NumericalError("a tile's stiffness in the plane is coupled with that out of it");
        own.stiffness[i % patterns] = {reduced.topLeftCorner(half, half),
                                       reduced.bottomRightCorner(half, half)};
    });
}

MatrixXd stiffness_logarithms(const TileStrains& strains, std::size_t tile_class, double length,
                              const base::Control& control) {
    constexpr double kInPlaneWeight = 0.3;
    const MatrixXd& basis = strains.basis(tile_class);
    Eigen::VectorXd scale = Eigen::VectorXd::Ones(basis.rows());
    for (Index row = 0; row < basis.rows(); ++row) {
        if (row % kTileDofs >= 3) scale[row] = 1.0 / length;
    }
    const MatrixXd metric = basis.transpose() * scale.asDiagonal() * basis;
    const Index half = basis.cols() / 2;
    const MatrixXd first = metric.topLeftCorner(half, half);
    const MatrixXd second = metric.bottomRightCorner(half, half);
    const std::size_t patterns = strains.pattern_count(tile_class);
    MatrixXd logs(2 * half * half, static_cast<Index>(patterns));
    for (std::size_t p = 0; p < patterns; ++p) {
        control.check();
        const auto& own = strains.stiffness(tile_class, p);
        const MatrixXd in_plane = kInPlaneWeight * logarithm_of(first * own.in_plane * first.transpose());
        const MatrixXd out_of_plane = logarithm_of(second * own.out_of_plane * second.transpose());
        logs.col(static_cast<Index>(p)) << in_plane.reshaped(), out_of_plane.reshaped();
    }
    return logs;
}

std::vector<std::size_t> spread_choice(const MatrixXd& columns, std::size_t count,
                                       const base::Control& control) {
    const auto distances_to = [&columns](const Eigen::VectorXd& place) -> Eigen::VectorXd {
        return (columns.colwise() - place).colwise().norm().transpose();
    };
    Index first = 0;
    distances_to(columns.rowwise().mean()).minCoeff(&first);
    std::vector<std::size_t> chosen{static_cast<std::size_t>(first)};
    Eigen::VectorXd nearest = distances_to(columns.col(first));
    while (chosen.size() < std::min(count, static_cast<std::size_t>(columns.cols()))) {
        control.check();
        Index next = 0;
        nearest.maxCoeff(&next);
        chosen.push_back(static_cast<std::size_t>(next));
        nearest = nearest.cwiseMin(distances_to(columns.col(next)));
    }
    return chosen;
}

}  // namespace fretwork::design::detail
