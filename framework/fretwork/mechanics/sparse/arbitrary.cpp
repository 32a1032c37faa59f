// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/sparse/arbitrary.hpp>

#include <cstdint>

namespace fretwork::mechanics::sparse {

Eigen::MatrixXd arbitrary_numbers(Eigen::Index rows, Eigen::Index columns) {
    Eigen::MatrixXd numbers(rows, columns);
    std::uint64_t state = 1;
    for (double& entry : numbers.reshaped()) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;  // Knuth's MMIX generator
        entry = static_cast<double>(state >> 11) * 0x1.0p-52 - 1.0;
    }
    return numbers;
}

}  // namespace fretwork::mechanics::sparse
