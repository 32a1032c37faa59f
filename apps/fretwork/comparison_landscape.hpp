// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fretwork::app {

struct LandscapeOptions {
    int descents = 300;  ///< of each kind on each problem, from uniform random points
    int threads = 0;
};

/// Look at the objective around its minima, and write two tables to a folder.
///
/// descents.csv: where single descents end. Kinds: "smoothed", with the default continuation; "sharp", with
/// all but the last stage left out; "residuals", Ceres on the bare residuals. sections.csv: the objective,
/// and what smoothing makes of it, along each variable through the best of these points.
void write_landscape(const std::vector<std::string>& problems, const LandscapeOptions& options,
                     const std::filesystem::path& folder);

}  // namespace fretwork::app
