// SPDX-License-Identifier: GPL-3.0-or-later
#include "made_sample.hpp"

#include <fretwork/exports/making/making_files.hpp>

#include <pugixml.hpp>

#include <cstring>
#include <zip.h>

namespace fretwork::exports {
namespace THIS_TEST {

using namespace test;
using fabrication::Solid;
using testing::HasSubstr;

const fabrication::Shape& sample_shape() {
    static const fabrication::Shape shape = fabrication::make_shape(sample_surface(), {.fillet = 5e-4});
    return shape;
}
const Solid& sample_solid() {
    static const Solid solid = fabrication::make_solid(sample_shape());
    return solid;
}
/// mm3
double wanted_volume() {
    return 1e9 * fabrication::volume(sample_solid());
}

float float_at(const std::string& text, std::size_t place) {
    float value = 0.0F;
    std::memcpy(&value, text.data() + place, sizeof(value));
    return value;
}

/// The text of a file in an archive.
std::string entry(const std::string& archive, const char* name) {
    zip_error_t error;
    zip_source_t* source = zip_source_buffer_create(archive.data(), archive.size(), 0, &error);
    zip_t* opened = zip_open_from_source(source, ZIP_RDONLY, &error);
    if (opened == nullptr) return "";
    zip_stat_t stat;
    std::string text;
    if (zip_stat(opened, name, 0, &stat) == 0) {
        text.resize(stat.size);
        zip_file_t* file = zip_fopen(opened, name, 0);
        zip_fread(file, text.data(), text.size());
        zip_fclose(file);
    }
    zip_discard(opened);
    return text;
}

TEST(SolidStl, ReadAgainItHasTheVolumeInCubicMillimetres) {
    const std::string text = solid_stl(sample_solid());
    std::uint32_t count = 0;
    std::memcpy(&count, text.data() + 80, 4);
    ASSERT_EQ(count, sample_solid().triangles.size());
    ASSERT_EQ(text.size(), 84 + 50 * static_cast<std::size_t>(count));
    double volume = 0.0;
    for (std::size_t t = 0; t < count; ++t) {
        std::array<std::array<double, 3>, 3> p{};
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < 3; ++i) p[c][i] = float_at(text, 84 + 50 * t + 12 + 12 * c + 4 * i);
        volume += (p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
                   p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
                   p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0])) /
                  6.0;
    }
    EXPECT_NEAR(volume, wanted_volume(), 1e-4 * wanted_volume());  // 32 bit numbers
    EXPECT_THAT(text.substr(0, 80), HasSubstr("millimetres"));
    EXPECT_FALSE(text.starts_with("solid"));  // readers would take it for ASCII
}

TEST(SolidStl, NormalsHaveLengthOne) {
    const std::string text = solid_stl(sample_solid());
    for (std::size_t t = 0; t < sample_solid().triangles.size(); t += 97) {
        const std::size_t at = 84 + 50 * t;
        EXPECT_NEAR(std::hypot(float_at(text, at), float_at(text, at + 4), float_at(text, at + 8)), 1.0,
                    1e-6);
    }
}

TEST(Solid3mf, ReadAgainItHasTheUnitTheTrianglesAndTheVolume) {
    const std::string archive = solid_3mf(sample_solid());
    EXPECT_THAT(entry(archive, "[Content_Types].xml"), HasSubstr("3dmanufacturing-3dmodel+xml"));
    EXPECT_THAT(entry(archive, "_rels/.rels"), HasSubstr("/3D/3dmodel.model"));
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(entry(archive, "3D/3dmodel.model").c_str()));
    const auto model = document.child("model");
    EXPECT_STREQ(model.attribute("unit").value(), "millimeter");
    const auto mesh = model.child("resources").child("object").child("mesh");
    Solid read;
    for (const auto& vertex : mesh.child("vertices").children("vertex"))
        read.vertices.push_back({vertex.attribute("x").as_double(), vertex.attribute("y").as_double(),
                                 vertex.attribute("z").as_double()});
    for (const auto& triangle : mesh.child("triangles").children("triangle"))
        read.triangles.push_back({triangle.attribute("v1").as_int(), triangle.attribute("v2").as_int(),
                                  triangle.attribute("v3").as_int()});
    EXPECT_EQ(read.triangles.size(), sample_solid().triangles.size());
    EXPECT_EQ(check(read).open_edges, 0U);
    EXPECT_NEAR(fabrication::volume(read), wanted_volume(), 1e-6 * wanted_volume());
}

TEST(Lattice3mf, HasABeamForEveryBarWithTheAreaOfTheSection) {
    const fabrication::BarPlan plan = fabrication::bar_plan(sample_surface());
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(entry(lattice_3mf(plan), "3D/3dmodel.model").c_str()));
    const auto lattice =
        document.child("model").child("resources").child("object").child("mesh").child("b:beamlattice");
    const double radius = lattice.attribute("radius").as_double();
    EXPECT_NEAR(M_PI * radius * radius, 1e6 * plan.width * plan.height, 1e-5);
    const auto beams = lattice.child("b:beams").children("b:beam");
    EXPECT_EQ(std::distance(beams.begin(), beams.end()), static_cast<std::ptrdiff_t>(plan.bars.size()));
}

TEST(SolidMeshes, ObjAndPlySayMillimetresAndHaveEveryTriangle) {
    const std::string obj = solid_obj(sample_solid());
    EXPECT_THAT(obj.substr(0, 100), HasSubstr("millimetres"));
    std::size_t faces = 0;
    double largest = 0.0;
    for (const std::string& line : base::split(obj, '\n')) {
        faces += line.starts_with("f ") ? 1U : 0U;
        if (line.starts_with("v ")) largest = std::max(largest, std::stod(line.substr(2)));
    }
    EXPECT_EQ(faces, sample_solid().triangles.size());
    EXPECT_NEAR(largest, 1e3 * box_of(sample_shape()).xmax, 1e-3);
    const std::string ply = solid_ply(sample_solid());
    EXPECT_THAT(ply.substr(0, 200), HasSubstr("millimetres"));
    EXPECT_THAT(ply, HasSubstr("element face " + std::to_string(faces) + "\n"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
