// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/sample.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/exports/tables/library_meshes.hpp>

#include <cmath>

namespace fretwork::exports {
namespace THIS_TEST {

using fretwork::test::TemporaryFolder;

std::size_t count_of(const std::string& text, const std::string& start) {
    std::size_t count = 0;
    for (const std::string& line : base::split(text, '\n')) count += line.starts_with(start) ? 1 : 0;
    return count;
}

library::Library calibrated_library(const std::filesystem::path& path) {
    library::Library library = library::test::make_library(path);
    library.store(std::vector{library::test::sample_data("0-1+1-6", 1.0)});
    return library;
}

TEST(LibraryMeshes, AreTheFanAndTheReducedModelOfEachPattern) {
    const TemporaryFolder folder;
    const auto library = calibrated_library(folder.path() / "lib.db");
    const auto meshes = folder.path() / "meshes";
    EXPECT_EQ(export_meshes(library, library.patterns(), meshes, {MeshKind::Obj}),
              library.pattern_count() + 1);
    // The fan: 6 interface nodes, 6 radial ones, the center; 2 edges a sector. The reduced model: a ring and
    // 6 links.
    const std::string fan = base::read_text_file(meshes / "0-1+1-6.obj");
    EXPECT_EQ(count_of(fan, "v "), 13U);
    EXPECT_EQ(count_of(fan, "l "), 12U);
    const std::string reduced = base::read_text_file(meshes / "0-1+1-6.paper6.obj");
    EXPECT_EQ(count_of(reduced, "v "), 12U);
    EXPECT_EQ(count_of(reduced, "l "), 12U);
    EXPECT_FALSE(std::filesystem::exists(meshes / "1-6+3-6.paper6.obj")) << "it is not calibrated";
}

TEST(LibraryMeshes, LieInTheSettingsHexagon) {
    const reduction::Setting setting = reduction::paper_setting();
    const auto layout = pattern::find_node_layout("paper7");
    const LineSet lines = pattern_lines(layout, pattern::parse_pattern_id(layout, "0-1+1-6"), setting);
    const double inradius = setting.tile_side * std::sqrt(3.0) / 2.0;
    for (int i = 0; i < 6; ++i) {
        // Interface node i at angle 270 + 60 i degrees, on the middle of a side.
        const double angle = (270.0 + 60.0 * i) * std::acos(-1.0) / 180.0;
        const Eigen::Vector3d place(inradius * std::cos(angle), inradius * std::sin(angle), 0.0);
        EXPECT_LT((lines.nodes[i] - place).norm(), 1e-15);
    }
}

TEST(LibraryMeshes, AreWrittenAsPlyToo) {
    const TemporaryFolder folder;
    const auto library = calibrated_library(folder.path() / "lib.db");
    const auto all = library.patterns();
    EXPECT_EQ(export_meshes(library, std::span(all).first(1), folder.path() / "meshes", {MeshKind::Ply}), 2U);
    EXPECT_TRUE(base::read_text_file(folder.path() / "meshes" / "0-1+1-6.ply").starts_with("ply\n"));
}

TEST(LibraryMeshes, AFolderThatCannotBeMadeIsReported) {
    const TemporaryFolder folder;
    const auto library = calibrated_library(folder.path() / "lib.db");
    EXPECT_THROW(
        export_meshes(library, library.patterns(), folder.path() / "lib.db" / "meshes", {MeshKind::Obj}),
        base::IoError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
