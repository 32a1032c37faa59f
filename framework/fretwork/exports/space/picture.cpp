// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/detail/panels.hpp>
#include <fretwork/exports/space/detail/bar_colours.hpp>
#include <fretwork/exports/space/detail/camera.hpp>
#include <fretwork/exports/space/detail/picture_legend.hpp>
#include <fretwork/exports/space/detail/png_text.hpp>
#include <fretwork/exports/space/detail/raster.hpp>
#include <fretwork/exports/space/pictures.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace fretwork::exports {
namespace {

using detail::DepthMap;
using detail::linear_colour;
using detail::Mesh;
using detail::Sample;
using Eigen::Vector3d;
using Eigen::Vector3f;

double screen(float light) {
    const double value = std::clamp(static_cast<double>(light), 0.0, 1.0);
    return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
}

// ---- what is seen ----

Vector3f support_colour(BarScene::Support::Kind kind) {
    using Kind = BarScene::Support::Kind;
    return linear_colour(kind == Kind::Clamped ? "#c8322b" : (kind == Kind::Pinned ? "#2f8f4e" : "#e08a1e"));
}

Mesh make_mesh(const BarScene& bars, const Scene& scene) {
    Mesh mesh =
        detail::bar_mesh(bars, scene.displacement_scale, detail::end_colours(bars, scene.picture.colour));
    for (const BarScene::Support& support : bars.supports)
        detail::add_ball(mesh, place_of(bars, support.node, scene.displacement_scale), 1.1 * bars.width,
                         support_colour(support.kind));
    return mesh;
}

/// The bars at rest; empty if hidden, or if nothing moves.
Mesh make_ghost(const BarScene& bars, const Scene& scene) {
    if (scene.picture.ghost == PictureOptions::Ghost::Hidden || bars.motion.isZero(0.0)) return {};
    return detail::bar_mesh(bars, 0.0, detail::end_colours(bars, detail::kPlainColour));
}

// ---- light ----

/// Light from far away.
struct Light {
    Vector3f direction;  ///< towards the light
    Vector3f colour;     ///< colour times brightness
    int texels = 0;      ///< texels along a side of its shadow map
};

/// A sky that is brighter above, and a lamp over the viewer's left shoulder. The lamp is large, so that its
/// shadows are soft.
std::vector<Light> lights(const detail::Camera& camera, PixelSize size) {
    constexpr int kFewest = 128;
    constexpr int kMost = 2048;
    const int texels = std::clamp(std::max(size.width, size.height), kFewest, kMost);
    constexpr int kSky = 56;
    constexpr int kLamp = 16;
    constexpr double kGoldenAngle = 2.399963229728653;
    std::vector<Light> lights;
    for (int i = 0; i < kSky; ++i) {
        const double z = (i + 0.5) / kSky;
        const double across = std::sqrt(1.0 - z * z);
        const Vector3d direction(across * std::cos(kGoldenAngle * i), across * std::sin(kGoldenAngle * i), z);
        const Vector3f colour =
            Vector3f(0.93F, 0.97F, 1.06F) * static_cast<float>((0.6 + 0.8 * z) * 1.05 / kSky);
        lights.push_back({direction.cast<float>(), colour, texels * 2 / 3});
    }
    Vector3d lamp = camera.from_own({-0.75, 0.55, 0.35});
    lamp.z() = std::max(lamp.z(), 0.0) + 0.75;
    lamp.normalize();
    const Vector3d side = lamp.unitOrthogonal();
    constexpr double kLampSize = 0.13;
    for (int i = 0; i < kLamp; ++i) {
        const double radius = kLampSize * std::sqrt((i + 0.5) / kLamp);
        const Vector3d offset =
            radius * (std::cos(kGoldenAngle * i) * side + std::sin(kGoldenAngle * i) * lamp.cross(side));
        lights.push_back({(lamp + offset).normalized().cast<float>(),
                          Vector3f(1.04F, 1.0F, 0.92F) * (0.95F / kLamp), texels * 4 / 3});
    }
    return lights;
}

/// A point that may be lit, and the light that it receives.
struct Receiver {
    Vector3f place;
    Vector3f normal;
    Vector3f light = Vector3f::Zero();
    Vector3f unshadowed = Vector3f::Zero();  ///< light if there were no shadows
};

class Lighting {
  public:
    Lighting(const Mesh& mesh, std::vector<Light> lights, const base::Control& control)
        : mesh_(mesh), lights_(std::move(lights)), control_(control) {}

