// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/error.hpp>

#include <string>

namespace fretwork::studio {

/// An error in words for people who see a surface but no files. Places in messages and files become words
/// ("load case 1, support 2"), and errors of solvers become advice.
std::string in_words(const base::Error& error);

/// The error that is being handled, in words: for `catch (...)`. An exception that is no error of the input,
/// the system or the solver is a defect of the program; the words say so and ask for a report.
std::string error_in_words();

/// The name of the source in errors about messages of pages. in_words() leaves it out.
inline constexpr const char* kMessageSource = "message";

/// A text that may come from outside, as one line of at most 500 characters.
std::string one_line(const std::string& text);

}  // namespace fretwork::studio
