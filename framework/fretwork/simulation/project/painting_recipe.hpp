// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>
#include <fretwork/simulation/project/painting_choice.hpp>
#include <fretwork/simulation/project/project.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fretwork::simulation {

/// The largest image or drawing that a project keeps, in bytes.
inline constexpr std::size_t kLargestKeptFile = std::size_t{4} << 20U;

/// A choice as a recipe keeps it: its palette lists ids, and an image or a drawing has its content. None if
/// the choice gives patterns neither by place nor by chance (one pattern, a painting file), or if its file
/// has more than kLargestKeptFile bytes. Throws as paint().
std::optional<PaintingChoice> recipe_of(const PaintingChoice& choice, const PaintingGround& ground);

/// A remark for the user on a choice without a recipe: its image or drawing is too large to be kept. None if
/// the choice has no such file.
std::optional<std::string> unkept_file_remark(const PaintingChoice& choice);
/// The same remark on a choice that has just painted tiles of a project. None if these tiles have a recipe.
std::optional<std::string> unkept_file_remark(const Project& project, const PaintingChoice& choice,
                                              std::span<const tiling::TileIndex> painted);

/// Paint all tiles of a project by a choice, and keep the choice as their recipe if recipe_of() has one. The
/// tiles leave the recipes that they had. `library` may be null. Returns the painted tiles. Throws as paint()
/// of a tessellation, and as setting_of().
std::vector<tiling::TileIndex> paint(Project& project, const PaintingChoice& choice,
                                     const library::Library* library);
/// Paint some tiles of a project by a choice, as above.
std::vector<tiling::TileIndex> paint(Project& project, std::span<const tiling::TileIndex> tiles,
                                     const PaintingChoice& choice, const library::Library* library);

/// Take tiles out of their recipes, because they were painted in another way. Recipes that lose all tiles are
/// removed.
void end_recipes(Project& project, std::span<const tiling::TileIndex> tiles);

/// Paint the tiles of every recipe again, such as after a retiling or with another setting. `library` may be
/// null: then properties of patterns are computed. Throws InputError that names the recipe by its number, or
/// as setting_of().
void apply_recipes(Project& project, const library::Library* library);

}  // namespace fretwork::simulation
