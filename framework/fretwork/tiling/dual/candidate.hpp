// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/detail/work.hpp>
#include <fretwork/tiling/dual/defects.hpp>
#include <fretwork/tiling/dual/dual.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <optional>

namespace fretwork::tiling::detail {

/// Where the sites come from: isotropic remeshing, or a triangular lattice at an angle (rad).
struct Start {
    std::optional<double> lattice_angle{};
    /// The distance of the sites over the wanted side, to try first.
    double factor = 0.0;
    [[nodiscard]] std::string name() const;
};

/// The input of candidates, and the measures by which they are judged.
struct Task {
    const outlines::Outline& outline;
    const SizeField& field;
    const TessellationOptions& options;
    QualityLimits limits;
    double refined_tiles = 0.0;  ///< about, where holes and narrow places want them small; else 0
    /// From this number on each try takes seconds: starts that are known to be of no use are tried roughly.
    [[nodiscard]] bool has_many() const { return refined_tiles > 3000.0; }
};

/// A tiling of the outline, one of several to choose from.
struct Candidate {
    Dual dual;
    TessellationReport report;
    std::vector<Defect> defects;
    double side_error = 0.0;    ///< of the mean of sides over wanted sides, relative
    double irregularity = 0.0;  ///< the smaller the better
    /// The distance of its sites over the wanted side, where that was hard to find: another attempt with
    /// nearly the same wanted sides begins there.
    std::optional<double> factor{};
};

/// A first sketch of the tiling from a start: how irregular it will be (cheap, and good enough to leave the
/// worst aside), and at which distance of the sites the sides will be right. Takes rough_steps() steps.
struct Sketch {
    double irregularity = 0.0;
    double factor = 0.0;
    int tiles = 0;
};
Sketch make_sketch(const Task& task, const Start& start, Work& work);
std::size_t rough_steps(const TessellationOptions& options);

/// The tiling that comes from a start, at the density that gives it the wanted sides. Takes
/// candidate_steps() steps of the work.
Candidate make_candidate(const Task& task, const Start& start, Work& work);
std::size_t candidate_steps(const TessellationOptions& options);

/// True if the first is the better choice.
bool is_better(const Candidate& first, const Candidate& second);

}  // namespace fretwork::tiling::detail
