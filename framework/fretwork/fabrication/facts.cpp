// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/fabrication/detail/bar_angles.hpp>
#include <fretwork/fabrication/detail/fillets.hpp>
#include <fretwork/fabrication/detail/length_text.hpp>
#include <fretwork/fabrication/detail/patches.hpp>
#include <fretwork/fabrication/facts.hpp>
#include <fretwork/fabrication/shape.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/mechanics/standard_gravity.hpp>
#include <fretwork/simulation/results/bar_clearance.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>
#include <fretwork/simulation/simulate.hpp>
#include <fretwork/simulation/stages.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::fabrication {
namespace {

using geometry::Point2;

using namespace detail;
using simulation::LoadCase;
using simulation::Surface;

/// The largest number of warnings of one kind that are listed. Further warnings are only counted.
constexpr std::size_t kMostOfOneKind = 30;
/// This model follows large rotations: thin sheets bend far under their loads and their own weight.
const std::string kModel = "corotational";

void require_positive(double value, const char* what) {
    if (std::isfinite(value) && value > 0.0) return;
    throw base::InputError(std::string(what) + " is " + base::format_number(value) +
                           ", where a number above zero is needed");
}

std::string where(TileIndex tile, TessellationNodeIndex node, const geometry::Point2& place) {
    return "tile " + std::to_string(tile) + ", node " + std::to_string(node) + " at " + place_text(place) +
           ": ";
}

/// A load case with the same supports, and with gravity as the only load.
LoadCase own_weight(const LoadCase& load_case) {
    LoadCase weight;
    weight.name = load_case.name;
    weight.supports = load_case.supports;
    weight.gravity = {0.0, 0.0, -mechanics::kStandardGravity};
    return weight;
}

simulation::SurfaceResult estimate(const Surface& surface, const LoadCase& load_case,
                                   const FactsOptions& wanted) {
    const simulation::SimulationOptions options{
        .model = kModel, .models = wanted.models, .estimate_where_doubtful = true};
    simulation::SurfaceResult result =
        simulation::simulate(surface, load_case, options, wanted.control.silent());
    result.subject = simulation::result_subject(surface, load_case, options);
    return result;
}

class FactFinder {
  public:
    FactFinder(const Surface& surface, const ShapeOptions& shape, const FactsOptions& options)
        : surface_(surface), options_(options), plan_(bar_plan(surface, shape.frame_width)) {
        shape_ = make_shape(plan_, shape.without_kerf());
        for (const std::string& remark : remarks(shape)) warn(remark);
        warn_of_section();
    }

    Facts run(const FactsLoads& loads) {
        measure();
        judge_places();
        judge_angles();
        judge_overlaps();
        judge_pieces();
        options_.control.check();
        if (loads.load_case != nullptr) estimate_sag(*loads.load_case);
        judge_stress(loads);
        return std::move(facts_);
    }

  private:
    [[nodiscard]] std::vector<std::string> remarks(const ShapeOptions& shape) const {
        if (shape.kerf > 0.0 && options_.bed) return cut_into_sheets(surface_, shape, *options_.bed).remarks;
        return shape_remarks(shape_, shape.kerf > 0.0 ? make_shape(plan_, shape) : shape_, shape);
    }

    void measure() {
        facts_.tiles = surface_.tessellation.tiles.size();
        facts_.bars = plan_.bars.size();
        facts_.joints = surface_.setting.joints;
        facts_.pieces = shape_.pieces.size();
        facts_.openings = opening_count(shape_);
        facts_.box = box_of(shape_);
        facts_.height = shape_.height;
        facts_.area = area(shape_);
        facts_.volume = facts_.area * shape_.height;
        facts_.mass = facts_.volume * surface_.setting.material.density;
        for (const double mass : simulation::tile_masses(surface_)) facts_.beam_mass += mass;
        facts_.cut_length = cut_length(shape_);
        facts_.pierces = facts_.pieces + facts_.openings;
        facts_.layers = static_cast<std::size_t>(std::ceil(shape_.height / options_.layer_height - 1e-9));
        facts_.wall_length = facts_.cut_length * static_cast<double>(facts_.layers);
        const auto radii = inner_corner_radii(shape_);
        facts_.smallest_radius = radii.empty() ? 0.0 : std::ranges::min(radii);
        facts_.strength = options_.strength ? options_.strength : surface_.setting.strength;
    }

