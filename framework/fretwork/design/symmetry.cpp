// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/design/symmetry.hpp>

namespace fretwork::design {

std::string symmetry_text(const Symmetry& symmetry) {
    switch (symmetry.kind) {
        case Symmetry::Kind::None:
            return "none";
        case Symmetry::Kind::MirrorX:
            return "mirror:x";
        case Symmetry::Kind::MirrorY:
            return "mirror:y";
        default:
            return "turn:" + std::to_string(symmetry.folds);
    }
}

}  // namespace fretwork::design