    /// Adds up light after light, so that the sum does not depend on the number of threads.
    void shine_on(std::vector<Receiver>& receivers) const {
        const std::size_t at_once = base::resolved_thread_count(0);
        for (std::size_t first = 0; first < lights_.size(); first += at_once) {
            control_.check();
            const std::size_t count = std::min(at_once, lights_.size() - first);
            std::vector<std::optional<DepthMap>> maps(count);
            base::parallel_for(count, 0, [&](std::size_t i) {
                maps[i].emplace(mesh_, lights_[first + i].direction, lights_[first + i].texels);
            });
            constexpr std::size_t kBatch = 8192;
            base::parallel_for((receivers.size() + kBatch - 1) / kBatch, 0, [&](std::size_t batch) {
                const std::size_t end = std::min(receivers.size(), (batch + 1) * kBatch);
                control_.check();
                for (std::size_t r = batch * kBatch; r < end; ++r) {
                    for (std::size_t i = 0; i < count; ++i) add(lights_[first + i], *maps[i], receivers[r]);
                }
            });
        }
    }

  private:
    static void add(const Light& light, const DepthMap& map, Receiver& receiver) {
        const float facing = receiver.normal.dot(light.direction);
        if (facing <= 0.0F) return;
        const Vector3f given = facing * light.colour;
        receiver.unshadowed += given;
        if (map.is_lit(receiver.place + 1.5F * map.texel_size() * receiver.normal)) receiver.light += given;
    }

    const Mesh& mesh_;
    std::vector<Light> lights_;
    base::Control control_;
};

// ---- the picture ----

/// The samples along each side of a pixel: fewer in a picture of more than 4.4 million pixels, whose samples
/// would need gigabytes of memory.
int samples_per_side(PixelSize size) {
    constexpr std::size_t kMostSamples = 40'000'000;
    for (const std::size_t side : {3, 2})
        if (size.count() * side * side <= kMostSamples) return static_cast<int>(side);
    return 1;
}

constexpr float kShadowOnGround = 0.62F;
/// The shape at rest: a grey that is seen on white and on black.
constexpr float kGhostOpacity = 0.3F;
const Vector3f kGhost = linear_colour("#8d959e");

class Picture {
  public:
    Picture(const Scene& scene, const BarScene& bars)
        : whole_(scene.picture.size),
          field_(shown_field(bars, scene.picture.colour)),
          note_(note_of(bars, scene)),
          size_{whole_.width, whole_.height - (field_ == nullptr ? 0 : detail::legend_height(whole_))},
          samples_per_side_(samples_per_side(size_)),
          mesh_(make_mesh(bars, scene)),
          ghost_(make_ghost(bars, scene)),
          places_(places_of(mesh_, ghost_)),
          ground_(ground_height()),
          camera_(detail::start_view(bars, scene), static_cast<double>(size_.width) / size_.height, places_),
          lighting_(mesh_, lights(camera_, size_), scene.control),
          grid_width_(size_.width / 2 + 2),
          ground_grid_(grid_width_ * (size_.height / 2 + 2)),
          pixels_(size_.count()) {}

    std::string text() && {
        draw_bars();
        draw_ghost();
        draw_ground();
        return detail::png_text(
            whole_, field_ == nullptr ? bytes() : detail::with_legend(bytes(), whole_, {*field_, note_}));
    }

