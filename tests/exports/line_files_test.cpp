// SPDX-License-Identifier: GPL-3.0-or-later
// Files are read again by readers of the tests' own, and give the same numbers to the last bit.
#include "sample.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/exports/line_files.hpp>

#include <pugixml.hpp>

#include <sstream>

namespace fretwork::exports {
namespace {

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

TEST(LineFiles, VtuHasTheModesUnderTheirValues) {
    mechanics::Result result;
    mechanics::NodeValues shape = mechanics::NodeValues::Zero(2, mechanics::kDofsPerNode);
    shape.row(1) << 0.0, 0.25, 1.0, 7.0, 7.0, 7.0;
    result.vibration_modes = {{12.5, shape}};
    result.buckling_modes = {{3.0, shape}, {4.0, -shape}};
    LineSet lines{.nodes = {{0, 0, 0}, {1, 0, 0}}, .lines = {{0, 1}}, .tiles = {}, .patterns = {}};
    lines.fields = mode_fields(result);
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(vtu_text(lines).c_str()));
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

}  // namespace
}  // namespace fretwork::exports
