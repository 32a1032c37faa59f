// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

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
        if (value.is_binary()) return append_rows(value.get_binary(), depth);
        append_plain(value);
    }
    std::string take() && { return std::move(text_); }

  private:
    void append_plain(const Json& value) {
        if (value.is_number_float()) return append_double(value.get<double>());
        if (value.is_string()) return append_quoted(value.get_ref<const std::string&>());
        if (value.is_number()) return append_integer(value);
        text_ += value.dump();
    }

    /// Nearly all texts are plain ASCII and need no escapes.
    void append_quoted(const std::string& text) {
        const auto is_plain = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; };
        if (std::ranges::all_of(text, is_plain)) {
            text_.append(1, '"').append(text).append(1, '"');
            return;
        }
        const bool is_harmless = printable(text) == text;
        text_ += Json(text).dump(-1, ' ', !is_harmless, Json::error_handler_t::replace);
    }

    /// Writes the characters of Json::dump(), without its new serializer for each value. A number that is
    /// not finite is refused.
    void append_double(double number) {
        if (!std::isfinite(number)) {
            throw NumericalError("a result holds a number that is not finite" +
                                 (key_.empty() ? "" : ", under '" + key_ + "'"));
        }
        std::array<char, 64> buffer{};
        text_.append(buffer.data(),
                     nlohmann::detail::to_chars(buffer.data(), buffer.data() + buffer.size(), number));
    }

    void append_integer(const Json& integer) {
        std::array<char, 32> buffer{};
        char* const last = buffer.data() + buffer.size();
        const auto written = integer.is_number_unsigned()
                                 ? std::to_chars(buffer.data(), last, integer.get<std::uint64_t>())
                                 : std::to_chars(buffer.data(), last, integer.get<std::int64_t>());
        text_.append(buffer.data(), written.ptr);
    }

    void append_rows(const Json::binary_t& table, int depth) {
        const std::size_t count = table.size() / sizeof(double);
        const std::size_t columns = table.subtype();
        text_ += "[";
        for (std::size_t i = 0; i < count; ++i) {
            const bool starts_row = i % columns == 0;
            if (i > 0) text_ += starts_row ? "]," : ", ";
            if (starts_row) {
                new_line(depth + 1);
                text_ += "[";
            }
            double number = 0.0;
            std::memcpy(&number, table.data() + i * sizeof(double), sizeof(double));
            append_double(number);
        }
        if (count > 0) {
            text_ += "]";
            new_line(depth);
        }
        text_ += "]";
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

Json number_rows(std::span<const double> values, std::uint8_t columns) {
    if (columns == 0 || values.size() % columns != 0)
        throw InputError(std::to_string(values.size()) + " numbers do not fill rows of " +
                         std::to_string(columns));
    const auto bytes = std::as_bytes(values);
    const auto* const first = reinterpret_cast<const std::uint8_t*>(bytes.data());
    return Json::binary(std::vector<std::uint8_t>(first, first + bytes.size()), columns);
}

std::string json_text(const Json& document) {
    Layout layout;
    layout.append(document, 0);
    return std::move(layout).take() + "\n";
}

}  // namespace fretwork::base
