// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/index_vector.hpp>

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace fretwork::base {
namespace THIS_TEST {

using Tile = Index<struct TileTag>;
using Node = Index<struct NodeTag>;
using TilesOfNames = IndexVector<Tile, std::string>;

template <class Container, class Place>
concept Counts = requires(Container& container, Place place) {
    container[place];
};

TEST(IndexVector, IsCountedByItsOwnRoleOnly) {
    EXPECT_TRUE((Counts<TilesOfNames, Tile>));
    EXPECT_TRUE((Counts<const TilesOfNames, Tile>));
    EXPECT_TRUE((Counts<TilesOfNames, std::size_t>));
    EXPECT_FALSE((Counts<TilesOfNames, Node>));
    EXPECT_FALSE((Counts<const TilesOfNames, Node>));
}

TEST(IndexVector, GivesTheElementOfAnIndex) {
    TilesOfNames names{"first", "second"};
    names[Tile(1)] += " tile";
    EXPECT_EQ(names[Tile(0)], "first");
    EXPECT_EQ(names[Tile(1)], "second tile");
}

TEST(IndexVector, HasTheIndicesOfItsElementsAndNoOther) {
    const TilesOfNames names{"first", "second"};
    EXPECT_TRUE(names.has(Tile(0)));
    EXPECT_TRUE(names.has(Tile(1)));
    EXPECT_FALSE(names.has(Tile(2)));
    EXPECT_FALSE(names.has(Tile()));
}

TEST(IndexVector, ListsItsIndicesInOrder) {
    const TilesOfNames names(3, "tile");
    std::vector<Tile> listed;
    for (const Tile tile : names.indices()) listed.push_back(tile);
    EXPECT_THAT(listed, testing::ElementsAre(Tile(0), Tile(1), Tile(2)));
}

}  // namespace THIS_TEST
}  // namespace fretwork::base
