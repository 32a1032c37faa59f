// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace fretwork::base {

/// The kind of an error, for programs that do more than show its text.
enum class ErrorKind : std::uint8_t {
    Other,          ///< none of the kinds below
    NothingHeld,    ///< a structure has no support
    PartNotHeld,    ///< a part of a structure has no support; `about` states the place of the part
    MovesFreely,    ///< a structure moves without strain although it has supports; `about` states the place
    NotCalibrated,  ///< a calibration is missing; `about` is the pattern and the tile model
};

/// The place of an error.
struct ErrorPlace {
    std::string source;  ///< a file, an option or a message; may be empty
    std::string place;   ///< a JSON pointer, a line or an element in the source; may be empty
};

/// An error as data.
struct ErrorData {
    std::string problem{};  ///< text that says what is wrong and what would be valid
    /// Places, outermost first: a file, then a file to which the first file refers.
    std::vector<ErrorPlace> where{};
    ErrorKind kind = ErrorKind::Other;  ///< kind of the error, for programs
    std::vector<std::string> about{};   ///< facts that depend on `kind`; see ErrorKind
};

/// The text "SOURCE: PLACE: what is wrong", with all places, outermost first. A NUL in them becomes \x00.
std::string text_of(const ErrorData& data);

/// The base class of all exceptions of the library. `what()` is one line for the person who gave the input,
/// made from the error's data.
///
/// A programming mistake is an assert. A disappointing outcome (not converged, rejected) is data in a report.
class Error : public std::runtime_error {
  public:
    /// Make an error from a text that says what is wrong.
    explicit Error(const std::string& problem) : Error(ErrorData{problem}) {}
    /// Make an error from all its data.
    explicit Error(ErrorData data) : std::runtime_error(text_of(data)), data_(std::move(data)) {}

    /// Make an error with one place.
    /// @param source  the file or option
    /// @param place  the JSON pointer, line or element in the source; may be empty
    Error(const std::string& source, const std::string& place, const std::string& problem)
        : Error(ErrorData{problem, {{source, place}}}) {}

    /// The data from which `what()` is made.
    [[nodiscard]] const ErrorData& data() const { return data_; }

  private:
    ErrorData data_;
};

/// A file, an argument or an option is not valid.
class InputError : public Error {
  public:
    using Error::Error;
};

/// A shape is well-formed as data but impossible as geometry, such as an outline that crosses itself or a
/// beam of length zero.
class GeometryError : public InputError {
  public:
    using InputError::InputError;
};

/// A system of equations has no usable solution, because of a structure without supports or a matrix with
/// NaN, for example.
class NumericalError : public Error {
  public:
    using Error::Error;
};

/// The operating system refused an operation, such as writing a file. A text file that cannot be read
/// is an InputError.
class IoError : public Error {
  public:
    using Error::Error;
};

/// Copy an error and add an outer source. A catcher that knows the file throws the copy:
///
///     throw within(file, "", error)
template <class SomeError>
[[nodiscard]] SomeError within(const std::string& source, const std::string& place, const SomeError& error) {
    ErrorData data = error.data();
    data.where.insert(data.where.begin(), {source, place});
    return SomeError(std::move(data));
}

/// Return the value of `work`. If `work` throws a SomeError or a class derived from it, throw a SomeError
/// with its data and an outer source:
///
///     return located(file, "", [&] { return make_outline(points); });
template <class SomeError = InputError, class Work>
auto located(const std::string& source, const std::string& place, const Work& work) {
    try {
        return work();
    } catch (const SomeError& error) {
        throw within(source, place, error);
    }
}

/// An exception as text for a person.
struct Failure {
    std::string text;        ///< one line, without the program's name
    bool is_defect = false;  ///< true: a defect of the program, of which the text asks for a report
};
/// The exception that is being handled: for `catch (...)`. Errors of the library, the system and the memory
/// are foreseen; any other std::exception is a defect. Rethrows what is no std::exception.
[[nodiscard]] Failure handled_failure();

/// True if `source` is among the sources of the error.
[[nodiscard]] bool names_source(const Error& error, const std::string& source);

/// Return the value of `work`. If `work` throws an InputError or a GeometryError that does not name `source`,
/// throw a copy with this outer source.
template <class Work>
auto with_source(const std::string& source, const Work& work) {
    try {
        return work();
    } catch (const GeometryError& error) {
        if (names_source(error, source)) throw;
        throw within(source, "", error);
    } catch (const InputError& error) {
        if (names_source(error, source)) throw;
        throw within(source, "", error);
    }
}

/// Copy an error and replace `source` by `name`. A file has a temporary name while it is written.
template <class SomeError>
[[nodiscard]] SomeError renamed(const SomeError& error, const std::string& source, const std::string& name) {
    ErrorData data = error.data();
    for (ErrorPlace& place : data.where)
        if (place.source == source) place.source = name;
    return SomeError(std::move(data));
}

}  // namespace fretwork::base
