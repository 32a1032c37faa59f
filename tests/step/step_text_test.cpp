// SPDX-License-Identifier: GPL-3.0-or-later
// STEP files are read back, by OpenCASCADE and by gmsh, and measured.
#include "support.hpp"

#include <fretwork/base/files/file.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/simulation/project/project.hpp>

#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <step_text.hpp>

namespace fretwork::step {
namespace THIS_TEST {

using fabrication::Contour;
using fabrication::Piece;
using fabrication::Shape;
using fretwork::test::TemporaryFolder;
using geometry::Point2;

constexpr double kHeight = 0.003;  // m

/// A plate of 60 x 40 mm whose corners are rounded by 5 mm, with a hole of 8 mm.
Shape plate() {
    const double b = std::tan(std::numbers::pi / 8.0);  // a quarter of a circle
    const double r = 0.005;
    Contour outer;
    for (const auto& [x, y, dx, dy] : {std::array{0.06, 0.0, 1.0, 0.0}, std::array{0.06, 0.04, 0.0, 1.0},
                                       std::array{0.0, 0.04, -1.0, 0.0}, std::array{0.0, 0.0, 0.0, -1.0}}) {
        outer.push_back({{x - r * dx, y - r * dy}, b});
        outer.push_back({{x - r * dy, y + r * dx}, 0.0});
    }
    return {{Piece{outer, {fabrication::reversed(fabrication::circle({0.03, 0.02}, 0.004))}}}, kHeight};
}

TopoDS_Shape read_back(const std::string& text, const TemporaryFolder& folder) {
    const auto file = folder.file("a.step", text);
    STEPControl_Reader reader;
    EXPECT_EQ(reader.ReadFile(file.c_str()), IFSelect_RetDone);
    reader.TransferRoots();
    return reader.OneShape();
}

double volume_of(const TopoDS_Shape& shape) {  // mm3
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

std::size_t count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    std::size_t count = 0;
    for (TopExp_Explorer at(shape, kind); at.More(); at.Next()) ++count;
    return count;
}

std::size_t cylinders(const TopoDS_Shape& shape) {
    std::size_t count = 0;
    for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next())
        count += BRepAdaptor_Surface(TopoDS::Face(at.Current())).GetType() == GeomAbs_Cylinder ? 1 : 0;
    return count;
}

TEST(StepText, APlateHasItsVolumeAndItsArcsAreArcs) {
    const TemporaryFolder folder;
    const TopoDS_Shape solid = read_back(step_text(plate(), "plate"), folder);
    const double pi = std::numbers::pi;
    // Closed form: the rectangle, less its corners, less the hole.
    const double area = 60.0 * 40.0 - (4.0 - pi) * 25.0 - pi * 16.0;
    EXPECT_NEAR(volume_of(solid), 3.0 * area, 1e-9 * area);
    EXPECT_EQ(count(solid, TopAbs_SOLID), 1U);
    EXPECT_GE(cylinders(solid), 5U) << "four corners and the hole";
}

TEST(StepText, EveryPieceIsASolid) {
    Shape shape = plate();
    Piece other = shape.pieces.front();
    for (Contour* contour : {&other.outer, &other.openings.front()})
        for (fabrication::ContourPoint& corner : *contour) corner.place.x += 0.1;
    shape.pieces.push_back(other);
    const TemporaryFolder folder;
    const TopoDS_Shape solids = read_back(step_text(shape, "plates"), folder);
    EXPECT_EQ(count(solids, TopAbs_SOLID), 2U);
    EXPECT_NEAR(volume_of(solids), 1e9 * fabrication::area(shape) * kHeight, 1e-6);
}

std::string output_of(const std::string& command) {
    FILE* pipe = ::popen(("{ " + command + "; } 2>&1").c_str(), "r");
    std::string text;
    char buffer[4096];
    while (pipe != nullptr && std::fgets(buffer, sizeof(buffer), pipe) != nullptr) text += buffer;
    if (pipe != nullptr) ::pclose(pipe);
    return text;
}

/// The commands that tile a specimen as p.json in a folder.
std::string tile_in(const std::string& place) {
    return "cd " + place +
           " && " FRETWORK_PROGRAM " tile " FRETWORK_SOURCE_DIR
           "/experiments/outlines/specimen.svg "
           "--edge-length 40mm --patterns 1-3+3-6 --out p.json >/dev/null";
}

TEST(StepProgram, PrintsJsonWhateverTheNameOfTheFile) {
    const TemporaryFolder folder;
    const std::string program = tile_in(folder.path().string()) + " && " FRETWORK_STEP " p.json";
    const auto written = base::Json::parse(output_of(program + R"( --json --to 'a "b".step' 2>/dev/null)"));
    EXPECT_EQ(written["path"], "a \"b\".step");
    EXPECT_GE(written["solids"], 1);
    EXPECT_EQ(written["unit"], "millimetre");
    double said = 0.0;
    const std::string line = output_of(program + " --to b.step 2>/dev/null");
    ASSERT_EQ(std::sscanf(line.c_str(), "b.step: %*s %*[^,], %lf mm3", &said), 1) << line;
    EXPECT_NEAR(written["volume"].get<double>(), said, 1e-5 * said) << "printed with six digits";
}

/// What is made of a project, with fillets and a frame, has the volume that another program finds.
TEST(StepProgram, GmshFindsTheVolumeThatItSays) {
    if (output_of("/usr/bin/python3 -c 'import gmsh; print(42)'").find("42") == std::string::npos)
        GTEST_SKIP() << "python3-gmsh is not installed";
    const TemporaryFolder folder;
    const std::string place = folder.path().string();
    const std::string said =
        output_of(tile_in(place) + " && " FRETWORK_STEP " p.json --fillet 0.5mm --frame 4mm --to a.step");
    double expected = 0.0;
    ASSERT_EQ(std::sscanf(said.c_str(), "a.step: 1 solid, %lf mm3", &expected), 1) << said;
    const std::string found = output_of(
        "/usr/bin/python3 -c \"import gmsh; gmsh.initialize(); "
        "gmsh.option.setNumber('General.Verbosity', 0); "
        "made = gmsh.model.occ.importShapes('" +
        place +
        "/a.step'); gmsh.model.occ.synchronize(); "
        "print(sum(gmsh.model.occ.getMass(3, tag) for dim, tag in made if dim == 3))\"");
    EXPECT_NEAR(std::stod(found), expected, 1e-4 * expected) << found;
}

TEST(StepProgram, TellsWhereItCannotWrite) {
    const TemporaryFolder folder;
    const std::string start = tile_in(folder.path().string()) + " && ";
    EXPECT_THAT(output_of(start + "TMPDIR=/nowhere " FRETWORK_STEP " p.json --to a.step; echo exit $?"),
                testing::MatchesRegex("fretwork-step: .*TMPDIR.*/nowhere.*\nexit 2\n"));
    EXPECT_THAT(output_of(start + FRETWORK_STEP " p.json --to a.step 2>&1 >/dev/full; echo exit $?"),
                testing::AllOf(testing::HasSubstr("standard output"), testing::HasSubstr("exit 2")));
}

TEST(StepProgram, RefusesInOneLine) {
    const TemporaryFolder folder;
    const auto refusal = [&](const std::string& words) {
        return output_of("cd " + folder.path().string() + " && " FRETWORK_STEP " " + words +
                         "; echo exit $?");
    };
    EXPECT_THAT(refusal("none.json --to a.stl"), testing::HasSubstr("a.stl"));
    EXPECT_THAT(refusal("none.json --to a.step"),
                testing::MatchesRegex("fretwork-step: none.json.*\nexit 2\n"));
    (void)folder.file("mine.step", "a poem");
    EXPECT_THAT(refusal("none.json --to mine.step"), testing::HasSubstr("no STEP file"));
    EXPECT_THAT(refusal("--help"),
                testing::AllOf(testing::HasSubstr("Example: fretwork-step"), testing::HasSubstr("exit 0")));
}

}  // namespace THIS_TEST
}  // namespace fretwork::step
