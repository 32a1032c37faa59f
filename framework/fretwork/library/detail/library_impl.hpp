// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/detail/database.hpp>
#include <fretwork/library/detail/rows.hpp>
#include <fretwork/library/library.hpp>

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fretwork::library {

/// An open library. Call store() within a transaction of begin_writing().
struct Library::Impl {
    explicit Impl(detail::Database opened);

    [[nodiscard]] detail::ResponseShape shape() const;

    /// Read the setting again, because another process may have changed it since the file was opened.
    void read_setting();
    /// Begin a write transaction. The first transaction also records the writer's provenance. Throws IoError
    /// if the file cannot be written. Throws InputError if another process has changed the setting of the
    /// file, because results for the old setting do not belong there.
    [[nodiscard]] std::unique_ptr<detail::Transaction> begin_writing();
    /// Begin a write transaction that may change the setting.
    [[nodiscard]] std::unique_ptr<detail::Transaction> begin_choosing_setting();
    void commit(detail::Transaction& transaction);
    /// Replace the stored setting, but not the rows of the table `scenario`, and commit the transaction.
    void replace_setting(detail::Transaction& transaction, const reduction::Setting& wanted);

    /// Throws InputError that suggests the nearest id if the library has no such pattern.
    void require_pattern(std::string_view id) const;
    /// The pattern of a stored id. Throws InputError that names the file if the id is invalid.
    [[nodiscard]] pattern::NamedPattern entry(std::string id) const;
    /// The patterns whose ids a statement gives, in the order of Library::patterns().
    [[nodiscard]] std::vector<pattern::NamedPattern> select_patterns(detail::Statement& ids) const;
    /// The patterns at these places (ascending) among the patterns with this number of edges.
    [[nodiscard]] std::vector<pattern::NamedPattern> patterns_at(int edges,
                                                                 std::span<const std::size_t> places) const;

    void store(const PatternData& data);
    void store(const Failure& failure);

    detail::Database database;
    pattern::NodeLayout layout;
    std::string setting_json;  ///< text of `setting` in the file
    reduction::Setting setting;
    bool writer_recorded = false;

  private:
    void store_responses(const std::string& pattern, const std::vector<reduction::Response>& responses);
    void store_calibration(const std::string& pattern, const CalibrationRecord& record);
    void store_property(const std::string& pattern, const std::pair<std::string, double>& property);
    void forget_failure(const std::string& pattern, const std::string& stage);
};

}  // namespace fretwork::library
