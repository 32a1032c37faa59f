// SPDX-License-Identifier: GPL-3.0-or-later
#include "honeycomb.hpp"
#include "support.hpp"

#include <fretwork/base/random.hpp>
#include <fretwork/mechanics/corotational_element.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>
#include <fretwork/reduction/models/corotational_tile.hpp>
#include <fretwork/simulation/derivatives/sensitivity.hpp>
#include <fretwork/simulation/session.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::simulation {
namespace THIS_TEST {

using mechanics::NodeValues;
using test::complaint_of;
using test::honeycomb;
using tiling::TileIndex;

const std::vector<std::string> kPatterns = {"0-1+1-6", "0-6", "0-1+1-5+1-6+5-6"};

std::vector<std::string> shuffled_patterns(std::uint64_t seed) {
    base::SplitMix64 random(seed);
    std::vector<std::string> patterns;
    for (int i = 0; i < 5; ++i) patterns.push_back(kPatterns[random.below(3)]);
    return patterns;
}

Surface sample_surface(std::uint64_t seed) {
    return make_surface(honeycomb(5, 4, shuffled_patterns(seed)), nullptr);
}

/// Bent by forces, a moment, its own weight and a pushed side, with a rotation that is partly held.
LoadCase bending(std::uint64_t seed) {
    base::SplitMix64 random(seed);
    LoadCase load_case =
        test::cantilever({0.02 * random.share(), 0.02 * random.share(), 0.03 + 0.03 * random.share()});
    load_case.loads.push_back({NodesAtSide{Side::Top}, {0, 0, 0.002}, {1e-5, 2e-5, 1e-5}});
    load_case.prescribed.push_back({NodesAtSide{Side::Bottom}, mechanics::Dof::uz, 0.004 * random.share()});
    load_case.prescribed.push_back({NodesById{{30}}, mechanics::Dof::ry, 0.2});
    load_case.gravity = {0.0, 1.0, -9.0};
    return load_case;
}

NodeValues random_gradient(Eigen::Index nodes, std::uint64_t seed) {
    base::SplitMix64 random(seed);
    NodeValues gradient(nodes, 6);
    for (double& entry : gradient.reshaped()) entry = random.share() - 0.5;
    gradient.rightCols<3>() *= 0.01;
    return gradient;
}

/// From rest, so that no difference depends on the way.
double value(const NodeValues& gradient, const Surface& surface, const LoadCase& load_case,
             const SimulationOptions& options) {
    const SurfaceResult result = simulate(surface, load_case, options);
    EXPECT_TRUE(result.solution.converged());
    return gradient.cwiseProduct(result.solution.displacements).sum();
}

/// By differences of fourth order.
template <class Value>
double difference(double step, const Value& value) {
    return (8.0 * (value(step) - value(-step)) - (value(2 * step) - value(-2 * step))) / (12.0 * step);
}

void expect_close(const std::vector<double>& found, const std::vector<double>& expected) {
    const Eigen::Map<const Eigen::VectorXd> a(found.data(), std::ssize(found));
    const Eigen::Map<const Eigen::VectorXd> b(expected.data(), std::ssize(expected));
    EXPECT_GE(a.dot(b) / (a.norm() * b.norm()), 0.999999);
    EXPECT_LE((a - b).norm(), 1e-6 * b.norm()) << a.transpose() << "\n" << b.transpose();
}

const SimulationOptions kCorotational = {.model = "corotational", .threads = 1};

TEST(Sensitivity, IsTheDerivativeByLoadsAndPrescribedValues) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Surface surface = sample_surface(seed);
        const LoadCase load_case = bending(seed);
        Session session(surface, load_case, kCorotational);
        const SurfaceResult result = session.solve();
        ASSERT_TRUE(result.solution.converged());
        const NodeValues gradient = random_gradient(result.solution.displacements.rows(), seed);
        const Sensitivity found = session.sensitivity(gradient);
        std::vector<double> derivatives;
        std::vector<double> differences;
        for (const int node : {12, 25, 40, 52}) {
            for (int d = 0; d < 6; ++d) {
                const double unit = d < 3 ? 0.01 : 1e-4;
                derivatives.push_back(unit * found.loads(node, d));
                differences.push_back(difference(0.05, [&](double step) {
                    LoadCase edited = load_case;
                    LoadCase::Load load{NodesById{{node}}};
                    (d < 3 ? load.force[d] : load.moment[d - 3]) = unit * step;
                    edited.loads.push_back(load);
                    return value(gradient, surface, edited, kCorotational);
                }));
            }
        }
        for (std::size_t entry = 0; entry < load_case.prescribed.size(); ++entry) {
            const auto& own = load_case.prescribed[entry];
            const double unit = static_cast<int>(own.dof) < 3 ? 0.01 : 0.3;
            double sum = 0.0;
            for (const auto node : select_nodes(own.where, surface.tessellation))
                sum += found.held_values(node.value, static_cast<int>(own.dof));
            derivatives.push_back(unit * sum);
            differences.push_back(difference(0.02, [&](double step) {
                LoadCase edited = load_case;
                edited.prescribed[entry].value += unit * step;
                return value(gradient, surface, edited, kCorotational);
            }));
        }
        expect_close(derivatives, differences);
    }
}

