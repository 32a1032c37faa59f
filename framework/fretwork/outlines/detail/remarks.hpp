// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/regions/filled_region.hpp>

#include <map>
#include <string>
#include <vector>

namespace fretwork::outlines::detail {

/// Collects the changes that a reader makes to a drawing, as remarks for the user. The text stays short for
/// any number of changes.
class Remarks {
  public:
    void add(std::string remark) { remarks_.push_back(std::move(remark)); }
    /// Count content that is left out: "3 TEXT left out".
    void leave_out(const std::string& kind, int count = 1) { left_out_[kind] += count; }
    /// Add remarks about the changes of the shapes.
    void add_changes(const Region& region, double tolerance);
    [[nodiscard]] std::vector<std::string> list() const;
    /// The content that was left out, in one remark; empty if there is none.
    [[nodiscard]] std::string left_out() const;

  private:
    std::vector<std::string> remarks_;
    std::map<std::string, int> left_out_;
};

/// A length for people: "284", "12.5", "0.02", in millimetres.
std::string in_millimetres(double length);
/// A limit for people, in millimetres with two digits, rounded up.
std::string roughly_in_millimetres(double length);

}  // namespace fretwork::outlines::detail
