// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/internal/utf8.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>

namespace fretwork::base {
namespace {

std::size_t edit_distance(std::string_view left, std::string_view right) {
    std::vector<std::size_t> row(right.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < left.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < right.size(); ++j) {
            const std::size_t substituted = diagonal + (left[i] == right[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, substituted});
        }
    }
    return row.back();
}

/// Characters that a terminal obeys or that hide what is written: C0 and C1 controls, line and paragraph
/// separators, marks of direction, characters of no width, and tags.
bool is_harmful(char32_t code) {
    struct Range {
        char32_t first, last;
    };
    constexpr Range kHarmful[] = {{0x00, 0x1f},     {0x7f, 0x9f},      {0xad, 0xad},     {0x61c, 0x61c},
                                  {0x200b, 0x200f}, {0x2028, 0x202e},  {0x2060, 0x206f}, {0xfeff, 0xfeff},
                                  {0xfff9, 0xfffb}, {0xe0000, 0xe007f}};
    return std::ranges::any_of(kHarmful, [&](const Range& r) { return r.first <= code && code <= r.last; });
}

std::string hexadecimal(unsigned long number, std::size_t digits) {
    std::array<char, 16> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number, 16);
    const std::string text(buffer.data(), result.ptr);
    return std::string(digits - std::min(digits, text.size()), '0') + text;
}

}  // namespace

std::string format_number(double value) {
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

std::string format_number(double value, int digits) {
    std::array<char, 64> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                      std::chars_format::general, digits);
    return {buffer.data(), result.ptr};
}

std::string join(std::span<const std::string> words, std::string_view separator) {
    std::string text;
    for (const std::string& word : words) {
        if (&word != words.data()) text += separator;
        text += word;
    }
    return text;
}

std::string counted(std::size_t count, std::string_view noun) {
    return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> words;
    for (;;) {
        const std::size_t end = text.find(separator);
        words.emplace_back(text.substr(0, end));
        if (end == std::string_view::npos) return words;
        text.remove_prefix(end + 1);
    }
}

std::size_t find_outside(std::string_view text, char sign) {
    int depth = 0;
    char quote = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (c == sign && depth == 0) {
            return i;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '(' || c == '[') {
            ++depth;
        } else if ((c == ')' || c == ']') && depth > 0) {
            --depth;
        }
    }
    return text.size();
}

std::vector<std::string> split_lines(std::string_view text) {
    std::vector<std::string> lines = split(text, '\n');
    for (std::string& line : lines)
        if (line.ends_with('\r')) line.pop_back();
    return lines;
}

std::string in_small_letters(std::string_view text) {
    std::string small(text);
    for (char& c : small) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return small;
}

std::string csv_field(std::string_view text) {
    if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::string printable(std::string_view text) {
    std::string shown;
    while (!text.empty()) {
        const Character character = first_character(text);
        if (!character.code || (*character.code < 0x80 && is_harmful(*character.code))) {
            shown += "\\x" + hexadecimal(static_cast<unsigned char>(text.front()), 2);
        } else if (is_harmful(*character.code)) {
            shown += "\\u{" + hexadecimal(*character.code, 4) + "}";
        } else {
            shown += text.substr(0, character.bytes);
        }
        text.remove_prefix(character.bytes);
    }
    return shown;
}

std::string shortened(std::string_view text, std::size_t most) {
    constexpr std::string_view kGap = "...";
    std::vector<std::size_t> starts;
    for (std::size_t at = 0; at < text.size(); at += first_character(text.substr(at)).bytes)
        starts.push_back(at);
    if (starts.size() <= most) return std::string(text);
    const std::size_t kept = most - kGap.size();
    const std::size_t tail = kept / 2;
    return std::string(text.substr(0, starts[kept - tail]))
        .append(kGap)
        .append(text.substr(starts[starts.size() - tail]));
}

std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> candidates) {
    constexpr std::size_t kLongestName = 200;  // the time grows with the product of the lengths
    if (word.size() > kLongestName) return std::nullopt;
    const std::size_t limit = std::max<std::size_t>(1, word.size() / 3);
    std::optional<std::string> nearest;
    std::size_t smallest = limit + 1;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < smallest) {
            smallest = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string unknown_name_message(std::string_view kind, std::string_view word,
                                 std::span<const std::string> candidates) {
    constexpr std::size_t kMostShown = 60;
    const std::string start = "unknown " + std::string(kind) + " '" + shortened(word, kMostShown) + "'; ";
    if (const auto nearest = nearest_name(word, candidates))
        return start + "did you mean '" + *nearest + "'?";
    return start + (candidates.empty() ? "there is none" : "there is: " + join(candidates, ", "));
}

}  // namespace fretwork::base
