// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>
#include <fretwork/mechanics/sparse/arbitrary.hpp>

namespace fretwork::mechanics::sparse {

Eigen::MatrixXd arbitrary_numbers(Eigen::Index rows, Eigen::Index columns) {
    Eigen::MatrixXd numbers(rows, columns);
    base::SplitMix64 random(1);
    for (double& entry : numbers.reshaped()) entry = 2.0 * random.share() - 1.0;
    return numbers;
}

}  // namespace fretwork::mechanics::sparse