  private:
    struct Pixel {
        Vector3f colour = Vector3f::Zero();  ///< the sum of its samples
        float samples = 0.0F;
        float ghost = 0.0F;   ///< number of samples of the shape at rest
        float ground = 0.0F;  ///< opacity of the shadow
    };

    /// The field to show; null: plain bars.
    static const BarScene::Field* shown_field(const BarScene& bars, const std::string& name) {
        const auto field = std::ranges::find(bars.fields, name, &BarScene::Field::name);
        return field == bars.fields.end() ? nullptr : &*field;
    }
    /// "552.5 x 413.2 mm at rest, displacements at true scale, joints: stiff"
    static std::string note_of(const BarScene& bars, const Scene& scene) {
        Eigen::AlignedBox3d box;
        for (const Vector3d& node : bars.nodes) box.extend(node);
        return detail::short_number(1e3 * box.sizes().x()) + " x " + detail::millimetres(box.sizes().y()) +
               " at rest, " + detail::scale_note(scene.displacement_scale) + ", " +
               detail::joints_note(bars.joints);
    }
    static std::vector<Vector3d> places_of(const Mesh& mesh, const Mesh& ghost) {
        std::vector<Vector3d> places;
        for (const Mesh* part : {&mesh, &ghost})
            for (const Mesh::Vertex& vertex : part->vertices) places.push_back(vertex.place.cast<double>());
        return places;
    }
    [[nodiscard]] float ground_height() const {
        float lowest = 0.0F;
        for (const Mesh::Vertex& vertex : mesh_.vertices) lowest = std::min(lowest, vertex.place.z());
        return lowest;
    }

    void draw_bars() {
        const auto samples = detail::visible_samples(mesh_, camera_, size_, samples_per_side_);
        std::vector<Receiver> receivers;
        receivers.reserve(samples.size());
        for (const Sample& sample : samples) receivers.push_back({sample.place, sample.normal});
        lighting_.shine_on(receivers);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            Pixel& pixel = pixels_[samples[i].pixel];
            // The light that the ground reflects, and a little from everywhere, so that nothing is black.
            const float below = 0.16F + 0.10F * (1.0F - samples[i].normal.z());
            const Vector3f light = receivers[i].light + Vector3f(below, below, 0.96F * below);
            pixel.colour += shade(samples[i].colour.cwiseProduct(light));
            pixel.samples += 1.0F;
        }
    }

    /// The shape at rest casts no shadow, and lies behind the bars.
    void draw_ghost() {
        for (const Sample& sample : detail::visible_samples(ghost_, camera_, size_, samples_per_side_))
            pixels_[sample.pixel].ghost += 1.0F;
    }

    /// Bright light is rolled off, so that it keeps its hue.
    static Vector3f shade(const Vector3f& light) {
        constexpr float kKnee = 0.75F;
        const float largest = light.maxCoeff();
        if (largest <= kKnee) return light;
        const float rolled = kKnee + (1.0F - kKnee) * (1.0F - std::exp(-(largest - kKnee) / (1.0F - kKnee)));
        return light * (rolled / largest);
    }

    /// The shadow is soft: it is found on a grid of every second pixel, and smoothed.
    void draw_ground() {
        std::vector<Receiver> receivers;
        std::vector<std::size_t> at;
        for (std::size_t p = 0; p < ground_grid_.size(); ++p) {
            const std::size_t row = p / grid_width_;
            const auto x = static_cast<double>(p % grid_width_);
            const auto y = static_cast<double>(row);
            const Vector3d ray = camera_.ray(4.0 * x / size_.width - 1.0, 1.0 - 4.0 * y / size_.height);
            const double distance = (ground_ - camera_.eye().z()) / ray.z();
            if (!(distance > 0.0)) continue;
            receivers.push_back({(camera_.eye() + distance * ray).cast<float>(), Vector3f::UnitZ()});
            at.push_back(p);
        }
        lighting_.shine_on(receivers);
        for (std::size_t i = 0; i < at.size(); ++i)
            ground_grid_[at[i]] =
                1.0F - receivers[i].light.sum() / std::max(receivers[i].unshadowed.sum(), 1e-6F);
        constexpr int kRounds = 2;
        for (int round = 0; round < kRounds; ++round) {
            smooth(1);
            smooth(grid_width_);
        }
        for (std::size_t p = 0; p < pixels_.size(); ++p)
            pixels_[p].ground = kShadowOnGround * ground_shadow(p) * fading(p);
    }

