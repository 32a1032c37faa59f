// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/file.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/base/text.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace fretwork::base {

using Json = nlohmann::ordered_json;

struct JsonReader::Value {
    std::shared_ptr<const Json> document;
    std::shared_ptr<const std::string> source;
    const Json* json;
    std::string pointer;

    [[nodiscard]] std::shared_ptr<const Value> child(const Json& member, const std::string& key) const {
        return std::make_shared<const Value>(Value{document, source, &member, pointer + "/" + key});
    }
};

namespace {

/// RFC 6901: '~' and '/' are escaped in a pointer.
std::string escaped(const std::string& key) {
    std::string text;
    for (const char c : key) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return text;
}

std::string line_and_column(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    return "line " + std::to_string(line) + ", column " + std::to_string(before.size() - line_start + 1);
}

/// nlohmann keeps the last of two equal keys without a word; a strict reader may not.
class RepeatedKeys {
  public:
    bool operator()(int, Json::parse_event_t event, Json& parsed) {
        if (event == Json::parse_event_t::object_start) open_.emplace_back();
        if (event == Json::parse_event_t::object_end) open_.pop_back();
        if (event == Json::parse_event_t::key && !open_.back().insert(parsed.get<std::string>()).second) {
            repeated_ = parsed.get<std::string>();
        }
        return true;
    }
    [[nodiscard]] const std::optional<std::string>& repeated() const { return repeated_; }

  private:
    std::vector<std::set<std::string>> open_;
    std::optional<std::string> repeated_;
};

/// "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error ..." says the place once
/// too often.
std::string parse_complaint(const std::string& what) {
    const std::size_t start = what.find(": ");
    return start == std::string::npos ? what : what.substr(start + 2);
}

std::string shortened(const Json& json) {
    constexpr std::size_t kMost = 60;
    const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text.size() <= kMost ? text : text.substr(0, kMost) + "...";
}

}  // namespace

JsonReader JsonReader::from_file(const std::filesystem::path& path) {
    return from_text(read_text_file(path), path.string());
}

JsonReader JsonReader::from_text(std::string_view text, std::string source) {
    RepeatedKeys keys;
    try {
        auto document = std::make_shared<const Json>(Json::parse(text, std::ref(keys)));
        if (keys.repeated())
            throw InputError(source, "", "the key '" + *keys.repeated() + "' appears twice in one object");
        const Json* json = document.get();
        auto name = std::make_shared<const std::string>(std::move(source));
        return JsonReader(
            std::make_shared<const Value>(Value{std::move(document), std::move(name), json, ""}));
    } catch (const Json::parse_error& error) {
        throw InputError(source, line_and_column(text, error.byte),
                         "malformed JSON: " + parse_complaint(error.what()));
    } catch (const Json::out_of_range&) {
        throw InputError(source, "", "holds a number that is too large for double precision (above 1.8e308)");
    } catch (const Json::exception& error) {
        throw InputError(source, "", std::string("malformed JSON: ") + parse_complaint(error.what()));
    }
}

void JsonReader::fail(const std::string& message) const {
    throw InputError(source(), value_->pointer.empty() ? "/" : value_->pointer, message);
}

void JsonReader::expect_format(std::string_view kind) const {
    const std::string wanted = "fretwork/" + std::string(kind) + "/1";
    if (at("format").string() != wanted)
        at("format").fail("is " + at("format").text() + ", where \"" + wanted + "\" is needed");
}

void JsonReader::allow_only(std::initializer_list<std::string_view> keys) const {
    const std::vector<std::string> known(keys.begin(), keys.end());
    for (const auto& [key, member] : members()) {
        if (std::find(known.begin(), known.end(), key) == known.end()) {
            member.fail(unknown_name_message("key", key, known));
        }
    }
}

std::optional<JsonReader> JsonReader::find(std::string_view key) const {
    if (!is_object()) fail("is " + shortened(*value_->json) + ", where an object is needed");
    const std::string name(key);
    const auto member = value_->json->find(name);
    if (member == value_->json->end()) return std::nullopt;
    return JsonReader(value_->child(*member, escaped(name)));
}

