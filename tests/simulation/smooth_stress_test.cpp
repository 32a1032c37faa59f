// SPDX-License-Identifier: GPL-3.0-or-later
// Energy and stress as functions of what the equilibrium depends on, linear and nonlinear.
#include "honeycomb.hpp"
#include "support.hpp"

#include <fretwork/simulation/derivatives/sensitivity.hpp>
#include <fretwork/simulation/derivatives/smooth_stress.hpp>
#include <fretwork/simulation/results/beam_table.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace fretwork::simulation {
namespace THIS_TEST {

using mechanics::NodeValues;
using test::complaint_of;

const std::vector<std::string> kModels = {"condensed", "corotational"};

Surface sample_surface() {
    return make_surface(test::honeycomb(5, 4, {"0-1+1-6", "0-6", "0-1+1-5+1-6+5-6"}), nullptr);
}

/// Held, loaded, weighed and pushed, with a rotation that is partly held.
LoadCase bending() {
    LoadCase load_case = test::cantilever({0.01, 0.004, 0.04});
    load_case.loads.push_back({NodesAtSide{Side::Top}, {0, 0, 0.002}, {1e-5, 2e-5, 1e-5}});
    load_case.prescribed.push_back({NodesAtSide{Side::Bottom}, mechanics::Dof::uz, 0.003});
    load_case.prescribed.push_back({NodesById{{30}}, mechanics::Dof::ry, 0.1});
    load_case.gravity = {0.0, 1.0, -9.0};
    return load_case;
}

/// A function of a surface, its gradient by displacements, and what it adds to the derivatives.
struct Quantity {
    std::function<double(const Session&, const SurfaceResult&)> value;
    std::function<NodeValues(const Session&, const SurfaceResult&)> gradient;
    std::function<Sensitivity(const SurfaceResult&, const Sensitivity&)> adapted;
    std::function<double(const Session&, const SurfaceResult&, const SettingCurve&)> at_rest;
};

Quantity weighted_displacements() {
    const auto weights = [](Eigen::Index rows) {
        NodeValues gradient(rows, 6);
        for (Eigen::Index i = 0; i < gradient.size(); ++i)
            gradient.data()[i] = std::sin(1.7 * static_cast<double>(i)) * (i % 6 < 3 ? 1.0 : 0.01);
        return gradient;
    };
    return {[weights](const Session&, const SurfaceResult& result) {
                const NodeValues& rows = result.solution.displacements;
                return weights(rows.rows()).cwiseProduct(rows).sum();
            },
            [weights](const Session&, const SurfaceResult& result) {
                return weights(result.solution.displacements.rows());
            },
            [](const SurfaceResult&, const Sensitivity& by) { return by; },
            [](const Session&, const SurfaceResult&, const SettingCurve&) { return 0.0; }};
}

Quantity energy() {
    return {[](const Session&, const SurfaceResult& result) { return result.solution.energy; },
            [](const Session& session, const SurfaceResult& result) {
                return session.energy_gradient(result.solution);
            },
            [](const SurfaceResult& result, const Sensitivity& by) {
                return with_energy(by, 1.0, result.solution.energy);
            },
            [](const Session&, const SurfaceResult&, const SettingCurve&) { return 0.0; }};
}

Quantity stress() {
    return {[](const Session& session, const SurfaceResult& result) {
                return smooth_stress(session, result.solution).value;
            },
            [](const Session& session, const SurfaceResult& result) {
                return smooth_stress(session, result.solution).gradient;
            },
            [](const SurfaceResult&, const Sensitivity& by) { return by; },
            [](const Session& session, const SurfaceResult& result, const SettingCurve& curve) {
                return smooth_stress_along(session, result, curve);
            }};
}

/// From rest, so that no difference depends on the way.
double value_of(const Quantity& quantity, const Surface& surface, const LoadCase& load_case,
                const std::string& model) {
    Session session(surface, load_case, {.model = model, .threads = 1});
    const SurfaceResult result = session.solve();
    EXPECT_TRUE(result.solution.converged());
    return quantity.value(session, result);
}

double difference(double step, const std::function<double(double)>& value) {
    return (8.0 * (value(step) - value(-step)) - (value(2 * step) - value(-2 * step))) / (12.0 * step);
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected) {
    const Eigen::Map<const Eigen::VectorXd> a(found.data(), std::ssize(found));
    const Eigen::Map<const Eigen::VectorXd> b(expected.data(), std::ssize(expected));
    EXPECT_LE((a - b).norm(), 1e-6 * b.norm()) << a.transpose() << "\n" << b.transpose();
}

reduction::Setting with_modulus(const reduction::Setting& setting, double step) {
    reduction::Setting edited = setting;
    edited.material.young_modulus *= 1.0 + step;
    return edited;
}

reduction::Setting with_thickness(const reduction::Setting& setting, double step) {
    reduction::Setting edited = setting;
    edited.section = mechanics::rectangle_section(0.002, 0.002 * (1.0 + step));
    return edited;
}

class Derivatives : public testing::TestWithParam<std::string> {
  protected:
    /// Solves, and takes the derivatives of a quantity.
    Sensitivity derivatives(const Quantity& quantity) {
        result_ = session_.solve();
        return quantity.adapted(result_, session_.sensitivity(quantity.gradient(session_, result_)));
    }

