// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/library/detail/library_impl.hpp>
#include <fretwork/library/detail/pattern_order.hpp>
#include <fretwork/library/detail/rows.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>

#include <algorithm>
#include <cmath>

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

}  // namespace

Library::Impl::Impl(Database opened)
    : database(std::move(opened)),
      layout(pattern::parse_node_layout(stored_json(database, "layout"), database.path().string())),
      setting_json(stored_json(database, "setting")),
      setting(reduction::parse_setting(setting_json, database.path().string())) {}

detail::ResponseShape Library::Impl::shape() const {
    return {&setting, setting.sides * static_cast<int>(layout.interface_nodes().size())};
}

void Library::Impl::read_setting() {
    setting_json = stored_json(database, "setting");
    setting = reduction::parse_setting(setting_json, database.path().string());
}

std::unique_ptr<Transaction> Library::Impl::begin_writing() {
    auto transaction = begin_choosing_setting();
    const std::string stored = stored_json(database, "setting");
    if (stored == setting_json) return transaction;
    const std::string difference =
        reduction::setting_difference(setting, reduction::parse_setting(stored, database.path().string()));
    if (!difference.empty())
        throw base::InputError(database.path().string(), "",
                               "another process has given it another setting meanwhile: " + difference);
    return transaction;
}

std::unique_ptr<Transaction> Library::Impl::begin_choosing_setting() {
    if (database.is_read_only())
        throw base::IoError(database.path().string(), "", "cannot be written: no permission");
    auto transaction = std::make_unique<Transaction>(database, Transaction::Kind::Write);
    if (!writer_recorded) detail::record_writer(database);
    return transaction;
}

void Library::Impl::commit(Transaction& transaction) {
    transaction.commit();
    writer_recorded = true;
}

void Library::Impl::require_pattern(std::string_view id) const {
    Statement present(database, "SELECT 1 FROM pattern WHERE id = ?");
    if (present.bind_all(id).step()) return;
    std::vector<std::string> ids;
    Statement rows(database, "SELECT id FROM pattern ORDER BY id");
    while (rows.step()) ids.emplace_back(rows.text(0));
    const auto near = base::nearest_name(id, ids);
    throw base::InputError(
        database.path().string(), "",
        "has no pattern " + std::string(id) + (near ? "; did you mean " + *near + "?" : ""));
}

pattern::NamedPattern Library::Impl::entry(std::string id) const {
    const pattern::Pattern pattern = base::located(database.path().string(), "pattern",
                                                   [&] { return pattern::parse_pattern_id(layout, id); });
    return {std::move(id), pattern};
}

std::vector<pattern::NamedPattern> Library::Impl::select_patterns(Statement& ids) const {
    std::vector<pattern::NamedPattern> entries;
    while (ids.step()) entries.push_back(entry(std::string(ids.text(0))));
    std::sort(entries.begin(), entries.end(), comes_before);
    return entries;
}

std::vector<pattern::NamedPattern> Library::Impl::patterns_at(int edges,
                                                              std::span<const std::size_t> places) const {
    Statement rows(database, "SELECT id FROM pattern WHERE edges = ?");
    rows.bind_all(edges);
    std::vector<std::string> ids;
    while (rows.step()) ids.emplace_back(rows.text(0));
    std::vector<pattern::NamedPattern> entries;
    auto begin = ids.begin();
    for (const std::size_t place : places) {
        const auto wanted = ids.begin() + place;
        std::nth_element(begin, wanted, ids.end(), detail::id_comes_before);
        entries.push_back(entry(*wanted));
        begin = wanted + 1;
    }
    return entries;
}

void Library::Impl::store_responses(const std::string& pattern,
                                    const std::vector<reduction::Response>& responses) {
    detail::check_responses(database, pattern, responses, shape());
    const auto present = detail::ResponseReader(database, shape()).read(pattern);
    if (present.empty()) {
        detail::insert_responses(database, pattern, responses);
    } else if (!detail::are_equal(present, responses)) {
        throw base::InputError(database.path().string(), "pattern " + pattern,
                               "has other responses than those which are to be stored");
    }
    forget_failure(pattern, responses_computation());
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
            "has another " + calibration_computation(key) + " than the one which is to be stored");
    }
    forget_failure(pattern, calibration_computation(key));
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
        .bind_all(failure.pattern, failure.computation, failure.reason)
        .run();
}

void Library::Impl::forget_failure(const std::string& pattern, const std::string& stage) {
    Statement(database, "DELETE FROM failure WHERE pattern_id = ? AND stage = ?")
        .bind_all(pattern, stage)
        .run();
}

}  // namespace fretwork::library
