// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/pattern.hpp>

#include <optional>
#include <vector>

namespace fretwork::pattern {

/// The reflection of a layout's base triangle that exchanges v1 and v2. The reflection maps a fan to its
/// mirror image.
class Mirror {
  public:
    /// Find the mirror image of each edge of a layout.
    explicit Mirror(const NodeLayout& layout);

    /// The mirror image of a pattern. None if the mirror image of one of its edges is not a candidate edge of
    /// the layout.
    [[nodiscard]] std::optional<Pattern> image(const Pattern& pattern) const;
    /// True if the pattern is its own mirror image.
    [[nodiscard]] bool is_symmetric(const Pattern& pattern) const;
    /// The mirror image of an edge: the candidate edge whose fan is the mirrored fan. None if the layout has
    /// no such edge.
    [[nodiscard]] std::optional<EdgeIndex> image(EdgeIndex edge) const { return images_[edge]; }

  private:
    base::IndexVector<EdgeIndex, std::optional<EdgeIndex>> images_;
};

}  // namespace fretwork::pattern
