// SPDX-License-Identifier: GPL-3.0-or-later
// A method that is in no catalogue is used like one that is. The conformance tests run on it,
// too.
#include "analytic_problems.hpp"
#include "evolution_strategy.hpp"

#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/minimize.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::optimization {
namespace THIS_TEST {

TEST(OwnMethod, MinimizesWithoutBeingInTheCatalogue) {
    const auto problem = sphere(4);
    const own::EvolutionStrategy method({.starts = 1, .seed = 3});
    const auto report = minimize(problem, method, {.cost = 5000});
    EXPECT_LT(report.value, 1e-6);
    EXPECT_EQ(report.ending, Ending::Converged);
}

/// The code on the page is what is compiled here.
TEST(OwnMethod, IsWhatThePageShows) {
    const std::string folder = FRETWORK_SOURCE_DIR;
    const std::string source = base::read_text_file(folder + "/tests/optimization/evolution_strategy.hpp");
    const std::string page = base::read_text_file(folder + "/docs/guide/own_optimizer.md");
    int blocks = 0;
    for (std::size_t begin = page.find("```cpp\n"); begin != std::string::npos;
         begin = page.find("```cpp\n", begin)) {
        const std::string before = "<!-- program -->\n";  // a program of its own, which tests/docs runs
        if (page.substr(begin - before.size(), before.size()) == before) {
            begin += 7;
            continue;
        }
        begin += 7;
        const std::string block = page.substr(begin, page.find("```", begin) - begin);
        EXPECT_THAT(source, testing::HasSubstr(block));
        ++blocks;
    }
    EXPECT_EQ(blocks, 2);
}

}  // namespace THIS_TEST
}  // namespace fretwork::optimization
