// SPDX-License-Identifier: GPL-3.0-or-later
#include "outlines/outlines.hpp"

#include <fretwork/base/files/file.hpp>
#include <fretwork/outlines/outline.hpp>

#include <limits>
#include <regex>

namespace fretwork::outlines {
namespace THIS_TEST {

using geometry::Polygon;
using test::complaint_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

TEST(Outline, IsTheSameIfLinesEndInCrLf) {
    const TemporaryFolder folder;
    for (const auto& path :
         {example_outline("specimen.svg"), data_file("slot.dxf"), data_file("square_with_window.obj"),
          data_file("quadrilateral.ply"), data_file("two_triangles.off")}) {
        const std::string text = std::regex_replace(base::read_text_file(path), std::regex("\r?\n"), "\r\n");
        const Outline expected = read_outline(path);
        const Outline outline = read_outline(folder.file("o" + path.extension().string(), text));
        EXPECT_EQ(outline.boundary, expected.boundary) << path;
        EXPECT_EQ(outline.holes, expected.holes) << path;
    }
}

const Polygon kSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Polygon square_at(double x, double y, double side) {
    return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

TEST(Outline, TheBoundaryTurnsLeftAndHolesTurnRightHoweverTheyCome) {
    const Polygon hole = square_at(0.2, 0.2, 0.2);
    for (const bool is_reversed : {false, true}) {
        Polygon boundary = kSquare;
        Polygon inner = hole;
        if (is_reversed) {
            std::reverse(boundary.begin(), boundary.end());
            std::reverse(inner.begin(), inner.end());
        }
        const Outline outline = make_outline(boundary, {inner});
        EXPECT_DOUBLE_EQ(geometry::signed_area(outline.boundary), 1.0);
        EXPECT_NEAR(geometry::signed_area(outline.holes.at(0)), -0.04, 1e-15);
        EXPECT_EQ(outline.boundary.front(), boundary.front());
    }
}

/// The area is that of the same file with the line ends of Unix; both are read by the same steps.
TEST(Outline, FilesMayHaveTheLineEndsOfWindows) {
    const TemporaryFolder folder;
    for (const std::filesystem::path& path :
         {data_file("slot.dxf"), data_file("square_with_window.obj"), data_file("quadrilateral.ply"),
          data_file("two_triangles.off"), example_outline("specimen.svg")}) {
        std::string text = base::read_text_file(path);
        ASSERT_EQ(text.find('\r'), std::string::npos) << path;
        for (std::size_t end = 0; (end = text.find('\n', end)) != std::string::npos; end += 2)
            text.replace(end, 1, "\r\n");
        const std::string name = "windows" + path.extension().string();
        EXPECT_DOUBLE_EQ(area_of(read_outline(folder.file(name, text))), area_of(read_outline(path))) << path;
    }
}

TEST(Outline, ACrossingNamesItsTwoSides) {
    EXPECT_THAT(complaint_of([] {
                    make_outline({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {});
                }),
                AllOf(HasSubstr("side 0 of the boundary"), HasSubstr("side 2 of the boundary"),
                      HasSubstr("from (0, 0) to (1, 1)")));
}

TEST(Outline, TouchingIsRefusedAsCrossingIs) {
    EXPECT_THAT(complaint_of([] {
                    make_outline({{0, 0}, {2, 0}, {1, 1}, {1, 0}, {0, 1}}, {});
                }),
                HasSubstr("touches or crosses"));
    EXPECT_THAT(complaint_of([] {
                    make_outline({{0, 0}, {2, 0}, {1, 0}, {1, 1}}, {});
                }),
                HasSubstr("touches or crosses"));  // folds back
    EXPECT_THAT(complaint_of([] { make_outline(kSquare, {square_at(0, 0.2, 0.2)}); }),
                AllOf(HasSubstr("of the boundary"), HasSubstr("of hole 0")));
    EXPECT_THAT(complaint_of([] {
                    make_outline(kSquare, {square_at(0.2, 0.2, 0.2), square_at(0.4, 0.4, 0.2)});
                }),
                AllOf(HasSubstr("of hole 0"), HasSubstr("of hole 1")));
}

TEST(Outline, ATouchIsDecidedExactly) {
    // The apex lies on the side from (0, 0) to (1, 3e-17), or the least bit above it.
    const double tiny = 3e-17;
    EXPECT_NO_THROW(
        make_outline({{0, 0}, {1, 0}, {1, 1}, {0.5, std::numeric_limits<double>::denorm_min()}, {0, 1}}, {}));
    EXPECT_THROW(make_outline({{0, 0}, {1, 2 * tiny}, {1, 1}, {0.5, tiny}, {0, 1}}, {}), base::GeometryError);
}

TEST(Outline, HolesLieInsideAndNotInEachOther) {
    EXPECT_THAT(complaint_of([] { make_outline(kSquare, {square_at(2, 0, 0.5)}); }),
                HasSubstr("hole 0 lies outside the boundary"));
    EXPECT_THAT(complaint_of([] {
                    make_outline(kSquare, {square_at(0.1, 0.1, 0.5), square_at(0.2, 0.2, 0.1)});
                }),
                HasSubstr("hole 1 lies inside hole 0"));
}

TEST(Outline, PointsAreEnoughFiniteAndApart) {
    EXPECT_THAT(complaint_of([] {
                    make_outline({{0, 0}, {1, 0}}, {});
                }),
                HasSubstr("the boundary has 2 points"));
    EXPECT_THAT(complaint_of([] { make_outline(kSquare, {{}}); }), HasSubstr("hole 0 has 0 points"));
    EXPECT_THAT(complaint_of([] {
                    make_outline({{0, 0}, {1, 0}, {1, 0}, {0, 1}}, {});
                }),
                HasSubstr("has no length"));
    EXPECT_THAT(complaint_of([] {
                    make_outline({{0, 0}, {1, 0}, {std::numeric_limits<double>::quiet_NaN(), 1}}, {});
                }),
                HasSubstr("point 2 of the boundary is (nan, 1)"));
}

TEST(Outline, PointsBeyondTheLimitsOfLengthsAreRefused) {
    EXPECT_THAT(complaint_of([] {
                    make_outline({{0, 0}, {1e308, 0}, {1e308, 1e308}}, {});
                }),
                AllOf(HasSubstr("point 1 of the boundary is (1e+308, 0)"),
                      HasSubstr("a number from -1e+12 to 1e+12 (m)")));
    EXPECT_THAT(complaint_of([] { make_outline(kSquare, {square_at(-1.6e308, -1.6e308, 1.7e308)}); }),
                HasSubstr("point 0 of hole 0 is (-1.6e+308, -1.6e+308)"));
    EXPECT_DOUBLE_EQ(area_of(make_outline({{-1e12, 0}, {1e12, 0}, {0, 1e12}}, {})), 1e24);
}

TEST(OutlineJson, ReadsBoundaryAndHoles) {
    const Outline outline = read_outline(data_file("frame.json"));
    EXPECT_EQ(outline.holes.size(), 1U);
    EXPECT_NEAR(area_of(outline), 0.3 * 0.2 - 0.5 * 0.1 * 0.1, 1e-15);
}

TEST(OutlineJson, ReadsBackWhatWasWritten) {
    const TemporaryFolder folder;
    const Outline outline = read_outline(example_outline("example_b.svg"));
    write_outline(outline, folder.path() / "o.json");
    const Outline read = read_outline(folder.path() / "o.json");
    EXPECT_EQ(read.boundary, outline.boundary);
    EXPECT_EQ(read.holes, outline.holes);
}

TEST(OutlineJson, ComplaintsNameFileAndPlace) {
    const TemporaryFolder folder;
    const auto refuse = [&](const std::string& content) {
        const auto path = folder.file("o.json", content);
        std::string message = complaint_of([&] { read_outline(path); });
        EXPECT_THAT(message, HasSubstr("o.json"));
        return message;
    };
    const std::string format = R"({"format":"fretwork/outline/1",)";
    EXPECT_THAT(refuse("{"), HasSubstr("malformed JSON"));
    EXPECT_THAT(refuse(R"({"format":"fretwork/project/1","boundary":[]})"), HasSubstr("/format"));
    EXPECT_THAT(refuse(format + R"("holes":[]})"), HasSubstr("'boundary' is missing"));
    EXPECT_THAT(refuse(format + R"("boundary":[[0,0],[1,0],[0,1]],"hole":[]})"),
                HasSubstr("unknown key 'hole'"));
    EXPECT_THAT(refuse(format + R"("boundary":[[0,0],[1,0]]})"), HasSubstr("/boundary"));
    EXPECT_THAT(refuse(format + R"("boundary":[[0,0],[1,0],[0,1,2]]})"), HasSubstr("/boundary/2"));
    EXPECT_THAT(refuse(format + R"("boundary":[[0,0],[1,0],[0,1e999]]})"), HasSubstr("o.json"));
    EXPECT_THAT(refuse(format + R"("boundary":[[0,0],[1,0],[0,1]],"holes":[[[0.1,0.1],[0.2]]]})"),
                HasSubstr("/holes/0/1"));
    EXPECT_THAT(refuse(format + R"("boundary":[[0,0],[1,1],[1,0],[0,1]]})"), HasSubstr("touches or crosses"));
}

TEST(ReadOutline, TheEndingTellsTheKind) {
    const TemporaryFolder folder;
    EXPECT_THAT(complaint_of([&] { read_outline(folder.file("o.step", "")); }), HasSubstr("'.step'"));
    for (const char* name : {"none.json", "none.svg", "none.dxf", "none.obj", "none.ply", "none.off"}) {
        EXPECT_THAT(complaint_of([&] { read_outline(folder.path() / name); }), HasSubstr(name));
    }
    EXPECT_NO_THROW(read_outline(folder.file("O.JSON", base::read_text_file(data_file("frame.json")))));
}

TEST(ReadOutline, TheExamplesHaveTheSizesOfThePaper) {
    struct Example {
        const char* name;
        double width;
        double height;
        std::size_t holes;
    };
    // The paper, Table 3 and Section 7.3. The drawings are rounded to hundredths of a millimetre.
    for (const Example& example :
         {Example{"example_a.svg", 0.71, 0.40, 1}, Example{"example_b.svg", 1.08, 0.91, 2},
          Example{"example_c.svg", 0.80, 0.64, 0}, Example{"specimen.svg", 0.18, 0.26, 0}}) {
        const Outline outline = read_outline(example_outline(example.name));
        const auto [low, high] = box_of(outline.boundary);
        EXPECT_NEAR(high.x - low.x, example.width, 1e-4) << example.name;
        EXPECT_NEAR(high.y - low.y, example.height, 1e-4) << example.name;
        EXPECT_EQ(outline.holes.size(), example.holes) << example.name;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::outlines
