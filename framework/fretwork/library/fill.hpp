// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/library/library.hpp>

#include <span>
#include <string>

namespace fretwork::library {

/// Options of fill(): the calibration that it adds to each pattern, and the way it runs.
struct FillOptions {
    std::string model = "paper6";  ///< name of a row of `models`
    /// The catalogue that has the model.
    std::span<const reduction::TileModel> models = reduction::tile_models();
    reduction::CalibrationOptions calibration{};  ///< options of the fit
    int threads = 0;                              ///< number of threads; 0: one for each processor
    /// Time between two stores, s; 0: each finished pattern is stored at once.
    double seconds_between_stores = 1.0;
    /// Progress and stop. After a stop, fill() stores and reports the finished patterns and does not throw.
    base::Control control{};
    /// Throws InputError if a value is invalid.
    void validate() const;
    /// The row of the model. Throws InputError if `models` has no such row.
    [[nodiscard]] const reduction::TileModel& tile_model() const;
    /// The key of the calibrations made with these options. Throws as tile_model().
    [[nodiscard]] CalibrationKey key() const;
};

/// The report of fill().
struct FillReport {
    std::size_t open = 0;    ///< number of patterns that lacked the calibration at the start
    std::size_t done = 0;    ///< number of patterns calibrated by this call
    std::size_t failed = 0;  ///< number of patterns recorded as failed by this call
    /// Number of starts without a descent, in the searches of this call that gave calibrations.
    std::size_t dead_starts = 0;
};

/// Compute the missing data of some of a library's patterns: the calibration that the options describe, and
/// the responses. Effective properties are computed with the responses, if tiles have four or six sides.
///
/// Finished patterns are stored every FillOptions::seconds_between_stores in one transaction. A killed
/// process loses the patterns that are not stored yet, and a new call continues with them. The result does
/// not depend on threads, interruptions, or the division of the patterns among several calls. A failed
/// computation is recorded with its reason, and does not stop the rest. Apart from the list of patterns,
/// memory does not grow with their number. Throws InputError if an option is invalid, IoError if no thread
/// can be started, and as Library::store; data that was stored before the error remains.
FillReport fill(Library& library, std::span<const pattern::NamedPattern> patterns,
                const FillOptions& options);

}  // namespace fretwork::library
