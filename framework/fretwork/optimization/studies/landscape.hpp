// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/optimization/studies/study_problem.hpp>

#include <string>
#include <vector>

namespace fretwork::optimization::study {

/// Options of explore_landscape().
struct LandscapeOptions {
    ProblemFamilies families{};  ///< the families of the ids
    int descents = 300;          ///< number of descents of each kind on each problem, from uniform random
                                 ///< points
    int threads = 0;             ///< 0: one for each processor
    base::Control control{};     ///< progress counts finished problems
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The objective around its minima, as two tables in CSV.
struct Landscape {
    /// The ends of single descents. Kinds: "smoothed", with the default continuation; "sharp", with only its
    /// last stage; "residuals", Ceres on the residuals without smoothing.
    std::string descents;
    /// The objective and its smoothed versions along each variable, through the best of these points.
    std::string sections;
};

/// Explore the problems with these ids. Throws base::Stopped.
Landscape explore_landscape(const std::vector<std::string>& problems, const LandscapeOptions& options);

}  // namespace fretwork::optimization::study
