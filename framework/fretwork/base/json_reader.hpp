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

/// A value in a JSON document, together with its place in the document.
///
/// Reading is strict: allow_only() refuses unknown keys, a key that appears twice is an error, and numbers
/// are finite. A function throws if the value is not of the kind that it reads. Every error is an InputError
/// that names the source and, if there is one, the place: the JSON pointer or, in malformed JSON, line and
/// column.
///
/// A JsonReader is cheap to copy and keeps the document alive. The JSON pointer is searched only when a
/// message needs it.
class JsonReader {
  public:
    /// Throws InputError (unreadable file, malformed JSON, repeated key, number beyond the range of a double,
    /// nesting deeper than 100).
    static JsonReader from_file(const std::filesystem::path& path);
    /// Throws InputError as from_file().
    /// @param source  the name of the text in messages
    /// @param place   the JSON pointer at which the source has the text, if it is a part of the source
    static JsonReader from_text(std::string_view text, std::string source, std::string place = "");

    /// Check that the document's `"format"` is "fretwork/<kind>/N", with N from `oldest` to `newest`. Throws
    /// InputError. Only unreleased versions wrote N below `oldest`; the message then asks the user to make
    /// the file again.
    void expect_format(std::string_view kind, int newest = 1, int oldest = 1) const;
    /// Check that the number in the document's `"format"` is at least the number in `needed`. Throws
    /// InputError with the place of the first member with `key`. Pre: expect_format() has checked the kind,
    /// and both numbers have one digit.
    /// @param needed  a whole format, such as "fretwork/stages/2"
    /// @param key  a key in the value, at any depth, that older formats lack, such as "circle"
    void require_format(std::string_view needed, std::string_view key) const;
    /// Throw InputError unless the value is an object with no other keys than `keys`.
    void allow_only(std::initializer_list<std::string_view> keys) const;
    /// Throw InputError unless the value is an object with no other keys than `keys`.
    void allow_only(std::span<const std::string_view> keys) const;

    /// The member with a key. Throws InputError if the object has no such member.
    [[nodiscard]] JsonReader at(std::string_view key) const;
    /// The member with a key; nothing if the object has no such member.
    [[nodiscard]] std::optional<JsonReader> find(std::string_view key) const;
    /// All members of an object, in the order of the file.
    [[nodiscard]] std::vector<std::pair<std::string, JsonReader>> members() const;
    /// All elements of an array.
    [[nodiscard]] std::vector<JsonReader> elements() const;
    /// All elements of an array that must have `count` elements.
    [[nodiscard]] std::vector<JsonReader> elements(std::size_t count) const;

    /// True for `null`.
    [[nodiscard]] bool is_null() const;
    /// True for `{..}`.
    [[nodiscard]] bool is_object() const;
    /// True for `[..]`.
    [[nodiscard]] bool is_array() const;
    /// True for a number.
    [[nodiscard]] bool is_number() const;
    /// True for a string.
    [[nodiscard]] bool is_string() const;

    /// The value as a number, which must be finite.
    [[nodiscard]] double number() const;
    /// The value as a number, which must be above 0.
    [[nodiscard]] double positive_number() const;
    /// The elements of an array of `count` numbers.
    [[nodiscard]] std::vector<double> numbers(std::size_t count) const;
    /// The value as a whole number, which must be written without a point or an exponent, and lie from `low`
    /// to `high`.
    [[nodiscard]] long long integer(long long low, long long high) const;
    /// The value as true or false.
    [[nodiscard]] bool boolean() const;
    /// The value as a string.
    [[nodiscard]] std::string string() const;
    /// The value as a string, which must be one of `choices`.
    [[nodiscard]] std::string choice(std::initializer_list<std::string_view> choices) const;

    /// The compact JSON text of the value.
    [[nodiscard]] std::string text() const;
    /// The file (or other source) that the document came from.
    [[nodiscard]] std::string source() const;
    /// The JSON pointer of the value in the source; "" is the whole source.
    [[nodiscard]] std::string pointer() const;
    /// Throw an InputError with the place of the value.
    [[noreturn]] void fail(const std::string& message) const;
    /// Throw an InputError with the data of `error` and the place of the value. ErrorData::kind stays. If
    /// the first place of `error` has no source and is a JSON pointer, it is a part of the value: the two
    /// pointers become one. What the document does not have of it, because a value was left out or follows
    /// from others, remains a place of its own.
    [[noreturn]] void fail(const InputError& error) const;
    /// Return the value of `work`. If `work` throws a SomeError, throw an InputError with the place of the
    /// value.
    template <class SomeError = InputError, class Work>
    auto located(const Work& work) const {
        try {
            return work();
        } catch (const SomeError& error) {
            fail(error);
        }
    }

  private:
    struct Document;
    struct Access;  ///< gives the value as the parser's type, which users do not see
    JsonReader(std::shared_ptr<const Document> document, const void* value)
        : document_(std::move(document)), value_(value) {}
    std::shared_ptr<const Document> document_;
    const void* value_;  ///< a value in `document_`
};

}  // namespace fretwork::base
