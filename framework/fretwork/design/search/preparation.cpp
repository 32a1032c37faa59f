// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/random.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/design/search/free_section.hpp>
#include <fretwork/design/search/preparation.hpp>
#include <fretwork/design/search/uniform_guess.hpp>
#include <fretwork/pattern/mirror.hpp>
#include <fretwork/simulation/results/bar_clearance.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace fretwork::design::detail {
namespace {

using pattern::NamedPattern;
using simulation::CandidateTiles;
using simulation::Surface;
using tiling::TileIndex;

/// The largest number of condensations worth their time and memory: a second or two, 50 MB.
constexpr std::size_t kMostCondensed = 8000;
constexpr std::size_t kFewestCandidates = 24;

/// A surface of one tile: the first hexagon, or the first tile if there is no hexagon.
Surface reference_surface(const Surface& surface) {
    Surface reference = surface;
    auto& tiles = reference.tessellation.tiles;
    const auto hexagon =
        std::ranges::find_if(tiles, [](const tiling::Tile& tile) { return tile.vertices.size() == 6; });
    tiles = {hexagon != tiles.end() ? *hexagon : tiles.front()};
    return reference;
}

/// The palette with its most different patterns first, and the coordinates of these (leading_coordinates()).
/// Patterns that are candidates already come next, and have coordinates, too.
struct SpreadPalette {
    std::vector<NamedPattern> patterns;
    Eigen::MatrixXd coordinates;
};

/// The largest number of patterns that are chosen as the most different, unless there are more uniform
/// paintings.
constexpr std::size_t kSpread = 128;

SpreadPalette spread_palette(const Surface& surface, const std::vector<NamedPattern>& palette,
                             const std::vector<NamedPattern>& known, const DesignOptions& options) {
    const CandidateTiles tile(reference_surface(surface), palette, {options.threads, options.control});
    const base::Control control = options.control.silent();
    const TileStrains strains(tile, options.threads, control);
    const Eigen::MatrixXd logs =
        stiffness_logarithms(strains, 0, tiling::mean_tile_side(surface.tessellation), control);
    // Uniform paintings have patterns with coordinates only.
    const std::size_t count = std::max(kSpread, options.uniform_paintings);
    auto chosen = spread_choice(logs, std::min(count, palette.size()), control);
    std::vector<bool> is_taken(palette.size(), false);
    for (const std::size_t place : chosen) is_taken[place] = true;
    for (const NamedPattern& own : known) {
        const auto place =
            static_cast<std::size_t>(std::ranges::find(palette, own.id, &NamedPattern::id) - palette.begin());
        if (place < palette.size() && !is_taken[place]) chosen.push_back(place);
        if (place < palette.size()) is_taken[place] = true;
    }
    SpreadPalette spread;
    for (const std::size_t place : chosen) spread.patterns.push_back(palette[place]);
    for (std::size_t p = 0; p < palette.size(); ++p) {
        if (!is_taken[p]) spread.patterns.push_back(palette[p]);
    }
    spread.coordinates = leading_coordinates(logs(Eigen::all, chosen));
    return spread;
}

/// The largest number of candidates that the number of tile classes allows.
std::size_t most_candidates(const CandidateTiles& tiles) {
    return std::max(kFewestCandidates, kMostCondensed / tiles.class_count());
}

/// At most `count` patterns, drawn at random, in the palette's order.
std::vector<NamedPattern> sampled(const std::vector<NamedPattern>& palette, std::size_t count,
                                  std::uint64_t seed) {
    if (palette.size() <= count) return palette;
    base::SplitMix64 random(base::SplitMix64::mix(seed));
    std::vector<NamedPattern> sample;
    for (std::size_t p = 0; p < palette.size() && sample.size() < count; ++p) {
        if (random.below(palette.size() - p) < count - sample.size()) sample.push_back(palette[p]);
    }
    return sample;
}

/// The name of the load case of goals that name none.
std::string default_case(const simulation::Project& project, const DesignOptions& options) {
    const bool is_only = options.load_case.empty() && project.load_cases.size() == 1;
    return is_only ? project.load_cases.front().name : options.load_case;
}

/// Names of the load cases that the goals speak of, in their order.
std::vector<std::string> case_names(const Target& target, const simulation::Project& project,
                                    const std::string& own) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < target.goals.size(); ++i) {
        const bool is_named = !target.goals[i].load_case.empty();
        const std::string& name = is_named ? target.goals[i].load_case : own;
        base::located("", "/goals/" + std::to_string(i) + (is_named ? "/case" : ""),
                      [&] { (void)simulation::find_load_case(project, name); });
        if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
    return names;
}

