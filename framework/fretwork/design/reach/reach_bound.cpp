// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/design/reach/reach_bound.hpp>
#include <fretwork/geometry/box.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace fretwork::design::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using tiling::TileIndex;

/// Linear theory holds for wanted displacements up to this share of the surface's size.
constexpr double kLargestLinear = 0.02;
/// The largest number of directions for the distance: the residual lies nearly in the space of these.
constexpr Index kDirections = 24;
constexpr Index kSix = 6;

bool is_linear(const Trials& trials) {
    const auto& parts = trials.parts();
    if (trials.initial_unknowns().size() > 0) return false;
    const double size = tiling::bounding_box(parts.surface.tessellation).diagonal();
    if (trials.largest_wanted() > kLargestLinear * size) return false;
    return std::ranges::all_of(parts.cases, [](const DesignCase& own) {
        return own.load_case.gravity.isZero(0) && !own.goals.slides() &&
               std::ranges::all_of(own.load_case.prescribed,
                                   [](const auto& entry) { return entry.value == 0.0; });
    });
}

/// The enclosure of a tile's stiffness in its strains, over all patterns that the tile may have.
struct TileEnclosure {
    Enclosure in_plane;
    Enclosure out_of_plane;
};

TileEnclosure enclosure_of(const TileStrains& strains, std::size_t tile_class,
                           const std::set<std::size_t>& patterns) {
    TileEnclosure result;
    for (const std::size_t pattern : patterns) {
        const TileStrains::Blocks& own = strains.stiffness(tile_class, pattern);
        result.in_plane.include(own.in_plane);
        result.out_of_plane.include(own.out_of_plane);
    }
    return result;
}

