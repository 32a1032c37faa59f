// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/named.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/internal/mode_count.hpp>
#include <fretwork/simulation/simulation_options.hpp>

#include <algorithm>
#include <string_view>

namespace fretwork::simulation {
namespace {

constexpr std::string_view kMixedPrefix = "mixed:";

void check_mixed(const SimulationOptions& options) {
    if (!mixed_share(options.model)) return;
    (void)reference_choice(options);
    if (options.analysis == Analysis::Linear)
        throw base::InputError("model " + options.model +
                               " is for large displacements: a linear analysis of tiles in full or condensed "
                               "gives the same");
    if (options.estimate_error)
        throw base::InputError(
            "the discretization error of " + options.model +
            " cannot be estimated: most of its tiles are not made of beams; that of full can");
}

void check_branch(const Surface& surface, const SimulationOptions& options) {
    if (options.branch == mechanics::Branch::Primary) return;
    const std::string name(mechanics::branch_name(options.branch));
    if (!is_nonlinear(surface, options) || mixed_share(options.model))
        throw base::InputError("model " + options.model + ": the " + name +
                               " branch is followed by full and corotational tiles, not by linear solutions, "
                               "nor by mixed models");
    if (options.estimate_error || options.estimate_model_error)
        throw base::InputError(
            "estimates of errors on request are made along the primary branch, not along the " + name +
            " branch");
}

void check_model_error(const Surface& surface, const SimulationOptions& options) {
    if (!options.estimate_model_error) return;
    if (options.analysis == Analysis::OfTheModel && is_reference(surface, options))
        throw base::InputError("model " + options.model + " is the reference: it has no model error");
}

}  // namespace

std::string mixed_model(double share) {
    return std::string(kMixedPrefix) + base::format_number(share);
}

std::optional<double> mixed_share(const std::string& model) {
    if (model == "mixed")
        throw base::InputError("model mixed: the share of tiles in full is missing, as in mixed:0.05");
    if (!model.starts_with(kMixedPrefix)) return std::nullopt;
    const auto share = base::read_number<double>(std::string_view(model).substr(kMixedPrefix.size()));
    if (!share || !(*share >= 0.0 && *share <= 1.0))
        throw base::InputError("model " + model +
                               ": the share of tiles in full is a number from 0 to 1, as in "
                               "mixed:0.05");
    return share;
}

ModelChoice model_choice(const SimulationOptions& options) {
    if (!mixed_share(options.model) &&
        std::ranges::find(options.models, options.model, &reduction::TileModel::name) ==
            options.models.end()) {
        auto names = base::names_of(options.models, &reduction::TileModel::name);
        names.emplace_back("mixed:SHARE");
        throw base::InputError(base::unknown_name_message("tile model", options.model, names));
    }
    return {mixed_share(options.model) ? kMixedTiles : options.model, options.models};
}

ModelChoice reference_choice(const SimulationOptions& options) {
    const auto row =
        std::ranges::find(options.models, reduction::Role::Reference, &reduction::TileModel::role);
    if (row == options.models.end())
        throw base::InputError("none of the tile models has all beams of a tile");
    return {row->name, options.models};
}

bool is_nonlinear(const Surface& surface, const SimulationOptions& options) {
    return displacements(surface, model_choice(options)) == reduction::Displacements::Large &&
           options.analysis == Analysis::OfTheModel;
}

bool is_reference(const Surface& surface, const SimulationOptions& options) {
    if (mixed_share(options.model)) return false;
    const ModelChoice choice = model_choice(options);
    for (std::size_t t = 0; t < surface.tessellation.tiles.size(); ++t) {
        if (tile_model(surface, choice, tiling::TileIndex(t)).role != reduction::Role::Reference)
            return false;
    }
    return true;
}

void SimulationOptions::validate(const Surface& surface) const {
    const bool nonlinear = is_nonlinear(surface, *this);
    check_mixed(*this);
    check_model_error(surface, *this);
    check_branch(surface, *this);
    if (threads < 0) throw base::InputError("threads: " + std::to_string(threads) + " must not be negative");
    if (estimate_error && !nonlinear)
        throw base::InputError(
            "the discretization error is estimated for nonlinear models made of beams only");
    for (const int modes : {vibration_modes, buckling_modes}) mechanics::check_mode_count(modes, 0);
    if (load_steps > 1 && !nonlinear)
        throw base::InputError("the number of steps is " + std::to_string(load_steps) +
                               ", where a linear solution has no path to divide");
    constexpr int kMostSteps = 10000;
    if (load_steps < 1 || load_steps > kMostSteps) {
        throw base::InputError("the number of steps is " + std::to_string(load_steps) + ", where 1 to " +
                               std::to_string(kMostSteps) + " are possible");
    }
}

}  // namespace fretwork::simulation
