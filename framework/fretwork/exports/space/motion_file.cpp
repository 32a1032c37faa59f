// SPDX-License-Identifier: GPL-3.0-or-later
// The bars as a binary glTF 2.0 file: one mesh at rest, a morph target for each load step, and an animation
// that goes from one to the next.
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/exports/detail/binary_text.hpp>
#include <fretwork/exports/space/detail/bar_colours.hpp>
#include <fretwork/exports/space/pictures.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>
#include <fretwork/simulation/stages.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace fretwork::exports {
namespace {

using base::Json;
using detail::Mesh;

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

// Constants of glTF: types of numbers, and kinds of buffers.
constexpr int kFloat = 5126;
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kIndexBuffer = 34963;

/// The kind of numbers of an accessor.
struct Column {
    const char* type;   ///< "VEC3", "SCALAR", ..
    int component;      ///< type of a number
    int target;         ///< kind of buffer on the graphics card; 0: none
    std::size_t width;  ///< numbers for each element
};
constexpr Column kVectors = {"VEC3", kFloat, kArrayBuffer, 3};
constexpr Column kColours = {"VEC4", kUnsignedShort, kArrayBuffer, 4};
constexpr Column kIndices = {"SCALAR", kUnsignedInt, kIndexBuffer, 1};
constexpr Column kNumbers = {"SCALAR", kFloat, 0, 1};

enum class Bounds { No, Yes };

/// The buffer of a file, with its views and accessors.
class BinaryBuffer {
  public:
    /// Returns the accessor's index.
    template <class Number>
    std::size_t add(const std::vector<Number>& numbers, const Column& column, Bounds bounds = Bounds::No) {
        const std::size_t offset = bytes_.size();
        const std::size_t size = numbers.size() * sizeof(Number);
        bytes_.append(reinterpret_cast<const char*>(numbers.data()), size);
        bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
        Json view = {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}};
        if (column.target != 0) view["target"] = column.target;
        Json accessor = {{"bufferView", views_.size()},
                         {"componentType", column.component},
                         {"count", numbers.size() / column.width},
                         {"type", column.type}};
        if (column.component == kUnsignedShort) accessor["normalized"] = true;
        if (bounds == Bounds::Yes) add_bounds(accessor, numbers, column.width);
        views_.push_back(std::move(view));
        accessors_.push_back(std::move(accessor));
        return accessors_.size() - 1;
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    [[nodiscard]] const Json& views() const { return views_; }
    [[nodiscard]] const Json& accessors() const { return accessors_; }

  private:
    template <class Number>
    static void add_bounds(Json& accessor, const std::vector<Number>& numbers, std::size_t width) {
        std::vector<Number> low(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(width));
        std::vector<Number> high = low;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            low[i % width] = std::min(low[i % width], numbers[i]);
            high[i % width] = std::max(high[i % width], numbers[i]);
        }
        accessor["min"] = low;
        accessor["max"] = high;
    }

    std::string bytes_;
    Json views_ = Json::array();
    Json accessors_ = Json::array();
};

/// The motions of the bars' nodes, one for each state after rest, and the names of the states.
struct Motions {
    std::vector<mechanics::NodeValues> states;
    std::vector<std::string> names;
};

std::string load_name(const mechanics::Solution& solution) {
    return "load " + base::format_number(solution.load_factor, 6);
}

/// The name of each step: its load. With load stages, each step is the end of a stage, and the name begins
/// with the number and the name of the stage.
std::vector<std::string> step_names(const simulation::SurfaceResult& result) {
    const std::vector<std::string> stages = simulation::stage_names(result);
    std::vector<std::string> names;
    for (const mechanics::Solution& step : result.load_steps) {
        const std::size_t k = names.size();
        const std::string stage = k < stages.size() ? std::to_string(k + 1) + " " + stages[k] + ", " : "";
        names.push_back(stage + load_name(step));
    }
    return names;
}

Motions motions_of(const Scene& scene, const BarScene& bars) {
    Motions motions;
    if (scene.results.empty()) return motions;
    const simulation::SurfaceResult& result = scene.results.front().result;
    if (result.load_steps.empty()) return {{bars.motion}, {load_name(result.solution)}};
    scene.control.check();
    const simulation::SurfaceBeams beams = simulation::surface_beams(scene.surface);
    for (const simulation::BeamState& state :
         simulation::step_beam_states(scene.surface, result, beams, {}, scene.models))
        motions.states.push_back(state.nodes.array().isNaN().select(0.0, state.nodes));
    motions.names = step_names(result);
    return motions;
}

