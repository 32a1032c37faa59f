// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/sparse/low_rank_update.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace fretwork::mechanics::structure {

/// A system of equations that can be solved on its own: all equations of a structure, only those in its
/// plane, or only those out of its plane. The class is a value: copies share layout and factors, which do not
/// change.
class Subsystem {
  public:
    /// Make a system without stiffness. Throws Stopped.
    Subsystem(sparse::SystemLayout layout, int threads, const base::Control& control);
    /// A copy of the system without stiffness, which shares layout and symbolic analysis.
    [[nodiscard]] Subsystem cleared() const;

    /// A copy of the system with its factors and without the correction.
    [[nodiscard]] Subsystem as_factorized() const;

    [[nodiscard]] const sparse::SystemLayout& layout() const { return *layout_; }

    /// Add an element's stiffness. Call add() and factorize() only before the subsystem is copied.
    void add(std::size_t element, const Eigen::MatrixXd& stiffness);
    /// Factorize the sum of all stiffnesses. Throws as the constructor of LinearSolver.
    void factorize(const Assembly& assembly, const base::Control& control);

    /// The equations of some nodes, in their order.
    [[nodiscard]] std::vector<int> equations_of(std::span<const int> nodes) const;
    /// A change of the stiffness between some nodes (6n x 6n), expressed as a change of the matrix of the
    /// equations.
    [[nodiscard]] sparse::MatrixChange change_at(std::span<const int> nodes,
                                                 const Eigen::MatrixXd& stiffness) const;
    /// The numbers of multiplications of a correction for changes of these equations, and of a factorization.
    [[nodiscard]] double correction_work(std::span<const int> equations) const;
    [[nodiscard]] double factorization_work() const { return numbers_->factors.factorization_work(); }
    /// Correct the factorized stiffness by these changes. Returns false and changes nothing if the correction
    /// would lose accuracy, or if the corrected stiffness is not positive definite. Throws Stopped.
    bool correct(std::vector<sparse::MatrixChange> changes, const base::Control& control);

    /// Solve the equations in place. Throws Stopped.
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
    /// The sum of the absolute values of all terms of K x, |K| |x|, with the factorized stiffness. This sum
    /// bounds the rounding error of internal_forces().
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
