// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace fretwork::base {

/// The root of what the library throws. `what()` is one line, fit to be shown to the person who gave the
/// input.
///
/// A programming mistake is an assert; an outcome that may disappoint (not converged, rejected) is data in a
/// report.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A file, an argument or an option is not what it has to be.
class InputError : public Error {
  public:
    explicit InputError(const std::string& message) : Error(message) {}

    /// @param source  the file or option
    /// @param place   the JSON pointer, line or element in it; may be empty
    InputError(const std::string& source, const std::string& place, const std::string& message);
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

}  // namespace fretwork::base
