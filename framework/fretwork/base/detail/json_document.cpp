// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/detail/json_document.hpp>
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace fretwork::base::detail {
namespace {

constexpr std::size_t kMostShown = 80;
constexpr std::size_t kDeepest = 100;

/// RFC 6901: '~' and '/' are escaped in a pointer.
std::string escaped(const std::string& key) {
    std::string text;
    for (const char c : key) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return text;
}

/// The message of nlohmann without the exception's name, number and place. A whole message is
/// "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error ...".
std::string parse_complaint(const std::string& what) {
    const std::size_t start = what.find(": ");
    return shortened(start == std::string::npos ? what : what.substr(start + 2), 2 * kMostShown);
}

/// A key that appears twice in an object, if any. Many keys are sorted, because that is faster.
std::optional<std::string> repeated_key(const JsonValue::object_t& object) {
    constexpr std::size_t kFew = 8;
    if (object.size() <= kFew) {
        for (auto second = object.begin(); second != object.end(); ++second) {
            for (auto first = object.begin(); first != second; ++first) {
                if (first->first == second->first) return first->first;
            }
        }
        return std::nullopt;
    }
    std::vector<std::string_view> keys;
    keys.reserve(object.size());
    for (const auto& member : object) keys.push_back(member.first);
    std::ranges::sort(keys);
    const auto repeated = std::ranges::adjacent_find(keys);
    return repeated == keys.end() ? std::nullopt : std::optional<std::string>(*repeated);
}

/// Builds the values as the parser comes to them. A complaint ends the parsing.
class Builder final : public nlohmann::json_sax<JsonValue> {
  public:
    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool number_float(number_float_t value, const string_t&) override { return add(value); }
    bool string(string_t& value) override { return add(std::move(value)); }
    bool binary(binary_t&) override { return false; }  // JSON text has none

    bool start_object(std::size_t) override { return open(JsonValue::value_t::object); }
    bool start_array(std::size_t) override { return open(JsonValue::value_t::array); }
    bool end_array() override { return close(); }
    bool end_object() override {
        const auto& object = open_.back()->get_ref<const JsonValue::object_t&>();
        if (const auto key = repeated_key(object))
            return complain(shortened(pointer_of(root_, *open_.back()), kMostShown),
                            "the key '" + shortened(*key, kMostShown) + "' appears twice in one object");
        return close();
    }
    bool key(string_t& value) override {
        key_ = std::move(value);
        return true;
    }

    bool parse_error(std::size_t byte, const std::string& token,
                     const nlohmann::detail::exception& error) override {
        error_byte_ = byte;
        // The parser reports two kinds of errors: numbers out of range, and malformed JSON.
        return complain("", dynamic_cast<const JsonValue::out_of_range*>(&error) != nullptr
                                ? "the number " + shortened(token, kMostShown) +
                                      " is too large for double precision (above 1.8e308)"
                                : "malformed JSON: " + parse_complaint(error.what()));
    }

    JsonValue root_;
    std::optional<std::string> complaint_{};
    std::string place_;                        ///< place of the complaint, as a JSON pointer
    std::optional<std::size_t> error_byte_{};  ///< byte of the complaint, if the parser found it

  private:
    bool complain(std::string place, std::string message) {
        place_ = std::move(place);
        complaint_ = std::move(message);
        return false;
    }

    template <class Value>
    JsonValue& append(Value&& value) {
        if (open_.empty()) return root_ = JsonValue(std::forward<Value>(value));
        JsonValue& parent = *open_.back();
        if (parent.is_array())
            return parent.get_ref<JsonValue::array_t&>().emplace_back(std::forward<Value>(value));
        // Not operator[], which looks through all the keys that are there.
        return parent.get_ref<JsonValue::object_t&>()
            .JsonValue::object_t::Container::emplace_back(std::move(key_), std::forward<Value>(value))
            .second;
    }

    template <class Value>
    bool add(Value&& value) {
        append(std::forward<Value>(value));
        return true;
    }

    bool open(JsonValue::value_t kind) {
        if (open_.size() == kDeepest)
            return complain("", "is nested more than " + std::to_string(kDeepest) + " deep");
        open_.push_back(&append(kind));
        return true;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    /// The open arrays and objects, outermost first. No parent grows while a child is open, so they stay in
    /// place.
    std::vector<JsonValue*> open_;
    std::string key_;
};

std::string line_and_column(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    return "line " + std::to_string(line) + ", column " + std::to_string(before.size() - line_start + 1);
}

bool append_pointer(const JsonValue& from, const JsonValue& wanted, std::string& pointer) {
    if (&from == &wanted) return true;
    const std::size_t length = pointer.size();
    const auto is_below = [&](const JsonValue& child, const std::string& key) {
        pointer.resize(length);
        pointer += "/" + key;
        return append_pointer(child, wanted, pointer);
    };
    if (from.is_object()) {
        for (const auto& [key, member] : from.get_ref<const JsonValue::object_t&>()) {
            if (is_below(member, escaped(key))) return true;
        }
    } else if (from.is_array()) {
        for (std::size_t i = 0; i < from.size(); ++i) {
            if (is_below(from[i], std::to_string(i))) return true;
        }
    }
    return false;
}

}  // namespace

JsonValue parse_json(std::string_view text, const std::string& source) {
    if (text.starts_with("SQLite format 3"))
        throw InputError(source, "", "is a database, where JSON is needed");
    Builder builder;
    // The parser takes a NUL for the end of the text.
    if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos)
        throw InputError(source, "", "is no JSON: byte " + std::to_string(nul + 1) + " is 0");
    if (JsonValue::sax_parse(text, &builder)) return std::move(builder.root_);
    throw InputError(source,
                     builder.error_byte_ ? line_and_column(text, *builder.error_byte_) : builder.place_,
                     builder.complaint_.value_or("malformed JSON"));
}

std::string pointer_of(const JsonValue& document, const JsonValue& value) {
    std::string pointer;
    return append_pointer(document, value, pointer) ? pointer : "";
}

}  // namespace fretwork::base::detail
