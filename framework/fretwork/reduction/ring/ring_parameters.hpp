// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/scenarios/setting.hpp>

#include <Eigen/Core>

#include <span>
#include <string>
#include <vector>

namespace fretwork::reduction {

/// All that a ring with links consists of: A, I2, I3, J (m^2, m^4) of the links, the same of the ring, theta
/// (rad, counterclockwise positive) and R (m), the ring's circumradius.
inline constexpr int kRingParts = 10;
inline constexpr int kRingTheta = 8;
inline constexpr int kRingR = 9;
using RingParts = Eigen::Matrix<double, kRingParts, 1>;

/// The bounds of a calibration: sections within [0.001, 1000] times the setting's (Section 5.3); theta within
/// 30 degrees; R within [0.001, 0.999] of the centroid-to-side distance, since at the whole of it and
/// theta = 0 the links would have no length (Eq. (7) allows that).
struct RingBounds {
    RingParts lower;
    RingParts upper;
};
RingBounds ring_bounds(const Setting& setting);

/// The units of the parts where numbers near 1 are wanted: the setting's section, 1 rad, and the
/// centroid-to-side distance.
RingParts ring_units(const Setting& setting);

/// Which parts of a ring with links a tile model's parameters set: parts = ties * parameters. Each parameter
/// sets one part, or several of one kind alike.
struct RingParameters {
    std::string model;  ///< the row of the catalogue
    std::vector<std::string> names;
    Eigen::MatrixXd ties;  ///< a column of zeros and ones for each parameter

    /// The part that a parameter sets; of several the first.
    [[nodiscard]] Eigen::Index part_of(Eigen::Index parameter) const;
    /// Some parts' values as the parameters' own: of parts that one parameter sets, the first.
    [[nodiscard]] Eigen::VectorXd select(const RingParts& parts) const;
    [[nodiscard]] RingParts parts(std::span<const double> values) const;
};

/// A, I2, I3, J, theta, R: the six of Eq. (4), where links and ring have one section.
const RingParameters& paper6_parameters();
/// All ten: link_A .., ring_A .., theta, R.
const RingParameters& ring10_parameters();

}  // namespace fretwork::reduction
