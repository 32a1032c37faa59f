// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/design/target/target_file.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::design {
namespace THIS_TEST {

using test::complaint_of;
using testing::AllOf;
using testing::HasSubstr;

const char* const kEveryKind = R"({ "format": "fretwork/target/1", "name": "arc", "description": "all kinds",
  "goals": [
    { "nodes": [3, 4], "displacements": [[0, null, 0.01], [null, null, 0.02]], "weight": 2 },
    { "nodes": [5], "positions": [[0.1, 0.2, 0.03]], "case": "snow" },
    { "select": { "side": "right" }, "displacement": ["0.1*x", null, 0.05] },
    { "select": { "box": [0, 0, 1, 1] }, "surface": "dome.obj" },
    { "select": { "nearest": [[0.1, 0.1]] }, "rotation": [0, null, 0.2] } ] })";

TEST(TargetFile, ReadsEveryKindOfGoal) {
    const Target target = parse_target(kEveryKind, "target.json");
    ASSERT_EQ(target.goals.size(), 5U);
    const auto& nodes = std::get<NodesGoal>(target.goals[0].what);
    EXPECT_EQ(nodes.nodes, (std::vector<int>{3, 4}));
    EXPECT_FALSE(nodes.values[0][1]);
    EXPECT_EQ(nodes.values[1][2], 0.02);
    EXPECT_EQ(target.goals[0].weight, 2.0);
    EXPECT_EQ(std::get<NodesGoal>(target.goals[1].what).quantity, NodesGoal::Quantity::Positions);
    EXPECT_EQ(target.goals[1].load_case, "snow");
    EXPECT_EQ(std::get<FormulaGoal>(target.goals[2].what).displacement[0], "0.1*x");
    EXPECT_EQ(std::get<MeshGoal>(target.goals[3].what).mesh, "dome.obj");
    EXPECT_EQ(std::get<RotationGoal>(target.goals[4].what).rotation[2], 0.2);
}

TEST(TargetFile, IsTheSameAfterWritingAndReading) {
    const Target target = parse_target(kEveryKind, "target.json");
    EXPECT_EQ(parse_target(target_text(target), "again"), target);
    const test::TemporaryFolder folder;
    write_target(target, folder.path() / "target.json");
    Target read = read_target(folder.path() / "target.json");
    EXPECT_EQ(std::get<MeshGoal>(read.goals[3].what).mesh, folder.path() / "dome.obj")
        << "meshes lie beside the file";
    read.goals[3] = target.goals[3];
    EXPECT_EQ(read, target);
}

TEST(TargetFile, KeepsCirclesInItsSecondFormat) {
    std::string text = R"({"format": "fretwork/target/2", "goals": [
        {"select": {"circle": {"center": [0.1, 0.2], "radius": 0.05}}, "displacement": [null, null, 0.01]}]})";
    const Target target = parse_target(text, "target.json");
    EXPECT_EQ(std::get<FormulaGoal>(target.goals[0].what).where,
              simulation::Selection(simulation::NodesInCircle{{0.1, 0.2}, 0.05}));
    EXPECT_THAT(target_text(target), HasSubstr("fretwork/target/2"));
    EXPECT_EQ(parse_target(target_text(target), "again"), target);
    text.replace(text.find("target/2"), 8, "target/1");
    EXPECT_THAT(complaint_of([&] { (void)parse_target(text, "target.json"); }),
                HasSubstr("no circle; fretwork/target/2 has"));
    EXPECT_THAT(target_text(parse_target(kEveryKind, "target.json")), HasSubstr("fretwork/target/1"));
}

std::string complaint_about(const std::string& goals) {
    return complaint_of([&] {
        (void)parse_target(R"({"format": "fretwork/target/1", "goals": [)" + goals + "]}", "t.json");
    });
}

TEST(TargetFile, RefusesFormulasAndMeshesThatNoDesignCanTake) {
    for (const char* formula : {"x+", "", "z"})
        EXPECT_THAT(complaint_about(R"({"select": {"side": "left"}, "displacement": [null, ")" +
                                    std::string(formula) + R"(", null]})"),
                    HasSubstr("t.json: /goals/0/displacement/1: '" + std::string(formula) + "': "));
    // Not finite at the origin, where no node may lie.
    EXPECT_NO_THROW((void)parse_target(R"({"format": "fretwork/target/1", "goals": [
        {"select": {"side": "left"}, "displacement": ["1/x", null, null]}]})",
                                       "t.json"));
    for (const char* mesh : {"", "x.txt"})
        EXPECT_THAT(
            complaint_about(R"({"select": {"side": "left"}, "surface": ")" + std::string(mesh) + "\"}"),
            AllOf(HasSubstr("t.json: /goals/0/surface: "),
                  HasSubstr("a mesh is an .obj, .ply or .off file")));
}

TEST(TargetFile, RefusesBadInputWithItsPlace) {
    EXPECT_THAT(complaint_about(""), HasSubstr("/goals"));
    EXPECT_THAT(complaint_about(R"({"weight": 1})"), HasSubstr("names no nodes"));
    EXPECT_THAT(complaint_about(R"({"nodes": [], "displacements": []})"), HasSubstr("/goals/0/nodes"));
    EXPECT_THAT(complaint_about(R"({"nodes": [1, 2], "displacements": [[0, 0, 0]]})"),
                HasSubstr("/goals/0/displacements"));
    EXPECT_THAT(complaint_about(R"({"nodes": [1]})"), HasSubstr("either displacements or positions"));
    EXPECT_THAT(complaint_about(R"({"nodes": [1], "displacements": [[null, null, null]]})"),
                HasSubstr("asks for nothing"));
    EXPECT_THAT(complaint_about(R"({"nodes": [1], "displacements": [[0, 0, 1e300]]})"), HasSubstr("1e+300"));
    EXPECT_THAT(complaint_about(R"({"nodes": [-1], "displacements": [[0, 0, 0]]})"), HasSubstr("-1"));
    EXPECT_THAT(complaint_about(R"({"select": {"side": "up"}, "displacement": [0, 0, 0]})"),
                HasSubstr("/goals/0/select/side"));
    EXPECT_THAT(complaint_about(R"({"select": {"side": "left"}})"), HasSubstr("exactly one of"));
    EXPECT_THAT(complaint_about(R"({"select": {"side": "left"}, "displacement": [true, null, null]})"),
                HasSubstr("an expression of x and y"));
    EXPECT_THAT(complaint_about(R"({"select": {"side": "left"}, "displacement": [0, 0, 0], "weight": 0})"),
                HasSubstr("/goals/0/weight"));
    EXPECT_THAT(
        complaint_about(R"({"select": {"side": "left"}, "displacement": [0, 0, 0], "weight": 1e-320})"),
        HasSubstr("/goals/0/weight: is"));
    EXPECT_THAT(complaint_about(R"({"select": {"side": "left"}, "displacement": [0, 0, 1e9]})"),
                HasSubstr("/goals/0/displacement/2"));
    EXPECT_THAT(complaint_about(R"({"select": {"side": "left"}, "rotation": [0, 3.2, null]})"),
                HasSubstr("/goals/0/rotation: is a rotation vector of 3.2 rad"));
    EXPECT_THAT(complaint_about(R"({"select": {"side": "left"}, "displacement": [0, 0, 0], "wieght": 1})"),
                HasSubstr("wieght"));
    EXPECT_THAT(complaint_of([] { (void)parse_target(R"({"format": "fretwork/target/9"})", "t.json"); }),
                HasSubstr("t.json"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::design
