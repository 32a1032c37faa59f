// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of the calibrations of a library, and their causes. See README.md.
#include "tables.hpp"

#include <fretwork/base/error.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>

namespace {

using namespace fretwork;

void print_objectives(const experiments::TableInput& input) {
    const library::CalibrationKey key =
        library::calibration_key(input.options, reduction::find_tile_model("paper6"));
    std::vector<double> objectives;
    std::size_t at_bound = 0;
    for (const auto& entry : input.patterns) {
        for (const auto& record : input.library.calibrations(entry.id)) {
            if (record.key() != key) continue;
            objectives.push_back(record.calibration.objective);
            at_bound += record.calibration.at_bound.empty() ? 0 : 1;
        }
    }
    const auto d = experiments::distribution(objectives);
    std::printf("Optimal objective E of the six-parameter model (%s, %d starts)\n\n", key.optimizer.c_str(),
                key.starts);
    experiments::print_head({"patterns", "mean", "deviation", "5 %", "25 %", "median", "75 %", "95 %",
                             "largest", "with a parameter at a bound"});
    std::vector<std::string> row = {std::to_string(objectives.size()), experiments::fixed(d.mean, 2),
                                    experiments::fixed(d.deviation, 2)};
    for (const double share : {0.05, 0.25, 0.5, 0.75, 0.95, 1.0})
        row.push_back(experiments::fixed(d.quantile(share), 2));
    row.push_back(std::to_string(at_bound));
    experiments::print_row(row);
    std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
    std::string path;
    int threads = 0;
    CLI::App app("Tables of a calibrated library: displacements, objectives, policies, magnitudes.");
    app.add_option("library", path, "The library, calibrated with the default options")->required();
    app.add_option("--threads", threads, "Threads; 0: all there are")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        const auto library = library::Library::open(path);
        const experiments::TableInput input{library, library.patterns(), {}, threads};
        experiments::print_displacements(input);
        print_objectives(input);
        experiments::print_policies(input);
        experiments::print_magnitudes(input);
    } catch (const base::Error& error) {
        std::fprintf(stderr, "calibration_statistics: %s\n", error.what());
        return 2;
    }
    return 0;
}
