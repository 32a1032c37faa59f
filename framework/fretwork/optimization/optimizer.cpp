// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/optimization/optimizer.hpp>

namespace fretwork::optimization {

std::string_view optimizer_class_name(OptimizerClass kind) {
    switch (kind) {
        case OptimizerClass::Local:
            return "local";
        case OptimizerClass::Global:
            return "global";
        case OptimizerClass::Random:
            return "random";
    }
    return "unknown";
}

std::string_view ending_name(Ending ending) {
    switch (ending) {
        case Ending::Converged:
            return "converged";
        case Ending::BudgetSpent:
            return "budget-spent";
        case Ending::Stalled:
            return "stalled";
        case Ending::Invalid:
            return "invalid";
    }
    return "unknown";
}

void OptimizerOptions::validate() const {
    if (starts < 1) throw base::InputError("starts: " + std::to_string(starts) + " must be at least 1");
}

}  // namespace fretwork::optimization