    void warn(std::string message, const std::optional<Point2>& place = std::nullopt) {
        facts_.warnings.push_back({std::move(message), place});
    }
    /// Repeat the warnings of the result from which sag or stress comes.
    void warn_of_result(const std::string& value, const simulation::SurfaceResult& result) {
        for (const std::string& warning : simulation::result_warnings(result)) warn(value + ": " + warning);
    }
    void warn_of_more(std::size_t count, const std::string& what) {
        if (count > kMostOfOneKind) warn("and " + std::to_string(count - kMostOfOneKind) + " more " + what);
    }

    void warn_of_section() {
        const auto& shape = surface_.setting.section.shape;
        if (!shape || std::holds_alternative<mechanics::RectangleShape>(*shape)) return;
        warn("bars are made as rectangles of " + millimetres(plan_.width) + " by " +
             millimetres(shape_.height) + ", which stand for the " + mechanics::shape_name(*shape) +
             " of the setting: mass and lengths are those of the rectangles, stresses those of the " +
             mechanics::shape_name(*shape));
    }

    void judge_places() {
        const auto places =
            narrow_places(shape_, plan_, std::max(options_.clearance, 2.0 * plan_.width), options_.control);
        if (!places.empty()) facts_.narrowest = places.front();
        std::size_t count = 0;
        for (const NarrowPlace& narrow : places) {
            if (narrow.width >= options_.clearance) break;
            if (++count > kMostOfOneKind) continue;
            const bool gap = narrow.kind == NarrowPlace::Kind::Gap;
            warn(where(narrow.tile, narrow.node, narrow.place) + (gap ? "a gap of " : "an opening of ") +
                     millimetres(narrow.width) + (gap ? "" : " at most") + ", below the clearance of " +
                     millimetres(options_.clearance),
                 narrow.place);
        }
        warn_of_more(count, "narrow places");
    }

    void judge_angles() {
        const auto angles = bar_angles(plan_);
        facts_.sharpest_angle = angles.empty() ? 2.0 * std::numbers::pi : angles.front().angle;
        std::size_t count = 0;
        for (const BarAngle& one : angles) {
            if (one.angle >= options_.sharp_angle) break;
            if (++count > kMostOfOneKind) continue;
            const Point2& place = plan_.nodes[one.node];
            warn(where(one.tile, one.node, place) + "two beams meet at " +
                     short_number(one.angle * 180.0 / std::numbers::pi) + " degrees",
                 place);
        }
        warn_of_more(count, "sharp angles");
    }

    /// Warn of bars that overlap: the material makes them one piece, but the model has two separate bars.
    void judge_overlaps() {
        const auto close = simulation::close_bars(surface_, 0.0, options_.control);
        if (!close.empty()) warn(simulation::close_bars_text(close));
    }

    void judge_pieces() {
        for (std::size_t p = 1; p < shape_.pieces.size() && p <= kMostOfOneKind; ++p) {
            const Point2& place = shape_.pieces[p].outer.front().place;
            warn("disconnected piece at " + place_text(place), place);
        }
        const auto nodes = nodes_with_bars(plan_);
        const auto corners = std::ranges::count_if(
            plan_.coincidences, [&](const BarPlan::Coincidence& one) { return nodes.contains(one.taken); });
        if (corners > 0)
            warn(std::to_string(corners) +
                 " nodes of neighbouring tiles, or of the border, lie at one place: the material is "
                 "joined there, but the model is not");
    }

    /// Solve with gravity scaled to the mass of the outline, because beams count joints more than once.
    [[nodiscard]] simulation::SurfaceResult estimate_outline(LoadCase load_case) const {
        if (facts_.beam_mass > 0.0) load_case.gravity *= facts_.mass / facts_.beam_mass;
        return estimate(surface_, load_case, options_);
    }

