// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/problem.hpp>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fretwork::optimization::study {

/// A problem on which optimizers are compared. Its id is "family/name".
struct StudyProblem {
    std::string id;
    std::shared_ptr<const optimization::Problem> problem;
    std::optional<double> best_value;  ///< where it is known in closed form
    Eigen::VectorXd optimum;           ///< likewise, or empty
    std::optional<double> scale{};     ///< of values that are good; none: the median of values less the best
};

/// Problems of one kind, found by name. A study is given all families that its ids may name.
struct ProblemFamily {
    std::string name;
    /// The problem of an id, and the part of it behind the family. Throws InputError if it names nothing.
    std::function<StudyProblem(const std::string& id, const std::string& name)> make;
};
using ProblemFamilies = std::vector<ProblemFamily>;

/// analytic/NAME: functions of the literature.
ProblemFamily analytic_family();
std::vector<std::string> analytic_problem_ids();

/// Throws InputError for an id that names nothing.
StudyProblem make_study_problem(const std::string& id, const ProblemFamilies& families);

/// One id a line; empty lines are left out. Throws InputError that names file and line for one that names no
/// problem, or that stands there already.
std::vector<std::string> read_problem_ids(const std::filesystem::path& path, const ProblemFamilies& families);

/// Those of `ids` that `choice` names, in their order: "all", or words joined by commas, each an id, a
/// family, or family:N for N of it, evenly spread. Throws InputError.
std::vector<std::string> chosen_problems(const std::vector<std::string>& ids, const std::string& choice);

/// "calibration" of "calibration/0-1+1-6".
std::string family_of(const std::string& id);

}  // namespace fretwork::optimization::study
