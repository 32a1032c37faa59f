// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/discretization.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace fretwork::mechanics {
namespace {

/// A solution's error over its difference from the solution with half the divisions: 1 / (2^2 - 1).
constexpr double kErrorFromCoarser = 1.0 / 3.0;

/// The relative difference above which two solutions lie on different branches of a buckled path, or are too
/// coarse for an estimate.
constexpr double kSameBranch = 0.5;

double largest_row(const NodeValues& values, int first) {
    return values.rows() == 0 ? 0.0 : values.middleCols<3>(first).rowwise().norm().maxCoeff();
}

/// The diagonal of the box around a frame, m.
double extent(const Frame& frame) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& node : frame.nodes) box.extend(node);
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

/// The error estimated from two solutions.
/// @param length  the rotation to which errors are compared is at least the largest displacement divided by
/// this length. Otherwise, rounding would be taken for an error in structures such as trusses, whose nodes
/// hardly turn
DiscretizationError error_between(const Solution& solution, const Solution& other, double error_of_difference,
                                  double length) {
    DiscretizationError error;
    const NodeValues difference = other.displacements - solution.displacements;
    const bool is_near = largest_row(difference, 0) <= kSameBranch * largest_row(solution.displacements, 0);
    error.known = solution.converged() && other.converged() && is_near;
    if (!error.known) return error;
    error.displacement = error_of_difference * largest_row(difference, 0);
    error.rotation = error_of_difference * largest_row(difference, 3);
    const auto share = [](double part, double whole) { return whole > 0.0 ? part / whole : 0.0; };
    const double displacement = largest_row(solution.displacements, 0);
    const double rotation = std::max(largest_row(solution.displacements, 3), share(displacement, length));
    error.share = std::max(share(error.displacement, displacement), share(error.rotation, rotation));
    return error;
}

bool can_be_halved(const Frame& frame) {
    return std::ranges::all_of(frame.beams, [](const Beam& beam) { return beam.divisions % 2 == 0; });
}

bool can_be_doubled(const Frame& frame) {
    return std::ranges::all_of(frame.beams,
                               [](const Beam& beam) { return beam.divisions <= kMostDivisions / 2; });
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
    for (std::size_t i = 0; i < frame.beams.size(); ++i) {
        int& divisions = frame.beams[i].divisions;
        const std::int64_t finer = std::int64_t{divisions} * times;
        if (finer > kMostDivisions)
            throw base::InputError("/beams/" + std::to_string(i) +
                                   "/divisions: " + std::to_string(divisions) + " cannot be multiplied by " +
                                   std::to_string(times) + "; " + std::to_string(kMostDivisions) +
                                   " at most are possible");
        divisions = static_cast<int>(finer);
    }
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
    if (!from_coarser && !can_be_doubled(frame)) return std::vector<DiscretizationError>(solutions.size());
    const Frame other = from_coarser ? halved(frame) : refined(frame, 2);
    const auto others =
        follow_load_path(assemble(other, {.control = options.control}), load_factors, options);
    std::vector<DiscretizationError> errors;
    for (std::size_t i = 0; i < others.size(); ++i)
        errors.push_back(error_between(solutions[i], others[i],
                                       from_coarser ? kErrorFromCoarser : kErrorFromFiner, extent(frame)));
    return errors;
}

}  // namespace fretwork::mechanics
