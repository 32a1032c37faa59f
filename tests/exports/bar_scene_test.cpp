// SPDX-License-Identifier: GPL-3.0-or-later
// Bars in 3D: what a scene of them holds, the page and the picture that show it.
#include "sample.hpp"
#include "stops.hpp"

#include <fretwork/base/files/base64.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/space/bar_scene.hpp>
#include <fretwork/exports/space/pictures.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <cstring>
#include <numbers>
#include <png.h>

namespace fretwork::exports {
namespace THIS_TEST {

using namespace test;
using base::Json;
using testing::HasSubstr;
using testing::Not;

Scene bent_scene(Rows rows = Rows::EveryNode) {
    const simulation::Surface surface = sample_surface();
    Scene scene{surface, sample_conditions(surface), {{"bent", bent(surface, rows)}}};
    scene.picture.size = {240, 150};
    return scene;
}

simulation::LoadCase cantilever() {
    simulation::LoadCase load_case;
    load_case.name = "cantilever";
    load_case.supports.push_back({simulation::NodesAtSide{simulation::Side::Left}, mechanics::DofSet::all()});
    load_case.loads.push_back({simulation::NodesAtSide{simulation::Side::Right}, {0, 0, -0.02}});
    return load_case;
}

Scene solved_scene(const char* model) {
    const simulation::Surface surface = sample_surface();
    return {surface, std::nullopt, {{model, simulation::simulate(surface, cantilever(), {.model = model})}}};
}

// ---- the scene ----

TEST(BarScene, HasEveryBarOfTheSurfaceWithItsSection) {
    const Scene scene = bent_scene();
    const BarScene bars = make_bar_scene(scene);
    EXPECT_EQ(bars.bars.size(), surface_lines(scene.surface).lines.size());
    const mechanics::Section& section = scene.surface.setting.section;
    EXPECT_NEAR(bars.width * bars.height, section.area, 1e-12 * section.area);
    EXPECT_EQ(bars.supports.size(), scene.conditions->supports.size());
    for (const BarScene::Field& field : bars.fields) EXPECT_EQ(field.values.size(), 2 * bars.bars.size());
}

TEST(BarScene, HasOneSupportForTheEntriesOfANode) {
    Scene scene = bent_scene();
    const mechanics::DofSet rotations{{false, false, false, true, true, true}};
    scene.conditions->supports = {{mechanics::NodeIndex(0), mechanics::DofSet::translations()},
                                  {mechanics::NodeIndex(0), rotations}};
    const BarScene bars = make_bar_scene(scene);
    ASSERT_EQ(bars.supports.size(), 1U);
    EXPECT_EQ(bars.supports[0].kind, BarScene::Support::Kind::Clamped);
}

TEST(BarScene, OfACondensedResultHasItsBarsBackAndNotOnlyInterfaceNodes) {
    const BarScene full = make_bar_scene(solved_scene("full"));
    const BarScene corotational = make_bar_scene(solved_scene("corotational"));
    EXPECT_EQ(corotational.bars, full.bars);
    // The model is off by some per cent; a bar that stayed at rest would be off by all of it.
    EXPECT_LT((corotational.motion - full.motion).norm(), 0.1 * full.motion.norm());
}

TEST(BarScene, OfAResultThatDoesNotSayItsModelHasTheLinesThroughInterfaceNodes) {
    const BarScene bars = make_bar_scene(bent_scene(Rows::InterfaceNodes));
    EXPECT_EQ(bars.bars.size(), 6 * sample_surface().tessellation.tiles.size());
    EXPECT_TRUE(bars.motion.allFinite());
}

TEST(ValueRange, LeavesOutAFewValuesFarAboveAllOthersAndIsEvenAroundZero) {
    std::vector<double> values(1000, 1.0);
    EXPECT_EQ(value_range(values).to, 1.0);
    values[3] = 50.0;
    EXPECT_EQ(value_range(values).to, 1.0);
    EXPECT_EQ(value_range(values).from, 0.0);
    values[4] = -0.5;
    EXPECT_EQ(value_range(values).from, -1.0);
    values[5] = std::nan("");
    EXPECT_EQ(whole_range(values).to, 50.0);
    EXPECT_EQ(value_range({}).to, 0.0);
}

// ---- the page ----

Json data_of(const std::string& page) {
    const std::string start = "<script type=\"application/json\" id=\"data\">";
    const std::size_t from = page.find(start) + start.size();
    return Json::parse(page.substr(from, page.find("</script>", from) - from));
}

template <class Number>
std::vector<Number> unpacked(const Json& text) {
    const std::string bytes = base::decode_base64(text.get<std::string>(), "test");
    std::vector<Number> numbers(bytes.size() / sizeof(Number));
    std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
}

TEST(ViewPage, HoldsTheSceneAndNamesNothingOutsideOfItself) {
    const Scene scene = bent_scene();
    const std::string page = view_html(scene);
    const BarScene bars = make_bar_scene(scene);
    const Json data = data_of(page);
    const auto place = unpacked<float>(data["place"]);
    ASSERT_EQ(place.size(), 3 * bars.nodes.size());
    EXPECT_FLOAT_EQ(place[3], static_cast<float>(bars.nodes[1].x()));
    EXPECT_EQ(unpacked<float>(data["motion"]).size(), 6 * bars.nodes.size());
    for (const std::uint32_t node : unpacked<std::uint32_t>(data["ends"])) EXPECT_LT(node, bars.nodes.size());
    // Utilization is there with a strength only.
    EXPECT_EQ(data["fields"].size(), bar_field_names().size() - 1);
    for (const char* outside : {"http://", "https://", "src=", "href=", "@import", "fetch(", "import "})
        EXPECT_THAT(page, Not(HasSubstr(outside)));
}

TEST(ViewPage, LoadsAreThoseOfTheConditions) {
    const Scene scene = bent_scene();
    Eigen::Vector3d given = Eigen::Vector3d::Zero();
    for (const mechanics::NodalLoad& load : scene.conditions->loads) given += load.force;
    Eigen::Vector3d shown = Eigen::Vector3d::Zero();
    for (const BarScene::Load& load : make_bar_scene(scene).loads) shown += load.force;
    EXPECT_GT(given.norm(), 0.0);
    EXPECT_LT((given - shown).norm(), 1e-12 * given.norm());
    EXPECT_EQ(data_of(view_html(scene))["loads"].size(), make_bar_scene(scene).loads.size());
}

TEST(ViewPage, FieldsComeBackWithinTheStepOfTheirSixteenBits) {
    const Scene scene = solved_scene("full");
    const BarScene bars = make_bar_scene(scene);
    const Json data = data_of(view_html(scene));
    for (std::size_t f = 0; f < bars.fields.size(); ++f) {
        const Json& field = data["fields"][f];
        const double low = field["low"];
        const double step = (field["high"].get<double>() - low) / 65534.0;
        const auto packed = unpacked<std::uint16_t>(field["values"]);
        for (std::size_t i = 0; i < packed.size(); ++i)
            EXPECT_NEAR(low + step * packed[i], bars.fields[f].values[i], 0.51 * step);
    }
}

TEST(ViewPage, ANameThatEndsTheScriptDoesNotEndIt) {
    Scene scene = bent_scene();
    scene.results.front().label = "</script><script>alert(1)</script>";
    const std::string page = view_html(scene);
    EXPECT_THAT(page, Not(HasSubstr("alert(1)</script>")));
    EXPECT_THAT(data_of(page)["title"].get<std::string>(), HasSubstr(scene.results.front().label));
}

// ---- the picture ----

struct Image {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<std::uint8_t> bytes;
    [[nodiscard]] std::uint8_t opacity(std::size_t x, std::size_t y) const {
        return bytes[4 * (y * width + x) + 3];
    }
    [[nodiscard]] std::size_t opaque_count() const {
        std::size_t count = 0;
        for (std::size_t i = 3; i < bytes.size(); i += 4) count += bytes[i] == 255 ? 1 : 0;
        return count;
    }
};

Image read_png(const std::string& text) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&png, text.data(), text.size()) == 0) return {};
    png.format = PNG_FORMAT_RGBA;
    Image image{png.width, png.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png))};
    png_image_finish_read(&png, nullptr, image.bytes.data(), 0, nullptr);
    return image;
}

