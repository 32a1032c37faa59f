// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer_catalogue.hpp>

#include <vector>

namespace fretwork::optimization::study {

/// A method as it takes part in a study, with restarts as a part of it.
struct Contender {
    const optimization::OptimizerRow* method = nullptr;
    int starts = 1;
};

/// All methods of the catalogue with the number of starts that the study gives them: enough that a method
/// made of short descents is no worse off than one whose single run takes long.
std::vector<Contender> default_contenders();

/// How often a contender runs on one problem: once if its method is deterministic, else as often as wanted.
int repetitions_of(const Contender& contender, int wanted);

}  // namespace fretwork::optimization::study
