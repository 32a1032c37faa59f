// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/library/detail/calibration_rows.hpp>
#include <fretwork/library/detail/content.hpp>
#include <fretwork/library/detail/database.hpp>
#include <fretwork/library/detail/provenance_rows.hpp>
#include <fretwork/library/detail/response_rows.hpp>
#include <fretwork/library/detail/schema.hpp>
#include <fretwork/library/library.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace fretwork::library {
namespace {

using detail::Database;
using detail::Statement;
using detail::Transaction;

std::string stored_json(const Database& database, const std::string& table) {
    Statement row(database, "SELECT json FROM " + table);
    if (!row.step()) throw base::InputError(database.path().string(), table, "is missing");
    return std::string(row.text(0));
}

void insert_json(const Database& database, const std::string& sql, std::string_view key,
                 std::string_view json) {
    Statement(database, sql).bind_all(key, json).run();
}

void insert_scenarios(const Database& database, const reduction::Setting& setting) {
    Statement insert(database, "INSERT INTO scenario VALUES (?, ?, ?, ?, ?)");
    int position = 0;
    for (const reduction::Scenario& scenario : setting.scenarios) {
        insert
            .bind_all(scenario.name, position++, scenario.weight, scenario.max_magnitude,
                      scenario.description)
            .run();
    }
}

/// Make the tables of a new library, all of them or none.
void initialize(Database& database, const pattern::NodeLayout& layout, const reduction::Setting& setting) {
    Transaction transaction(database, Transaction::Kind::Write);
    if (!detail::is_empty(database)) throw base::InputError(database.path().string(), "", "exists already");
    detail::create_schema(database);
    insert_json(database, "INSERT INTO layout VALUES (?, ?)", layout.name(),
                pattern::node_layout_text(layout));
    Statement(database, "INSERT INTO setting VALUES (1, ?)").bind_all(reduction::setting_text(setting)).run();
    insert_scenarios(database, setting);
    transaction.commit();
}

bool comes_before(const PatternEntry& left, const PatternEntry& right) {
    const int left_count = left.pattern.edge_count();
    const int right_count = right.pattern.edge_count();
    if (left_count != right_count) return left_count < right_count;
    return left.pattern.edges() < right.pattern.edges();
}

using SummariesById = std::map<std::string, PatternSummary, std::less<>>;

void collect_responses(const Database& database, SummariesById& by_id) {
    Statement rows(
        database,
        "SELECT pattern_id, count(*), sum(converged), sum(converged AND stable) FROM response_state "
        "GROUP BY pattern_id");
    while (rows.step()) {
        PatternSummary& summary = by_id[std::string(rows.text(0))];
        summary.samples = static_cast<int>(rows.integer(1));
        summary.converged_samples = static_cast<int>(rows.integer(2));
        summary.stable_samples = static_cast<int>(rows.integer(3));
    }
}

void collect_calibrations(const Database& database, SummariesById& by_id) {
    Statement rows(database,
                   "SELECT pattern_id, count(*), min(objective) FROM calibration GROUP BY pattern_id");
    while (rows.step()) {
        PatternSummary& summary = by_id[std::string(rows.text(0))];
        summary.calibrations = static_cast<int>(rows.integer(1));
        summary.best_objective = rows.real(2);
    }
}

}  // namespace

CalibrationKey calibration_key(const reduction::CalibrationOptions& options, std::string model) {
    return {std::move(model), options.optimizer, options.seed, options.starts, options.budget};
}

CalibrationKey CalibrationRecord::key() const {
    return {calibration.model, calibration.optimizer, calibration.seed, calibration.starts, budget};
}

std::string responses_stage() {
    return "responses";
}

std::string calibration_stage(const CalibrationKey& key) {
    return "calibration " + key.model + " " + key.optimizer + " seed " + std::to_string(key.seed) +
           " starts " + std::to_string(key.starts) + " budget " + std::to_string(key.budget);
}

struct Library::Impl {
    explicit Impl(Database opened)
        : database(std::move(opened)),
          layout(pattern::parse_node_layout(stored_json(database, "layout"), database.path().string())),
          setting(reduction::parse_setting(stored_json(database, "setting"), database.path().string())) {}

    [[nodiscard]] detail::ResponseShape shape() const {
        return {&setting, setting.sides * static_cast<int>(layout.interface_nodes().size())};
    }

