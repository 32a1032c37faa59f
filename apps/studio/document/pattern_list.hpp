// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <studio/document/state.hpp>

namespace fretwork::studio {

/// All patterns of a layout with their properties in a setting: the answer to `patterns`. `state` gives the
/// setting and the library; null: the setting of new surfaces, and no library. Throws InputError,
/// base::Stopped.
base::Json pattern_list(const std::string& layout, const State* state, const base::Control& control);

}  // namespace fretwork::studio
