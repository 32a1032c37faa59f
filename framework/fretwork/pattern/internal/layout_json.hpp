// SPDX-License-Identifier: GPL-3.0-or-later
// A layout as JSON inside other documents.
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/pattern/node_layout.hpp>

namespace fretwork::pattern {

/// Read a layout as it stands in its own file. Throws InputError with source and JSON pointer.
NodeLayout read_node_layout(const base::JsonReader& json);
/// The inverse of read_node_layout.
base::Json node_layout_json(const NodeLayout& layout);

}  // namespace fretwork::pattern
