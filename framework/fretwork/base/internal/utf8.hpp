// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace fretwork::base {

/// A character of UTF-8.
struct Character {
    std::optional<char32_t> code;  ///< code point; none if the bytes are malformed
    std::size_t bytes = 1;         ///< number of bytes; 1 if the bytes are malformed
};

/// The first character of a text that is not empty. Overlong forms and surrogates count as malformed.
Character first_character(std::string_view text);

}  // namespace fretwork::base
