// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/task.hpp>
#include <fretwork/mechanics/nonlinear/unknowns.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/mechanics/results/solution.hpp>

#include <memory>
#include <optional>

namespace fretwork::mechanics::nonlinear {

/// The number of steps of a task that reports the progress of a path.
inline constexpr int kThousandths = 1000;

/// The receiver of a path's progress.
struct PathProgress {
    const base::Task& task;   ///< task of kThousandths steps
    double last_load_factor;  ///< load factor at which the task is done
};

/// The last equilibrium of a path; loads, forces and moments have one row for each node.
struct PathEnd {
    Configuration configuration;
    NodeValues loads;
    NodeValues reactions;  ///< forces and moments of the supports
};

/// A load path, followed from one load factor to the next as in follow_load_path(). The assembly and the
/// options must outlive it.
class LoadPath {
  public:
    /// Begin at rest, or at an equilibrium under other loads. The load factor is 0 there, and 1 at the loads
    /// and prescribed values of the assembly. A beginning that is no equilibrium is corrected. With
    /// Branch::Stable and Branch::Snapping, the path leaves an unstable beginning: downhill in energy without
    /// the released forces, or along the lowest mode if there are none. A path from rest throws
    /// NumericalError as Newton::factorize_at_rest(). Throws Stopped.
    LoadPath(const Assembly& assembly, const EquilibriumOptions& options,
             const std::optional<PathStart>& start = std::nullopt);
    LoadPath(const LoadPath&) = delete;
    LoadPath& operator=(const LoadPath&) = delete;
    ~LoadPath();

    /// Follow the path to a load factor above the last one. If the solution has not converged, it is the last
    /// equilibrium found. Throws Stopped.
    Solution advance_to(double load_factor, const PathProgress& progress);
    /// The last equilibrium.
    [[nodiscard]] PathEnd end() const;

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::mechanics::nonlinear
