// SPDX-License-Identifier: GPL-3.0-or-later
// Every reduced tile model beside the full one, on the paper's scenarios and on painted surfaces. See
// README.md.
#include "scenarios.hpp"
#include "surfaces.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/files/provenance.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>

namespace {

using namespace fretwork;
using namespace fretwork::tile_models;

struct Options {
    std::size_t patterns = 60;
    int repeats = 5;
    int threads = 0;
    std::string out = ".";
};

std::string five_digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.5g", value);
    return text;
}

std::string scenarios_csv(const std::vector<ScenarioRow>& rows, const reduction::Setting& setting) {
    std::string text = "pattern,model,parameters,E";
    for (const reduction::Scenario& scenario : setting.scenarios) text += "," + scenario.name;
    text += ",evaluations,cpu_seconds,at_bound\n";
    for (const ScenarioRow& row : rows) {
        text += row.pattern + "," + row.model + "," + std::to_string(row.parameters) + "," +
                five_digits(row.objective);
        for (const double error : row.scenario_errors) text += "," + five_digits(error);
        text += "," + std::to_string(row.evaluations) + "," + five_digits(row.cpu_seconds) + "," +
                std::to_string(row.at_bound) + "\n";
    }
    return text;
}

std::string number_or_nothing(const std::optional<double>& value) {
    return value ? five_digits(*value) : "";
}

std::string surfaces_csv(const std::vector<SurfaceRow>& rows) {
    std::string text =
        "surface,kind,tiles,wanted,deflection,model,mean_error,largest_error,seconds,iterations\n";
    for (const SurfaceRow& row : rows) {
        text += std::to_string(row.surface) + "," + row.kind + "," + std::to_string(row.tiles) + "," +
                five_digits(row.wanted) + "," + five_digits(row.deflection) + "," + row.model + "," +
                number_or_nothing(row.mean_error) + "," + number_or_nothing(row.largest_error) + "," +
                five_digits(row.seconds) + "," + std::to_string(row.iterations) + "\n";
    }
    return text;
}

std::string provenance_text() {
    std::string text;
    for (const auto& [name, value] : base::provenance()) text += name + ": " + value + "\n";
    return text;
}

void run(const Options& options) {
    const reduction::Setting setting = reduction::paper_setting();
    const std::filesystem::path folder = options.out;
    const ScenarioStudy study = study_scenarios(setting, options.patterns, options.threads);
    base::write_file_atomically(folder / "scenarios.csv", scenarios_csv(study.rows, setting));
    base::write_file_atomically(folder / "provenance.txt", provenance_text());
    const auto rows = study_surfaces(setting, study.patterns, options.repeats);
    base::write_file_atomically(folder / "surfaces.csv", surfaces_csv(rows));
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Compare the tile models on scenarios and on surfaces.");
    app.add_option("--patterns", options.patterns, "How many, spread over the numbers of edges")
        ->capture_default_str();
    app.add_option("--repeats", options.repeats, "Surfaces of each kind of load")->capture_default_str();
    app.add_option("--threads", options.threads, "Threads of the calibrations; 0: all there are")
        ->capture_default_str();
    app.add_option("--out", options.out, "Folder of the CSV files")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        run(options);
    } catch (const base::Error& error) {
        std::fprintf(stderr, "tile_models: %s\n", error.what());
        return 2;
    }
    return 0;
}
