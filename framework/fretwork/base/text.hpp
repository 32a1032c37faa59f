// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::base {

/// The shortest decimal text that reads back as the same double.
std::string format_number(double value);
/// A number rounded for people, with at most `digits` significant digits: "0.333", "1.2e+06".
std::string format_number(double value, int digits);

/// Join words with a separator: {"a", "b"} with ", " is "a, b".
std::string join(std::span<const std::string> words, std::string_view separator);

/// A count with its noun, with a plural "s" unless the count is one: "1 tile", "3 tiles".
std::string counted(std::size_t count, std::string_view noun);

/// Split a text at every separator; "a,,b" gives three words, the second of them empty, and "" gives one
/// empty word.
std::vector<std::string> split(std::string_view text, char separator);

/// The position of a sign outside of quotes ("" or '') and brackets (() or []); the size of the text if there
/// is none.
std::size_t find_outside(std::string_view text, char sign);

/// The lines of a text, split at line feeds; a carriage return at the end of a line is left out. After a line
/// feed at the end of the text comes one more, empty line.
std::vector<std::string> split_lines(std::string_view text);

/// A text with its ASCII capitals in small letters, whatever the locale.
std::string in_small_letters(std::string_view text);

/// A text as an entry of a CSV file, quoted if necessary (RFC 4180).
std::string csv_field(std::string_view text);

/// A text from a file, made safe for a terminal. Control characters (line breaks and ESC too), characters
/// without width, marks that change the direction of writing, and bytes that are not UTF-8 are replaced by
/// their codes, as in \x1b and \u{202e}.
std::string printable(std::string_view text);

/// A text cut to at most `most` characters (10 or more): a longer text gets "..." in its middle. Characters
/// of UTF-8 stay whole.
std::string shortened(std::string_view text, std::size_t most);

/// The candidate nearest to `word` by edit distance, if one lies within a third of the word's length (at
/// least one edit). Nothing for a word of more than 200 bytes.
std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> candidates);

/// The message "unknown <kind> 'word'; did you mean 'x'?". If no candidate is near, the message lists all
/// candidates.
std::string unknown_name_message(std::string_view kind, std::string_view word,
                                 std::span<const std::string> candidates);

}  // namespace fretwork::base
