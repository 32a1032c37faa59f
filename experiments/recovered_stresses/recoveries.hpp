// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/results/surface_beams.hpp>
#include <fretwork/simulation/session.hpp>

#include <Eigen/Core>

#include <vector>

namespace fretwork::recovered_stresses {

/// The von Mises stress of each beam, Pa, at the end where it is larger.
using Stresses = Eigen::VectorXd;

/// Ways from a solution of a surface to the stresses of its beams.
class Recoveries {
  public:
    /// @param session  has given a nonlinear solution of the surface since its last edit
    explicit Recoveries(const simulation::Session& session);

    /// As `fretwork beams` has them.
    [[nodiscard]] Stresses built_in(const simulation::SurfaceResult& result) const;
    /// Inner nodes follow linearly in the frame of their tile, and beams answer linearly there.
    [[nodiscard]] Stresses linear(const simulation::SurfaceResult& result) const;
    /// Inner nodes follow linearly; beams answer to the displacements of their ends as at large
    /// displacements.
    [[nodiscard]] Stresses large_beams(const simulation::SurfaceResult& result) const;
    /// Each tile alone with all of its beams, in equilibrium while its interface nodes are held where they
    /// are.
    [[nodiscard]] Stresses held_tiles(const simulation::SurfaceResult& result) const;
    /// Each tile alone with all of its beams, in equilibrium under the forces of its corotational element on
    /// its interface nodes, one of which is held.
    [[nodiscard]] Stresses loaded_tiles(const simulation::SurfaceResult& result) const;
    /// The same with no node held, but each on springs, which are without force where the corotational
    /// solution has the node. They stand for the neighbours: `stiffness` times the tile's own stiffness
    /// against that node.
    [[nodiscard]] Stresses sprung_tiles(const simulation::SurfaceResult& result, double stiffness) const;
    [[nodiscard]] Stresses sprung_softly(const simulation::SurfaceResult& r) const {
        return sprung_tiles(r, 0.1);
    }
    [[nodiscard]] Stresses sprung(const simulation::SurfaceResult& r) const { return sprung_tiles(r, 1.0); }
    [[nodiscard]] Stresses sprung_stiffly(const simulation::SurfaceResult& r) const {
        return sprung_tiles(r, 10.0);
    }

  private:
    enum class Answer { Linear, Large };
    struct Boundary {
        std::size_t held = 0;    ///< as many of the interface nodes
        bool is_loaded = false;  ///< the others bear the forces of the corotational tile
        double spring_stiffness = 0.0;
    };
    [[nodiscard]] Stresses following(const simulation::SurfaceResult& result, Answer answer) const;
    [[nodiscard]] Stresses alone(const simulation::SurfaceResult& result, Boundary boundary) const;
    void write(tiling::TileIndex tile, const mechanics::NodeValues& rows, Answer answer,
               Stresses& stresses) const;

    const simulation::Session& session_;
    simulation::SurfaceBeams beams_;
    std::vector<mechanics::BeamSection> sections_;
};

}  // namespace fretwork::recovered_stresses
