// SPDX-License-Identifier: GPL-3.0-or-later
// The animated glTF is read back as its standard says, and its states are those of the result.
#include "sample.hpp"
#include "stops.hpp"

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/exports/space/detail/bar_colours.hpp>
#include <fretwork/exports/space/pictures.hpp>
#include <fretwork/simulation/stages.hpp>

#include <cstring>

namespace fretwork::exports {
namespace THIS_TEST {

using namespace test;
using base::Json;
using testing::HasSubstr;

constexpr int kSteps = 4;

Scene moving_scene() {
    const simulation::Surface surface = sample_surface();
    simulation::SurfaceResult result = bent(surface, Rows::EveryNode);
    for (int k = 1; k <= kSteps; ++k) {
        mechanics::Solution step = bent(surface, Rows::EveryNode, k / static_cast<double>(kSteps)).solution;
        step.load_factor = k / static_cast<double>(kSteps);
        result.load_steps.push_back(std::move(step));
    }
    return {surface, std::nullopt, {{"bent", std::move(result)}}};
}

std::uint32_t word_at(const std::string& text, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, text.data() + at, sizeof word);
    return word;
}

/// The two chunks of a file, whose header and lengths fit.
struct GlbFile {
    Json json;
    std::string binary;

    explicit GlbFile(const std::string& text) {
        EXPECT_EQ(text.substr(0, 4), "glTF");
        EXPECT_EQ(word_at(text, 4), 2U);
        EXPECT_EQ(word_at(text, 8), text.size());
        const std::size_t length = word_at(text, 12);
        EXPECT_EQ(text.substr(16, 4), "JSON");
        EXPECT_EQ(length % 4, 0U);
        json = Json::parse(text.substr(20, length));
        const std::size_t second = 20 + length;
        EXPECT_EQ(text.substr(second + 4, 4), std::string("BIN\0", 4));
        EXPECT_EQ(second + 8 + word_at(text, second), text.size());
        binary = text.substr(second + 8);
        EXPECT_EQ(json["buffers"][0]["byteLength"], binary.size());
    }

