// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/outlines/outline.hpp>
#include <studio/server/sent_file.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace fretwork::studio {

/// An outline that comes in a message.
struct SentOutline {
    SentFile file;
    std::string part = "largest";   ///< of a drawing with several, as `fretwork tile --part`
    std::optional<double> width{};  ///< wanted width, m; none: its own
};

/// The outline that would be tiled, and the size of all parts of the drawing.
struct TakenOutline {
    outlines::OutlineFile file;                ///< the chosen parts, as wide as is wanted
    std::vector<std::array<double, 2>> sizes;  ///< of all parts at the same scale, m, the largest part first
    double factor = 1.0;                       ///< by which the drawing was scaled
};

SentOutline read_sent_outline(const base::JsonReader& json);
/// Throws as read_outline_file and take_parts.
TakenOutline take_outline(const SentOutline& sent);
/// The answer to `measure`.
base::Json measured(const TakenOutline& outline);

}  // namespace fretwork::studio
