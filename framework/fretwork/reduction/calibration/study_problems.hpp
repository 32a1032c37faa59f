// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/studies/study_problem.hpp>

#include <string>
#include <vector>

namespace fretwork::reduction {

/// The families of problems on which the framework compares optimizers:
/// - calibration/PATTERN: the paper's model, fitted to a pattern's responses in the paper's setting. If the
///   pattern is of another layout than the paper's, its id starts with the name of that layout
///   (paper8:0-1+1-7);
/// - synthetic/N: the paper's model, fitted to the model's own displacements at parameters that are drawn at
///   random from the middle 80 % of their ranges;
/// - analytic/NAME: a function of the literature.
optimization::study::ProblemFamilies study_families();

/// The ids of the problems of a study: `patterns` patterns of the paper's layout, 12 synthetic problems, and
/// all analytic functions. The patterns are spread over the numbers of edges and, within each number, over
/// three classes of bending stiffness.
std::vector<std::string> study_problem_ids(std::size_t patterns);

}  // namespace fretwork::reduction
