// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"
#include "stops.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/linear_element.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/structure/factorized_structure.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace fretwork::mechanics {
namespace THIS_TEST {

/// The nodes lie in a plane or in space.
enum class Extent { Flat, Spatial };

constexpr int kColumns = 14;
constexpr int kRows = 10;

/// A grid of beams beside a regular one, clamped at one side: beam b is element b.
Frame grid(Extent extent) {
    sample::Random random(3);
    Frame frame;
    for (int i = 0; i < kColumns * kRows; ++i) {
        const int column = i % kColumns;
        const int row = i / kColumns;
        frame.nodes.push_back(random.vector(0.002) + Eigen::Vector3d(0.01 * column, 0.01 * row, 0.0));
        if (extent == Extent::Flat) frame.nodes.back().z() = 0.0;
        if (i % kColumns > 0) frame.beams.push_back(sample::beam_between(i - 1, i));
        if (i >= kColumns) frame.beams.push_back(sample::beam_between(i - kColumns, i));
        if (i % kColumns == 0) sample::clamp(frame, i);
    }
    frame.loads.push_back({NodeIndex(kColumns - 1), {0.1, -0.2, 0.3}, {0.001, 0.002, -0.001}});
    return frame;
}

/// A frame and its assembly, of which each edit replaces only what it changes.
class EditedGrid {
  public:
    explicit EditedGrid(Extent extent) : frame_(grid(extent)), assembly_(assemble(frame_)) {}

    [[nodiscard]] const Frame& frame() const { return frame_; }
    [[nodiscard]] const Assembly& assembly() const { return assembly_; }

    void change_beam(std::size_t beam, double width) {
        frame_.beams[beam].section = rectangle_section(width, 0.002);
        assembly_.elements[beam] = assemble(frame_).elements[beam];
    }
    void hold(int node) {
        frame_.supports.push_back({NodeIndex(node), sample::kPinned});
        assembly_.supports = frame_.supports;
    }
    void load(int node, const Eigen::Vector3d& force) {
        frame_.loads.push_back({NodeIndex(node), force});
        assembly_.loads = assemble(frame_).loads;
    }
    void prescribe(int node, double value) {
        frame_.prescribed = {{NodeIndex(node), Dof::uz, value}};
        assembly_.prescribed = frame_.prescribed;
    }

    void edit(sample::Random& random) {
        const auto below = [&](std::size_t count) {
            return std::min(
                static_cast<std::size_t>((random.next() + 1.0) / 2.0 * static_cast<double>(count)),
                count - 1);
        };
        const auto node = static_cast<int>(below(frame_.nodes.size()));
        switch (below(8)) {
            case 0:
                return hold(node);
            case 1:
                return load(node, random.vector(0.1));
            case 2:
                return prescribe(node, 1e-4 * random.next());
            case 3:
                for (std::size_t b = 0; b < frame_.beams.size(); b += 2) change_beam(b, 0.003);
                return;
            default:
                return change_beam(below(frame_.beams.size()), 0.002 + 0.0015 * random.next());
        }
    }

