// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/file.hpp>
#include <fretwork/pattern/census.hpp>

#include <gtest/gtest.h>

#include <filesystem>

namespace fretwork::pattern {
namespace THIS_TEST {

const std::filesystem::path kFolder = FRETWORK_SOURCE_DIR "/experiments/layouts";

TEST(Layouts, AreTheSameByNameAndByFile) {
    for (const std::string& name : layout_names()) {
        const NodeLayout by_name = find_node_layout(name);
        const NodeLayout by_file = find_node_layout((kFolder / (name + ".json")).string());
        EXPECT_EQ(by_name.name(), by_file.name());
        EXPECT_TRUE(std::equal(by_name.candidate_edges().begin(), by_name.candidate_edges().end(),
                               by_file.candidate_edges().begin(), by_file.candidate_edges().end()));
    }
}

TEST(Layouts, OfTheFolderAreAllKnownByName) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder))
        files += entry.path().extension() == ".json";
    EXPECT_EQ(files, layout_names().size());
}

TEST(Layouts, OnlyThoseThatAreBuiltInHaveNames) {
    for (const std::string& name : layout_names()) EXPECT_TRUE(is_layout_name(name)) << name;
    EXPECT_FALSE(is_layout_name("paper7.json"));
    EXPECT_FALSE(is_layout_name(""));
}

// The files beside the layouts: what their page shows.
TEST(Layouts, HaveTheCensusThatLiesBesideThem) {
    for (const std::string& name : layout_names()) {
        if (name == "fifths12") continue;  // seconds; its total is in enumerate_test
        const NodeLayout layout = find_node_layout(name);
        EnumerationOptions options;
        options.edges = default_edge_range(layout);
        EXPECT_EQ(census_csv(take_census(layout, options)), base::read_text_file(kFolder / (name + ".csv")))
            << name;
    }
}

// 312,906 is the count of an independent program.
TEST(Layouts, QuartersHave312906Patterns) {
    EXPECT_EQ(count_patterns(find_node_layout("quarters10")).total(), 312906u);
}

}  // namespace THIS_TEST
}  // namespace fretwork::pattern
