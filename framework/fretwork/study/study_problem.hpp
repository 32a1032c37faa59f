// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/problem.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fretwork::study {

/// A problem on which optimizers are compared. Its id is "family/name":
/// - calibration/PATTERN: the paper's model fitted to a pattern's responses in the paper's setting; a pattern
/// of another layout than the paper's has the layout's name in front (paper8:0-1+1-7);
/// - synthetic/N: the same fitted to itself, with parameters drawn at random from the middle 80 % of their
/// ranges;
/// - analytic/NAME: a function of the literature.
struct StudyProblem {
    std::string id;
    std::shared_ptr<const optimization::Problem> problem;
    std::optional<double> best_value;  ///< where it is known in closed form
    Eigen::VectorXd optimum;           ///< likewise, or empty
};

/// Throws InputError for an id that names nothing.
StudyProblem make_study_problem(const std::string& id);

/// Patterns of the paper's layout, spread over the numbers of edges and, within each, over three classes of
/// bending stiffness; 12 synthetic problems; all analytic ones.
std::vector<std::string> study_problem_ids(std::size_t patterns);

/// One id a line; empty lines are left out. Throws InputError that names file and line for one that names no
/// problem, or that stands there already.
std::vector<std::string> read_problem_ids(const std::filesystem::path& path);

/// Of `ids` those that `choice` names, in their order: "all", or words joined by commas, each an id, a
/// family, or family:N for N of it, evenly spread. Throws InputError.
std::vector<std::string> chosen_problems(const std::vector<std::string>& ids, const std::string& choice);

/// "calibration" of "calibration/0-1+1-6".
std::string family_of(const std::string& id);

}  // namespace fretwork::study