  private:
    Frame frame_;
    Assembly assembly_;
};

/// The displacements of the frame when its nodes are numbered from the other end: another elimination order.
NodeValues solved_from_the_other_end(Frame frame) {
    const auto last = static_cast<int>(frame.nodes.size()) - 1;
    const auto turn = [&](NodeIndex& node) { node = NodeIndex(last - node.value); };
    std::reverse(frame.nodes.begin(), frame.nodes.end());
    for (Beam& beam : frame.beams) {
        for (NodeIndex& node : beam.nodes) turn(node);
    }
    for (Support& support : frame.supports) turn(support.node);
    for (PrescribedDisplacement& given : frame.prescribed) turn(given.node);
    for (NodalLoad& load : frame.loads) turn(load.node);
    return solve_linear(assemble(frame)).displacements.colwise().reverse();
}

TEST(LinearSolverEdits, AfterAnyEditsTheAnswerIsThatOfTheFinalStructure) {
    for (const Extent extent : {Extent::Flat, Extent::Spatial}) {
        sample::Random random(17);
        EditedGrid grid(extent);
        LinearSolver solver(grid.assembly());
        int corrected = 0, anew = 0;
        bool was_updated = false;
        for (int i = 0; i < 60; ++i) {
            grid.edit(random);
            const FactorChange change = solver.update(grid.assembly());
            was_updated = change == FactorChange::Updated || (was_updated && change == FactorChange::Kept);
            const Solution found = solver.solve();
            const Solution expected = solve_linear(grid.assembly());
            if (!was_updated) {
                ++anew;
                ASSERT_EQ(found.displacements, expected.displacements) << i;
                ASSERT_EQ(found.reactions, expected.reactions) << i;
                continue;
            }
            ++corrected;
            const double rounding = (solved_from_the_other_end(grid.frame()) - expected.displacements).norm();
            ASSERT_LT((found.displacements - expected.displacements).norm(), 100.0 * rounding) << i;
            // Rounding again: either may be the smaller one.
            ASSERT_LT(found.residual, 10.0 * expected.residual) << i;
        }
        EXPECT_GT(corrected, 10);
        EXPECT_GT(anew, 10);
    }
}

TEST(LinearSolverEdits, ALoadLeavesFactorsAndCorrectionAsTheyAre) {
    EditedGrid grid(Extent::Flat);
    LinearSolver solver(grid.assembly());
    grid.change_beam(7, 0.003);
    EXPECT_EQ(solver.update(grid.assembly()), FactorChange::Updated);
    grid.load(20, {0.0, 0.0, 1.0});
    EXPECT_EQ(solver.update(grid.assembly()), FactorChange::Kept);
}

TEST(LinearSolverEdits, ThreadsChangeNoBit) {
    EditedGrid grid(Extent::Flat);
    LinearSolver one(grid.assembly()), two(grid.assembly(), {.threads = 2});
    grid.change_beam(7, 0.003);
    EXPECT_EQ(one.update(grid.assembly()), FactorChange::Updated);
    EXPECT_EQ(two.update(grid.assembly()), FactorChange::Updated);
    EXPECT_EQ(one.solve().displacements, two.solve().displacements);
}

TEST(LinearSolverEdits, TakenBackAnEditLeavesNoTrace) {
    EditedGrid grid(Extent::Flat);
    const Assembly before = grid.assembly();
    LinearSolver solver(before);
    const NodeValues expected = solver.solve().displacements;
    grid.change_beam(7, 0.003);
    EXPECT_EQ(solver.update(grid.assembly()), FactorChange::Updated);
    EXPECT_NE(solver.solve().displacements, expected);
    EXPECT_EQ(solver.update(before), FactorChange::Kept);
    EXPECT_EQ(solver.solve().displacements, expected);
}

TEST(LinearSolverEdits, ARefusedEditChangesNothing) {
    EditedGrid grid(Extent::Flat);
    LinearSolver solver(grid.assembly());
    const NodeValues expected = solver.solve().displacements;
    Assembly loose = grid.assembly();
    loose.supports.clear();
    EXPECT_THROW(solver.update(loose), base::NumericalError);
    EXPECT_EQ(solver.solve().displacements, expected);
}

TEST(LinearSolverEdits, AnElementThatCouplesTheHalvesAndItsRemovalAreNewStructures) {
    EditedGrid grid(Extent::Flat);
    const Assembly& flat = grid.assembly();
    Frame turned_frame = grid.frame();
    turned_frame.beams[5].section = rectangle_section(0.002, 0.004);
    turned_frame.beams[5].normal = Eigen::Vector3d(0.3, 0.4, 1.0);
    Assembly turned = flat;
    turned.elements[5] = assemble(turned_frame).elements[5];
    LinearSolver solver(flat);
    for (const Assembly* assembly : {&std::as_const(turned), &flat}) {
        solver.update(*assembly);
        EXPECT_EQ(solver.solve().displacements, solve_linear(*assembly).displacements);
    }
}

/// A chain of elements of three nodes each, which share their first and last nodes. The stiffness of each is
/// positive definite, and symmetric but for rounding.
Assembly chain(int elements) {
    sample::Random random(5);
    Assembly assembly;
    const int nodes = 2 * elements + 1;
    for (int i = 0; i < nodes; ++i) assembly.nodes.push_back(random.vector(1.0));
    assembly.reported_nodes = nodes;
    assembly.loads = NodeValues::Constant(nodes, kDofsPerNode, 0.5);
    assembly.supports = {{NodeIndex(0), DofSet::all()}};
    for (int e = 0; e < elements; ++e) {
        Eigen::MatrixXd factor(18, 18);
        for (double& value : factor.reshaped()) value = random.next();
        Eigen::MatrixXd stiffness = factor * factor.transpose() + Eigen::MatrixXd::Identity(18, 18);
        stiffness.triangularView<Eigen::StrictlyLower>() *= 1.0 + 1e-15;
        assembly.elements.push_back(linear_element(
            {NodeIndex(2 * e), NodeIndex(2 * e + 1), NodeIndex(2 * e + 2)}, {.stiffness = stiffness}));
    }
    return assembly;
}

/// An element's like, twice as stiff, that lists the same nodes from the second on.
std::shared_ptr<const Element> listed_from_the_second(const Element& element) {
    Eigen::MatrixXd stiffness;
    element.rest_stiffness(stiffness);
    std::vector<NodeIndex> nodes(element.nodes().begin(), element.nodes().end());
    std::ranges::rotate(nodes, nodes.begin() + 1);
    std::vector<int> rows;
    for (int i = 0; i < 18; ++i) rows.push_back((i + kDofsPerNode) % 18);
    return linear_element(std::move(nodes), {.stiffness = 2.0 * stiffness(rows, rows)});
}

TEST(LinearSolverEdits, AnElementMayListItsNodesInAnotherOrder) {
    const Assembly before = chain(40);
    Assembly one = before, all = before;
    one.elements[7] = listed_from_the_second(*before.elements[7]);
    for (auto& element : all.elements) element = listed_from_the_second(*element);
    const structure::FactorizedStructure factorized(before, {});
    const structure::FactorizedStructure corrected(factorized, one, structure::ElementEdit::Correct);
    EXPECT_EQ(corrected.last_change(), FactorChange::Updated);
    const structure::FactorizedStructure anew(one, {});
    Eigen::VectorXd by_correction = Eigen::VectorXd::Ones(anew.systems()[0].layout().equations());
    Eigen::VectorXd by_factors = by_correction;
    corrected.systems()[0].solve(by_correction);
    anew.systems()[0].solve(by_factors);
    // The chain's stiffness has a condition of some 1e6.
    EXPECT_LT((by_correction - by_factors).norm(), 1e-9 * by_factors.norm());
    LinearSolver solver(before);
    EXPECT_EQ(solver.update(all), FactorChange::Refactorized);
    EXPECT_EQ(solver.solve().displacements, solve_linear(all).displacements);
    EXPECT_EQ(solver.update(before), FactorChange::Refactorized);
    EXPECT_EQ(solver.solve().displacements, solve_linear(before).displacements);
}

TEST(LinearSolverEdits, StopsAtAnyLookAndIsAsItWas) {
    const EditedGrid before(Extent::Flat);
    EditedGrid one = before, many = before;
    one.change_beam(7, 0.003);
    for (std::size_t b = 0; b < before.frame().beams.size(); ++b) many.change_beam(b, 0.003);
    Assembly held = before.assembly();
    held.supports.push_back({NodeIndex(kColumns - 1), DofSet::all()});
    LinearSolver solver(before.assembly());
    const NodeValues expected = solver.solve().displacements;
    const auto is_as_it_was = [&] { EXPECT_EQ(solver.solve().displacements, expected); };
    for (const Assembly* edited : {&one.assembly(), &many.assembly(), &std::as_const(held)}) {
        test::expect_stops_at_any_look(
            [&](const base::Control& control) {
                solver.update(before.assembly());
                solver.update(*edited, control);
            },
            is_as_it_was);
    }
}

TEST(LinearSolverEdits, SolutionsStopAtAnyLook) {
    EditedGrid grid(Extent::Spatial);
    LinearSolver solver(grid.assembly());
    const Eigen::MatrixXd right_sides = Eigen::MatrixXd::Identity(kColumns * kRows * kDofsPerNode, 3);
    for (const double width : {0.002, 0.003}) {  // as factorized, and corrected
        grid.change_beam(30, width);
        solver.update(grid.assembly());
        test::expect_stops_at_any_look([&](const base::Control& control) { (void)solver.solve(control); },
                                       [] {});
        test::expect_stops_at_any_look(
            [&](const base::Control& control) { (void)solver.solve_free(right_sides, control); }, [] {});
    }
}

TEST(LinearSolverEdits, OtherConnectionsAreANewStructure) {
    Frame frame = grid(Extent::Flat);
    LinearSolver solver(assemble(frame));
    frame.beams.push_back(sample::beam_between(0, kColumns + 1));
    const Assembly edited = assemble(frame);
    solver.update(edited);
    EXPECT_EQ(solver.solve().displacements, solve_linear(edited).displacements);
}

TEST(LinearSolverEdits, AStructureThatBecomesFarSofterIsFactorizedAnew) {
    // The only beams to a corner, at a ten-millionth of their stiffness.
    EditedGrid grid(Extent::Flat);
    Frame soft = grid.frame();
    Assembly edited = grid.assembly();
    for (std::size_t b = 0; b < soft.beams.size(); ++b) {
        if (std::ranges::find(soft.beams[b].nodes, NodeIndex(kColumns - 1)) == soft.beams[b].nodes.end())
            continue;
        soft.beams[b].material.young_modulus *= 1e-7;
        edited.elements[b] = assemble(soft).elements[b];
    }
    LinearSolver solver(grid.assembly());
    EXPECT_EQ(solver.update(edited), FactorChange::Refactorized);
    EXPECT_EQ(solver.solve().displacements, solve_linear(edited).displacements);
}

TEST(LinearSolverEdits, CorrectedAndNewFactorsAgree) {
    const EditedGrid before(Extent::Spatial);
    EditedGrid grid = before;
    for (const std::size_t beam : {3U, 50U, 51U, 200U}) grid.change_beam(beam, 0.004);
    const structure::FactorizedStructure factorized(before.assembly(), {.threads = 1});
    const structure::FactorizedStructure corrected(factorized, grid.assembly(),
                                                   structure::ElementEdit::Correct);
    const structure::FactorizedStructure anew(factorized, grid.assembly(), structure::ElementEdit::Refactor);
    EXPECT_EQ(corrected.corrected_elements(), 4U);
    EXPECT_EQ(anew.corrected_elements(), 0U);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(corrected.systems()[0].layout().equations());
    load[17] = 1.0;
    Eigen::VectorXd by_correction = load, by_factors = load;
    corrected.systems()[0].solve(by_correction);
    anew.systems()[0].solve(by_factors);
    EXPECT_LT((by_correction - by_factors).norm(), 1e-8 * by_factors.norm());
    EXPECT_LT(
        (corrected.systems()[0].internal_forces(by_factors) - anew.systems()[0].internal_forces(by_factors))
            .norm(),
        1e-10);
}

TEST(LinearSolverEdits, ColumnsOfRightSidesAreSolvedAsLoadsAre) {
    EditedGrid grid(Extent::Flat);
    LinearSolver solver(grid.assembly());
    sample::Random random(2);
    Eigen::MatrixXd right_sides(kColumns * kRows * kDofsPerNode, 3);
    for (double& value : right_sides.reshaped()) value = random.next();
    for (const double width : {0.002, 0.003}) {  // as factorized, and corrected
        grid.change_beam(30, width);
        solver.update(grid.assembly());
        const Eigen::MatrixXd found = solver.solve_free(right_sides);
        for (Eigen::Index c = 0; c < 3; ++c) {
            const NodeValues load = right_sides.col(c).reshaped<Eigen::RowMajor>(kColumns * kRows, 6);
            const NodeValues expected = solver.solve(load).displacements;
            const NodeValues column = found.col(c).reshaped<Eigen::RowMajor>(kColumns * kRows, 6);
            EXPECT_LT((column - expected).norm(), 1e-9 * expected.norm());
        }
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
