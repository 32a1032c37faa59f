// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/load_cases/load_case.hpp>

#include <utility>

namespace fretwork::simulation {

/// The load case without the origins of its entries: errors then name entries by their places in
/// load_case_text(). For whoever shows people this text, and no file.
inline LoadCase without_origins(LoadCase load_case) {
    const auto forget = [](auto& entries) {
        for (auto& entry : entries) entry.origin = {};
    };
    forget(load_case.supports);
    forget(load_case.loads);
    forget(load_case.area_loads);
    forget(load_case.prescribed);
    return load_case;
}

}  // namespace fretwork::simulation
