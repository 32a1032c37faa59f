// SPDX-License-Identifier: GPL-3.0-or-later
// Storing, reading, hashing and exporting, at the size of the paper's library: 1,824 patterns x 5 scenarios x
// 10 magnitudes x 6 nodes.
#include <fretwork/library/fill.hpp>
#include <fretwork/pattern/enumerate.hpp>

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>

namespace fretwork::library {
namespace {

const std::vector<pattern::Pattern>& paper_patterns() {
    static const std::vector<pattern::Pattern> patterns = [] {
        const auto layout = pattern::find_node_layout("paper7");
        pattern::EnumerationOptions options;
        options.edges = pattern::default_edge_range(layout);
        std::vector<pattern::Pattern> list;
        pattern::for_each_pattern(layout, options,
                                  [&](const pattern::Pattern& found) { list.push_back(found); });
        return list;
    }();
    return patterns;
}

PatternData made_up_data(const std::string& id, double seed) {
    const reduction::Setting setting = reduction::paper_setting();
    PatternData data{id, {}, {}, {}};
    for (const reduction::Scenario& scenario : setting.scenarios) {
        reduction::Response response{scenario.name, {}};
        for (int k = 1; k <= setting.magnitudes; ++k) {
            reduction::Response::Sample sample{k, scenario.max_magnitude * k / setting.magnitudes,
                                               mechanics::NodeValues(6, 6)};
            for (int i = 0; i < 36; ++i) sample.displacements(i / 6, i % 6) = std::sin(seed + i + 0.1 * k);
            response.samples.push_back(sample);
        }
        data.responses.push_back(response);
    }
    CalibrationRecord record;
    record.calibration.optimizer = "made-up";
    record.calibration.scenario_errors.assign(setting.scenarios.size(), 1.0 / seed);
    data.calibrations.push_back(record);
    return data;
}

/// A library in a temporary file that vanishes with it.
class TemporaryLibrary {
  public:
    TemporaryLibrary()
        : path_(std::filesystem::temp_directory_path() / "fretwork_library_bench.db"), library_(make()) {}
    TemporaryLibrary(const TemporaryLibrary&) = delete;
    TemporaryLibrary& operator=(const TemporaryLibrary&) = delete;
    ~TemporaryLibrary() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    Library& operator*() { return library_; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    Library make() {
        std::filesystem::remove(path_);
        Library library =
            Library::create(path_, pattern::find_node_layout("paper7"), reduction::paper_setting());
        library.add_patterns(paper_patterns());
        return library;
    }
    std::filesystem::path path_;
    Library library_;
};

void fill(Library& library, std::size_t batch_size) {
    std::vector<PatternData> batch;
    for (const pattern::NamedPattern& entry : library.patterns()) {
        batch.push_back(made_up_data(entry.id, static_cast<double>(entry.pattern.edge_count())));
        if (batch.size() < batch_size) continue;
        library.store(batch);
        batch.clear();
    }
    library.store(batch);
}

void store_paper_library(benchmark::State& state) {
    for (auto _ : state) {
        state.PauseTiming();
        TemporaryLibrary library;
        state.ResumeTiming();
        fill(*library, static_cast<std::size_t>(state.range(0)));
        state.counters["MB"] = static_cast<double>(std::filesystem::file_size(library.path())) * 1e-6;
    }
    state.counters["patterns"] = benchmark::Counter(static_cast<double>(paper_patterns().size()),
                                                    benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(store_paper_library)->Arg(16)->Arg(64)->Unit(benchmark::kMillisecond);

/// Responses, properties and calibrations of the nine patterns of two edges, and storing them, on one thread.
void fill_two_edge_patterns(benchmark::State& state) {
    FillOptions options;
    options.threads = 1;
    for (auto _ : state) {
        state.PauseTiming();
        TemporaryLibrary library;
        std::vector<pattern::NamedPattern> patterns = (*library).patterns();
        std::erase_if(patterns,
                      [](const pattern::NamedPattern& entry) { return entry.pattern.edge_count() > 2; });
        state.ResumeTiming();
        benchmark::DoNotOptimize(fill(*library, patterns, options));
    }
}
BENCHMARK(fill_two_edge_patterns)->Unit(benchmark::kMillisecond);

Library& filled() {
    static TemporaryLibrary library;
    static const bool done = (fill(*library, 64), true);
    benchmark::DoNotOptimize(done);
    return *library;
}

void open_and_summarize(benchmark::State& state) {
    const std::filesystem::path path = filled().path();
    for (auto _ : state) benchmark::DoNotOptimize(Library::open(path).summaries());
}
BENCHMARK(open_and_summarize)->Unit(benchmark::kMillisecond);

void read_responses_of_one_pattern(benchmark::State& state) {
    const Library& library = filled();
    for (auto _ : state) benchmark::DoNotOptimize(library.responses("0-1+1-6"));
}
BENCHMARK(read_responses_of_one_pattern)->Unit(benchmark::kMicrosecond);

void hash_content(benchmark::State& state) {
    const Library& library = filled();
    for (auto _ : state) benchmark::DoNotOptimize(library.content_hash());
}
BENCHMARK(hash_content)->Unit(benchmark::kMillisecond);

void export_tables(benchmark::State& state) {
    const auto folder = std::filesystem::temp_directory_path() / "fretwork_library_bench";
    for (auto _ : state) filled().export_csv(folder);
    std::filesystem::remove_all(folder);
}
BENCHMARK(export_tables)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fretwork::library
