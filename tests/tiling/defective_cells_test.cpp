// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/dual/edits.hpp>

#include <gtest/gtest.h>

namespace fretwork::tiling::detail {
namespace THIS_TEST {

Cell cell_of(std::initializer_list<int> vertices) {
    return {vertices.begin(), vertices.end()};
}

/// Three unit squares in a row from x = 0 to 3, all their vertices on loop 0.
Dual row_of_squares() {
    Dual dual;
    for (int x = 0; x <= 3; ++x) {
        dual.vertices.push_back({.place = {static_cast<double>(x), 0.0}, .loop = LoopIndex(0)});
        dual.vertices.push_back({.place = {static_cast<double>(x), 1.0}, .loop = LoopIndex(0)});
    }
    for (int x = 0; x < 3; ++x) dual.cells.push_back(cell_of({2 * x, 2 * x + 2, 2 * x + 3, 2 * x + 1}));
    return dual;
}

double area_of_all(const Dual& dual) {
    double area = 0.0;
    for (std::size_t cell = 0; cell < dual.cells.size(); ++cell)
        area += geometry::signed_area(polygon_of(dual, cell));
    return area;
}

TEST(DefectiveCells, TheEndOfALimbIsLeftOutWhereItIsSmallEnough) {
    const auto results = without_cell(row_of_squares(), 2, 1.5, {});
    ASSERT_EQ(results.size(), 2U);  // left out, and as one with its neighbour
    EXPECT_EQ(results[0].cells.size(), 2U);
    EXPECT_DOUBLE_EQ(area_of_all(results[0]), 2.0);
    EXPECT_EQ(results[1].cells.size(), 2U);
    EXPECT_DOUBLE_EQ(area_of_all(results[1]), 3.0);
}

TEST(DefectiveCells, ALargeEndIsNotLeftOut) {
    const auto results = without_cell(row_of_squares(), 2, 0.5, {});
    ASSERT_EQ(results.size(), 1U);
    EXPECT_DOUBLE_EQ(area_of_all(results[0]), 3.0);
}

TEST(DefectiveCells, ACellBetweenTwoOthersIsNotLeftOutButMadeOneWithEither) {
    const auto results = without_cell(row_of_squares(), 1, 1.5, {});
    ASSERT_EQ(results.size(), 2U);
    for (const Dual& dual : results) EXPECT_DOUBLE_EQ(area_of_all(dual), 3.0);
}

TEST(DefectiveCells, AUnionThatIsNotConvexIsNotMade) {
    Dual dual = row_of_squares();
    dual.vertices[7].place = {3.0, 2.0};  // the last square rises: with its neighbour it has a dent
    dual.vertices.push_back({.place = {1.5, 1.5}});
    dual.cells.push_back(cell_of({3, 5, 8}));  // and a third cell has the dent's vertex
    EXPECT_TRUE(without_cell(dual, 2, 0.0, {}).empty());
}

TEST(DefectiveCells, AnEndOnTwoLoopsIsNotLeftOut) {
    Dual dual = row_of_squares();
    dual.vertices[5].loop = LoopIndex(1);  // taking the last square away would open the hole
    EXPECT_EQ(without_cell(dual, 2, 1.5, {}).size(), 1U);
}

}  // namespace THIS_TEST
}  // namespace fretwork::tiling::detail
