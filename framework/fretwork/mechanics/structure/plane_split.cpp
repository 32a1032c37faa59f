// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/structure/plane_split.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace fretwork::mechanics::structure {

bool is_flat(const Assembly& assembly) {
    return std::all_of(assembly.nodes.begin(), assembly.nodes.end(),
                       [&](const Eigen::Vector3d& node) { return node.z() == assembly.nodes.front().z(); });
}

bool decouples(const Eigen::MatrixXd& stiffness) {
    constexpr double kRounding = 1e-14;
    constexpr std::array<Eigen::Index, 3> kIn = {0, 1, 5};
    constexpr std::array<Eigen::Index, 3> kOut = {2, 3, 4};
    for (Eigen::Index column = 0; column < stiffness.cols(); column += kDofsPerNode) {
        for (Eigen::Index row = 0; row < stiffness.rows(); row += kDofsPerNode) {
            for (const Eigen::Index j : kOut) {
                for (const Eigen::Index i : kIn) {
                    const double coupling = stiffness(row + i, column + j);
                    if (coupling == 0.0) continue;  // frequent case; saves the square root
                    const double scale = stiffness(row + i, row + i) * stiffness(column + j, column + j);
                    if (std::abs(coupling) > kRounding * std::sqrt(scale)) return false;
                }
            }
        }
    }
    return true;
}

}  // namespace fretwork::mechanics::structure
