// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"
#include "support.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/mechanics/frame/frame_file.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace fretwork::mechanics {
namespace THIS_TEST {

using testing::AllOf;
using testing::HasSubstr;

/// All that a frame file may hold.
constexpr const char* kWhole = R"({ "format": "fretwork/frame/1",
  "nodes": [[0,0,0],[1,0,0],[1,1,0],[1,1,1]],
  "materials": { "pla": { "young_modulus": 1e9, "poisson_ratio": 0.3, "density": 1240 },
                 "odd": { "young_modulus": 2e9, "shear_modulus": 7e8, "density": 900 } },
  "sections":  { "bar":  { "type": "rectangle", "width": 0.002, "height": 0.004 },
                 "rod":  { "type": "circle", "diameter": 0.002 },
                 "pipe": { "type": "tube", "outer_diameter": 0.004, "inner_diameter": 0.003 },
                 "any":  { "area": 4e-6, "I2": 1.3e-12, "I3": 1.4e-12, "J": 2.2e-12, "shear_area2": 3.3e-6,
                           "shear_area3": 3.4e-6 } },
  "beams":     [ { "nodes": [0,1], "section": "bar", "material": "pla", "normal": [0,1,0], "divisions": 3,
                   "releases": [ { "end": 1, "free": ["ry","rz"] } ] },
                 { "nodes": [1,2], "section": "pipe", "material": "odd" },
                 { "nodes": [2,3], "section": "any", "material": "pla" } ],
  "supports":  [ { "node": 0, "fixed": ["ux","uy","uz","rx","ry","rz"] } ],
  "prescribed":[ { "node": 3, "uz": 0.01, "ux": -0.02 } ],
  "loads":     [ { "node": 1, "force": [0,0,-1], "moment": [0,2,0] }, { "node": 2, "force": [1,2,3] } ],
  "gravity":   [0,0,-9.81] })";

class FrameFile : public testing::Test {
  protected:
    Frame read(const std::string& text) {
        std::ofstream(path_) << text;
        return read_frame(path_);
    }
    /// The message with which a file is refused, or "".
    std::string complaint(const std::string& text) {
        try {
            read(text);
        } catch (const base::InputError& error) {
            return error.what();
        }
        return "";
    }
    /// kWhole with one piece replaced.
    std::string complaint(const std::string& piece, const std::string& by) {
        std::string text = kWhole;
        const auto place = text.find(piece);
        EXPECT_NE(place, std::string::npos) << piece;
        return complaint(text.replace(place, piece.size(), by));
    }

    test::TemporaryFolder folder_;
    std::filesystem::path path_ = folder_.path() / "frame.json";
};

TEST_F(FrameFile, EveryKeyIsRead) {
    const Frame frame = read(kWhole);
    ASSERT_EQ(frame.beams.size(), 3u);
    EXPECT_EQ(frame.beams[0].section, rectangle_section(0.002, 0.004));
    EXPECT_EQ(frame.beams[0].normal, Eigen::Vector3d(0, 1, 0));
    EXPECT_EQ(frame.beams[0].divisions, 3);
    EXPECT_EQ(frame.beams[0].releases[0], (Release{1, {{false, false, false, false, true, true}}}));
    EXPECT_EQ(frame.beams[1].section, tube_section(0.004, 0.003));
    EXPECT_DOUBLE_EQ(frame.beams[1].material.shear_modulus(), 7e8);
    EXPECT_DOUBLE_EQ(*frame.beams[2].section.shear_area3, 3.4e-6);
    EXPECT_EQ(frame.prescribed.size(), 2u);
    EXPECT_EQ(frame.loads[0].moment, Eigen::Vector3d(0, 2, 0));
    EXPECT_EQ(frame.gravity, Eigen::Vector3d(0, 0, -9.81));
}

TEST_F(FrameFile, WrittenFramesAreReadBackEqual) {
    const Frame frame = read(kWhole);
    write_frame(frame, path_);
    const std::string once = base::read_text_file(path_);
    const Frame again = read_frame(path_);
    ASSERT_EQ(again.beams.size(), frame.beams.size());
    for (std::size_t b = 0; b < frame.beams.size(); ++b) {
        EXPECT_EQ(again.beams[b].nodes, frame.beams[b].nodes);
        EXPECT_EQ(again.beams[b].section, frame.beams[b].section);
        EXPECT_EQ(again.beams[b].material, frame.beams[b].material);
        EXPECT_EQ(again.beams[b].normal, frame.beams[b].normal);
        EXPECT_EQ(again.beams[b].divisions, frame.beams[b].divisions);
        EXPECT_EQ(again.beams[b].releases, frame.beams[b].releases);
    }
    write_frame(again, path_);
    EXPECT_EQ(base::read_text_file(path_), once);
}

