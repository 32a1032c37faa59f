// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace fretwork::base {
namespace {

class Layout {
  public:
    void append(const Json& value, int depth) {
        if (value.is_object() && !value.empty()) return append_object(value, depth);
        if (value.is_array() &&
            std::any_of(value.begin(), value.end(), [](const Json& v) { return v.is_structured(); })) {
            return append_nested_array(value, depth);
        }
        if (value.is_array()) return append_plain_array(value);
        append_plain(value);
    }
    std::string take() && { return std::move(text_); }

  private:
    void append_plain(const Json& value) {
        if (value.is_number_float() && !std::isfinite(value.get<double>())) {
            throw NumericalError("a result holds a number that is not finite" +
                                 (key_.empty() ? "" : ", under '" + key_ + "'"));
        }
        if (value.is_string()) return append_quoted(value.get_ref<const std::string&>());
        if (value.is_number()) return append_number(value);
        text_ += value.dump();
    }

    /// Nearly all texts are plain ASCII, which stands for itself.
    void append_quoted(const std::string& text) {
        const auto is_plain = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; };
        if (std::ranges::all_of(text, is_plain)) {
            text_.append(1, '"').append(text).append(1, '"');
            return;
        }
        const bool is_harmless = printable(text) == text;
        text_ += Json(text).dump(-1, ' ', !is_harmless, Json::error_handler_t::replace);
    }

    /// The characters of Json::dump, which prepares for each value as for a whole document. Most of a large
    /// document is numbers.
    void append_number(const Json& number) {
        std::array<char, 64> buffer{};
        char* const first = buffer.data();
        char* last = nullptr;
        if (number.is_number_float()) {
            last = nlohmann::detail::to_chars(first, first + buffer.size(), number.get<double>());
        } else if (number.is_number_unsigned()) {
            last = std::to_chars(first, first + buffer.size(), number.get<std::uint64_t>()).ptr;
        } else {
            last = std::to_chars(first, first + buffer.size(), number.get<std::int64_t>()).ptr;
        }
        text_.append(first, last);
    }

    void append_plain_array(const Json& array) {
        text_ += "[";
        for (std::size_t i = 0; i < array.size(); ++i) {
            if (i > 0) text_ += ", ";
            append_plain(array[i]);
        }
        text_ += "]";
    }

    void append_nested_array(const Json& array, int depth) {
        text_ += "[";
        for (std::size_t i = 0; i < array.size(); ++i) {
            if (i > 0) text_ += ",";
            new_line(depth + 1);
            append(array[i], depth + 1);
        }
        new_line(depth);
        text_ += "]";
    }

    void append_object(const Json& object, int depth) {
        text_ += "{";
        bool first = true;
        for (const auto& [key, member] : object.items()) {
            if (!first) text_ += ",";
            first = false;
            new_line(depth + 1);
            append_quoted(key);
            text_ += ": ";
            key_ = key;
            append(member, depth + 1);
        }
        new_line(depth);
        text_ += "}";
    }

    void new_line(int depth) { text_.append(1, '\n').append(2 * static_cast<std::size_t>(depth), ' '); }

    std::string text_;
    std::string key_;
};

}  // namespace

std::string json_text(const Json& document) {
    Layout layout;
    layout.append(document, 0);
    return std::move(layout).take() + "\n";
}

}  // namespace fretwork::base
