// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/node_layout.hpp>

#include <string_view>

namespace fretwork::reduction::detail {

/// Throws InputError unless the layout has one interface node on a side.
/// @param made_for_one  what needs that, for the message: "scenarios are"
void require_one_interface_node(const pattern::NodeLayout& layout, std::string_view made_for_one);

}  // namespace fretwork::reduction::detail
