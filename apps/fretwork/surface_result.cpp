// SPDX-License-Identifier: GPL-3.0-or-later
#include "output.hpp"
#include "surface_result.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>

#include <algorithm>
#include <utility>

namespace fretwork::app {

namespace {

/// A warning, with the files of the results that have it.
struct SharedWarning {
    std::string text;
    std::vector<std::string> files;
};

void add_warning(const std::string& text, const std::string& file, std::vector<SharedWarning>& warnings) {
    auto known = std::ranges::find(warnings, text, &SharedWarning::text);
    if (known == warnings.end()) known = warnings.insert(known, {text, {}});
    if (std::ranges::find(known->files, file) == known->files.end()) known->files.push_back(file);
}

}  // namespace

simulation::SurfaceResult read_surface_result(const std::string& file) {
    return std::move(read_surface_results({&file, 1}).front());
}

std::vector<simulation::SurfaceResult> read_surface_results(std::span<const std::string> files) {
    std::vector<simulation::SurfaceResult> results;
    std::vector<SharedWarning> warnings;
    for (const std::string& file : files) {
        results.push_back(simulation::read_surface_result(file));
        simulation::check_subject(*results.back().subject, file);
        for (const std::string& text : simulation::result_warnings(results.back()))
            add_warning(text, file, warnings);
    }
    for (const SharedWarning& warning : warnings)
        warn(base::join(warning.files, " and ") + ": " + warning.text);
    return results;
}

void check_subject_of(const simulation::SurfaceIdentity& surface, const simulation::SurfaceResult& result,
                      const std::string& file) {
    const std::string difference = simulation::subject_difference(*result.subject, surface);
    if (!difference.empty())
        throw base::InputError(file, "", "is not a result of this project: they differ in " + difference);
}

}  // namespace fretwork::app
