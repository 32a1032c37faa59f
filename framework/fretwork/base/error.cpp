// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>

namespace fretwork::base {

InputError::InputError(const std::string& source, const std::string& place, const std::string& message)
    : Error(source + ": " + (place.empty() ? "" : place + ": ") + message) {}

}  // namespace fretwork::base
