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
        case Ending::Stopped:
            return "stopped";
    }
    return "unknown";
}

/// The largest number of starts. A larger number is a slip, and would fill the memory before the budget ends
/// the search.
constexpr int kMostStarts = 100'000;

void OptimizerOptions::validate() const {
    if (starts < 1 || starts > kMostStarts)
        throw base::InputError("starts: " + std::to_string(starts) + " must be from 1 to " +
                               std::to_string(kMostStarts));
}

}  // namespace fretwork::optimization
