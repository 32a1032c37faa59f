// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/detail/session_impl.hpp>

#include <vector>

namespace fretwork::simulation {

/// The additional data of a session of a mixed model: the same surface with the worst tiles in full, which
/// gets the same edits.
class Session::Mixture {
  public:
    /// @param plain  the same surface with corotational tiles, which gets each edit first and outlives this
    /// one; tiles with their own tile model have it
    Mixture(const Impl& plain, const SimulationOptions& options);

    [[nodiscard]] const SimulationOptions& options() const { return options_; }
    [[nodiscard]] Impl& impl() { return impl_; }
    [[nodiscard]] const std::vector<tiling::TileIndex>& full_tiles() const { return full_tiles_; }
    [[nodiscard]] const SurfaceResult& corotational() const { return corotational_; }
    [[nodiscard]] const Report& last_report() const { return report_; }

    /// Solve with corotational tiles, then with the worst tiles in full. Returns the second solution, with
    /// the seconds of both; or the first solution if it has not converged, or if no tile is put in full.
    SurfaceResult solve(Impl& plain, const base::Control& control, mechanics::StabilityCheck check);

  private:
    void choose(const Impl& plain, const base::Control& control);

    SimulationOptions options_;
    double share_;
    Impl impl_;
    SurfaceResult corotational_;
    std::vector<tiling::TileIndex> full_tiles_;
    Report report_;
};

}  // namespace fretwork::simulation
