// SPDX-License-Identifier: GPL-3.0-or-later
#include "honeycomb.hpp"
#include "support.hpp"

#include <fretwork/base/text.hpp>

#include <regex>

namespace fretwork::simulation {
namespace {

using test::complaint_of;
using test::honeycomb;
using test::TemporaryFolder;
using testing::HasSubstr;

Project example() {
    Project project = honeycomb(3, 2, {"0-1+1-6", "0-6"});
    project.load_cases = {test::cantilever({0, 0, -1})};
    LoadCase other;
    other.name = "other";
    other.supports.push_back({NodesNearest{{{0.1, 0.2}}}, mechanics::DofSet::translations()});
    other.loads.push_back({NodesInBox{{0, 0, 1, 1}}, {1, 0, 0}, {0, 2, 0}, LoadCase::Amount::Each});
    other.prescribed.push_back({NodesById{{1, 2}}, mechanics::Dof::uz, 0.01});
    other.gravity = {0, 0, -9.81};
    project.load_cases.push_back(other);
    return project;
}

TEST(ProjectFile, WritingWhatWasReadGivesTheSameFile) {
    const TemporaryFolder folder;
    write_project(example(), folder.path() / "a.json");
    const Project read = read_project(folder.path() / "a.json");
    write_project(read, folder.path() / "b.json");
    EXPECT_EQ(base::read_text_file(folder.path() / "a.json"), base::read_text_file(folder.path() / "b.json"));
    EXPECT_EQ(read.tessellation.tiles.size(), 6U);
    EXPECT_EQ(read.load_cases.size(), 2U);
    EXPECT_EQ(read.load_cases[1].gravity, Eigen::Vector3d(0, 0, -9.81));
}

TEST(ProjectFile, KeepsItsLibrary) {
    const TemporaryFolder folder;
    Project project = example();
    project.library_path = "lib.db";
    project.library_hash = "abc";
    write_project(project, folder.path() / "a.json");
    EXPECT_EQ(read_project(folder.path() / "a.json").library_path, "lib.db");
    EXPECT_EQ(read_project(folder.path() / "a.json").library_hash, "abc");
}

/// The complaint about a project file in which the first match of `what` is replaced.
std::string complaint_after(const std::string& what, const std::string& replacement) {
    const TemporaryFolder folder;
    write_project(example(), folder.path() / "a.json");
    const std::string text = base::read_text_file(folder.path() / "a.json");
    const std::string changed =
        std::regex_replace(text, std::regex(what), replacement, std::regex_constants::format_first_only);
    EXPECT_NE(changed, text) << what;
    base::write_file_atomically(folder.path() / "a.json", changed);
    return complaint_of([&] { read_project(folder.path() / "a.json"); });
}

TEST(ProjectFile, RefusesWhatDoesNotFitTogether) {
    EXPECT_THAT(complaint_after("\"load_cases\"", "\"loadcases\""), HasSubstr("unknown key 'loadcases'"));
    EXPECT_THAT(complaint_after("\"0-6\"", "\"0-3\""), HasSubstr("/tessellation/patterns/1"));
    EXPECT_THAT(complaint_after("\"pattern\": 1", "\"pattern\": 7"), HasSubstr("/tessellation"));
    EXPECT_THAT(complaint_after("\"vertices\": \\[0", "\"vertices\": [4000"), HasSubstr("/tessellation"));
    EXPECT_THAT(complaint_after("\"interface_nodes\": \\[0", "\"interface_nodes\": [3"),
                HasSubstr("/tessellation"));
    EXPECT_THAT(complaint_after("\"other\"", "\"cantilever\""), HasSubstr("the name of two load cases"));
    EXPECT_THAT(complaint_after("fretwork/project/1", "fretwork/project/9"),
                HasSubstr("\"fretwork/project/1\" is needed"));
    EXPECT_THAT(complaint_after("\"1/3\"", "\"1/0\""), HasSubstr("/layout"));
}

TEST(FindLoadCase, TakesTheOnlyOneAndAsksAmongSeveral) {
    Project project = example();
    EXPECT_EQ(find_load_case(project, "other").name, "other");
    EXPECT_THAT(complaint_of([&] { find_load_case(project, ""); }), HasSubstr("cantilever, other"));
    EXPECT_THAT(complaint_of([&] { find_load_case(project, "cantilver"); }),
                HasSubstr("did you mean 'cantilever'?"));
    project.load_cases.pop_back();
    EXPECT_EQ(find_load_case(project, "").name, "cantilever");
    project.load_cases.pop_back();
    EXPECT_THAT(complaint_of([&] { find_load_case(project, ""); }), HasSubstr("fretwork case add"));
}

}  // namespace
}  // namespace fretwork::simulation
