// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/detail/constraints.hpp>
#include <fretwork/mechanics/detail/newton.hpp>
#include <fretwork/mechanics/modes.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::mechanics {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostIterations = 500;
constexpr double kTolerance = 1e-11;

void require_definite(const detail::NonlinearSystem& system, const detail::Ldlt::Outcome& outcome) {
    if (outcome.positive_definite()) return;
    throw base::NumericalError(
        "the structure, as held, can move without strain at " +
        detail::node_text(system.assembly(), system.layout().node_of(std::max(outcome.zero_pivot, 0))));
}

/// The eigenvalues of A x = mu K x of largest size, with their vectors, by subspace iteration with K's
/// factor.
class SubspaceIteration {
  public:
    struct Pairs {
        VectorXd values;
        MatrixXd vectors;
    };

    SubspaceIteration(detail::NonlinearSystem& rest_system, std::vector<double> operand)
        : layout_(rest_system.layout()),
          stiffness_(rest_system.tangent().begin(), rest_system.tangent().end()),
          operand_(std::move(operand)),
          factors_(layout_) {
        require_definite(rest_system, factors_.factorize(stiffness_));
    }

    Pairs run(int count) {
        const int size = std::min(layout_.equations(), std::max(2 * count, count + 8));
        MatrixXd basis = start_vectors(size);
        VectorXd last = VectorXd::Zero(size);
        Pairs pairs;
        for (int iteration = 0; iteration < kMostIterations; ++iteration) {
            MatrixXd image = times(operand_, basis);
            factors_.solve(image);
            pairs = project(image);
            basis = pairs.vectors;
            const int wanted = std::min(count, size);
            const VectorXd change = (pairs.values - last).head(wanted).cwiseAbs();
            if (change.maxCoeff() <= kTolerance * pairs.values.cwiseAbs().maxCoeff()) break;
            last = pairs.values;
        }
        return pairs;
    }

  private:
    /// Numbers without pattern, the same on every system.
    [[nodiscard]] MatrixXd start_vectors(int size) const {
        MatrixXd start(layout_.equations(), size);
        std::uint64_t state = 1;
        for (double& entry : start.reshaped()) {
            state = state * 6364136223846793005ULL + 1442695040888963407ULL;
            entry = static_cast<double>(state >> 11) * 0x1.0p-52 - 1.0;
        }
        return start;
    }

    [[nodiscard]] MatrixXd times(const std::vector<double>& matrix, const MatrixXd& vectors) const {
        MatrixXd result(vectors.rows(), vectors.cols());
        for (Eigen::Index i = 0; i < vectors.cols(); ++i) {
            VectorXd product = VectorXd::Zero(vectors.rows());
            detail::add_product(layout_, matrix, vectors.col(i), product);
            result.col(i) = product;
        }
        return result;
    }

    /// Rayleigh and Ritz: the best approximations in the span of `vectors`, largest size first.
    [[nodiscard]] Pairs project(MatrixXd vectors) const {
        for (Eigen::Index i = 0; i < vectors.cols(); ++i)
            vectors.col(i) /= vectors.col(i).cwiseAbs().maxCoeff();
        const MatrixXd small_stiffness = vectors.transpose() * times(stiffness_, vectors);
        const MatrixXd small_operand = vectors.transpose() * times(operand_, vectors);
        const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(small_operand, small_stiffness);
        std::vector<Eigen::Index> order(static_cast<std::size_t>(vectors.cols()));
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Eigen::Index>(i);
        const VectorXd& values = solver.eigenvalues();
        std::sort(order.begin(), order.end(),
                  [&](auto a, auto b) { return std::abs(values[a]) > std::abs(values[b]); });
        Pairs pairs{VectorXd(values.size()), MatrixXd(vectors.rows(), vectors.cols())};
        for (std::size_t i = 0; i < order.size(); ++i) {
            pairs.values[static_cast<Eigen::Index>(i)] = values[order[i]];
            pairs.vectors.col(static_cast<Eigen::Index>(i)) = vectors * solver.eigenvectors().col(order[i]);
        }
        return pairs;
    }

