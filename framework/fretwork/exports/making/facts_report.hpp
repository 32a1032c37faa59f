// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/cut_sheet.hpp>
#include <fretwork/fabrication/facts.hpp>

#include <string>

namespace fretwork::exports {

/// A table for people, in millimetres, grams and megapascals; then the warnings, one a line.
std::string facts_text(const fabrication::Facts& facts);
/// "fretwork/facts/2", SI.
std::string facts_json(const fabrication::Facts& facts);
/// Facts, and the outline that pictures show.
struct FactsOfScene {
    fabrication::Facts facts;
    fabrication::CutSheet sheet;
};
/// One page without anything else: the table, and a picture in which the warnings are marked.
std::string facts_html(const FactsOfScene& scene);

}  // namespace fretwork::exports