    /// Begin to write; the first time, say who does.
    [[nodiscard]] std::unique_ptr<Transaction> begin_writing() {
        if (database.is_read_only())
            throw base::IoError(database.path().string() + ": cannot be written: no permission");
        auto transaction = std::make_unique<Transaction>(database, Transaction::Kind::Write);
        if (!session_recorded) detail::record_session(database);
        return transaction;
    }
    void commit(Transaction& transaction) {
        transaction.commit();
        session_recorded = true;
    }

    [[nodiscard]] bool has_pattern(std::string_view id) const {
        Statement row(database, "SELECT 1 FROM pattern WHERE id = ?");
        return row.bind_all(id).step();
    }
    void require_pattern(std::string_view id) const;
    [[nodiscard]] std::vector<PatternEntry> select_patterns(Statement& ids) const;

    void store(const PatternData& data);
    void store_responses(const std::string& pattern, const std::vector<reduction::Response>& responses);
    void store_calibration(const std::string& pattern, const CalibrationRecord& record);
    void store_property(const std::string& pattern, const std::pair<std::string, double>& property);
    void store(const Failure& failure);
    void forget_failure(const std::string& pattern, const std::string& stage);

    Database database;
    pattern::NodeLayout layout;
    reduction::Setting setting;
    bool session_recorded = false;
};

void Library::Impl::require_pattern(std::string_view id) const {
    if (has_pattern(id)) return;
    std::vector<std::string> ids;
    Statement rows(database, "SELECT id FROM pattern ORDER BY id");
    while (rows.step()) ids.emplace_back(rows.text(0));
    const auto near = base::nearest_name(id, ids);
    throw base::InputError(
        database.path().string(), "",
        "has no pattern " + std::string(id) + (near ? "; did you mean " + *near + "?" : ""));
}

std::vector<PatternEntry> Library::Impl::select_patterns(Statement& ids) const {
    std::vector<PatternEntry> entries;
    while (ids.step()) {
        const std::string id(ids.text(0));
        entries.push_back({id, pattern::parse_pattern_id(layout, id)});
    }
    std::sort(entries.begin(), entries.end(), comes_before);
    return entries;
}

void Library::Impl::store_responses(const std::string& pattern,
                                    const std::vector<reduction::Response>& responses) {
    detail::check_responses(database, pattern, responses, shape());
    const auto present = detail::read_responses(database, pattern, shape());
    if (present.empty()) {
        detail::insert_responses(database, pattern, responses);
    } else if (!detail::are_equal(present, responses)) {
        throw base::InputError(database.path().string(), "pattern " + pattern,
                               "has other responses than those which are to be stored");
    }
    forget_failure(pattern, responses_stage());
}

void Library::Impl::store_calibration(const std::string& pattern, const CalibrationRecord& record) {
    detail::check_calibration(database, pattern, record, setting);
    const auto present = detail::read_calibrations(database, pattern, setting);
    const CalibrationKey key = record.key();
    const auto same = std::ranges::find_if(present, [&](const auto& other) { return other.key() == key; });
    if (same == present.end()) {
        detail::insert_calibration(database, pattern, record, setting);
    } else if (!detail::are_equal(*same, record)) {
        throw base::InputError(
            database.path().string(), "pattern " + pattern,
            "has another " + calibration_stage(key) + " than the one which is to be stored");
    }
    forget_failure(pattern, calibration_stage(key));
}

void Library::Impl::store_property(const std::string& pattern,
                                   const std::pair<std::string, double>& property) {
    if (!std::isfinite(property.second)) {
        throw base::NumericalError(database.path().string() + ": property " + property.first + " of " +
                                   pattern + " is not finite");
    }
    Statement(database, "INSERT OR REPLACE INTO property VALUES (?, ?, ?)")
        .bind_all(pattern, property.first, property.second)
        .run();
}

void Library::Impl::store(const PatternData& data) {
    require_pattern(data.pattern);
    if (!data.responses.empty()) store_responses(data.pattern, data.responses);
    for (const CalibrationRecord& record : data.calibrations) store_calibration(data.pattern, record);
    for (const auto& property : data.properties) store_property(data.pattern, property);
}

void Library::Impl::store(const Failure& failure) {
    require_pattern(failure.pattern);
    Statement(database, "INSERT OR REPLACE INTO failure VALUES (?, ?, ?)")
        .bind_all(failure.pattern, failure.stage, failure.reason)
        .run();
}

