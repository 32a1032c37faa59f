// SPDX-License-Identifier: GPL-3.0-or-later
#include "honeycomb.hpp"
#include "stops.hpp"

#include <fretwork/simulation/results/beam_table.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/session.hpp>
#include <fretwork/simulation/simulate.hpp>

namespace fretwork::simulation {
namespace THIS_TEST {

using test::cantilever;
using test::honeycomb;
using tiling::TileIndex;

Session sample_session(const std::string& model) {
    return Session(make_surface(honeycomb(4, 3, {"0-1+1-6", "0-6"}), nullptr), cantilever({0.1, 0.05, -0.2}),
                   {.model = model, .analysis = Analysis::Linear, .threads = 1});
}

/// An edit, and the one that takes it back.
enum class Way { There, Back };

/// Solve after an edit, stopped at any look; a solve after it goes on. All tiles have been built before, so
/// that the looks are always as many.
template <class Edit>
void expect_goes_on_after_any_stop(Session session, const Edit& edit) {
    const auto solve_after = [&](Way way, const base::Control& control) {
        edit(session, way);
        (void)session.solve(control);
    };
    for (const Way way : {Way::Back, Way::There}) solve_after(way, {});
    test::expect_stops_at_any_look(
        [&](const base::Control& control) {
            solve_after(Way::Back, {});
            solve_after(Way::There, control);
        },
        [&] {
            const auto found = session.solve().solution.displacements;
            const auto expected =
                simulate(session.surface(), session.load_case(), session.options()).solution.displacements;
            // Corrected factors change these displacements by some 1e-12.
            EXPECT_LT((found - expected).norm(), 1e-10 * expected.norm());
        });
}

TEST(SessionStops, ASolveGoesOnAfterAStopAtAnyLook) {
    for (const char* model : {"condensed", "full"}) {
        expect_goes_on_after_any_stop(sample_session(model), [](Session& session, Way way) {
            session.paint(std::vector{TileIndex(5)}, way == Way::Back ? "0-6" : "1-6+3-6");
        });
        expect_goes_on_after_any_stop(sample_session(model), [](Session& session, Way way) {
            reduction::Setting setting = session.surface().setting;
            setting.material.young_modulus = way == Way::Back ? 1e9 : 2e9;
            session.set_setting(setting);
        });
    }
    expect_goes_on_after_any_stop(sample_session("condensed"), [](Session& session, Way way) {
        session.turn(std::vector{TileIndex(5)}, way == Way::Back ? -1 : 1);
    });
    expect_goes_on_after_any_stop(sample_session("condensed"), [](Session& session, Way way) {
        session.set_support(1, {NodesById{{way == Way::Back ? 20 : 21}}, mechanics::DofSet::translations()});
    });
}

TEST(SessionStops, AdjointSolutionsStopAtAnyLook) {
    Session session = sample_session("condensed");
    const auto rows = static_cast<Eigen::Index>(session.solve().nodes.size()) * 6;
    const Eigen::MatrixXd ones = Eigen::MatrixXd::Ones(rows, 2);
    const auto solve_painted = [&](const std::string& pattern, const base::Control& control) {
        session.paint(std::vector{TileIndex(5)}, pattern);
        return session.solve_adjoint(ones, control);
    };
    const Eigen::MatrixXd expected = solve_painted("1-6+3-6", {});
    test::expect_stops_at_any_look(
        [&](const base::Control& control) {
            (void)solve_painted("0-6", {});
            (void)solve_painted("1-6+3-6", control);
        },
        // Corrected factors change these displacements by some 1e-12.
        [&] { EXPECT_LT((session.solve_adjoint(ones) - expected).norm(), 1e-10 * expected.norm()); });
}

TEST(SessionStops, StressesAndDeformationsStopAtEachTile) {
    Session session(make_surface(honeycomb(4, 3, {"0-1+1-6", "0-6"}), nullptr),
                    cantilever({0.0, 0.0, -0.001}), {.model = "corotational", .threads = 1});
    SurfaceResult result = session.solve();
    result.subject = result_subject(session.surface(), session.load_case(), session.options());
    const auto expect_stops = [&](const auto& work) {
        const test::StopAtLook never;
        work(never.control());
        EXPECT_GE(never.looks(), session.surface().tessellation.tiles.size());
        test::expect_stops_at_any_look(work, [] {});
    };
    expect_stops(
        [&](const base::Control& control) { (void)session.tile_deformations(result.solution, control); });
    expect_stops([&](const base::Control& control) { (void)beam_table(session, result.solution, control); });
    expect_stops([&](const base::Control& control) {
        (void)beam_table(session.surface(), result, reduction::tile_models(), control);
    });
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
