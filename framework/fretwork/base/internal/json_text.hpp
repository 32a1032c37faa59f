// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

namespace fretwork::base {

/// The type in which writers build their documents: members keep the order in which they were added.
using Json = nlohmann::ordered_json;

/// The JSON of a value, or of the `part` of it that a function or a member gives; null if there is no value.
template <class Value, class Part = std::identity>
Json or_null(const std::optional<Value>& value, Part part = {}) {
    return value ? Json(std::invoke(part, *value)) : Json(nullptr);
}

/// A table as an array of rows, from its numbers row by row. The numbers stay in one block of memory, because
/// tables are most of a large document. Only json_text() can write this value, which may not be an element of
/// an array. Throws InputError unless the numbers fill whole rows.
Json number_rows(std::span<const double> values, std::uint8_t columns);

/// Format a document for people: an array of plain values takes one line, and objects and nested arrays take
/// several. Control characters are escaped, because a terminal would obey them. Throws NumericalError that
/// names the key if a number is not finite, because JSON has no NaN.
std::string json_text(const Json& document);

}  // namespace fretwork::base