    void estimate_sag(const LoadCase& load_case) {
        if (load_case.supports.empty() || surface_.setting.material.density <= 0.0) return;
        simulation::SurfaceResult result;
        try {
            result = estimate_outline(own_weight(load_case));
        } catch (const base::NumericalError& error) {
            return warn("the sag under its own weight on the supports alone is not known: " +
                        std::string(error.what()));
        }
        if (!result.solution.converged())
            return warn("the sag under its own weight is not known: its path ends at " +
                        short_number(100.0 * result.solution.load_factor) + " % of the weight");
        warn_of_result("the sag under its own weight", result);
        Facts::Sag sag{load_case.name, result.solution.reactions.col(2).sum(), 0.0, {}};
        for (std::size_t n = 0; n < surface_.tessellation.interface_nodes.size(); ++n) {
            const double down = std::abs(result.solution.displacements(n, 2));
            if (down <= sag.deflection) continue;
            sag.deflection = down;
            sag.place = surface_.tessellation.interface_nodes[n];
        }
        if (sag.deflection > 0.1 * std::max(facts_.box.width(), facts_.box.height()))
            warn("the sag under its own weight is large: " + millimetres(sag.deflection), sag.place);
        facts_.sag = sag;
    }

    void judge_stress(const FactsLoads& loads) {
        if (loads.result != nullptr) {
            warn_of_result("the stress of the result", *loads.result);
            take_stress(*loads.result, "the result");
        } else if (loads.load_case != nullptr) {
            estimate_stress(*loads.load_case);
        }
        if (!facts_.stress || !facts_.strength || facts_.stress->value <= *facts_.strength) return;
        const Point2& place = plan_.nodes[facts_.stress->node];
        warn(where(facts_.stress->tile, facts_.stress->node, place) + "a stress of " +
                 short_number(facts_.stress->value * 1e-6) + " MPa, above the strength of " +
                 short_number(*facts_.strength * 1e-6) + " MPa",
             place);
    }

    void estimate_stress(const LoadCase& load_case) {
        const simulation::SurfaceResult result = estimate_outline(load_case);
        if (!result.solution.converged())
            return warn("the stress under the load case " + load_case.name +
                        " is not known: its path ends at " +
                        short_number(100.0 * result.solution.load_factor) + " % of the load");
        warn_of_result("the stress under the load case " + load_case.name, result);
        take_stress(result, "load case " + load_case.name);
    }

    /// Take the largest stress of all load steps and load stages, because loads may be taken off again.
    void take_stress(const simulation::SurfaceResult& result, const std::string& source) {
        const simulation::SurfaceBeams beams = simulation::surface_beams(surface_);
        const auto sections = simulation::beam_sections(beams, surface_.setting);
        if (result.load_steps.empty())
            return take_largest(
                beams, simulation::beam_state(surface_, result, beams, sections, options_.models), source);
        const std::vector<simulation::BeamState> states =
            simulation::step_beam_states(surface_, result, beams, sections, options_.models);
        const std::vector<std::string> stages = simulation::stage_names(result);
        for (std::size_t i = 0; i < states.size(); ++i)
            take_largest(beams, states[i],
                         source + (i < stages.size() ? ", load stage " + stages[i]
                                                     : ", load step " + std::to_string(i + 1)));
    }

    void take_largest(const simulation::SurfaceBeams& beams, const simulation::BeamState& state,
                      const std::string& source) {
        for (Eigen::Index row = 0; row < state.forces.rows(); ++row) {
            const double value = state.forces(row, simulation::kVonMisesField);
            if (!(value > (facts_.stress ? facts_.stress->value : -1.0))) continue;
            const std::size_t beam = row / 2;
            const int node = beams.ends[beam][row % 2];
            facts_.stress = Facts::Stress{source, value, beams.tiles[beam], TessellationNodeIndex(node)};
        }
    }

    const Surface& surface_;
    const FactsOptions& options_;
    BarPlan plan_;
    Shape shape_;
    Facts facts_;
};

}  // namespace

void FactsOptions::validate() const {
    require_positive(clearance, "the clearance, m,");
    constexpr double kThinnestLayer = 1e-6;  // m; printers make layers of 1e-5 m and more
    if (!(std::isfinite(layer_height) && layer_height >= kThinnestLayer))
        throw base::InputError("the height of layers is " + base::format_number(layer_height) +
                               " m, where at least 1e-06 m is needed");
    require_positive(sharp_angle, "the angle below which to warn of beams, rad,");
    if (strength) require_positive(*strength, "the strength, Pa,");
}

Facts facts(const Surface& surface, const ShapeOptions& shape, const FactsLoads& loads,
            const FactsOptions& options) {
    options.validate();
    shape.validate();
    return FactFinder(surface, shape, options).run(loads);
}

}  // namespace fretwork::fabrication
