// SPDX-License-Identifier: GPL-3.0-or-later
// solve as its user runs it.
#include "cli/command.hpp"
#include "support.hpp"

#include <regex>

namespace fretwork::app {
namespace THIS_TEST {

using test::run_command;
using test::TemporaryFolder;
using testing::HasSubstr;

class Solve : public testing::Test {
  protected:
    Solve() {
        folder_.file("column.json", R"({"format": "fretwork/frame/1", "nodes": [[0, 0, 0], [0, 0, 1]],
            "materials": {"m": {"young_modulus": 1e9, "poisson_ratio": 0.3, "density": 1000}},
            "sections": {"s": {"type": "rectangle", "width": 0.01, "height": 0.02}},
            "beams": [{"nodes": [0, 1], "section": "s", "material": "m", "divisions": 8}],
            "supports": [{"node": 0, "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}],
            "loads": [{"node": 1, "force": [0.01, 0, -1]}]})");
    }
    test::Outcome run(const std::string& options) {
        auto outcome = run_command("fretwork solve column.json --out r.json " + options, folder_.path());
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return outcome;
    }
    /// The result but for the time that it took.
    std::string result(const std::string& options) {
        run(options);
        return std::regex_replace(base::read_text_file(folder_.path() / "r.json"),
                                  std::regex(R"("seconds": *[^,}]*)"), "");
    }
    TemporaryFolder folder_;
};

TEST_F(Solve, GivesTheSameResultOnAnyNumberOfThreads) {
    for (const std::string solver : {"--solver linear", "--solver newton --steps 3"})
        EXPECT_EQ(result(solver + " --threads 1"), result(solver + " --threads 3"));
}

// E I / L^2 pi^2 / 4 = 4.11 N and four times as much, about the two axes; and no loads in the reversed sense.
TEST_F(Solve, SaysWhenThereAreFewerBucklingLoadsThanWanted) {
    const auto outcome = run("--solver linear --buckling 1000");
    EXPECT_THAT(outcome.out, HasSubstr("buckling load 1: 4.11"));
    EXPECT_THAT(outcome.out, HasSubstr("buckling load 2: 16.4"));
    EXPECT_THAT(outcome.out, HasSubstr("no more than "));
}

// Two strips that meet 6 mm above their clamped ends, pressed down there, and held upright.
TEST_F(Solve, NamesTheLimitLoadWithItsPlaceAndWhatHelps) {
    folder_.file("arch.json",
                 R"({"format": "fretwork/frame/1", "nodes": [[0, 0, 0], [0.2, 0, 0.006], [0.4, 0, 0]],
        "materials": {"m": {"young_modulus": 1e9, "poisson_ratio": 0.3}},
        "sections": {"s": {"type": "rectangle", "width": 0.02, "height": 0.002}},
        "beams": [{"nodes": [0, 1], "section": "s", "material": "m", "divisions": 8},
                  {"nodes": [1, 2], "section": "s", "material": "m", "divisions": 8}],
        "supports": [{"node": 0, "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]},
                     {"node": 1, "fixed": ["uy", "rx", "ry", "rz"]},
                     {"node": 2, "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}],
        "loads": [{"node": 1, "force": [0, 0, -10]}]})");
    const auto stopped = run_command("fretwork solve arch.json --out r.json", folder_.path());
    EXPECT_EQ(stopped.exit_code, 1);
    EXPECT_THAT(stopped.out, HasSubstr("limit load at 0."));
    EXPECT_THAT(stopped.out, HasSubstr("(node 1 along uz); --branch snapping looks beyond it"));
    EXPECT_EQ(
        run_command("fretwork solve arch.json --branch snapping --out r.json", folder_.path()).exit_code, 0);
}

TEST_F(Solve, AnswersForModesOfWhatIsNotLoadedOrCannotMove) {
    std::string frame = base::read_text_file(folder_.path() / "column.json");
    frame.replace(frame.find("\"node\": 1, \"force\""), 9, "\"node\": 0");
    folder_.file("column.json", frame);
    EXPECT_THAT(run("--buckling 2").out, HasSubstr("no buckling load: nothing is loaded"));
    EXPECT_THAT(run("--buckling 2 --json").out, HasSubstr("\"buckling_load_factors\": []"));
    frame.replace(frame.find("\"divisions\": 8"), 14, "\"divisions\": 1");
    folder_.file("column.json", frame);
    EXPECT_THAT(run("--modes 20").out, HasSubstr("no more than 6 natural frequencies"));
    frame.insert(frame.find("{\"node\": 0, \"fixed\""),
                 R"({"node": 1, "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}, )");
    folder_.file("column.json", frame);
    EXPECT_THAT(run("--modes 1").out, HasSubstr("no natural frequency: everything that has mass is held"));
}

TEST_F(Solve, NamesTheNodesOfADeckByTheirLabels) {
    folder_.file("turned.inp",
                 "*NODE\n11,0,0,0\n22,1,0,0\n*ELEMENT,TYPE=B31,ELSET=E\n1,11,22\n"
                 "*MATERIAL,NAME=M\n*ELASTIC\n1e9,0.3\n"
                 "*BEAM SECTION,SECTION=RECT,ELSET=E,MATERIAL=M\n0.01,0.02\n0,0,1\n"
                 "*STEP\n*STATIC\n*BOUNDARY\n11,1,6\n22,4,4,4.0\n*END STEP\n");
    const auto outcome =
        run_command("fretwork solve turned.inp --solver dynamic-relaxation --out r.json", folder_.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("node 22 is prescribed to turn by 4"));
}

TEST_F(Solve, NamesTheFileOfAMechanism) {
    folder_.file("loose.json", R"({"format": "fretwork/frame/1", "nodes": [[0, 0, 0], [0, 0, 1], [0, 0, 2]],
        "materials": {"m": {"young_modulus": 1e9, "poisson_ratio": 0.3}},
        "sections": {"s": {"type": "rectangle", "width": 0.01, "height": 0.02}},
        "beams": [{"nodes": [0, 1], "section": "s", "material": "m"},
                  {"nodes": [1, 2], "section": "s", "material": "m", "releases": [{"end": 0, "free": ["ry"]}]}],
        "supports": [{"node": 0, "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}]})");
    const auto outcome = run_command("fretwork solve loose.json --out r.json", folder_.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("loose.json: the structure, as held, can move without strain at "));
    // What no deck can hold is refused before the solution.
    const auto before = run_command("fretwork solve loose.json --deck d.inp --out r.json", folder_.path());
    EXPECT_EQ(before.exit_code, 2);
    EXPECT_THAT(before.err, HasSubstr("loose.json: /beams/1 has releases, which an input deck"));
}

TEST_F(Solve, WritesNoResultThatItDoesNotRead) {
    std::string frame = base::read_text_file(folder_.path() / "column.json");
    frame.replace(frame.find("1e9"), 3, "1e-12");
    folder_.file("soft.json", frame);
    const auto outcome = run_command("fretwork solve soft.json --solver linear --out r.json", folder_.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, HasSubstr("soft.json: the largest displacement is "));
    EXPECT_THAT(outcome.err, HasSubstr("the load or a stiffness is out of any sensible range"));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "r.json"));
}

TEST_F(Solve, WritesModesForParaView) {
    run("--solver linear --modes 2 --vtu r.vtu");
    const std::string file = base::read_text_file(folder_.path() / "r.vtu");
    EXPECT_THAT(file, HasSubstr("Name=\"displacement\""));
    EXPECT_THAT(file, HasSubstr("Name=\"vibration 2, "));
}

}  // namespace THIS_TEST
}  // namespace fretwork::app
