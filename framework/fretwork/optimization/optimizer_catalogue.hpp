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
    std::string name;
    std::string summary;  ///< one line
    OptimizerClass kind;
    Evaluation needs;  ///< besides the value
    std::function<std::unique_ptr<Optimizer>(const OptimizerOptions& options)> make;
};

/// All methods of the library. To add one: a file with its factory, and a row; a method of NLopt is a row
/// alone. A program with its own methods passes a list of rows where one is taken.
std::span<const OptimizerRow> optimizer_catalogue();

/// Throws InputError that names the nearest method, or all of them.
const OptimizerRow& find_optimizer(std::string_view name,
                                   std::span<const OptimizerRow> rows = optimizer_catalogue());

}  // namespace fretwork::optimization
