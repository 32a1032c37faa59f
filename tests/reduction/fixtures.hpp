// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/random.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/pattern/pattern.hpp>
#include <fretwork/reduction/calibration/calibration.hpp>
#include <fretwork/reduction/linear_response.hpp>
#include <fretwork/reduction/response.hpp>
#include <fretwork/reduction/ring/ring_problem.hpp>

#include <cmath>
#include <numbers>

namespace fretwork::reduction {

inline const pattern::NodeLayout& paper_layout() {
    static const pattern::NodeLayout layout = pattern::find_node_layout("paper7");
    return layout;
}

inline pattern::Pattern paper_pattern(std::string_view id) {
    return pattern::parse_pattern_id(paper_layout(), id);
}

/// The six parameters of the paper's model by name.
struct Paper6Parameters {
    double A = 0.0;
    double I2 = 0.0;
    double I3 = 0.0;
    double J = 0.0;
    double theta = 0.0;
    double R = 0.0;

    [[nodiscard]] std::vector<double> values() const { return {A, I2, I3, J, theta, R}; }
    [[nodiscard]] RingParts parts() const { return paper6_parameters().parts(values()); }
    operator RingParts() const { return parts(); }  // NOLINT(*-explicit-*)
    static Paper6Parameters from_values(std::span<const double> v) {
        return {v[0], v[1], v[2], v[3], v[4], v[5]};
    }
    static Paper6Parameters of(const RingParts& parts) {
        const Eigen::VectorXd values = reduction::paper6_parameters().select(parts);
        return from_values({values.data(), 6});
    }
};

/// Parameters anywhere between the given shares of the bounds; sections on a logarithmic scale.
inline Paper6Parameters random_parameters(const Setting& setting, base::RandomStream& random,
                                          double lowest = 0.2, double highest = 0.8) {
    const RingBounds bounds = ring_bounds(setting);
    const auto low = Paper6Parameters::of(bounds.lower);
    const auto high = Paper6Parameters::of(bounds.upper);
    const auto share = [&] { return lowest + (highest - lowest) * random.uniform(); };
    const auto logarithmic = [&](double a, double b) { return a * std::pow(b / a, share()); };
    const auto linear = [&](double a, double b) { return a + (b - a) * share(); };
    return {logarithmic(low.A, high.A), logarithmic(low.I2, high.I2),  logarithmic(low.I3, high.I3),
            logarithmic(low.J, high.J), linear(low.theta, high.theta), linear(low.R, high.R)};
}

/// The same for links and a ring with sections of their own.
inline RingParts random_parts(const Setting& setting, base::RandomStream& random) {
    RingParts parts = random_parameters(setting, random);
    parts.segment<4>(4) = random_parameters(setting, random).parts().head<4>();
    return parts;
}

/// The paper's model fitted to responses. The pattern plays no part in it.
inline Calibration calibrate_paper6(const std::vector<Response>& responses, const Setting& setting,
                                    const CalibrationOptions& options = {}) {
    const pattern::Pattern any = paper_pattern("0-1+1-6");
    return calibrate(find_tile_model("paper6"), {paper_layout(), any, setting, responses}, options);
}
inline Paper6Parameters paper6_values(const Calibration& calibration) {
    return Paper6Parameters::from_values(parameter_values(calibration, find_tile_model("paper6")));
}

/// The largest entry of a difference, relative to the largest entry.
template <class Left, class Right>
double relative_difference(const Left& left, const Right& right) {
    return (left - right).cwiseAbs().maxCoeff() / right.cwiseAbs().maxCoeff();
}

}  // namespace fretwork::reduction
