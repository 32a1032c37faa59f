// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/detail/work.hpp>
#include <fretwork/tiling/dual/defects.hpp>
#include <fretwork/tiling/dual/dual.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <optional>

namespace fretwork::tiling::detail {

/// The source of the sites: isotropic remeshing, or a triangular lattice at an angle (rad).
struct Start {
    std::optional<double> lattice_angle{};
    /// The first value to try for the distance of the sites, as a multiple of the wanted side.
    double factor = 0.0;
    [[nodiscard]] std::string name() const;
};

/// The input of candidates, and the measures by which they are judged.
struct Task {
    const outlines::Outline& outline;
    const SizeField& field;
    const TessellationOptions& options;
    QualityLimits limits;
    double refined_tiles = 0.0;  ///< approximate number of tiles if holes and narrow places need small ones;
                                 ///< else 0
    /// True if each try takes seconds, because of the number of tiles. Starts that are known to be poor are
    /// then only sketched.
    [[nodiscard]] bool has_many() const { return refined_tiles > 3000.0; }
};

/// A tiling of the outline, one of several to choose from.
struct Candidate {
    Dual dual;
    TessellationReport report;
    std::vector<Defect> defects;
    double side_error = 0.0;    ///< relative error of the mean ratio of sides to wanted sides
    double irregularity = 0.0;  ///< see Measures; smaller is better
    /// The distance of its sites as a multiple of the wanted side, if it was hard to find. Another attempt
    /// with nearly the same wanted sides starts with this value.
    std::optional<double> factor{};
};

/// A rough prediction of the tiling from a start: its irregularity, and the distance of the sites that gives
/// the wanted sides. It is cheap, and good enough to discard the worst starts. Reports rough_steps() steps of
/// progress.
struct Sketch {
    double irregularity = 0.0;
    double factor = 0.0;
    int tiles = 0;
};
Sketch make_sketch(const Task& task, const Start& start, Work& work);
std::size_t rough_steps(const TessellationOptions& options);

/// The tiling from a start, at the density of sites that gives the wanted sides. Reports candidate_steps()
/// steps of progress.
Candidate make_candidate(const Task& task, const Start& start, Work& work);
std::size_t candidate_steps(const TessellationOptions& options);

/// True if the first is the better choice.
bool is_better(const Candidate& first, const Candidate& second);

}  // namespace fretwork::tiling::detail
