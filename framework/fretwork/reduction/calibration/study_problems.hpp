// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/studies/study_problem.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>

#include <string>
#include <vector>

namespace fretwork::reduction {

/// A setting with a name, which ids of problems state after an '@'.
struct NamedSetting {
    std::string name;  ///< name, not empty, without '@', '/', ',', ':', quotes and blanks
    Setting setting;   ///< the setting
};

/// The families of problems on which the framework compares optimizers:
/// - calibration/PATTERN: the paper's model, fitted to a pattern's responses in the paper's setting. The id
///   of a pattern of another layout starts with that layout's name (paper8:0-1+1-7).
///   calibration/PATTERN@SETTING is the same in a setting of `settings`;
/// - synthetic/N: the paper's model, fitted to its own displacements at a random point in the middle 80 % of
///   the range of each variable;
/// - analytic/NAME: a function of the literature.
/// Throws InputError if a setting's name is not valid. Making a calibration throws as compute_responses().
optimization::study::ProblemFamilies study_families(const std::vector<NamedSetting>& settings = {});

/// The ids of the problems of a study: `patterns` patterns of the paper's layout, 12 synthetic problems, and
/// all analytic functions. The patterns are spread over the numbers of edges and, within each number, over
/// three classes of bending stiffness.
std::vector<std::string> study_problem_ids(std::size_t patterns);
/// The ids of the calibrations among study_problem_ids(), in the setting with this name.
std::vector<std::string> study_problem_ids_in(const std::string& setting, std::size_t patterns);

}  // namespace fretwork::reduction
