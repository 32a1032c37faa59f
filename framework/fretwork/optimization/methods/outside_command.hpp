// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/optimization/optimizer_catalogue.hpp>

#include <string>

namespace fretwork::optimization {

/// A method that is a program of its own, in any language.
struct OutsideCommand {
    std::string name;         ///< name of the method: letters, digits, '-', '_' and '.'
    std::string command;      ///< command of the shell, started once for each run
    base::Control control{};  ///< stops the waiting for the command; must live as long as the row is used
    /// Throws InputError if the name is not valid, or there is no command.
    void validate() const;
};

/// The row of a method that is a program of its own. The program and ours speak in lines of words over its
/// standard input and output. First it gets five lines:
///
///     dimension 6
///     lower -1.5 0 ..        the bounds, one number for each variable
///     upper 1.5 2 ..
///     seed 17
///     starts 1
///
/// Then it asks, as often as it likes, and gets one line for each question:
///
///     value x1 x2 ..         objective at a point: a number, or `inf` where it is not finite
///     gradient x1 x2 ..      objective and its derivatives, or `inf`
///
/// The answer is `spent` once the rest of the budget does not cover the evaluation, and `outside` for a point
/// beyond the bounds, which is not charged. The program ends with the line `done`, or `done stalled` if its
/// criterion was not met. After `spent` it may end without a word.
///
/// The evaluator counts and keeps what every method is judged by; only the processor time of the program
/// itself is not counted. Running the method throws IoError if the command cannot be started, InputError if
/// it says something else or ends before it is done.
OptimizerRow outside_command_row(const OutsideCommand& method);

}  // namespace fretwork::optimization
