// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/detail/json_document.hpp>
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::base {

using detail::JsonValue;

struct JsonReader::Document {
    std::string source;
    std::string place;  ///< JSON pointer of `root` in the source
    JsonValue root;
};

struct JsonReader::Access {
    static const JsonValue& value(const JsonReader& reader) {
        return *static_cast<const JsonValue*>(reader.value_);
    }
    static JsonReader child(const JsonReader& reader, const JsonValue& value) {
        return {reader.document_, &value};
    }
    static const JsonValue::object_t& object(const JsonReader& reader) {
        if (!reader.is_object()) refuse(reader, "an object");
        return value(reader).get_ref<const JsonValue::object_t&>();
    }
    static const JsonValue::array_t& array(const JsonReader& reader) {
        if (!reader.is_array()) refuse(reader, "an array");
        return value(reader).get_ref<const JsonValue::array_t&>();
    }
    static const JsonValue::array_t& array(const JsonReader& reader, std::size_t count) {
        const auto& values = array(reader);
        if (values.size() != count) {
            reader.fail("has " + std::to_string(values.size()) + " elements, where " + std::to_string(count) +
                        " are needed");
        }
        return values;
    }
    /// Go from a value along a JSON pointer as far as the document goes. The rest stays in `pointer`.
    static JsonReader follow(JsonReader reader, std::string& pointer) {
        while (pointer.starts_with('/')) {
            const std::string key = pointer.substr(1, pointer.find('/', 1) - 1);
            const JsonValue* next = child_at(value(reader), key);
            if (next == nullptr) break;
            reader = child(reader, *next);
            pointer.erase(0, key.size() + 1);
        }
        return reader;
    }
    /// The first member with a key in a value, at any depth; the value itself if there is none.
    static JsonReader first_member(const JsonReader& reader, std::string_view key) {
        const JsonValue* found = find_member(value(reader), key);
        return found != nullptr ? child(reader, *found) : reader;
    }
    [[noreturn]] static void refuse(const JsonReader& reader, const std::string& wanted) {
        reader.fail("is " + description(value(reader)) + ", where " + wanted + " is needed");
    }

  private:
    /// The member or the element that a token of a JSON pointer names; null if there is none.
    static const JsonValue* child_at(const JsonValue& json, const std::string& token) {
        if (json.is_object()) {
            const auto member = json.find(token);
            return member != json.end() ? &*member : nullptr;
        }
        const auto index = read_number<std::size_t>(token);
        return json.is_array() && index && *index < json.size() ? &json[*index] : nullptr;
    }
    static const JsonValue* find_member(const JsonValue& json, std::string_view key) {
        if (!json.is_structured()) return nullptr;
        for (auto child = json.begin(); child != json.end(); ++child) {
            if (json.is_object() && child.key() == key) return &*child;
            if (const JsonValue* found = find_member(*child, key)) return found;
        }
        return nullptr;
    }

    /// The value, shortened; for long arrays and objects, the size.
    static std::string description(const JsonValue& json) {
        constexpr std::size_t kMostShown = 60;
        constexpr std::size_t kFew = 8;
        if (json.is_array() && json.size() > kFew) return "an array of " + std::to_string(json.size());
        if (json.is_object() && json.size() > kFew)
            return "an object with " + std::to_string(json.size()) + " keys";
        return shortened(json.dump(-1, ' ', false, JsonValue::error_handler_t::replace), kMostShown);
    }
};

JsonReader JsonReader::from_file(const std::filesystem::path& path) {
    return from_text(read_text_file(path), path.string());
}

JsonReader JsonReader::from_text(std::string_view text, std::string source, std::string place) {
    JsonValue root = detail::parse_json(text, source);
    auto document =
        std::make_shared<const Document>(Document{std::move(source), std::move(place), std::move(root)});
    const JsonValue* value = &document->root;
    return {std::move(document), value};
}

void JsonReader::fail(const std::string& message) const {
    fail(InputError(message));
}

void JsonReader::fail(const InputError& error) const {
    constexpr std::size_t kMostShown = 80;
    ErrorData data = error.data();
    JsonReader wrong = *this;
    if (!data.where.empty() && data.where.front().source.empty()) {
        std::string& part = data.where.front().place;
        wrong = Access::follow(wrong, part);
        if (part.starts_with('/')) part.erase(0, 1);  // it is no place of the source
        if (part.empty()) data.where.erase(data.where.begin());
    }
    const std::string place = shortened(wrong.pointer(), kMostShown);
    throw within(source(), place.empty() ? "/" : place, InputError(std::move(data)));
}

void JsonReader::expect_format(std::string_view kind, int newest, int oldest) const {
    const JsonReader format = at("format");
    const std::string given = format.text();
    std::vector<std::string> known;
    for (int number = newest; number >= 1; --number) {
        const std::string name = "\"fretwork/" + std::string(kind) + "/" + std::to_string(number) + "\"";
        if (number >= oldest) known.push_back(name);
        if (given != name) continue;
        if (number >= oldest) return;
        format.fail("is " + given + ", of an unreleased version: make the " + std::string(kind) + " again (" +
                    join(known, " or ") + ")");
    }
    Access::refuse(format, join(known, " or "));
}

void JsonReader::require_format(std::string_view needed, std::string_view key) const {
    const std::string given = at("format").string();
    if (given >= needed) return;  // compared as texts, because numbers have one digit
    Access::first_member(*this, key)
        .fail(given + " has no " + std::string(key) + "; " + std::string(needed) + " has");
}

void JsonReader::allow_only(std::initializer_list<std::string_view> keys) const {
    allow_only(std::span(keys.begin(), keys.size()));
}

void JsonReader::allow_only(std::span<const std::string_view> keys) const {
    for (const auto& [key, member] : Access::object(*this)) {
        if (std::ranges::find(keys, key) != keys.end()) continue;
        const std::vector<std::string> known(keys.begin(), keys.end());
        Access::child(*this, member).fail(unknown_name_message("key", key, known));
    }
}

std::optional<JsonReader> JsonReader::find(std::string_view key) const {
    for (const auto& [name, member] : Access::object(*this)) {
        if (name == key) return Access::child(*this, member);
    }
    return std::nullopt;
}

JsonReader JsonReader::at(std::string_view key) const {
    if (auto member = find(key)) return *std::move(member);
    fail("the key '" + std::string(key) + "' is missing");
}

std::vector<std::pair<std::string, JsonReader>> JsonReader::members() const {
    const auto& object = Access::object(*this);
    std::vector<std::pair<std::string, JsonReader>> list;
    list.reserve(object.size());
    for (const auto& [key, member] : object) list.emplace_back(key, Access::child(*this, member));
    return list;
}

std::vector<JsonReader> JsonReader::elements() const {
    const auto& array = Access::array(*this);
    std::vector<JsonReader> list;
    list.reserve(array.size());
    for (const JsonValue& element : array) list.push_back(Access::child(*this, element));
    return list;
}

std::vector<JsonReader> JsonReader::elements(std::size_t count) const {
    (void)Access::array(*this, count);
    return elements();
}

bool JsonReader::is_null() const {
    return Access::value(*this).is_null();
}
bool JsonReader::is_object() const {
    return Access::value(*this).is_object();
}
bool JsonReader::is_array() const {
    return Access::value(*this).is_array();
}
bool JsonReader::is_number() const {
    return Access::value(*this).is_number();
}
bool JsonReader::is_string() const {
    return Access::value(*this).is_string();
}

double JsonReader::number() const {
    if (!is_number()) Access::refuse(*this, "a number");
    const auto value = Access::value(*this).get<double>();
    if (!std::isfinite(value)) Access::refuse(*this, "a finite number");
    return value;
}

double JsonReader::positive_number() const {
    const double value = number();
    if (!(value > 0)) Access::refuse(*this, "a number above zero");
    return value;
}

std::vector<double> JsonReader::numbers(std::size_t count) const {
    std::vector<double> list;
    list.reserve(count);
    for (const JsonValue& element : Access::array(*this, count)) {
        // A large document consists mostly of such values, so a reader is made only for an error.
        const double value = element.is_number() ? element.get<double>() : std::nan("");
        list.push_back(std::isfinite(value) ? value : Access::child(*this, element).number());
    }
    return list;
}

long long JsonReader::integer(long long low, long long high) const {
    const JsonValue& json = Access::value(*this);
    // An unsigned value above the signed range would turn negative.
    const bool is_too_large =
        json.is_number_unsigned() &&
        json.get<unsigned long long>() > static_cast<unsigned long long>(std::max(high, 0LL));
    const bool fits = json.is_number_integer() && !is_too_large && json.get<long long>() >= low &&
                      json.get<long long>() <= high;
    if (!fits)
        Access::refuse(*this, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return json.get<long long>();
}

bool JsonReader::boolean() const {
    const JsonValue& json = Access::value(*this);
    if (!json.is_boolean()) Access::refuse(*this, "true or false");
    return json.get<bool>();
}

std::string JsonReader::string() const {
    if (!is_string()) Access::refuse(*this, "a text");
    return Access::value(*this).get<std::string>();
}

std::string JsonReader::choice(std::initializer_list<std::string_view> choices) const {
    std::string value = string();
    if (std::ranges::find(choices, value) != choices.end()) return value;
    const std::vector<std::string> known(choices.begin(), choices.end());
    fail(unknown_name_message("choice", value, known));
}

std::string JsonReader::text() const {
    return Access::value(*this).dump(-1, ' ', false, JsonValue::error_handler_t::replace);
}
std::string JsonReader::source() const {
    return document_->source;
}
std::string JsonReader::pointer() const {
    return document_->place + detail::pointer_of(document_->root, Access::value(*this));
}

}  // namespace fretwork::base
