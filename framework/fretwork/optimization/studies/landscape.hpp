// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/optimization/studies/study_problem.hpp>

#include <string>
#include <vector>

namespace fretwork::optimization::study {

struct LandscapeOptions {
    ProblemFamilies families{};  ///< that the ids name
    int descents = 300;          ///< of each kind on each problem, from uniform random points
    int threads = 0;             ///< 0: all there are
    base::Control control{};     ///< receives every finished problem
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The objective around its minima, as two tables in CSV.
struct Landscape {
    /// Where single descents end. Kinds: "smoothed", with the default continuation; "sharp", with all but its
    /// last stage left out; "residuals", Ceres on the bare residuals.
    std::string descents;
    /// The objective, and what smoothing makes of it, along each variable through the best of these points.
    std::string sections;
};

/// Explore problems, which are named by their ids. Throws base::Stopped.
Landscape explore_landscape(const std::vector<std::string>& problems, const LandscapeOptions& options);

}  // namespace fretwork::optimization::study