void Library::Impl::forget_failure(const std::string& pattern, const std::string& stage) {
    Statement(database, "DELETE FROM failure WHERE pattern_id = ? AND stage = ?")
        .bind_all(pattern, stage)
        .run();
}

Library::Library(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Library::Library(Library&&) noexcept = default;
Library& Library::operator=(Library&&) noexcept = default;
Library::~Library() = default;

Library Library::create(const std::filesystem::path& path, const pattern::NodeLayout& layout,
                        const reduction::Setting& setting) {
    Database database(path, Database::Mode::CreateOrWrite);
    try {
        initialize(database, layout, setting);
    } catch (const base::IoError&) {
        std::error_code ignored;
        if (std::filesystem::file_size(path, ignored) == 0) std::filesystem::remove(path, ignored);
        throw;
    }
    return Library(std::make_unique<Impl>(std::move(database)));
}

Library Library::open(const std::filesystem::path& path, Access access) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
        throw base::InputError(path.string(), "", "cannot be read: no such file");
    if (std::filesystem::is_directory(path, ignored))
        throw base::InputError(path.string(), "", "is a folder, where a pattern library is needed");
    Database database(path, access == Access::ReadOnly ? Database::Mode::Read : Database::Mode::Write);
    detail::check_schema(database);
    return Library(std::make_unique<Impl>(std::move(database)));
}

Library Library::open_or_create(const std::filesystem::path& path, const pattern::NodeLayout& layout,
                                const reduction::Setting& setting) {
    // A process that was killed while it made the file has left an empty one.
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored) || (std::filesystem::is_regular_file(path, ignored) &&
                                                    detail::is_empty(Database(path, Database::Mode::Write))))
        return create(path, layout, setting);
    Library library = open(path, Access::ReadWrite);
    library.check_layout(layout);
    library.check_setting(setting);
    return library;
}

const std::filesystem::path& Library::path() const {
    return impl_->database.path();
}
const pattern::NodeLayout& Library::layout() const {
    return impl_->layout;
}
const reduction::Setting& Library::setting() const {
    return impl_->setting;
}

void Library::check_setting(const reduction::Setting& wanted) const {
    const std::string difference = reduction::setting_difference(wanted, impl_->setting);
    if (!difference.empty())
        throw base::InputError(path().string(), "", "is of another setting: " + difference);
}

void Library::adopt_setting(const reduction::Setting& wanted) {
    const auto transaction = impl_->begin_writing();
    if (detail::query_integer(impl_->database,
                              "SELECT 1 FROM response_state UNION SELECT 1 FROM calibration "
                              "UNION SELECT 1 FROM property UNION SELECT 1 FROM failure")) {
        check_setting(wanted);
        return;
    }
    Statement(impl_->database, "DELETE FROM scenario").run();
    Statement(impl_->database, "UPDATE setting SET json = ?").bind_all(reduction::setting_text(wanted)).run();
    insert_scenarios(impl_->database, wanted);
    impl_->commit(*transaction);
    impl_->setting = wanted;
}

void Library::check_layout(const pattern::NodeLayout& wanted) const {
    if (pattern::node_layout_text(wanted) == pattern::node_layout_text(layout())) return;
    const std::string difference = wanted.name() == layout().name()
                                       ? "its layout of the name " + layout().name() + " has other nodes"
                                       : "its layout is " + layout().name() + ", not " + wanted.name();
    throw base::InputError(path().string(), "", "is of another layout: " + difference);
}

std::size_t Library::add_patterns(std::span<const pattern::Pattern> patterns) {
    const auto transaction = impl_->begin_writing();
    Statement insert(impl_->database, "INSERT OR IGNORE INTO pattern VALUES (?, ?, ?)");
    std::size_t added = 0;
    for (const pattern::Pattern& pattern : patterns) {
        insert.bind_all(pattern_id(layout(), pattern), layout().name(), pattern.edge_count()).run();
        added += static_cast<std::size_t>(impl_->database.changed_rows());
    }
    if (added > 0) impl_->commit(*transaction);
    return added;
}

std::size_t Library::pattern_count() const {
    return static_cast<std::size_t>(
        detail::query_integer(impl_->database, "SELECT count(*) FROM pattern").value_or(0));
}

std::vector<PatternEntry> Library::patterns() const {
    Statement ids(impl_->database, "SELECT id FROM pattern");
    return impl_->select_patterns(ids);
}