/// With the weight of the beams, which follows their section and density.
TEST(Sensitivity, IsTheDerivativeByMaterialAndSection) {
    for (const std::uint64_t seed : {1U, 2U}) {
        const Surface surface = sample_surface(seed);
        const LoadCase load_case = bending(seed);
        Session session(surface, load_case, kCorotational);
        const SurfaceResult result = session.solve();
        const NodeValues gradient = random_gradient(result.solution.displacements.rows(), seed);
        const Sensitivity found = session.sensitivity(gradient);
        const auto with = [&](const reduction::Setting& setting) {
            Surface edited = surface;
            edited.setting = setting;
            return value(gradient, edited, load_case, kCorotational);
        };
        const auto modulus = [&](double step) {
            reduction::Setting setting = surface.setting;
            setting.material.young_modulus *= 1.0 + step;
            return setting;
        };
        const auto density = [&](double step) {
            reduction::Setting setting = surface.setting;
            setting.material.density *= 1.0 + step;
            return setting;
        };
        const auto thickness = [&](double step) {
            reduction::Setting setting = surface.setting;
            setting.section = mechanics::rectangle_section(0.002, 0.002 * (1.0 + step));
            return setting;
        };
        const double by_modulus = derivative_along(found, surface, modulus, 1e-2);
        EXPECT_NEAR(by_modulus, found.stiffness, 1e-7 * std::abs(found.stiffness));
        double sum = 0.0;
        for (const TileSensitivity& tile : found.tiles) sum += tile.stiffness;
        EXPECT_NEAR(sum, found.stiffness, 1e-6 * std::abs(found.stiffness));
        expect_close({by_modulus, derivative_along(found, surface, density, 1e-2),
                      derivative_along(found, surface, thickness, 1e-2)},
                     {difference(0.01, [&](double step) { return with(modulus(step)); }),
                      difference(0.01, [&](double step) { return with(density(step)); }),
                      difference(0.01, [&](double step) { return with(thickness(step)); })});
    }
}

/// The tile's own pattern and this share of what another one has more.
reduction::TileModel blended(const pattern::Pattern& other, const double& share) {
    return {.name = "blended",
            .summary = "between two patterns",
            .displacements = reduction::Displacements::Large,
            .sharing = reduction::Sharing::Congruent,
            .build = [&other, &share](const reduction::TileInput& input) {
                const auto condensed = [&](const pattern::Fan& fan, std::vector<Eigen::Vector3d>* nodes) {
                    const auto frame = reduction::fan_frame(input.layout, fan, input.polygon, input.setting);
                    if (nodes != nullptr) nodes->assign(frame.nodes.begin(), frame.nodes.begin() + 6);
                    return reduction::condensed_frame(frame, fan.interface_node_count);
                };
                mechanics::CorotationalBody::Parts parts;
                parts.stiffness = (1.0 - share) * condensed(input.fan, &parts.nodes) +
                                  share * condensed(pattern::make_fan(input.layout, other, 6), nullptr);
                return reduction::corotational_tile(std::move(parts));
            }};
}