std::size_t place_of(std::vector<NamedPattern>& patterns, const NamedPattern& wanted) {
    const auto found = std::ranges::find(patterns, wanted.id, &NamedPattern::id);
    if (found != patterns.end()) return static_cast<std::size_t>(found - patterns.begin());
    patterns.push_back(wanted);
    return patterns.size() - 1;
}

/// Paints all tiles that are not kept with one pattern, because Trials needs a painted surface.
void paint_whole(Surface& surface, const std::vector<TileGroup>& groups, const NamedPattern& pattern) {
    tiling::Tessellation& tessellation = surface.tessellation;
    const std::size_t place = place_of(tessellation.patterns, pattern);
    for (const TileGroup& group : groups) {
        for (const TileGroup::Member& member : group.members)
            tessellation.tiles[member.tile].pattern = static_cast<int>(place);
    }
    surface.calibrations.resize(tessellation.patterns.size());
}

/// The patterns of a palette that have a mirror image in their layout.
std::vector<NamedPattern> with_mirror_image(const pattern::NodeLayout& layout,
                                            const std::vector<NamedPattern>& palette) {
    const pattern::Mirror mirror(layout);
    std::vector<NamedPattern> kept;
    for (const NamedPattern& own : palette) {
        if (mirror.image(own.pattern)) kept.push_back(own);
    }
    if (kept.empty())
        throw base::InputError(
            "no pattern of the palette has a mirror image in its layout, which a mirror symmetry needs");
    return kept;
}

/// The index of each candidate's mirror image; missing images become candidates. A kept tile's pattern may
/// have none: no group has this pattern, and its own index stands there.
std::vector<std::size_t> mirror_images(const pattern::NodeLayout& layout,
                                       std::vector<NamedPattern>& candidates) {
    const pattern::Mirror mirror(layout);
    std::vector<std::size_t> images;
    for (std::size_t p = 0; p < candidates.size(); ++p) {
        const std::optional<pattern::Pattern> image = mirror.image(candidates[p].pattern);
        images.push_back(image ? place_of(candidates, {pattern::pattern_id(layout, *image), *image}) : p);
    }
    return images;
}

bool needs_mirror_images(const Symmetry& symmetry) {
    return symmetry.kind == Symmetry::Kind::MirrorX || symmetry.kind == Symmetry::Kind::MirrorY;
}

/// The ids of the patterns of kept tiles, each once.
std::vector<std::string> kept_patterns(const Surface& surface, const DesignOptions& options) {
    std::vector<std::string> kept;
    for (const TileIndex tile : options.keep) {
        const auto* own = tiling::pattern_of(surface.tessellation, tile);
        if (own == nullptr)
            throw base::InputError("tile " + std::to_string(tile.value) +
                                   " is to be kept but has no pattern");
        if (std::ranges::find(kept, own->id) == kept.end()) kept.push_back(own->id);
    }
    return kept;
}

/// If kept tiles already have max_patterns patterns, only these are left for other tiles.
std::vector<NamedPattern> within_number(std::vector<NamedPattern> palette,
                                        const std::vector<std::string>& kept, const DesignOptions& options) {
    if (options.max_patterns == 0 || kept.size() < options.max_patterns) return palette;
    std::erase_if(palette,
                  [&](const NamedPattern& own) { return std::ranges::find(kept, own.id) == kept.end(); });
    if (kept.size() > options.max_patterns || palette.empty())
        throw base::InputError("the kept tiles have " + base::counted(kept.size(), "pattern") +
                               " already, where all tiles are to have " +
                               std::to_string(options.max_patterns) + " at most" +
                               (palette.empty() ? ", and none of these is in the palette" : ""));
    return palette;
}