JsonReader JsonReader::at(std::string_view key) const {
    if (auto member = find(key)) return *member;
    fail("the key '" + std::string(key) + "' is missing");
}

std::vector<std::pair<std::string, JsonReader>> JsonReader::members() const {
    if (!is_object()) fail("is " + shortened(*value_->json) + ", where an object is needed");
    std::vector<std::pair<std::string, JsonReader>> list;
    for (const auto& [key, member] : value_->json->items()) {
        list.emplace_back(key, JsonReader(value_->child(member, escaped(key))));
    }
    return list;
}

std::vector<JsonReader> JsonReader::elements() const {
    if (!is_array()) fail("is " + shortened(*value_->json) + ", where an array is needed");
    std::vector<JsonReader> list;
    list.reserve(value_->json->size());
    for (std::size_t i = 0; i < value_->json->size(); ++i) {
        list.push_back(JsonReader(value_->child((*value_->json)[i], std::to_string(i))));
    }
    return list;
}

std::vector<JsonReader> JsonReader::elements(std::size_t count) const {
    auto list = elements();
    if (list.size() != count) {
        fail("has " + std::to_string(list.size()) + " elements, where " + std::to_string(count) +
             " are needed");
    }
    return list;
}

bool JsonReader::is_object() const {
    return value_->json->is_object();
}
bool JsonReader::is_array() const {
    return value_->json->is_array();
}
bool JsonReader::is_number() const {
    return value_->json->is_number();
}
bool JsonReader::is_string() const {
    return value_->json->is_string();
}

double JsonReader::number() const {
    if (!is_number()) fail("is " + shortened(*value_->json) + ", where a number is needed");
    const auto value = value_->json->get<double>();
    if (!std::isfinite(value)) fail("is " + shortened(*value_->json) + ", where a finite number is needed");
    return value;
}

double JsonReader::positive_number() const {
    const double value = number();
    if (!(value > 0)) fail("is " + text() + ", where a number above zero is needed");
    return value;
}

std::vector<double> JsonReader::numbers(std::size_t count) const {
    std::vector<double> list;
    for (const JsonReader& element : elements(count)) list.push_back(element.number());
    return list;
}

long long JsonReader::integer(long long low, long long high) const {
    const std::string wanted = "a whole number from " + std::to_string(low) + " to " + std::to_string(high);
    if (!value_->json->is_number_integer())
        fail("is " + shortened(*value_->json) + ", where " + wanted + " is needed");
    // An unsigned value above the signed range would turn negative.
    const bool too_large =
        value_->json->is_number_unsigned() &&
        value_->json->get<unsigned long long>() > static_cast<unsigned long long>(std::max(high, 0LL));
    const auto value = value_->json->get<long long>();
    if (too_large || value < low || value > high) fail("is " + text() + ", where " + wanted + " is needed");
    return value;
}

bool JsonReader::boolean() const {
    if (!value_->json->is_boolean())
        fail("is " + shortened(*value_->json) + ", where true or false is needed");
    return value_->json->get<bool>();
}

std::string JsonReader::string() const {
    if (!is_string()) fail("is " + shortened(*value_->json) + ", where a text is needed");
    return value_->json->get<std::string>();
}

std::string JsonReader::choice(std::initializer_list<std::string_view> choices) const {
    std::string value = string();
    const std::vector<std::string> known(choices.begin(), choices.end());
    if (std::find(known.begin(), known.end(), value) == known.end())
        fail(unknown_name_message("choice", value, known));
    return value;
}

std::string JsonReader::text() const {
    return value_->json->dump(-1, ' ', false, Json::error_handler_t::replace);
}
std::string JsonReader::source() const {
    return *value_->source;
}
std::string JsonReader::pointer() const {
    return value_->pointer;
}

}  // namespace fretwork::base
