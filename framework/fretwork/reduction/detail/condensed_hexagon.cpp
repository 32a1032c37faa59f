// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/detail/condensed_hexagon.hpp>

#include <Eigen/Cholesky>

#include <complex>
#include <numbers>

namespace fretwork::reduction::detail {
namespace {

using Eigen::Matrix3cd;
using Eigen::Matrix3d;

/// Columns shifted so that column i is column i + by.
NodeColumns shifted(const NodeColumns& columns, int by) {
    NodeColumns result;
    for (int i = 0; i < kSectors; ++i) result.col(i) = columns.col((i + by + kSectors) % kSectors);
    return result;
}

/// The inverse of the ring's matrix. The discrete Fourier transform over the sectors splits it into one
/// Hermitian 3 x 3 matrix for each harmonic; harmonics m and 6 - m are conjugates.
BlockCirculant inverse_of_ring(const HexagonBlocks& blocks) {
    constexpr int kHarmonics = kSectors / 2 + 1;
    BlockCirculant inverse;
    for (Matrix3d& block : inverse.blocks) block.setZero();
    for (int m = 0; m < kHarmonics; ++m) {
        const auto phase = std::polar(1.0, 2.0 * std::numbers::pi * m / kSectors);
        const Matrix3cd matrix = blocks.ring_own.cast<std::complex<double>>() + phase * blocks.ring_next +
                                 std::conj(phase) * blocks.ring_next.transpose();
        const Matrix3cd harmonic = matrix.llt().solve(Matrix3cd::Identity());
        const double share = (m == 0 || m == kSectors / 2 ? 1.0 : 2.0) / kSectors;
        std::complex<double> factor = share;
        for (int d = 0; d < kSectors; ++d) {
            inverse.blocks[d] += (factor * harmonic).real();
            factor *= std::conj(phase);
        }
    }
    return inverse;
}

}  // namespace

NodeColumns BlockCirculant::apply(const NodeColumns& columns) const {
    NodeColumns result = blocks[0] * columns;
    for (int d = 1; d < kSectors; ++d) result.noalias() += blocks[d] * shifted(columns, d);
    return result;
}

CondensedHexagon::CondensedHexagon(const HexagonBlocks& blocks)
    : blocks_(blocks), ring_inverse_(inverse_of_ring(blocks)) {}

PlaneStiffness CondensedHexagon::stiffness() const {
    std::array<Matrix3d, kSectors> rows;
    for (int d = 0; d < kSectors; ++d) {
        rows[d] = -blocks_.interface_ring * ring_inverse_.blocks[d] * blocks_.interface_ring.transpose();
    }
    rows[0] += blocks_.interface_own;
    PlaneStiffness result;
    for (int i = 0; i < kSectors; ++i) {
        for (int j = 0; j < kSectors; ++j) {
            result.block<3, 3>(3 * i, 3 * j) = rows[(j - i + kSectors) % kSectors];
        }
    }
    return result;
}

NodeColumns CondensedHexagon::ring_displacements(const NodeColumns& interface) const {
    return -ring_inverse_.apply(blocks_.interface_ring.transpose() * interface);
}

NodeColumns CondensedHexagon::changed_forces(const HexagonBlocks& change, const NodeColumns& interface,
                                             const NodeColumns& ring) const {
    NodeColumns on_ring = change.interface_ring.transpose() * interface + change.ring_own * ring;
    on_ring += change.ring_next * shifted(ring, 1) + change.ring_next.transpose() * shifted(ring, -1);
    return change.interface_own * interface + change.interface_ring * ring -
           blocks_.interface_ring * ring_inverse_.apply(on_ring);
}

}  // namespace fretwork::reduction::detail
