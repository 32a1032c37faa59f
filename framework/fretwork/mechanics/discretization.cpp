// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/discretization.hpp>

#include <algorithm>
#include <string>

namespace fretwork::mechanics {
namespace {

/// 1 / (1 - 2^-order) with order two.
constexpr double kRichardson = 4.0 / 3.0;

double largest_row(const NodeValues& values, int first) {
    return values.rows() == 0 ? 0.0 : values.middleCols<3>(first).rowwise().norm().maxCoeff();
}

DiscretizationError compare(const Solution& coarse, const Solution& fine) {
    DiscretizationError error;
    error.known = coarse.converged() && fine.converged();
    if (!error.known) return error;
    const NodeValues difference = fine.displacements - coarse.displacements;
    error.displacement = kRichardson * largest_row(difference, 0);
    error.rotation = kRichardson * largest_row(difference, 3);
    const auto share = [](double part, double whole) { return whole > 0.0 ? part / whole : 0.0; };
    error.share = std::max(share(error.displacement, largest_row(fine.displacements, 0)),
                           share(error.rotation, largest_row(fine.displacements, 3)));
    return error;
}

}  // namespace

Frame refined(Frame frame, int times) {
    if (times < 1)
        throw base::InputError("beams cannot be divided " + std::to_string(times) +
                               " times as finely; a number above zero is needed");
    for (Beam& beam : frame.beams) beam.divisions *= times;
    return frame;
}

std::vector<DiscretizationError> estimate_discretization_error(const Frame& frame,
                                                               std::span<const double> load_factors,
                                                               std::span<const Solution> solutions,
                                                               const EquilibriumOptions& options) {
    if (solutions.size() != load_factors.size())
        throw base::InputError("there are " + std::to_string(solutions.size()) + " solutions for " +
                               std::to_string(load_factors.size()) + " load factors");
    const auto fine = follow_load_path(assemble(refined(frame, 2)), load_factors, options);
    std::vector<DiscretizationError> errors;
    for (std::size_t i = 0; i < fine.size(); ++i) errors.push_back(compare(solutions[i], fine[i]));
    return errors;
}

}  // namespace fretwork::mechanics
