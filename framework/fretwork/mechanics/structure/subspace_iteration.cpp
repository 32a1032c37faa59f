// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/symmetric_eigen.hpp>
#include <fretwork/mechanics/sparse/arbitrary.hpp>
#include <fretwork/mechanics/structure/subspace_iteration.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace fretwork::mechanics::structure {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostIterations = 500;

/// The number of vectors in addition to the wanted vectors. Eigenvalues near the end of the range converge
/// last, so the last ones should not be wanted.
constexpr int kSpareVectors = 8;

/// Load factors 1 / mu above this multiple of the smallest one are rounding, and are not searched.
constexpr double kReach = 1e8;

/// The start of the first slice, as a share of the smallest factor. The share is not a round number, because
/// factors of symmetric structures often have simple ratios, and none should lie on the border of two slices.
constexpr double kStart = 0.73;

/// Vectors of unit energy are dependent if a unit combination of them has less than this energy.
constexpr double kDependent = 1e-13;

/// The smallest scale of a vector; vectors that vanish stay unchanged.
constexpr double kNothing = 1e-300;

/// A test whether values have converged: their change is within the tolerance or, if it no longer falls,
/// within the range of rounding.
class Settling {
  public:
    Settling() = default;
    explicit Settling(VectorXd last) : last_(std::move(last)) {}
    bool is_settled(const VectorXd& values, const VectorXd& scale) {
        const VectorXd last = std::exchange(last_, values);
        if (values.size() != last.size()) {
            *this = Settling(values);
            return false;
        }
        if (values.size() == 0) return true;
        const double change = (values - last).cwiseAbs().cwiseQuotient(scale).maxCoeff();
        const bool nears = change < 0.5 * least_;
        idle_ = nears ? 0 : idle_ + 1;
        if (nears) least_ = change;
        return change <= kTolerance || (idle_ >= kIdle && change <= kWandering);
    }

  private:
    static constexpr double kTolerance = 1e-11;
    static constexpr double kWandering = 1e-5;
    /// After so many iterations in which the smallest change was not halved, only rounding changes values.
    static constexpr int kIdle = 60;
    VectorXd last_;
    double least_ = std::numeric_limits<double>::max();
    int idle_ = 0;
};

}  // namespace

SubspaceIteration::SubspaceIteration(const sparse::SystemLayout& layout, Matrices matrices,
                                     sparse::Ldlt factors, const base::Control& control)
    : layout_(layout),
      stiffness_(matrices.stiffness),
      operand_(std::move(matrices.operand)),
      factors_(std::move(factors)),
      control_(control),
      task_(control, "modes (iterations)", kMostIterations) {}

SubspaceIteration::Pairs SubspaceIteration::largest(int count) {
    factorize_shifted(0.0);
    const int size = std::min(layout_.equations(), std::max(2 * count, count + kSpareVectors));
    Pairs pairs{VectorXd(0), sparse::arbitrary_numbers(layout_.equations(), size)};
    Settling settling;
    for (int iteration = 0; pairs.vectors.cols() > 0; ++iteration) {
        pairs = step(pairs.vectors, 0.0);
        const VectorXd values = pairs.values.head(std::min<Eigen::Index>(count, pairs.values.size()));
        const double scale = values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0.0;
        if (settling.is_settled(values, VectorXd::Constant(values.size(), scale))) break;
        if (iteration >= kMostIterations)
            throw base::NumericalError("the " + std::to_string(count) + " lowest modes do not settle");
    }
    const Eigen::Index kept = std::min<Eigen::Index>(count, pairs.values.size());
    return {pairs.values.head(kept), pairs.vectors.leftCols(kept)};
}

/// All factors lambda = 1 / mu in (lower, upper].
struct SubspaceIteration::Slice {
    double lower;
    double upper;
    int count;
    int size;  ///< size of the subspace, for all factors in (lower / 2, upper + lower / 2] and a few more

    [[nodiscard]] bool contains(double mu) const { return mu * lower < 1.0 && mu * upper >= 1.0; }
};

SubspaceIteration::Pairs SubspaceIteration::largest_positive(int count) {
    Pairs found{VectorXd(0), MatrixXd(layout_.equations(), 0)};
    double lower = find_start();
    if (lower == 0.0) return found;
    const double end = kReach * lower;
    int below = 0;
    while (found.values.size() < count && lower < end) {
        double upper = 2.0 * lower;
        const int below_upper = count_below(upper);
        if (below_upper > below) {
            // In each iteration, modes with factors farther from the middle of the slice than its width lose
            // half or more of their share against the modes in the slice. The subspace has room for all
            // modes with nearer factors.
            double near = 0.5 * lower;
            double far = upper + 0.5 * lower;
            const int size = count_below(far) - count_below(near) + kSpareVectors;
            append_slice({lower, upper, below_upper - below, std::min(layout_.equations(), size)}, found);
        }
        lower = upper;
        below = below_upper;
    }
    const Eigen::Index kept = std::min<Eigen::Index>(count, found.values.size());
    return {found.values.head(kept), found.vectors.leftCols(kept)};
}

