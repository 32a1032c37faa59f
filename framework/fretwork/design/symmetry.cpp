// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/design/symmetry.hpp>

namespace fretwork::design {

Symmetry parse_symmetry(std::string_view text) {
    if (text == "mirror:x") return {Symmetry::Kind::MirrorX};
    if (text == "mirror:y") return {Symmetry::Kind::MirrorY};
    for (int folds = 2; folds <= 12; ++folds) {
        if (text == "turn:" + std::to_string(folds)) return {Symmetry::Kind::Turn, folds};
    }
    throw base::InputError("'" + std::string(text) +
                           "' is no symmetry: expected mirror:x, mirror:y, or turn:N with N from 2 to 12");
}

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
