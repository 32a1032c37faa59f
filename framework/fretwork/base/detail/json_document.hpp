// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace fretwork::base::detail {

/// The values of a JSON text; members keep the order of the text.
using JsonValue = nlohmann::ordered_json;

/// Parse strictly, in time proportional to the text: a key that appears twice, a number beyond the range of a
/// double, and nesting deeper than 100 are refused. Throws InputError that names the source, and the line and
/// column or the JSON pointer.
JsonValue parse_json(std::string_view text, const std::string& source);

/// The JSON pointer (RFC 6901) of a value that lies in a document; found by search, so only for messages.
std::string pointer_of(const JsonValue& document, const JsonValue& value);

}  // namespace fretwork::base::detail
