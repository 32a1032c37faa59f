// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/fan.hpp>

#include <string>

namespace fretwork::pattern::detail {

/// A string of bytes. The strings of two fans are equal exactly if the fans are isomorphic as graphs whose
/// interface nodes have their own colour.
std::string canonical_form(const Fan& fan);

}  // namespace fretwork::pattern::detail
