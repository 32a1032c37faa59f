// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/enums.hpp"
#include "core/record.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <cctype>

namespace fretwork::python {
namespace {

[[noreturn]] void refuse_word(const char* kind, const std::string& word, std::span<const char* const> words) {
    const std::vector<std::string> known(words.begin(), words.end());
    throw base::InputError(base::unknown_name_message(kind, word, known));
}

/// "limit-load" as LIMIT_LOAD.
std::string member_name(std::string word) {
    for (char& c : word) c = c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return word;
}

/// The words of a set of dofs: a text is split at blanks, anything else gives its elements.
std::vector<std::string> dof_words(py::handle object) {
    const py::object words = py::isinstance<py::str>(object) ? object.attr("split")() : py::iter(object);
    std::vector<std::string> found;
    for (const py::handle word : words) found.push_back(py::cast<std::string>(word));
    return found;
}

}  // namespace

int place_of_word(py::handle object, const char* kind, std::span<const char* const> words) {
    if (!py::isinstance<py::str>(object)) return -1;
    const auto word = py::cast<std::string>(object);
    const auto found = std::ranges::find(words, word, [](const char* known) { return std::string(known); });
    if (found == words.end()) refuse_word(kind, word, words);
    return static_cast<int>(found - words.begin());
}

bool read_dofs(py::handle object, mechanics::DofSet& dofs) {
    if (!py::isinstance<py::str>(object) && !py::isinstance<py::iterable>(object)) return false;
    for (const std::string& word : dof_words(object)) {
        if (word == "all")
            dofs = mechanics::DofSet::all();
        else if (word == "translations")
            std::fill_n(dofs.contains.begin(), 3, true);
        else
            dofs.contains[static_cast<std::size_t>(
                place_of_word(py::str(word), "component", Words<mechanics::Dof>::kWords))] = true;
    }
    return true;
}

py::object dof_names(const mechanics::DofSet& dofs) {
    py::list names;
    for (std::size_t d = 0; d < dofs.contains.size(); ++d)
        if (dofs.contains[d]) names.append(py::cast(static_cast<mechanics::Dof>(d)));
    return py::tuple(names);
}

py::array_t<double, py::array::c_style | py::array::forcecast> read_rows(py::handle object,
                                                                         py::ssize_t columns, bool convert) {
    using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;
    const auto nothing = py::reinterpret_steal<Rows>(py::handle());
    if (!convert && !py::isinstance<py::array>(object)) return nothing;
    if (py::isinstance<py::str>(object) || object.is_none()) return nothing;
    Rows rows = Rows::ensure(object);
    if (!rows) {
        PyErr_Clear();
        return nothing;
    }
    if (rows.size() == 0) return Rows(std::vector<py::ssize_t>{0, columns});
    return rows.ndim() == 2 && rows.shape(1) == columns ? rows : nothing;
}

py::object int_of_digits(const std::string& digits) {
    return py::reinterpret_steal<py::object>(PyLong_FromString(digits.c_str(), nullptr, 10));
}

py::object fraction(std::int64_t numerator, std::int64_t denominator) {
    return py::module_::import("fractions").attr("Fraction")(numerator, denominator);
}

pattern::Rational read_fraction(py::handle object) {
    if (py::isinstance<py::float_>(object))
        throw py::type_error("places of nodes are exact: give an int, a Fraction or a text such as '1/3'");
    const py::object read = py::module_::import("fractions").attr("Fraction")(object);
    return {py::cast<std::int64_t>(read.attr("numerator")), py::cast<std::int64_t>(read.attr("denominator"))};
}

py::object make_enum_class(py::module_& module, const char* name, const char* doc,
                           std::span<const char* const> words) {
    py::list members;
    for (const char* word : words) members.append(py::make_tuple(member_name(word), word));
    const py::object type = py::module_::import("enum").attr("StrEnum")(
        name, members, py::arg("module") = module.attr("__module__"));
    type.attr("__doc__") = doc;
    module.attr(name) = type;
    py::dict by_word;
    for (const char* word : words) by_word[word] = type(word);
    return by_word;
}

}  // namespace fretwork::python
