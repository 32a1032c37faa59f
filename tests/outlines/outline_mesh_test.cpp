// SPDX-License-Identifier: GPL-3.0-or-later
#include "outlines/outlines.hpp"

#include <fretwork/outlines/outline.hpp>

namespace fretwork::outlines {
namespace THIS_TEST {

using test::complaint_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

TEST(OutlineMesh, BorderLoopsAreBoundaryAndHoles) {
    const Outline square = read_outline(data_file("square_with_window.obj"));
    EXPECT_EQ(square.boundary.size(), 12U);
    ASSERT_EQ(square.holes.size(), 1U);
    EXPECT_EQ(square.holes[0].size(), 4U);
    EXPECT_DOUBLE_EQ(area_of(square), 8.0);
}

TEST(OutlineMesh, PlyAndOffAreReadToo) {
    EXPECT_DOUBLE_EQ(area_of(read_outline(data_file("quadrilateral.ply"))), 2.0);
    EXPECT_DOUBLE_EQ(area_of(read_outline(data_file("two_triangles.off"))), 1.0);
}

TEST(OutlineMesh, ComplaintsNameTheFileAndTheVertex) {
    const TemporaryFolder folder;
    const auto refuse = [&](const std::string& content) {
        const auto path = folder.file("o.obj", content);
        std::string message = complaint_of([&] { read_outline(path); });
        EXPECT_THAT(message, HasSubstr("o.obj"));
        return message;
    };
    EXPECT_THAT(refuse("v 0 0 0\nv 1 0 0\nv 0 1 0\n"), HasSubstr("no face"));
    EXPECT_THAT(refuse("nonsense\n"), HasSubstr("no face"));
    EXPECT_THAT(refuse("v 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3\n"), HasSubstr("vertex 2"));
    EXPECT_THAT(refuse("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 3 0 0\nv 4 0 0\nv 3 1 0\nf 1 2 3\nf 4 5 6\n"),
                HasSubstr("not one piece"));
    EXPECT_THAT(refuse("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), HasSubstr("touches or crosses"));
}

TEST(OutlineMesh, ObjIndicesAreCheckedAndCountBackIfNegative) {
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    EXPECT_THAT(refuse_file("o.obj", triangle + "f 1 2 4\n"),
                AllOf(HasSubstr("line 4"), HasSubstr("vertex 4")));
    EXPECT_THAT(refuse_file("o.obj", triangle + "f 0 1 2\n"),
                AllOf(HasSubstr("line 4"), HasSubstr("vertex 0")));
    EXPECT_THAT(refuse_file("o.obj", triangle + "f -4 1 2\n"), HasSubstr("vertex -4"));
    EXPECT_THAT(refuse_file("o.obj", triangle + "f -9223372036854775808 1 2\n"), HasSubstr("vertex -92"));
    EXPECT_THAT(refuse_file("o.obj", triangle + "f 1 2 99999999999999999999\n"),
                HasSubstr("is not a whole number"));
    EXPECT_THAT(refuse_file("o.obj", triangle + "f 1 2\n"), HasSubstr("2 vertices"));
    EXPECT_THAT(refuse_file("o.obj", triangle + "f 1 2 2\n"), HasSubstr("twice"));
    EXPECT_THAT(refuse_file("o.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"),
                AllOf(HasSubstr("line 2"), HasSubstr("'nan'")));
    EXPECT_THAT(refuse_file("o.obj", "v 0 x 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\n"),
                AllOf(HasSubstr("line 1"), HasSubstr("'x'")));
    EXPECT_THAT(refuse_file("o.obj", "v 0 0\n"), HasSubstr("2 coordinates"));
    EXPECT_THAT(refuse_file("o.obj", triangle + "v 1 1 0\nf 1 2 3\nf 1 2 4\n"), HasSubstr("face 1"));
    const TemporaryFolder folder;
    EXPECT_DOUBLE_EQ(area_of(read_outline(folder.file("o.obj", triangle + "f -3/1/1 -2//2 -1 # rim\n"))),
                     0.5);
}

TEST(OutlineMesh, OffCountsAndIndicesAreChecked) {
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
    EXPECT_THAT(refuse_file("o.off", "OFF\n-3 1 0\n" + points + "3 0 1 2\n"),
                AllOf(HasSubstr("line 2"), HasSubstr("'-3'")));
    EXPECT_THAT(refuse_file("o.off", "OFF\n999999999999 1 0\n" + points + "3 0 1 2\n"),
                AllOf(HasSubstr("line 2"), HasSubstr("999999999999 vertices")));
    EXPECT_THAT(refuse_file("o.off", "OFF\n3 1 0\n" + points + "999999999999 0 1 2\n"),
                AllOf(HasSubstr("line 6"), HasSubstr("999999999999 vertices")));
    EXPECT_THAT(refuse_file("o.off", "OFF\n3 1 0\n" + points + "3 0 1 7\n"),
                AllOf(HasSubstr("line 6"), HasSubstr("vertex 7"), HasSubstr("there are 3")));
    EXPECT_THAT(refuse_file("o.off", "OFF 3 2 0\n" + points + "3 0 1 2\n"),
                AllOf(HasSubstr("line 6"), HasSubstr("face 1 of 2")));
    EXPECT_THAT(refuse_file("o.off", "OFF BINARY\n"), HasSubstr("binary"));
    EXPECT_THAT(refuse_file("o.off", "solid\n"), HasSubstr("'solid'"));
    EXPECT_THAT(refuse_file("o.off", ""), HasSubstr("ends before"));
}

TEST(OutlineMesh, PlyHeadersAndRowsAreChecked) {
    const std::string begin = "ply\nformat ascii 1.0\nelement vertex ";
    const std::string end =
        "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
    EXPECT_THAT(refuse_file("o.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"),
                AllOf(HasSubstr("line 4"), HasSubstr("end_header")));
    EXPECT_THAT(refuse_file("o.ply", begin + "999999999999" + end + "3 0 1 2\n"),
                AllOf(HasSubstr("line 3"), HasSubstr("999999999999 rows of vertex")));
    EXPECT_THAT(refuse_file("o.ply", begin + "-3" + end), AllOf(HasSubstr("line 3"), HasSubstr("'-3'")));
    EXPECT_THAT(refuse_file("o.ply", begin + "3" + end + "3 0 1 3\n"),
                AllOf(HasSubstr("line 13"), HasSubstr("vertex 3")));
    EXPECT_THAT(refuse_file("o.ply", begin + "3" + end + "4 0 1 2\n"), HasSubstr("too few"));
    EXPECT_THAT(refuse_file("o.ply", begin + "3" + end), HasSubstr("ends before face 0 of 1"));
    EXPECT_THAT(refuse_file("o.ply", begin + "3" + end + "3 0 1 0.5\n"), HasSubstr("0.5"));
    EXPECT_THAT(refuse_file("o.ply", "ply\nformat utf8 1.0\n"), HasSubstr("'utf8'"));
    EXPECT_THAT(refuse_file("o.ply", begin + "1\nproperty long x\n"), HasSubstr("'long'"));
    EXPECT_THAT(refuse_file("o.ply", begin + "3\nend_header\n"),
                AllOf(HasSubstr("element vertex"), HasSubstr("3 rows and no property")));
}

/// The same triangle in both byte orders; the bytes are written out by hand.
TEST(OutlineMesh, BinaryPlyIsReadInBothByteOrders) {
    const auto header = [](const std::string& order) {
        return "ply\nformat binary_" + order + "_endian 1.0\nelement vertex 3\nproperty float x\n" +
               "property float y\nproperty float z\nelement face 1\n" +
               "property list uchar ushort vertex_indices\nend_header\n";
    };
    const std::string zero(4, '\0');
    const std::string big_one("\x3f\x80\0\0", 4);
    const std::string little_one("\0\0\x80\x3f", 4);
    const auto body = [&](const std::string& one, const std::string& indices) {
        return zero + zero + zero + one + zero + zero + zero + one + zero + "\x03" + indices;
    };
    const std::string big = header("big") + body(big_one, std::string("\0\0\0\1\0\2", 6));
    const std::string little = header("little") + body(little_one, std::string("\0\0\1\0\2\0", 6));
    const TemporaryFolder folder;
    EXPECT_DOUBLE_EQ(area_of(read_outline(folder.file("big.ply", big))), 0.5);
    EXPECT_DOUBLE_EQ(area_of(read_outline(folder.file("little.ply", little))), 0.5);
    EXPECT_THAT(refuse_file("o.ply", little.substr(0, little.size() - 1)),
                AllOf(HasSubstr("face 0"), HasSubstr("ends here")));
}

TEST(OutlineMesh, AListOfAPlyHasANumberOfNumbers) {
    const std::string begin =
        "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
        "property float y\nproperty float z\nproperty list float uchar n\nend_header\n" +
        std::string(12, '\0');
    const auto count = [](const char* bytes) { return std::string(bytes, 4); };
    EXPECT_THAT(refuse_file("o.ply", begin + count("\0\0\xc0\x7f")),
                AllOf(HasSubstr("vertex 0"), HasSubstr("n promises nan numbers")));
    EXPECT_THAT(refuse_file("o.ply", begin + count("\0\0\x80\xbf")), HasSubstr("n promises -1 numbers"));
    EXPECT_THAT(refuse_file("o.ply", begin + count("\0\0\x80\x7f")), HasSubstr("n promises inf numbers"));
}

TEST(OutlineMesh, OneOfFarTooManyFacesIsRefusedBeforeItIsReadWhole) {
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 250'001; ++i) text += "f 1 2 3\n";
    EXPECT_THAT(refuse_file("huge.obj", text),
                AllOf(HasSubstr("line 250004"), HasSubstr("more than 250000 faces")));
}

}  // namespace THIS_TEST
}  // namespace fretwork::outlines
