// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/detail/dual.hpp>
#include <fretwork/tiling/detail/work.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <optional>

namespace fretwork::tiling::detail {

/// Where the sites come from: isotropic remeshing, or a triangular lattice at an angle (rad).
struct Start {
    std::optional<double> lattice_angle{};
    [[nodiscard]] std::string name() const;
};

/// A tiling of the outline, one of several to choose from.
struct Candidate {
    Dual dual;
    TessellationReport report;
    int not_convex = 0;         ///< tiles
    int slender = 0;            ///< tiles with an angle below 30 degrees
    int pieces = 0;             ///< sets of tiles that hang together by sides
    int pinched = 0;            ///< vertices at which the rim touches itself: a gap in a narrow part
    double side_error = 0.0;    ///< of the mean side, relative
    double irregularity = 0.0;  ///< the smaller the better
};

/// How irregular the tiling from a start will be, judged by a first sketch of it: cheap, and good enough to
/// leave the worst aside. Takes rough_steps() steps of the work.
double rough_irregularity(const Outline& outline, const TessellationOptions& options, const Start& start,
                          Work& work);
std::size_t rough_steps(const TessellationOptions& options);

/// The tiling that comes from a start, at the density that gives it the wanted mean side; no tiles if the
/// outline is too small. Takes candidate_steps() steps of the work.
Candidate make_candidate(const Outline& outline, const TessellationOptions& options, const Start& start,
                         Work& work);
std::size_t candidate_steps(const TessellationOptions& options);

/// True if the first is the better choice.
bool is_better(const Candidate& first, const Candidate& second);

}  // namespace fretwork::tiling::detail
