// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/frame/detail/frame_check.hpp>
#include <fretwork/mechanics/frame/frame.hpp>

namespace fretwork::mechanics {

void validate(const Frame& frame) {
    detail::check_frame(frame, {"frame"});
}

}  // namespace fretwork::mechanics
