// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/exports/tables/line_files.hpp>
#include <fretwork/exports/tables/series_files.hpp>

#include <algorithm>
#include <functional>

namespace fretwork::exports {
namespace {

std::vector<double> times_of(const std::vector<mechanics::Solution>& steps) {
    std::vector<double> times;
    for (const mechanics::Solution& step : steps) times.push_back(step.load_factor);
    if (std::ranges::adjacent_find(times, std::greater_equal()) == times.end()) return times;
    for (std::size_t i = 0; i < times.size(); ++i) times[i] = static_cast<double>(i + 1);
    return times;
}

/// Check that a stem can be part of an XML attribute.
void check_stem(const std::string& stem) {
    if (stem.find_first_of("\"&<>") != std::string::npos)
        throw base::InputError("a series for ParaView cannot be called '" + stem +
                               "': its name holds one of \" & < >");
}

}  // namespace

std::string series_step_name(const std::string& stem, std::size_t step) {
    return stem + "-" + std::to_string(step) + ".vtu";
}

std::vector<NamedFile> series_files(const simulation::Surface& surface,
                                    const simulation::SurfaceResult& result, const std::string& stem,
                                    std::optional<double> strength,
                                    std::span<const reduction::TileModel> models) {
    check_stem(stem);
    const std::vector<mechanics::Solution> steps =
        result.load_steps.empty() ? std::vector{result.solution} : result.load_steps;
    const std::vector<double> times = times_of(steps);
    std::string collection = "<?xml version=\"1.0\"?>\n<!-- " + std::string(base::kMadeBy) +
                             " -->\n<VTKFile type=\"Collection\" version=\"0.1\" "
                             "byte_order=\"LittleEndian\">\n<Collection>\n";
    std::vector<NamedFile> files;
    simulation::SurfaceResult there = result;
    there.vibration_modes.clear();  // modes are computed at rest, and do not belong to a step
    there.buckling_modes.clear();
    there.load_steps.clear();
    for (std::size_t i = 0; i < steps.size(); ++i) {
        there.solution = steps[i];
        files.push_back(
            {series_step_name(stem, i + 1), vtu_text(beam_lines(surface, &there, strength, models))});
        collection += "<DataSet timestep=\"" + base::format_number(times[i]) + "\" part=\"0\" file=\"" +
                      files.back().name + "\"/>\n";
    }
    files.insert(files.begin(), {stem + ".pvd", collection + "</Collection>\n</VTKFile>\n"});
    return files;
}

}  // namespace fretwork::exports
