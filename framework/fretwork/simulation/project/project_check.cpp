// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/named.hpp>
#include <fretwork/outlines/coloured_drawing.hpp>
#include <fretwork/reduction/effective_properties.hpp>
#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/project/project_check.hpp>
#include <fretwork/tiling/painting/field.hpp>

#include <cstddef>
#include <utility>

namespace fretwork::simulation {
namespace {

/// Throws InputError unless a property is one that tiles have without a library.
void check_property(const std::string& property) {
    const reduction::EffectiveProperties any{Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity(), 1.0};
    using Row = std::pair<std::string, double>;
    (void)base::find_named(property, reduction::property_values(any), &Row::first, "property");
}

/// Checks the content of a recipe, with one operator for each kind of choice.
struct RecipeCheck {
    const Project& project;
    std::string file;
    std::string place;  ///< JSON pointer of the recipe

    void operator()(const PaintByField& choice) const {
        const auto* image = std::get_if<FieldImage>(&choice.field);
        if (image != nullptr && image->content)
            base::located(file, place + "/image", [&] {
                (void)tiling::image_values(image->content->bytes, image->file.string(), {}, {});
            });
        if (!choice.property.empty() && project.library_path.empty())
            base::located(file, place + "/property", [&] { check_property(choice.property); });
    }
    void operator()(const PaintByColours& choice) const {
        if (!choice.content) return;
        base::located(file, place + "/drawing", [&] {
            (void)outlines::ColouredDrawing::parse(choice.content->bytes, choice.drawing.string());
        });
    }
    /// The reader has checked the other choices whole.
    template <class Other>
    void operator()(const Other&) const {}
};

}  // namespace

void check_tile_models(const Project& project, const std::string& file) {
    for (std::size_t i = 0; i < project.tile_models.size(); ++i) {
        base::located(file, "/tile_models/" + std::to_string(i) + "/model",
                      [&] { (void)reduction::find_tile_model(project.tile_models[i].model); });
    }
}

void check_project(const Project& project, const std::string& file) {
    check_tile_models(project, file);
    for (const LoadCase& load_case : project.load_cases)
        base::located(file, "", [&] { check_selections(load_case, project.tessellation); });
    for (std::size_t i = 0; i < project.recipes.size(); ++i)
        std::visit(RecipeCheck{project, file, "/recipes/" + std::to_string(i)}, project.recipes[i].choice);
}

}  // namespace fretwork::simulation
