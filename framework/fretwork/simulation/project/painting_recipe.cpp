// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/detail/painting_palette.hpp>
#include <fretwork/simulation/project/painting_recipe.hpp>
#include <fretwork/simulation/project/project_library.hpp>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <utility>

namespace fretwork::simulation {
namespace {

using tiling::TileIndex;

/// A choice with the content of its image or drawing, if any. The same content paints and goes into the
/// recipe.
struct LoadedChoice {
    explicit LoadedChoice(PaintingChoice given) : choice(std::move(given)) {
        if (auto* field = std::get_if<PaintByField>(&choice)) {
            if (auto* image = std::get_if<FieldImage>(&field->field)) load(image->file, image->content);
        } else if (auto* colours = std::get_if<PaintByColours>(&choice)) {
            load(colours->drawing, colours->content);
        }
    }

    PaintingChoice choice;
    bool is_from_path = false;  ///< true if the file was read here, so that its name is a path

  private:
    void load(const std::filesystem::path& file, std::optional<FileContent>& content) {
        if (content) return;
        content = FileContent{base::read_text_file(file)};
        is_from_path = true;
    }
};

/// The image or the drawing of a choice, or null.
const std::filesystem::path* file_of(const PaintingChoice& choice) {
    if (const auto* colours = std::get_if<PaintByColours>(&choice)) return &colours->drawing;
    const auto* field = std::get_if<PaintByField>(&choice);
    const auto* image = field != nullptr ? std::get_if<FieldImage>(&field->field) : nullptr;
    return image != nullptr ? &image->file : nullptr;
}

struct RecipeMaker {
    const PaintingGround& ground;
    bool is_from_path;

    std::optional<PaintingChoice> operator()(PaintAtRandom choice) const {
        choice.palette = listed(choice.palette);
        return choice;
    }
    std::optional<PaintingChoice> operator()(PaintByField choice) const {
        choice.palette = listed(choice.palette);
        auto* image = std::get_if<FieldImage>(&choice.field);
        if (image != nullptr && !keeps(image->file, *image->content)) return std::nullopt;
        return choice;
    }
    std::optional<PaintingChoice> operator()(PaintByColours choice) const {
        if (!keeps(choice.drawing, *choice.content)) return std::nullopt;
        return choice;
    }
    template <class Other>
    std::optional<PaintingChoice> operator()(const Other&) const {
        return std::nullopt;
    }

    /// False if the file is too large. Of a path, only the file's name is kept: a project may be moved.
    [[nodiscard]] bool keeps(std::filesystem::path& file, const FileContent& content) const {
        if (is_from_path) file = base::printable(file.filename().string());
        return content.bytes.size() <= kLargestKeptFile;
    }

    /// The ids of a palette, because its library or file may change.
    [[nodiscard]] PaletteChoice listed(const PaletteChoice& palette) const {
        return {.ids = pattern::ids_of(detail::palette_of(palette, ground))};
    }
};

/// Tiles of equal choices share a recipe. A tile may be painted twice; the recipe has it once.
void add_recipe(Project& project, PaintingChoice choice, const std::vector<TileIndex>& tiles) {
    auto known = std::ranges::find(project.recipes, choice, &PaintingRecipe::choice);
    if (known == project.recipes.end())
        known = project.recipes.insert(known, PaintingRecipe{std::move(choice), {}});
    known->tiles.insert(known->tiles.end(), tiles.begin(), tiles.end());
    std::ranges::sort(known->tiles);
    const auto repeated = std::ranges::unique(known->tiles);
    known->tiles.erase(repeated.begin(), repeated.end());
}

std::optional<PaintingChoice> recipe_of(const LoadedChoice& loaded, const PaintingGround& ground) {
    return std::visit(RecipeMaker{ground, loaded.is_from_path}, loaded.choice);
}

/// Update the recipes after tiles have been painted.
void note_painting(Project& project, const std::vector<TileIndex>& painted, const LoadedChoice& loaded,
                   const PaintingGround& ground) {
    if (painted.empty()) return;
    std::optional<PaintingChoice> recipe = recipe_of(loaded, ground);
    end_recipes(project, painted);
    if (recipe) add_recipe(project, *std::move(recipe), painted);
}

}  // namespace

std::optional<PaintingChoice> recipe_of(const PaintingChoice& choice, const PaintingGround& ground) {
    return recipe_of(LoadedChoice(choice), ground);
}

std::optional<std::string> unkept_file_remark(const PaintingChoice& choice) {
    const std::filesystem::path* file = file_of(choice);
    if (file == nullptr) return std::nullopt;
    return "the project does not keep " + base::printable(file->string()) + ", which has more than " +
           std::to_string(kLargestKeptFile >> 20U) +
           " MiB: if the surface is tiled again, new tiles take the patterns of the nearest old ones";
}

std::optional<std::string> unkept_file_remark(const Project& project, const PaintingChoice& choice,
                                              std::span<const TileIndex> painted) {
    if (painted.empty()) return std::nullopt;
    const bool has_recipe = std::ranges::any_of(project.recipes, [&](const PaintingRecipe& recipe) {
        return std::ranges::binary_search(recipe.tiles, painted.front());
    });
    return has_recipe ? std::nullopt : unkept_file_remark(choice);
}

std::vector<TileIndex> paint(Project& project, const PaintingChoice& choice,
                             const library::Library* library) {
    if (std::holds_alternative<std::monostate>(choice)) return {};
    const reduction::Setting setting = setting_of(project, library);
    const PaintingGround ground{project.layout, setting, library};
    const LoadedChoice loaded(choice);
    std::vector<TileIndex> painted = paint(project.tessellation, loaded.choice, ground);
    note_painting(project, painted, loaded, ground);
    return painted;
}

std::vector<TileIndex> paint(Project& project, std::span<const TileIndex> tiles, const PaintingChoice& choice,
                             const library::Library* library) {
    const reduction::Setting setting = setting_of(project, library);
    const PaintingGround ground{project.layout, setting, library};
    const LoadedChoice loaded(choice);
    std::vector<TileIndex> painted = paint(project.tessellation, tiles, loaded.choice, ground);
    note_painting(project, painted, loaded, ground);
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
