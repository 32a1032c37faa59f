// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/space/detail/picture_legend.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace fretwork::exports::detail {
namespace THIS_TEST {

const BarScene::Field kField{"displacement", "Displacement", "mm", 1e3, {0.0, 0.25, 1.0}};
const std::string kNote = "joints: stiff";

TEST(PictureLegend, StandsBelowThePictureOnTransparentGround) {
    constexpr PixelSize kSize{400, 300};
    const int height = legend_height(kSize);
    ASSERT_GT(height, 0);
    const std::vector<std::uint8_t> picture(std::size_t{4} * 400 * static_cast<std::size_t>(300 - height),
                                            77);
    const auto whole = with_legend(picture, kSize, {kField, kNote});
    ASSERT_EQ(whole.size(), std::size_t{4} * 400 * 300);
    EXPECT_TRUE(std::equal(picture.begin(), picture.end(), whole.begin())) << "it covers the surface";
    std::size_t opaque = 0;
    for (std::size_t i = picture.size() + 3; i < whole.size(); i += 4) {
        EXPECT_TRUE(whole[i] == 0 || whole[i] == 255);
        opaque += whole[i] == 255 ? 1 : 0;
    }
    EXPECT_GT(opaque, 1000U);
    EXPECT_LT(opaque, (whole.size() - picture.size()) / 8) << "more than letters and colours";
}

TEST(PictureLegend, IsLeftOutOfSmallPictures) {
    const std::vector<std::uint8_t> picture(std::size_t{4} * 200 * 100, 77);
    EXPECT_EQ(legend_height({200, 100}), 0);
    EXPECT_EQ(with_legend(picture, {200, 100}, {kField, kNote}), picture);
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports::detail
