// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of options before a verb runs.
#pragma once

#include <CLI/CLI.hpp>

#include <initializer_list>
#include <string>

namespace fretwork::app {

/// Whole numbers of at most 18 digits, which every seed can hold. CLI11 itself would turn negative and larger
/// numbers into other numbers.
CLI::Validator seed_check();

/// Numbers of threads.
CLI::Validator thread_check();

/// Finite numbers of zero or more: CLI11's own ranges let NaN pass.
CLI::Validator not_negative_check();

/// Finite numbers above zero, for a limit that does not exist without its option.
CLI::Validator above_zero_check();

/// Lengths of zero or more, such as 0.5mm.
CLI::Validator length_check();

/// Throw InputError if one of these options is given, because it has no effect here.
/// @param why  what they are for: "is for drawings, .."
void refuse_given(const CLI::App& verb, std::initializer_list<const char*> options, const std::string& why);

}  // namespace fretwork::app
