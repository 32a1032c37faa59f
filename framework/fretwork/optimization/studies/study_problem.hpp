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
    std::string id;                                        ///< `family/name`
    std::shared_ptr<const optimization::Problem> problem;  ///< the problem to minimize
    std::optional<double> best_value;                      ///< the minimum, if it is known in closed form
    Eigen::VectorXd optimum;                               ///< the point of the minimum; empty: not known
    /// Scale of differences from the best value. None: their median over spread points or, if `best_value` is
    /// none, the lowest value found.
    std::optional<double> scale{};
};

/// Problems of one kind, found by name. A study gets all families to which its ids may refer.
struct ProblemFamily {
    std::string name;  ///< name of the family, before the `/` of an id
    /// A function that makes the problem with an id; `name` is the rest of the id after "family/". Throws
    /// InputError if there is no such problem.
    std::function<StudyProblem(const std::string& id, const std::string& name)> make;
};
/// The families to which the ids of a study may refer.
using ProblemFamilies = std::vector<ProblemFamily>;

/// The family analytic/NAME: test functions of the literature.
ProblemFamily analytic_family();
/// The ids of the analytic problems.
std::vector<std::string> analytic_problem_ids();

/// Make the problem with an id. Throws InputError if there is no such family, and as ProblemFamily::make.
StudyProblem make_study_problem(const std::string& id, const ProblemFamilies& families);

/// Read a list of ids, one on each line; empty lines are skipped. Throws InputError that names file and line
/// if an id is unknown or appears twice. Throws InputError if the file cannot be read or has no id, and as
/// make_study_problem().
std::vector<std::string> read_problem_ids(const std::filesystem::path& path, const ProblemFamilies& families);

/// The ids that `choice` selects, in the order of `ids`. The choice is "all", or words joined by commas. A
/// word is an id, a family for all its ids, or family:N for N of its ids, evenly spread. Throws InputError.
std::vector<std::string> chosen_problems(const std::vector<std::string>& ids, const std::string& choice);

/// The name of an id's family: "calibration" for "calibration/0-1+1-6".
std::string family_of(const std::string& id);

}  // namespace fretwork::optimization::study
