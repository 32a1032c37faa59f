// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/design/design.hpp>
#include <studio/document/history.hpp>

namespace fretwork::studio {

/// A painting that a design has found.
struct DesignFound {
    /// Sketch: a painting after few solutions, which shows early where the design leads. Answer: the final
    /// painting.
    enum class Stage { Sketch, Answer };
    Stage stage = Stage::Answer;
    design::DesignReport report;
    design::DesignOptions options;  ///< those of the request
};

/// The document with the painting of a design, and with the design's load cases if they differ.
Edited with_design(const State& state, const design::DesignReport& report);

/// The event `designed`.
base::Json designed_event(const DesignFound& found, std::int64_t revision);

}  // namespace fretwork::studio
