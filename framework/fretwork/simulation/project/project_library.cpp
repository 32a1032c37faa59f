// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/simulation/project/project_check.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/simulation/project/project_library.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace fretwork::simulation {
namespace {

namespace fs = std::filesystem;

/// The JSON pointer of the entry that gives a tile its own model; "" if there is none.
std::string place_of_model(const Project& project, tiling::TileIndex tile) {
    for (std::size_t i = 0; i < project.tile_models.size(); ++i) {
        if (std::ranges::find(project.tile_models[i].tiles, tile) != project.tile_models[i].tiles.end())
            return "/tile_models/" + std::to_string(i);
    }
    return "";
}

/// Throw InputError if a value is not plausible: another program or a fault of the disk has changed the
/// library.
void check_values(std::span<const double> values, const std::string& pattern,
                  const reduction::TileModel& model) {
    constexpr double kLeast = 1e-100, kMost = 1e100;  // beyond all calibrated values
    for (std::size_t i = 0; i < values.size(); ++i) {
        const reduction::TileParameter& parameter = model.parameters[i];
        const bool must_be_positive = parameter.scale == reduction::TileParameter::Scale::Logarithmic;
        const bool is_sound = std::abs(values[i]) < kMost && (!must_be_positive || values[i] > kLeast);
        if (!is_sound)
            throw base::InputError("the library's calibration of pattern " + pattern + " with " + model.name +
                                   " is damaged: " + parameter.name + " is " +
                                   base::format_number(values[i]) + "; calibrate it again in a new library");
    }
}

/// True for pipes and for names of open files, such as /dev/stdin, even if a shell has opened a regular file
/// there.
bool is_stream(const fs::path& file) {
    const fs::path folder = file.lexically_normal().parent_path();
    if (folder == "/dev" || folder == "/dev/fd" || folder == "/proc/self/fd") return true;
    std::error_code unknown;
    return fs::exists(file, unknown) && !fs::is_regular_file(file, unknown);
}

fs::path absolute_folder(const std::string& project_file) {
    return fs::absolute(folder_of_project(project_file) / "project").lexically_normal().parent_path();
}

}  // namespace

fs::path folder_of_project(const std::string& project_file) {
    return is_stream(project_file) ? fs::path() : fs::path(project_file).parent_path();
}

std::string library_path_from(const std::string& project_file, const fs::path& library) {
    return fs::absolute(library)
        .lexically_normal()
        .lexically_relative(absolute_folder(project_file))
        .generic_string();
}

std::string library_path_of(const std::string& project_file, const Project& project) {
    if (project.library_path.empty()) return "";
    return (folder_of_project(project_file) / project.library_path).string();
}

void move_library_path(Project& project, const std::string& from_file, const std::string& to_file) {
    if (project.library_path.empty() || absolute_folder(from_file) == absolute_folder(to_file)) return;
    project.library_path = library_path_from(to_file, library_path_of(from_file, project));
}

reduction::Setting setting_of(const Project& project, const library::Library* library) {
    if (library == nullptr) return project.setting.value_or(reduction::paper_setting());
    if (project.setting) library->check_setting(*project.setting);
    reduction::Setting setting = project.setting.value_or(library->setting());
    if (!setting.strength) setting.strength = library->setting().strength;
    return setting;
}

std::optional<library::Library> open_project_library(const std::string& project_file, const Project& project,
                                                     const std::string& wanted) {
    if (!wanted.empty()) return library::Library::open(wanted);
    if (project.library_path.empty()) return std::nullopt;
    const std::string path = library_path_of(project_file, project);
    std::error_code ignored;
    if (!fs::exists(path, ignored))
        throw base::InputError(
            project_file, "/library/path",
            "the library " + path + " is not there; bring it back, or give another library");
    library::Library library = library::Library::open(path);
    if (!library.has_content(project.library_hash)) {
        throw base::InputError(
            project_file, "/library/hash",
            "the library " + path +
                " has changed since the project was made; give it as the library to use it as it is now");
    }
    return library;
}

bool needs_library(const Project& project, const ModelChoice& choice) {
    const auto is_calibrated = [&](const std::string& model) {
        return !reduction::find_tile_model(model, choice.models).parameters.empty();
    };
    return !project.setting || is_calibrated(choice.name) ||
           std::ranges::any_of(project.tile_models, is_calibrated, &Project::TileModelChoice::model);
}

Project read_checked_project(const std::string& file) {
    Project project = read_project(file);
    check_tile_models(project, file);
    return project;
}

void check_calibrations(const std::string& file, const Project& project, const Surface& surface,
                        const ModelChoice& choice) {
    for (std::size_t t = 0; t < surface.tessellation.tiles.size(); ++t) {
        const tiling::TileIndex tile(t);
        base::located(file, place_of_model(project, tile), [&] {
            const auto& model = tile_model(surface, choice, tile);
            const std::vector<double> values = tile_parameters(surface, tile, model);
            check_values(values, tiling::pattern_of(surface.tessellation, tile)->id, model);
        });
    }
}

}  // namespace fretwork::simulation