/// With a mirror symmetry and no number left for a pattern and its image, only patterns that are their own
/// images are left, and those of kept tiles whose images have kept tiles, too.
std::vector<NamedPattern> within_number_of_pairs(const pattern::NodeLayout& layout,
                                                 std::vector<NamedPattern> palette,
                                                 const std::vector<std::string>& kept,
                                                 const DesignOptions& options) {
    if (options.max_patterns == 0 || kept.size() + 2 <= options.max_patterns) return palette;
    const pattern::Mirror mirror(layout);
    const auto is_kept = [&](const std::string& id) { return std::ranges::find(kept, id) != kept.end(); };
    std::erase_if(palette, [&](const NamedPattern& own) {
        const pattern::Pattern image = mirror.image(own.pattern).value();
        return image != own.pattern && !(is_kept(own.id) && is_kept(pattern::pattern_id(layout, image)));
    });
    if (palette.empty())
        throw base::InputError("a pattern and its mirror image are two of at most " +
                               base::counted(options.max_patterns, "pattern") +
                               ", and no pattern of the palette is its own mirror image");
    return palette;
}

/// The patterns of a palette whose own bars keep the clearance.
std::vector<NamedPattern> with_clearance(const Surface& surface, std::vector<NamedPattern> palette,
                                         const DesignOptions& options) {
    if (!options.clearance) return palette;
    Surface tile = reference_surface(surface);
    tile.tessellation.tiles[TileIndex(0)].pattern = 0;
    std::erase_if(palette, [&](const NamedPattern& own) {
        options.control.silent().check();
        tile.tessellation.patterns = {own};
        return !simulation::close_bars(tile, *options.clearance).empty();
    });
    if (palette.empty())
        throw base::InputError("every pattern of the palette has bars that come nearer to each other than " +
                               base::format_number(1e3 * *options.clearance, 4) +
                               " mm: a smaller clearance or narrower bars are needed");
    return palette;
}

bool is_loaded(const DesignCase& own) {
    return !own.load_case.loads.empty() || !own.load_case.area_loads.empty();
}

/// A combination has no factor or prescribed values of its own: found ones could not be written into it.
void require_no_combination(const simulation::Project& project, const std::vector<std::string>& names,
                            const DesignOptions& options) {
    if (!options.free_factor && !options.free_prescribed) return;
    for (const simulation::LoadCase& own : project.load_cases) {
        if (own.combines.empty() || std::ranges::find(names, own.name) == names.end()) continue;
        throw base::InputError(
            "load case '" + own.name + "' combines '" + own.combines.front().load_case + "'" +
            (own.combines.size() > 1 ? " and others" : "") + ": it has no " +
            (options.free_factor ? "factor on all its loads" : "prescribed values of its own") +
            " to be searched; a load case with these loads has");
    }
}

/// A factor or a value that is searched must act on something.
void require_free(const std::vector<DesignCase>& cases, const Surface& surface,
                  const DesignOptions& options) {
    const auto is_moved = [](const DesignCase& own) { return !own.load_case.prescribed.empty(); };
    const std::string which = cases.size() == 1 ? "load case '" + cases.front().load_case.name + "'"
                                                : "none of the target's load cases";
    if (options.free_factor && std::ranges::none_of(cases, is_loaded))
        throw base::InputError(which + " has " + (cases.size() == 1 ? "no" : "a") +
                               " load besides its weight whose factor could be searched");
    if (options.free_prescribed && std::ranges::none_of(cases, is_moved))
        throw base::InputError(which + " prescribes " + (cases.size() == 1 ? "no" : "a") +
                               " displacement that could be searched");
    if (options.free_width || options.free_thickness) require_rectangle(surface.setting.section);
}

/// The load cases with their goals. Throws InputError if what is free or wanted does not fit them.
std::vector<DesignCase> checked_cases(const simulation::Project& project, const Target& target,
                                      const Surface& surface, const std::vector<std::string>& names,
                                      const DesignOptions& options) {
    const std::string unnamed = default_case(project, options);
    std::vector<DesignCase> cases;
    for (const std::string& name : names)
        cases.push_back({simulation::find_load_case(project, name),
                         CaseGoals(target, name, unnamed, surface.tessellation)});
    require_no_combination(project, names, options);
    require_free(cases, surface, options);
    if (std::ranges::all_of(cases, [](const DesignCase& own) { return own.goals.largest() <= 0.0; }))
        throw base::InputError("", "/goals",
                               "the target asks for no displacement: the flat surface has it already");
    return cases;
}

