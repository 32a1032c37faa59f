// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <filesystem>
#include <span>

namespace fretwork::library {

/// Merge libraries of one layout and one setting into a new file. Rows that are in several must be equal, bit
/// by bit: rounding beside a bifurcation, or in a search, has effects without a tolerance. The order of the
/// inputs does not matter. Throws InputError (an output that exists, settings that differ, a row that
/// differs, by name), IoError, or Stopped; then there is no output.
void merge(const std::filesystem::path& output, std::span<const std::filesystem::path> inputs,
           const base::Control& control = {});

}  // namespace fretwork::library
