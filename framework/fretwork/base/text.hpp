// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::base {

/// The shortest decimal text that reads back as the same double.
std::string format_number(double value);
/// A rounded one for people, with `digits` significant digits at most: "0.333", "1.2e+06".
std::string format_number(double value, int digits);

/// Join with a separator: {"a", "b"} with ", " is "a, b".
std::string join(std::span<const std::string> words, std::string_view separator);

/// Split at every separator; "a,,b" has an empty middle, "" is one empty word.
std::vector<std::string> split(std::string_view text, char separator);

/// A text as a field of a CSV file: quoted where it has to be (RFC 4180).
std::string csv_field(std::string_view text);

/// A text that comes from a file, fit for a terminal: control characters, escape sequences, marks that turn
/// the direction of writing, and bytes that are no UTF-8 are shown as \x1b or \u{202e}. Line breaks are, too.
std::string printable(std::string_view text);

/// A text of at most `most` characters (10 or more): a longer one has "..." in its middle. Characters of
/// UTF-8 stay whole.
std::string shortened(std::string_view text, std::size_t most);

/// The candidate most like `word` (edit distance, at most a third of its length and at least one), if any is.
std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> candidates);

/// "unknown <kind> 'word'; did you mean 'x'?", or the list of what there is, where nothing is near.
std::string unknown_name_message(std::string_view kind, std::string_view word,
                                 std::span<const std::string> candidates);

}  // namespace fretwork::base
