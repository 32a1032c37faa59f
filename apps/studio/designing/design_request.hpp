// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/json_reader.hpp>
#include <fretwork/design/design.hpp>
#include <studio/solving/synced_session.hpp>

#include <string>

namespace fretwork::studio {

/// A design that a page asks for.
struct DesignWish {
    design::Target target;
    design::DesignOptions options;  ///< without palette and control
    std::string palette;            ///< as `fretwork design --palette` takes it
};

/// The request `design`, for the selected load case. Throws InputError if it is malformed, or impossible on
/// this document.
DesignWish read_design(const base::JsonReader& request, const Situation& situation);

}  // namespace fretwork::studio
