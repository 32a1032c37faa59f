// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/error.hpp>

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fretwork::base {

/// A value in a JSON document, together with its place there.
///
/// Reading is strict: an unknown key is an error, a key that appears twice is an error, and numbers are
/// finite. Every error is an InputError that names the source, the JSON pointer, the value, and what would be
/// valid.
///
/// A reader is a handle. It is cheap to copy and keeps the document alive. The JSON pointer is searched only
/// when a message needs it.
class JsonReader {
  public:
    /// Throws InputError (missing file, malformed JSON with line and column, repeated key).
    static JsonReader from_file(const std::filesystem::path& path);
    /// @param source  the name of the text in messages
    static JsonReader from_text(std::string_view text, std::string source);

    /// The document's `"format"` must be "fretwork/<kind>/N", with N from `oldest` to `newest`. Only
    /// unreleased versions wrote formats below `oldest`: the message asks the user to make the file again.
    void expect_format(std::string_view kind, int newest = 1, int oldest = 1) const;
    /// Throw InputError unless this is an object with no other keys than these.
    void allow_only(std::initializer_list<std::string_view> keys) const;
    /// Throw InputError if the object has any other key.
    void allow_only(std::span<const std::string_view> keys) const;

    /// A required member. Throws InputError if it is missing.
    [[nodiscard]] JsonReader at(std::string_view key) const;
    /// An optional member.
    [[nodiscard]] std::optional<JsonReader> find(std::string_view key) const;
    /// All members of an object, in the order of the file.
    [[nodiscard]] std::vector<std::pair<std::string, JsonReader>> members() const;
    /// All elements of an array.
    [[nodiscard]] std::vector<JsonReader> elements() const;
    /// All elements of an array that must have `count` elements.
    [[nodiscard]] std::vector<JsonReader> elements(std::size_t count) const;

    /// True for `{..}`.
    [[nodiscard]] bool is_object() const;
    /// True for `[..]`.
    [[nodiscard]] bool is_array() const;
    /// True for a number.
    [[nodiscard]] bool is_number() const;
    /// True for a text.
    [[nodiscard]] bool is_string() const;

    /// The number, finite.
    [[nodiscard]] double number() const;
    /// The number, above 0.
    [[nodiscard]] double positive_number() const;
    /// That many numbers.
    [[nodiscard]] std::vector<double> numbers(std::size_t count) const;
    /// A whole number from `low` to `high`.
    [[nodiscard]] long long integer(long long low, long long high) const;
    /// True or false.
    [[nodiscard]] bool boolean() const;
    /// The text.
    [[nodiscard]] std::string string() const;
    /// A string that is one of `choices`.
    [[nodiscard]] std::string choice(std::initializer_list<std::string_view> choices) const;

    /// The value as compact JSON text.
    [[nodiscard]] std::string text() const;
    /// The file (or other source) that the document came from.
    [[nodiscard]] std::string source() const;
    /// The JSON pointer of this value; "" is the whole document.
    [[nodiscard]] std::string pointer() const;
    /// Throw InputError about this value.
    [[noreturn]] void fail(const std::string& message) const;
    /// Throw the error again with the place of this value added. Its kind stays.
    [[noreturn]] void fail(const InputError& error) const;

  private:
    struct Document;
    struct Access;  ///< gives the value as the parser's type, which users do not see
    JsonReader(std::shared_ptr<const Document> document, const void* value)
        : document_(std::move(document)), value_(value) {}
    std::shared_ptr<const Document> document_;
    const void* value_;  ///< a value in `document_`
};

}  // namespace fretwork::base
