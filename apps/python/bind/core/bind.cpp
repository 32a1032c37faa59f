// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bind.hpp"

#include <fretwork/base/error.hpp>

namespace fretwork::python {

void fill_record(py::object record, const py::dict& named) {
    if (named.empty()) return;
    py::module_::import("fretwork._record").attr("fill")(record, named);
}

py::object taken(py::dict& named, const char* name) {
    return named.attr("pop")(name, py::none());
}

void check(const pattern::NodeLayout& layout, const pattern::Pattern& pattern) {
    const std::size_t count = layout.candidate_edges().size();
    if (const auto beyond = pattern.bits() >> count; beyond.any())
        throw base::InputError("the pattern has the candidate edge " +
                               std::to_string(count + beyond._Find_first()) + ", and the layout '" +
                               layout.name() + "' has " + std::to_string(count) +
                               ": it is a pattern of another layout");
}

void check(const pattern::NodeLayout& layout, std::span<const pattern::Pattern> patterns) {
    for (const pattern::Pattern& pattern : patterns) check(layout, pattern);
}

std::size_t checked_index(std::ptrdiff_t index, std::size_t count, const char* what) {
    if (index < 0 || static_cast<std::size_t>(index) >= count)
        throw py::index_error("there is no " + std::string(what) + " " + std::to_string(index) +
                              "; there are " + std::to_string(count));
    return static_cast<std::size_t>(index);
}

}  // namespace fretwork::python