    [[nodiscard]] double by_load(const Quantity& quantity, int node, int dof, double step) const {
        const double unit = dof < 3 ? 0.005 : 1e-4;
        return difference(step,
                          [&](double share) {
                              LoadCase edited = load_case_;
                              LoadCase::Load load{NodesById{{node}}};
                              (dof < 3 ? load.force[dof] : load.moment[dof - 3]) = unit * share;
                              edited.loads.push_back(load);
                              return value_of(quantity, surface_, edited, GetParam());
                          }) /
               unit;
    }

    [[nodiscard]] double by_prescribed(const Quantity& quantity, std::size_t entry, double step) const {
        return difference(step, [&](double change) {
            LoadCase edited = load_case_;
            edited.prescribed[entry].value += change;
            return value_of(quantity, surface_, edited, GetParam());
        });
    }

    void expect_loads_and_held_values(const Quantity& quantity) {
        const Sensitivity by = derivatives(quantity);
        std::vector<double> found;
        std::vector<double> expected;
        for (const int node : {12, 40}) {
            for (const int dof : {0, 2, 4}) {
                const double unit = dof < 3 ? 1.0 : 0.02;  // so that all are of one size
                found.push_back(unit * by.loads(node, dof));
                expected.push_back(unit * by_load(quantity, node, dof, 0.02));
            }
        }
        expect_near(found, expected);
        for (std::size_t entry = 0; entry < load_case_.prescribed.size(); ++entry) {
            const auto& own = load_case_.prescribed[entry];
            double sum = 0.0;
            for (const auto node : select_nodes(own.where, surface_.tessellation))
                sum += by.held_values(node.value, static_cast<int>(own.dof));
            expect_near({sum}, {by_prescribed(quantity, entry, entry == 0 ? 5e-5 : 2e-3)});
        }
    }

    void expect_settings(const Quantity& quantity) {
        const Sensitivity by = derivatives(quantity);
        for (const auto change : {with_modulus, with_thickness}) {
            const SettingCurve curve{[&](double step) { return change(surface_.setting, step); }, 1e-3};
            const double found = derivative_along(by, surface_, curve.setting, curve.step) +
                                 quantity.at_rest(session_, result_, curve);
            expect_near({found}, {difference(1e-3, [&](double step) {
                            Surface edited = surface_;
                            edited.setting = curve.setting(step);
                            return value_of(quantity, edited, load_case_, GetParam());
                        })});
        }
    }

