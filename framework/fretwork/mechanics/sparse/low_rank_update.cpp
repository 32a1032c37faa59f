// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/symmetric_eigen.hpp>
#include <fretwork/mechanics/sparse/low_rank_update.hpp>

#include <Eigen/Cholesky>

#include <cmath>

namespace fretwork::mechanics::sparse {
namespace {

/// The share of A's diagonal below which an eigenvalue of a change is rounding.
constexpr double kRounding = 1e-14;

/// The smallest and the largest pivot of the inner matrix with which the factors of A are good enough.
constexpr double kSoftest = 1e-5;
constexpr double kStiffest = 1e5;

std::vector<int> all_equations(std::span<const MatrixChange> changes) {
    std::vector<int> equations;
    for (const MatrixChange& change : changes)
        equations.insert(equations.end(), change.equations.begin(), change.equations.end());
    return equations;
}

}  // namespace

double LowRankUpdate::work(const Ldlt& factors, std::span<const int> equations) {
    const auto rank = static_cast<double>(equations.size());
    return factors.inverse_form_work(equations, std::ssize(equations)) + rank * rank * rank +
           factors.solution_work();
}

LowRankUpdate::Modes LowRankUpdate::modes_of(const Ldlt& factors, const MatrixChange& change) {
    if (change.equations.empty()) return {};
    Eigen::VectorXd scale(change.values.rows());
    for (Eigen::Index i = 0; i < scale.size(); ++i)
        scale[i] = std::sqrt(factors.diagonal(change.equations[i]));
    const Eigen::VectorXd inverse = scale.cwiseInverse();
    const Eigen::MatrixXd scaled = inverse.asDiagonal() * change.values * inverse.asDiagonal();
    const geometry::SymmetricEigen eigen = geometry::symmetric_eigen(scaled);
    const Eigen::ArrayXd values = eigen.values;  // eigenvalues, ascending
    const Eigen::Index minus = (values < -kRounding).count();
    const Eigen::Index plus = (values > kRounding).count();
    const Eigen::MatrixXd modes =
        scale.asDiagonal() * eigen.vectors * values.abs().sqrt().matrix().asDiagonal();
    return {modes.rightCols(plus), modes.leftCols(minus)};
}

template <class Body>
void LowRankUpdate::for_each_block(const Body& body) const {
    Eigen::Index plus = 0;
    Eigen::Index minus = plus_;
    for (std::size_t c = 0; c < changes_.size(); ++c) {
        body(changes_[c], modes_[c].plus, plus);
        body(changes_[c], modes_[c].minus, minus);
        plus += modes_[c].plus.cols();
        minus += modes_[c].minus.cols();
    }
}

std::optional<LowRankUpdate> LowRankUpdate::make(const Ldlt& factors, std::vector<MatrixChange> changes,
                                                 const base::Control& control) {
    LowRankUpdate update;
    update.changes_ = std::move(changes);
    for (const MatrixChange& change : update.changes_) {
        control.check();
        update.modes_.push_back(modes_of(factors, change));
        update.plus_ += update.modes_.back().plus.cols();
        update.minus_ += update.modes_.back().minus.cols();
    }
    if (update.rank() == 0) return update;
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(factors.equations(), update.rank());
    update.for_each_block([&](const MatrixChange& change, const Eigen::MatrixXd& modes, Eigen::Index first) {
        columns.middleCols(first, modes.cols())(change.equations, Eigen::all) = modes;
    });
    const std::vector<int> equations = all_equations(update.changes_);
    if (!update.factorize_inner(factors.inverse_form(std::move(columns), equations, control)))
        return std::nullopt;
    return update;
}

/// @param form  U^T A^-1 U
bool LowRankUpdate::factorize_inner(const Eigen::MatrixXd& form) {
    const auto factorize = [](std::optional<Eigen::LLT<Eigen::MatrixXd>>& factors, Eigen::MatrixXd matrix) {
        if (matrix.size() == 0) return true;
        matrix.diagonal().array() += 1.0;
        return factors.emplace(matrix).info() == Eigen::Success;
    };
    if (!factorize(stiffer_, form.topLeftCorner(plus_, plus_))) return false;
    coupling_ = form.bottomLeftCorner(minus_, plus_);
    Eigen::MatrixXd softer = -form.bottomRightCorner(minus_, minus_);
    if (plus_ > 0 && minus_ > 0) {  // Eigen's triangular solver takes no empty matrix
        const Eigen::MatrixXd half = stiffer_->matrixL().solve(coupling_.transpose());
        softer += half.transpose() * half;
    }
    if (!factorize(softer_, std::move(softer))) return false;  // the changed matrix is not positive definite
    const auto pivots = [](const Eigen::LLT<Eigen::MatrixXd>& factors) -> Eigen::ArrayXd {
        return factors.matrixLLT().diagonal().array().square();
    };
    return (plus_ == 0 || (pivots(*stiffer_) < kStiffest).all()) &&
           (minus_ == 0 || (pivots(*softer_) > kSoftest).all());
}

/// The product of (S + U^T A^-1 U)^-1 and some columns, by block elimination.
Eigen::MatrixXd LowRankUpdate::inner_solution(const Eigen::MatrixXd& projected) const {
    if (minus_ == 0) return stiffer_->solve(projected);
    if (plus_ == 0) return -softer_->solve(projected);
    Eigen::MatrixXd result(projected.rows(), projected.cols());
    const Eigen::MatrixXd plus = stiffer_->solve(projected.topRows(plus_));
    result.bottomRows(minus_) = -softer_->solve(projected.bottomRows(minus_) - coupling_ * plus);
    result.topRows(plus_) = plus - stiffer_->solve(coupling_.transpose() * result.bottomRows(minus_));
    return result;
}

void LowRankUpdate::solve(const Ldlt& factors, Eigen::VectorXd& right_side,
                          const base::Control& control) const {
    Eigen::MatrixXd columns = right_side;
    solve(factors, columns, control);
    right_side = columns.col(0);
}

void LowRankUpdate::solve(const Ldlt& factors, Eigen::MatrixXd& right_sides,
                          const base::Control& control) const {
    factors.solve(right_sides, control);
    if (rank() == 0) return;
    Eigen::MatrixXd projected(rank(), right_sides.cols());
    for_each_block([&](const MatrixChange& change, const Eigen::MatrixXd& modes, Eigen::Index first) {
        const Eigen::MatrixXd own = right_sides(change.equations, Eigen::all);
        projected.middleRows(first, modes.cols()) = modes.transpose() * own;
    });
    const Eigen::MatrixXd weights = inner_solution(projected);
    Eigen::MatrixXd correction = Eigen::MatrixXd::Zero(right_sides.rows(), right_sides.cols());
    for_each_block([&](const MatrixChange& change, const Eigen::MatrixXd& modes, Eigen::Index first) {
        correction(change.equations, Eigen::all) += modes * weights.middleRows(first, modes.cols());
    });
    factors.solve(correction, control);
    right_sides -= correction;
}

void LowRankUpdate::add_product(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
    for (const MatrixChange& change : changes_) {
        const Eigen::VectorXd own = x(change.equations);
        y(change.equations) += change.values * own;
    }
}

}  // namespace fretwork::mechanics::sparse
