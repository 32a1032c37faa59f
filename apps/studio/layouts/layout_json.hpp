// SPDX-License-Identifier: GPL-3.0-or-later
// Layouts, as messages have them.
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <studio/layouts/layout_change.hpp>
#include <studio/layouts/layout_count.hpp>

namespace fretwork::studio {

/// A layout as its page shows it: the content of its file, its nodes, and its candidate edges.
base::Json layout_json(const pattern::NodeLayout& layout);

/// The keys `grid` and `mirror` of a request; each may be left out.
LayoutHand read_hand(const base::JsonReader& request);

/// The key `change` of a request: `{move: NODE, to: [3]}`, `{add: KIND, to: [3]}` or `{remove: NODE}`. Throws
/// InputError if it is malformed, or names a node that the layout does not have.
LayoutChange read_change(const base::JsonReader& json, const pattern::NodeLayout& layout);

/// The valid patterns of a layout: how many were found, whether these are all, and some of their ids.
base::Json count_json(const pattern::NodeLayout& layout, const CountedPatterns& counted);

}  // namespace fretwork::studio
