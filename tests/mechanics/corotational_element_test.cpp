// SPDX-License-Identifier: GPL-3.0-or-later
#include "../support.hpp"
#include "sample.hpp"

#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/mechanics/corotational_element.hpp>
#include <fretwork/mechanics/linear_element.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <algorithm>
#include <numeric>

namespace fretwork::mechanics {
namespace THIS_TEST {

using Eigen::MatrixXd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::VectorXd;
using sample::Random;
using test::complaint_of;
using testing::HasSubstr;

/// The size of all samples, m.
constexpr double kLength = 0.03;

/// A condensed structure as an element, turned in space.
struct Tile {
    std::vector<Vector3d> places;  ///< of its nodes in the structure, m
    MatrixXd stiffness;            ///< in the body's axes
    std::unique_ptr<const Element> element;

    Tile(const Frame& frame, int nodes, const Quaterniond& turn) {
        std::vector<NodeIndex> kept;
        for (int i = 0; i < nodes; ++i) kept.emplace_back(i);
        stiffness = condense(assemble(frame), kept);
        const std::vector<Vector3d> own(frame.nodes.begin(), frame.nodes.begin() + nodes);
        const Vector3d origin(0.4, -0.1, 0.2);
        for (const Vector3d& place : own) places.push_back(origin + turn * place);
        element = corotational_element(
            kept, std::make_shared<CorotationalBody>(CorotationalBody::Parts{own, stiffness}),
            turn.toRotationMatrix());
    }
};

/// Flat with six nodes, in space with four, and two nodes on a line.
std::vector<Tile> every_shape() {
    const Quaterniond turn = geometry::exponential({0.3, -0.5, 0.9});
    Frame beam;
    beam.nodes = {{0, 0, 0}, {kLength, 0, 0}};
    beam.beams.push_back(sample::beam_between(0, 1));
    std::vector<Tile> tiles;
    tiles.emplace_back(sample::flat_wheel(), 6, turn);
    tiles.emplace_back(sample::star(), 4, turn);
    tiles.emplace_back(beam, 2, turn);
    return tiles;
}

/// The whole turned and moved at will, each node turned by up to `amplitude` rad against that and moved by
/// as much of the size.
std::vector<NodeState> random_states(const Tile& tile, double amplitude, Random& random) {
    const Quaterniond common = random.rotation();
    const Vector3d shift = random.vector(0.1);
    std::vector<NodeState> states;
    for (const Vector3d& place : tile.places) {
        const Vector3d moved = place + amplitude * kLength * random.vector(1.0 / std::sqrt(3.0));
        states.push_back({common * moved + shift - place,
                          common * geometry::exponential(amplitude * random.vector(1.0 / std::sqrt(3.0)))});
    }
    return states;
}

ElementResponse response_of(const Element& element, const std::vector<NodeState>& states,
                            Demand demand = Demand::Force) {
    ElementResponse response;
    element.evaluate(states, demand, response);
    return response;
}

void move(NodeState& state, int dof, double by) {
    if (dof < 3) {
        state.displacement[dof] += by * kLength;
    } else {
        state.rotation = (geometry::exponential(by * Vector3d::Unit(dof - 3)) * state.rotation).normalized();
    }
}

/// The central difference of a value along each dof; displacements in lengths.
template <class Value>
MatrixXd differences(std::vector<NodeState> states, const Value& value) {
    constexpr double kStep = 1e-5;
    MatrixXd result;
    for (std::size_t node = 0; node < states.size(); ++node) {
        for (int dof = 0; dof < kDofsPerNode; ++dof) {
            const NodeState kept = states[node];
            move(states[node], dof, kStep);
            const VectorXd plus = value(states);
            states[node] = kept;
            move(states[node], dof, -kStep);
            const VectorXd difference = (plus - value(states)) / (2.0 * kStep);
            states[node] = kept;
            result.conservativeResize(difference.size(), result.cols() + 1);
            result.rightCols<1>() = difference;
        }
    }
    return result;
}

/// Forces times the length, so that they and moments are of one kind.
VectorXd in_moments(VectorXd force) {
    for (Eigen::Index at = 0; at < force.size(); at += kDofsPerNode) force.segment<3>(at) *= kLength;
    return force;
}
MatrixXd in_moments(MatrixXd tangent) {
    for (Eigen::Index at = 0; at < tangent.rows(); at += kDofsPerNode) {
        tangent.middleRows<3>(at) *= kLength;
        tangent.middleCols<3>(at) *= kLength;
    }
    return tangent;
}

TEST(CorotationalElement, ForceIsTheGradientOfTheEnergyAtLargeRotations) {
    for (const Tile& tile : every_shape()) {
        Random random(1);
        for (int trial = 0; trial < 20; ++trial) {
            const auto states = random_states(tile, 0.4, random);
            const VectorXd force = in_moments(response_of(*tile.element, states).force);
            const MatrixXd gradient = differences(states, [&](const auto& at) {
                return VectorXd::Constant(1, response_of(*tile.element, at).energy).eval();
            });
            EXPECT_LT((gradient.transpose() - force).norm(), 1e-8 * force.norm());
        }
    }
}

TEST(CorotationalElement, TangentIsTheDerivativeOfTheForceAtLargeRotations) {
    for (const Tile& tile : every_shape()) {
        Random random(2);
        for (int trial = 0; trial < 20; ++trial) {
            const auto states = random_states(tile, 0.4, random);
            const ElementResponse response = response_of(*tile.element, states, Demand::Tangent);
            const MatrixXd tangent = response.tangent;
            EXPECT_LT((tangent - tangent.transpose()).norm(), 1e-13 * tangent.norm());
            MatrixXd derivative = tangent;
            for (Eigen::Index at = 3; at < derivative.rows(); at += kDofsPerNode)
                derivative.block<3, 3>(at, at) -= 0.5 * geometry::cross_matrix(response.force.segment<3>(at));
            derivative = in_moments(derivative);
            const MatrixXd difference = differences(
                states, [&](const auto& at) { return in_moments(response_of(*tile.element, at).force); });
            EXPECT_LT((derivative - difference).norm(), 1e-8 * derivative.norm());
        }
    }
}

/// The checks of the tests of mixed responses, on elements of more nodes.
TEST(CorotationalElement, GivenStressesMeetTheSlopesOfItsStrains) {
    for (const Tile& tile : every_shape()) {
        Random random(3);
        const auto states = random_states(tile, 0.4, random);
        const Eigen::Index size = tile.element->stress_count();
        VectorXd own(size);
        MatrixXd slopes(size, size);
        MixedResponse response;
        const VectorXd given = VectorXd::LinSpaced(size, -1.0, 2.0);
        const auto count = static_cast<std::size_t>(size);
        tile.element->evaluate_mixed(
            states, Demand::Tangent,
            {{given.data(), count}, {own.data(), count}, {slopes.data(), count * count}}, response);
        EXPECT_LT((slopes.transpose() * own - response.force).norm(), 1e-13 * response.force.norm());
        EXPECT_LT((slopes.transpose() * given - response.given_force).norm(), 1e-13 * given.norm());
        VectorXd none(size);
        const MatrixXd geometric = differences(states, [&](const auto& at) {
            MixedResponse moved;
            tile.element->evaluate_mixed(at, Demand::Force, {{given.data(), count}, {none.data(), count}, {}},
                                         moved);
            return in_moments(moved.given_force);
        });
        MatrixXd expected = slopes.transpose() * tile.stiffness * slopes;
        expected = in_moments(expected) + geometric;
        for (Eigen::Index at = 3; at < size; at += kDofsPerNode)
            expected.block<3, 3>(at, at) += 0.5 * geometry::cross_matrix(response.given_force.segment<3>(at));
        EXPECT_LT((in_moments(response.tangent) - expected).norm(), 1e-8 * expected.norm());
    }
}

TEST(CorotationalElement, RestStiffnessIsTheTangentAtRest) {
    for (const Tile& tile : every_shape()) {
        const auto response =
            response_of(*tile.element, std::vector<NodeState>(tile.places.size()), Demand::Tangent);
        MatrixXd stiffness;
        tile.element->rest_stiffness(stiffness);
        // Condensation leaves rounding in the stiffness against rigid motions; the tangent has none.
        EXPECT_LT((stiffness - response.tangent).norm(), 1e-12 * stiffness.norm());
        EXPECT_LT(response.force.norm(), 1e-14 * stiffness.norm());
    }
}

TEST(CorotationalElement, TurnsOfTheWholeByAnyAngleCostNoEnergy) {
    for (const Tile& tile : every_shape()) {
        const Vector3d axis = Vector3d(0.2, -0.7, 0.4).normalized();
        for (double angle = 0.0; angle < 13.0; angle += 0.1) {  // more than two whole turns
            const Quaterniond turn = geometry::exponential(angle * axis);
            std::vector<NodeState> states;
            for (const Vector3d& place : tile.places) states.push_back({turn * place - place, turn});
            const ElementResponse response = response_of(*tile.element, states);
            // Rounding of places 0.5 m from the origin, times the stiffness.
            const double force = 1e-15 * tile.stiffness.cwiseAbs().maxCoeff();
            EXPECT_LT(response.force.norm(), force) << angle;
            EXPECT_LT(response.energy, 1e-15 * force) << angle;
        }
    }
}

TEST(CorotationalElement, ForceAndTangentTurnWithTheWhole) {
    for (const Tile& tile : every_shape()) {
        Random random(4);
        for (int trial = 0; trial < 10; ++trial) {
            const auto states = random_states(tile, 0.4, random);
            const Quaterniond turn = random.rotation();
            auto turned = states;
            for (std::size_t i = 0; i < states.size(); ++i) {
                turned[i].displacement = turn * (tile.places[i] + states[i].displacement) - tile.places[i];
                turned[i].rotation = turn * states[i].rotation;
            }
            const auto before = response_of(*tile.element, states, Demand::Tangent);
            const auto after = response_of(*tile.element, turned, Demand::Tangent);
            EXPECT_NEAR(after.energy, before.energy, 1e-11 * before.energy);
            const Eigen::Matrix3d map = turn.toRotationMatrix();
            for (Eigen::Index i = 0; i < before.force.size(); i += 3) {
                EXPECT_LT((after.force.segment<3>(i) - map * before.force.segment<3>(i)).norm(),
                          1e-11 * before.force.norm());
                for (Eigen::Index j = 0; j < before.force.size(); j += 3) {
                    const Eigen::Matrix3d expected = map * before.tangent.block<3, 3>(i, j) * map.transpose();
                    EXPECT_LT((after.tangent.block<3, 3>(i, j) - expected).norm(),
                              1e-11 * before.tangent.norm());
                }
            }
        }
    }
}

TEST(CorotationalElement, ForcesOnTheNodesBalance) {
    for (const Tile& tile : every_shape()) {
        Random random(5);
        for (int trial = 0; trial < 10; ++trial) {
            const auto states = random_states(tile, 0.4, random);
            const ElementResponse response = response_of(*tile.element, states);
            const VectorXd forces = in_moments(response.force);
            Vector3d sum = Vector3d::Zero();
            Vector3d moment = Vector3d::Zero();
            for (std::size_t i = 0; i < states.size(); ++i) {
                const auto at = static_cast<Eigen::Index>(i) * kDofsPerNode;
                sum += forces.segment<3>(at);
                const Vector3d arm =
                    tile.places[i] + states[i].displacement - tile.places[0] - states[0].displacement;
                moment += (arm / kLength).cross(forces.segment<3>(at)) + forces.segment<3>(at + 3);
            }
            EXPECT_LT(sum.norm(), 1e-12 * forces.norm());
            EXPECT_LT(moment.norm(), 1e-12 * forces.norm());
        }
    }
}

TEST(CorotationalElement, StretchMeetsTheLinearForceHoweverTheWholeIsTurned) {
    const Tile bar = std::move(every_shape()[2]);
    const double axial = 1e9 * sample::bar().area / kLength;
    const double stretch = 0.2 * kLength;
    Random random(6);
    for (int trial = 0; trial < 5; ++trial) {
        const Quaterniond turn = random.rotation();
        const Vector3d rest = bar.places[1] - bar.places[0];
        const Vector3d now = turn * rest.normalized() * (kLength + stretch);
        const std::vector<NodeState> states = {{Vector3d::Zero(), turn}, {now - rest, turn}};
        const ElementResponse response = response_of(*bar.element, states);
        EXPECT_NEAR(response.energy, 0.5 * axial * stretch * stretch, 1e-12 * axial * stretch * stretch);
        const Vector3d expected = axial * stretch * now.normalized();
        EXPECT_LT((response.force.segment<3>(6) - expected).norm(), 1e-11 * expected.norm());
    }
}

TEST(CorotationalElement, DoesNotDependOnTheOrderOfItsNodes) {
    const Tile tile = std::move(every_shape()[0]);
    const std::vector<std::size_t> order = {4, 0, 5, 2, 1, 3};
    const auto count = static_cast<Eigen::Index>(order.size());
    std::vector<Vector3d> places;
    MatrixXd stiffness(6 * count, 6 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto from_i = static_cast<Eigen::Index>(order[static_cast<std::size_t>(i)]);
        places.push_back(sample::flat_wheel().nodes[order[static_cast<std::size_t>(i)]]);
        for (Eigen::Index j = 0; j < count; ++j) {
            const auto from_j = static_cast<Eigen::Index>(order[static_cast<std::size_t>(j)]);
            stiffness.block<6, 6>(6 * i, 6 * j) = tile.stiffness.block<6, 6>(6 * from_i, 6 * from_j);
        }
    }
    std::vector<NodeIndex> nodes;
    for (int i = 0; i < 6; ++i) nodes.emplace_back(i);
    const auto renumbered = corotational_element(
        nodes, std::make_shared<CorotationalBody>(CorotationalBody::Parts{places, stiffness}),
        geometry::exponential({0.3, -0.5, 0.9}).toRotationMatrix());
    Random random(7);
    const auto states = random_states(tile, 0.4, random);
    std::vector<NodeState> reordered;
    for (const std::size_t i : order) reordered.push_back(states[i]);
    const auto before = response_of(*tile.element, states);
    const auto after = response_of(*renumbered, reordered);
    EXPECT_NEAR(after.energy, before.energy, 1e-11 * before.energy);
    for (std::size_t i = 0; i < order.size(); ++i) {
        EXPECT_LT((after.force.segment<6>(static_cast<Eigen::Index>(6 * i)) -
                   before.force.segment<6>(static_cast<Eigen::Index>(6 * order[i])))
                      .norm(),
                  1e-11 * before.force.norm());
    }
}

/// Both answer K d to displacements d; what they differ in is of second order.
TEST(CorotationalElement, DiffersFromTheLinearElementBySecondOrderOnly) {
    for (const Tile& tile : every_shape()) {
        MatrixXd stiffness;
        tile.element->rest_stiffness(stiffness);
        const auto nodes = tile.element->nodes();
        const auto linear = linear_element({nodes.begin(), nodes.end()}, {.stiffness = stiffness});
        const auto difference = [&](double amplitude) {
            Random random(8);
            std::vector<NodeState> states;
            for (std::size_t i = 0; i < nodes.size(); ++i) {
                const Vector3d shift = amplitude * kLength * random.vector(1.0);
                states.push_back({shift, geometry::exponential(amplitude * random.vector(1.0))});
            }
            return in_moments(
                       (response_of(*tile.element, states).force - response_of(*linear, states).force).eval())
                .norm();
        };
        EXPECT_NEAR(difference(1e-4) / difference(2e-4), 0.25, 1e-3);
    }
}

/// A column of elements, each a condensed beam, pinned at both ends.
TEST(CorotationalElement, AColumnOfThemBucklesUnderEulersLoad) {
    constexpr int kPieces = 16;
    const double length = 0.2;
    const double pushed = 1.0;
    Frame piece;
    piece.nodes = {{0, 0, 0}, {length / kPieces, 0, 0}};
    piece.beams.push_back(sample::beam_between(0, 1));
    piece.beams[0].section = rectangle_section(0.004, 0.002);
    const MatrixXd stiffness = condense(assemble(piece), std::vector{NodeIndex(0), NodeIndex(1)});
    const auto body = std::make_shared<CorotationalBody>(CorotationalBody::Parts{piece.nodes, stiffness});
    Assembly column;
    for (int i = 0; i <= kPieces; ++i) column.nodes.emplace_back(0.0, length * i / kPieces, 0.0);
    const Eigen::Matrix3d turn = geometry::exponential({0, 0, std::numbers::pi / 2}).toRotationMatrix();
    for (int i = 0; i < kPieces; ++i)
        column.elements.push_back(corotational_element({NodeIndex(i), NodeIndex(i + 1)}, body, turn));
    column.supports = {{NodeIndex(0), {{true, true, true, false, true, false}}},
                       {NodeIndex(kPieces), {{true, false, true, false, true, false}}}};
    column.loads = NodeValues::Zero(kPieces + 1, kDofsPerNode);
    column.loads(kPieces, 1) = -pushed;
    column.reported_nodes = kPieces + 1;
    const double bending = 1e9 * 0.004 * std::pow(0.002, 3) / 12.0;
    const double euler = std::pow(std::numbers::pi / length, 2) * bending;
    const auto modes = buckling_modes(column, 1);
    ASSERT_EQ(modes.size(), 1U);
    // The elements' geometric stiffness is that of a straight chord: its error falls with their number
    // squared, and here is below a hundredth.
    EXPECT_NEAR(modes[0].value * pushed, euler, 0.01 * euler);
}

TEST(CorotationalElement, KnowsTheLargestTurnOfANodeAgainstTheOthers) {
    const Tile tile = std::move(every_shape()[0]);
    std::vector<NodeState> states(tile.places.size());
    EXPECT_NEAR(tile.element->relative_turn(states), 0.0, 1e-15);
    states[2].rotation = geometry::exponential({0, 0, 0.5});
    const double turn = tile.element->relative_turn(states);
    EXPECT_GT(turn, 0.4);  // the frame follows a node by less than its share of six
    EXPECT_LT(turn, 0.5);
}

TEST(CorotationalElement, TurnsItsMassIntoTheStructuresAxes) {
    const Tile tile = std::move(every_shape()[0]);
    const MatrixXd own = VectorXd::LinSpaced(36, 1.0, 2.0).asDiagonal();
    CorotationalBody::Parts parts{sample::flat_wheel().nodes, tile.stiffness, [&] { return MatrixXd(own); }};
    parts.nodes.resize(6);
    const auto nodes = tile.element->nodes();
    const Eigen::Matrix3d turn = geometry::exponential({0.1, 0.7, -0.4}).toRotationMatrix();
    const auto element =
        corotational_element({nodes.begin(), nodes.end()}, std::make_shared<CorotationalBody>(parts), turn);
    MatrixXd mass;
    element->mass(mass);
    const Eigen::Matrix3d expected = turn * own.block<3, 3>(6, 6) * turn.transpose();
    EXPECT_LT((mass.block<3, 3>(6, 6) - expected).norm(), 1e-14);
    MatrixXd none;
    EXPECT_THAT(complaint_of([&] { tile.element->mass(none); }), HasSubstr("natural frequencies"));
}

TEST(CorotationalElement, RefusesWhatIsNoStiffnessOfItsNodes) {
    const Frame wheel = sample::flat_wheel();
    const std::vector<Vector3d> six(wheel.nodes.begin(), wheel.nodes.begin() + 6);
    const auto body = [&](MatrixXd stiffness) { CorotationalBody({six, std::move(stiffness)}); };
    EXPECT_THAT(complaint_of([&] { body(MatrixXd::Zero(18, 18)); }), HasSubstr("36 rows"));
    EXPECT_THAT(complaint_of([&] { body(MatrixXd::Identity(36, 36)); }), HasSubstr("rigid motion"));
    EXPECT_THAT(complaint_of([&] {
                    CorotationalBody({{six[0]}, MatrixXd::Zero(6, 6)});
                }),
                HasSubstr("two nodes"));
    const auto shared =
        std::make_shared<CorotationalBody>(CorotationalBody::Parts{six, MatrixXd::Zero(36, 36)});
    EXPECT_THAT(
        complaint_of([&] {
            (void)corotational_element({NodeIndex(0), NodeIndex(1)}, shared, Eigen::Matrix3d::Identity());
        }),
        HasSubstr("6 nodes cannot be placed on 2"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