/// Warnings about goals for nodes that are held. Free prescribed values do not count as held.
std::vector<DesignWarning> warnings_about(const std::vector<DesignCase>& cases, const Surface& surface,
                                          const DesignOptions& options) {
    std::vector<DesignWarning> warnings;
    for (const DesignCase& own : cases) {
        simulation::LoadCase held = own.load_case;
        held.gravity.setZero();
        if (options.free_prescribed) held.prescribed.clear();
        for (DesignWarning& warning : own.goals.against(simulation::resolve(held, surface)))
            warnings.push_back(std::move(warning));
    }
    return warnings;
}

}  // namespace

Preparation prepare(const simulation::Project& project, const library::Library* library, const Target& target,
                    const DesignOptions& options, std::size_t first) {
    Surface surface = simulation::make_surface(project, library);
    surface.tile_models = {};
    if (options.max_utilization > 0.0 && !surface.setting.strength)
        throw base::InputError("the largest utilization", "", "needs a strength, and the setting has none");
    const std::vector<std::string> kept = kept_patterns(surface, options);
    std::vector<TileGroup> groups = tile_groups(surface.tessellation, options.keep, options.symmetry);
    if (groups.empty()) throw base::InputError("all tiles are kept: there is nothing to paint");
    std::vector<std::string> names = case_names(target, project, default_case(project, options));
    std::vector<DesignCase> cases = checked_cases(project, target, surface, names, options);
    std::vector<NamedPattern> allowed =
        with_clearance(surface, within_number(options.palette, kept, options), options);
    if (needs_mirror_images(options.symmetry))
        allowed =
            within_number_of_pairs(surface.layout, with_mirror_image(surface.layout, allowed), kept, options);
    const std::size_t most = most_candidates(CandidateTiles(surface, {}, {options.threads, options.control}));
    SpreadPalette spread = spread_palette(surface, sampled(allowed, first, options.seed), {}, options);
    std::vector<NamedPattern> candidates = std::move(spread.patterns);
    candidates.resize(std::min(candidates.size(), most));
    if (allowed.size() <= first) allowed.clear();
    paint_whole(surface, groups, candidates.front());
    std::vector<std::size_t> palette(candidates.size());
    for (std::size_t p = 0; p < palette.size(); ++p) palette[p] = p;
    for (const TileIndex tile : options.keep)
        (void)place_of(candidates, *tiling::pattern_of(surface.tessellation, tile));
    std::vector<std::size_t> mirrored;
    if (needs_mirror_images(options.symmetry)) mirrored = mirror_images(surface.layout, candidates);
    std::vector<DesignWarning> warnings = warnings_about(cases, surface, options);
    CandidateTiles condensed(surface, std::move(candidates), {options.threads, options.control});
    return {{std::move(surface),
             std::move(cases),
             std::move(condensed),
             std::move(groups),
             std::move(mirrored),
             {options.free_factor, options.free_prescribed, options.free_width, options.free_thickness},
             options.threads},
            std::move(names),
            std::move(palette),
            std::move(spread.coordinates),
            std::move(warnings),
            std::move(allowed)};
}

ExtendedPalette extend_palette(Trials& trials, const std::vector<NamedPattern>& whole,
                               const DesignOptions& options) {
    const Surface& surface = trials.parts().surface;
    std::vector<NamedPattern> candidates = trials.parts().candidates.patterns();
    SpreadPalette spread = spread_palette(surface, whole, candidates, options);
    const std::size_t most = std::max(static_cast<std::size_t>(spread.coordinates.cols()),
                                      most_candidates(trials.parts().candidates));
    spread.patterns.resize(std::min(spread.patterns.size(), most));
    ExtendedPalette choice{{}, std::move(spread.coordinates)};
    for (const NamedPattern& own : spread.patterns) choice.palette.push_back(place_of(candidates, own));
    std::vector<std::size_t> mirrored;
    if (needs_mirror_images(options.symmetry)) mirrored = mirror_images(surface.layout, candidates);
    trials.take_candidates(std::move(candidates), std::move(mirrored), options.control);
    return choice;
}

}  // namespace fretwork::design::detail