    Surface surface_ = sample_surface();
    LoadCase load_case_ = bending();
    Session session_{surface_, load_case_, {.model = GetParam(), .threads = 1}};
    SurfaceResult result_;
};

TEST_P(Derivatives, OfDisplacementsByLoadsAndHeldValues) {
    expect_loads_and_held_values(weighted_displacements());
}
TEST_P(Derivatives, OfDisplacementsBySettings) {
    expect_settings(weighted_displacements());
}
TEST_P(Derivatives, OfEnergyByLoadsAndHeldValues) {
    expect_loads_and_held_values(energy());
}
TEST_P(Derivatives, OfEnergyBySettings) {
    expect_settings(energy());
}
TEST_P(Derivatives, OfSmoothStressByLoadsAndHeldValues) {
    expect_loads_and_held_values(stress());
}
TEST_P(Derivatives, OfSmoothStressBySettings) {
    expect_settings(stress());
}

/// With a factor on all stiffnesses, which is what another modulus is: energies of tiles add up.
TEST_P(Derivatives, OfEnergyByAFactorAreThoseByTheModulus) {
    const Sensitivity by = derivatives(energy());
    const auto modulus = [&](double step) { return with_modulus(surface_.setting, step); };
    EXPECT_NEAR(derivative_along(by, surface_, modulus, 1e-2), by.stiffness, 1e-6 * std::abs(by.stiffness));
    double sum = 0.0;
    for (const TileSensitivity& tile : by.tiles) sum += tile.energy;
    EXPECT_NEAR(sum, result_.solution.energy, 1e-6 * result_.solution.energy);
}

TEST_P(Derivatives, OfTheOwnPatternVanish) {
    const Sensitivity by = derivatives(weighted_displacements());
    const CandidateTiles candidates(surface_, surface_.tessellation.patterns);
    const Eigen::MatrixXd weights = pattern_derivatives(by, candidates);
    for (const tiling::TileIndex tile : surface_.tessellation.tiles.indices())
        EXPECT_NEAR(weights(tile.value, surface_.tessellation.tiles[tile].pattern), 0.0,
                    1e-7 * weights.row(tile.value).cwiseAbs().maxCoeff());
}

TEST_P(Derivatives, SmoothStressIsAboveTheLargestAndComesNearWithTheExponent) {
    result_ = session_.solve();
    const double largest =
        most_stressed(beam_table(session_, result_.solution), 1).front().largest_von_mises();
    double before = std::numeric_limits<double>::infinity();
    for (const double exponent : {4.0, 32.0, 256.0}) {
        const SmoothStress found = smooth_stress(session_, result_.solution, {.exponent = exponent});
        EXPECT_DOUBLE_EQ(found.largest, largest);
        EXPECT_GE(found.value, largest);
        EXPECT_LT(found.value, before);
        before = found.value;
    }
    EXPECT_LT(before, 1.05 * largest);
}

INSTANTIATE_TEST_SUITE_P(Models, Derivatives, testing::ValuesIn(kModels),
                         [](const auto& given) { return given.param; });

TEST(SmoothStress, DoesNotDependOnTheNumberOfThreads) {
    Session session(sample_surface(), bending(), {.model = "corotational", .threads = 1});
    const SurfaceResult result = session.solve();
    const SmoothStress one = smooth_stress(session, result.solution, {.threads = 1});
    const SmoothStress four = smooth_stress(session, result.solution, {.threads = 4});
    EXPECT_EQ(one.value, four.value);
    EXPECT_EQ((one.gradient - four.gradient).cwiseAbs().maxCoeff(), 0.0);
}

TEST(SmoothStress, RefusesModelsWhoseStressHasNoDerivative) {
    Session full(sample_surface(), bending(), {.model = "full", .threads = 1});
    const SurfaceResult result = full.solve();
    EXPECT_THAT(complaint_of([&] { (void)smooth_stress(full, result.solution); }),
                testing::HasSubstr("condensed and corotational"));
    EXPECT_THAT(complaint_of([&] { (void)smooth_stress(full, result.solution, {.exponent = 1.0}); }),
                testing::HasSubstr("exponent"));
}

TEST(SmoothStress, OfARestingSurfaceIsZero) {
    LoadCase resting = test::cantilever({0, 0, 0});
    Session session(sample_surface(), resting, {.model = "condensed", .threads = 1});
    const SmoothStress found = smooth_stress(session, session.solve().solution);
    EXPECT_EQ(found.value, 0.0);
    EXPECT_EQ(found.gradient.norm(), 0.0);
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
