// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines with parts that are far smaller than a tile: needles, slits, near touches, points that are almost
// one.
#include "outlines/outlines.hpp"

#include <fretwork/tiling/tessellate.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <cmath>
#include <random>

namespace fretwork::tiling {
namespace THIS_TEST {

using geometry::Point2;
using geometry::Polygon;
using test::complaint_of;
using testing::AllOf;
using testing::HasSubstr;

constexpr double kSide = 0.026;  // m, of the tiles

TessellationResult tile(const outlines::Outline& outline, int relaxations = 50) {
    const auto layout = pattern::find_node_layout("paper7");
    TessellationResult result =
        tessellate(outline, layout, {.edge_length = kSide, .relaxation_iterations = relaxations});
    validate(result.tessellation, layout);
    return result;
}

std::string complaint_about(const outlines::Outline& outline) {
    return complaint_of([&] { tile(outline); });
}

const Polygon kPlate = {{0, 0}, {0.4, 0}, {0.4, 0.3}, {0, 0.3}};

class TinyGap : public testing::TestWithParam<double> {};

TEST_P(TinyGap, BetweenAHoleAndTheBoundaryIsRefusedWithItsPlace) {
    const outlines::Outline outline =
        outlines::make_outline(kPlate, {{{0.2, GetParam()}, {0.25, 0.1}, {0.15, 0.1}}});
    EXPECT_THAT(complaint_about(outline), AllOf(HasSubstr("from another part of the outline"),
                                                HasSubstr("near (0.2, "), HasSubstr("need 2.6e-06 m")));
}
TEST_P(TinyGap, BetweenAHoleAndAnAxisChangesNothing) {
    Polygon plate = kPlate;
    for (Point2& p : plate) p.y -= 0.15;
    const outlines::Outline outline =
        outlines::make_outline(plate, {{{0.2, GetParam()}, {0.25, 0.1}, {0.15, 0.1}}});
    const outlines::Outline exact = outlines::make_outline(plate, {{{0.2, 0}, {0.25, 0.1}, {0.15, 0.1}}});
    EXPECT_EQ(tile(outline).report.tiles, tile(exact).report.tiles);
}
INSTANTIATE_TEST_SUITE_P(Sizes, TinyGap, testing::Values(1e-300, 1e-200, 1e-170, 1e-150, 1e-20));

TEST(DegenerateOutline, ANeedleIsRefusedWithItsWidthAndPlace) {
    const outlines::Outline pointed = outlines::make_outline(
        {{0, 0}, {1, 0}, {1, 0.5}, {100, 0.5 + 1e-9}, {1, 0.5 + 2e-9}, {1, 1}, {0, 1}}, {});
    EXPECT_THAT(complaint_about(pointed), AllOf(HasSubstr("the boundary is"), HasSubstr("needle")));
    const outlines::Outline blunt = outlines::make_outline(
        {{0, 0}, {1, 0}, {1, 0.5}, {101, 0.5}, {101, 0.5 + 1e-7}, {1, 0.5 + 1e-7}, {1, 1}, {0, 1}}, {});
    EXPECT_THAT(complaint_about(blunt), HasSubstr("is 1e-07 m from"));
    const outlines::Outline strip = outlines::make_outline({{0, 0}, {10, 0}, {10, 1e-7}, {0, 1e-7}}, {});
    EXPECT_THAT(complaint_about(strip), HasSubstr("is 1e-07 m from"));
}

TEST(DegenerateOutline, ASlitIsRefusedWhereItIsTooNarrowAndTakenWhereItIsNot) {
    const auto with_slit = [](double width) {
        return outlines::make_outline({{0, 0},
                                       {0.4, 0},
                                       {0.4, 0.15},
                                       {0.3, 0.15},
                                       {0.3, 0.15 + width},
                                       {0.4, 0.15 + width},
                                       {0.4, 0.3},
                                       {0, 0.3}},
                                      {});
    };
    EXPECT_THAT(complaint_about(with_slit(1e-6)), HasSubstr("is 1e-06 m from"));
    EXPECT_NO_THROW(tile(with_slit(1e-4)));
}

TEST(DegenerateOutline, AHoleLikeAPointIsRefused) {
    const outlines::Outline outline =
        outlines::make_outline(kPlate, {{{0.2, 0.1}, {0.2 + 1e-6, 0.1}, {0.2, 0.1 + 1e-6}}});
    EXPECT_THAT(complaint_about(outline), AllOf(HasSubstr("hole 0"), HasSubstr("near (0.2, 0.1)")));
}

TEST(DegenerateOutline, ASharpTipIsNoNeedle) {
    // Tips of 6 degrees occur in drawings. No tile fits into them, and they stay uncovered.
    const outlines::Outline kite = outlines::make_outline({{0, 0}, {0.2, -0.1}, {2, 0}, {0.2, 0.1}}, {});
    EXPECT_LT(tile(kite).report.covered_share, 1.0);
}

TEST(DegenerateOutline, PointsThatAreAlmostOneAreLeftOutAndCounted) {
    const outlines::Outline outline =
        outlines::make_outline({{0, 0}, {1e-200, 0}, {0.4, 0}, {0.4, 0.3}, {0.4 - 1e-9, 0.3}, {0, 0.3}}, {});
    const TessellationReport report = tile(outline).report;
    EXPECT_EQ(report.negligible_points, 2);
    EXPECT_EQ(report.tiles, tile(outlines::make_outline(kPlate, {})).report.tiles);
}

TEST(DegenerateOutline, APointThatIsTheWholeOutlineIsRefused) {
    const outlines::Outline speck = outlines::make_outline({{0, 0}, {1e-12, 0}, {0, 1e-12}}, {});
    EXPECT_THAT(complaint_about(speck), HasSubstr("the boundary has 1 points"));
}

TEST(DegenerateOutline, FarFromTheOriginDetailsWouldBeLost) {
    Polygon far = kPlate;
    for (Point2& p : far) p.x = p.x * 4 + 1e10;
    EXPECT_THAT(complaint_about(outlines::make_outline(far, {})),
                AllOf(HasSubstr("1e+10 m from the origin"), HasSubstr("move it to within 2.6e+07 m")));
}

TEST(DegenerateOutline, AVeryLongRimIsRefusedBeforeWorkBegins) {
    Polygon comb{{0, -1}};
    for (int tooth = 0; tooth < 4000; ++tooth) {
        comb.push_back({1e-3 * tooth, 0});
        comb.push_back({1e-3 * tooth, 100});
        comb.push_back({1e-3 * (tooth + 0.5), 100});
        comb.push_back({1e-3 * (tooth + 0.5), 0});
    }
    comb.push_back({4, -1});
    EXPECT_THAT(complaint_about(outlines::make_outline(comb, {})), HasSubstr("the most"));
}

/// Outlines by chance, of coordinates that are likely to be equal, nearly equal, or tiny.
class Degenerate {
  public:
    explicit Degenerate(std::uint32_t seed) : random_(seed) {}

