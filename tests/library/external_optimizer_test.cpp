// SPDX-License-Identifier: GPL-3.0-or-later
// An optimizer from outside of the library calibrates a library.
#include "../optimization/evolution_strategy.hpp"
#include "sample.hpp"

#include <fretwork/library/fill.hpp>

namespace fretwork::library {
namespace THIS_TEST {

using namespace test;
using testing::HasSubstr;

/// The built-in rows and the one from outside.
const std::vector<optimization::OptimizerRow>& optimizers() {
    static const std::vector<optimization::OptimizerRow> rows = [] {
        const auto built_in = optimization::optimizer_catalogue();
        std::vector<optimization::OptimizerRow> all(built_in.begin(), built_in.end());
        all.push_back(own::kEvolutionStrategy);
        return all;
    }();
    return rows;
}

reduction::Calibration calibrated(const TemporaryFolder& folder, const std::string& optimizer) {
    const std::string id = "0-1+1-6";
    auto library =
        Library::create(folder.path() / (optimizer + ".db"), paper_layout(), reduction::paper_setting());
    library.add_patterns(parse({id}));
    FillOptions options;
    options.calibration.optimizer = optimizer;
    options.calibration.optimizers = optimizers();
    options.calibration.starts = 2;
    EXPECT_EQ(fill(library, library.patterns(), options).done, 1U);
    return *library.best_fit(id);
}

// Its steps end at 1e-5 of the range of each parameter, which leaves less than a hundredth of E.
TEST(ExternalOptimizer, CalibratesALibraryAsWellAsABuiltInOne) {
    const TemporaryFolder folder;
    const reduction::Calibration found = calibrated(folder, "evolution-strategy");
    EXPECT_EQ(found.optimizer, "evolution-strategy");
    EXPECT_EQ(found.parameters.size(), 6U);
    const reduction::Calibration best = calibrated(folder, "ceres-multistart");
    EXPECT_GE(found.objective, best.objective * (1.0 - 1e-6));
    EXPECT_LE(found.objective, best.objective * 1.01);
}

TEST(ExternalOptimizer, IsKnownOnlyWhereItsRowsArePassed) {
    FillOptions options;
    options.calibration.optimizer = "evolution-strategy";
    EXPECT_THAT(complaint_of([&] { options.validate(); }), HasSubstr("ceres-multistart"));
    options.calibration.optimizers = optimizers();
    EXPECT_NO_THROW(options.validate());
}

}  // namespace THIS_TEST
}  // namespace fretwork::library
