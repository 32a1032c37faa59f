// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/file.hpp>
#include <fretwork/pattern/census.hpp>

#include <gtest/gtest.h>

namespace fretwork::pattern {
namespace {

EnumerationOptions options_of(const NodeLayout& layout) {
    EnumerationOptions options;
    options.edges = default_edge_range(layout);
    return options;
}

// data/table1.csv is the paper's Table 1.
TEST(Census, IsThePapersTable1ByteForByte) {
    const NodeLayout layout = find_node_layout("paper7");
    const Census census = take_census(layout, options_of(layout));
    EXPECT_EQ(census_csv(census), base::read_text_file(FRETWORK_SOURCE_DIR "/tests/pattern/data/table1.csv"));
    EXPECT_EQ(census.valid(), 1824u);
}

}  // namespace
}  // namespace fretwork::pattern
