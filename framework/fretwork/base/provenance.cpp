// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/provenance.hpp>

namespace fretwork::base {

std::string version() {
    return FRETWORK_VERSION;
}

std::vector<std::pair<std::string, std::string>> provenance() {
    return {{"fretwork_version", FRETWORK_VERSION},
            {"fretwork_commit", FRETWORK_COMMIT},
            {"compiler", FRETWORK_COMPILER},
            {"build_type", FRETWORK_BUILD_TYPE},
            {"processor", FRETWORK_PROCESSOR}};
}

}  // namespace fretwork::base