    /// Replaces each value by a weighted mean of it and the two values `distance` places before and after.
    void smooth(std::size_t distance) {
        const std::vector<float> before = ground_grid_;
        for (std::size_t p = distance; p + distance < before.size(); ++p)
            ground_grid_[p] = 0.25F * before[p - distance] + 0.5F * before[p] + 0.25F * before[p + distance];
    }

    [[nodiscard]] float ground_shadow(std::size_t pixel) const {
        const std::size_t width = size_.width;
        const std::size_t row = pixel / width;
        const float x = 0.5F * (static_cast<float>(pixel % width) + 0.5F);
        const float y = 0.5F * (static_cast<float>(row) + 0.5F);
        const std::size_t first = static_cast<std::size_t>(y) * grid_width_ + static_cast<std::size_t>(x);
        const float sx = x - std::floor(x);
        const float sy = y - std::floor(y);
        const float upper = (1.0F - sx) * ground_grid_[first] + sx * ground_grid_[first + 1];
        const float lower =
            (1.0F - sx) * ground_grid_[first + grid_width_] + sx * ground_grid_[first + grid_width_ + 1];
        return (1.0F - sy) * upper + sy * lower;
    }

    /// Towards the rim of the picture the shadow ends softly.
    [[nodiscard]] float fading(std::size_t pixel) const {
        const std::size_t width = size_.width;
        const auto share = [](std::size_t place, int count) {
            const float s = (static_cast<float>(place) + 0.5F) / static_cast<float>(count);
            return std::clamp(std::min(s, 1.0F - s) / 0.06F, 0.0F, 1.0F);
        };
        return share(pixel % width, size_.width) * share(pixel / width, size_.height);
    }

    /// The bars over the ghost, and both over the shadow on the ground.
    [[nodiscard]] std::vector<std::uint8_t> bytes() const {
        const auto samples = static_cast<float>(samples_per_side_ * samples_per_side_);
        std::vector<std::uint8_t> bytes;
        bytes.reserve(4 * pixels_.size());
        for (const Pixel& pixel : pixels_) {
            const float bars = pixel.samples / samples;
            const float ghost = (1.0F - bars) * kGhostOpacity * pixel.ghost / samples;
            const float opacity = bars + ghost + (1.0F - bars - ghost) * pixel.ground;
            Vector3f colour = Vector3f::Zero();
            if (opacity > 0.0F)
                colour = (bars / std::max(pixel.samples, 1.0F) * pixel.colour + ghost * kGhost) / opacity;
            for (const float light : colour)
                bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0 * screen(light))));
            bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0F * opacity)));
        }
        return bytes;
    }

    PixelSize whole_;
    const BarScene::Field* field_;  ///< the shown field; null: none
    std::string note_;              ///< below the legend
    PixelSize size_;                ///< size of the surface's picture, above the legend
    int samples_per_side_;          ///< samples along each side of a pixel
    Mesh mesh_;
    Mesh ghost_;
    std::vector<Vector3d> places_;  ///< places of all vertices
    float ground_;
    detail::Camera camera_;
    Lighting lighting_;
    std::size_t grid_width_;
    std::vector<float> ground_grid_;  ///< shadow at every second pixel, 0 to 1
    std::vector<Pixel> pixels_;
};

}  // namespace

std::string picture_png(const Scene& scene) {
    const BarScene bars = make_bar_scene(scene);
    if (bars.bars.empty()) throw base::InputError("there is nothing to draw: no tile is painted");
    return Picture(scene, bars).text();
}

}  // namespace fretwork::exports
