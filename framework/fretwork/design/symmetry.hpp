// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace fretwork::design {

/// The symmetry of a painting about the middle of the surface's bounding box. A tile that is its own image
/// may have any pattern, so that the bars of a tile on the axis of a mirror need not be symmetric.
struct Symmetry {
    /// The motion that leaves the painting unchanged.
    enum class Kind {
        None,
        MirrorX,  ///< the left and the right half are mirror images
        MirrorY,  ///< the lower and the upper half are mirror images
        Turn      ///< a rotation by 1 / `folds` of a whole turn leaves the painting unchanged
    };
    Kind kind = Kind::None;  ///< kind of the symmetry
    int folds = 1;           ///< number of equal rotations in a whole turn, for Turn
    friend bool operator==(const Symmetry&, const Symmetry&) = default;
};

/// The text of a symmetry, as commands take it: "mirror:x", "mirror:y" or "turn:N"; "none" without a
/// symmetry.
std::string symmetry_text(const Symmetry& symmetry);

}  // namespace fretwork::design
