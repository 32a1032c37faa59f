// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/structure/mechanism.hpp>
#include <fretwork/mechanics/structure/subsystem.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::mechanics::structure {

Subsystem::Subsystem(sparse::SystemLayout layout, int threads, const base::Control& control)
    : layout_(std::make_shared<const sparse::SystemLayout>(std::move(layout))),
      numbers_(std::make_shared<Numbers>(std::vector<double>(layout_->row().size(), 0.0),
                                         sparse::Ldlt(*layout_, threads, control))) {}

Subsystem Subsystem::cleared() const {
    Subsystem result;
    result.layout_ = layout_;
    result.numbers_ = std::make_shared<Numbers>(std::vector<double>(layout_->row().size(), 0.0),
                                                numbers_->factors.another());
    return result;
}

Subsystem Subsystem::as_factorized() const {
    Subsystem result;
    result.layout_ = layout_;
    result.numbers_ = numbers_;
    return result;
}

void Subsystem::add(std::size_t element, const Eigen::MatrixXd& stiffness) {
    layout_->add(element, stiffness, numbers_->values);
}

void Subsystem::factorize(const Assembly& assembly, const base::Control& control) {
    const sparse::Ldlt::Outcome outcome = numbers_->factors.factorize(numbers_->values, control);
    refuse_mechanisms(assembly, *layout_, numbers_->values, numbers_->factors, outcome, control);
}

std::vector<int> Subsystem::equations_of(std::span<const int> nodes) const {
    std::vector<int> equations;
    for (const int node : nodes) {
        for (int d = 0; d < kDofsPerNode; ++d) {
            if (const int equation = layout_->equation(node, d); equation >= 0) equations.push_back(equation);
        }
    }
    return equations;
}

sparse::MatrixChange Subsystem::change_at(std::span<const int> nodes,
                                          const Eigen::MatrixXd& stiffness) const {
    std::vector<int> dofs;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (int d = 0; d < kDofsPerNode; ++d) {
            if (layout_->equation(nodes[i], d) >= 0) dofs.push_back(static_cast<int>(i) * kDofsPerNode + d);
        }
    }
    return {equations_of(nodes), stiffness(dofs, dofs)};
}

double Subsystem::correction_work(std::span<const int> equations) const {
    return sparse::LowRankUpdate::work(numbers_->factors, equations);
}

bool Subsystem::correct(std::vector<sparse::MatrixChange> changes, const base::Control& control) {
    auto correction = sparse::LowRankUpdate::make(numbers_->factors, std::move(changes), control);
    if (!correction) return false;
    correction_ = std::move(correction);
    return true;
}

Eigen::VectorXd Subsystem::internal_forces(const Eigen::VectorXd& x) const {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(x.size());
    sparse::add_product(*layout_, numbers_->values, x, forces);
    if (correction_) correction_->add_product(x, forces);
    return forces;
}

Eigen::VectorXd Subsystem::cancelling_forces(const Eigen::VectorXd& x) const {
    std::vector<double> values(numbers_->values.size());
    std::ranges::transform(numbers_->values, values.begin(), [](double value) { return std::abs(value); });
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(x.size());
    sparse::add_product(*layout_, values, x.cwiseAbs(), forces);
    return forces;
}

}  // namespace fretwork::mechanics::structure
