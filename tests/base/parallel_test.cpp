// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/base/parallel.hpp>

#include <atomic>
#include <numeric>
#include <vector>

namespace fretwork::base {
namespace {

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

TEST(ParallelFor, TakesAllThreadsForZero) {
    EXPECT_GE(resolved_thread_count(0), 1);
}

}  // namespace
}  // namespace fretwork::base
