// SPDX-License-Identifier: GPL-3.0-or-later
#include "instances.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/random.hpp>
#include <fretwork/geometry/point_grid.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/simulation/derivatives/candidate_tiles.hpp>
#include <fretwork/simulation/simulate.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace fretwork::experiments {
namespace {

/// Points nearer to each other than this are one, m.
constexpr double kSame = 1e-6;

/// A sum of three random waves, from 0 to 1 over the tiles.
std::vector<double> smooth_field(const std::vector<geometry::Point2>& places, base::SplitMix64& random) {
    double reach = 0.0;
    for (const geometry::Point2& place : places) reach = std::max({reach, place.x, place.y});
    std::vector<double> field(places.size(), 0.0);
    for (int wave = 0; wave < 3; ++wave) {
        const double angle = 6.28 * random.share();
        const double number = (1.0 + 5.0 * random.share()) / reach;
        const double phase = 6.28 * random.share();
        for (std::size_t i = 0; i < places.size(); ++i)
            field[i] +=
                std::sin(number * (std::cos(angle) * places[i].x + std::sin(angle) * places[i].y) + phase);
    }
    const auto [low, high] = std::ranges::minmax(field);
    for (double& value : field) value = (value - low) / std::max(high - low, 1e-12);
    return field;
}

/// Each tile gets the patch of the nearest of some random tiles.
std::vector<std::size_t> patches(const std::vector<geometry::Point2>& places, base::SplitMix64& random) {
    std::vector<std::size_t> seeds;
    for (std::size_t i = 0; i < std::max<std::size_t>(1, places.size() / 5); ++i)
        seeds.push_back(random.below(places.size()));
    std::vector<std::size_t> result;
    for (const geometry::Point2& place : places) {
        const auto distance = [&](std::size_t seed) {
            return std::hypot(place.x - places[seed].x, place.y - places[seed].y);
        };
        result.push_back(*std::ranges::min_element(seeds, {}, distance));
    }
    return result;
}

design::Target of_all_nodes(const simulation::Project& project, const std::string& name,
                            const std::vector<Eigen::Vector3d>& displacements) {
    design::NodesGoal goal;
    for (std::size_t i = 0; i < project.tessellation.interface_nodes.size(); ++i) {
        goal.nodes.push_back(static_cast<int>(i));
        goal.values.push_back({displacements[i].x(), displacements[i].y(), displacements[i].z()});
    }
    return {name, "", {{goal}}};
}

double deflection(const simulation::Project& project, double force) {
    const auto result = simulation::simulate(simulation::make_surface(project, nullptr), tip_load(force),
                                             {.model = "corotational"});
    return result.solution.displacements.leftCols<3>().rowwise().norm().maxCoeff();
}

}  // namespace

simulation::Project lattice(int columns, int rows) {
    simulation::Project project;
    project.setting = reduction::paper_setting();
    const double side = project.setting->tile_side;
    const geometry::Polygon hexagon = geometry::regular_polygon(6, side);
    tiling::Tessellation& tessellation = project.tessellation;
    tessellation.layout = "paper7";
    tessellation.patterns =
        pattern::parse_named_patterns(project.layout, std::vector<std::string>{"0-1+1-6"});
    geometry::PointGrid vertices(kSame);
    geometry::PointGrid nodes(kSame);
    for (int column = 0; column < columns; ++column) {
        for (int row = 0; row < rows; ++row) {
            const double x = 1.5 * side * column;
            const double y = std::sqrt(3.0) * side * (row + 0.5 * (column % 2));
            tiling::Tile tile;
            tile.pattern = 0;
            for (std::size_t k = 0; k < 6; ++k) {
                const geometry::Point2 a{x + hexagon[k].x, y + hexagon[k].y};
                const geometry::Point2 b{x + hexagon[(k + 1) % 6].x, y + hexagon[(k + 1) % 6].y};
                tile.vertices.emplace_back(vertices.number_of(a, kSame));
                tile.interface_nodes.emplace_back(nodes.number_of({(a.x + b.x) / 2, (a.y + b.y) / 2}, kSame));
            }
            tessellation.tiles.push_back(std::move(tile));
        }
    }
    tessellation.vertices = vertices.points();
    tessellation.interface_nodes = nodes.points();
    const double w = 1.5 * side * (columns + 1);
    const double h = std::sqrt(3.0) * side * (rows + 1);
    project.outline = outlines::make_outline({{-w, -h}, {w, -h}, {w, h}, {-w, h}}, {});
    return project;
}

std::vector<pattern::NamedPattern> palette(const std::string& count, std::uint64_t seed) {
    const pattern::NodeLayout& layout = pattern::paper_layout();
    std::vector<pattern::Pattern> all =
        pattern::enumerate_patterns(layout, {.edges = pattern::default_edge_range(layout)});
    if (count != "all") {
        base::SplitMix64 random(seed);
        const std::size_t wanted = std::min<std::size_t>(std::stoul(count), all.size());
        for (std::size_t i = 0; i < wanted; ++i) std::swap(all[i], all[i + random.below(all.size() - i)]);
        all.resize(wanted);
    }
    std::vector<pattern::NamedPattern> named;
    for (const pattern::Pattern& own : all) named.push_back({pattern::pattern_id(layout, own), own});
    return named;
}

Hidden find_hidden(const std::string& name) {
    if (name == "graded") return Hidden::Graded;
    if (name == "patchy") return Hidden::Patchy;
    if (name == "random") return Hidden::Random;
    throw base::InputError("'" + name + "' is no kind of hidden painting: expected graded, patchy or random");
}

