// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"
#include "support.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/decks/calculix_file.hpp>
#include <fretwork/mechanics/linear_solver.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>

namespace fretwork::mechanics {
namespace THIS_TEST {

class CalculixFile : public testing::Test {
  protected:
    LabelledFrame read(const std::string& text) {
        std::ofstream(path_) << text;
        return read_calculix(path_);
    }
    /// kDeck with something in place of a piece of it, and after it.
    LabelledFrame changed(const std::string& piece, const std::string& by, const std::string& after = "");
    std::string complaint(const std::string& piece, const std::string& by);
    /// The forces on kDeck's tip after a second step.
    Eigen::Vector3d force_after(const std::string& second_step);
    test::TemporaryFolder folder_;
    std::filesystem::path path_ = folder_.path() / "deck.inp";
};

// Two elements of CalculiX's kinds, sets, a generated list, and keywords that only steer the solver.
constexpr const char* kDeck = R"(*HEADING
a cantilever of two elements
** a comment
*Node, nset=Nall
10, 0., 0., 0.
20, 0.5, 0, 0
30, 1e0, 0, 0
40, 1.5, 0.,
*ELEMENT, TYPE=B32R, ELSET=EBEAM
1, 10, 20,
30
*ELEMENT, TYPE=B31, ELSET=EBEAM
2, 30, 40
*NSET, NSET=TIP
40
*NSET, NSET=MOST, GENERATE
10, 30, 20
*MATERIAL, NAME=PLA
*ELASTIC
1.E9, .25
*DENSITY
1240
*BEAM SECTION, ELSET=EBEAM, MATERIAL=PLA, SECTION=RECT
.02, .01
0., 0., 1.
*BOUNDARY
10, 1, 6
TIP, 2, 2, 0.003
*ELSET, ELSET=EALL
EBEAM
*STEP, NLGEOM
*STATIC
*CLOAD
TIP, 3, -2.5
TIP, 5, 0.5
*DLOAD
EALL, GRAV, 9.81, 0, 0, -1
*NODE FILE
U
*END STEP
)";

LabelledFrame CalculixFile::changed(const std::string& piece, const std::string& by,
                                    const std::string& after) {
    std::string text = kDeck;
    const auto place = text.find(piece);
    EXPECT_NE(place, std::string::npos) << piece;
    return read(text.replace(place, piece.size(), by) + after);
}

Eigen::Vector3d CalculixFile::force_after(const std::string& second_step) {
    const Frame frame = changed("", "", "*STEP\n*STATIC\n" + second_step + "*END STEP\n").frame;
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (const NodalLoad& load : frame.loads) {
        if (load.node == NodeIndex(3)) force += load.force;
    }
    return force;
}

std::string CalculixFile::complaint(const std::string& piece, const std::string& by) {
    try {
        changed(piece, by);
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "";
}

TEST_F(CalculixFile, ReadsBeamsOfDeck) {
    const auto [frame, labels, source] = read(kDeck);
    EXPECT_THAT(labels, testing::ElementsAre(10, 20, 30, 40));
    ASSERT_EQ(frame.beams.size(), 3u);  // the middle node of the three-node element is a node
    EXPECT_EQ(frame.beams[1].nodes[0], NodeIndex(1));
    EXPECT_EQ(frame.beams[2].nodes[1], NodeIndex(3));
    EXPECT_EQ(frame.beams[0].section,
              rectangle_section(0.01, 0.02));  // n1, along which it is 20 mm, is axis 3
    EXPECT_EQ(frame.beams[0].material,
              (Material{.young_modulus = 1e9, .poisson_ratio = 0.25, .density = 1240}));
    ASSERT_EQ(frame.supports.size(), 1u);
    EXPECT_EQ(frame.supports[0].fixed, DofSet::all());
    ASSERT_EQ(frame.prescribed.size(), 1u);
    EXPECT_EQ(frame.prescribed[0].dof, Dof::uy);
    EXPECT_EQ(frame.prescribed[0].value, 0.003);
    ASSERT_EQ(frame.loads.size(), 1u);
    EXPECT_EQ(frame.loads[0].force, Eigen::Vector3d(0.0, 0.0, -2.5));
    EXPECT_EQ(frame.loads[0].moment, Eigen::Vector3d(0.0, 0.5, 0.0));
    EXPECT_EQ(frame.gravity, Eigen::Vector3d(0.0, 0.0, -9.81));
}

TEST_F(CalculixFile, WrittenFrameIsReadBack) {
    Frame frame = sample::star();
    frame.beams[1].section = rectangle_section(0.003, 0.002);
    frame.beams[2].normal = Eigen::Vector3d(0.3, 0.1, 1.0);
    frame.prescribed.push_back({NodeIndex(0), Dof::uz, 1.0 / 3.0e3});
    frame.gravity = {0.1, 0.0, -9.81};
    write_calculix(frame, path_);
    const Frame found = read_calculix(path_).frame;
    ASSERT_EQ(found.beams.size(), frame.beams.size());
    for (std::size_t i = 0; i < frame.beams.size(); ++i) {
        const Section& section = frame.beams[i].section;
        EXPECT_NEAR(found.beams[i].section.area, section.area, 1e-13 * section.area);
        EXPECT_NEAR(found.beams[i].section.I2, section.I2, 1e-13 * section.I2);
        EXPECT_NEAR(found.beams[i].section.I3, section.I3, 1e-13 * section.I3);
        EXPECT_NEAR(found.beams[i].section.J, section.J, 1e-13 * section.J);
        EXPECT_EQ(found.beams[i].material, frame.beams[i].material);
    }
    const Solution expected = solve_linear(assemble(frame));
    const Solution solution = solve_linear(assemble(found));
    EXPECT_LT((solution.displacements - expected.displacements).norm(),
              1e-12 * expected.displacements.norm());
}

TEST_F(CalculixFile, TextIsReadAsTheFileIs) {
    const std::string text = calculix_text(sample::star());
    EXPECT_EQ(calculix_text(parse_calculix(text, "somewhere").frame), text);
    const std::string crlf = std::regex_replace(text, std::regex("\n"), "\r\n");
    EXPECT_EQ(calculix_text(parse_calculix(crlf, "somewhere").frame), text);
    EXPECT_EQ(parse_calculix(text, "somewhere").source, "somewhere");
    try {
        parse_calculix("*NODE\n1,0,0,x\n", "somewhere");
        FAIL();
    } catch (const base::InputError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith("somewhere: line 2 "));
    }
}

TEST_F(CalculixFile, RefusesToWriteWhatADeckCannotHold) {
    Frame divided = sample::star();
    divided.beams[1].divisions = 2;
    Frame hinged = sample::star();
    hinged.beams[2].releases = {{0, {{false, false, false, true, false, false}}}};
    EXPECT_THROW(write_calculix(divided, path_), base::InputError);
    EXPECT_THROW(write_calculix(hinged, path_), base::InputError);
    EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(CalculixFile, ForcesWithinOneStepAddUp) {
    EXPECT_EQ(changed("TIP, 3, -2.5", "TIP, 3, -2.5\n40, 3, -0.5").frame.loads[0].force.z(), -3.0);
    EXPECT_EQ(changed("TIP, 3, -2.5", "TIP, 3, -2.5\n*CLOAD\n40, 3, -0.5").frame.loads[0].force.z(), -3.0);
}

TEST_F(CalculixFile, ForceOfLaterStepReplacesEarlier) {
    EXPECT_EQ(force_after(""), Eigen::Vector3d(0, 0, -2.5));
    EXPECT_EQ(force_after("*CLOAD\nTIP, 3, -4\n"), Eigen::Vector3d(0, 0, -4));
    EXPECT_EQ(force_after("*CLOAD, OP=MOD\nTIP, 2, 1\n"), Eigen::Vector3d(0, 1, -2.5));
    EXPECT_EQ(force_after("*CLOAD, OP=NEW\nTIP, 2, 1\n"), Eigen::Vector3d(0, 1, 0));
    EXPECT_EQ(force_after("*CLOAD\nTIP, 2, 1\n*CLOAD, OP=NEW\nTIP, 2, 1\n"), Eigen::Vector3d(0, 2, -2.5));
    EXPECT_EQ(force_after("*CLOAD\nTIP, 3, 0\n"), Eigen::Vector3d(0, 0, 0));
}

TEST_F(CalculixFile, DisplacementOfLaterStepReplacesEarlier) {
    const auto after = [&](const std::string& cards) { return changed("", "", "*STEP\n" + cards).frame; };
    Frame frame = after("*BOUNDARY\n40, 2, 2, 0.004\n");
    ASSERT_EQ(frame.prescribed.size(), 1u);
    EXPECT_EQ(frame.prescribed[0].value, 0.004);
    frame = after("*BOUNDARY\n40, 2\n10, 3, 3, 0.001\n");  // held at rest, and moved where it was held
    ASSERT_EQ(frame.prescribed.size(), 1u);
    EXPECT_EQ(frame.prescribed[0].node, NodeIndex(0));
    ASSERT_EQ(frame.supports.size(), 2u);
    EXPECT_EQ(frame.supports[0].fixed, (DofSet{{true, true, false, true, true, true}}));
    EXPECT_EQ(frame.supports[1].fixed, (DofSet{{false, true, false, false, false, false}}));
    frame = after("*BOUNDARY, OP=NEW\n40, 1, 6\n");
    EXPECT_TRUE(frame.prescribed.empty());
    ASSERT_EQ(frame.supports.size(), 1u);
    EXPECT_EQ(frame.supports[0].node, NodeIndex(3));
}

TEST_F(CalculixFile, GravityOfLaterStepReplacesSameDirection) {
    const auto after = [&](const std::string& cards) {
        return changed("", "", "*STEP\n" + cards).frame.gravity;
    };
    EXPECT_EQ(after("*DLOAD\nEALL, GRAV, 1.62, 0, 0, -2\n"), Eigen::Vector3d(0, 0, -1.62));
    EXPECT_EQ(after("*DLOAD\nEALL, GRAV, 1.62, 1, 0, 0\n"), Eigen::Vector3d(1.62, 0, -9.81));
    EXPECT_EQ(after("*DLOAD, OP=NEW\nEALL, GRAV, 1.62, 1, 0, 0\n"), Eigen::Vector3d(1.62, 0, 0));
}

TEST_F(CalculixFile, SetHoldsEachNodeOnce) {
    const Frame frame = changed("*NSET, NSET=TIP\n40", "*NSET, NSET=TIP\n40, 40\n*NSET, NSET=TIP\n40").frame;
    ASSERT_EQ(frame.loads.size(), 1u);
    EXPECT_EQ(frame.loads[0].force.z(), -2.5);
}

TEST_F(CalculixFile, CircleTakesOneNumberAsRadiusAndTwoAsDiameter) {
    const auto circle = [&](const std::string& size) {
        return changed("SECTION=RECT\n.02, .01", "SECTION=CIRC\n" + size).frame.beams[0].section;
    };
    EXPECT_EQ(circle("0.02"), circle_section(0.04));
    EXPECT_EQ(circle("0.02, 0.02"), circle_section(0.02));
    EXPECT_THAT(complaint("SECTION=RECT\n.02, .01", "SECTION=CIRC\n.02, .01"),
                testing::AllOf(testing::HasSubstr("line 24"), testing::HasSubstr("no ellipse")));
}

TEST_F(CalculixFile, ReadsFortranExponents) {
    EXPECT_EQ(changed("1.E9, .25", "1.0D9, 2.5d-1").frame.beams[0].material,
              (Material{.young_modulus = 1e9, .poisson_ratio = 0.25, .density = 1240}));
}

TEST_F(CalculixFile, RefusesUnknownParametersByName) {
    using testing::HasSubstr;
    const auto refuses = [&](const std::string& card, const std::string& parameter, const std::string& name) {
        EXPECT_THAT(complaint("\n" + card, "\n" + card + ", " + parameter),
                    testing::AllOf(HasSubstr(name), HasSubstr("not understood")))
            << card << parameter;
    };
    refuses("*CLOAD", "FOLLOWER", "(*CLOAD) has the parameter FOLLOWER");
    refuses("*CLOAD", "AMPLITUDE=A1", "AMPLITUDE");
    refuses("*CLOAD", "OP=OLD", "OP=OLD");
    refuses("*DLOAD", "AMPLITUDE=A1", "AMPLITUDE");
    refuses("*BOUNDARY", "TYPE=VELOCITY", "TYPE=VELOCITY");
    refuses("*BOUNDARY", "AMPLITUDE=A1", "AMPLITUDE");
    refuses("*BOUNDARY", "FIXED", "FIXED");
    refuses("*BEAM SECTION", "OFFSET1=0.5", "OFFSET1");
    refuses("*BEAM SECTION", "ORIENTATION=O", "ORIENTATION");
    refuses("*ELASTIC", "TYPE=ENGINEERING CONSTANTS", "TYPE=ENGINEERINGCONSTANTS");
    refuses("*ELASTIC", "DEPENDENCIES=1", "DEPENDENCIES");
    refuses("*DENSITY", "DEPENDENCIES=1", "DEPENDENCIES");
    refuses("*STEP", "PERTURBATION", "PERTURBATION");
    refuses("*Node", "SYSTEM=C", "SYSTEM");
    refuses("*ELEMENT", "OFFSET=1", "OFFSET");
    refuses("*NSET", "INSTANCE=I", "INSTANCE");
    EXPECT_EQ(complaint("*ELASTIC\n", "*ELASTIC, TYPE=ISO\n"), "");
    EXPECT_EQ(complaint("*BOUNDARY\n", "*BOUNDARY, TYPE=DISPLACEMENT\n"), "");
}

TEST_F(CalculixFile, CommaAfterTheLastNodeDoesNotJoinTwoElements) {
    for (const std::string comma : {"", ",", ",,"}) {
        const Frame frame = changed("30\n*ELEMENT, TYPE=B31, ELSET=EBEAM\n2, 30, 40",
                                    "30" + comma + "\n*ELEMENT, TYPE=B31, ELSET=EBEAM\n2, 30, 40" + comma +
                                        "\n3, 40, 20" + comma)
                                .frame;
        ASSERT_EQ(frame.beams.size(), 4u) << comma;
        EXPECT_EQ(frame.beams[2].nodes[1], NodeIndex(3));
        EXPECT_EQ(frame.beams[3].nodes[0], NodeIndex(3));
        EXPECT_EQ(frame.beams[3].nodes[1], NodeIndex(1));
    }
    EXPECT_EQ(changed("2, 30, 40", "2,\n30,\n40").frame.beams.size(), 3u);
}

TEST_F(CalculixFile, RefusesDataThatOrientBeams) {
    using testing::HasSubstr;
    EXPECT_THAT(complaint("2, 30, 40", "2, 30, 40, 10"),
                HasSubstr("line 13 gives an element of type B31 more than a label and 2 nodes"));
    EXPECT_THAT(complaint("1, 10, 20,\n30", "1, 10, 20,\n30, 40"),
                HasSubstr("line 10 gives an element of type B32R more than a label and 3 nodes"));
    EXPECT_THAT(complaint("20, 0.5, 0, 0", "20, 0.5, 0, 0, 0, 1, 0"),
                HasSubstr("line 6 has more than a label and three coordinates"));
    EXPECT_EQ(complaint("20, 0.5, 0, 0", "20, 0.5, 0, 0,"), "");
}

TEST_F(CalculixFile, InvalidFrameIsReportedWithLabelsOfDeck) {
    using testing::HasSubstr;
    using testing::StartsWith;
    const std::string file = path_.string() + ": ";
    EXPECT_THAT(complaint("10, 1, 6", "10, 1, 3"),
                StartsWith(file + "node 10: the part of the structure at node 10"));
    EXPECT_THAT(complaint("40, 1.5, 0.,", "40, 1.5, 0.,\n50, 2, 2, 2"),
                StartsWith(file + "node 50: node 50 has no"));
    EXPECT_THAT(complaint("40, 1.5, 0.,", "40, 1., 0.,"),
                StartsWith(file + "element 2: the beam has no length"));
    EXPECT_THAT(complaint(".02, .01", ".02, -.01"), StartsWith(file + "line 24: the width of a rectangle"));
    EXPECT_THAT(complaint("SECTION=RECT\n.02, .01", "SECTION=GENERAL\n0., 1e-8, 0., 1e-8, 1e-8"),
                StartsWith(file + "element 1/section/area"));
    EXPECT_THAT(complaint("TIP, 3, -2.5", "TIP, 3, 1e40"), StartsWith(file + "node 40/force: is ("));
    EXPECT_THAT(complaint("TIP, 2, 2, 0.003", "TIP, 2, 2, 1e40"), StartsWith(file + "node 40/uy: is 1e+40"));
    EXPECT_THAT(complaint("*DENSITY\n1240", "*DENSITY\n0"),
                testing::AllOf(StartsWith(file), HasSubstr("density")));
}

TEST_F(CalculixFile, RefusesLabelsBelowOne) {
    using testing::HasSubstr;
    EXPECT_THAT(complaint("10, 0., 0., 0.", "-10, 0., 0., 0."), HasSubstr("line 5 has the label -10, where"));
    EXPECT_THAT(complaint("20, 0.5, 0, 0", "0, 0.5, 0, 0"), HasSubstr("line 6 has the label 0, where"));
    EXPECT_THAT(complaint("2, 30, 40", "-2, 30, 40"), HasSubstr("line 13 has the label -2, where"));
    EXPECT_THAT(complaint("2, 30, 40", "0, 30, 40"), HasSubstr("line 13 has the label 0, where"));
}

TEST_F(CalculixFile, GravityMustActOnAllBeamsWhereverItStands) {
    using testing::HasSubstr;
    EXPECT_THAT(complaint("EALL, GRAV", "NONE, GRAV"),
                HasSubstr("line 37 names the element set NONE, which does not exist"));
    const auto early = [](const std::string& set) {
        return "*DLOAD\n" + set + ", GRAV, 1, 1, 0, 0\n*Node, nset=Nall\n";
    };
    EXPECT_THAT(complaint("*Node, nset=Nall\n", early("NONE")),
                HasSubstr("line 5 names the element set NONE, which does not exist"));
    EXPECT_THAT(complaint("*ELSET, ELSET=EALL\nEBEAM", "*ELSET, ELSET=EALL\n1"),
                HasSubstr("line 37 lets gravity act on EALL, a part of the beams"));
    EXPECT_THAT(complaint("*ELEMENT, TYPE=B31, ELSET=EBEAM\n",
                          "*DLOAD\nEBEAM, GRAV, 1, 1, 0, 0\n*ELEMENT, TYPE=B31, ELSET=EREST\n"),
                HasSubstr("line 13 lets gravity act on EBEAM, a part of the beams"));
    EXPECT_EQ(changed("*Node, nset=Nall\n", early("EALL")).frame.gravity, Eigen::Vector3d(1.0, 0.0, -9.81));
}

/// ccx 2.20 reads a number as a label, too, even if a set has this number as its name.
TEST_F(CalculixFile, ANumberIsALabelAlsoIfASetHasThisName) {
    const std::string load = "TIP, 3, -2.5\nTIP, 5, 0.5";
    const auto loaded = [&](const std::string& by) {
        const Frame frame =
            changed("*NSET, NSET=TIP\n40", "*NSET, NSET=20\n40\n*NSET, NSET=TIP\n" + by).frame;
        EXPECT_EQ(frame.loads.size(), 1u);
        return frame.loads.at(0).node;
    };
    EXPECT_EQ(loaded("40"), NodeIndex(3));
    EXPECT_EQ(loaded("20"), NodeIndex(1)) << "as an entry of a set";
    const Frame frame = changed(load, "20, 3, -2.5\n*NSET, NSET=20\n40\n*CLOAD\n20, 3, -1").frame;
    ASSERT_EQ(frame.loads.size(), 1u);
    EXPECT_EQ(frame.loads[0].node, NodeIndex(1));
    EXPECT_EQ(frame.loads[0].force.z(), -3.5);
    EXPECT_THAT(complaint(load, "*NSET, NSET=7\n40\n*CLOAD\n7, 3, -1"),
                testing::HasSubstr("line 37 names node 7, which does not exist; a number means no node set"));
    EXPECT_EQ(changed("ELSET=EALL\nEBEAM",
                      "ELSET=EALL\nEBEAM\n*ELSET, ELSET=5\nEBEAM\n*BEAM SECTION, ELSET=5, "
                      "MATERIAL=PLA, SECTION=CIRC\n.03")
                  .frame.beams[0]
                  .section,
              circle_section(0.06))
        << "a section is always for a set";
}

TEST_F(CalculixFile, RefusesSetsWithoutNodesWhereTheyAreUsed) {
    using testing::HasSubstr;
    const std::string tip = "*NSET, NSET=TIP\n40";
    EXPECT_THAT(complaint(tip, "*NSET, NSET=TIP"), HasSubstr("names the node set TIP, which has no nodes"));
    EXPECT_THAT(complaint(tip, "*NSET, NSET=TIP\nTIP"), HasSubstr("line 15 puts the set TIP into itself"));
    EXPECT_THAT(complaint(tip, tip + "\nTIP"), HasSubstr("line 16 puts the set TIP into itself"));
    EXPECT_THAT(
        complaint(tip, "*NSET, NSET=TIP\n40, MOST"),
        HasSubstr("line 15 puts MOST into the set TIP, where labels and sets that are defined before"));
    EXPECT_THAT(complaint(tip, "*NSET, NSET=\n40"), HasSubstr("the parameter NSET without a value"));
    EXPECT_THAT(complaint("*ELSET, ELSET=EALL\nEBEAM", "*ELSET, ELSET=EALL\nEALL"),
                HasSubstr("line 30 puts the set EALL into itself"));
    EXPECT_THAT(complaint("TIP, 3, -2.5", "TOP, 3, -2.5"),
                HasSubstr("line 34 names the node set TOP, which does not exist"));
    EXPECT_THAT(complaint("TIP, 2, 2,", ", 2, 2,"), HasSubstr("line 28 names no node or node set"));
    EXPECT_EQ(complaint(tip, "*NSET, NSET=UNUSED\n" + tip), "");
}

TEST_F(CalculixFile, GravityMayNameTheOnlyElement) {
    using testing::HasSubstr;
    EXPECT_THAT(complaint("EALL, GRAV", "2, GRAV"),
                HasSubstr("line 37 lets gravity act on element 2, a part of the beams; it must act on all of "
                          "them: name a set of all"));
    EXPECT_THAT(complaint("EALL, GRAV", "3, GRAV"),
                HasSubstr("line 37 names element 3, which does not exist"));
    EXPECT_THAT(complaint("EALL, GRAV", ", GRAV"), HasSubstr("line 37 names no set of all elements"));
    const std::string second = "*ELEMENT, TYPE=B31, ELSET=EBEAM\n2, 30, 40\n";
    std::string text = kDeck;
    text.erase(text.find(second), second.size());
    text.erase(text.find("40, 1.5, 0.,\n"), 13);
    text.replace(text.find("*NSET, NSET=TIP\n40"), 18, "*NSET, NSET=TIP\n30");
    text.replace(text.find("EALL, GRAV"), 10, "1, GRAV");
    EXPECT_EQ(read(text).frame.gravity, Eigen::Vector3d(0.0, 0.0, -9.81));
}

TEST_F(CalculixFile, DeckWithoutNodesOrElementsIsToldWhatIsMissing) {
    const auto told = [&](const std::string& text) { return test::complaint_of([&] { (void)read(text); }); };
    const std::string file = path_.string() + ": ";
    for (const char* text : {"", "** nothing\n", "*NODE\n", "*STEP\n*END STEP\n"})
        EXPECT_THAT(told(text), testing::StartsWith(file + "has no node: *NODE")) << text;
    EXPECT_THAT(told("*NODE\n1, 0, 0, 0\n"), testing::StartsWith(file + "has no element: *ELEMENT"));
}

TEST_F(CalculixFile, RefusesBadDecksWithLineNumber) {
    using testing::HasSubstr;
    EXPECT_THAT(complaint("1.E9, .25", "1.E9, .25, 293\n2.E9, .25, 400"),
                testing::AllOf(HasSubstr("line 21"), HasSubstr("one temperature")));
    EXPECT_THAT(complaint("*DENSITY\n1240", "*DENSITY\n1240, 293\n1250, 400"), HasSubstr("one temperature"));
    EXPECT_THAT(complaint(".02, .01", ".02, .01, .005"), HasSubstr("3 numbers, where no more than 2"));
    EXPECT_THAT(complaint("EALL, GRAV, 9.81, 0, 0, -1", "EALL, GRAV, 9.81, 0, 0, 0"),
                HasSubstr("no direction"));
    EXPECT_THAT(complaint("20, 0.5, 0, 0", "20, half, 0, 0"), HasSubstr("line 6 has 'HALF'"));
    EXPECT_THAT(complaint("2, 30, 40", "2, 30, 41"), HasSubstr("node 41, which does not exist"));
    EXPECT_THAT(complaint("10, 30, 20", "10, 2000000000"),
                HasSubstr("line 17 puts 1999999991 labels into a set"));
    EXPECT_THAT(complaint("10, 30, 20", "1, 1000\n1, 19999500"),
                HasSubstr("line 18 puts 19999500 labels into a set; with those before, these are 20000500"));
    EXPECT_THAT(complaint("10, 30, 20", "10, 30, 0"), HasSubstr("line 17 steps by 0"));
    EXPECT_THAT(complaint("10, 30, 20", "30, 10, 20"), HasSubstr("line 17 generates labels up to 10, which"));
    EXPECT_EQ(complaint("10, 30, 20", "10, 10"), "");
    EXPECT_THAT(complaint("10, 1, 6", "10, 6, 1"), HasSubstr("degree of freedom 1, before its first"));
    EXPECT_THAT(complaint("1, 10, 20,\n30", "1, 10, 30,\n20"), HasSubstr("does not lie between"));
    EXPECT_THAT(complaint("TYPE=B31,", "TYPE=C3D8,"), HasSubstr("type C3D8"));
    EXPECT_THAT(complaint("SECTION=RECT", "SECTION=HEX"), HasSubstr("shape HEX"));
    EXPECT_THAT(complaint("*DLOAD", "*DFLUX"), HasSubstr("*DFLUX, which is not understood"));
    EXPECT_THAT(complaint("EALL, GRAV", "EALL, P1"), HasSubstr("no gravity"));
    EXPECT_THAT(complaint("TIP, 3,", "TIP, 7,"), HasSubstr("degree of freedom 7"));
    EXPECT_THAT(complaint("ELSET=EBEAM, MATERIAL=PLA", "ELSET=EBEAM, MATERIAL=ABS"),
                HasSubstr("material ABS"));
    EXPECT_THAT(complaint("*ELASTIC\n1.E9, .25", "*ELASTIC\n1.E9"), HasSubstr("1 numbers, where 2"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
