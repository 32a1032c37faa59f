// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/library/pattern_query.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/pattern/pattern.hpp>
#include <fretwork/reduction/calibration/calibration.hpp>
#include <fretwork/reduction/response.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fretwork::library {

/// The access to a library's file.
enum class Access {
    ReadOnly,  ///< nothing is stored; at most, the transaction of a killed writer is rolled back
    ReadWrite  ///< data may be stored; the file must exist
};

/// True if `left` comes before `right` in the order of Library::patterns(): by number of edges, then by the
/// edges.
bool comes_before(const pattern::NamedPattern& left, const pattern::NamedPattern& right);

/// The key that distinguishes the calibrations of one pattern.
struct CalibrationKey {
    std::string model;       ///< name of the tile model
    std::string optimizer;   ///< name of the method
    std::uint64_t seed = 0;  ///< seed of the search, below 2^63
    int starts = 0;          ///< number of starts; see reduction::CalibrationOptions
    int budget = 0;          ///< largest cost; see reduction::CalibrationOptions
    friend bool operator==(const CalibrationKey&, const CalibrationKey&) = default;
};
/// The key of a calibration with these options. For a model without parameters, the optimizer is "none" and
/// the numbers are 0.
CalibrationKey calibration_key(const reduction::CalibrationOptions& options,
                               const reduction::TileModel& model);

/// A calibration with the data that libraries add.
struct CalibrationRecord {
    reduction::Calibration calibration;  ///< the fitted model
    int budget = 0;                      ///< largest cost; see reduction::CalibrationOptions
    double seconds = 0.0;                ///< wall time, s; not part of the content
    /// The key under which the calibration is stored.
    [[nodiscard]] CalibrationKey key() const;
};

/// The data to store for one pattern. An empty member leaves the stored data unchanged.
struct PatternData {
    std::string pattern;                          ///< pattern id
    std::vector<reduction::Response> responses;   ///< none, or one for each scenario of the setting
    std::vector<CalibrationRecord> calibrations;  ///< calibrations of any models
    std::vector<std::pair<std::string, double>> properties;  ///< name and value, SI
};

/// A summary of a library's data on one pattern.
struct PatternSummary {
    std::string pattern;  ///< pattern id
    int edges = 0;        ///< number of edges of the pattern
    /// Number of samples of the pattern's responses, scenarios times magnitudes; 0: no responses.
    int samples = 0;
    int converged_samples = 0;  ///< number of converged samples
    int stable_samples = 0;     ///< number of converged samples that are stable
    /// Number of samples that have not converged because their load is above the largest load of the path.
    int limit_load_samples = 0;
    int calibrations = 0;                    ///< number of calibrations
    std::optional<double> best_objective{};  ///< smallest objective among the calibrations
    int failures = 0;                        ///< number of recorded failures
};

/// A recorded failure of a computation on one pattern. A failure does not stop the computations on other
/// patterns.
struct Failure {
    std::string pattern;  ///< pattern id
    /// The failed computation: responses_computation(), or calibration_computation(key).
    std::string computation;
    std::string reason;  ///< one line
    friend bool operator==(const Failure&, const Failure&) = default;
};
/// The name of the computation of responses, for Failure::computation.
std::string responses_computation();
/// The name of the computation of a calibration, for Failure::computation.
std::string calibration_computation(const CalibrationKey& key);

