// SPDX-License-Identifier: GPL-3.0-or-later
// Files for cutting and printing, measured by programs that are not ours. Where one is missing, its test is
// skipped.
#include "made_sample.hpp"

#include <fretwork/exports/making/making_files.hpp>
#include <fretwork/exports/tables/series_files.hpp>

#include <cstdio>
#include <memory>
#include <optional>
#include <regex>
#include <sstream>

namespace fretwork::exports {
namespace THIS_TEST {

using namespace test;
using testing::HasSubstr;

/// The output of a command, errors included.
std::string output_of(const std::string& command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen((command + " 2>&1").c_str(), "r"), ::pclose);
    std::string text;
    char buffer[4096];
    while (pipe && std::fgets(buffer, sizeof(buffer), pipe.get()) != nullptr) text += buffer;
    return text;
}
bool succeeds(const std::string& command) {
    return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

/// The number behind a word.
std::optional<double> number_after(const std::string& text, const std::string& word) {
    std::smatch match;
    if (!std::regex_search(text, match, std::regex(word + R"([^0-9-]*(-?[0-9.]+(e[-+]?[0-9]+)?))")))
        return std::nullopt;
    return std::stod(match[1]);
}

const fabrication::ShapeOptions kOptions{.fillet = 5e-4, .frame_width = 3e-3};

const fabrication::Shape& shape() {
    static const fabrication::Shape made = fabrication::make_shape(sample_surface(), kOptions);
    return made;
}
const fabrication::Solid& solid() {
    static const fabrication::Solid made = fabrication::make_solid(shape());
    return made;
}

TEST(ForeignPrograms, EzdxfMeasuresTheAreaInMillimetres) {
    if (!succeeds("/usr/bin/python3 -c 'import ezdxf'")) GTEST_SKIP() << "python3-ezdxf is not installed";
    const TemporaryFolder folder;
    const auto file = folder.file("cut.dxf", cut_dxf(fabrication::whole_sheet(sample_surface(), kOptions)));
    const std::string printed =
        output_of("/usr/bin/python3 " FRETWORK_SOURCE_DIR "/tests/exports/measure_dxf.py " + file.string());
    EXPECT_THAT(printed, HasSubstr("errors 0\n"));
    EXPECT_THAT(printed, HasSubstr("unit 4\n"));
    EXPECT_THAT(printed, HasSubstr("inserts 0\n"));
    EXPECT_THAT(printed, HasSubstr("layers cut,labels\n"));
    EXPECT_THAT(printed, HasSubstr("closed True\n"));
    const auto area = number_after(printed, "area");
    ASSERT_TRUE(area) << printed;
    // It flattens arcs to a ten-thousandth of a millimetre, along some metres of contour.
    EXPECT_NEAR(*area, 1e6 * fabrication::area(shape()), 0.3) << printed;
}

TEST(ForeignPrograms, InkscapeFindsTheSizeOfTheCut) {
    if (!succeeds("inkscape --version")) GTEST_SKIP() << "inkscape is not installed";
    const TemporaryFolder folder;
    const auto file = folder.file("cut.svg", cut_svg(fabrication::whole_sheet(sample_surface(), kOptions)));
    const std::string printed = output_of("inkscape --query-id=cut --query-width " + file.string());
    std::smatch match;
    ASSERT_TRUE(std::regex_search(printed, match, std::regex(R"((^|\n)([0-9.]+)\s*$)"))) << printed;
    constexpr double kPixelsPerMillimetre = 96.0 / 25.4;
    constexpr double kHairline = 0.1;  // mm; the line's width counts
    EXPECT_NEAR(std::stod(match[2]) / kPixelsPerMillimetre, 1e3 * box_of(shape()).width() + kHairline, 1e-3);
}

TEST(ForeignPrograms, VtkReadsTheSeriesOfLoadStepsWithTheirPositions) {
    if (!succeeds("/usr/bin/python3 -c 'import vtkmodules.vtkIOXML'"))
        GTEST_SKIP() << "python3-vtk9 is not installed";
    const simulation::Surface surface = sample_surface();
    simulation::SurfaceResult result = bent(surface, Rows::EveryNode);
    for (const double factor : {0.25, 0.5, 1.0}) {
        result.load_steps.push_back(bent(surface, Rows::EveryNode, factor).solution);
        result.load_steps.back().load_factor = factor;
    }
    const TemporaryFolder folder;
    for (const NamedFile& file : series_files(surface, result, "series")) folder.file(file.name, file.text);
    std::istringstream printed(output_of("/usr/bin/python3 " FRETWORK_SOURCE_DIR
                                         "/tests/exports/read_vtu.py " +
                                         (folder.path() / "series.pvd").string()));
    const std::size_t beams = surface_lines(surface).lines.size();
    for (const mechanics::Solution& step : result.load_steps) {
        std::string word;
        double time = 0.0;
        std::size_t cells = 0;
        std::size_t stresses = 0;
        ASSERT_TRUE(printed >> word >> time >> cells >> stresses) << printed.str();
        EXPECT_EQ(time, step.load_factor);
        EXPECT_EQ(cells, beams);
        EXPECT_EQ(stresses, beams);
        for (std::size_t i = 0; i < result.nodes.size(); ++i) {
            Eigen::Vector3d place;
            ASSERT_TRUE(printed >> place.x() >> place.y() >> place.z()) << i;
            const Eigen::Vector3d moved = step.displacements.row(static_cast<Eigen::Index>(i)).head<3>();
            // Both are sums of two numbers that are written in full.
            EXPECT_LT((place - result.nodes[i].rest_position - moved).norm(), 1e-15) << i;
        }
    }
    std::string rest;
    EXPECT_FALSE(printed >> rest) << rest;
}

TEST(ForeignPrograms, AdmeshFindsNothingToRepair) {
    if (!succeeds("admesh --version")) GTEST_SKIP() << "admesh is not installed";
    const TemporaryFolder folder;
    const auto file = folder.file("solid.stl", solid_stl(solid()));
    const std::string printed = output_of("admesh " + file.string());
    for (const char* defect : {"Edges fixed", "Facets removed", "Facets added", "Facets reversed",
                               "Backwards edges", "Degenerate facets", "Normals fixed"})
        EXPECT_EQ(number_after(printed, defect), 0.0) << defect << "\n" << printed;
    EXPECT_EQ(number_after(printed, "Number of parts"), 1.0) << printed;
    EXPECT_NEAR(number_after(printed, "Volume").value_or(0.0), 1e9 * fabrication::volume(solid()),
                2e-4 * 1e9 * fabrication::volume(solid()));
}

TEST(ForeignPrograms, PrusaSlicerTakesStlAndThreeMfForTheSameClosedSolidInMillimetres) {
    if (!succeeds("prusa-slicer --help")) GTEST_SKIP() << "prusa-slicer is not installed";
    const TemporaryFolder folder;
    for (const auto& file :
         {folder.file("solid.stl", solid_stl(solid())), folder.file("solid.3mf", solid_3mf(solid()))}) {
        const std::string printed = output_of("prusa-slicer --info " + file.string());
        EXPECT_THAT(printed, HasSubstr("manifold = yes")) << printed;
        EXPECT_EQ(number_after(printed, "number_of_parts ="), 1.0) << printed;
        EXPECT_NEAR(number_after(printed, "volume =").value_or(0.0), 1e9 * fabrication::volume(solid()),
                    2e-4 * 1e9 * fabrication::volume(solid()));
        constexpr double kChords = 2 * 0.005;  // mm: on both sides an arc with chords
        EXPECT_NEAR(number_after(printed, "size_x =").value_or(0.0), 1e3 * box_of(shape()).width(), kChords)
            << printed;
        EXPECT_NEAR(number_after(printed, "size_z =").value_or(0.0), 1e3 * shape().height, 1e-5) << printed;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
