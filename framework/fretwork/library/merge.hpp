// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <filesystem>
#include <span>

namespace fretwork::library {

/// Merge libraries of one layout and one setting into a new file; some inputs may lack the strength or the
/// shape of the section. Rows that occur in several inputs must be equal bit by bit, because no tolerance
/// bounds the effect of rounding near a bifurcation or in a search. The order of the inputs does not change
/// the content. Throws InputError if there is no input, an input is not a library, the output exists, or two
/// inputs differ in their layout, setting, strength, shape or a row; the message names the difference. Throws
/// IoError and Stopped. After an error, no output is left.
void merge(const std::filesystem::path& output, std::span<const std::filesystem::path> inputs,
           const base::Control& control = {});

}  // namespace fretwork::library
