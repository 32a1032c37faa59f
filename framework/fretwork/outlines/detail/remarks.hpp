// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/regions/filled_region.hpp>

#include <map>
#include <string>
#include <vector>

namespace fretwork::outlines::detail {

/// The changes of a reader to a drawing, for the person who made it. The text stays short, however many there
/// are.
class Remarks {
  public:
    void say(std::string remark) { said_.push_back(std::move(remark)); }
    /// Count something that is not taken: "3 TEXT left out".
    void leave_out(const std::string& kind, int count = 1) { left_out_[kind] += count; }
    /// Changes of the shapes.
    void tell(const Region& region, double tolerance);
    [[nodiscard]] std::vector<std::string> list() const;
    /// The parts that were left out, in one remark; empty if there are none.
    [[nodiscard]] std::string left_out() const;

  private:
    std::vector<std::string> said_;
    std::map<std::string, int> left_out_;
};

/// A length for people: "284", "12.5", "0.02", in millimetres.
std::string in_millimetres(double length);
/// The same with two digits, rounded up: for limits.
std::string roughly_in_millimetres(double length);

}  // namespace fretwork::outlines::detail
