// SPDX-License-Identifier: GPL-3.0-or-later
// The tests have their own readers of these files, which must give the same numbers to the last bit.
#include "sample.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/exports/tables/line_files.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <pugixml.hpp>

#include <numbers>
#include <sstream>

namespace fretwork::exports {
namespace THIS_TEST {

using namespace test;

LineSet sample_lines() {
    const simulation::Surface surface = sample_surface();
    return result_lines(surface, bent(surface, Rows::EveryNode));
}

template <class Number>
std::vector<Number> numbers_of(const pugi::xml_node& array) {
    std::istringstream stream(array.child_value());
    std::vector<Number> numbers;
    for (std::string word; stream >> word;) {
        if constexpr (std::is_integral_v<Number>) {
            numbers.push_back(static_cast<Number>(std::stol(word)));
        } else {
            numbers.push_back(std::stod(word));
        }
    }
    return numbers;
}

pugi::xml_node array_of(const pugi::xml_node& parent, const char* name) {
    return parent.find_child_by_attribute("DataArray", "Name", name);
}

class VtuFile : public testing::Test {
  protected:
    VtuFile() { EXPECT_TRUE(document_.load_string(vtu_text(lines_).c_str())); }
    [[nodiscard]] pugi::xml_node piece() const {
        return document_.child("VTKFile").child("UnstructuredGrid").child("Piece");
    }
    LineSet lines_ = sample_lines();
    pugi::xml_document document_;
};

TEST_F(VtuFile, HasTheNodesAtRestAndTheirDisplacements) {
    EXPECT_EQ(piece().attribute("NumberOfPoints").as_uint(), lines_.nodes.size());
    const auto points = numbers_of<double>(piece().child("Points").child("DataArray"));
    const auto displacement = numbers_of<double>(array_of(piece().child("PointData"), "displacement"));
    const auto rotation = numbers_of<double>(array_of(piece().child("PointData"), "rotation"));
    ASSERT_EQ(points.size(), 3 * lines_.nodes.size());
    ASSERT_EQ(displacement.size(), points.size());
    ASSERT_EQ(rotation.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i / 3);
        const auto column = static_cast<Eigen::Index>(i % 3);
        EXPECT_EQ(points[i], lines_.nodes[i / 3][column]);
        EXPECT_EQ(displacement[i], (*lines_.displacements)(row, column));
        EXPECT_EQ(rotation[i], (*lines_.displacements)(row, 3 + column));
    }
}

TEST_F(VtuFile, HasOneLineCellForEachBeam) {
    const std::size_t count = lines_.lines.size();
    EXPECT_EQ(piece().attribute("NumberOfCells").as_uint(), count);
    const auto connectivity = numbers_of<int>(array_of(piece().child("Cells"), "connectivity"));
    const auto offsets = numbers_of<int>(array_of(piece().child("Cells"), "offsets"));
    const auto types = numbers_of<int>(array_of(piece().child("Cells"), "types"));
    const auto tiles = numbers_of<int>(array_of(piece().child("CellData"), "tile"));
    ASSERT_EQ(connectivity.size(), 2 * count);
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(connectivity[2 * i], lines_.lines[i][0]);
        EXPECT_EQ(connectivity[2 * i + 1], lines_.lines[i][1]);
        EXPECT_EQ(offsets[i], static_cast<int>(2 * i + 2));
        EXPECT_EQ(types[i], 3) << "VTK_LINE";
        EXPECT_EQ(tiles[i], lines_.tiles[i]);
    }
    EXPECT_EQ(numbers_of<int>(array_of(piece().child("CellData"), "pattern")), lines_.patterns);
}

