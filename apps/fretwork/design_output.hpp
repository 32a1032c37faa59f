// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/design.hpp>

#include <span>

namespace fretwork::app {

/// Print a design as JSON (the keys are listed in framework/fretwork/design/README.md).
/// @param warnings  those of design::design_warnings()
void print_design_json(const design::DesignReport& report, std::span<const design::DesignWarning> warnings);
/// The same for people.
void print_design(const design::DesignReport& report);
/// One line on standard error for each thing that keeps the target out of reach, as far as it is known.
void warn_of_design(std::span<const design::DesignWarning> warnings);

}  // namespace fretwork::app