/// The pattern library: one setting, patterns of one node layout, their responses, calibrations and
/// properties, in one SQLite file (tables and columns: schema.md).
///
/// Every writing call is one transaction: if the process is killed or the disk is full, the file is as before
/// or as after the call. A stored response or calibration never changes: to store an equal value again does
/// nothing, and to store a different value throws InputError. Only one thread at a time may use a Library.
/// Several processes may have one file open, also on a network disk (rollback journal and file locks).
///
/// Reading calls throw InputError if the file is damaged or, unless stated otherwise, an id is unknown. All
/// calls throw IoError if the file cannot be used (disk full, no permission, locked by another process for
/// longer than ten seconds).
class Library {
  public:
    /// Create a library in a new or an empty file. Throws InputError if the setting is invalid or the file
    /// exists and is not empty, IoError if it cannot be written.
    static Library create(const std::filesystem::path& path, const pattern::NodeLayout& layout,
                          const reduction::Setting& setting);
    /// Open a file. A file of schema 3 is converted to the present schema if it is opened for writing, and is
    /// only read otherwise. Throws InputError if the file is missing, is not a library, or has another
    /// schema.
    static Library open(const std::filesystem::path& path, Access access = Access::ReadOnly);
    /// Open an existing file for writing and check its layout and setting, or create a new file with these
    /// patterns. If not all patterns can be written, no new file is left. An empty file becomes a library
    /// without patterns. Throws InputError if the setting is invalid, or if the file has another layout or
    /// setting. Throws Stopped.
    static Library open_or_create(const std::filesystem::path& path, const pattern::NodeLayout& layout,
                                  const reduction::Setting& setting,
                                  std::span<const pattern::Pattern> patterns = {},
                                  const base::Control& control = {});
    Library(Library&&) noexcept;
    Library& operator=(Library&&) noexcept;
    ~Library();

    /// The path of the library's file.
    [[nodiscard]] const std::filesystem::path& path() const;
    /// The node layout of all patterns.
    [[nodiscard]] const pattern::NodeLayout& layout() const;
    /// The material, section and scenarios of all responses.
    [[nodiscard]] const reduction::Setting& setting() const;
    /// Check the setting, except strength and section shape. Throws InputError that names the first
    /// difference.
    void check_setting(const reduction::Setting& wanted) const;
    /// Check that the library has this layout. Throws InputError that states the difference.
    void check_layout(const pattern::NodeLayout& wanted) const;
    /// Replace the library's setting by `wanted` if nothing has been computed with the old setting. Otherwise
    /// check the setting as check_setting() does, and replace only the strength and the section's shape, if
    /// `wanted` has them. Computed values do not depend on these two. Throws InputError if `wanted` is
    /// invalid.
    void adopt_setting(const reduction::Setting& wanted);

    /// Add patterns that the library lacks. Returns the number of patterns added. Throws Stopped; then no
    /// pattern is added.
    std::size_t add_patterns(std::span<const pattern::Pattern> patterns, const base::Control& control = {});
    /// The number of patterns.
    [[nodiscard]] std::size_t pattern_count() const;
    /// All patterns, sorted by number of edges and then by their edges.
    [[nodiscard]] std::vector<pattern::NamedPattern> patterns() const;
    /// Up to `size` of patterns(), spread over the numbers of edges as by reduction::stratified_sample().
    /// Only the chosen ids are parsed.
    [[nodiscard]] std::vector<pattern::NamedPattern> sample(std::size_t size) const;
    /// One summary for each pattern, in the order of patterns().
    [[nodiscard]] std::vector<PatternSummary> summaries() const;
    /// One summary for each of `patterns`, in the same order; without data if the library lacks the pattern.
    [[nodiscard]] std::vector<PatternSummary> summaries(
        std::span<const pattern::NamedPattern> patterns) const;
    /// The patterns with a calibration of a model that has parameters, in the order of patterns().
    [[nodiscard]] std::vector<pattern::NamedPattern> fitted_patterns() const;
    /// Find patterns by their behaviour. Only patterns with properties are found; fill() computes properties.
    /// Throws InputError if an expression of the query is invalid. The error names its source ("where",
    /// "sort", or "where or sort" if SQLite does not say which) and, if it is known, the place.
    [[nodiscard]] FoundPatterns find(const PatternQuery& query) const;
    /// The objectives of all calibrations of a key, ascending.
    [[nodiscard]] std::vector<double> objectives(const CalibrationKey& key) const;
    /// The pattern with an id, in any form that pattern::parse_pattern_id accepts. Throws InputError that
    /// suggests the nearest id.
    [[nodiscard]] pattern::NamedPattern find_pattern(std::string_view id) const;

