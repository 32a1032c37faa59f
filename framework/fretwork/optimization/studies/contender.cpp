// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/studies/contender.hpp>

#include <algorithm>
#include <string_view>

namespace fretwork::optimization::study {
namespace {

/// A method with more than one start, and its number of starts.
struct Starts {
    std::string_view method;
    int starts;
};
constexpr Starts kStarts[] = {
    {"ceres-multistart", 8},
    {"gauss-newton-multistart", 8},
    {"ceres-residuals", 8},
    {"ceres-dogleg", 8},
    {"ceres-subspace-dogleg", 8},
    {"ceres-sine", 8},
    {"ceres-smoothed", 8},
    {"ceres-smoothed-dogleg", 8},
    {"ceres-smoothed-subspace-dogleg", 8},
    {"ceres-smoothed-sine", 8},
    {"bobyqa", 8},
    {"subplex", 4},
    {"slsqp", 8},
    {"cma-es", 4},
};

}  // namespace

std::vector<Contender> default_contenders() {
    std::vector<Contender> contenders;
    for (const optimization::OptimizerRow& row : optimization::optimizer_catalogue()) {
        const auto* given = std::ranges::find(kStarts, row.name, &Starts::method);
        contenders.push_back({&row, given == std::end(kStarts) ? 1 : given->starts});
    }
    return contenders;
}

int repetitions_of(const Contender& contender, int wanted) {
    return contender.method->kind == optimization::OptimizerClass::Global ? 1 : wanted;
}

}  // namespace fretwork::optimization::study