    outlines::Outline make() {
        Polygon boundary = {{0, 0}, {0.15, 0}, {0.15, 0.12}, {0, 0.12}};
        if (chance(0.7)) add_spike(boundary);
        std::vector<Polygon> holes;
        if (chance(0.7)) holes.push_back(hole());
        for (Point2& p : boundary) p = {nudged(p.x), nudged(p.y)};
        return outlines::make_outline(boundary, holes);
    }

  private:
    bool chance(double share) { return uniform(0, 1) < share; }
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;  // the same everywhere
    }
    /// From 1e-300 to 0.1, each order of magnitude as likely as another; half of them above 1e-20.
    double tiny() { return std::pow(10, chance(0.5) ? uniform(-20, -1) : uniform(-300, -1)); }
    double nudged(double x) { return chance(0.2) ? x + (chance(0.5) ? 1 : -1) * tiny() : x; }
    /// Out of a side, or into it.
    void add_spike(Polygon& boundary) {
        const double width = tiny();
        const double tip = uniform(-0.1, 0.3);
        boundary.insert(boundary.begin() + 2,
                        {{0.15, 0.06}, {0.15 + tip, 0.06 + uniform(0, 1) * width}, {0.15, 0.06 + width}});
    }
    Polygon hole() {
        const double size = chance(0.5) ? 0.03 : tiny();
        const double height = chance(0.5) ? size : tiny();
        const Point2 corner{chance(0.5) ? tiny() : 0.05, chance(0.5) ? tiny() : 0.04};
        return {corner, {corner.x + size, nudged(corner.y)}, {corner.x + size, corner.y + height}};
    }

    std::mt19937 random_;
};

TEST(DegenerateOutline, ByChanceIsTiledValidlyOrRefusedInOneLine) {
    int tiled = 0;
    int refused = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        try {
            const outlines::Outline outline = Degenerate(seed).make();
            EXPECT_GT(tile(outline, 5).report.tiles, 0);
            ++tiled;
        } catch (const base::InputError& error) {  // GeometryError is one
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            ++refused;
        }
    }
    EXPECT_GT(tiled, 30);  // neither branch may become empty
    EXPECT_GT(refused, 30);
}

TEST(TessellateLimits, ThousandsOfSmallHolesAreRefusedWithWhatTheyWouldTake) {
    std::vector<geometry::Polygon> holes;
    for (int column = 0; column < 100; ++column) {
        for (int row = 0; row < 100; ++row) {
            const double x = 0.01 * column + 0.003;
            const double y = 0.01 * row + 0.003;
            holes.push_back({{x, y}, {x, y + 0.004}, {x + 0.004, y + 0.004}, {x + 0.004, y}});
        }
    }
    const outlines::Outline sheet = outlines::make_outline({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, holes);
    const std::string complaint = test::complaint_of(
        [&] { tessellate(sheet, pattern::find_node_layout("paper7"), {.edge_length = 0.026}); });
    EXPECT_THAT(complaint,
                testing::AllOf(testing::HasSubstr("10000 holes"), testing::HasSubstr("000 tiles and"),
                               testing::HasSubstr("GB of memory"), testing::HasSubstr("leave out")));
}

}  // namespace THIS_TEST
}  // namespace fretwork::tiling
