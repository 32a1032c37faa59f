// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/base/named.hpp>

namespace fretwork::base {
namespace THIS_TEST {

struct Row {
    std::string name;
    int value;
};
const std::vector<Row> kRows = {{"newton", 1}, {"linear", 2}};

TEST(Named, RowsAreFoundByTheirNames) {
    EXPECT_EQ(&find_named("linear", kRows, &Row::name, "solver"), &kRows[1]);
    EXPECT_EQ(names_of(kRows, &Row::name), (std::vector<std::string>{"newton", "linear"}));
}

TEST(Named, ForAnUnknownNameTheNearestIsSuggested) {
    EXPECT_EQ(test::complaint_of([] { (void)find_named("liner", kRows, &Row::name, "solver"); }),
              "unknown solver 'liner'; did you mean 'linear'?");
}

}  // namespace THIS_TEST
}  // namespace fretwork::base
