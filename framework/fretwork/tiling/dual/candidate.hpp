// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/detail/shared_task.hpp>
#include <fretwork/tiling/dual/defects.hpp>
#include <fretwork/tiling/dual/dual.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <optional>

namespace fretwork::tiling::detail {

/// The source of the sites: a triangular lattice at an angle, or isotropic remeshing if there is no angle.
struct Start {
    std::optional<double> lattice_angle{};
    /// The distance of neighbouring sites in the first round, as a multiple of the wanted side.
    double factor = 0.0;
    [[nodiscard]] std::string name() const;
};

/// The input of make_sketch() and make_candidate(), and the limits for defects.
struct TilingProblem {
    const outlines::Outline& outline;
    const SizeField& field;
    const TessellationOptions& options;
    QualityLimits limits;
    /// Approximate number of tiles if an outline with holes needs small tiles; 0 for all other outlines.
    double refined_tiles = 0.0;
    /// True if each tiling takes seconds because of the number of tiles. Then fewer lattices are sketched. A
    /// distance of sites is sketched first, and is tiled in full only if the sides of the sketch are near the
    /// wanted sides, or in the last round.
    [[nodiscard]] bool has_many() const { return refined_tiles > 3000.0; }
};

/// A tiling of the outline, one of several to choose from.
struct Candidate {
    Dual dual;
    TessellationReport report;
    std::vector<Defect> defects;
    double side_error = 0.0;    ///< difference between 1 and the mean ratio of sides to wanted sides
    double irregularity = 0.0;  ///< irregularity of the tiling (see Measures); smaller is better
    /// The distance of neighbouring sites as a multiple of the wanted side; none unless the search met a jump
    /// of the sides. The next attempt with nearly the same wanted sides starts with it.
    std::optional<double> factor{};
};

/// A rough prediction of the tiling from a start: its irregularity, and the distance of the sites that gives
/// the wanted sides. A sketch is cheap and suffices to discard the worst starts. make_sketch() reports at
/// most rough_steps() steps of progress. Throws base::Stopped.
struct Sketch {
    double irregularity = 0.0;
    double factor = 0.0;
    int tiles = 0;
};
Sketch make_sketch(const TilingProblem& problem, const Start& start, SharedTask& task);
std::size_t rough_steps(const TessellationOptions& options);

/// Make the tiling from a start, with the distance of sites that gives the wanted sides. Usually reports
/// fewer than candidate_steps() steps of progress. Throws base::Stopped.
Candidate make_candidate(const TilingProblem& problem, const Start& start, SharedTask& task);
std::size_t candidate_steps(const TessellationOptions& options);

/// True if `first` is the better choice.
bool is_better(const Candidate& first, const Candidate& second);

}  // namespace fretwork::tiling::detail