    const detail::SystemLayout& layout_;
    std::vector<double> stiffness_;
    std::vector<double> operand_;
    detail::Ldlt factors_;
};

Mode make_mode(const detail::NonlinearSystem& system, double value, const VectorXd& vector) {
    NodeValues table =
        NodeValues::Zero(static_cast<Eigen::Index>(system.assembly().nodes.size()), kDofsPerNode);
    system.layout().scatter(vector, table);
    NodeValues shape = table.topRows(system.assembly().reported_nodes);
    Eigen::Index row = 0;
    Eigen::Index column = 0;
    const double largest = shape.leftCols<3>().cwiseAbs().maxCoeff(&row, &column);
    if (largest > 0.0) shape /= shape(row, column);
    return {value, std::move(shape)};
}

void check_count(int count) {
    if (count < 1)
        throw base::InputError("the number of modes is " + std::to_string(count) +
                               ", and must be above zero");
}

std::vector<double> mass_values(const detail::NonlinearSystem& system) {
    std::vector<double> values(system.layout().row().size(), 0.0);
    MatrixXd mass;
    const Assembly& assembly = system.assembly();
    for (std::size_t e = 0; e < assembly.elements.size(); ++e) {
        assembly.elements[e]->mass(mass);
        system.layout().add(e, assembly.elements[e]->nodes(), mass, values);
    }
    if (std::all_of(values.begin(), values.end(), [](double value) { return value == 0.0; }))
        throw base::InputError("the structure has no mass to vibrate: give its materials a density");
    return values;
}

/// Minus the geometric stiffness of the linear solution.
std::vector<double> softening(const detail::NonlinearSystem& system, const VectorXd& linear_rate) {
    const Assembly& assembly = system.assembly();
    NodeValues table = detail::constraints_of(assembly).values;
    system.layout().scatter(linear_rate, table);
    std::vector<double> values(system.layout().row().size(), 0.0);
    MatrixXd stiffness;
    for (std::size_t e = 0; e < assembly.elements.size(); ++e) {
        const auto nodes = assembly.elements[e]->nodes();
        VectorXd displacements(static_cast<Eigen::Index>(nodes.size()) * kDofsPerNode);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            displacements.segment<kDofsPerNode>(static_cast<Eigen::Index>(i) * kDofsPerNode) =
                table.row(nodes[i].value).transpose();
        assembly.elements[e]->geometric_stiffness(displacements, stiffness);
        stiffness = -stiffness;
        system.layout().add(e, nodes, stiffness, values);
    }
    return values;
}

}  // namespace

std::vector<Mode> vibration_modes(const Assembly& assembly, int count) {
    check_count(count);
    detail::NonlinearSystem system(assembly);
    system.evaluate(system.rest(), 0.0);
    const auto pairs = SubspaceIteration(system, mass_values(system)).run(count);
    std::vector<Mode> modes;
    for (Eigen::Index i = 0; i < std::min<Eigen::Index>(count, pairs.values.size()); ++i) {
        if (pairs.values[i] <= 0.0) break;
        const double frequency = 1.0 / (2.0 * std::numbers::pi * std::sqrt(pairs.values[i]));
        modes.push_back(make_mode(system, frequency, pairs.vectors.col(i)));
    }
    return modes;
}

std::vector<Mode> buckling_modes(const Assembly& assembly, int count) {
    check_count(count);
    detail::NonlinearSystem system(assembly);
    system.evaluate(system.rest(), 0.0);
    detail::Ldlt factors(system.layout());
    require_definite(system, factors.factorize(system.tangent()));
    VectorXd rate = system.load_rate();
    factors.solve(rate);
    const auto pairs = SubspaceIteration(system, softening(system, rate)).run(count);
    std::vector<Mode> modes;
    for (Eigen::Index i = 0; i < pairs.values.size() && static_cast<int>(modes.size()) < count; ++i) {
        // What is left of an unloaded structure's zeros are factors beyond all loads.
        if (pairs.values[i] > 1e-12)
            modes.push_back(make_mode(system, 1.0 / pairs.values[i], pairs.vectors.col(i)));
    }
    return modes;
}

}  // namespace fretwork::mechanics
