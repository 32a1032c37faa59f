// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/sparse/low_rank_update.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace fretwork::mechanics::structure {

/// Equations that can be solved on their own: all of a structure, or its half in or out of the plane. A
/// value: copies share layout and factors, which no copy changes.
class Subsystem {
  public:
    /// Equations without stiffness yet.
    Subsystem(sparse::SystemLayout layout, int threads, const base::Control& control);
    /// The same equations without stiffness: layout and symbolic analysis are shared.
    [[nodiscard]] Subsystem cleared() const;

    /// The same equations and factors without a correction.
    [[nodiscard]] Subsystem as_factorized() const;

    [[nodiscard]] const sparse::SystemLayout& layout() const { return *layout_; }

    /// Add an element's stiffness, and factorize the sum. Only before the equations are copied.
    void add(std::size_t element, const Eigen::MatrixXd& stiffness);
    /// Throws NumericalError that names a node of the assembly if the structure can move without strain.
    void factorize(const Assembly& assembly, const base::Control& control);

    /// The equations of some nodes, in their order.
    [[nodiscard]] std::vector<int> equations_of(std::span<const int> nodes) const;
    /// A change of the stiffness between some nodes (6n x 6n) as one of equations.
    [[nodiscard]] sparse::MatrixChange change_at(std::span<const int> nodes,
                                                 const Eigen::MatrixXd& stiffness) const;
    /// Multiplications of a correction for changes of these equations, and of a factorization.
    [[nodiscard]] double correction_work(std::span<const int> equations) const;
    [[nodiscard]] double factorization_work() const { return numbers_->factors.factorization_work(); }
    /// The stiffness as factorized, with these changes. False, and nothing is changed, if that would cost
    /// accuracy. Throws Stopped.
    bool correct(std::vector<sparse::MatrixChange> changes, const base::Control& control);

    /// Solve in place. Throws Stopped.
    template <class Dense>
    void solve(Dense& right_side, const base::Control& control = {}) const {
        if (correction_) {
            correction_->solve(numbers_->factors, right_side, control);
        } else {
            numbers_->factors.solve(right_side, control);
        }
    }
    /// The stiffness times x.
    [[nodiscard]] Eigen::VectorXd internal_forces(const Eigen::VectorXd& x) const;
    /// The forces that cancel in it, |K| |x|, with the stiffness as factorized.
    [[nodiscard]] Eigen::VectorXd cancelling_forces(const Eigen::VectorXd& x) const;

  private:
    struct Numbers {
        std::vector<double> values;
        sparse::Ldlt factors;
    };
    Subsystem() = default;

    std::shared_ptr<const sparse::SystemLayout> layout_;
    std::shared_ptr<Numbers> numbers_;
    std::optional<sparse::LowRankUpdate> correction_;
};

}  // namespace fretwork::mechanics::structure
