// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/models/tile_model.hpp>

#include <Eigen/Core>

#include <array>
#include <complex>
#include <span>
#include <string>
#include <vector>

namespace fretwork::tile_models {

/// Every stiffness of a flat tile that a turn by 60 degrees leaves as it is (the group C6, and the reflection
/// in the tile's own plane): 44 numbers.
///
/// A fan is its pattern turned from side to side, so a tile has these turns. It has mirrors in its plane (the
/// group C6v) only if the pattern has one; so they are not required.
///
/// In axes that turn with the interface nodes (along the side's normal, along the side, across the plane) the
/// stiffness is block circulant. The discrete Fourier transform over the sides splits it into a Hermitian
/// block for each harmonic m = 0, 1, 2, 3 (harmonics m and 6 - m are conjugates) and plane: in the tile's
/// plane for (u_n, u_t, h r_z), out of it for (u_z, h r_n, h r_t), where h is the centroid-to-side distance.
/// Rigid motions are the null vectors of m = 0 (one in each plane) and m = 1 (one complex one): the rest of
/// each block is B = V L D L^* V^*, with an orthonormal basis V of what is not rigid, L lower triangular with
/// ones on its diagonal, and D diagonal. So any values with D > 0 give a stiffness that is positive on all
/// but rigid motions, and every such stiffness has one set of values.
class SymmetricStiffness {
  public:
    static constexpr int kParameters = 44;
    enum class Kind { Pivot, Coupling };  ///< an entry of D, N/m; a real or imaginary part of L's, 1
    enum class Plane { Membrane, Bending };
    struct Parameter {
        std::string name;  ///< "membrane2_d1", "bending1_re21"
        Kind kind;
        std::array<int, 2>
            pivots;  ///< the parameters that are the two pivots of a coupling; of a pivot, itself
    };
    static const std::vector<Parameter>& parameters();

    /// For a tile of any polygon: harmonics are those of its number of sides (from the third one on the
    /// hexagon's third), axes those of its sides; what remains of its rigid motions is projected out. In the
    /// regular hexagon of `size` it is the stiffness of the parameters. Stiffness falls with the third power
    /// of a tile's size, as that of bent beams does.
    /// @param size  the centroid-to-side distance for which the parameters are given, m
    SymmetricStiffness(const geometry::Polygon& polygon, double size);

    /// 6n x 6n for n sides, SI.
    [[nodiscard]] Eigen::MatrixXd stiffness(std::span<const double> values) const;
    /// The values of the parameters for a stiffness of a regular hexagon; what is not symmetric in it, or
    /// resists a rigid motion, is left out.
    [[nodiscard]] std::vector<double> values_of(const Eigen::MatrixXd& stiffness) const;

  private:
    using Block = Eigen::Matrix3cd;
    void add_circulant(Plane plane, std::span<const Block> harmonics, Eigen::MatrixXd& sum) const;

    int sides_;
    double scale_;                            ///< of the stiffness with the tile's size
    std::array<Eigen::MatrixXd, 2> strains_;  ///< (3n x 6n) of each plane: a node's components in its axes
};

/// The row of a catalogue, calibrated within a factor of 3 of the pivots of some values, and within 0.3 of
/// the couplings in units that make the two pivots of each alike. Without values it can only be built.
reduction::TileModel symmetric_stiffness_model(const std::vector<double>& around = {});

/// The values of a pattern's condensed stiffness in the setting's hexagon.
std::vector<double> condensed_values(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                                     const reduction::Setting& setting);

}  // namespace fretwork::tile_models
