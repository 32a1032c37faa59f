// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/derivatives/candidate_tiles.hpp>

#include <Eigen/Core>

#include <vector>

namespace fretwork::design::detail {

/// The stiffness k of each candidate tile in coordinates without rigid motions, so that the tile's stiffness
/// K is U k U^T. The first half of the columns of the orthonormal matrix U are in-plane strains (ux uy rz);
/// the other half are out-of-plane strains. The beams of a flat tile do not couple the two halves, so k has
/// two diagonal blocks. Const functions may be called from several threads.
class TileStrains {
  public:
    /// Compute k for all candidates. Throws NumericalError if a stiffness couples in-plane and out-of-plane
    /// strains; Stopped.
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

/// Compute the matrix logarithms of the patterns' stiffnesses in one class of tiles, one column for each
/// pattern. The distance between two columns measures how much two patterns differ; the in-plane part has a
/// smaller weight. Rotations count as displacements at the distance `length` (m).
Eigen::MatrixXd stiffness_logarithms(const TileStrains& strains, std::size_t tile_class, double length,
                                     const base::Control& control);

/// Choose `count` columns that lie far from each other. The first is the column nearest to the mean. Each
/// further one is the column farthest from the chosen columns. All columns are chosen if there are at most
/// `count`.
std::vector<std::size_t> spread_choice(const Eigen::MatrixXd& columns, std::size_t count,
                                       const base::Control& control);

}  // namespace fretwork::design::detail
