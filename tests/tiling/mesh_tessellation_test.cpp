// SPDX-License-Identifier: GPL-3.0-or-later
#include "outlines/outlines.hpp"

#include <fretwork/tiling/tessellate.hpp>
#include <fretwork/tiling/tessellation.hpp>

namespace fretwork::tiling {
namespace THIS_TEST {

using test::complaint_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

/// A mesh of points and faces, the latter numbered from 1.
TessellationResult read(const std::string& text) {
    const TemporaryFolder folder;
    folder.file("mesh.obj", text);
    const auto layout = pattern::find_node_layout("paper7");
    TessellationResult result = read_mesh_tessellation(folder.path() / "mesh.obj", layout);
    validate(result.tessellation, layout);
    return result;
}

constexpr const char* kPoints = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 0 2 0\nv 1 2 0\n";

std::string complaint_about(const std::string& faces) {
    return complaint_of([&] { read(kPoints + faces); });
}

TEST(MeshTessellation, FacesAreTheTiles) {
    const TessellationResult result = read(std::string(kPoints) + "f 1 2 5 4\nf 2 3 6 5\nf 4 5 8 7\n");
    EXPECT_EQ(result.tessellation.tiles.size(), 3U);
    EXPECT_EQ(result.tessellation.interface_nodes.size(), 10U);
    EXPECT_EQ(result.report.mean_side, 1.0);
}

TEST(MeshTessellation, AMeshSeenFromBelowIsTurned) {
    EXPECT_EQ(read(std::string(kPoints) + "f 4 5 2 1\nf 5 6 3 2\n").tessellation.tiles.size(), 2U);
}

TEST(MeshTessellation, TheFaceThatIsNoTileIsNamed) {
    EXPECT_THAT(complaint_about("f 5 6 8\nf 1 3 5 8 7\n"),
                AllOf(HasSubstr("face 1"), HasSubstr("not convex")));
    EXPECT_THAT(complaint_about("f 1 2 5 4\nf 2 3 6 5\nf 1 2 8\n"), HasSubstr("face 2"));
    EXPECT_THAT(complaint_about("f 1 2 5 4\nf 5 8 7\n"), HasSubstr("connected"));
}

TEST(MeshTessellation, AStraightCornerMayBendInwardsByRounding) {
    const auto squares = [](const std::string& bend) {
        return "v 0 0 0\nv 1 " + bend + " 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 2 0\nv 2 2 0\n" +
               "f 1 2 3 4 5\nf 5 4 7 6\n";
    };
    for (const char* bend : {"1e-17", "1e-9", "1e-6"})
        EXPECT_EQ(read(squares(bend)).tessellation.tiles.size(), 2U) << bend;
    EXPECT_THAT(complaint_of([&] { read(squares("0.01")); }),
                AllOf(HasSubstr("face 0"), HasSubstr("it bends inwards at (1, 0.01) by 0.01 m")));
}

TEST(MeshTessellation, AVertexOnTheMiddleOfASideIsNoWholeSide) {
    EXPECT_THAT(complaint_about("f 1 3 5 4\nf 3 6 5\nf 4 6 8 7\n"), HasSubstr("connected"));
    EXPECT_THAT(complaint_about("f 1 2 5 4\nf 2 3 6 5\nf 4 5 7\nf 5 8 7\nf 4 6 7\n"), HasSubstr("face 4"));
}

TEST(MeshTessellation, FacesThatOverlapAreRefused) {
    EXPECT_THAT(complaint_of([] {
                    read(
                        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1.2 5 0\nv 0.5 -1 0\n"
                        "f 1 2 3 4\nf 3 2 5\nf 3 5 6\n");
                }),
                HasSubstr("overlap"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::tiling
