// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/base/text.hpp>

#include <cstdlib>

namespace fretwork::base {
namespace {

TEST(FormatNumber, ReadsBackAsTheSameDouble) {
    for (const double value : {0.1, 1.0 / 3.0, 6.02214076e23, 5e-324, -0.0, 123456789.0}) {
        EXPECT_EQ(std::strtod(format_number(value).c_str(), nullptr), value);
    }
    EXPECT_EQ(format_number(0.1), "0.1");
}

TEST(Split, IsUndoneByJoin) {
    for (const std::string text : {"", "a", "a,b", ",a,,b,"}) EXPECT_EQ(join(split(text, ','), ","), text);
}

TEST(NearestName, FindsASlipOfThePenAndNothingFar) {
    const std::vector<std::string> names = {"bending", "dome", "saddle"};
    EXPECT_EQ(nearest_name("bendign", names), "bending");
    EXPECT_EQ(nearest_name("sadle", names), "saddle");
    EXPECT_EQ(nearest_name("torsion", names), std::nullopt);
    EXPECT_EQ(nearest_name("x", {}), std::nullopt);
}

}  // namespace
}  // namespace fretwork::base