/// The derivative of every tile x pattern weight, on a random choice of them.
TEST(Sensitivity, IsTheDerivativeByPatternsOfTiles) {
    const std::vector<std::string> ids = {"0-6", "1-6+3-6", "0-1+1-6", "0-1+1-5+1-6+5-6"};
    for (const std::uint64_t seed : {1U, 2U}) {
        const Surface surface = sample_surface(seed);
        LoadCase load_case = bending(seed);
        load_case.gravity.setZero();  // the blended tile's weight would be its own pattern's
        Session session(surface, load_case, kCorotational);
        const SurfaceResult result = session.solve();
        const NodeValues gradient = random_gradient(result.solution.displacements.rows(), seed);
        const CandidateTiles candidates(surface, pattern::parse_named_patterns(surface.layout, ids));
        EXPECT_EQ(candidates.class_count(), 1U);
        const Eigen::MatrixXd weights = pattern_derivatives(session.sensitivity(gradient), candidates);
        std::vector<double> derivatives;
        std::vector<double> differences;
        base::SplitMix64 random(seed);
        for (int i = 0; i < 12; ++i) {
            const auto tile = static_cast<std::size_t>(random.below(20));
            const std::size_t pattern = random.below(ids.size());
            double share = 0.0;
            std::vector<reduction::TileModel> models = reduction::tile_models();
            models.push_back(blended(candidates.patterns()[pattern].pattern, share));
            Surface mixed = surface;
            mixed.tile_models.resize(20);
            mixed.tile_models[tile] = "blended";
            derivatives.push_back(
                weights(static_cast<Eigen::Index>(tile), static_cast<Eigen::Index>(pattern)));
            differences.push_back(difference(5e-4, [&](double step) {
                share = step;
                return value(gradient, mixed, load_case,
                             {.model = "corotational", .models = models, .threads = 1});
            }));
        }
        expect_close(derivatives, differences);
    }
}

TEST(Sensitivity, CountsTheWeightOfAnotherPattern) {
    const Surface surface = sample_surface(1);
    const LoadCase load_case = bending(1);
    Session session(surface, load_case, kCorotational);
    (void)session.solve();
    const NodeValues gradient = random_gradient(std::ssize(surface.tessellation.interface_nodes), 1);
    const Sensitivity found = session.sensitivity(gradient);
    const CandidateTiles candidates(surface, surface.tessellation.patterns);
    const Eigen::MatrixXd weights = pattern_derivatives(found, candidates);
    for (const TileIndex tile : surface.tessellation.tiles.indices()) {
        const auto own = surface.tessellation.tiles[tile].pattern;
        EXPECT_NEAR(weights(tile.value, own), 0.0, 1e-9 * weights.row(tile.value).cwiseAbs().maxCoeff())
            << "a tile's own pattern changes nothing";
        const auto masses = tile_masses(surface);
        EXPECT_NEAR(candidates.mass(candidates.class_of(tile), static_cast<std::size_t>(own)), masses[tile],
                    1e-9 * masses[tile]);
    }
}

TEST(Sensitivity, DoesNotDependOnTheNumberOfThreads) {
    const auto found = [](int threads) {
        Session session(sample_surface(1), bending(1), {.model = "corotational", .threads = threads});
        const auto rows = session.solve().solution.displacements.rows();
        return session.sensitivity(random_gradient(rows, 1)).loads;
    };
    EXPECT_EQ((found(1) - found(4)).cwiseAbs().maxCoeff(), 0.0);
}

TEST(Sensitivity, OfBeamsHasLoadsButNoTiles) {
    Session session(sample_surface(1), bending(1), {.model = "full", .threads = 1});
    const SurfaceResult result = session.solve();
    const Sensitivity found = session.sensitivity(random_gradient(result.solution.displacements.rows(), 1));
    EXPECT_TRUE(std::isnan(found.tiles.front().stiffness));
    EXPECT_GT(found.loads.norm(), 0.0);
}

TEST(Sensitivity, AsksForASolutionAfterTheLastEdit) {
    Session session(sample_surface(1), bending(1), kCorotational);
    const auto refused = testing::HasSubstr("after the last edit");
    EXPECT_THAT(complaint_of([&] { (void)session.linearize(); }), refused);
    const auto rows = session.solve().solution.displacements.rows();
    (void)session.linearize();
    EXPECT_THAT(complaint_of([&] { (void)session.sensitivity(NodeValues::Zero(rows - 1, 6)); }),
                testing::HasSubstr("one is needed for each"));
    session.paint(std::vector{TileIndex(3)}, "0-6");
    EXPECT_THAT(complaint_of([&] { (void)session.linearize(); }), refused);
    Session linear(sample_surface(1), bending(1), {.model = "condensed"});
    (void)linear.solve();
    EXPECT_THAT(complaint_of([&] { (void)linear.linearize(); }), testing::HasSubstr("large displacements"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
