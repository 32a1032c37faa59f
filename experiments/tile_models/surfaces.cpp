// SPDX-License-Identifier: GPL-3.0-or-later
#include "surfaces.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/progress.hpp>
#include <fretwork/base/random.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/project/new_project.hpp>
#include <fretwork/simulation/results/comparison.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretwork::tile_models {
namespace {

using simulation::LoadCase;
using simulation::Side;
using simulation::Surface;

/// A kind of load, and how far surfaces are deflected under it, as a share of the span.
struct Kind {
    const char* name;
    std::vector<double> wanted;
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> table = {{"cantilever", {0.05, 0.15, 0.4, 0.6}},
                                            {"bridge", {0.05, 0.15, 0.4, 0.6}},
                                            {"compression", {0.05, 0.15, 0.4, 0.6}},
                                            {"shear", {0.01, 0.03}},
                                            {"tension", {0.01, 0.03}}};
    return table;
}

struct Shape {
    double width;   ///< m, the span
    double height;  ///< m
};

LoadCase load_case(const std::string& kind, double amount, const Shape& shape) {
    LoadCase result;
    result.name = kind;
    result.supports.push_back({simulation::NodesAtSide{Side::Left}, mechanics::DofSet::all()});
    const auto total = [&](simulation::Selection where, const Eigen::Vector3d& force) {
        result.loads.push_back(
            {std::move(where), amount * force, Eigen::Vector3d::Zero(), LoadCase::Amount::Total});
    };
    const simulation::NodesAtSide right{Side::Right};
    if (kind == "cantilever") total(right, {0.0, 0.0, -1.0});
    if (kind == "shear") total(right, {0.0, 1.0, 0.0});
    if (kind == "tension") total(right, {1.0, 0.0, 0.0});
    if (kind == "compression") total(right, {-1.0, 0.0, 0.1});  // a little aside: one branch to follow
    if (kind == "bridge") {
        result.supports.push_back({right, {{false, true, true, false, false, false}}});
        total(simulation::NodesInBox{{0.35 * shape.width, -1.0, 0.65 * shape.width, shape.height + 1.0}},
              {0.0, 0.0, -1.0});
    }
    return result;
}

double largest_displacement(const simulation::SurfaceResult& result) {
    return result.solution.displacements.leftCols<3>().rowwise().norm().maxCoeff();
}

/// Nothing if there is no equilibrium.
std::optional<simulation::SurfaceResult> solved(const Surface& surface, const LoadCase& loads,
                                                const std::string& model) {
    try {
        auto result =
            simulation::simulate(surface, loads, {.model = model, .models = catalogue(), .threads = 1});
        if (result.solution.converged()) return result;
    } catch (const base::NumericalError&) {
        // Recorded as a model without an equilibrium.
    }
    return std::nullopt;
}

/// The load under which the corotational model is deflected as wanted, to 2 %.
std::optional<LoadCase> find_load(const Surface& surface, const Kind& kind, double wanted,
                                  const Shape& shape) {
    constexpr int kTrials = 14;
    const auto rigid = solved(surface, load_case(kind.name, 1e-4, shape), "condensed");
    if (!rigid) return std::nullopt;
    double amount = 1e-4 * wanted * shape.width / largest_displacement(*rigid);
    double below = 0.0;
    double above = std::numeric_limits<double>::infinity();
    for (int trial = 0; trial < kTrials; ++trial) {
        LoadCase loads = load_case(kind.name, amount, shape);
        const auto found = solved(surface, loads, "corotational");
        const double share = found ? largest_displacement(*found) / (wanted * shape.width) : 2.0;
        if (found && std::abs(share - 1.0) < 0.02) return loads;
        (share < 1.0 ? below : above) = amount;
        amount = std::clamp(amount / share, 0.3 * amount, 3.0 * amount);
        if (amount <= below || amount >= above) amount = 0.5 * (below + std::min(above, 3.0 * below));
    }
    return std::nullopt;
}

/// Eight patterns, painted at random.
Surface make_surface(const reduction::Setting& setting, const std::vector<CalibratedPattern>& patterns,
                     const Shape& shape, std::uint64_t seed) {
    base::RandomStream random(seed, 0);
    std::vector<std::string> ids;
    constexpr std::size_t kPalette = 8;
    while (ids.size() < std::min(kPalette, patterns.size())) {
        const auto pick = static_cast<std::size_t>(random.uniform() * static_cast<double>(patterns.size()));
        if (std::ranges::find(ids, patterns[pick].id) == ids.end()) ids.push_back(patterns[pick].id);
    }
    const auto outline = outlines::make_outline(
        {{0.0, 0.0}, {shape.width, 0.0}, {shape.width, shape.height}, {0.0, shape.height}}, {});
    auto made = simulation::make_project(
        outline,
        {.setting = setting, .painting = simulation::PaintAtRandom{.seed = seed, .palette = {.ids = ids}}},
        nullptr);
    Surface surface = simulation::make_surface(made.project, nullptr);
    for (std::size_t i = 0; i < surface.tessellation.patterns.size(); ++i) {
        const auto own =
            std::ranges::find(patterns, surface.tessellation.patterns[i].id, &CalibratedPattern::id);
        surface.calibrations[i] = own->calibrations;
    }
    return surface;
}

void add_rows(const Surface& surface, const LoadCase& loads, SurfaceRow row, double span,
              std::vector<SurfaceRow>& rows) {
    const auto full = solved(surface, loads, "full");
    if (!full) return;
    row.deflection = largest_displacement(*full) / span;
    for (const reduction::TileModel& model : catalogue()) {
        row.model = model.name;
        row.mean_error.reset();
        row.largest_error.reset();
        const bool is_full = model.role == reduction::Role::Reference;
        const auto result = is_full ? full : solved(surface, loads, model.name);
        if (result) {
            row.seconds = result->seconds;
            row.iterations = result->solution.iterations;
            row.mean_error = 0.0;
            row.largest_error = 0.0;
            if (!is_full) {
                const auto difference = simulation::compare(*full, *result);
                row.mean_error = difference.mean_translation_error / difference.max_displacement;
                row.largest_error = difference.max_translation_error / difference.max_displacement;
            }
        }
        rows.push_back(row);
    }
}

}  // namespace

std::vector<SurfaceRow> study_surfaces(const reduction::Setting& setting,
                                       const std::vector<CalibratedPattern>& patterns, int repeats) {
    std::vector<SurfaceRow> rows;
    base::TerminalProgress progress;
    progress.start("surfaces", kinds().size() * static_cast<std::size_t>(repeats));
    std::size_t done = 0;
    for (const Kind& kind : kinds()) {
        for (int repeat = 0; repeat < repeats; ++repeat) {
            const auto seed = static_cast<std::uint64_t>(1000 * (&kind - kinds().data()) + repeat + 1);
            base::RandomStream random(seed, 1);
            const double width = 0.35 + 0.2 * random.uniform();
            const Shape shape{width, width * (0.4 + 0.3 * random.uniform())};
            const Surface surface = make_surface(setting, patterns, shape, seed);
            for (const double wanted : kind.wanted) {
                const auto loads = find_load(surface, kind, wanted, shape);
                if (loads)
                    add_rows(surface, *loads,
                             {static_cast<int>(seed),
                              kind.name,
                              surface.tessellation.tiles.size(),
                              wanted,
                              0.0,
                              "",
                              {},
                              {}},
                             shape.width, rows);
            }
            progress.update(++done);
        }
    }
    progress.finish();
    return rows;
}

}  // namespace fretwork::tile_models
