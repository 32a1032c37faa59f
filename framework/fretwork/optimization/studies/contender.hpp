// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer_catalogue.hpp>

#include <vector>

namespace fretwork::optimization::study {

/// A method with its number of starts, as it takes part in a study.
struct Contender {
    const optimization::OptimizerRow* method = nullptr;  ///< a row of a catalogue
    int starts = 1;                                      ///< number of starts in one run
};

/// All methods of the catalogue with their numbers of starts in a study. A method with short descents gets
/// more starts than a method with one long run, so that both have the same chance.
std::vector<Contender> default_contenders();

/// The number of runs of a contender on one problem: 1 if its method is deterministic, else `wanted`.
int repetitions_of(const Contender& contender, int wanted);

}  // namespace fretwork::optimization::study
