// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/mechanics/nonlinear/nonlinear_system.hpp>

#include <gtest/gtest.h>

namespace fretwork::mechanics::nonlinear {
namespace THIS_TEST {

constexpr double kLength = 0.02;

/// A wheel that exercises every kind of node: clamped, partly held in rotation, freely turning under a
/// moment, prescribed displacements and rotations, a hinge.
Frame varied_wheel() {
    Frame frame = sample::flat_wheel();
    frame.supports.push_back({NodeIndex(2), {{true, false, true, true, false, true}}});
    frame.supports.push_back({NodeIndex(7), {{false, false, false, false, true, false}}});
    frame.prescribed.push_back({NodeIndex(3), Dof::uy, 0.004});
    frame.prescribed.push_back({NodeIndex(4), Dof::rx, 0.8});
    frame.prescribed.push_back({NodeIndex(4), Dof::rz, -0.5});
    for (const int node : {4, 5, 7, 8})
        frame.loads.push_back({NodeIndex(node), {0.3, 0.1, -0.4}, {0.01, -0.02, 0.015}});
    frame.beams[5].releases = {{1, {{false, false, false, false, true, true}}}};
    return frame;
}

Configuration random_configuration(const NonlinearSystem& system, double load_factor) {
    sample::Random random(21);
    Configuration configuration = system.unknowns().rest();
    system.unknowns().prescribe(load_factor, configuration);
    for (int pass = 0; pass < 3; ++pass) {
        Eigen::VectorXd step(system.unknowns().equations());
        for (double& value : step) value = 0.5 * random.next();
        NodeValues table = NodeValues::Zero(
            static_cast<Eigen::Index>(system.unknowns().assembly().nodes.size()), kDofsPerNode);
        system.unknowns().layout().scatter(step, table);
        table.leftCols<3>() *= 0.2 * kLength;
        system.unknowns().layout().gather(table, step);
        system.unknowns().move(step, configuration);
    }
    return configuration;
}

Eigen::MatrixXd whole_tangent(const NonlinearSystem& system) {
    const int size = system.unknowns().equations();
    Eigen::MatrixXd tangent(size, size);
    for (int i = 0; i < size; ++i) {
        const Eigen::VectorXd unit = Eigen::VectorXd::Unit(size, i);
        Eigen::VectorXd column = system.skew_product(unit);
        sparse::add_product(system.unknowns().layout(), system.tangent(), unit, column);
        tangent.col(i) = column;
    }
    return tangent;
}

/// At an equilibrium of these forces, where the parts that are left out by choice vanish.
TEST(NonlinearSystem, TangentIsTheDerivativeOfTheUnbalancedForces) {
    Assembly assembly = assemble(varied_wheel());
    NonlinearSystem first(assembly);
    const Configuration configuration = random_configuration(first, 1.0);
    // Loads that hold this configuration: then the residual vanishes at freely turning nodes.
    first.evaluate(configuration, 0.0);
    NodeValues holding = NodeValues::Zero(assembly.loads.rows(), kDofsPerNode);
    first.unknowns().layout().scatter(-first.unbalanced(), holding);
    for (Eigen::Index node = 0; node < holding.rows(); ++node) {
        const bool free = first.unknowns().layout().equation(static_cast<int>(node), 3) >= 0 &&
                          first.unknowns().layout().equation(static_cast<int>(node), 4) >= 0 &&
                          first.unknowns().layout().equation(static_cast<int>(node), 5) >= 0;
        if (free) assembly.loads.row(node) = holding.row(node);
    }
    NonlinearSystem system(assembly);
    system.evaluate(configuration, 1.0);
    const Eigen::MatrixXd tangent = whole_tangent(system);
    Eigen::MatrixXd difference(tangent.rows(), tangent.cols());
    constexpr double kStep = 1e-6;
    for (int i = 0; i < system.unknowns().equations(); ++i) {
        const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(system.unknowns().equations(), i);
        Configuration moved = configuration;
        system.unknowns().move(step, moved);
        system.evaluate(moved, 1.0);
        const Eigen::VectorXd plus = system.unbalanced();
        moved = configuration;
        system.unknowns().move(-step, moved);
        system.evaluate(moved, 1.0);
        difference.col(i) = (system.unbalanced() - plus) / (2.0 * kStep);
    }
    for (int i = 0; i < system.unknowns().equations(); ++i)
        EXPECT_LT((tangent.col(i) - difference.col(i)).norm(), 3e-6 * difference.col(i).norm()) << i;
}

TEST(NonlinearSystem, LoadRateIsTheDerivativeInTheLoadFactor) {
    const Assembly assembly = assemble(varied_wheel());
    NonlinearSystem system(assembly);
    const Configuration configuration = random_configuration(system, 1.0);
    system.evaluate(configuration, 1.0);
    const Eigen::VectorXd rate = system.load_rate();
    constexpr double kStep = 1e-6;
    Configuration moved = configuration;
    system.unknowns().prescribe(1.0 + kStep, moved);
    system.evaluate(moved, 1.0 + kStep);
    const Eigen::VectorXd plus = system.unbalanced();
    system.unknowns().prescribe(1.0 - kStep, moved);
    system.evaluate(moved, 1.0 - kStep);
    const Eigen::VectorXd difference = (plus - system.unbalanced()) / (2.0 * kStep);
    EXPECT_LT((rate - difference).norm(), 1e-6 * difference.norm());
}

TEST(NonlinearSystem, StepBetweenUndoesAMove) {
    const Assembly assembly = assemble(varied_wheel());
    const NonlinearSystem system(assembly);
    const Configuration from = random_configuration(system, 1.0);
    Eigen::VectorXd step(system.unknowns().equations());
    sample::Random random(22);
    for (double& value : step) value = 0.3 * random.next();
    Configuration to = from;
    system.unknowns().move(step, to);
    EXPECT_LT((system.unknowns().step_between(from, to) - step).norm(), 1e-13);
}

TEST(NonlinearSystem, RatesOfStepsAgreeWithFiniteDifferences) {
    const Assembly assembly = assemble(varied_wheel());
    const NonlinearSystem system(assembly);
    const Configuration base = system.unknowns().rest();
    const Configuration far = random_configuration(system, 0.0);
    sample::Random random(4);
    Eigen::VectorXd rate(system.unknowns().equations());
    for (double& value : rate) value = random.next();
    constexpr double kStep = 1e-6;
    Configuration before = far;
    Configuration after = far;
    system.unknowns().move(-kStep * rate, before);
    system.unknowns().move(kStep * rate, after);
    const Eigen::VectorXd difference =
        (system.unknowns().step_between(base, after) - system.unknowns().step_between(base, before)) /
        (2.0 * kStep);
    EXPECT_LT((system.unknowns().rate_of_steps(system.unknowns().step_between(base, far), rate) - difference)
                  .norm(),
              1e-8);
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics::nonlinear
