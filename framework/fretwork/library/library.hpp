// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
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

enum class Access { ReadOnly, ReadWrite };

/// A pattern of a library.
/// The order of Library::patterns(): by number of edges, then by the edges.
bool comes_before(const pattern::NamedPattern& left, const pattern::NamedPattern& right);

/// The key of a calibration among those of one pattern.
struct CalibrationKey {
    std::string model;
    std::string optimizer;
    std::uint64_t seed = 0;  ///< below 2^63
    int starts = 0;
    int budget = 0;  ///< evaluations at most
    friend bool operator==(const CalibrationKey&, const CalibrationKey&) = default;
};
CalibrationKey calibration_key(const reduction::CalibrationOptions& options,
                               const reduction::TileModel& model);

/// A calibration with the library's notes on it.
struct CalibrationRecord {
    reduction::Calibration calibration;
    int budget = 0;        ///< evaluations at most
    double seconds = 0.0;  ///< wall time; not part of the content
    [[nodiscard]] CalibrationKey key() const;
};

/// The data to store for one pattern. Empty members leave what is stored as it is.
struct PatternData {
    std::string pattern;                         ///< id
    std::vector<reduction::Response> responses;  ///< none, or one for each scenario of the setting
    std::vector<CalibrationRecord> calibrations;
    std::vector<std::pair<std::string, double>> properties;  ///< name and value, SI
};

/// How much a library has of one pattern.
struct PatternSummary {
    std::string pattern;  ///< id
    int edges = 0;
    int samples = 0;             ///< of its responses: scenarios times magnitudes; 0: no responses
    int converged_samples = 0;   ///< of them
    int stable_samples = 0;      ///< of those that converged
    int limit_load_samples = 0;  ///< of those that did not: beyond the largest load that the path reaches
    int calibrations = 0;
    std::optional<double> best_objective{};  ///< of them
    int failures = 0;
};

/// A pattern on which a computation failed. It is recorded, and does not stop the rest.
struct Failure {
    std::string pattern;  ///< id
    std::string stage;    ///< the computation: responses_stage(), or calibration_stage(key)
    std::string reason;   ///< one line
    friend bool operator==(const Failure&, const Failure&) = default;
};
std::string responses_stage();
std::string calibration_stage(const CalibrationKey& key);

/// The pattern library: one setting, patterns of one node layout, their responses, calibrations and
/// properties, in one SQLite file (tables and columns: schema.md).
///
/// Every writing call is one transaction: a process killed at any moment, or a disk that is full, leaves the
/// file as it was before or after the call. A stored response or calibration never changes: to store the same
/// again does nothing, to store another is an InputError. A Library is used by one thread at a time; several
/// processes may have one file open (rollback journal and file locks, so network disks work).
///
/// Reading calls throw InputError if an id is unknown or the file is damaged; writing calls also IoError
/// (disk full, no permission, locked by another process for longer than ten seconds).
class Library {
  public:
    /// Make a new file. Throws InputError if there is one already; IoError if it cannot be written.
    static Library create(const std::filesystem::path& path, const pattern::NodeLayout& layout,
                          const reduction::Setting& setting);
    /// A file of schema 3 is changed to this version's schema when it is opened for writing; else it is read
    /// as it is. Throws InputError if the file is missing, is no library, or is one of another version.
    static Library open(const std::filesystem::path& path, Access access = Access::ReadOnly);
    /// Open the file for writing if there is one, and check its layout and setting; else create it with these
    /// patterns in it: a new file that cannot hold all of them is not made.
    static Library open_or_create(const std::filesystem::path& path, const pattern::NodeLayout& layout,
                                  const reduction::Setting& setting,
                                  std::span<const pattern::Pattern> patterns = {},
                                  const base::Control& control = {});
    Library(Library&&) noexcept;
    Library& operator=(Library&&) noexcept;
    ~Library();

    [[nodiscard]] const std::filesystem::path& path() const;
    [[nodiscard]] const pattern::NodeLayout& layout() const;
    [[nodiscard]] const reduction::Setting& setting() const;
    /// Throws InputError that names the first difference.
    void check_setting(const reduction::Setting& wanted) const;
    void check_layout(const pattern::NodeLayout& wanted) const;
    /// Take another setting while nothing has been computed under the present one; afterwards its strength
    /// alone, if it has one, and the rest is as with check_setting.
    void adopt_setting(const reduction::Setting& wanted);