TEST_F(FrameFile, TextIsReadAsTheFileIs) {
    const Frame frame = parse_frame(kWhole, "somewhere");
    EXPECT_EQ(frame_text(frame), frame_text(read(kWhole)));
    try {
        parse_frame("{}", "somewhere");
        FAIL();
    } catch (const base::InputError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith("somewhere"));
    }
}

TEST_F(FrameFile, EqualSectionsAreWrittenOnce) {
    write_frame(sample::star(), path_);
    EXPECT_EQ(base::read_text_file(path_).find("section1"), std::string::npos);
}

TEST_F(FrameFile, ShapeThatNoSectionHasIsNotWritten) {
    Frame frame = sample::star();
    Section& section = frame.beams[0].section;
    section = circle_section(0.002);
    for (const SectionShape& shape : {SectionShape(TubeShape{0.002, 0.0}), SectionShape(CircleShape{})}) {
        section.shape = shape;
        validate(frame);
        const Section found = parse_frame(frame_text(frame), "text").beams[0].section;
        EXPECT_FALSE(found.shape.has_value());
        EXPECT_EQ(found.area, section.area);
        EXPECT_EQ(found.I2, section.I2);
        EXPECT_EQ(found.I3, section.I3);
        EXPECT_EQ(found.J, section.J);
    }
}

TEST_F(FrameFile, MissingFileIsNamed) {
    try {
        read_frame("/nowhere/frame.json");
        FAIL();
    } catch (const base::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("/nowhere/frame.json"));
    }
}

TEST_F(FrameFile, EveryTruncationIsRefusedWithItsFile) {
    const std::string whole = kWhole;
    for (std::size_t size = 0; size < whole.size() - 1; size += 7)
        EXPECT_THAT(complaint(whole.substr(0, size)), HasSubstr(path_.string())) << size;
}

TEST_F(FrameFile, UnknownKeysAreRefusedWithTheNearestKnown) {
    EXPECT_THAT(complaint("\"divisions\"", "\"division\""),
                AllOf(HasSubstr("/beams/0"), HasSubstr("divisions")));
    EXPECT_THAT(complaint("\"gravity\"", "\"grvity\""), HasSubstr("gravity"));
    EXPECT_THAT(complaint("\"density\"", "\"densty\""), HasSubstr("/materials/pla"));
    EXPECT_THAT(complaint("\"uz\": 0.01", "\"vz\": 0.01"), HasSubstr("/prescribed/0"));
}

TEST_F(FrameFile, MissingKeysAreRefused) {
    EXPECT_THAT(complaint("\"young_modulus\": 1e9, ", ""),
                AllOf(HasSubstr("/materials/pla"), HasSubstr("young")));
    EXPECT_THAT(complaint("\"width\": 0.002, ", ""), AllOf(HasSubstr("/sections/bar"), HasSubstr("width")));
    EXPECT_THAT(complaint("\"node\": 1, ", ""), HasSubstr("/loads/0"));
    EXPECT_THAT(complaint("fretwork/frame/1", "fretwork/frame/3"), HasSubstr("/format"));
}

TEST_F(FrameFile, WrongCountsAndTypesAreRefused) {
    EXPECT_THAT(complaint("[1,1,0]", "[1,1]"), HasSubstr("/nodes/2"));
    EXPECT_THAT(complaint("\"nodes\": [1,2]", "\"nodes\": [1,2,3]"), HasSubstr("/beams/1/nodes"));
    EXPECT_THAT(complaint("\"nodes\": [1,2]", "\"nodes\": [1,17]"), HasSubstr("/beams/1/nodes/1"));
    EXPECT_THAT(complaint("\"nodes\": [1,2]", "\"nodes\": [1,2.5]"), HasSubstr("/beams/1/nodes/1"));
    EXPECT_THAT(complaint("\"divisions\": 3", "\"divisions\": 0"), HasSubstr("/beams/0/divisions"));
    EXPECT_THAT(complaint("\"divisions\": 3", "\"divisions\": 1001"), HasSubstr("/beams/0/divisions"));
    EXPECT_THAT(complaint("\"end\": 1", "\"end\": 2"), HasSubstr("/beams/0/releases/0/end"));
    EXPECT_THAT(complaint("\"ry\",\"rz\"] }", "\"rw\"] }"), HasSubstr("/beams/0/releases/0/free/0"));
    EXPECT_THAT(complaint("[0,0,-9.81]", "[0,0]"), HasSubstr("/gravity"));
}

