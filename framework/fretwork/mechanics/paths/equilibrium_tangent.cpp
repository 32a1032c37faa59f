// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/nonlinear/tangent_at.hpp>

#include <utility>

namespace fretwork::mechanics {

EquilibriumTangent::EquilibriumTangent(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
EquilibriumTangent::EquilibriumTangent(EquilibriumTangent&&) noexcept = default;
EquilibriumTangent& EquilibriumTangent::operator=(EquilibriumTangent&&) noexcept = default;
EquilibriumTangent::~EquilibriumTangent() = default;

std::span<const NodeState> EquilibriumTangent::states() const {
    return impl_->states();
}

Eigen::MatrixXd EquilibriumTangent::motions(const Eigen::MatrixXd& forces,
                                            const base::Control& control) const {
    Eigen::MatrixXd rows = forces;
    impl_->moments_to_vectors(rows);
    rows = impl_->rows_of(impl_->solve(impl_->equations_of(rows), nonlinear::Newton::Side::Tangent, control));
    impl_->vectors_to_spins(rows);
    return rows;
}

Eigen::MatrixXd EquilibriumTangent::motions_of_held(const Eigen::MatrixXd& values,
                                                    const base::Control& control) const {
    return impl_->motions_of_held(values, control);
}

Eigen::MatrixXd EquilibriumTangent::adjoint_motions(const Eigen::MatrixXd& gradients,
                                                    const base::Control& control) const {
    Eigen::MatrixXd rows = gradients;
    impl_->gradients_to_spins(rows);
    rows =
        impl_->rows_of(impl_->solve(impl_->equations_of(rows), nonlinear::Newton::Side::Transposed, control));
    impl_->vectors_to_spins(rows);
    return rows;
}

Eigen::MatrixXd EquilibriumTangent::by_held_values(const Eigen::MatrixXd& gradients,
                                                   const Eigen::MatrixXd& adjoint_motions) const {
    return impl_->by_held_values(gradients, adjoint_motions);
}

Eigen::MatrixXd EquilibriumTangent::as_rotation_vectors(const Eigen::MatrixXd& motions) const {
    Eigen::MatrixXd rows = motions;
    impl_->spins_to_vectors(rows);
    return rows;
}

Eigen::MatrixXd EquilibriumTangent::strain_slopes(std::size_t element) const {
    return impl_->strain_slopes(element);
}

Eigen::VectorXd EquilibriumTangent::internal_forces(std::size_t element) const {
    return impl_->internal_forces(element);
}

std::vector<Eigen::MatrixXd> EquilibriumTangent::flexibilities(std::span<const std::size_t> elements,
                                                               const base::Control& control) const {
    return impl_->flexibilities(elements, control);
}

}  // namespace fretwork::mechanics
