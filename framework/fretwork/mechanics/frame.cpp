// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/frame.hpp>
#include <fretwork/mechanics/structure/frame_check.hpp>

namespace fretwork::mechanics {

void validate(const Frame& frame) {
    structure::check_frame(frame, {"frame"});
}

}  // namespace fretwork::mechanics
