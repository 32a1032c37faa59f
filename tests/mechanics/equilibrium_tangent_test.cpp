// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"
#include "stops.hpp"
#include "support.hpp"

#include <fretwork/mechanics/paths/equilibrium_solver.hpp>

#include <gtest/gtest.h>

#include <array>
#include <stop_token>

namespace fretwork::mechanics {
namespace THIS_TEST {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Far below the differences that are taken here.
EquilibriumOptions tight() {
    EquilibriumOptions options;
    options.relative_residual = 1e-12;
    return options;
}

/// Bent, with forces and moments on all of its right side, a partly held rotation and prescribed values of a
/// displacement and of rotations.
Assembly bent(std::uint64_t seed) {
    sample::Random random(seed);
    Assembly assembly = assemble(sample::honeycomb(9, 6));
    assembly.loads *= 15.0;
    for (int node = 0; node < 54; node += 5)
        assembly.loads.row(node).head<3>() += random.vector(2e-3).transpose();
    assembly.prescribed.push_back({NodeIndex(48), Dof::ry, 0.3 + 0.1 * random.next()});
    assembly.prescribed.push_back({NodeIndex(48), Dof::rx, 0.2});
    return assembly;
}

VectorXd random_gradient(const Assembly& assembly, std::uint64_t seed) {
    sample::Random random(seed);
    VectorXd gradient(std::ssize(assembly.nodes) * kDofsPerNode);
    for (Eigen::Index i = 0; i < gradient.size(); ++i) gradient[i] = random.next() * (i % 6 < 3 ? 1.0 : 0.01);
    return gradient;
}

double value(const VectorXd& gradient, const Assembly& assembly) {
    EquilibriumSolver solver(tight());
    const Solution solution = solver.solve(assembly);
    EXPECT_TRUE(solution.converged());
    VectorXd displacements = solution.displacements.transpose().reshaped();
    return gradient.head(displacements.size()).dot(displacements);
}

/// The derivative by differences of fourth order.
template <class Edit>
double difference(const VectorXd& gradient, const Assembly& assembly, double step, const Edit& edit) {
    const auto at = [&](double place) {
        Assembly edited = assembly;
        edit(edited, place * step);
        return value(gradient, edited);
    };
    return (8.0 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12.0 * step);
}

void expect_close(const std::vector<double>& found, const std::vector<double>& expected) {
    const Eigen::Map<const VectorXd> a(found.data(), std::ssize(found));
    const Eigen::Map<const VectorXd> b(expected.data(), std::ssize(expected));
    EXPECT_GE(a.dot(b) / (a.norm() * b.norm()), 0.999999);
    EXPECT_LE((a - b).norm(), 1e-6 * b.norm()) << a.transpose() << "\n" << b.transpose();
}

/// Moments of fixed direction make the tangent unsymmetric here.
TEST(EquilibriumTangent, AdjointMotionsAreDerivativesByForcesAndMoments) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Assembly assembly = bent(seed);
        const VectorXd gradient = random_gradient(assembly, seed + 10);
        EquilibriumSolver solver(tight());
        ASSERT_TRUE(solver.solve(assembly).converged());
        const MatrixXd motions = solver.tangent().adjoint_motions(gradient);
        std::vector<double> found;
        std::vector<double> expected;
        for (const int node : {2, 8, 17, 30, 44, 53}) {
            for (int d = 0; d < kDofsPerNode; ++d) {
                found.push_back(motions(kDofsPerNode * node + d, 0) * (d < 3 ? 1.0 : 100.0));
                expected.push_back(
                    difference(gradient, assembly, d < 3 ? 1e-4 : 1e-6,
                               [&](Assembly& edited, double change) { edited.loads(node, d) += change; }) *
                    (d < 3 ? 1.0 : 100.0));
            }
        }
        expect_close(found, expected);
    }
}

TEST(EquilibriumTangent, GivesTheDerivativesByHeldValues) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Assembly assembly = bent(seed);
        const VectorXd gradient = random_gradient(assembly, seed + 10);
        EquilibriumSolver solver(tight());
        ASSERT_TRUE(solver.solve(assembly).converged());
        const EquilibriumTangent tangent = solver.tangent();
        const MatrixXd held = tangent.by_held_values(gradient, tangent.adjoint_motions(gradient));
        std::vector<double> found;
        std::vector<double> expected;
        for (std::size_t i = 0; i < assembly.prescribed.size(); ++i) {
            const PrescribedDisplacement& entry = assembly.prescribed[i];
            const double unit = static_cast<int>(entry.dof) < 3 ? 1.0 : 0.01;  // beams are a centimetre long
            found.push_back(unit * held(kDofsPerNode * entry.node.value + static_cast<int>(entry.dof), 0));
            expected.push_back(unit *
                               difference(gradient, assembly, 3e-5, [i](Assembly& edited, double change) {
                                   edited.prescribed[i].value += change;
                               }));
        }
        // Clamped nodes, whose values are zero.
        for (const Dof dof : {Dof::ux, Dof::uz, Dof::ry, Dof::rz}) {
            const double unit = static_cast<int>(dof) < 3 ? 1.0 : 0.01;
            found.push_back(unit * held(kDofsPerNode * 9 + static_cast<int>(dof), 0));
            expected.push_back(unit *
                               difference(gradient, assembly, 3e-5, [dof](Assembly& edited, double change) {
                                   edited.prescribed.push_back({NodeIndex(9), dof, change});
                               }));
        }
        expect_close(found, expected);
    }
}

