// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace fretwork::base::detail {

/// The type in which writers build their documents: members keep the order in which they were added.
using Json = nlohmann::ordered_json;

/// Lay a document out for people: objects and nested arrays over lines, an array of plain values on one line.
/// Throws NumericalError if a number is not finite, naming its JSON pointer: JSON has no NaN.
std::string json_text(const Json& document);

}  // namespace fretwork::base::detail
