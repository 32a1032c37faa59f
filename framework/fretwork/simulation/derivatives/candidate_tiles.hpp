// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/simulation/surface.hpp>

#include <Eigen/Core>

#include <vector>

namespace fretwork::simulation {

/// The condensed stiffness of every tile of a surface with each pattern of a palette. Congruent tiles form a
/// *class* and share the stiffness. Threads may share a CandidateTiles, which is immutable.
class CandidateTiles {
  public:
    /// Options of condensing the candidates.
    struct Options {
        /// Number of threads; 0: one for each processor. The result is bitwise the same for every number of
        /// threads.
        int threads = 0;
        base::Control control{};  ///< progress and stop
    };
    /// Condense every pattern in every class of congruent tiles. Throws InputError if an interface node of a
    /// tile has no beam; Stopped.
    CandidateTiles(const Surface& surface, std::vector<pattern::NamedPattern> patterns,
                   const Options& options);
    /// Condense every pattern with the default options. Throws as above.
    CandidateTiles(const Surface& surface, std::vector<pattern::NamedPattern> patterns)
        : CandidateTiles(surface, std::move(patterns), Options{}) {}

    /// The patterns of the palette.
    [[nodiscard]] const std::vector<pattern::NamedPattern>& patterns() const { return patterns_; }
    /// The number of tiles.
    [[nodiscard]] std::size_t tile_count() const { return class_of_.size(); }
    /// The number of classes of congruent tiles.
    [[nodiscard]] std::size_t class_count() const { return classes_.size(); }
    /// The class of a tile.
    [[nodiscard]] std::size_t class_of(tiling::TileIndex tile) const { return class_of_[tile]; }

    /// The condensed stiffness K (SI), 6n x 6n for n interface nodes, in the axes in which the tiles of a
    /// class are built.
    [[nodiscard]] Eigen::MatrixXd stiffness(std::size_t tile_class, std::size_t pattern) const;
    /// The stiffnesses of all patterns, one column for each: the lower triangle of K, column by column.
    [[nodiscard]] const Eigen::MatrixXd& packed(std::size_t tile_class) const {
        return classes_[tile_class].packed;
    }
    /// The mass of a pattern's bars in a tile of a class, kg.
    [[nodiscard]] double mass(std::size_t tile_class, std::size_t pattern) const {
        return classes_[tile_class].masses[pattern];
    }
    /// The positions of the interface nodes of a class, m, in the axes in which its tiles are built.
    [[nodiscard]] const std::vector<Eigen::Vector3d>& interface_nodes(std::size_t tile_class) const {
        return classes_[tile_class].interface_nodes;
    }
    /// The coefficients of the form a . K e for a column of packed(): a . K e = pack_form(a, e) . column.
    static Eigen::VectorXd pack_form(const Eigen::VectorXd& a, const Eigen::VectorXd& e);

  private:
    struct Class {
        Eigen::Index size = 0;       ///< number of rows of K, 6n
        Eigen::MatrixXd packed;      ///< lower triangle of K, one column for each pattern
        std::vector<double> masses;  ///< mass for each pattern, kg
        std::vector<Eigen::Vector3d> interface_nodes;
    };
    std::vector<pattern::NamedPattern> patterns_;
    std::vector<Class> classes_;
    base::IndexVector<tiling::TileIndex, std::size_t> class_of_;
};

}  // namespace fretwork::simulation
