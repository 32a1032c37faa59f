// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace fretwork::mechanics {
namespace THIS_TEST {

/// Stiff along its axis: an axial strain would not matter, but its rounding would.
Frame cantilever(int divisions, const Section& section) {
    Frame frame;
    frame.nodes = {{0, 0, 0}, {1, 0, 0}};
    frame.beams.push_back({.nodes = {NodeIndex(0), NodeIndex(1)},
                           .section = section,
                           .material = {.young_modulus = 1e9, .poisson_ratio = 0.0},
                           .divisions = divisions});
    frame.supports.push_back({NodeIndex(0), DofSet::all()});
    return frame;
}

Eigen::VectorXd tip(const Frame& frame) {
    const double factors[] = {0.25, 0.5, 0.75, 1.0};
    const auto path = follow_load_path(assemble(frame), factors, {.relative_residual = 1e-11});
    EXPECT_TRUE(path.back().converged());
    return path.back().displacements.row(1).transpose();
}

/// The exponents p of an error ~ (1 / divisions)^p, from one doubling to the next, against 64 divisions.
std::vector<double> orders(const NodalLoad& load, const Section& section) {
    const auto solve = [&](int divisions) {
        Frame frame = cantilever(divisions, section);
        frame.loads.push_back(load);
        return tip(frame);
    };
    const Eigen::VectorXd reference = solve(64);
    std::vector<double> errors;
    for (const int divisions : {2, 4, 8}) errors.push_back((solve(divisions) - reference).norm());
    return {std::log2(errors[0] / errors[1]), std::log2(errors[1] / errors[2])};
}

constexpr Section kSquare{.area = 1e-4, .I2 = 1e-9, .I3 = 1e-9, .J = 1.7e-9};
constexpr Section kFlat{.area = 1e-4, .I2 = 1e-9, .I3 = 4e-9, .J = 3e-9};

// Without the strains' products of twist and bending the order would be two as soon as a path leaves a plane.
TEST(BeamConvergence, IsFourthOrderInAPlane) {
    for (const double order : orders({NodeIndex(1), {0.0, 0.0, 4.0}}, kSquare)) EXPECT_GT(order, 3.7);
}

TEST(BeamConvergence, IsFourthOrderInSpaceForEqualBendingStiffnesses) {
    for (const double order : orders({NodeIndex(1), {0.0, 1.5, 2.0}, {0.8, 0.3, 0.2}}, kSquare))
        EXPECT_GT(order, 3.4);
}

// Where the bending stiffnesses differ, bending in two planes makes the torque vary along a beam, and the
// element's is constant.
TEST(BeamConvergence, IsSecondOrderInSpaceForUnequalBendingStiffnesses) {
    Section sheared = kFlat;
    sheared.shear_area2 = 1e-6;
    sheared.shear_area3 = 2e-6;
    for (const Section& section : {kFlat, sheared}) {
        for (const double order : orders({NodeIndex(1), {0.0, 1.5, 2.0}, {0.8, 0.3, 0.2}}, section))
            EXPECT_GT(order, 1.9);
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
