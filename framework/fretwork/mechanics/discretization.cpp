// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/discretization.hpp>

#include <algorithm>
#include <string>

namespace fretwork::mechanics {
namespace {

/// The share of the difference to a solution with other divisions that is a solution's own error, with order
/// two: 1 / (1 - 2^-2) to one with twice, 1 / (2^2 - 1) to one with half the divisions.
constexpr double kErrorFromFiner = 4.0 / 3.0;
constexpr double kErrorFromCoarser = 1.0 / 3.0;

double largest_row(const NodeValues& values, int first) {
    return values.rows() == 0 ? 0.0 : values.middleCols<3>(first).rowwise().norm().maxCoeff();
}

DiscretizationError compare(const Solution& solution, const Solution& other, double error_of_difference) {
    DiscretizationError error;
    error.known = solution.converged() && other.converged();
    if (!error.known) return error;
    const NodeValues difference = other.displacements - solution.displacements;
    error.displacement = error_of_difference * largest_row(difference, 0);
    error.rotation = error_of_difference * largest_row(difference, 3);
    const auto share = [](double part, double whole) { return whole > 0.0 ? part / whole : 0.0; };
    error.share = std::max(share(error.displacement, largest_row(solution.displacements, 0)),
                           share(error.rotation, largest_row(solution.displacements, 3)));
    return error;
}

bool can_be_halved(const Frame& frame) {
    return std::ranges::all_of(frame.beams, [](const Beam& beam) { return beam.divisions % 2 == 0; });
}

Frame halved(Frame frame) {
    for (Beam& beam : frame.beams) beam.divisions /= 2;
    return frame;
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
    const bool from_coarser = can_be_halved(frame);
    const Frame other = from_coarser ? halved(frame) : refined(frame, 2);
    const auto others = follow_load_path(assemble(other), load_factors, options);
    std::vector<DiscretizationError> errors;
    for (std::size_t i = 0; i < others.size(); ++i)
        errors.push_back(
            compare(solutions[i], others[i], from_coarser ? kErrorFromCoarser : kErrorFromFiner));
    return errors;
}

}  // namespace fretwork::mechanics
