// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace fretwork::design {

/// The symmetry of a painting about the middle of the surface's bounding box.
struct Symmetry {
    /// What the painting goes over into itself by.
    enum class Kind {
        None,
        MirrorX,  ///< left and right are mirror images
        MirrorY,  ///< below and above are mirror images
        Turn      ///< unchanged by 1 / `folds` of a whole turn
    };
    Kind kind = Kind::None;  ///< which one
    int folds = 1;           ///< of a turn: by a full turn over this number
    friend bool operator==(const Symmetry&, const Symmetry&) = default;
};

/// The text that people type for a symmetry: "mirror:x", "mirror:y", "turn:N" or "none".
std::string symmetry_text(const Symmetry& symmetry);

}  // namespace fretwork::design
