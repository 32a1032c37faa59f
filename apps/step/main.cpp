// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork-step writes the solids of a project's surface to a STEP file. It is a separate program, because it
// needs OpenCASCADE.
#include "step_text.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/project/project_library.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <typed/making_choice.hpp>

namespace fretwork::step {
namespace {

struct Options {
    std::string project;
    std::string to;
    std::string library;
    std::string load_case;
    typed::MakingChoice making{};
    bool json = false;
};

/// Refuse a path without the ending of a STEP file, and an existing file that is no STEP file.
void require_replaceable(const std::filesystem::path& path) {
    const std::string ending = base::ending_of(path);
    if (ending != ".step" && ending != ".stp")
        throw base::InputError(path.string(), "", "has another ending than .step and .stp");
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) return;
    if (base::read_text_file(path).rfind("ISO-10303-21", 0) != 0)
        throw base::InputError(path.string(), "", "is there already, and is no STEP file");
}

simulation::Surface read_surface(const Options& options, const simulation::Project& project) {
    if (project.setting && options.library.empty()) return simulation::make_surface(project, nullptr);
    const std::optional<library::Library> library =
        simulation::open_project_library(options.project, project, options.library);
    return simulation::make_surface(project, library ? &*library : nullptr);
}

void print(const fabrication::Shape& shape, const Options& options) {
    const std::size_t solids = shape.pieces.size();
    const double volume = 1e9 * fabrication::area(shape) * shape.height;  // mm3, as in the file
    if (options.json) {
        const std::string document = base::json_text(
            {{"path", options.to}, {"solids", solids}, {"volume", volume}, {"unit", "millimetre"}});
        std::fputs(document.c_str(), stdout);
    } else {
        std::printf("%s: %s, %s mm3\n", base::printable(options.to).c_str(),
                    base::counted(solids, "solid").c_str(), base::format_number(volume, 6).c_str());
    }
}

void run(const Options& options) {
    require_replaceable(options.to);
    const simulation::Project project = simulation::read_checked_project(options.project);
    const simulation::Surface surface = read_surface(options, project);
    std::optional<simulation::Conditions> conditions;
    if (!options.load_case.empty())
        conditions = simulation::resolve(simulation::find_load_case(project, options.load_case), surface);
    const exports::Making making = typed::read_making(options.making, conditions ? &*conditions : nullptr);
    const auto [shape, remarks] = fabrication::make_remarked_shape(surface, making.shape);
    const std::string text = step_text(shape, std::filesystem::path(options.to).stem().string());
    base::write_file_atomically(options.to, text);
    for (const std::string& remark : remarks) std::fprintf(stderr, "fretwork-step: %s\n", remark.c_str());
    print(shape, options);
}

void flush_output() {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
    throw base::IoError("the standard output cannot be written");
}

void add_options(CLI::App& app, Options& options) {
    app.add_option("project", options.project, "Project file")->required();
    app.add_option("--to", options.to, "File to write: .step or .stp")->required();
    app.add_option("--case", options.load_case, "Load case whose supports get the holes of --bolts");
    app.add_option("--library", options.library, "Library with the setting (default: the project's)");
    app.add_option("--fillet", options.making.fillet,
                   "Radius of inner corners between bars (default: sharp)");
    app.add_option("--frame", options.making.frame, "Width of a frame along the rim");
    app.add_option("--bolts", options.making.bolts, "Diameter of holes at the supports of --case");
    app.add_option(
        "--eye", options.making.eye,
        "Diameter of the disc of material around each hole of --bolts (default: twice that of the hole)");
    app.add_flag("--json", options.json,
                 "Print what was written as JSON; volume in mm3, the cube of its `unit`");
    app.footer("Example: fretwork-step project.json --fillet 0.5mm --frame 4mm --to chair.step");
}

}  // namespace
}  // namespace fretwork::step

int main(int argc, char** argv) {
    using namespace fretwork;
    CLI::App app(
        "Write the solid parts of a project to a STEP file: extruded outlines with true arcs, millimetres",
        "fretwork-step");
    step::Options options;
    step::add_options(app, options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    try {
        step::run(options);
        step::flush_output();
        return 0;
    } catch (...) {
        const base::Failure failure = base::handled_failure();
        std::fprintf(stderr, "fretwork-step: %s\n", failure.text.c_str());
        return failure.is_defect ? 70 : 2;  // as in fretwork
    }
}
