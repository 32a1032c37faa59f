// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever takes long can be stopped from another thread, and tells how far it is.
#include "sample.hpp"
#include "stops.hpp"

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/discretization.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/mechanics/paths/linear_range.hpp>
#include <fretwork/mechanics/paths/path_tracing.hpp>
#include <fretwork/mechanics/paths/relaxation.hpp>

#include <gtest/gtest.h>

#include <semaphore>
#include <thread>

namespace fretwork::mechanics {
namespace THIS_TEST {

/// At the first step that it is told of, another thread asks to stop; the work goes on when that has
/// happened.
class StopFromAnotherThread final : public base::Progress {
  public:
    ~StopFromAnotherThread() override { told_.release(); }
    void start(std::string_view, std::size_t) override {}
    void update(std::size_t) override {
        if (std::exchange(is_told_, true)) return;
        told_.release();
        asked_.acquire();
    }
    void finish() override { ++finished; }
    base::Control control() { return {.stop = source_.get_token(), .progress = this}; }
    int finished = 0;

  private:
    bool is_told_ = false;
    std::binary_semaphore told_{0};
    std::binary_semaphore asked_{0};
    std::stop_source source_;
    std::jthread other_{[this] {
        told_.acquire();
        source_.request_stop();
        asked_.release();
    }};
};

/// Counts what it is told, and checks that steps do not go back.
class Count final : public base::Progress {
  public:
    void start(std::string_view, std::size_t total) override {
        EXPECT_EQ(started, finished);
        ++started;
        total_ = total;
        last_ = 0;
    }
    void update(std::size_t done) override {
        EXPECT_GE(done, last_);
        EXPECT_LE(done, total_);
        last_ = done;
        ++updates;
    }
    void finish() override { ++finished; }
    int started = 0;
    int finished = 0;
    int updates = 0;

  private:
    std::size_t total_ = 0;
    std::size_t last_ = 0;
};

/// Some 20,000 beams.
const Assembly& large_assembly() {
    static const Assembly assembly = assemble(sample::honeycomb(120, 112));
    return assembly;
}

template <class Solve>
void expect_stopped(const Solve& solve) {
    StopFromAnotherThread listener;
    EXPECT_THROW(solve(listener.control()), base::Stopped);
    EXPECT_EQ(listener.finished, 1);
}

TEST(Control, StopsASolveOfTwentyThousandBeams) {
    ASSERT_GT(large_assembly().elements.size(), 19000u);
    for (const int threads : {1, 2}) {
        expect_stopped([&](const base::Control& control) {
            (void)solve_linear(large_assembly(), {.threads = threads, .control = control});
        });
        expect_stopped([&](const base::Control& control) {
            (void)follow_load_path(large_assembly(), even_load_factors(10),
                                   {.threads = threads, .control = control});
        });
    }
    expect_stopped([](const base::Control& control) {
        (void)trace_path(large_assembly(), {.equilibrium = {.control = control}});
    });
    expect_stopped([](const base::Control& control) { (void)relax(large_assembly(), {.control = control}); });
    expect_stopped([](const base::Control& control) {
        (void)vibration_modes(large_assembly(), 3, {.control = control});
    });
    expect_stopped([](const base::Control& control) {
        (void)buckling_modes(large_assembly(), 3, {.control = control});
    });
}

TEST(Control, StopsTheEstimateOfADiscretizationError) {
    const Frame frame = sample::honeycomb(20, 20);
    const auto factors = even_load_factors(4);
    const auto path = follow_load_path(assemble(frame), factors);
    expect_stopped([&](const base::Control& control) {
        (void)estimate_discretization_error(frame, factors, path, {.control = control});
    });
}

TEST(Control, StopsModesAndEstimatesAtAnyLook) {
    const Frame frame = sample::honeycomb(6, 5);
    const Assembly assembly = assemble(frame);
    const std::vector<double> factors = even_load_factors(1);
    const auto path = follow_load_path(assembly, factors);
    const auto expect_stops = [](const auto& work) { test::expect_stops_at_any_look(work, [] {}); };
    expect_stops(
        [&](const base::Control& control) { (void)vibration_modes(assembly, 2, {.control = control}); });
    expect_stops(
        [&](const base::Control& control) { (void)buckling_modes(assembly, 2, {.control = control}); });
    expect_stops([&](const base::Control& control) { (void)linear_range(assembly, {.control = control}); });
    expect_stops([&](const base::Control& control) {
        (void)estimate_discretization_error(frame, factors, path, {.control = control});
    });
}

TEST(Control, TellsProgressOfEverySolver) {
    const Assembly assembly = assemble(sample::star());
    Count count;
    const base::Control control{.progress = &count};
    const double factors[] = {0.5, 1.0};
    (void)solve_linear(assembly, {.control = control});
    (void)follow_load_path(assembly, factors, {.control = control});
    (void)trace_path(assembly, {.equilibrium = {.control = control}});
    (void)relax(assembly, {.control = control});
    (void)vibration_modes(assembly, 2, {.control = control});
    EXPECT_EQ(count.started, 5);
    EXPECT_EQ(count.finished, 5);
    EXPECT_GT(count.updates, 10);
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
