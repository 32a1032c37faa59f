// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/scenarios/setting.hpp>

#include <Eigen/Core>

#include <span>
#include <string>
#include <vector>

namespace fretwork::reduction {

/// The number of parts. The parts are the quantities that define a ring with links: A (m^2), I2, I3 and J
/// (m^4) of the links; A, I2, I3 and J of the ring; theta (rad, counterclockwise positive); R (m). If each
/// side has one interface node, R is the ring's circumradius; ring_tile() defines R in general.
inline constexpr int kRingParts = 10;
/// The index of theta among the parts.
inline constexpr int kRingTheta = 8;
/// The index of R among the parts.
inline constexpr int kRingR = 9;
/// All parts of a ring, in the order that kRingParts states.
using RingParts = Eigen::Matrix<double, kRingParts, 1>;

/// The bounds of a calibration. A, I2, I3 and J lie within [0.001, 1000] times the value of the setting's
/// section (Section 5.3). theta lies within [-30, 30] degrees. R lies within [0.001, 0.999] times the
/// centroid-to-side distance. With R equal to this distance, which Eq. (7) allows, and theta = 0, the links
/// would have length zero.
struct RingBounds {
    RingParts lower;  ///< smallest value of each part, SI
    RingParts upper;  ///< largest value of each part, SI
};
/// The bounds of a calibration in a setting.
RingBounds ring_bounds(const Setting& setting);

/// The scale of each part: the value of the setting's section, 1 rad, or the centroid-to-side distance.
/// A part divided by its scale has no unit.
RingParts ring_units(const Setting& setting);

/// The map from a tile model's parameters to the parts of a ring with links: parts = ties * parameters. Each
/// parameter sets one part, or several parts of one kind to the same value.
struct RingParameters {
    std::string model;               ///< name of the tile model
    std::vector<std::string> names;  ///< names of the parameters
    /// Matrix of zeros and ones with one row for each part and one column for each parameter.
    Eigen::MatrixXd ties;

    /// The first part that a parameter sets.
    [[nodiscard]] Eigen::Index part_of(Eigen::Index parameter) const;
    /// The parameters at given values of the parts: each parameter takes the value of the first part that it
    /// sets.
    [[nodiscard]] Eigen::VectorXd select(const RingParts& parts) const;
    /// All parts at given values of the parameters.
    [[nodiscard]] RingParts parts(std::span<const double> values) const;
};

/// The six parameters of Eq. (4), with one section for links and ring: A, I2, I3, J, theta, R.
const RingParameters& paper6_parameters();
/// Ten parameters, one for each part: link_A .., ring_A .., theta, R.
const RingParameters& ring10_parameters();

}  // namespace fretwork::reduction