/// VTK writes a text as the numbers of its characters, ended by 0.
TEST_F(VtuFile, NamesTheJointsOfTheSetting) {
    simulation::Surface surface = sample_surface();
    for (const auto joints : {reduction::Joints::Centreline, reduction::Joints::Stiff}) {
        surface.setting.joints = joints;
        pugi::xml_document document;
        ASSERT_TRUE(document.load_string(vtu_text(beam_lines(surface, nullptr)).c_str()));
        const auto data = document.child("VTKFile").child("UnstructuredGrid").child("FieldData");
        std::string text;
        for (const int code : numbers_of<int>(array_of(data, "joints"))) text += static_cast<char>(code);
        EXPECT_EQ(text, std::string(reduction::joints_name(joints)) + '\0');
    }
    EXPECT_FALSE(document_.child("VTKFile").child("UnstructuredGrid").child("FieldData"))
        << "lines of which nothing is known";
}

TEST(ObjFile, HasDisplacedVerticesAndLines) {
    const LineSet lines = sample_lines();
    const auto places = displaced_nodes(lines);
    std::size_t vertices = 0;
    std::size_t edges = 0;
    std::istringstream stream(obj_text(lines));
    for (std::string line; std::getline(stream, line);) {
        const auto words = base::split(line, ' ');
        if (words[0] == "v") {
            for (Eigen::Index c = 0; c < 3; ++c)
                EXPECT_EQ(std::stod(words[static_cast<std::size_t>(c) + 1]), places[vertices][c]);
            ++vertices;
        } else if (words[0] == "l") {
            EXPECT_EQ(std::stoi(words[1]) - 1, lines.lines[edges][0]);
            EXPECT_EQ(std::stoi(words[2]) - 1, lines.lines[edges][1]);
            ++edges;
        } else {
            EXPECT_EQ(words[0], "#");
        }
    }
    EXPECT_EQ(vertices, lines.nodes.size());
    EXPECT_EQ(edges, lines.lines.size());
}

TEST(PlyFile, HasAHeaderThatSaysWhatFollows) {
    const LineSet lines = sample_lines();
    const auto places = displaced_nodes(lines);
    std::istringstream stream(ply_text(lines));
    std::string header;
    for (std::string line; std::getline(stream, line) && line != "end_header";) header += line + "\n";
    EXPECT_THAT(header, testing::StartsWith("ply\nformat ascii 1.0\n"));
    EXPECT_THAT(header, testing::HasSubstr("element vertex " + std::to_string(places.size()) + "\n"));
    EXPECT_THAT(header, testing::HasSubstr("element edge " + std::to_string(lines.lines.size()) + "\n"));
    for (const Eigen::Vector3d& place : places) {
        std::string x;
        std::string y;
        std::string z;
        stream >> x >> y >> z;
        EXPECT_EQ(Eigen::Vector3d(std::stod(x), std::stod(y), std::stod(z)), place);
    }
    for (const auto& line : lines.lines) {
        std::array<int, 2> read{};
        stream >> read[0] >> read[1];
        EXPECT_EQ(read, line);
    }
    std::string rest;
    EXPECT_FALSE(stream >> rest);
}

TEST(CsvFile, HasARowForEachNodeUnderNamesWithUnits) {
    const LineSet lines = sample_lines();
    std::istringstream stream(csv_text(lines));
    std::string line;
    std::getline(stream, line);
    EXPECT_EQ(line, "node,x_m,y_m,z_m,ux_m,uy_m,uz_m,rx_rad,ry_rad,rz_rad");
    std::size_t node = 0;
    for (; std::getline(stream, line); ++node) {
        const auto fields = base::split(line, ',');
        ASSERT_EQ(fields.size(), 10U);
        EXPECT_EQ(fields[0], std::to_string(node));
        for (Eigen::Index d = 0; d < 6; ++d) {
            EXPECT_EQ(std::stod(fields[static_cast<std::size_t>(d) + 4]),
                      (*lines.displacements)(static_cast<Eigen::Index>(node), d));
        }
    }
    EXPECT_EQ(node, lines.nodes.size());
}