/// The rotation about z from the axes of a tile's class to the surface's. It brings the class's nodes to the
/// tile's.
Eigen::Matrix3d turn_of(const std::vector<Eigen::Vector3d>& own, const tiling::Tessellation& tessellation,
                        const tiling::Tile& tile) {
    Eigen::Vector2d middle_own = Eigen::Vector2d::Zero();
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    const auto place = [&](std::size_t i) {
        const geometry::Point2& point = tessellation.interface_nodes[tile.interface_nodes[i]];
        return Eigen::Vector2d(point.x, point.y);
    };
    for (std::size_t i = 0; i < own.size(); ++i) {
        middle_own += own[i].head<2>() / static_cast<double>(own.size());
        middle += place(i) / static_cast<double>(own.size());
    }
    double along = 0.0;
    double across = 0.0;
    for (std::size_t i = 0; i < own.size(); ++i) {
        const Eigen::Vector2d from = own[i].head<2>() - middle_own;
        const Eigen::Vector2d to = place(i) - middle;
        along += from.dot(to);
        across += from.x() * to.y() - from.y() * to.x();
    }
    return Eigen::AngleAxisd(std::atan2(across, along), Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

/// A lower and an upper bound of the surface's stiffness, without the held dofs.
class LinearSurface {
  public:
    LinearSurface(const Trials& trials, const std::vector<std::size_t>& palette,
                  const simulation::Conditions& conditions, const base::Control& control)
        : trials_(trials) {
        place_dofs(conditions);
        std::map<std::pair<std::size_t, std::set<std::size_t>>, TileEnclosure> known;
        const auto& tessellation = trials.parts().surface.tessellation;
        for (const TileIndex tile : tessellation.tiles.indices()) {
            control.check();
            const std::size_t tile_class = trials.parts().candidates.class_of(tile);
            const std::set<std::size_t> patterns = trials.possible(tile, palette);
            const auto [entry, is_new] = known.try_emplace({tile_class, patterns});
            if (is_new) entry->second = enclosure_of(trials.strains(), tile_class, patterns);
            add(tile, tile_class, entry->second);
        }
        factors_[0].compute(matrix(below_));
        factors_[1].compute(matrix(above_));
    }

    /// K_A^-1 and K_B^-1 times forces. Vectors have six rows for each node. Held rows of the forces do not
    /// count; those of the results are zero.
    [[nodiscard]] std::array<VectorXd, 2> answers(const VectorXd& forces) const {
        VectorXd free(free_count_);
        for (Index i = 0; i < forces.size(); ++i) {
            if (place_[i] >= 0) free[place_[i]] = forces[i];
        }
        std::array<VectorXd, 2> result;
        for (std::size_t which = 0; which < 2; ++which) {
            const VectorXd own = factors_[which].solve(free);
            result[which].setZero(forces.size());
            for (Index i = 0; i < forces.size(); ++i) {
                if (place_[i] >= 0) result[which][i] = own[place_[i]];
            }
        }
        return result;
    }
    [[nodiscard]] bool is_held() const {
        return factors_[0].info() == Eigen::Success && factors_[1].info() == Eigen::Success;
    }

  private:
    using Factors = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

    void place_dofs(const simulation::Conditions& conditions) {
        const auto nodes = std::ssize(trials_.parts().surface.tessellation.interface_nodes);
        place_.setZero(kSix * nodes);
        for (const mechanics::Support& support : conditions.supports) {
            for (std::size_t d = 0; d < 6; ++d) {
                if (support.fixed.contains[d]) place_[kSix * support.node.value + static_cast<Index>(d)] = -1;
            }
        }
        for (const auto& own : conditions.prescribed)
            place_[kSix * own.node.value + static_cast<Index>(own.dof)] = -1;
        for (Index& place : place_) {
            if (place >= 0) place = free_count_++;
        }
    }

    void add(TileIndex tile, std::size_t tile_class, const TileEnclosure& enclosure) {
        const auto& parts = trials_.parts();
        const tiling::Tile& own = parts.surface.tessellation.tiles[tile];
        const MatrixXd& basis = trials_.strains().basis(tile_class);
        const Eigen::Matrix3d turn =
            turn_of(parts.candidates.interface_nodes(tile_class), parts.surface.tessellation, own);
        MatrixXd turned = basis;
        for (Index block = 0; block < basis.rows() / 3; ++block)
            turned.middleRows<3>(3 * block) = turn * basis.middleRows<3>(3 * block);
        const Index half = basis.cols() / 2;
        for (const bool is_above : {false, true}) {
            const MatrixXd& in_plane = is_above ? enclosure.in_plane.above : enclosure.in_plane.below;
            const MatrixXd& out = is_above ? enclosure.out_of_plane.above : enclosure.out_of_plane.below;
            const MatrixXd stiffness = turned.leftCols(half) * in_plane * turned.leftCols(half).transpose() +
                                       turned.rightCols(half) * out * turned.rightCols(half).transpose();
            scatter(own, stiffness, is_above ? above_ : below_);
        }
    }

    void scatter(const tiling::Tile& tile, const MatrixXd& stiffness,
                 std::vector<Eigen::Triplet<double>>& entries) const {
        const auto place = [&](Index row) {
            return place_[kSix * tile.interface_nodes[static_cast<std::size_t>(row / kSix)].value +
                          row % kSix];
        };
        for (Index i = 0; i < stiffness.rows(); ++i) {
            for (Index j = 0; j < stiffness.cols(); ++j) {
                if (place(i) >= 0 && place(j) >= 0) entries.emplace_back(place(i), place(j), stiffness(i, j));
            }
        }
    }

    [[nodiscard]] Eigen::SparseMatrix<double> matrix(
        const std::vector<Eigen::Triplet<double>>& entries) const {
        Eigen::SparseMatrix<double> result(free_count_, free_count_);
        result.setFromTriplets(entries.begin(), entries.end());
        return result;
    }

    const Trials& trials_;
    Eigen::Matrix<Index, Eigen::Dynamic, 1> place_;  ///< index of each dof among the free ones; -1: held
    Index free_count_ = 0;
    std::vector<Eigen::Triplet<double>> below_;
    std::vector<Eigen::Triplet<double>> above_;
    std::array<Factors, 2> factors_;
};

/// The observations C of one load case, as functions of the displacements of all nodes.
class Observations {
  public:
    Observations(const CaseGoals& goals, Index nodes, double scale)
        : list_(goals.observe(mechanics::NodeValues::Zero(nodes, kSix), {})), scale_(scale), nodes_(nodes) {}

    [[nodiscard]] VectorXd of(const VectorXd& displacements) const {
        VectorXd result(std::ssize(list_));
        for (Index i = 0; i < result.size(); ++i)
            result[i] = weight(i) * at(i).direction.dot(displacements.segment<kSix>(kSix * at(i).node));
        return result;
    }
    /// C^T times a combination: forces on all nodes.
    [[nodiscard]] VectorXd forces_of(const VectorXd& combination) const {
        VectorXd forces = VectorXd::Zero(kSix * nodes_);
        for (Index i = 0; i < combination.size(); ++i)
            forces.segment<kSix>(kSix * at(i).node) += weight(i) * combination[i] * at(i).direction;
        return forces;
    }
    [[nodiscard]] VectorXd wanted() const {
        VectorXd result(std::ssize(list_));
        for (Index i = 0; i < result.size(); ++i) result[i] = -weight(i) * at(i).residual;
        return result;
    }

  private:
    [[nodiscard]] const Observation& at(Index i) const { return list_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] double weight(Index i) const { return scale_ * std::sqrt(at(i).weight); }

    std::vector<Observation> list_;
    double scale_;
    Index nodes_;
};

/// The distance from the wanted observations to the ellipsoid of the observations around `middle`, in the
/// space of at most kDirections directions. The first direction is the difference from `middle`, and the
/// ellipsoid's shape makes each next one (Lanczos).
double distance_along(const LinearSurface& surface, const Observations& observations, double radius,
                      const VectorXd& middle, const base::Control& control) {
    const VectorXd off = observations.wanted() - middle;
    const Index count = std::min<Index>(kDirections, off.size());
    MatrixXd directions(off.size(), 0);
    MatrixXd shaped(off.size(), 0);
    VectorXd next = off;
    while (directions.cols() < count) {
        control.check();
        const double before = next.norm();
        for (int again = 0; again < 2; ++again) next -= directions * (directions.transpose() * next);
        if (!(next.norm() > 1e-10 * before)) break;
        next.normalize();
        const auto answers = surface.answers(observations.forces_of(next));
        const Index last = directions.cols();
        directions.conservativeResize(Eigen::NoChange, last + 1);
        directions.col(last) = next;
        shaped.conservativeResize(Eigen::NoChange, last + 1);
        shaped.col(last) = observations.of(answers[0] - answers[1]);
        next = shaped.col(last);
    }
    if (directions.cols() == 0) return 0.0;
    const MatrixXd shape = directions.transpose() * shaped;
    return distance_to_ellipsoid(0.5 * (shape + shape.transpose()), radius, directions.transpose() * off);
}

/// The distance of one load case; none if the surface is not held.
std::optional<double> case_distance(const Trials& trials, const DesignCase& own,
                                    const std::vector<std::size_t>& palette, const base::Control& control) {
    const simulation::Surface& given = trials.parts().surface;
    const simulation::Conditions conditions = simulation::resolve(own.load_case, given);
    const auto nodes = std::ssize(given.tessellation.interface_nodes);
    const mechanics::NodeValues rows = simulation::load_rows(conditions, static_cast<std::size_t>(nodes));
    const VectorXd loads = Eigen::Map<const VectorXd>(rows.data(), rows.size());
    const LinearSurface surface(trials, palette, conditions, control);
    if (!surface.is_held()) return std::nullopt;
    const Observations observations(own.goals, nodes, trials.scale());
    const auto answers = surface.answers(loads);
    const double radius = 0.5 * std::sqrt(std::max(0.0, loads.dot(answers[0] - answers[1])));
    return distance_along(surface, observations, radius, 0.5 * observations.of(answers[0] + answers[1]),
                          control);
}

}  // namespace

void Enclosure::include(const MatrixXd& matrix) {
    if (below.size() == 0) {
        below = above = matrix;
        return;
    }
    const auto improve = [&](MatrixXd& bound, double sign) {
        const Eigen::LLT<MatrixXd> factors(bound);
        const MatrixXd lower = factors.matrixL();
        const MatrixXd half = factors.matrixL().solve(matrix);
        const MatrixXd relative = factors.matrixL().solve(half.transpose());
        const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(0.5 * (relative + relative.transpose()));
        const VectorXd outside = (sign * (modes.eigenvalues().array() - 1.0)).max(0.0);
        const MatrixXd part = lower * modes.eigenvectors();
        bound += sign * part * outside.asDiagonal() * part.transpose();
    };
    improve(above, 1.0);
    improve(below, -1.0);
}

double distance_to_ellipsoid(const MatrixXd& shape, double radius, const VectorXd& point) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(shape);
    const Eigen::ArrayXd h = modes.eigenvalues().array().max(0.0);
    const Eigen::ArrayXd c = modes.eigenvectors().transpose() * point;
    const double most = h.maxCoeff();
    // The nearest point has the parts h / (h + m) c; the multiplier m puts it on the ellipsoid.
    const auto is_outside = [&](double m) {
        double sum = 0.0;
        for (Index i = 0; i < h.size(); ++i)
            if (h[i] > 0.0) sum += h[i] * c[i] * c[i] / ((h[i] + m) * (h[i] + m));
        return sum > radius * radius;
    };
    const auto distance = [&](double m) {
        double sum = 0.0;
        for (Index i = 0; i < h.size(); ++i) {
            const double left = h[i] > 0.0 ? m * c[i] / (h[i] + m) : c[i];
            sum += left * left;
        }
        return std::sqrt(sum);
    };
    if (!(most > 0.0)) return point.norm();
    double low = std::log(most) - 60.0;
    double high = std::log(most) + 60.0;
    // Only what is across the directions in which the ellipsoid is flat is outside.
    if (!is_outside(std::exp(low))) return (h > 0.0).select(0.0, c).matrix().norm();
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (is_outside(std::exp(middle)) ? low : high) = middle;
    }
    return distance(std::exp(low));
}

std::optional<double> reach_bound(const Trials& trials, const std::vector<std::size_t>& palette,
                                  const base::Control& control) {
    if (!is_linear(trials)) return std::nullopt;
    double sum = 0.0;
    for (const DesignCase& own : trials.parts().cases) {
        const auto distance = case_distance(trials, own, palette, control);
        if (!distance) return std::nullopt;
        sum += *distance * *distance;
    }
    return std::sqrt(sum);
}

}  // namespace fretwork::design::detail
