// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/library/library.hpp>

#include <span>
#include <string>

namespace fretwork::library {

/// Which calibration fill() adds to each pattern, and how it works.
struct FillOptions {
    std::string model = "paper6";  ///< a row of `models`
    std::span<const reduction::TileModel> models = reduction::tile_models();
    reduction::CalibrationOptions calibration{};
    int threads = 0;                      ///< 0: all there are
    double seconds_between_stores = 1.0;  ///< 0: what is finished is stored at once
    /// When stopped, fill() stores and reports what is done, and does not throw.
    base::Control control{};
    /// Throws InputError if a value is invalid.
    void validate() const;
    [[nodiscard]] const reduction::TileModel& tile_model() const;
    /// The key of the calibrations that these options give.
    [[nodiscard]] CalibrationKey key() const;
};

struct FillReport {
    std::size_t open = 0;         ///< patterns that lacked the calibration at the start
    std::size_t done = 0;         ///< of them, calibrated now
    std::size_t failed = 0;       ///< of them, recorded as failed now
    std::size_t dead_starts = 0;  ///< of the searches that gave calibrations now: starts that went nowhere
};

/// Compute what the library lacks of some of its patterns: responses, effective properties, and the
/// calibration that the options ask for.
///
/// Finished patterns are stored about every second in one transaction, so a killed process loses no more; a
/// new run goes on there. The result does not depend on threads, interruptions and shards. A failed
/// computation is recorded with its reason, and does not stop the rest. Memory does not grow with the number
/// of patterns. Throws as Library::store; then all that was stored before is there.
FillReport fill(Library& library, std::span<const pattern::NamedPattern> patterns,
                const FillOptions& options);

}  // namespace fretwork::library
