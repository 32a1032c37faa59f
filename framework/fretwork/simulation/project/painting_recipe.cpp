// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/detail/painting_palette.hpp>
#include <fretwork/simulation/project/painting_recipe.hpp>
#include <fretwork/simulation/project/project_library.hpp>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace fretwork::simulation {
namespace {

using tiling::TileIndex;

/// Reads the file if the choice does not have its content yet. False if it is too large to be kept.
bool keep_file(std::filesystem::path& file, std::optional<FileContent>& content) {
    if (!content) {
        content = FileContent{base::read_text_file(file)};
        file = base::printable(file.filename().string());
    }
    return content->bytes.size() <= kLargestKeptFile;
}

struct RecipeMaker {
    const PaintingGround& ground;

    std::optional<PaintingChoice> operator()(PaintAtRandom choice) const {
        choice.palette = listed(choice.palette);
        return choice;
    }
    std::optional<PaintingChoice> operator()(PaintByField choice) const {
        choice.palette = listed(choice.palette);
        auto* image = std::get_if<FieldImage>(&choice.field);
        if (image != nullptr && !keep_file(image->file, image->content)) return std::nullopt;
        return choice;
    }
    std::optional<PaintingChoice> operator()(PaintByColours choice) const {
        if (!keep_file(choice.drawing, choice.content)) return std::nullopt;
        return choice;
    }
    template <class Other>
    std::optional<PaintingChoice> operator()(const Other&) const {
        return std::nullopt;
    }

    /// A library or a painting file may change or go.
    [[nodiscard]] PaletteChoice listed(const PaletteChoice& palette) const {
        return {.ids = pattern::ids_of(detail::palette_of(palette, ground))};
    }
};

/// Equal choices are one recipe.
void add_recipe(Project& project, PaintingChoice choice, const std::vector<TileIndex>& tiles) {
    auto known = std::ranges::find(project.recipes, choice, &PaintingRecipe::choice);
    if (known == project.recipes.end())
        known = project.recipes.insert(known, PaintingRecipe{std::move(choice), {}});
    known->tiles.insert(known->tiles.end(), tiles.begin(), tiles.end());
    std::ranges::sort(known->tiles);
}

/// What follows a painting of a project's tiles.
void note_painting(Project& project, const std::vector<TileIndex>& painted, const PaintingChoice& choice,
                   const PaintingGround& ground) {
    if (painted.empty()) return;
    std::optional<PaintingChoice> recipe = recipe_of(choice, ground);
    end_recipes(project, painted);
    if (recipe) add_recipe(project, *std::move(recipe), painted);
}

}  // namespace

std::optional<PaintingChoice> recipe_of(const PaintingChoice& choice, const PaintingGround& ground) {
    return std::visit(RecipeMaker{ground}, choice);
}

std::vector<TileIndex> paint(Project& project, const PaintingChoice& choice,
                             const library::Library* library) {
    if (std::holds_alternative<std::monostate>(choice)) return {};
    const reduction::Setting setting = setting_of(project, library);
    const PaintingGround ground{project.layout, setting, library};
    std::vector<TileIndex> painted = paint(project.tessellation, choice, ground);
    note_painting(project, painted, choice, ground);
    return painted;
}

std::vector<TileIndex> paint(Project& project, std::span<const TileIndex> tiles, const PaintingChoice& choice,
                             const library::Library* library) {
    const reduction::Setting setting = setting_of(project, library);
    const PaintingGround ground{project.layout, setting, library};
    std::vector<TileIndex> painted = paint(project.tessellation, tiles, choice, ground);
    note_painting(project, painted, choice, ground);
    return painted;
}

void end_recipes(Project& project, std::span<const TileIndex> tiles) {
    const std::set<TileIndex> ended(tiles.begin(), tiles.end());
    for (PaintingRecipe& recipe : project.recipes)
        std::erase_if(recipe.tiles, [&](TileIndex tile) { return ended.contains(tile); });
    std::erase_if(project.recipes, [](const PaintingRecipe& recipe) { return recipe.tiles.empty(); });
}

void apply_recipes(Project& project, const library::Library* library) {
    if (project.recipes.empty()) return;
    const reduction::Setting setting = setting_of(project, library);
    const PaintingGround ground{project.layout, setting, library};
    for (std::size_t i = 0; i < project.recipes.size(); ++i) {
        const PaintingRecipe& recipe = project.recipes[i];
        base::located("recipe " + std::to_string(i), "",
                      [&] { return paint(project.tessellation, recipe.tiles, recipe.choice, ground); });
    }
}

}  // namespace fretwork::simulation
