// SPDX-License-Identifier: GPL-3.0-or-later
// A method that is in no catalogue is used, and compared, like one that is. The conformance tests run on it,
// too.
#include "analytic_problems.hpp"
#include "evolution_strategy.hpp"

#include <fretwork/base/file.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/comparison.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::optimization {
namespace {

TEST(OwnMethod, MinimizesWithoutBeingInTheCatalogue) {
    const auto problem = sphere(4);
    const own::EvolutionStrategy method({.starts = 1, .seed = 3});
    const auto report = minimize(problem, method, {.cost = 5000});
    EXPECT_LT(report.value, 1e-6);
    EXPECT_EQ(report.termination, Termination::Converged);
}

TEST(OwnMethod, TakesPartInAComparison) {
    const Contender contender{&own::kEvolutionStrategy, 2};
    const RunKey key{"sphere", std::string(own::kEvolutionStrategy.name), 1};
    ComparisonTable table;
    table.add(record_run(sphere(2), contender, key, {.budget = {.cost = 500}}, Eigen::Vector2d(0.1, 0.2)));
    EXPECT_TRUE(table.contains(key));
    EXPECT_THAT(table.csv(), testing::HasSubstr("sphere,evolution-strategy,1,random,2,2,"));
}

/// The code on the page is what is compiled here.
TEST(OwnMethod, IsWhatThePageShows) {
    const std::string folder = FRETWORK_SOURCE_DIR;
    const std::string source = base::read_text_file(folder + "/tests/optimization/evolution_strategy.hpp");
    const std::string page = base::read_text_file(folder + "/framework/fretwork/optimization/README.md");
    int blocks = 0;
    for (std::size_t begin = page.find("```cpp\n"); begin != std::string::npos;
         begin = page.find("```cpp\n", begin)) {
        begin += 7;
        const std::string block = page.substr(begin, page.find("```", begin) - begin);
        EXPECT_THAT(source, testing::HasSubstr(block));
        ++blocks;
    }
    EXPECT_EQ(blocks, 2);
}

}  // namespace
}  // namespace fretwork::optimization
