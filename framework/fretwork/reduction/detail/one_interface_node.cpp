// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/reduction/detail/one_interface_node.hpp>

namespace fretwork::reduction::detail {

void require_one_interface_node(const pattern::NodeLayout& layout, std::string_view made_for_one) {
    const std::size_t count = layout.interface_nodes().size();
    if (count == 1) return;
    throw base::InputError("layout '" + layout.name() + "' has " + std::to_string(count) +
                           " interface nodes on a side; " + std::string(made_for_one) + " made for one");
}

}  // namespace fretwork::reduction::detail
