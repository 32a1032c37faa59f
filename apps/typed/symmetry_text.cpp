// SPDX-License-Identifier: GPL-3.0-or-later
#include "typed/symmetry_text.hpp"

#include <fretwork/base/error.hpp>

namespace fretwork::typed {

using design::Symmetry;

Symmetry read_symmetry(const std::string& text) {
    if (text == "mirror:x") return {Symmetry::Kind::MirrorX};
    if (text == "mirror:y") return {Symmetry::Kind::MirrorY};
    for (int folds = 2; folds <= 12; ++folds) {
        if (text == "turn:" + std::to_string(folds)) return {Symmetry::Kind::Turn, folds};
    }
    throw base::InputError("'" + text +
                           "' is not a symmetry: expected mirror:x, mirror:y, or turn:N with N from 2 to 12");
}

}  // namespace fretwork::typed
