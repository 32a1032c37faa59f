// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/design/gamut.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <set>

namespace fretwork::design {
namespace {

using Places = Eigen::Matrix<double, Eigen::Dynamic, 3>;
using tiling::InterfaceIndex;
using tiling::TileIndex;

/// A quadric has six coefficients.
constexpr Eigen::Index kFewestNodes = 6;
/// A wanted curvature is outside if its distance from every reached one exceeds this share of the largest
/// reached curvature.
constexpr double kOutside = 0.1;

/// The interface nodes of a tile and of the tiles that share a node with it.
std::vector<int> nodes_around(const tiling::Tessellation& tessellation,
                              const std::vector<std::vector<TileIndex>>& tiles_of, TileIndex tile) {
    std::set<int> nodes;
    for (const InterfaceIndex own : tessellation.tiles[tile].interface_nodes) {
        for (const TileIndex other : tiles_of[static_cast<std::size_t>(own.value)]) {
            for (const InterfaceIndex node : tessellation.tiles[other].interface_nodes)
                nodes.insert(node.value);
        }
    }
    return {nodes.begin(), nodes.end()};
}

/// The normal of the plane that fits the nodes best, on the side that faces z at rest.
Eigen::Vector3d normal_of(const Places& own, const Eigen::Matrix<double, Eigen::Dynamic, 2>& rest) {
    Eigen::Vector3d normal = Eigen::JacobiSVD<Places>(own, Eigen::ComputeFullV).matrixV().col(2);
    // The map from rest to space keeps the sense of turning.
    const Eigen::Matrix<double, 2, 3> map = (rest.transpose() * rest).ldlt().solve(rest.transpose() * own);
    const Eigen::Vector3d up = map.row(0).transpose().eval().cross(map.row(1).transpose().eval());
    return up.dot(normal) < 0.0 ? Eigen::Vector3d(-normal) : normal;
}

std::optional<Curvatures> curvatures_of(Places own, Eigen::Matrix<double, Eigen::Dynamic, 2> rest) {
    if (own.rows() < kFewestNodes || !own.allFinite()) return std::nullopt;
    own.rowwise() -= own.colwise().mean().eval();
    rest.rowwise() -= rest.colwise().mean().eval();
    const Eigen::Vector3d normal = normal_of(own, rest);
    const Eigen::Vector3d first = normal.unitOrthogonal();
    const Eigen::Vector3d second = normal.cross(first);
    const double size = own.rowwise().norm().maxCoeff();
    if (!(size > 0.0)) return std::nullopt;
    const Eigen::ArrayXd x = own * first / size;
    const Eigen::ArrayXd y = own * second / size;
    const Eigen::VectorXd z = own * normal / size;
    Eigen::MatrixXd terms(own.rows(), kFewestNodes);
    terms << Eigen::VectorXd::Ones(own.rows()), x.matrix(), y.matrix(), (0.5 * x * x).matrix(),
        (x * y).matrix(), (0.5 * y * y).matrix();
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(terms);
    if (factors.rank() < kFewestNodes) return std::nullopt;
    const Eigen::VectorXd c = factors.solve(z);
    // Weingarten map of the graph z(x, y) in the middle: second form over first form.
    const double p = c[1];
    const double q = c[2];
    Eigen::Matrix2d form;
    form << 1.0 + p * p, p * q, p * q, 1.0 + q * q;
    Eigen::Matrix2d bending;
    bending << c[3], c[4], c[4], c[5];
    bending /= std::sqrt(1.0 + p * p + q * q) * size;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> principal(bending, form);
    return Curvatures{principal.eigenvalues()[1], principal.eigenvalues()[0]};
}

}  // namespace

base::IndexVector<TileIndex, std::optional<Curvatures>> tile_curvatures(
    const tiling::Tessellation& tessellation, const Places& places) {
    std::vector<std::vector<TileIndex>> tiles_of(tessellation.interface_nodes.size());
    for (const TileIndex tile : tessellation.tiles.indices()) {
        for (const InterfaceIndex node : tessellation.tiles[tile].interface_nodes)
            tiles_of[static_cast<std::size_t>(node.value)].push_back(tile);
    }
    base::IndexVector<TileIndex, std::optional<Curvatures>> result;
    for (const TileIndex tile : tessellation.tiles.indices()) {
        const std::vector<int> nodes = nodes_around(tessellation, tiles_of, tile);
        Eigen::Matrix<double, Eigen::Dynamic, 2> rest(std::ssize(nodes), 2);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const geometry::Point2& place = tessellation.interface_nodes[InterfaceIndex(nodes[i])];
            rest.row(static_cast<Eigen::Index>(i)) << place.x, place.y;
        }
        result.push_back(curvatures_of(places(nodes, Eigen::all), rest));
    }
    return result;
}

std::optional<double> Gamut::share_outside() const {
    if (wanted.empty() || reached.empty()) return std::nullopt;
    double largest = 0.0;
    for (const Curvatures& own : reached)
        largest = std::max({largest, std::abs(own.largest), std::abs(own.smallest)});
    std::size_t outside = 0;
    for (const Curvatures& goal : wanted) {
        const bool is_near = std::ranges::any_of(reached, [&](const Curvatures& own) {
            return std::hypot(goal.largest - own.largest, goal.smallest - own.smallest) <= kOutside * largest;
        });
        if (!is_near) ++outside;
    }
    return static_cast<double>(outside) / static_cast<double>(wanted.size());
}

}  // namespace fretwork::design
