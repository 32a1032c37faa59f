// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/nonlinear/load_path.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <cmath>

namespace fretwork::mechanics {
namespace {

void check_factors(std::span<const double> factors) {
    double last = 0.0;
    for (const double factor : factors) {
        if (!std::isfinite(factor) || !(factor > last))
            throw base::InputError("load factor " + base::format_number(factor) +
                                   " does not lie above the one before it, " + base::format_number(last));
        last = factor;
    }
}

}  // namespace

std::vector<Solution> follow_load_path(const Assembly& assembly, std::span<const double> load_factors,
                                       const EquilibriumOptions& options) {
    options.validate();
    check_factors(load_factors);
    std::vector<Solution> solutions;
    if (load_factors.empty()) return solutions;
    nonlinear::LoadPath path(assembly, options);
    const base::Task task(options.control, "load path (thousandths of the load)", nonlinear::kThousandths);
    for (const double factor : load_factors) {
        if (solutions.empty() || solutions.back().converged()) {
            solutions.push_back(path.advance_to(factor, {task, load_factors.back()}));
        } else {
            solutions.push_back(solutions.back());
            solutions.back().iterations = 0;
            solutions.back().stability_losses.clear();  // each loss is reported once
        }
    }
    return solutions;
}

}  // namespace fretwork::mechanics
