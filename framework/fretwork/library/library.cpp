// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/library/detail/content.hpp>
#include <fretwork/library/detail/draft.hpp>
#include <fretwork/library/detail/library_impl.hpp>
#include <fretwork/library/detail/rows.hpp>
#include <fretwork/library/detail/schema.hpp>
#include <fretwork/library/detail/schema3.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/pattern/mirror.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>

#include <map>

namespace fretwork::library {
namespace {

using detail::Database;
using detail::Statement;
using detail::Transaction;

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

enum class Initialized { Yes, WasNotEmpty };

/// Create all tables of a new library in one transaction, unless there are tables already.
Initialized initialize(Database& database, const pattern::NodeLayout& layout,
                       const reduction::Setting& setting) {
    Transaction transaction(database, Transaction::Kind::Write);
    if (!detail::is_empty(database)) return Initialized::WasNotEmpty;
    detail::create_schema(database);
    insert_json(database, "INSERT INTO layout VALUES (?, ?)", layout.name(),
                pattern::node_layout_text(layout));
    Statement(database, "INSERT INTO setting VALUES (1, ?)").bind_all(reduction::setting_text(setting)).run();
    insert_scenarios(database, setting);
    transaction.commit();
    return Initialized::Yes;
}

/// Make the tables in an empty file. If several processes find the file empty, one of them makes the tables.
void fill_if_empty(const std::filesystem::path& path, const pattern::NodeLayout& layout,
                   const reduction::Setting& setting) {
    Database database(path, Database::Mode::Write);
    if (detail::is_empty(database)) (void)initialize(database, layout, setting);
}

/// Make a draft of the file, and move it to the path. False, without a change, if a file exists at the path
/// by now.
template <class Make>
bool make_file(const std::filesystem::path& path, Make&& make) {
    const detail::Draft draft(path);
    draft.fill([&] { make(draft.path()); });
    return draft.move_into_place();
}

void make_tables(const std::filesystem::path& path, const pattern::NodeLayout& layout,
                 const reduction::Setting& setting) {
    Database database(path, Database::Mode::CreateOrWrite);
    (void)initialize(database, layout, setting);
}

}  // namespace

CalibrationKey calibration_key(const reduction::CalibrationOptions& options,
                               const reduction::TileModel& model) {
    if (model.parameters.empty()) return {.model = model.name, .optimizer = "none"};
    return {model.name, options.optimizer, options.seed, options.starts, options.budget};
}

CalibrationKey CalibrationRecord::key() const {
    return {calibration.model, calibration.optimizer, calibration.seed, calibration.starts, budget};
}

std::string responses_computation() {
    return "responses";
}

std::string calibration_computation(const CalibrationKey& key) {
    return "calibration " + key.model + " " + key.optimizer + " seed " + std::to_string(key.seed) +
           " starts " + std::to_string(key.starts) + " budget " + std::to_string(key.budget);
}

Library::Library(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Library::Library(Library&&) noexcept = default;
Library& Library::operator=(Library&&) noexcept = default;
Library::~Library() = default;

Library Library::create(const std::filesystem::path& path, const pattern::NodeLayout& layout,
                        const reduction::Setting& setting) {
    setting.validate();
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) {
        Database database(path, Database::Mode::CreateOrWrite);
        if (initialize(database, layout, setting) == Initialized::WasNotEmpty)
            throw base::InputError(path.string(), "", "exists already");
        return Library(std::make_unique<Impl>(std::move(database)));
    }
    if (!make_file(path, [&](const auto& draft) { make_tables(draft, layout, setting); }))
        throw base::IoError(path.string(), "", "another process has made it meanwhile");
    return open(path, Access::ReadWrite);
}

Library Library::open(const std::filesystem::path& path, Access access) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored))
        throw base::InputError(path.string(), "", "cannot be read: no such file");
    if (std::filesystem::is_directory(path, ignored))
        throw base::InputError(path.string(), "", "is a folder, where a pattern library is needed");
    Database database(path, access == Access::ReadOnly ? Database::Mode::Read : Database::Mode::Write);
    detail::check_schema(database);
    if (detail::schema_version(database) != detail::kSchemaVersion) {
        if (access == Access::ReadWrite && !database.is_read_only()) {
            detail::migrate_schema3(database);
        } else {
            detail::view_schema3(database);
        }
    }
    return Library(std::make_unique<Impl>(std::move(database)));
}

Library Library::open_or_create(const std::filesystem::path& path, const pattern::NodeLayout& layout,
                                const reduction::Setting& setting, std::span<const pattern::Pattern> patterns,
                                const base::Control& control) {
    setting.validate();
    // An existing file may be empty. Another process may make the file, or the tables in it, at the same
    // time.
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) {
        (void)make_file(path, [&](const auto& draft) {
            make_tables(draft, layout, setting);
            if (!patterns.empty()) open(draft, Access::ReadWrite).add_patterns(patterns, control);
        });
    } else if (std::filesystem::is_regular_file(path, ignored)) {
        fill_if_empty(path, layout, setting);
    }
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

