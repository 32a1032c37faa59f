// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/elements/linear_element.hpp>
#include <fretwork/mechanics/linear_element.hpp>

#include <string>

namespace fretwork::mechanics {
namespace {

void check_size(const char* name, const Eigen::MatrixXd& matrix, std::size_t nodes) {
    const auto size = static_cast<Eigen::Index>(nodes) * kDofsPerNode;
    if (matrix.rows() == size && matrix.cols() == size) return;
    throw base::InputError("an element of " + std::to_string(nodes) + " nodes needs a " + name + " of " +
                           std::to_string(size) + " rows and columns, not " + std::to_string(matrix.rows()) +
                           " x " + std::to_string(matrix.cols()));
}

}  // namespace

std::unique_ptr<const Element> linear_element(std::vector<NodeIndex> nodes, LinearMatrices matrices) {
    check_size("stiffness", matrices.stiffness, nodes.size());
    if (matrices.mass.size() > 0) check_size("mass", matrices.mass, nodes.size());
    return std::make_unique<elements::LinearElement>(std::move(nodes), std::move(matrices));
}

}  // namespace fretwork::mechanics