    /// Add patterns; those that are there already are left alone. Returns how many are new. Stopped, it adds
    /// none.
    std::size_t add_patterns(std::span<const pattern::Pattern> patterns, const base::Control& control = {});
    [[nodiscard]] std::size_t pattern_count() const;
    /// All patterns by number of edges, then by their edges: the order of the enumeration, however they came
    /// in.
    [[nodiscard]] std::vector<pattern::NamedPattern> patterns() const;
    /// Up to `size` of patterns(), spread over the numbers of edges as by reduction::stratified_sample(). It
    /// reads what it takes, not all that there is.
    [[nodiscard]] std::vector<pattern::NamedPattern> sample(std::size_t size) const;
    /// One row for each of patterns().
    [[nodiscard]] std::vector<PatternSummary> summaries() const;
    /// One row for each of these, in their order.
    [[nodiscard]] std::vector<PatternSummary> summaries(
        std::span<const pattern::NamedPattern> patterns) const;
    /// The patterns that have a calibration of a model to which something is fitted, in the order of
    /// patterns().
    [[nodiscard]] std::vector<pattern::NamedPattern> fitted_patterns() const;
    /// The objectives of all calibrations of a key, ascending.
    [[nodiscard]] std::vector<double> objectives(const CalibrationKey& key) const;
    /// The pattern of an id, given as pattern::parse_pattern_id takes it. Throws InputError that names the
    /// nearest id.
    [[nodiscard]] pattern::NamedPattern find_pattern(std::string_view id) const;

    /// The patterns, in the order of patterns(), whose responses are neither stored nor recorded as failed.
    [[nodiscard]] std::vector<pattern::NamedPattern> patterns_without_responses() const;
    /// The same for a calibration; patterns whose responses failed are left out.
    [[nodiscard]] std::vector<pattern::NamedPattern> patterns_without_calibration(
        const CalibrationKey& key) const;
    /// The same for one pattern.
    [[nodiscard]] bool lacks_responses(std::string_view pattern_id) const;
    [[nodiscard]] bool lacks_calibration(std::string_view pattern_id, const CalibrationKey& key) const;

    /// Store a batch in one transaction: all of it or nothing. A failure recorded for what is now stored is
    /// forgotten. Throws InputError (unknown pattern, scenario or number of samples; another value than the
    /// stored one), NumericalError (a value is not finite).
    void store(std::span<const PatternData> batch, std::span<const Failure> failures = {});
    [[nodiscard]] std::vector<Failure> failures() const;
    /// Forget all failures, so that their patterns are tried again.
    void forget_failures();

    /// The responses of a pattern in the order of the setting's scenarios; empty if they are not there.
    [[nodiscard]] std::vector<reduction::Response> responses(std::string_view pattern_id) const;
    /// All calibrations of a pattern, sorted by key.
    [[nodiscard]] std::vector<CalibrationRecord> calibrations(std::string_view pattern_id) const;
    /// For each tile model that a pattern has calibrations of, the one with the smallest objective, by name.
    [[nodiscard]] std::vector<reduction::Calibration> best_calibrations(std::string_view pattern_id) const;
    /// The calibration with the smallest objective among a pattern's fitted models.
    [[nodiscard]] std::optional<reduction::Calibration> best_fit(std::string_view pattern_id) const;
    /// Properties of a pattern, sorted by name.
    [[nodiscard]] std::vector<std::pair<std::string, double>> properties(std::string_view pattern_id) const;

    /// A SHA-256 (64 hexadecimal digits) of the content: layout, setting, patterns, responses, calibrations,
    /// properties, failures. It does not depend on the order in which they came in, on times, hosts and
    /// program versions, or on how SQLite laid out the file.
    [[nodiscard]] std::string content_hash() const;
    /// Whether a hash is that of the content, as this version or an older one computes it.
    [[nodiscard]] bool has_content(std::string_view hash) const;
    /// Write each table as one CSV file into a folder (made if missing), and layout.json and setting.json.
    /// Rows are sorted; times and hosts are left out, so equal contents give equal files.
    void export_csv(const std::filesystem::path& folder, const base::Control& control = {}) const;

  private:
    struct Impl;
    explicit Library(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::library
