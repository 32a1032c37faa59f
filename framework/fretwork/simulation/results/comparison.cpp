// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/node_states.hpp>
#include <fretwork/simulation/results/comparison.hpp>
#include <fretwork/simulation/results/result_subject.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <vector>

namespace fretwork::simulation {
namespace {

/// The rows of the interface nodes in the result, by their ids.
std::map<int, Eigen::Index> interface_rows(const SurfaceResult& result) {
    std::map<int, Eigen::Index> rows;
    for (std::size_t i = 0; i < result.nodes.size(); ++i) {
        if (result.nodes[i].is_interface) rows.emplace(result.nodes[i].id, static_cast<Eigen::Index>(i));
    }
    return rows;
}

void require_converged(const SurfaceResult& result, const std::string& which) {
    if (!result.solution.converged()) {
        throw base::InputError("the " + which + " result did not converge (" +
                               std::string(mechanics::termination_name(result.solution.termination)) +
                               "): nothing to compare");
    }
}

/// Results of a session have no subject, and cannot be checked.
void require_same_subject(const SurfaceResult& full, const SurfaceResult& reduced) {
    if (!full.subject || !reduced.subject) return;
    const std::string difference = subject_difference(*full.subject, *reduced.subject);
    if (!difference.empty())
        throw base::InputError("the two results do not belong together: they differ in " + difference);
    if (reduced.subject->is_reference && !full.subject->is_reference)
        throw base::InputError("the first result is of the model " + full.subject->model +
                               ", the second of the model " + reduced.subject->model +
                               ": name the full one first");
    if (full.subject->model == reduced.subject->model && full.solver == reduced.solver)
        throw base::InputError("both results are of the model " + full.subject->model +
                               " and the same solver: there is nothing to compare");
}

void require_same_place(const mechanics::Result::Node& full, const mechanics::Result::Node& reduced) {
    constexpr double kTolerance = 1e-9;  // m; our files keep every digit, those of other programs may not
    if ((full.rest_position - reduced.rest_position).norm() > kTolerance) {
        throw base::InputError("interface node " + std::to_string(full.id) +
                               " lies at different places in the two results: they are not of one surface");
    }
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double standard_deviation(const std::vector<double>& values) {
    const double middle = mean(values);
    double sum = 0.0;
    for (const double value : values) sum += (value - middle) * (value - middle);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

double largest_of_interface(const SurfaceResult& result, const Eigen::MatrixX3d& rows) {
    double largest = 0.0;
    for (const auto& [id, row] : interface_rows(result)) largest = std::max(largest, rows.row(row).norm());
    return largest;
}

/// Values collected node by node.
struct Errors {
    std::vector<double> translation;
    std::vector<double> rotation;
    double squared_difference = 0.0;
    double squared_displacement = 0.0;
    Eigen::AlignedBox2d box;
    double max_displacement = 0.0;
    double max_rotation = 0.0;

    void add(const Eigen::Vector3d& rest, const auto& full, const auto& reduced) {
        const Eigen::Vector3d displacement = full.template head<3>();
        const Eigen::Vector3d difference = displacement - Eigen::Vector3d(reduced.template head<3>());
        const Eigen::Quaterniond turned = geometry::exponential(full.template tail<3>());
        translation.push_back(difference.norm());
        rotation.push_back(turned.angularDistance(geometry::exponential(reduced.template tail<3>())));
        squared_difference += difference.squaredNorm();
        squared_displacement += displacement.squaredNorm();
        box.extend(rest.head<2>());
        max_displacement = std::max(max_displacement, displacement.norm());
        max_rotation = std::max(max_rotation, turned.angularDistance(Eigen::Quaterniond::Identity()));
    }
};

Errors collect(const SurfaceResult& full, const SurfaceResult& reduced) {
    const auto full_rows = interface_rows(full);
    const auto reduced_rows = interface_rows(reduced);
    if (full_rows.empty()) throw base::InputError("the results have no interface nodes to compare");
    if (full_rows.size() != reduced_rows.size()) {
        throw base::InputError("the results have " + std::to_string(full_rows.size()) + " and " +
                               std::to_string(reduced_rows.size()) +
                               " interface nodes: they are not of one surface");
    }
    Errors errors;
    for (const auto& [id, row] : full_rows) {
        const auto match = reduced_rows.find(id);
        if (match == reduced_rows.end()) {
            throw base::InputError("interface node " + std::to_string(id) +
                                   " is missing in the reduced result");
        }
        require_same_place(full.nodes[row], reduced.nodes[match->second]);
        const Eigen::Matrix<double, 6, 1> truth = full.solution.displacements.row(row);
        const Eigen::Matrix<double, 6, 1> guess = reduced.solution.displacements.row(match->second);
        errors.add(full.nodes[row].rest_position, truth, guess);
    }
    return errors;
}

}  // namespace

double largest_displacement(const SurfaceResult& result, const mechanics::Solution& solution) {
    return largest_of_interface(result, solution.displacements.leftCols<3>());
}

double largest_rotation(const SurfaceResult& result, const mechanics::Solution& solution) {
    return largest_of_interface(result, solution.displacements.rightCols<3>());
}

Comparison compare(const SurfaceResult& full, const SurfaceResult& reduced) {
    require_same_subject(full, reduced);
    require_converged(full, "full");
    require_converged(reduced, "reduced");
    const Errors errors = collect(full, reduced);
    Comparison comparison;
    comparison.width = errors.box.sizes().x();
    comparison.height = errors.box.sizes().y();
    comparison.max_displacement = errors.max_displacement;
    comparison.max_translation_error =
        *std::max_element(errors.translation.begin(), errors.translation.end());
    comparison.mean_translation_error = mean(errors.translation);
    comparison.sd_translation_error = standard_deviation(errors.translation);
    comparison.max_rotation = errors.max_rotation;
    comparison.max_rotation_error = *std::max_element(errors.rotation.begin(), errors.rotation.end());
    comparison.mean_rotation_error = mean(errors.rotation);
    comparison.sd_rotation_error = standard_deviation(errors.rotation);
    comparison.relative_l2_error = errors.squared_displacement > 0
                                       ? std::sqrt(errors.squared_difference / errors.squared_displacement)
                                       : 0.0;
    if (!std::isfinite(comparison.relative_l2_error) || !std::isfinite(comparison.max_translation_error) ||
        !std::isfinite(comparison.max_rotation_error))
        throw base::InputError("the results hold displacements that are too large to be compared");
    comparison.full_is_unstable = full.solution.is_unstable();
    for (const SurfaceResult* result : {&full, &reduced}) {
        if (!comparison.joints && result->subject) comparison.joints = result->subject->joints;
    }
    comparison.full_seconds = full.seconds;
    comparison.reduced_seconds = reduced.seconds;
    return comparison;
}

std::string comparison_text(const Comparison& comparison) {
    constexpr double kDegrees = 57.29577951308232;
    const double largest = comparison.max_displacement;
    const auto share = [&](double error) { return largest > 0 ? 100.0 * error / largest : 0.0; };
    char text[1200];
    std::snprintf(
        text, sizeof text,
        "surface %.4g x %.4g mm, largest displacement %.4g mm, largest rotation %.4g deg (interface nodes)\n"
        "                        largest         mean           sd\n"
        "translation error  %9.4g mm %9.4g mm %9.4g mm\n"
        "   of the largest  %9.3g %%  %9.3g %%  %9.3g %%\n"
        "rotation error     %8.4g deg %8.4g deg %8.4g deg\n"
        "relative L2 error of the translations: %.3g %%\n"
        "time: full %.3g s, reduced %.3g s\n",
        1e3 * comparison.width, 1e3 * comparison.height, 1e3 * largest, kDegrees * comparison.max_rotation,
        1e3 * comparison.max_translation_error, 1e3 * comparison.mean_translation_error,
        1e3 * comparison.sd_translation_error, share(comparison.max_translation_error),
        share(comparison.mean_translation_error), share(comparison.sd_translation_error),
        kDegrees * comparison.max_rotation_error, kDegrees * comparison.mean_rotation_error,
        kDegrees * comparison.sd_rotation_error, 100.0 * comparison.relative_l2_error,
        comparison.full_seconds, comparison.reduced_seconds);
    if (!comparison.joints) return text;
    return text + ("joints: " + std::string(reduction::joints_name(*comparison.joints))) + "\n";
}

std::string comparison_header() {
    return "example,width_m,height_m,max_displacement_m,max_translation_error_m,mean_translation_error_m,"
           "sd_translation_error,max_rotation_rad,max_rotation_error_rad,mean_rotation_error_rad,sd_rotation_"
           "error,"
           "full_model_minutes,reduced_model_milliseconds";
}

std::string comparison_row(const std::string& example, const Comparison& comparison) {
    const double values[] = {comparison.width,
                             comparison.height,
                             comparison.max_displacement,
                             comparison.max_translation_error,
                             comparison.mean_translation_error,
                             comparison.sd_translation_error,
                             comparison.max_rotation,
                             comparison.max_rotation_error,
                             comparison.mean_rotation_error,
                             comparison.sd_rotation_error,
                             comparison.full_seconds / 60.0,
                             comparison.reduced_seconds * 1e3};
    std::string row = base::csv_field(example);
    for (const double value : values) row += "," + base::format_number(value);
    return row;
}

}  // namespace fretwork::simulation
