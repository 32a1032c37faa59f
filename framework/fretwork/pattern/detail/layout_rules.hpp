// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/node_layout.hpp>

#include <optional>
#include <string>

namespace fretwork::pattern::detail {

/// A breach of a layout rule by a description.
struct LayoutFault {
    std::string pointer;  ///< where in a layout file, as a JSON pointer
    std::string message;  ///< names the rule and, if one node breaks it, the node
};

/// The first rule that a description breaks, if any.
std::optional<LayoutFault> find_layout_fault(const NodeLayoutDescription& description);

}  // namespace fretwork::pattern::detail
