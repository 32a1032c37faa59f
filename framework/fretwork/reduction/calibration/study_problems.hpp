// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/studies/study_problem.hpp>

#include <string>
#include <vector>

namespace fretwork::reduction {

/// The families of problems on which the framework compares optimizers:
/// - calibration/PATTERN: the paper's model fitted to a pattern's responses in the paper's setting; a pattern
/// of
///   another layout than the paper's has the layout's name in front (paper8:0-1+1-7);
/// - synthetic/N: the same fitted to itself, with parameters drawn at random from the middle 80 % of their
/// ranges;
/// - analytic/NAME: a function of the literature.
optimization::study::ProblemFamilies study_families();

/// Patterns of the paper's layout, spread over the numbers of edges and, within each, over three classes of
/// bending stiffness; 12 synthetic problems; all analytic ones.
std::vector<std::string> study_problem_ids(std::size_t patterns);

}  // namespace fretwork::reduction
