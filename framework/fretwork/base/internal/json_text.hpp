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

/// A value, or what a function or a member gives of it; null if there is no value.
template <class Value, class Part = std::identity>
Json or_null(const std::optional<Value>& value, Part part = {}) {
    return value ? Json(std::invoke(part, *value)) : Json(nullptr);
}

/// A table as an array of rows, kept in one piece of memory: most of a large document. Only json_text can
/// read it. Throws InputError unless the numbers fill whole rows.
Json number_rows(std::span<const double> values, std::uint8_t columns);

/// Lay a document out for people: objects and nested arrays over lines, an array of plain values on one line.
/// Characters that a terminal obeys are escaped, as JSON allows. Throws NumericalError that names the key if
/// a number is not finite: JSON has no NaN.
std::string json_text(const Json& document);

}  // namespace fretwork::base
