// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace fretwork::base {

/// The kind of an error, where programs do more than show its text.
enum class ErrorKind : std::uint8_t {
    Other,
    NothingHeld,    ///< a structure has no support
    PartNotHeld,    ///< a part of a structure has no support; `about`: where it is
    MovesFreely,    ///< a structure moves without strain although it is held; `about`: where
    NotCalibrated,  ///< there is no calibration; `about`: the pattern, the tile model
};

/// Where something is wrong.
struct ErrorPlace {
    std::string source;  ///< a file, an option, a message; may be empty
    std::string place;   ///< a JSON pointer, a line or an element in it; may be empty
};

/// An error as data.
struct ErrorData {
    std::string problem{};            ///< what is wrong, and what would be valid
    std::vector<ErrorPlace> where{};  ///< the outermost first: a file, then the file that it names
    ErrorKind kind = ErrorKind::Other;
    std::vector<std::string> about{};  ///< see ErrorKind
};

/// "SOURCE: PLACE: what is wrong", in one line.
std::string text_of(const ErrorData& data);

/// The root of what the library throws. `what()` is one line, fit to be shown to the person who gave the
/// input: it is made of the data.
///
/// A programming mistake is an assert; an outcome that may disappoint (not converged, rejected) is data in a
/// report.
class Error : public std::runtime_error {
  public:
    explicit Error(const std::string& problem) : Error(ErrorData{problem}) {}
    explicit Error(ErrorData data) : std::runtime_error(text_of(data)), data_(std::move(data)) {}

    /// @param source  the file or option
    /// @param place   the JSON pointer, line or element in it; may be empty
    Error(const std::string& source, const std::string& place, const std::string& problem)
        : Error(ErrorData{problem, {{source, place}}}) {}

    [[nodiscard]] const ErrorData& data() const { return data_; }

  private:
    ErrorData data_;
};

/// A file, an argument or an option is not what it has to be.
class InputError : public Error {
  public:
    using Error::Error;
};

/// A shape is well-formed as data and impossible as geometry: an outline that crosses itself, a beam of
/// length zero.
class GeometryError : public InputError {
  public:
    using InputError::InputError;
};

/// A system of equations has no usable solution: a floating structure, a matrix with NaN.
class NumericalError : public Error {
  public:
    using Error::Error;
};

/// The operating system refuses to read or write.
class IoError : public Error {
  public:
    using Error::Error;
};

/// The same error, found inside of a source that it does not name: `throw within(file, "", error)`.
template <class SomeError>
[[nodiscard]] SomeError within(const std::string& source, const std::string& place, const SomeError& error) {
    ErrorData data = error.data();
    data.where.insert(data.where.begin(), {source, place});
    return SomeError(std::move(data));
}

/// Whether an error says that it lies in a source.
[[nodiscard]] bool names_source(const Error& error, const std::string& source);

/// The same error of a source that people know by another name: a file that is written under a name for a
/// while.
template <class SomeError>
[[nodiscard]] SomeError renamed(const SomeError& error, const std::string& source, const std::string& name) {
    ErrorData data = error.data();
    for (ErrorPlace& place : data.where)
        if (place.source == source) place.source = name;
    return SomeError(std::move(data));
}

}  // namespace fretwork::base
