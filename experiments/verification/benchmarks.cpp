// SPDX-License-Identifier: GPL-3.0-or-later
// Published benchmarks, ours beside the exact or published values: a table (Markdown), and load-displacement
// curves with the order of convergence (SVG). See README.md.
#include "benchmark_frames.hpp"
#include "plot.hpp"

#include <fretwork/base/files/file.hpp>
#include <fretwork/mechanics/discretization.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/paths/path_tracing.hpp>

#include <cstdio>

namespace fretwork::verification {
namespace {

using Eigen::Vector3d;
using mechanics::assemble;
using mechanics::Solution;

constexpr double kPi = std::numbers::pi;

void row(const char* benchmark, const char* quantity, double exact, double ours) {
    const double scale = std::max(std::abs(exact), 1e-300);
    std::printf("| %s | %s | %.6g | %.6g | %.1e |\n", benchmark, quantity, exact, ours,
                std::abs(ours - exact) / scale);
}

std::vector<Solution> path_of(const Frame& frame, int steps,
                              const mechanics::EquilibriumOptions& options = {}) {
    std::vector<double> factors;
    for (int k = 1; k <= steps; ++k) factors.push_back(static_cast<double>(k) / steps);
    return follow_load_path(assemble(frame), factors, options);
}

Panel roll_up() {
    Panel panel{.title = "End moment (closed form)",
                .x_label = "M L / E I",
                .y_label = "tip displacement / L",
                .legend_at_right = true};
    Series along{"exact: u / L", Series::Mark::Line, {}};
    Series across{"exact: w / L", Series::Mark::Line, {}};
    for (double t = 0.05; t <= 4.0 * kPi; t += 0.05) {
        along.points.emplace_back(t, std::sin(t) / t - 1.0);
        across.points.emplace_back(t, (1.0 - std::cos(t)) / t);
    }
    Frame frame = thin_cantilever(20);
    frame.loads.push_back({NodeIndex(1), Vector3d::Zero(), {0.0, -4.0 * kPi, 0.0}});
    Series ours{"ours, 20 elements", Series::Mark::Dots, {}};
    for (const Solution& solution : path_of(frame, 24)) {
        const double t = 4.0 * kPi * solution.load_factor;
        ours.points.emplace_back(t, solution.displacements(1, 0));
        ours.points.emplace_back(t, solution.displacements(1, 2));
        if (solution.load_factor == 0.5) row("roll-up, 2 pi", "-u / L", 1.0, -solution.displacements(1, 0));
    }
    panel.series = {along, ours, across};
    return panel;
}

Panel tip_force() {
    struct Known {
        double load, w, u, angle;
    };
    constexpr Known kKnown[] = {{0.25, .082746, .004118, .124292},
                                {1, .301721, .056433, .461352},
                                {2, .493457, .160642, .781750},
                                {5, .713792, .387628, 1.215368},
                                {10, .810609, .554996, 1.430286}};
    Frame frame = thin_cantilever(20);
    frame.loads.push_back({NodeIndex(1), {0.0, 0.0, 10.0}});
    Series across{"ours: w / L", Series::Mark::Line, {{0.0, 0.0}}};
    Series along{"ours: -u / L", Series::Mark::Line, {{0.0, 0.0}}};
    Series known{"Mattiasson", Series::Mark::Dots, {}};
    for (const Solution& solution : path_of(frame, 40)) {
        const double load = 10.0 * solution.load_factor;
        across.points.emplace_back(load, solution.displacements(1, 2));
        along.points.emplace_back(load, -solution.displacements(1, 0));
        for (const Known& value : kKnown) {
            if (std::abs(value.load - load) > 1e-9) continue;
            known.points.emplace_back(load, value.w);
            known.points.emplace_back(load, value.u);
            const std::string name =
                "tip force, P L^2 / E I = " + std::to_string(static_cast<int>(value.load));
            if (value.load >= 1.0) row(name.c_str(), "w / L", value.w, solution.displacements(1, 2));
            if (value.load >= 1.0) row(name.c_str(), "tip angle", value.angle, -solution.displacements(1, 4));
        }
    }
    return {"Tip force (elliptic integrals)",
            "P L^2 / E I",
            "tip displacement / L",
            false,
            false,
            {across, along, known}};
}

Panel buckled_column() {
    Series exact{"exact, beside the foot", Series::Mark::Line, {}};
    for (double angle = 0.02; angle < 2.2; angle += 0.02) {
        const double k = std::sin(angle / 2.0);
        const double first = std::comp_ellint_1(k);
        exact.points.emplace_back(2.0 * k / first, std::pow(2.0 * first / kPi, 2));
    }
    Series ours{"ours, --branch stable", Series::Mark::Dots, {}};
    const Frame frame = euler_column(20);
    std::vector<double> factors;
    for (int i = 1; i <= 10; ++i) factors.push_back(1.0 + 0.08 * i);
    const auto path = follow_load_path(assemble(frame), factors, {.branch = mechanics::Branch::Stable});
    for (const Solution& solution : path)
        ours.points.emplace_back(solution.displacements(1, 2), solution.load_factor);
    row("column, clamped and free", "critical load / Euler's, followed", 1.0,
        path.front().stability_losses.at(0).load_factor);
    row("column, clamped and free", "critical load / Euler's, linearized", 1.0,
        buckling_modes(assemble(frame), 1).at(0).value);
    return {
        "Column beyond Euler's load", "tip displacement / L", "load / Euler's", false, false, {exact, ours}};
}

/// The load factor of the first maximum along a path, by the parabola through the points around it.
double first_limit(const std::vector<Solution>& path) {
    for (std::size_t k = 1; k + 1 < path.size(); ++k) {
        const double a = path[k - 1].load_factor, b = path[k].load_factor, c = path[k + 1].load_factor;
        if (b > a && b > c) return b + (c - a) * (c - a) / (8.0 * (2.0 * b - a - c));
    }
    return 0.0;
}

struct LimitCase {
    const char* name;
    double limit;
    int node;
    double largest_factor, largest_arc;
    int steps;
};

struct Units {
    const char* length;
    const char* force;
};

Panel snap(const Frame& frame, const LimitCase& limit, const Units& units) {
    const auto path = trace_path(assemble(frame), {.largest_load_factor = limit.largest_factor,
                                                   .largest_arc = limit.largest_arc,
                                                   .steps = limit.steps});
    Series curve{"ours, arc length", Series::Mark::Line, {{0.0, 0.0}}};
    double furthest = 0.0;
    for (const Solution& solution : path) {
        curve.points.emplace_back(-solution.displacements(limit.node, 2), limit.limit * solution.load_factor);
        furthest = std::max(furthest, curve.points.back().first);
    }
    Series known{"known limit load", Series::Mark::Line, {{0.0, limit.limit}, {furthest, limit.limit}}};
    row(limit.name, "first limit load", limit.limit, limit.limit * first_limit(path));
    return {limit.name,
            std::string("displacement, ") + units.length,
            std::string("load, ") + units.force,
            false,
            false,
            {curve, known}};
}

void critical_rows() {
    const double factors[] = {0.5, 0.9, 1.2};
    const auto add = [&](const char* name, double published, const Frame& frame) {
        const auto path = follow_load_path(assemble(frame), factors, {.locate_critical_loads = true});
        row(name, "critical load, followed", published,
            published * path[2].stability_losses.at(0).load_factor);
        row(name, "critical load, linearized", published,
            published * buckling_modes(assemble(frame), 1).at(0).value);
    };
    add("right-angle frame, tip force", 1.08752, right_angle_frame());
    add("right-angle frame, end moments", 622.222, hinged_right_angle_frame(1.0));
    add("hockling shaft (torque / exact)", 1.0, hockling_shaft());
}

void bend_rows() {
    const Vector3d exact(-23.55853, -13.60397, 53.47176);
    for (const int beams : {8, 16, 32}) {
        const auto tip = path_of(bathe_bolourchi_bend(beams, 1.0 / 6.0), 2).back().displacements.row(beams);
        const std::string name = "45-degree bend, " + std::to_string(beams) + " straight beams";
        row(name.c_str(), "tip, out of plane", exact.z(), tip[2]);
    }
}

void helix_rows() {
    const auto path = path_of(helix_cantilever(160), 200);
    row("helix, a tenth of the load", "tip, z", -1.09173, path[19].displacements(1, 2));
    row("helix, full load", "tip, x", -9.99520, path[199].displacements(1, 0));
    row("helix, full load", "tip, z, 160 divisions", -0.07644, path[199].displacements(1, 2));
    row("helix, full load", "tip, z, 320 divisions", -0.07644,
        path_of(helix_cantilever(320), 200).back().displacements(1, 2));
}

Panel convergence() {
    const auto errors = [](const char* name, const mechanics::NodalLoad& load,
                           const mechanics::Section& section) {
        const auto tip = [&](int divisions) {
            Frame frame = cantilever(1.0, {.nodes = {},
                                           .section = section,
                                           .material = {.young_modulus = 1e9, .poisson_ratio = 0.0},
                                           .divisions = divisions});
            frame.loads.push_back(load);
            return Eigen::VectorXd(
                path_of(frame, 4, {.relative_residual = 1e-11}).back().displacements.row(1).transpose());
        };
        const Eigen::VectorXd reference = tip(128);
        Series series{name, Series::Mark::Line, {}};
        for (const int divisions : {1, 2, 4, 8, 16})
            series.points.emplace_back(divisions, (tip(divisions) - reference).norm());
        const auto& p = series.points;
        std::printf("| order of convergence: %s | from 4 to 8 divisions | | %.2f | |\n", name,
                    std::log2(p[2].second / p[3].second));
        return series;
    };
    const mechanics::Section square{.area = 1e-4, .I2 = 1e-9, .I3 = 1e-9, .J = 1.7e-9};
    const mechanics::Section flat{.area = 1e-4, .I2 = 1e-9, .I3 = 4e-9, .J = 3e-9};
    const mechanics::NodalLoad in_plane{NodeIndex(1), {0.0, 0.0, 4.0}};
    const mechanics::NodalLoad in_space{NodeIndex(1), {0.0, 1.5, 2.0}, {0.8, 0.3, 0.2}};
    return {"Error of a cantilever's tip",
            "elements a beam",
            "error (m, rad)",
            true,
            true,
            {errors("in a plane", in_plane, square), errors("in space, square", in_space, square),
             errors("in space, flat section", in_space, flat)}};
}

void run(const std::string& out) {
    std::printf("| benchmark | quantity | exact or published | ours | difference |\n|---|---|---|---|---|\n");
    std::vector<Panel> panels{roll_up(), tip_force(), buckled_column()};
    panels.push_back(snap(lee_frame(), {"Lee's frame", 18556.73, 10, 2.0, 0.6, 150},
                          {"units of the source", "units of the source"}));
    panels.push_back(
        snap(williams_toggle(), {"Williams' toggle", 33.87039, 4, 1.5, 0.03, 600}, {"inches", "pounds"}));
    critical_rows();
    bend_rows();
    helix_rows();
    panels.push_back(convergence());
    base::write_file_atomically(out, plot_svg(panels));
}

}  // namespace
}  // namespace fretwork::verification

int main(int argc, char** argv) {
    fretwork::verification::run(argc > 1 ? argv[1] : "verification.svg");
}
