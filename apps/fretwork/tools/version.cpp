// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/version.hpp"

#include <fretwork/base/files/provenance.hpp>

namespace fretwork::app {

std::string version_text() {
    std::string text = "fretwork " + base::version() + "\n";
    for (const auto& [name, value] : base::provenance()) {
        if (name == "fretwork_commit") text += "commit " + value + "\n";
        if (name == "compiler") text += "compiler " + value + "\n";
    }
    return text + "libraries " + FRETWORK_LIBRARIES;
}

}  // namespace fretwork::app
