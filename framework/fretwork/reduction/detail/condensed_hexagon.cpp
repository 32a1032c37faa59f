// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/detail/condensed_hexagon.hpp>

#include <complex>
#include <numbers>

namespace fretwork::reduction::detail {
namespace {

using Eigen::Matrix3cd;
using Eigen::Matrix3d;
using Complex = std::complex<double>;

constexpr int kHalf = kSectors / 2;

/// Shifted columns: column i of the result is column i + by.
NodeColumns shifted(const NodeColumns& columns, int by) {
    NodeColumns result;
    for (int i = 0; i < kSectors; ++i) result.col(i) = columns.col((i + by + kSectors) % kSectors);
    return result;
}

std::array<Complex, kSectors> roots_of_one() {
    std::array<Complex, kSectors> roots;
    for (int d = 0; d < kSectors; ++d) roots[d] = std::polar(1.0, 2.0 * std::numbers::pi * d / kSectors);
    return roots;
}

/// The inverse L^-* D^-1 L^-1 of a positive definite matrix M = L D L^*. Only the lower triangle of M is
/// read.
Matrix3cd inverse_of_hermitian(const Matrix3cd& M) {
    const double D0 = M(0, 0).real();
    const Complex L10 = M(1, 0) / D0;
    const Complex L20 = M(2, 0) / D0;
    const double D1 = M(1, 1).real() - std::norm(L10) * D0;
    const Complex L21 = (M(2, 1) - M(2, 0) * std::conj(L10)) / D1;
    const double D2 = M(2, 2).real() - std::norm(L20) * D0 - std::norm(L21) * D1;
    const Complex X20 = L21 * L10 - L20;  // entry of L^-1, which has -L10 and -L21 next to its diagonal
    Matrix3cd inverse;
    inverse(2, 2) = 1.0 / D2;
    inverse(2, 1) = -L21 / D2;
    inverse(2, 0) = X20 / D2;
    inverse(1, 1) = 1.0 / D1 + std::norm(L21) / D2;
    inverse(1, 0) = -L10 / D1 - std::conj(L21) * inverse(2, 0);
    inverse(0, 0) = 1.0 / D0 + std::norm(L10) / D1 + std::norm(X20) / D2;
    inverse(0, 1) = std::conj(inverse(1, 0));
    inverse(0, 2) = std::conj(inverse(2, 0));
    inverse(1, 2) = std::conj(inverse(2, 1));
    return inverse;
}

/// Fill the second half of the blocks with the transposes of the first half.
void complete(BlockCirculant& matrix) {
    for (int d = kHalf + 1; d < kSectors; ++d) matrix.blocks[d] = matrix.blocks[kSectors - d].transpose();
}

/// The inverse of the ring's matrix. The discrete Fourier transform over the sectors splits it into one
/// Hermitian 3 x 3 matrix for each harmonic; harmonics m and 6 - m are conjugates.
BlockCirculant inverse_of_ring(const HexagonBlocks& blocks) {
    static const auto kRoots = roots_of_one();
    const Matrix3d even = blocks.ring_next + blocks.ring_next.transpose();
    const Matrix3d odd = blocks.ring_next - blocks.ring_next.transpose();
    BlockCirculant inverse;
    for (int d = 0; d <= kHalf; ++d) inverse.blocks[d].setZero();
    for (int m = 0; m <= kHalf; ++m) {
        Matrix3cd matrix;
        matrix.real() = blocks.ring_own + kRoots[m].real() * even;
        matrix.imag() = kRoots[m].imag() * odd;
        const Matrix3cd harmonic = inverse_of_hermitian(matrix);
        const double share = (m == 0 || m == kHalf ? 1.0 : 2.0) / kSectors;
        for (int d = 0; d <= kHalf; ++d) {
            const Complex factor = share * std::conj(kRoots[(d * m) % kSectors]);
            inverse.blocks[d] += factor.real() * harmonic.real() - factor.imag() * harmonic.imag();
        }
    }
    complete(inverse);
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

BlockCirculant CondensedHexagon::stiffness() const {
    const Matrix3d back = blocks_.interface_ring.transpose();
    BlockCirculant result;
    for (int d = 0; d <= kHalf; ++d) {
        const Matrix3d forces = blocks_.interface_ring * ring_inverse_.blocks[d];
        result.blocks[d] = -forces * back;
    }
    result.blocks[0] += blocks_.interface_own;
    complete(result);
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

void CondensedHexagon::add_work(const NodeColumns& one, const NodeColumns& other, HexagonBlocks& sum) const {
    const NodeColumns one_ring = ring_displacements(one);
    const NodeColumns other_ring = ring_displacements(other);
    sum.interface_own.noalias() += one * other.transpose();
    sum.interface_ring.noalias() += one * other_ring.transpose() + other * one_ring.transpose();
    sum.ring_own.noalias() += one_ring * other_ring.transpose();
    sum.ring_next.noalias() +=
        one_ring * shifted(other_ring, 1).transpose() + other_ring * shifted(one_ring, 1).transpose();
}

}  // namespace fretwork::reduction::detail
