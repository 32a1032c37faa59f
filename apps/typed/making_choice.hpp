// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/writer_catalogue.hpp>

#include <string>

namespace fretwork::typed {

/// Options of cutting or printing a surface, as a person writes them: lengths such as "2mm"; empty: not
/// given.
struct MakingChoice {
    std::string fillet;
    std::string kerf;
    std::string frame;
    std::string bolts;  ///< diameter of holes at the supports of a load case
    std::string eye;    ///< diameter of the disc of material around each bolt hole
    std::string bed;    ///< "600x400" in millimetres, or with units: "60cmx40cm"
    std::string fit;
    std::string clearance;
    std::string layer;
    /// The prefix of these names in messages.
    std::string prefix = "--";
};

/// Read the options. `conditions` are the conditions of the load case; null: no load case. Throws InputError
/// that names the entry.
exports::Making read_making(const MakingChoice& choice, const simulation::Conditions* conditions);

}  // namespace fretwork::typed
