// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/scenarios/setting.hpp>

#include <Eigen/Core>

#include <span>
#include <string>
#include <vector>

namespace fretwork::reduction {

/// The quantities that define a ring with links: A, I2, I3, J (m^2, m^4) of the links, then of the ring,
/// theta (rad, counterclockwise positive) and R (m), the ring's circumradius.
inline constexpr int kRingParts = 10;
/// The place of theta among the parts.
inline constexpr int kRingTheta = 8;
/// The place of R among the parts.
inline constexpr int kRingR = 9;
/// All parts of a ring, in this order.
using RingParts = Eigen::Matrix<double, kRingParts, 1>;

/// The bounds of a calibration: sections within [0.001, 1000] times the setting's (Section 5.3); theta within
/// 30 degrees; R within [0.001, 0.999] of the centroid-to-side distance, because with R equal to that
/// distance and theta = 0 the links would have length zero (Eq. (7) allows that).
struct RingBounds {
    RingParts lower;  ///< SI
    RingParts upper;  ///< SI
};
/// The bounds of a setting.
RingBounds ring_bounds(const Setting& setting);

/// Scales that make the parts numbers near 1: the setting's section, 1 rad, and the centroid-to-side
/// distance.
RingParts ring_units(const Setting& setting);

/// The map from a tile model's parameters to the parts of a ring with links: parts = ties * parameters. Each
/// parameter sets one part, or several parts of one kind to the same value.
struct RingParameters {
    std::string model;               ///< the row of the catalogue
    std::vector<std::string> names;  ///< of the parameters
    Eigen::MatrixXd ties;            ///< a column of zeros and ones for each parameter

    /// The first part that a parameter sets.
    [[nodiscard]] Eigen::Index part_of(Eigen::Index parameter) const;
    /// The parameters at given values of the parts: each takes the value of the first part that it sets.
    [[nodiscard]] Eigen::VectorXd select(const RingParts& parts) const;
    /// All parts that these parameters' values set.
    [[nodiscard]] RingParts parts(std::span<const double> values) const;
};

/// The six parameters of Eq. (4), with one section for links and ring: A, I2, I3, J, theta, R.
const RingParameters& paper6_parameters();
/// Ten parameters, one for each part: link_A .., ring_A .., theta, R.
const RingParameters& ring10_parameters();

}  // namespace fretwork::reduction
