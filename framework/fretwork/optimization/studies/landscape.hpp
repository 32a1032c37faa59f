// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/optimization/studies/study_problem.hpp>

#include <string>
#include <vector>

namespace fretwork::optimization::study {

/// Options of explore_landscape().
struct LandscapeOptions {
    ProblemFamilies families{};  ///< families to which the ids of problems may refer
    int descents = 300;          ///< number of descents of each kind on each problem, from uniform random
                                 ///< points
    int threads = 0;             ///< number of threads; 0: one for each processor
    base::Control control{};     ///< progress counts finished problems
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The objectives of problems around their minima, as two tables in CSV.
struct Landscape {
    /// The best points of single descents. A descent has one of three kinds: "smoothed", by the default
    /// continuation; "sharp", by only the last stage of the default continuation; "residuals", by Ceres on
    /// the residuals without smoothing.
    std::string descents;
    /// For each problem, the objective and the smoothed objectives along each variable, through the best of
    /// the problem's points in `descents`.
    std::string sections;
};

/// Explore the problems with these ids. Throws InputError if an option is invalid, NumericalError if a
/// problem does not offer residuals and curvatures, and as make_study_problem() and minimize().
Landscape explore_landscape(const std::vector<std::string>& problems, const LandscapeOptions& options);

}  // namespace fretwork::optimization::study
