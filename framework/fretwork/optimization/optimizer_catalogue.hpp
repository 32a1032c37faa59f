// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace fretwork::optimization {

/// One method that a user can choose by name.
struct OptimizerRow {
    std::string name;     ///< name of the method, as users type it
    std::string summary;  ///< description in one line
    OptimizerClass kind;  ///< class of the method
    Evaluation needs;     ///< the kind of evaluation that the method needs besides the value
    /// A function that makes the method. Throws InputError if an option is invalid.
    std::function<std::unique_ptr<Optimizer>(const OptimizerOptions& options)> make;
    /// The command of a method that is a program of its own; empty: a method of this program. A study does
    /// not mix the runs of two commands under one name.
    std::string command{};
};

/// The built-in methods. A new method is a file with its factory and a row; a method of NLopt needs only a
/// row. A program with its own methods passes its own list of rows to the functions that take one.
std::span<const OptimizerRow> optimizer_catalogue();

/// The row with this name. Throws InputError that suggests the nearest name, or lists all names.
const OptimizerRow& find_optimizer(std::string_view name,
                                   std::span<const OptimizerRow> rows = optimizer_catalogue());

}  // namespace fretwork::optimization
