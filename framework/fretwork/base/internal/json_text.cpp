// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <cmath>

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
        text_ += value.is_string() ? quoted(value) : value.dump();
    }

    static std::string quoted(const Json& text) {
        const auto& content = text.get_ref<const std::string&>();
        const bool is_harmless = printable(content) == content;
        return text.dump(-1, ' ', !is_harmless, Json::error_handler_t::replace);
    }

    /// Most of a large document is rows of numbers: one call for each row.
    void append_numbers(const Json& array) {
        for (const char c : array.dump()) {
            text_ += c;
            if (c == ',') text_ += ' ';
        }
    }

    void append_plain_array(const Json& array) {
        const auto is_finite_number = [](const Json& v) {
            return v.is_number() && (!v.is_number_float() || std::isfinite(v.get<double>()));
        };
        if (std::all_of(array.begin(), array.end(), is_finite_number)) return append_numbers(array);
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
            text_ += quoted(key) + ": ";
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
