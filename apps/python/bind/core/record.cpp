// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/record.hpp"

#include <set>
#include <string>

namespace fretwork::python {
namespace {

constexpr const char* kFields = "_setters";

/// The fields of a class, its own and those of its bases: names and setters.
py::dict fields_of(const py::object& type) {
    if (!py::hasattr(type, kFields)) return {};
    return type.attr(kFields).attr("copy")();
}

}  // namespace

void add_field(py::object& type, const char* name, const py::object& set) {
    py::dict fields = fields_of(type);
    fields[name] = set;
    type.attr(kFields) = fields;
}

void finish_record(py::object& type, Made made) {
    const py::module_ records = py::module_::import("fretwork._record");
    records.attr("finish")(type, made == Made::ByFields);
}

std::string_view kept_text(std::string_view text) {
    static std::set<std::string, std::less<>> texts;  // under Python's lock, and never moved
    return *texts.emplace(text).first;
}

py::object frozen(py::object value) {
    if (py::isinstance<py::list>(value)) return py::tuple(value);
    if (py::hasattr(value, "setflags")) value.attr("setflags")(py::arg("write") = false);  // an array
    return value;
}

}  // namespace fretwork::python
