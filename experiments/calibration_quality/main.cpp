// SPDX-License-Identifier: GPL-3.0-or-later
// The gain from each method and number of starts: every calibration of a stratified sample of patterns
// against the best objective that is known for it. See README.md.
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/progress.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/reduction/calibration/calibration.hpp>
#include <fretwork/reduction/stratified_sample.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

namespace {

using namespace fretwork;

struct Options {
    std::size_t patterns = 120;
    int reference_starts = 500;
    int threads = 0;
    std::string out = "calibration_quality.csv";
};

/// One method as it is compared.
struct Contender {
    const char* optimizer;
    int starts;
};
constexpr Contender kContenders[] = {
    {"ceres-multistart", 1},        {"ceres-multistart", 2},        {"ceres-multistart", 4},
    {"ceres-multistart", 8},        {"ceres-multistart", 16},       {"ceres-multistart", 32},
    {"gauss-newton-multistart", 1}, {"gauss-newton-multistart", 4}, {"gauss-newton-multistart", 8},
    {"ceres-residuals", 8},         {"ceres-residuals", 32},        {"simulated-annealing", 1},
};
constexpr int kBudget = 10'000'000;
constexpr std::uint64_t kReferenceSeed = 1'000'003;

struct Measurement {
    double objective = 0.0;
    long evaluations = 0;
    double cpu_seconds = 0.0;
};

struct PatternResult {
    std::string id;
    int edges = 0;
    double reference = 0.0;
    std::vector<Measurement> contenders;
    [[nodiscard]] double best() const {
        double value = reference;
        for (const Measurement& m : contenders) value = std::min(value, m.objective);
        return value;
    }
};

double thread_cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Measurement measure(const reduction::CalibrationInput& input, const reduction::CalibrationOptions& options) {
    const double start = thread_cpu_seconds();
    const auto found = reduction::calibrate(reduction::find_tile_model("paper6"), input, options);
    return {found.objective, found.cost, thread_cpu_seconds() - start};
}

PatternResult examine(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                      const Options& options) {
    const reduction::Setting setting = reduction::paper_setting();
    const auto responses = reduction::compute_responses(layout, pattern, setting);
    PatternResult result{pattern::pattern_id(layout, pattern), pattern.edge_count(), 0.0, {}};
    const reduction::CalibrationInput input{layout, pattern, setting, responses};
    result.reference = measure(input, {.optimizer = "ceres-multistart",
                                       .starts = options.reference_starts,
                                       .seed = kReferenceSeed,
                                       .budget = kBudget})
                           .objective;
    for (const Contender& contender : kContenders) {
        result.contenders.push_back(measure(
            input,
            {.optimizer = contender.optimizer, .starts = contender.starts, .seed = 1, .budget = kBudget}));
    }
    return result;
}

std::vector<PatternResult> examine_sample(const Options& options) {
    const auto layout = pattern::find_node_layout("paper7");
    const auto all =
        pattern::enumerate_patterns(layout, {.edges = pattern::default_edge_range(layout), .filters = {}});
    const auto chosen = reduction::spread_over_edges(all, options.patterns);
    base::TerminalProgress progress;
    progress.start("calibration quality", chosen.size());
    std::vector<PatternResult> results;
    constexpr std::size_t kBatch = 4;
    for (std::size_t begin = 0; begin < chosen.size(); begin += kBatch) {
        const std::size_t count = std::min(kBatch, chosen.size() - begin);
        std::vector<PatternResult> batch(count);
        base::parallel_for(count, options.threads,
                           [&](std::size_t i) { batch[i] = examine(layout, chosen[begin + i], options); });
        std::ranges::move(batch, std::back_inserter(results));
        progress.update(results.size());
    }
    progress.finish();
    return results;
}

std::string csv(const std::vector<PatternResult>& results) {
    std::string text = "pattern,edges,optimizer,starts,objective,best_known,evaluations,cpu_seconds\n";
    for (const PatternResult& result : results) {
        for (std::size_t c = 0; c < result.contenders.size(); ++c) {
            const Measurement& m = result.contenders[c];
            text += result.id + "," + std::to_string(result.edges) + "," + kContenders[c].optimizer + "," +
                    std::to_string(kContenders[c].starts) + "," + base::format_number(m.objective) + "," +
                    base::format_number(result.best()) + "," + std::to_string(m.evaluations) + "," +
                    base::format_number(m.cpu_seconds) + "\n";
        }
    }
    return text;
}

/// The share of patterns on which a contender comes within `tolerance` of the best known objective.
double share_within(const std::vector<PatternResult>& results, std::size_t contender, double tolerance) {
    const auto count = std::ranges::count_if(results, [&](const PatternResult& result) {
        return result.contenders[contender].objective <= (1.0 + tolerance) * result.best();
    });
    return static_cast<double>(count) / static_cast<double>(results.size());
}

void print_table(const std::vector<PatternResult>& results) {
    const auto patterns = static_cast<double>(results.size());
    std::printf(
        "| method | starts | within 0.1 %% | within 1 %% | worst excess | mean E | evaluations | CPU ms |\n"
        "|---|---|---|---|---|---|---|---|\n");
    for (std::size_t c = 0; c < std::size(kContenders); ++c) {
        double evaluations = 0.0;
        double seconds = 0.0;
        double objective = 0.0;
        double worst = 0.0;
        for (const PatternResult& result : results) {
            evaluations += static_cast<double>(result.contenders[c].evaluations) / patterns;
            seconds += result.contenders[c].cpu_seconds / patterns;
            objective += result.contenders[c].objective / patterns;
            worst = std::max(worst, result.contenders[c].objective / result.best() - 1.0);
        }
        std::printf("| `%s` | %d | %.1f %% | %.1f %% | %.2g %% | %.4f | %.0f | %.1f |\n",
                    kContenders[c].optimizer, kContenders[c].starts, 100 * share_within(results, c, 1e-3),
                    100 * share_within(results, c, 1e-2), 100 * worst, objective, evaluations, 1e3 * seconds);
    }
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Compare calibrations with the best known ones.");
    app.add_option("--patterns", options.patterns, "How many, spread over the numbers of edges")
        ->capture_default_str();
    app.add_option("--reference-starts", options.reference_starts, "Starts of the reference")
        ->capture_default_str();
    app.add_option("--threads", options.threads, "Threads; 0: all there are")->capture_default_str();
    app.add_option("--out", options.out, "The CSV file to write")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        const auto results = examine_sample(options);
        base::write_file_atomically(options.out, csv(results));
        print_table(results);
    } catch (const base::Error& error) {
        std::fprintf(stderr, "calibration_quality: %s\n", error.what());
        return 2;
    }
    return 0;
}
