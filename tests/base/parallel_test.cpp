// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/base/parallel.hpp>

#include <atomic>
#include <latch>
#include <numeric>
#include <utility>
#include <vector>

namespace fretwork::base {
namespace THIS_TEST {

TEST(ParallelFor, CallsEveryIndexOnce) {
    for (const int threads : {1, 2, 7}) {
        std::vector<std::atomic<int>> calls(1000);
        parallel_for(calls.size(), threads, [&](std::size_t i) { ++calls[i]; });
        for (const auto& count : calls) EXPECT_EQ(count.load(), 1);
    }
}

TEST(ParallelFor, OfNothingCallsNothing) {
    parallel_for(0, 4, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, ThrowsTheFailureOfTheSmallestIndex) {
    for (int round = 0; round < 50; ++round) {
        const std::string message = test::complaint_of([] {
            parallel_for(100, 4, [](std::size_t i) {
                if (i >= 20) throw InputError(std::to_string(i));
            });
        });
        EXPECT_EQ(message, "20");
    }
}

TEST(ParallelFor, CallsWithinCallsDoAllOfTheWork) {
    for (int round = 0; round < 20; ++round) {
        std::vector<std::atomic<int>> calls(5 * 40);
        parallel_for(
            5, 4, [&](std::size_t i) { parallel_for(40, 3, [&](std::size_t j) { ++calls[40 * i + j]; }); });
        for (const auto& count : calls) EXPECT_EQ(count.load(), 1);
    }
}

// Each round needs two threads at once. Threads that were started for it alone would all come for the first
// time; the most that any other test of this program has started is below ten.
TEST(ParallelFor, ThreadsAreKeptFromCallToCall) {
    std::atomic<int> newcomers{0};
    for (int round = 0; round < 40; ++round) {
        std::latch both(2);
        parallel_for(2, 2, [&](std::size_t) {
            thread_local bool has_come = false;
            if (!std::exchange(has_come, true)) ++newcomers;
            both.arrive_and_wait();
        });
    }
    EXPECT_LT(newcomers.load(), 20);
}

/// Two trees: 4 over 0, 1 and 3, which is over 2; and 5 alone.
constexpr int kParents[] = {4, 4, 3, 4, -1, -1};

TEST(ParallelTree, CallsEveryNodeOnceAndAfterItsChildren) {
    for (const int threads : {1, 2, 7}) {
        for (int round = 0; round < 20; ++round) {
            std::atomic<int> clock{0};
            int called[6] = {};
            parallel_tree(kParents, threads, [&](std::size_t i) { called[i] = ++clock; });
            EXPECT_EQ(clock.load(), 6);
            for (std::size_t i = 0; i < 6; ++i) {
                EXPECT_GT(called[i], 0);
                if (kParents[i] >= 0) {
                    EXPECT_LT(called[i], called[kParents[i]]);
                }
            }
        }
    }
}

TEST(ParallelTree, CallsNothingAboveAFailureAndThrowsThatOfTheSmallestIndex) {
    for (const int threads : {1, 4}) {
        for (int round = 0; round < 20; ++round) {
            std::atomic<bool> called[6] = {};
            const std::string message = test::complaint_of([&] {
                parallel_tree(kParents, threads, [&](std::size_t i) {
                    called[i] = true;
                    if (i == 2 || i == 5) throw InputError(std::to_string(i));
                });
            });
            EXPECT_EQ(message, "2");
            EXPECT_TRUE(called[0] && called[1] && called[5]);
            EXPECT_FALSE(called[3] || called[4]);
        }
    }
}

TEST(ParallelTree, OfNothingCallsNothing) {
    parallel_tree({}, 4, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, TakesAllThreadsForZero) {
    EXPECT_GE(resolved_thread_count(0), 1);
}

}  // namespace THIS_TEST
}  // namespace fretwork::base