mechanics::Frame straight_beam(int divisions) {
    mechanics::Frame frame;
    frame.nodes = {{0, 0, 0}, {1, 0, 0}};
    frame.beams.push_back({.nodes = {mechanics::NodeIndex(0), mechanics::NodeIndex(1)},
                           .section = {.area = 0.01, .I2 = 1e-6, .I3 = 1e-6, .J = 1e-6},
                           .material = {.young_modulus = 1e6, .poisson_ratio = 0.0, .density = 1.0},
                           .divisions = divisions});
    frame.supports.push_back({mechanics::NodeIndex(0), mechanics::DofSet::all()});
    return frame;
}

// A moment of E I pi / 2 L bends a cantilever into a quarter of a circle of radius 2 L / pi: so lie the ends
// of its divisions. The hinge about its own axis at the first end is not drawn.
TEST(SolutionLines, ShowADividedBeamAsItBends) {
    mechanics::Frame frame = straight_beam(8);
    frame.beams[0].releases = {{0, {{false, false, false, true, false, false}}}};
    frame.supports.push_back({mechanics::NodeIndex(1), {{false, false, false, true, false, false}}});
    frame.loads.push_back({mechanics::NodeIndex(1), {0, 0, 0}, {0, 0, 0.5 * std::numbers::pi}});
    const auto assembly = mechanics::assemble(frame);
    simulation::SurfaceResult result;
    result.solution = mechanics::follow_load_path(assembly, mechanics::even_load_factors(4)).back();
    ASSERT_TRUE(result.solution.converged());
    result.vibration_modes = mechanics::vibration_modes(assembly, 1);
    const LineSet lines = solution_lines(assembly, result);
    EXPECT_EQ(lines.nodes.size(), 9U);
    EXPECT_EQ(lines.lines.size(), 8U);
    const double radius = 2.0 / std::numbers::pi;
    for (const Eigen::Vector3d& place : displaced_nodes(lines))
        EXPECT_NEAR((place - Eigen::Vector3d(0.0, radius, 0.0)).norm(), radius, 1e-6);
    for (const auto& [from, to] : lines.lines) {
        const auto at = [&](int node) { return lines.nodes[node]; };
        EXPECT_NEAR((at(from) - at(to)).norm(), 1.0 / 8.0, 1e-15);
    }
    ASSERT_EQ(lines.fields.size(), 1U);
    EXPECT_EQ(lines.fields[0].vectors.rows(), 9);
    EXPECT_GT(lines.fields[0].vectors.row(5).norm(), 0.1);  // inside the beam, and it swings
}

TEST(LineFiles, VtuHasTheModesUnderTheirValues) {
    const auto assembly = mechanics::assemble(straight_beam(1));
    simulation::SurfaceResult result;
    mechanics::NodeValues shape = mechanics::NodeValues::Zero(2, mechanics::kDofsPerNode);
    result.solution.displacements = shape;
    result.solution.inner_displacements.resize(0, mechanics::kDofsPerNode);
    shape.row(1) << 0.0, 0.25, 1.0, 7.0, 7.0, 7.0;
    const mechanics::NodeValues none(0, mechanics::kDofsPerNode);
    result.vibration_modes = {{12.5, shape, none}};
    result.buckling_modes = {{3.0, shape, none}, {4.0, -shape, none}};
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(vtu_text(solution_lines(assembly, result)).c_str()));
    const auto data = document.child("VTKFile").child("UnstructuredGrid").child("Piece").child("PointData");
    const std::vector<double> moved = {0, 0, 0, 0, 0.25, 1};
    EXPECT_EQ(numbers_of<double>(array_of(data, "vibration 1, 12.5 Hz")), moved);
    EXPECT_EQ(numbers_of<double>(array_of(data, "buckling 1, 3 times the load")), moved);
    EXPECT_EQ(numbers_of<double>(array_of(data, "buckling 2, 4 times the load"))[5], -1.0);
}

TEST(LineFiles, WithoutDisplacementsGiveTheStateAtRest) {
    const LineSet lines = surface_lines(sample_surface());
    EXPECT_EQ(vtu_text(lines).find("PointData"), std::string::npos);
    const LineSet empty;
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(vtu_text(empty).c_str()));
    EXPECT_THAT(ply_text(empty), testing::HasSubstr("element vertex 0\n"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
