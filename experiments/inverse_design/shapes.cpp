// SPDX-License-Identifier: GPL-3.0-or-later
// Targets that no painting is known to reach: a graded strip, two load cases, an arch and a dome. README.md.
#include "instances.hpp"
#include "rows.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/simulation/simulate.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace {

using namespace fretwork;
using design::FreeVector;
using mechanics::Dof;
using mechanics::DofSet;
using simulation::LoadCase;
using simulation::NodesInBox;

constexpr double kPi = 3.14159265358979323846;

struct Arguments {
    std::string shape = "arch";
    std::string patterns = "all";
    std::uint64_t seed = 1;
    int solutions = 0;
    int threads = 2;
    bool free_factor = false;
};

struct Shape {
    simulation::Project project;
    design::Target target;
    design::DesignOptions options;
    double largest = 0.0;  ///< m, wanted
};

/// A goal for every node under a load case, given where the node is at rest.
template <class Wanted>
void add_goal(Shape& shape, const std::string& load_case, const Wanted& wanted) {
    design::NodesGoal goal;
    const auto& nodes = shape.project.tessellation.interface_nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const FreeVector value = wanted(nodes[i]);
        goal.nodes.push_back(static_cast<int>(i));
        goal.values.push_back(value);
        double square = 0.0;
        for (const auto& component : value) square += component ? *component * *component : 0.0;
        shape.largest = std::max(shape.largest, std::sqrt(square));
    }
    shape.target.goals.push_back({goal, 1.0, load_case});
}

/// The force that bends a random painting by so much of the span.
double tip_force(const Shape& shape, std::uint64_t seed, double share) {
    simulation::Project hidden = shape.project;
    experiments::paint(hidden, {experiments::Hidden::Graded, shape.options.palette, seed});
    return experiments::force_for(hidden, share);
}

FreeVector on_arc(double along, double radius) {
    return {radius * std::sin(along / radius) - along, 0.0, radius * (1.0 - std::cos(along / radius))};
}

/// A cantilever whose bending stiffness rises four times over the first 80 % of its span: the elastica under
/// the tip force, with the mean stiffness that half of the span asks for.
void make_field(Shape& shape, const Arguments& arguments) {
    const double force = tip_force(shape, arguments.seed, 0.5);
    shape.project.load_cases = {experiments::tip_load(force)};
    const double length = experiments::span_of(shape.project);
    const auto stiffness = [](double s) { return 1.0 + 3.0 * std::min(1.0, s / 0.8); };
    constexpr int kSteps = 400;
    std::vector<std::pair<double, double>> curve;
    // The moment of a vertical force is its arm: the curve is found again until it carries itself.
    const auto bend = [&](double strength) {
        double reach = length;
        for (int round = 0; round < 60; ++round) {
            curve = {{0.0, 0.0}};
            double slope = 0.0;
            for (int i = 0; i < kSteps; ++i) {
                const double step = length / kSteps;
                const double arm = reach - curve.back().first;
                slope += strength * arm / stiffness((i + 0.5) / kSteps) * step;
                curve.emplace_back(curve.back().first + step * std::cos(slope),
                                   curve.back().second + step * std::sin(slope));
            }
            reach = 0.5 * (reach + curve.back().first);
        }
        return curve.back().second;
    };
    double low = 0.0;
    double high = 8.0 / (length * length);  // beyond, it curls up
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (bend(middle) < 0.48 * length ? low : high) = middle;
    }
    bend(low);
    const double begin = tiling::bounding_box(shape.project.tessellation).xmin;
    add_goal(shape, "", [&](const geometry::Point2& place) -> FreeVector {
        const double at = std::clamp((place.x - begin) / length, 0.0, 1.0) * kSteps;
        const auto before = std::min<std::size_t>(static_cast<std::size_t>(at), kSteps - 1);
        const double rest = at - static_cast<double>(before);
        const double x = curve[before].first * (1 - rest) + curve[before + 1].first * rest;
        const double z = curve[before].second * (1 - rest) + curve[before + 1].second * rest;
        return {x - (place.x - begin), 0.0, z};
    });
    shape.options.load_case = "tip";
    shape.options.max_patterns = 8;
}