    /// The patterns, in the order of patterns(), whose responses are stored.
    [[nodiscard]] std::vector<pattern::NamedPattern> patterns_with_responses() const;
    /// The patterns, in the order of patterns(), whose responses are neither stored nor recorded as failed.
    [[nodiscard]] std::vector<pattern::NamedPattern> patterns_without_responses() const;
    /// The patterns, in the order of patterns(), for which a calibration of this key is neither stored nor
    /// recorded as failed. Patterns with failed responses are left out.
    [[nodiscard]] std::vector<pattern::NamedPattern> patterns_without_calibration(
        const CalibrationKey& key) const;
    /// True if the pattern is among patterns_without_responses(); false if it is not in the library.
    [[nodiscard]] bool lacks_responses(std::string_view pattern_id) const;
    /// True if the pattern is among patterns_without_calibration(key); false if it is not in the library.
    [[nodiscard]] bool lacks_calibration(std::string_view pattern_id, const CalibrationKey& key) const;

    /// Store a batch in one transaction, whole or not at all. A recorded failure of a computation is deleted
    /// if the batch has the result of that computation. A property replaces the stored one. Throws InputError
    /// (unknown pattern or scenario, wrong number of samples, a response or calibration that differs from the
    /// stored one), NumericalError (a value is not finite).
    void store(std::span<const PatternData> batch, std::span<const Failure> failures = {});
    /// All recorded failures.
    [[nodiscard]] std::vector<Failure> failures() const;
    /// Delete all recorded failures, so that fill() tries the failed computations again.
    void forget_failures();

    /// The responses of a pattern in the order of the setting's scenarios; empty if none are stored.
    [[nodiscard]] std::vector<reduction::Response> responses(std::string_view pattern_id) const;
    /// The responses of each of `patterns`, read in one transaction; empty for a pattern that has none or is
    /// not in the library.
    [[nodiscard]] std::vector<std::vector<reduction::Response>> responses(
        std::span<const pattern::NamedPattern> patterns) const;
    /// All calibrations of a pattern, sorted by key.
    [[nodiscard]] std::vector<CalibrationRecord> calibrations(std::string_view pattern_id) const;
    /// The calibration with the smallest objective for each tile model of a pattern, sorted by the model's
    /// name.
    [[nodiscard]] std::vector<reduction::Calibration> best_calibrations(std::string_view pattern_id) const;
    /// The calibration with the smallest objective among the models of a pattern that have parameters;
    /// nothing if there is none.
    [[nodiscard]] std::optional<reduction::Calibration> best_fit(std::string_view pattern_id) const;
    /// The properties of a pattern, sorted by name.
    [[nodiscard]] std::vector<std::pair<std::string, double>> properties(std::string_view pattern_id) const;

    /// A SHA-256 (64 hexadecimal digits) of the content: layout, setting, patterns, responses, calibrations,
    /// properties, failures. The hash does not depend on the setting's strength and section shape, on the
    /// order of storing, on times, hosts and program versions, or on SQLite's layout of the file.
    [[nodiscard]] std::string content_hash() const;
    /// True if `hash` is the content hash that this or an older version of the program computes.
    [[nodiscard]] bool has_content(std::string_view hash) const;
    /// Write the content into a folder, which is created if missing: layout.json, setting.json, and one CSV
    /// file for each other table of content and for the view `behaviour`. Rows are sorted; times and hosts
    /// are left out, so equal contents give equal files (except that setting.json has the strength and the
    /// section shape). Throws Stopped; files that are already written remain.
    void export_csv(const std::filesystem::path& folder, const base::Control& control = {}) const;

  private:
    struct Impl;
    explicit Library(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::library
