// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/symmetry.hpp>

#include <string>

namespace fretwork::typed {

/// The symmetry of a painting, as people write it: "mirror:x", "mirror:y", or "turn:N" with N from 2 to 12.
/// Throws InputError.
design::Symmetry read_symmetry(const std::string& text);

}  // namespace fretwork::typed