/// One painting: an arc of 45 degrees under the tip force, and one of 25 degrees downwards under a pressure
/// or, as "two-tips", under another tip force, which asks for the same stiffness as the first.
void make_two(Shape& shape, const Arguments& arguments) {
    const double force = tip_force(shape, arguments.seed, 0.37);
    const double length = experiments::span_of(shape.project);
    LoadCase downwards = experiments::tip_load(-0.5 * force);
    downwards.name = "downwards";
    if (arguments.shape == "two")
        downwards.loads = {{NodesInBox{{-10, -10, 10, 10}},
                            {0, 0, -1.5 * force},
                            Eigen::Vector3d::Zero(),
                            LoadCase::Amount::Total}};
    shape.project.load_cases = {experiments::tip_load(force), downwards};
    const double begin = tiling::bounding_box(shape.project.tessellation).xmin;
    const double up = length / (45.0 * kPi / 180.0);
    const double down = length / (25.0 * kPi / 180.0);
    add_goal(shape, "tip", [&](const geometry::Point2& place) { return on_arc(place.x - begin, up); });
    add_goal(shape, "downwards", [&](const geometry::Point2& place) {
        FreeVector value = on_arc(place.x - begin, down);
        value[2] = -*value[2];
        return value;
    });
    shape.options.load_case = "tip";
    shape.options.free_factor = true;
}

/// The nodes on a line across the surface: x or y within a tenth of a tile side.
NodesInBox on_line(const Shape& shape, bool is_across, double place) {
    const double near = 0.1 * shape.project.setting->tile_side;
    if (is_across) return {{place - near, -10.0, place + near, 10.0}};
    return {{-10.0, place - near, 10.0, place + near}};
}

/// The load that lifts a surface which is pushed in to one side, so that it has one branch.
LoadCase::Load lift() {
    return {NodesInBox{{-10, -10, 10, 10}}, {0, 0, 0.02}, Eigen::Vector3d::Zero(), LoadCase::Amount::Total};
}

/// A circular arch of 60 degrees between two lines of pins, the outermost nodes at left and right: the right
/// one is pushed in, and how far is unknown. Its target has the pins where they are.
void make_arch(Shape& shape) {
    const geometry::Box box = tiling::bounding_box(shape.project.tessellation);
    const double inset = 0.25 * shape.project.setting->tile_side;
    const double left = box.xmin + inset;
    const double right = box.xmax - inset;
    const double length = right - left;
    const double angle = kPi / 3.0;
    const double radius = length / angle;
    const double shortening = length - 2.0 * radius * std::sin(0.5 * angle);
    LoadCase push;
    push.name = "push";
    push.supports = {{on_line(shape, true, left), DofSet{{true, true, true, false, false, false}}},
                     {on_line(shape, true, right), DofSet{{false, true, true, false, false, false}}}};
    push.prescribed = {{on_line(shape, true, right), Dof::ux, -0.8 * shortening}};
    push.loads = {lift()};
    shape.project.load_cases = {push};
    const double middle = 0.5 * (left + right);
    add_goal(shape, "", [&](const geometry::Point2& place) -> FreeVector {
        const double along = place.x - middle;
        return {radius * std::sin(along / radius) - along - 0.5 * shortening, 0.0,
                radius * (std::cos(along / radius) - std::cos(0.5 * angle))};
    });
    shape.options.load_case = "push";
    shape.options.free_prescribed = true;
}