std::vector<std::size_t> from_soft_to_stiff(const simulation::Project& project,
                                            const std::vector<pattern::NamedPattern>& palette) {
    simulation::Surface surface = simulation::make_surface(project, nullptr);
    surface.tessellation.tiles = {surface.tessellation.tiles.front()};
    const simulation::CandidateTiles candidates(surface, palette);
    std::vector<double> traces;
    for (std::size_t p = 0; p < palette.size(); ++p) {
        const Eigen::MatrixXd stiffness = candidates.stiffness(0, p);
        double trace = 0.0;
        for (Eigen::Index i = 0; i < stiffness.rows(); i += 6) trace += stiffness(i + 2, i + 2);
        traces.push_back(trace);
    }
    std::vector<std::size_t> order(palette.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t p) { return traces[p]; });
    return order;
}

void paint(simulation::Project& project, const HiddenOptions& options) {
    base::SplitMix64 random(base::SplitMix64::mix(options.seed));
    tiling::Tessellation& tessellation = project.tessellation;
    const std::vector<geometry::Point2> places = tiling::tile_centers(tessellation);
    const std::vector<std::size_t> order = from_soft_to_stiff(project, options.palette);
    const std::vector<double> field = smooth_field(places, random);
    const std::vector<std::size_t> patch = patches(places, random);
    std::map<std::size_t, std::size_t> of_patch;
    for (const std::size_t own : patch) of_patch.try_emplace(own, random.below(order.size()));
    tessellation.patterns = options.palette;
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) {
        const auto last = static_cast<double>(order.size() - 1);
        const std::size_t graded = order[static_cast<std::size_t>(std::lround(field[t] * last))];
        const std::size_t drawn = random.below(order.size());
        tessellation.tiles[t].pattern =
            static_cast<int>(options.kind == Hidden::Graded   ? graded
                             : options.kind == Hidden::Patchy ? of_patch.at(patch[t])
                                                              : drawn);
    }
}

simulation::LoadCase tip_load(double force) {
    simulation::LoadCase load_case;
    load_case.name = "tip";
    load_case.supports.push_back({simulation::NodesAtSide{simulation::Side::Left}, mechanics::DofSet::all()});
    load_case.loads.push_back({simulation::NodesAtSide{simulation::Side::Right},
                               {0, 0, force},
                               Eigen::Vector3d::Zero(),
                               simulation::LoadCase::Amount::Total});
    return load_case;
}

double span_of(const simulation::Project& project) {
    const geometry::Box box = tiling::bounding_box(project.tessellation);
    return box.width();
}

double force_for(const simulation::Project& project, double share) {
    const double wanted = share * span_of(project);
    double low = 0.0;
    double high = 1e-3;
    while (deflection(project, high) < wanted) high *= 2.0;
    for (int i = 0; i < 12; ++i) {
        const double middle = 0.5 * (low + high);
        (deflection(project, middle) < wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

design::Target reached_by(const simulation::Project& project) {
    const auto result = simulation::simulate(simulation::make_surface(project, nullptr),
                                             project.load_cases.front(), {.model = "full"});
    std::vector<Eigen::Vector3d> displacements;
    for (std::size_t i = 0; i < project.tessellation.interface_nodes.size(); ++i)
        displacements.push_back(
            result.solution.displacements.row(static_cast<Eigen::Index>(i)).head<3>().transpose());
    return of_all_nodes(project, "planted", displacements);
}

design::Target arc(const simulation::Project& project, double angle) {
    const geometry::Box box = tiling::bounding_box(project.tessellation);
    const double radius = (box.width()) / angle;
    std::vector<Eigen::Vector3d> displacements;
    for (const geometry::Point2& place : project.tessellation.interface_nodes) {
        const double along = (place.x - box.xmin) / radius;
        displacements.emplace_back(radius * std::sin(along) - (place.x - box.xmin), 0.0,
                                   radius * (1.0 - std::cos(along)));
    }
    return of_all_nodes(project, "arc", displacements);
}

design::Target bent(const simulation::Project& project, const Bend& bend) {
    const geometry::Box box = tiling::bounding_box(project.tessellation);
    const double middle = 0.5 * (box.ymin + box.ymax);
    std::vector<Eigen::Vector3d> displacements;
    for (const geometry::Point2& place : project.tessellation.interface_nodes) {
        const double end = (place.x - box.xmin) / box.width();
        Eigen::Vector3d bent = Eigen::Vector3d::Zero();
        constexpr int kSteps = 200;
        constexpr double kPi = 3.14159265358979323846;
        for (int i = 0; i < kSteps; ++i) {
            const double s = end * (i + 0.5) / kSteps;
            const double slope = bend.angle * (s + bend.first * std::sin(kPi * s) / kPi +
                                               bend.second * std::sin(2.0 * kPi * s) / (2.0 * kPi));
            bent += Eigen::Vector3d(std::cos(slope), 0.0, std::sin(slope)) * box.width() * end / kSteps;
        }
        const double across = place.y - middle;
        displacements.emplace_back(bent.x() - (place.x - box.xmin),
                                   across * (std::cos(bend.twist * end) - 1.0),
                                   bent.z() + across * std::sin(bend.twist * end));
    }
    return of_all_nodes(project, "bent", displacements);
}

}  // namespace fretwork::experiments
