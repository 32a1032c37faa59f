// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/ring/ring_parameters.hpp>

#include <cmath>
#include <numbers>

namespace fretwork::reduction {
namespace {

Eigen::Vector4d section_parts(const mechanics::Section& section) {
    return {section.area, section.I2, section.I3, section.J};
}

RingParameters one_section() {
    RingParameters result{
        "paper6", {"A", "I2", "I3", "J", "theta", "R"}, Eigen::MatrixXd::Zero(kRingParts, 6)};
    result.ties.topLeftCorner<4, 4>().setIdentity();
    result.ties.block<4, 4>(4, 0).setIdentity();
    result.ties.bottomRightCorner<2, 2>().setIdentity();
    return result;
}

}  // namespace

RingBounds ring_bounds(const Setting& setting) {
    RingParts lower = RingParts::Constant(0.001);
    RingParts upper = RingParts::Constant(1000.0);
    lower[kRingTheta] = -std::numbers::pi / 6.0;
    upper[kRingTheta] = std::numbers::pi / 6.0;
    upper[kRingR] = 0.999;
    const RingParts units = ring_units(setting);
    return {lower.cwiseProduct(units), upper.cwiseProduct(units)};
}

RingParts ring_units(const Setting& setting) {
    RingParts units;
    units << section_parts(setting.section), section_parts(setting.section), 1.0,
        setting.tile_side / 2.0 / std::tan(std::numbers::pi / setting.sides);
    return units;
}

Eigen::Index RingParameters::part_of(Eigen::Index parameter) const {
    Eigen::Index part = 0;
    ties.col(parameter).maxCoeff(&part);
    return part;
}

Eigen::VectorXd RingParameters::select(const RingParts& parts) const {
    Eigen::VectorXd values(ties.cols());
    for (Eigen::Index k = 0; k < ties.cols(); ++k) values[k] = parts[part_of(k)];
    return values;
}

RingParts RingParameters::parts(std::span<const double> values) const {
    return ties * Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

const RingParameters& paper6_parameters() {
    static const RingParameters parameters = one_section();
    return parameters;
}

const RingParameters& ring10_parameters() {
    static const RingParameters parameters{
        "ring10",
        {"link_A", "link_I2", "link_I3", "link_J", "ring_A", "ring_I2", "ring_I3", "ring_J", "theta", "R"},
        Eigen::MatrixXd::Identity(kRingParts, kRingParts)};
    return parameters;
}

}  // namespace fretwork::reduction