std::vector<float> flat(const Mesh& mesh, Eigen::Vector3f Mesh::Vertex::*member) {
    std::vector<float> numbers;
    numbers.reserve(3 * mesh.vertices.size());
    for (const Mesh::Vertex& vertex : mesh.vertices)
        for (const float number : vertex.*member) numbers.push_back(number);
    return numbers;
}

std::vector<float> difference(std::vector<float> of, const std::vector<float>& from) {
    for (std::size_t i = 0; i < of.size(); ++i) of[i] -= from[i];
    return of;
}

std::vector<std::uint16_t> colour_numbers(const Mesh& mesh) {
    constexpr float kMost = 65535.0F;
    std::vector<std::uint16_t> numbers;
    for (const Mesh::Vertex& vertex : mesh.vertices) {
        for (const float light : vertex.colour)
            numbers.push_back(static_cast<std::uint16_t>(std::lround(kMost * std::clamp(light, 0.0F, 1.0F))));
        numbers.push_back(0xffff);
    }
    return numbers;
}

/// The triangles, with corners counterclockwise as seen from outside. Otherwise, viewers would flip the
/// normals of triangles that face away.
std::vector<std::uint32_t> outward_triangles(const Mesh& mesh) {
    std::vector<std::uint32_t> indices;
    for (auto [a, b, c] : mesh.triangles) {
        const auto& p = mesh.vertices[a];
        const Eigen::Vector3f across =
            (mesh.vertices[b].place - p.place).cross(mesh.vertices[c].place - p.place);
        if (across.dot(p.normal + mesh.vertices[b].normal + mesh.vertices[c].normal) < 0.0F) std::swap(b, c);
        indices.insert(indices.end(), {a, b, c});
    }
    return indices;
}

class MotionFile {
  public:
    explicit MotionFile(const Scene& scene)
        : scene_(scene), bars_(make_bar_scene(scene)), motions_(motions_of(scene, bars_)) {
        if (bars_.bars.empty()) throw base::InputError("there is nothing to draw: no tile is painted");
    }

    std::string text() && {
        add_mesh();
        if (!motions_.states.empty()) add_animation();
        add_frame();
        return container();
    }

  private:
    /// The bars in a state, with as many pieces as their sharpest bend in all states needs.
    [[nodiscard]] Mesh mesh_of(const mechanics::NodeValues& motion) const {
        BarScene state;
        state.nodes = bars_.nodes;
        state.bars = bars_.bars;
        state.width = bars_.width;
        state.height = bars_.height;
        state.motion = motion;
        return detail::bar_mesh(state, scene_.displacement_scale, colours_, pieces_);
    }

    [[nodiscard]] std::vector<int> most_pieces() const {
        BarScene state = bars_;
        std::vector<int> pieces(bars_.bars.size(), 1);
        for (const mechanics::NodeValues& motion : motions_.states) {
            state.motion = motion;
            const std::vector<int> needed = detail::bar_pieces(state, scene_.displacement_scale);
            for (std::size_t b = 0; b < pieces.size(); ++b) pieces[b] = std::max(pieces[b], needed[b]);
        }
        return pieces;
    }

