// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/solution.hpp>

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

}  // namespace fretwork::mechanics