TEST(EquilibriumTangent, MotionsAndAdjointMotionsAreEachOthersTransposed) {
    const Assembly assembly = bent(4);
    EquilibriumSolver solver(tight());
    ASSERT_TRUE(solver.solve(assembly).converged());
    const EquilibriumTangent tangent = solver.tangent();
    const VectorXd gradient = random_gradient(assembly, 5);
    const VectorXd forces = random_gradient(assembly, 6);
    const double forward = gradient.dot(tangent.as_rotation_vectors(tangent.motions(forces)).col(0));
    const double backward = forces.dot(tangent.adjoint_motions(gradient).col(0));
    EXPECT_NEAR(forward, backward, 1e-9 * std::abs(forward));
}

TEST(EquilibriumTangent, MotionsOfHeldComponentsAreTheTransposedOfDerivativesByTheirValues) {
    const Assembly assembly = bent(7);
    EquilibriumSolver solver(tight());
    ASSERT_TRUE(solver.solve(assembly).converged());
    const EquilibriumTangent tangent = solver.tangent();
    const VectorXd gradient = random_gradient(assembly, 5);
    const VectorXd values = random_gradient(assembly, 6);
    const double forward = gradient.dot(tangent.as_rotation_vectors(tangent.motions_of_held(values)).col(0));
    const double backward =
        values.dot(tangent.by_held_values(gradient, tangent.adjoint_motions(gradient)).col(0));
    EXPECT_NEAR(forward, backward, 1e-9 * std::abs(forward));
}

/// Without moments on free nodes the tangent is its symmetric part.
TEST(EquilibriumTangent, FlexibilitiesAreBlocksOfItsInverse) {
    Assembly assembly = bent(5);
    assembly.loads.rightCols<3>().setZero();
    EquilibriumSolver solver(tight());
    ASSERT_TRUE(solver.solve(assembly).converged());
    const EquilibriumTangent tangent = solver.tangent();
    const std::vector<std::size_t> elements = {0, 7, 20, 33, assembly.elements.size() - 1};
    const auto blocks = tangent.flexibilities(elements);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const auto nodes = assembly.elements[elements[i]]->nodes();
        for (Eigen::Index column = 0; column < 12; ++column) {
            VectorXd force = VectorXd::Zero(std::ssize(assembly.nodes) * kDofsPerNode);
            force[kDofsPerNode * nodes[static_cast<std::size_t>(column / 6)].value + column % 6] = 1.0;
            const MatrixXd motions = tangent.motions(force);
            for (Eigen::Index row = 0; row < 12; ++row)
                EXPECT_NEAR(
                    blocks[i](row, column),
                    motions(kDofsPerNode * nodes[static_cast<std::size_t>(row / 6)].value + row % 6, 0),
                    1e-9 * blocks[i].cwiseAbs().maxCoeff());
        }
    }
}

/// The next solution goes on from the equilibrium as if nothing had been asked.
TEST(EquilibriumTangent, LeavesTheSolverAsItWas) {
    Assembly assembly = bent(6);
    EquilibriumSolver asked;
    EquilibriumSolver silent;
    (void)asked.solve(assembly);
    (void)silent.solve(assembly);
    const std::vector<std::size_t> elements = {0, 1};
    (void)asked.tangent().flexibilities(elements);
    assembly.loads *= 1.02;
    const Solution a = asked.solve(assembly);
    const Solution b = silent.solve(assembly);
    EXPECT_EQ(asked.starting_point(), StartingPoint::LastEquilibrium);
    EXPECT_LT((a.displacements - b.displacements).norm(), 1e-7 * b.displacements.norm());
}

/// The control of the call that has made the tangent may be gone, or asked to stop, by then.
TEST(EquilibriumTangent, ListensToTheControlOfEachCallOnly) {
    const Assembly assembly = bent(8);  // with moments, for which solutions are iterated
    const MatrixXd force = MatrixXd::Ones(std::ssize(assembly.nodes) * kDofsPerNode, 1);
    const std::vector<std::size_t> elements = {0, 1};
    EquilibriumSolver solver(tight());
    ASSERT_TRUE(solver.solve(assembly).converged());
    std::stop_source done;
    const EquilibriumTangent tangent = solver.tangent({.stop = done.get_token()});
    done.request_stop();
    EXPECT_NO_THROW((void)tangent.motions(force));
    EXPECT_NO_THROW((void)tangent.flexibilities(elements));
}

TEST(EquilibriumTangent, IsRefusedWithoutAnEquilibrium) {
    EquilibriumSolver solver;
    EXPECT_THAT(test::complaint_of([&] { (void)solver.tangent(); }), testing::HasSubstr("has not converged"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
