// SPDX-License-Identifier: GPL-3.0-or-later
// Queries about the patterns of a library and the data stored for each.
#include <fretwork/library/detail/library_impl.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/reduction/stratified_sample.hpp>

#include <algorithm>
#include <map>

namespace fretwork::library {
namespace {

using detail::Database;
using detail::Statement;
using detail::Transaction;

constexpr const char* kCountSamples =
    "SELECT pattern_id, count(*), sum(converged), sum(converged AND stable), sum(limit_load) "
    "FROM response_state ";
constexpr const char* kCountCalibrations =
    "SELECT pattern_id, count(*), min(objective) AS objective FROM calibration ";
/// The query of the patterns without a certain calibration. The key of the calibration and the names of the
/// failed computations are bound to it.
constexpr const char* kWithoutCalibration =
    "SELECT id FROM pattern "
    "WHERE NOT EXISTS (SELECT 1 FROM calibration WHERE pattern_id = id AND model = ? "
    "AND optimizer = ? AND seed = ? AND starts = ? AND budget = ?) "
    "AND NOT EXISTS (SELECT 1 FROM failure WHERE pattern_id = id AND stage IN (?, ?)) ";
constexpr const char* kWithoutResponses =
    "SELECT id FROM pattern "
    "WHERE NOT EXISTS (SELECT 1 FROM response_state WHERE pattern_id = id) "
    "AND NOT EXISTS (SELECT 1 FROM failure WHERE pattern_id = id AND stage = ?) ";

void read_samples(const Statement& row, PatternSummary& summary) {
    summary.samples = row.count(1);
    summary.converged_samples = row.count(2);
    summary.stable_samples = row.count(3);
    summary.limit_load_samples = row.count(4);
}

void read_calibrations(const Statement& row, PatternSummary& summary) {
    summary.calibrations = row.count(1);
    summary.best_objective = row.optional_real(2);
}

using SummariesById = std::map<std::string, PatternSummary, std::less<>>;

SummariesById collect_summaries(const Database& database) {
    SummariesById by_id;
    Statement samples(database, std::string(kCountSamples) + "GROUP BY pattern_id");
    while (samples.step()) read_samples(samples, by_id[std::string(samples.text(0))]);
    Statement calibrations(database, std::string(kCountCalibrations) + "GROUP BY pattern_id");
    while (calibrations.step()) read_calibrations(calibrations, by_id[std::string(calibrations.text(0))]);
    Statement failures(database, "SELECT pattern_id, count(*) FROM failure GROUP BY pattern_id");
    while (failures.step()) by_id[std::string(failures.text(0))].failures = failures.count(1);
    return by_id;
}

PatternSummary named(PatternSummary summary, const pattern::NamedPattern& entry) {
    summary.pattern = entry.id;
    summary.edges = entry.pattern.edge_count();
    return summary;
}

/// For each number of edges, the number of patterns.
std::map<int, std::size_t> edge_counts(const Database& database) {
    std::map<int, std::size_t> counts;
    Statement rows(database, "SELECT edges, count(*) FROM pattern GROUP BY edges");
    while (rows.step()) counts[rows.count(0)] = rows.integer(1);
    return counts;
}

}  // namespace

std::size_t Library::pattern_count() const {
    return detail::query_integer(impl_->database, "SELECT count(*) FROM pattern").value_or(0);
}

std::vector<pattern::NamedPattern> Library::patterns() const {
    Statement ids(impl_->database, "SELECT id FROM pattern");
    return impl_->select_patterns(ids);
}

std::vector<pattern::NamedPattern> Library::sample(std::size_t size) const {
    const Transaction snapshot(impl_->database, Transaction::Kind::Read);
    const std::map<int, std::size_t> counts = edge_counts(impl_->database);
    std::vector<int> strata;  // the number of edges of each of patterns(), in their order
    for (const auto& [edges, count] : counts) strata.insert(strata.end(), count, edges);
    const std::vector<std::size_t> chosen = reduction::stratified_sample(strata, size);
    std::vector<pattern::NamedPattern> entries;
    std::size_t first = 0;
    auto next = chosen.begin();
    for (const auto& [edges, count] : counts) {
        std::vector<std::size_t> places;
        for (; next != chosen.end() && *next < first + count; ++next) places.push_back(*next - first);
        if (!places.empty())
            std::ranges::move(impl_->patterns_at(edges, places), std::back_inserter(entries));
        first += count;
    }
    return entries;
}

std::vector<PatternSummary> Library::summaries() const {
    const Transaction snapshot(impl_->database, Transaction::Kind::Read);
    const SummariesById by_id = collect_summaries(impl_->database);
    std::vector<PatternSummary> list;
    for (const pattern::NamedPattern& entry : patterns()) {
        const auto known = by_id.find(entry.id);
        list.push_back(named(known == by_id.end() ? PatternSummary{} : known->second, entry));
    }
    return list;
}

std::vector<PatternSummary> Library::summaries(std::span<const pattern::NamedPattern> patterns) const {
    const Transaction snapshot(impl_->database, Transaction::Kind::Read);
    Statement samples(impl_->database, std::string(kCountSamples) + "WHERE pattern_id = ?");
    Statement calibrations(impl_->database, std::string(kCountCalibrations) + "WHERE pattern_id = ?");
    Statement failures(impl_->database, "SELECT count(*) FROM failure WHERE pattern_id = ?");
    std::vector<PatternSummary> list;
    for (const pattern::NamedPattern& entry : patterns) {
        PatternSummary summary;
        if (samples.bind_all(entry.id).step()) read_samples(samples, summary);
        if (calibrations.bind_all(entry.id).step()) read_calibrations(calibrations, summary);
        if (failures.bind_all(entry.id).step()) summary.failures = failures.count(0);
        list.push_back(named(summary, entry));
    }
    return list;
}

std::vector<pattern::NamedPattern> Library::fitted_patterns() const {
    Statement ids(impl_->database, "SELECT DISTINCT pattern_id FROM calibration_parameter");
    return impl_->select_patterns(ids);
}

std::vector<double> Library::objectives(const CalibrationKey& key) const {
    Statement rows(impl_->database,
                   "SELECT objective FROM calibration WHERE model = ? AND optimizer = ? AND seed = ? "
                   "AND starts = ? AND budget = ? ORDER BY objective");
    rows.bind_all(key.model, key.optimizer, static_cast<std::int64_t>(key.seed), key.starts, key.budget);
    std::vector<double> values;
    while (rows.step()) values.push_back(rows.real(0));
    return values;
}

pattern::NamedPattern Library::find_pattern(std::string_view id) const {
    const pattern::Pattern pattern = pattern::parse_pattern_id(layout(), id);
    pattern::NamedPattern entry{pattern_id(layout(), pattern), pattern};
    impl_->require_pattern(entry.id);
    return entry;
}

std::vector<pattern::NamedPattern> Library::patterns_with_responses() const {
    Statement ids(impl_->database, "SELECT DISTINCT pattern_id FROM response_state");
    return impl_->select_patterns(ids);
}

std::vector<pattern::NamedPattern> Library::patterns_without_responses() const {
    Statement ids(impl_->database, kWithoutResponses);
    ids.bind_all(responses_computation());
    return impl_->select_patterns(ids);
}

bool Library::lacks_responses(std::string_view pattern_id) const {
    Statement ids(impl_->database, std::string(kWithoutResponses) + "AND id = ?");
    return ids.bind_all(responses_computation(), pattern_id).step();
}

std::vector<pattern::NamedPattern> Library::patterns_without_calibration(const CalibrationKey& key) const {
    Statement ids(impl_->database, kWithoutCalibration);
    ids.bind_all(key.model, key.optimizer, static_cast<std::int64_t>(key.seed), key.starts, key.budget,
                 responses_computation(), calibration_computation(key));
    return impl_->select_patterns(ids);
}

bool Library::lacks_calibration(std::string_view pattern_id, const CalibrationKey& key) const {
    Statement ids(impl_->database, std::string(kWithoutCalibration) + "AND id = ?");
    return ids
        .bind_all(key.model, key.optimizer, static_cast<std::int64_t>(key.seed), key.starts, key.budget,
                  responses_computation(), calibration_computation(key), pattern_id)
        .step();
}

}  // namespace fretwork::library
