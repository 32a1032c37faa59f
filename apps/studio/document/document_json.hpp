// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <studio/document/history.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>

namespace fretwork::studio {

/// A document's data for pages, besides its state.
struct DocumentStatus {
    std::int64_t revision = 0;
    std::optional<std::filesystem::path> path{};  ///< of its file; none: it has none yet
    std::string name{};
    bool is_saved = false;
    bool is_recovered = false;  ///< from an autosave that is newer than its file
    std::size_t selected_load_case = 0;
    std::optional<std::string> undo{};  ///< labels
    std::optional<std::string> redo{};
};

/// The places of a layout's nodes on the base triangle, as barycentric coordinates for v0, v1, v2.
base::Json layout_nodes_json(const pattern::NodeLayout& layout);
/// The event `document`: everything.
base::Json document_event(const State& state, const DocumentStatus& status);
/// The event `changed`: the keys of those parts that differ, and the status.
base::Json changed_event(const State& before, const State& now, const DocumentStatus& status);

}  // namespace fretwork::studio
