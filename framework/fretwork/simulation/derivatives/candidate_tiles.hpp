// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/simulation/surface.hpp>

#include <Eigen/Core>

#include <vector>

namespace fretwork::simulation {

/// The condensed stiffness of every tile of a surface with each pattern of a palette. Congruent tiles form a
/// *class* and share it.
class CandidateTiles {
  public:
    /// How candidates are condensed.
    struct Options {
        int threads = 0;  ///< 0: one for each processor. The number does not change a bit of the result.
        base::Control control{};  ///< how the caller follows and stops the work
    };
    /// Condenses each pattern in each class. Throws InputError if a pattern does not connect a tile; Stopped.
    CandidateTiles(const Surface& surface, std::vector<pattern::NamedPattern> patterns,
                   const Options& options);
    /// Condense every pattern in every class of congruent tiles.
    CandidateTiles(const Surface& surface, std::vector<pattern::NamedPattern> patterns)
        : CandidateTiles(surface, std::move(patterns), Options{}) {}

    /// The candidates.
    [[nodiscard]] const std::vector<pattern::NamedPattern>& patterns() const { return patterns_; }
    /// The number of tiles.
    [[nodiscard]] std::size_t tile_count() const { return class_of_.size(); }
    /// The number of classes of congruent tiles.
    [[nodiscard]] std::size_t class_count() const { return classes_.size(); }
    /// The class of a tile.
    [[nodiscard]] std::size_t class_of(tiling::TileIndex tile) const { return class_of_[tile]; }

    /// K, 6n x 6n, in the axes in which the tiles of a class are built.
    [[nodiscard]] Eigen::MatrixXd stiffness(std::size_t tile_class, std::size_t pattern) const;
    /// The stiffnesses of all patterns, one column each: the lower triangle of K, column by column.
    [[nodiscard]] const Eigen::MatrixXd& packed(std::size_t tile_class) const {
        return classes_[tile_class].packed;
    }
    /// Kg, of the pattern's bars in a tile of the class.
    [[nodiscard]] double mass(std::size_t tile_class, std::size_t pattern) const {
        return classes_[tile_class].masses[pattern];
    }
    /// The interface nodes of the tiles of a class, in its axes, m.
    [[nodiscard]] const std::vector<Eigen::Vector3d>& interface_nodes(std::size_t tile_class) const {
        return classes_[tile_class].interface_nodes;
    }
    /// The coefficients of a . K e in a column of packed(): a . K e = pack_form(a, e) . column.
    static Eigen::VectorXd pack_form(const Eigen::VectorXd& a, const Eigen::VectorXd& e);

  private:
    struct Class {
        Eigen::Index size = 0;       ///< 6n
        Eigen::MatrixXd packed;      ///< a column for each pattern
        std::vector<double> masses;  ///< kg
        std::vector<Eigen::Vector3d> interface_nodes;
    };
    std::vector<pattern::NamedPattern> patterns_;
    std::vector<Class> classes_;
    base::IndexVector<tiling::TileIndex, std::size_t> class_of_;
};

}  // namespace fretwork::simulation