TEST_F(FrameFile, NumbersOutOfRangeAreRefused) {
    EXPECT_THAT(complaint("[1,1,0]", "[1,NaN,0]"), HasSubstr("line"));
    EXPECT_THAT(complaint("[1,1,0]", "[1,1e999,0]"), HasSubstr(path_.string()));
    EXPECT_THAT(complaint("\"width\": 0.002", "\"width\": -0.002"), HasSubstr("/sections/bar/width"));
    EXPECT_THAT(complaint("\"poisson_ratio\": 0.3", "\"poisson_ratio\": 0.7"), HasSubstr("poisson_ratio"));
    EXPECT_THAT(complaint("\"inner_diameter\": 0.003", "\"inner_diameter\": 0.004"),
                HasSubstr("inner_diameter"));
}

TEST_F(FrameFile, ValuesBeyondAnythingThatIsBuiltAreRefusedWithTheirLimits) {
    EXPECT_THAT(complaint("[1,1,0]", "[1,1e20,0]"),
                AllOf(HasSubstr(path_.string() + ": /nodes/2"), HasSubstr("1e+12 (m)")));
    EXPECT_THAT(complaint("\"young_modulus\": 1e9", "\"young_modulus\": 1e308"),
                AllOf(HasSubstr("/materials/pla/young_modulus"), HasSubstr("1e+18 (Pa)")));
    EXPECT_THAT(complaint("\"width\": 0.002", "\"width\": 1e-320"), HasSubstr("/sections/bar/width"));
    EXPECT_THAT(complaint("[0,0,-9.81]", "[0,0,-1e308]"), HasSubstr("/gravity"));
    EXPECT_THAT(complaint("\"uz\": 0.01", "\"uz\": 1e308"), HasSubstr("/prescribed/0/uz"));
}

// No beam uses the rod.
TEST_F(FrameFile, MaterialsAndSectionsAreCheckedWhereTheyStandAlsoIfNoBeamUsesThem) {
    EXPECT_THAT(complaint("\"diameter\": 0.002", "\"diameter\": 1e300"),
                HasSubstr(": /sections/rod/diameter: "));
    EXPECT_THAT(
        complaint("\"pla\": {", "\"spare\": {\"young_modulus\": 1e300, \"poisson_ratio\": 0.3}, \"pla\": {"),
        HasSubstr(": /materials/spare/young_modulus: is 1e+300, where a number from 1e-12 to 1e+18 (Pa)"));
    EXPECT_THAT(complaint("\"density\": 900", "\"density\": 1e300"),
                HasSubstr(": /materials/odd/density: is 1e+300, where 0 or a number from "));
    EXPECT_THAT(complaint("\"shear_modulus\": 7e8", "\"shear_modulus\": 7e18"),
                HasSubstr(": /materials/odd/shear_modulus: "));
    EXPECT_THAT(complaint("\"I3\": 1.4e-12", "\"I3\": 1e49"),
                HasSubstr(": /sections/any/I3: is 1e+49, where "));
    EXPECT_THAT(complaint("\"shear_area3\": 3.4e-6", "\"shear_area3\": 1e25"),
                HasSubstr(": /sections/any/shear_area3: "));
    // The file has the length, and not the number that it gives.
    EXPECT_THAT(complaint("\"diameter\": 0.002", "\"diameter\": 1e-12"),
                HasSubstr(": /sections/rod: has no valid area: it is 7.85"));
}

/// One entry may prescribe several components.
TEST_F(FrameFile, AComponentThatTwoEntriesPrescribeIsRefusedWithTheSecond) {
    EXPECT_THAT(complaint(R"("ux": -0.02 })", R"("ux": -0.02 }, { "node": 3, "uz": 0.02 })"),
                HasSubstr("/prescribed/1: uz of node 3 is prescribed twice"));
}

TEST_F(FrameFile, NamesThatAreNotThereAreRefused) {
    EXPECT_THAT(complaint("\"section\": \"pipe\"", "\"section\": \"pipes\""),
                AllOf(HasSubstr("/beams/1/section"), HasSubstr("pipe")));
}

TEST_F(FrameFile, UnsupportedStructuresAreRefusedWithFileAndNode) {
    EXPECT_THAT(complaint("[1,0,0]", "[0,0,0]"), AllOf(HasSubstr(path_.string()), HasSubstr("/beams/0")));
    EXPECT_THAT(complaint("\"fixed\": [\"ux\",\"uy\",\"uz\",\"rx\",\"ry\",\"rz\"]", "\"fixed\": [\"ux\"]"),
                AllOf(HasSubstr(path_.string()), HasSubstr("/nodes/0")));
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