/// A cap of a tenth of the span: four lines of nodes are held in height, on which the cap has no height, and
/// are pushed in, each as far as the design likes.
void make_dome(Shape& shape) {
    const geometry::Box box = tiling::bounding_box(shape.project.tessellation);
    const double side = shape.project.setting->tile_side;
    const double step = 0.5 * std::sqrt(3.0) * side;  // odd columns are higher by this
    const geometry::Box lines{box.xmin + 0.25 * side, box.ymin + step, box.xmax - 0.25 * side,
                              box.ymax - step};
    LoadCase push;
    push.name = "push";
    const auto hold = [&](bool is_across, double place, double inwards) {
        const NodesInBox where = on_line(shape, is_across, place);
        push.supports.push_back({where, DofSet{{false, false, true, false, false, false}}});
        push.prescribed.push_back({where, is_across ? Dof::ux : Dof::uy, inwards * 0.006 * lines.width()});
    };
    hold(true, lines.xmin, 1.0);
    hold(true, lines.xmax, -1.0);
    hold(false, lines.ymin, 1.0);
    hold(false, lines.ymax, -1.0);
    push.loads = {lift()};
    shape.project.load_cases = {push};
    const double height = 0.1 * lines.width();
    add_goal(shape, "", [&](const geometry::Point2& place) -> FreeVector {
        const double u = (place.x - lines.xmin) / lines.width();
        const double v = (place.y - lines.ymin) / (lines.ymax - lines.ymin);
        return {std::nullopt, std::nullopt, height * std::sin(kPi * u) * std::sin(kPi * v)};
    });
    shape.options.load_case = "push";
    shape.options.free_prescribed = true;
}

Shape shape_of(const Arguments& arguments) {
    Shape shape;
    const bool is_dome = arguments.shape == "dome";
    shape.project = experiments::lattice(is_dome ? 9 : 11, is_dome ? 8 : 4);
    shape.options.palette = experiments::palette(arguments.patterns, arguments.seed);
    shape.options.seed = arguments.seed;
    shape.options.threads = arguments.threads;
    if (arguments.solutions > 0) shape.options.most_solutions = arguments.solutions;
    shape.options.free_factor = arguments.free_factor;
    if (arguments.shape == "field")
        make_field(shape, arguments);
    else if (arguments.shape == "two" || arguments.shape == "two-tips")
        make_two(shape, arguments);
    else if (arguments.shape == "arch")
        make_arch(shape);
    else if (is_dome)
        make_dome(shape);
    else
        throw base::InputError("'" + arguments.shape +
                               "' is no shape: expected field, two, two-tips, arch or dome");
    return shape;
}

/// The best single pattern of a design, with the free unknowns at their best, too.
double uniform_error(const Shape& shape, const design::DesignReport& report) {
    double least = report.best_uniform ? report.best_uniform->mean : NAN;
    if (!shape.options.free_factor && !shape.options.free_prescribed) return least;
    design::DesignOptions options = shape.options;
    std::erase_if(options.palette, [&](const auto& own) { return own.id != report.best_uniform_pattern; });
    const auto alone = design::design(shape.project, nullptr, shape.target, options);
    if (alone.error) least = std::min(least, alone.error->mean);
    return least;
}

void print_shape(const Arguments& arguments) {
    const Shape shape = shape_of(arguments);
    const auto report = design::design(shape.project, nullptr, shape.target, shape.options);
    experiments::Row row;
    row.method = "design";
    row.tiles = shape.project.tessellation.tiles.size();
    row.target = arguments.shape + (arguments.free_factor ? " with its load free" : "");
    row.palette = arguments.patterns;
    row.seed = arguments.seed;
    row.bent = shape.largest / experiments::span_of(shape.project);
    row.uniform = uniform_error(shape, report);
    experiments::take_report(report, row);
    for (const std::string& warning : design::plain_texts(report.warnings))
        std::fprintf(stderr, "warning: %s\n", warning.c_str());
    experiments::print(row);
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app("A design for a shape that no painting is known to reach, as a row of a table");
    app.add_option("--shape", arguments.shape, "field, two, two-tips, arch or dome");
    app.add_option("--patterns", arguments.patterns, "Of the palette: a number drawn at random, or all");
    app.add_option("--seed", arguments.seed, "Of the instance and of the search");
    app.add_flag("--free-factor", arguments.free_factor, "Search the factor on the loads, too");
    app.add_option("--solutions", arguments.solutions,
                   "Maximum number of nonlinear solutions; 0: the default");
    app.add_option("--threads", arguments.threads, "Of the design");
    CLI11_PARSE(app, argc, argv);
    try {
        print_shape(arguments);
    } catch (const base::Error& error) {
        std::fprintf(stderr, "inverse_design_shapes: %s\n", error.what());
        return 2;
    }
    return 0;
}