/// A factor below all positive factors; 0 if all eigenvalues are nearly zero.
double SubspaceIteration::find_start() {
    const Pairs extreme = largest(1);
    const double size = extreme.values.size() > 0 ? std::abs(extreme.values[0]) : 0.0;
    if (!(size > 1.0 / kReach / kReach)) return 0.0;
    double start = kStart / size;
    while (count_below(start) > 0) start *= 0.5;
    return start;
}

/// The number of positive factors below `factor`. If K - factor A is singular, `factor` is raised slightly.
int SubspaceIteration::count_below(double& factor) {
    constexpr double kStepAside = 1.0 + 1e-6;
    constexpr int kMostSteps = 20;
    for (int i = 0; i < kMostSteps; ++i, factor *= kStepAside) {
        factorize_shifted(factor);
        if (outcome_.zero_pivot < 0) return outcome_.negative_pivots;
    }
    throw base::NumericalError("the stiffness under " + base::format_number(factor) +
                               " times the load is singular in every digit");
}

void SubspaceIteration::append_slice(const Slice& slice, Pairs& found) {
    double shift = 0.5 * (slice.lower + slice.upper);
    (void)count_below(shift);
    Pairs pairs{VectorXd(0), sparse::arbitrary_numbers(layout_.equations(), slice.size)};
    Settling settling;
    for (int iteration = 0; iteration < kMostIterations && pairs.vectors.cols() > 0; ++iteration) {
        pairs = step(pairs.vectors, shift);
        std::vector<Eigen::Index> inside;
        for (Eigen::Index i = 0; i < pairs.values.size(); ++i)
            if (slice.contains(pairs.values[i])) inside.push_back(i);
        std::ranges::sort(inside, [&](auto a, auto b) { return pairs.values[a] > pairs.values[b]; });
        const VectorXd values = pairs.values(inside);
        if (!settling.is_settled(values, values) || values.size() != slice.count) continue;
        const Eigen::Index before = found.values.size();
        found.values.conservativeResize(before + slice.count);
        found.vectors.conservativeResize(Eigen::NoChange, before + slice.count);
        found.values.tail(slice.count) = values;
        found.vectors.rightCols(slice.count) = pairs.vectors(Eigen::all, inside);
        return;
    }
    throw base::NumericalError("the " + std::to_string(slice.count) + " factors between " +
                               base::format_number(slice.lower) + " and " + base::format_number(slice.upper) +
                               " times the load do not settle");
}

void SubspaceIteration::factorize_shifted(double shift) {
    std::vector<double> values(stiffness_.size());
    std::ranges::transform(stiffness_, operand_, values.begin(),
                           [shift](double k, double a) { return k - shift * a; });
    outcome_ = factors_.factorize(values, control_);
}

MatrixXd SubspaceIteration::times(std::span<const double> matrix, const MatrixXd& vectors) const {
    MatrixXd result(vectors.rows(), vectors.cols());
    for (Eigen::Index i = 0; i < vectors.cols(); ++i) {
        control_.check();
        VectorXd product = VectorXd::Zero(vectors.rows());
        sparse::add_product(layout_, matrix, vectors.col(i), product);
        result.col(i) = product;
    }
    return result;
}

SubspaceIteration::Pairs SubspaceIteration::step(const MatrixXd& basis, double shift) {
    task_.update(std::min<std::size_t>(++iterations_, kMostIterations));
    MatrixXd image = times(operand_, basis);
    factors_.solve(image, control_);
    return project(std::move(image), shift);
}

/// The best approximations in the span of `vectors` (Rayleigh-Ritz), in the order of their growth. If the
/// operand has a low rank, so has the span, and there are fewer approximations; none if the operand vanishes.
SubspaceIteration::Pairs SubspaceIteration::project(MatrixXd vectors, double shift) const {
    const VectorXd sizes = vectors.cwiseAbs().colwise().maxCoeff().cwiseMax(kNothing);
    vectors *= sizes.cwiseInverse().asDiagonal();
    MatrixXd images = times(stiffness_, vectors);
    const VectorXd energies = vectors.cwiseProduct(images).colwise().sum();
    if (!(energies.array() >= 0.0).all())
        throw base::NumericalError(
            "the structure, as held, can move almost without strain: hold it more, or release less of its "
            "beams");
    const VectorXd scale = energies.cwiseMax(kNothing).cwiseSqrt().cwiseInverse();
    vectors *= scale.asDiagonal();
    images *= scale.asDiagonal();
    control_.check();
    const geometry::SymmetricEigen span = geometry::symmetric_eigen(vectors.transpose() * images);
    const Eigen::Index rank = (span.values.array() > kDependent).count();
    // Eigen does not accept matrices without rows.
    if (rank == 0) return {VectorXd(0), MatrixXd(vectors.rows(), 0)};
    control_.check();
    const MatrixXd basis = vectors * span.vectors.rightCols(rank) *
                           span.values.tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
    const geometry::SymmetricEigen solver =
        geometry::symmetric_eigen(basis.transpose() * times(operand_, basis));
    const VectorXd& values = solver.values;
    std::vector<Eigen::Index> order(rank);
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    const auto growth = [&](Eigen::Index i) { return std::abs(values[i] / (1.0 - shift * values[i])); };
    std::ranges::stable_sort(order, [&](auto a, auto b) { return growth(a) > growth(b); });
    return {values(order), basis * solver.vectors(Eigen::all, order)};
}

}  // namespace fretwork::mechanics::structure
