// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/results/solution.hpp>

namespace fretwork::mechanics {

std::string_view termination_name(Termination termination) {
    switch (termination) {
        case Termination::Converged:
            return "converged";
        case Termination::LimitLoad:
            return "limit-load";
        case Termination::Diverged:
            return "diverged";
        case Termination::IterationsSpent:
            return "iterations-spent";
    }
    return "";
}

std::string_view stability_test_name(StabilityTest test) {
    switch (test) {
        case StabilityTest::None:
            return "none";
        case StabilityTest::Tangent:
            return "tangent";
        case StabilityTest::SymmetricPart:
            return "symmetric-part";
    }
    return "";
}

Solution end_of_path(std::span<const Solution> path) {
    Solution end = path.back();
    end.iterations = 0;
    end.stability_losses.clear();
    for (const Solution& solution : path) {
        end.iterations += solution.iterations;
        end.stability_losses.insert(end.stability_losses.end(), solution.stability_losses.begin(),
                                    solution.stability_losses.end());
    }
    return end;
}

}  // namespace fretwork::mechanics