void Library::Impl::replace_setting(detail::Transaction& transaction, const reduction::Setting& wanted) {
    std::string json = reduction::setting_text(wanted);
    Statement(database, "UPDATE setting SET json = ?").bind_all(json).run();
    commit(transaction);
    setting_json = std::move(json);
    setting = wanted;
}

void Library::adopt_setting(const reduction::Setting& wanted) {
    wanted.validate();
    const auto transaction = impl_->begin_choosing_setting();
    impl_->read_setting();
    if (detail::query_integer(impl_->database,
                              "SELECT 1 FROM response_state UNION SELECT 1 FROM calibration "
                              "UNION SELECT 1 FROM property UNION SELECT 1 FROM failure")) {
        check_setting(wanted);
        reduction::Setting next = impl_->setting;
        if (wanted.strength) next.strength = wanted.strength;
        if (wanted.section.shape) next.section.shape = wanted.section.shape;
        if (next != impl_->setting) impl_->replace_setting(*transaction, next);
        return;
    }
    Statement(impl_->database, "DELETE FROM scenario").run();
    insert_scenarios(impl_->database, wanted);
    impl_->replace_setting(*transaction, wanted);
}

void Library::check_layout(const pattern::NodeLayout& wanted) const {
    if (wanted == layout()) return;
    const std::string difference = wanted.name() == layout().name()
                                       ? "its layout of the name " + layout().name() + " has other nodes"
                                       : "its layout is " + layout().name() + ", not " + wanted.name();
    throw base::InputError(path().string(), "", "is of another layout: " + difference);
}

std::size_t Library::add_patterns(std::span<const pattern::Pattern> patterns, const base::Control& control) {
    const auto transaction = impl_->begin_writing();
    Statement insert(impl_->database, "INSERT OR IGNORE INTO pattern VALUES (?, ?, ?, nullif(?, ''))");
    const pattern::Mirror mirror(layout());
    std::size_t added = 0;
    for (const pattern::Pattern& pattern : patterns) {
        control.check();
        const auto image = mirror.image(pattern);
        insert
            .bind_all(pattern_id(layout(), pattern), layout().name(), pattern.edge_count(),
                      image ? pattern_id(layout(), *image) : "")
            .run();
        added += impl_->database.changed_rows();
    }
    if (added > 0) impl_->commit(*transaction);
    return added;
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
    return detail::ResponseReader(impl_->database, impl_->shape()).read(pattern_id);
}

std::vector<std::vector<reduction::Response>> Library::responses(
    std::span<const pattern::NamedPattern> patterns) const {
    const Transaction snapshot(impl_->database, Transaction::Kind::Read);
    detail::ResponseReader reader(impl_->database, impl_->shape());
    std::vector<std::vector<reduction::Response>> found;
    found.reserve(patterns.size());
    for (const pattern::NamedPattern& entry : patterns) found.push_back(reader.read(entry.id));
    return found;
}

std::vector<CalibrationRecord> Library::calibrations(std::string_view pattern_id) const {
    impl_->require_pattern(pattern_id);
    return detail::read_calibrations(impl_->database, pattern_id, setting());
}

std::vector<reduction::Calibration> Library::best_calibrations(std::string_view pattern_id) const {
    std::map<std::string, reduction::Calibration> best;
    for (CalibrationRecord& record : calibrations(pattern_id)) {
        const std::string model = record.calibration.model;
        const auto [entry, is_first] = best.try_emplace(model, record.calibration);
        if (!is_first && record.calibration.objective < entry->second.objective)
            entry->second = std::move(record.calibration);
    }
    std::vector<reduction::Calibration> list;
    for (auto& [model, calibration] : best) list.push_back(std::move(calibration));
    return list;
}

std::optional<reduction::Calibration> Library::best_fit(std::string_view pattern_id) const {
    std::optional<reduction::Calibration> best;
    for (reduction::Calibration& calibration : best_calibrations(pattern_id)) {
        if (calibration.parameters.empty()) continue;
        if (!best || calibration.objective < best->objective) best = std::move(calibration);
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

bool Library::has_content(std::string_view hash) const {
    return hash == content_hash() || hash == detail::schema3_content_hash(impl_->database);
}

void Library::export_csv(const std::filesystem::path& folder, const base::Control& control) const {
    control.check();
    const detail::StopGuard stop_guard(impl_->database, control);
    detail::export_csv(impl_->database, folder);
}

}  // namespace fretwork::library