TEST(Picture, ShowsBarsOnTransparentGround) {
    const Image image = read_png(picture_png(bent_scene()));
    ASSERT_EQ(image.width, 240U);
    ASSERT_EQ(image.height, 150U);
    for (const std::size_t x : {std::size_t{0}, image.width - 1}) {
        for (const std::size_t y : {std::size_t{0}, image.height - 1}) EXPECT_EQ(image.opacity(x, y), 0);
    }
    EXPECT_GT(image.opaque_count(), image.bytes.size() / 4 / 50) << "bars cover some of it";
}

TEST(Picture, IsFilledFromEverySide) {
    Scene scene = bent_scene();
    for (const double azimuth : {0.0, 1.0, 2.5, 4.0}) {
        for (const double elevation : {-0.5, 0.1, 1.0, std::numbers::pi / 2}) {
            scene.view = ViewOptions{azimuth, elevation};
            const Image image = read_png(picture_png(scene));
            EXPECT_GT(image.opaque_count(), 200U) << azimuth << " " << elevation;
            for (std::size_t x = 0; x < image.width; ++x)
                EXPECT_LT(image.opacity(x, 0), 255) << "nothing is cut off";
        }
    }
}

TEST(Picture, TheShapeAtRestIsAGhostBehindTheBars) {
    Scene scene = bent_scene();
    const Image with = read_png(picture_png(scene));
    scene.picture.ghost = PictureOptions::Ghost::Hidden;
    const Image without = read_png(picture_png(scene));
    const auto veiled = [](const Image& image) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < image.bytes.size(); i += 4) {
            const bool is_grey = image.bytes[i] > 100 && image.bytes[i] < 180;
            count += is_grey && image.bytes[i + 3] > 40 && image.bytes[i + 3] < 200 ? 1 : 0;
        }
        return count;
    };
    EXPECT_GT(veiled(with), veiled(without) + 500);
    scene.results.clear();
    const std::string at_rest = picture_png(scene);
    scene.picture.ghost = PictureOptions::Ghost::Shown;
    EXPECT_EQ(picture_png(scene), at_rest) << "there is none of a surface at rest";
}

/// Before the first light, between two, and on the ground.
TEST(Picture, StopsWhenAsked) {
    for (const std::size_t look : {0U, 5U, 60U}) {
        const fretwork::test::StopAtLook stop(look);
        Scene scene = bent_scene();
        scene.control = stop.control();
        EXPECT_THROW((void)picture_png(scene), base::Stopped) << look;
    }
}

TEST(Picture, OfAFieldThatThereIsNotIsRefusedAndNamesThoseThatThereAre) {
    Scene scene = bent_scene();
    scene.picture.colour = "stres";
    EXPECT_THAT(complaint_of([&] { (void)picture_png(scene); }), HasSubstr("stress"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