    void add_mesh() {
        colours_ = detail::end_colours(bars_, scene_.picture.colour);
        pieces_ = most_pieces();
        const Mesh rest = mesh_of(mechanics::NodeValues::Zero(bars_.motion.rows(), bars_.motion.cols()));
        const std::vector<float> places = flat(rest, &Mesh::Vertex::place);
        const std::vector<float> normals = flat(rest, &Mesh::Vertex::normal);
        Json primitive = {{"attributes",
                           {{"POSITION", buffer_.add(places, kVectors, Bounds::Yes)},
                            {"NORMAL", buffer_.add(normals, kVectors)},
                            {"COLOR_0", buffer_.add(colour_numbers(rest), kColours)}}},
                          {"indices", buffer_.add(outward_triangles(rest), kIndices)},
                          {"material", 0}};
        for (std::size_t k = 0; k < motions_.states.size(); ++k) {
            scene_.control.check();
            const Mesh state = mesh_of(motions_.states[k]);
            primitive["targets"].push_back(
                {{"POSITION",
                  buffer_.add(difference(flat(state, &Mesh::Vertex::place), places), kVectors, Bounds::Yes)},
                 {"NORMAL", buffer_.add(difference(flat(state, &Mesh::Vertex::normal), normals), kVectors)}});
        }
        Json mesh = {{"name", bars_.title}, {"primitives", Json::array({std::move(primitive)})}};
        if (!motions_.names.empty()) {
            mesh["extras"] = {{"targetNames", motions_.names}};
            // Without the animation, viewers show the last state.
            std::vector<int> weights(motions_.names.size(), 0);
            weights.back() = 1;
            mesh["weights"] = weights;
        }
        file_["meshes"] = Json::array({std::move(mesh)});
    }

    /// Add the animation from rest through all states. Each state has a weight of one at its time.
    void add_animation() {
        constexpr double kLeastSeconds = 2.0;
        constexpr double kStepSeconds = 0.1;
        const std::size_t count = motions_.states.size();
        const double step = std::max(kStepSeconds, kLeastSeconds / static_cast<double>(count));
        std::vector<float> times;
        std::vector<float> weights((count + 1) * count, 0.0F);
        for (std::size_t k = 0; k <= count; ++k) {
            times.push_back(static_cast<float>(step * static_cast<double>(k)));
            if (k > 0) weights[k * count + k - 1] = 1.0F;
        }
        const std::size_t input = buffer_.add(times, kNumbers, Bounds::Yes);
        const std::size_t output = buffer_.add(weights, kNumbers);
        file_["animations"] = Json::array(
            {{{"name", "load path"},
              {"samplers",
               Json::array({{{"input", input}, {"output", output}, {"interpolation", "LINEAR"}}})},
              {"channels",
               Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}})}}});
    }

    void add_frame() {
        file_["scene"] = 0;
        file_["scenes"] = Json::array({{{"nodes", {0}}}});
        // In glTF, the y axis points up.
        const double half = std::sqrt(0.5);
        file_["nodes"] =
            Json::array({{{"name", "surface"}, {"mesh", 0}, {"rotation", {-half, 0.0, 0.0, half}}}});
        file_["materials"] =
            Json::array({{{"name", "bars"},
                          {"doubleSided", true},
                          {"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 0.7}}}}});
        file_["accessors"] = buffer_.accessors();
        file_["bufferViews"] = buffer_.views();
        file_["buffers"] = Json::array({{{"byteLength", buffer_.bytes().size()}}});
    }

    /// Header, chunk of JSON, chunk of the buffer; each a multiple of four bytes.
    [[nodiscard]] std::string container() const {
        std::string json = json_text();
        json.resize((json.size() + 3) / 4 * 4, ' ');
        const std::string& binary = buffer_.bytes();
        constexpr std::size_t kHeaders = 12 + 8 + 8;
        const std::size_t size = kHeaders + json.size() + binary.size();
        if (size > 0xffffffffU)
            throw base::InputError("a .glb file has at most 4 GiB: fewer load steps are needed");
        std::string text = "glTF";
        detail::append_bits(text, 2);
        detail::append_bits(text, static_cast<std::uint32_t>(size));
        detail::append_bits(text, static_cast<std::uint32_t>(json.size()));
        text += "JSON" + json;
        detail::append_bits(text, static_cast<std::uint32_t>(binary.size()));
        text += std::string("BIN\0", 4) + binary;
        return text;
    }
    /// The name of this program comes first. By this name, the program recognizes its own files, which it may
    /// replace.
    [[nodiscard]] std::string json_text() const {
        const Json asset = {{"version", "2.0"}, {"generator", std::string(base::kMadeBy)}};
        return "{\"asset\":" + asset.dump() + "," + file_.dump().substr(1);
    }

    const Scene& scene_;
    BarScene bars_;
    Motions motions_;
    detail::EndColours colours_;
    std::vector<int> pieces_;
    BinaryBuffer buffer_;
    Json file_;
};

}  // namespace

std::string motion_glb(const Scene& scene) {
    return MotionFile(scene).text();
}

}  // namespace fretwork::exports