std::vector<PatternSummary> Library::summaries() const {
    const Transaction snapshot(impl_->database, Transaction::Kind::Read);
    SummariesById by_id;
    collect_responses(impl_->database, by_id);
    collect_calibrations(impl_->database, by_id);
    for (const Failure& failure : failures()) ++by_id[failure.pattern].failures;
    std::vector<PatternSummary> list;
    for (const PatternEntry& entry : patterns()) {
        list.push_back(by_id[entry.id]);
        list.back().pattern = entry.id;
        list.back().edges = entry.pattern.edge_count();
    }
    return list;
}

PatternEntry Library::find_pattern(std::string_view id) const {
    const pattern::Pattern pattern = pattern::parse_pattern_id(layout(), id);
    PatternEntry entry{pattern_id(layout(), pattern), pattern};
    impl_->require_pattern(entry.id);
    return entry;
}

std::vector<PatternEntry> Library::patterns_without_responses() const {
    Statement ids(impl_->database,
                  "SELECT id FROM pattern "
                  "WHERE NOT EXISTS (SELECT 1 FROM response_state WHERE pattern_id = id) "
                  "AND NOT EXISTS (SELECT 1 FROM failure WHERE pattern_id = id AND stage = ?)");
    ids.bind_all(responses_stage());
    return impl_->select_patterns(ids);
}

std::vector<PatternEntry> Library::patterns_without_calibration(const CalibrationKey& key) const {
    Statement ids(impl_->database,
                  "SELECT id FROM pattern "
                  "WHERE NOT EXISTS (SELECT 1 FROM calibration WHERE pattern_id = id AND model = ? "
                  "AND optimizer = ? AND seed = ? AND starts = ? AND budget = ?) "
                  "AND NOT EXISTS (SELECT 1 FROM failure WHERE pattern_id = id AND stage IN (?, ?))");
    ids.bind_all(key.model, key.optimizer, static_cast<std::int64_t>(key.seed), key.starts, key.budget,
                 responses_stage(), calibration_stage(key));
    return impl_->select_patterns(ids);
}

void Library::store(std::span<const PatternData> batch, std::span<const Failure> failures) {
    const auto transaction = impl_->begin_writing();
    for (const PatternData& data : batch) impl_->store(data);
    for (const Failure& failure : failures) impl_->store(failure);
    impl_->commit(*transaction);
}

std::vector<Failure> Library::failures() const {
    Statement rows(impl_->database,
                   "SELECT pattern_id, stage, reason FROM failure ORDER BY pattern_id, stage");
    std::vector<Failure> list;
    while (rows.step())
        list.push_back({std::string(rows.text(0)), std::string(rows.text(1)), std::string(rows.text(2))});
    return list;
}

void Library::forget_failures() {
    const auto transaction = impl_->begin_writing();
    impl_->database.execute("DELETE FROM failure");
    impl_->commit(*transaction);
}

std::vector<reduction::Response> Library::responses(std::string_view pattern_id) const {
    impl_->require_pattern(pattern_id);
    return detail::read_responses(impl_->database, pattern_id, impl_->shape());
}

std::vector<CalibrationRecord> Library::calibrations(std::string_view pattern_id) const {
    impl_->require_pattern(pattern_id);
    return detail::read_calibrations(impl_->database, pattern_id, setting());
}

std::optional<CalibrationRecord> Library::best_calibration(std::string_view pattern_id,
                                                           std::string_view model) const {
    std::optional<CalibrationRecord> best;
    for (CalibrationRecord& record : calibrations(pattern_id)) {
        if (record.calibration.model != model) continue;
        if (!best || record.calibration.objective < best->calibration.objective) best = std::move(record);
    }
    return best;
}

std::vector<std::pair<std::string, double>> Library::properties(std::string_view pattern_id) const {
    impl_->require_pattern(pattern_id);
    Statement rows(impl_->database, "SELECT name, value FROM property WHERE pattern_id = ? ORDER BY name");
    rows.bind_all(pattern_id);
    std::vector<std::pair<std::string, double>> list;
    while (rows.step()) list.emplace_back(std::string(rows.text(0)), rows.real(1));
    return list;
}

std::string Library::content_hash() const {
    return detail::content_hash(impl_->database);
}

void Library::export_csv(const std::filesystem::path& folder) const {
    detail::export_csv(impl_->database, folder);
}

}  // namespace fretwork::library
