// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/derivatives/candidate_tiles.hpp>

#include <Eigen/Core>

#include <vector>

namespace fretwork::design::detail {

/// The stiffness k of candidate tiles in coordinates without rigid motions: K = U k U^T. The first columns of
/// the orthonormal matrix U are strains in the plane (ux uy rz), and the other columns are strains out of the
/// plane. The beams of a flat tile do not couple strains in the plane with strains out of the plane, so k has
/// two blocks.
class TileStrains {
  public:
    /// Compute k for all candidates. Throws NumericalError if a stiffness couples strains in the plane with
    /// strains out of the plane; Stopped.
    TileStrains(const simulation::CandidateTiles& candidates, int threads, const base::Control& control = {});

    struct Blocks {
        Eigen::MatrixXd in_plane;
        Eigen::MatrixXd out_of_plane;
    };
    [[nodiscard]] const Eigen::MatrixXd& basis(std::size_t tile_class) const {
        return classes_[tile_class].basis;
    }
    [[nodiscard]] const Blocks& stiffness(std::size_t tile_class, std::size_t pattern) const {
        return classes_[tile_class].stiffness[pattern];
    }
    [[nodiscard]] std::size_t pattern_count(std::size_t tile_class) const {
        return classes_[tile_class].stiffness.size();
    }

  private:
    struct Class {
        Eigen::MatrixXd basis;          ///< basis U, 6n x (6n - 6)
        std::vector<Blocks> stiffness;  ///< stiffness of each pattern
    };
    std::vector<Class> classes_;
};

/// The logarithms of the patterns' stiffnesses in one class of tiles, one column for each pattern. The
/// distance of two columns measures how different two patterns are; stiffness in the plane has a smaller
/// weight. A rotation is measured by the displacement that it causes at the distance `length` (m).
Eigen::MatrixXd stiffness_logarithms(const TileStrains& strains, std::size_t tile_class, double length,
                                     const base::Control& control);

/// Choose `count` columns that lie far from each other: first the column nearest to the mean, then each time
/// the column farthest from the chosen columns. If there are no more than `count` columns, all are chosen.
std::vector<std::size_t> spread_choice(const Eigen::MatrixXd& columns, std::size_t count,
                                       const base::Control& control);

}  // namespace fretwork::design::detail
