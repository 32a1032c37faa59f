// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer_catalogue.hpp>

#include <string>

namespace fretwork::optimization {

/// A method that is a program of its own, in any language.
struct OutsideCommand {
    std::string name;     ///< name of the method: letters, digits, '-', '_' and '.'
    std::string command;  ///< shell command, started once for each run; a stop of the caller ends it
    /// Throws InputError if the name is not valid, or there is no command.
    void validate() const;
};

/// The row of a method that is a program of its own. The program reads lines from its standard input and
/// writes lines to its standard output. First it reads five lines:
///
///     dimension 6
///     lower -1.5 0 ..        the bounds, one number for each variable
///     upper 1.5 2 ..
///     seed 17
///     starts 1
///
/// Then it writes any number of requests and reads one line after each:
///
///     value x1 x2 ..         objective at a point: a number, or `inf` where it is not finite
///     gradient x1 x2 ..      objective and its derivatives, or `inf`
///
/// A program may send up to a mebibyte of requests before it reads their answers. The answer is `spent` if
/// the rest of the budget does not cover the evaluation. Else it is `outside` for a point beyond the bounds
/// or with a component that is not a number; such a point is not charged. At its end, the program writes
/// `done`, or `done stalled` if its criterion was not met. After `spent`, it may end without this line, with
/// any exit code. A program is killed, and its run ends as Ending::Stopped,
///
/// - if it sends more than a hundred requests after `spent`,
/// - if it asks for more than 100,000 points outside in succession,
/// - if it reads nothing for a second while a mebibyte of its requests waits, or
/// - if it is silent or reads no answer for a second after the time of the budget is over.
///
/// Cost and results are counted as for every method; only the program's processor time is not. A run throws
/// IoError if the shell cannot be started. It throws InputError if the shell does not find the program. It
/// also throws InputError if the program writes anything else, requests a gradient that the problem does not
/// offer, ends too early or with an exit code other than 0, or is done without a value.
///
/// Throws InputError if the name is not valid, or there is no command.
OptimizerRow outside_command_row(const OutsideCommand& method);

}  // namespace fretwork::optimization