    /// The numbers of an accessor.
    template <class Number>
    [[nodiscard]] std::vector<Number> numbers(const Json& index) const {
        const Json& accessor = json["accessors"][index.get<std::size_t>()];
        const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        std::vector<Number> numbers(view["byteLength"].get<std::size_t>() / sizeof(Number));
        std::memcpy(numbers.data(), binary.data() + view["byteOffset"].get<std::size_t>(),
                    numbers.size() * sizeof(Number));
        return numbers;
    }
    [[nodiscard]] const Json& primitive() const { return json["meshes"][0]["primitives"][0]; }
    [[nodiscard]] std::vector<float> floats(const char* attribute) const {
        return numbers<float>(primitive()["attributes"][attribute]);
    }
    [[nodiscard]] std::vector<float> floats_in_state(const char* attribute, std::size_t state) const {
        std::vector<float> sum = floats(attribute);
        const auto more = numbers<float>(primitive()["targets"][state][attribute]);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += more[i];
        return sum;
    }
};

TEST(MotionFile, AccessorsLieInTheirViewsAndViewsInTheBuffer) {
    const GlbFile file(motion_glb(moving_scene()));
    const std::map<int, std::size_t> bytes = {{5126, 4}, {5125, 4}, {5123, 2}};
    const std::map<std::string, std::size_t> widths = {{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
    std::size_t end = 0;
    for (const Json& view : file.json["bufferViews"]) {
        EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0U);
        EXPECT_GE(view["byteOffset"].get<std::size_t>(), end) << "they do not overlap";
        end = view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>();
    }
    EXPECT_LE(end, file.binary.size());
    for (const Json& accessor : file.json["accessors"]) {
        const Json& view = file.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        EXPECT_EQ(accessor["count"].get<std::size_t>() * widths.at(accessor["type"]) *
                      bytes.at(accessor["componentType"]),
                  view["byteLength"].get<std::size_t>());
    }
}

TEST(MotionFile, BoundsHoldWhatTheirAccessorsHold) {
    const GlbFile file(motion_glb(moving_scene()));
    std::size_t bounded = 0;
    for (std::size_t a = 0; a < file.json["accessors"].size(); ++a) {
        const Json& accessor = file.json["accessors"][a];
        if (!accessor.contains("min")) continue;
        ++bounded;
        const auto numbers = file.numbers<float>(Json(a));
        const std::size_t width = accessor["min"].size();
        for (std::size_t c = 0; c < width; ++c) {
            float low = numbers[c];
            float high = numbers[c];
            for (std::size_t i = c; i < numbers.size(); i += width) {
                low = std::min(low, numbers[i]);
                high = std::max(high, numbers[i]);
            }
            EXPECT_EQ(accessor["min"][c].get<float>(), low);
            EXPECT_EQ(accessor["max"][c].get<float>(), high);
        }
    }
    EXPECT_EQ(bounded, 1U + kSteps + 1U) << "places at rest, of each state, and times";
}

/// The scene with one of its load steps as its result.
Scene state_of(const Scene& scene, std::size_t step) {
    Scene state = scene;
    simulation::SurfaceResult& result = state.results.front().result;
    result.solution = result.load_steps[step];
    result.load_steps.clear();
    return state;
}

/// Bars have the pieces that their sharpest bend in all states needs.
std::vector<int> most_pieces(const Scene& scene) {
    std::vector<int> most;
    for (std::size_t k = 0; k < kSteps; ++k) {
        const auto needed = detail::bar_pieces(make_bar_scene(state_of(scene, k)), 1.0);
        most.resize(needed.size(), 1);
        for (std::size_t b = 0; b < most.size(); ++b) most[b] = std::max(most[b], needed[b]);
    }
    return most;
}

TEST(MotionFile, EachFrameIsItsState) {
    const Scene scene = moving_scene();
    const GlbFile file(motion_glb(scene));
    ASSERT_EQ(file.primitive()["targets"].size(), static_cast<std::size_t>(kSteps));
    const std::vector<int> pieces = most_pieces(scene);
    for (std::size_t k = 0; k < kSteps; ++k) {
        const BarScene bars = make_bar_scene(state_of(scene, k));
        const detail::Mesh wanted = detail::bar_mesh(
            bars, 1.0, detail::EndColours(2 * bars.bars.size(), Eigen::Vector3f::Zero()), pieces);
        const auto places = file.floats_in_state("POSITION", k);
        const auto normals = file.floats_in_state("NORMAL", k);
        ASSERT_EQ(places.size(), 3 * wanted.vertices.size());
        double most = 0.0;
        for (std::size_t v = 0; v < wanted.vertices.size(); ++v) {
            for (int c = 0; c < 3; ++c) {
                const std::size_t at = 3 * v + static_cast<std::size_t>(c);
                most = std::max<double>(most, std::abs(places[at] - wanted.vertices[v].place[c]));
                ASSERT_NEAR(normals[at], wanted.vertices[v].normal[c], 1e-6);
            }
        }
        EXPECT_LT(most, 1e-7) << "metres, of a surface of 0.15: single precision";
    }
}

TEST(MotionFile, TheAnimationGoesFromRestThroughEveryState) {
    const GlbFile file(motion_glb(moving_scene()));
    const Json& animation = file.json["animations"][0];
    EXPECT_EQ(animation["channels"][0]["target"]["path"], "weights");
    const auto times = file.numbers<float>(animation["samplers"][0]["input"]);
    const auto weights = file.numbers<float>(animation["samplers"][0]["output"]);
    ASSERT_EQ(times.size(), kSteps + 1U);
    ASSERT_EQ(weights.size(), (kSteps + 1U) * kSteps);
    EXPECT_EQ(times.front(), 0.0F);
    for (std::size_t frame = 0; frame <= kSteps; ++frame) {
        if (frame > 0) {
            EXPECT_GT(times[frame], times[frame - 1]);
        }
        for (std::size_t k = 0; k < kSteps; ++k)
            EXPECT_EQ(weights[frame * kSteps + k], frame == k + 1 ? 1.0F : 0.0F);
    }
    const Json names = file.json["meshes"][0]["extras"]["targetNames"];
    EXPECT_EQ(names, Json({"load 0.25", "load 0.5", "load 0.75", "load 1"}));
}

/// A stage that a limit load has ended is named by the share of it that was reached.
TEST(MotionFile, StatesOfLoadStagesAreNamedByStageAndLoad) {
    Scene scene = moving_scene();
    simulation::SurfaceResult& result = scene.results.front().result;
    const std::vector<simulation::LoadStage> stages = {
        {"press", {{"tip", 2.0}}},
        {"clip", {}, {}, {{simulation::NodesById{{1}}, mechanics::DofSet::all()}}}};
    result.subject.emplace().model = "full";
    result.subject->stages_text = simulation::stages_text(stages);
    result.load_steps.resize(2);
    result.load_steps[0].load_factor = 1.0;
    result.load_steps[1].load_factor = 0.6;
    const GlbFile file(motion_glb(scene));
    EXPECT_EQ(file.json["meshes"][0]["extras"]["targetNames"], Json({"1 press, load 1", "2 clip, load 0.6"}));
}

TEST(MotionFile, TrianglesFaceOutwardsAndNameVertices) {
    const GlbFile file(motion_glb(moving_scene()));
    const auto places = file.floats("POSITION");
    const auto normals = file.floats("NORMAL");
    const auto indices = file.numbers<std::uint32_t>(file.primitive()["indices"]);
    ASSERT_EQ(indices.size() % 3, 0U);
    const auto vector = [](const std::vector<float>& of, std::uint32_t vertex) {
        return Eigen::Vector3f(of[3 * vertex], of[3 * vertex + 1], of[3 * vertex + 2]);
    };
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) ASSERT_LT(indices[i + k], places.size() / 3);
        const auto a = vector(places, indices[i]);
        const auto across = (vector(places, indices[i + 1]) - a).cross(vector(places, indices[i + 2]) - a);
        EXPECT_GT(across.dot(vector(normals, indices[i])), 0.0F);
    }
    for (std::uint32_t v = 0; v < normals.size() / 3; ++v) EXPECT_NEAR(vector(normals, v).norm(), 1.0, 1e-5);
}

TEST(MotionFile, WithoutAResultItIsTheSurfaceAtRest) {
    const GlbFile file(motion_glb({sample_surface()}));
    EXPECT_FALSE(file.json.contains("animations"));
    EXPECT_FALSE(file.primitive().contains("targets"));
    EXPECT_GT(file.floats("POSITION").size(), 1000U);
}

TEST(MotionFile, SaysAtItsStartWhoMadeIt) {
    const std::string text = motion_glb(moving_scene());
    EXPECT_LT(text.find("made by fretwork"), 200U) << "else it could not be replaced";
    EXPECT_EQ(GlbFile(text).json["asset"]["version"], "2.0");
}

TEST(MotionFile, StopsWhenAsked) {
    const fretwork::test::StopAtLook stop(2);
    Scene scene = moving_scene();
    scene.control = stop.control();
    EXPECT_THROW((void)motion_glb(scene), base::Stopped);
}

TEST(MotionFile, OfAFieldThatThereIsNotIsRefused) {
    Scene scene = moving_scene();
    scene.picture.colour = "stres";
    EXPECT_THAT(complaint_of([&] { (void)motion_glb(scene); }), HasSubstr("stress"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports
