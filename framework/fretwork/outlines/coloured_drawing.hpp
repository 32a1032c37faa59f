// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::outlines {

/// The colour as "#rrggbb" that CSS means: "red", "#f00", "rgb(255, 0, 0)". Throws InputError on anything
/// else.
std::string parse_colour(std::string_view text);

/// The filled areas of an SVG, by colour. Its places are those of an outline that is read from it: metres,
/// from the lower left corner of the viewBox.
class ColouredDrawing {
  public:
    /// Throws InputError or GeometryError with file and place.
    explicit ColouredDrawing(const std::filesystem::path& path);
    ~ColouredDrawing();
    ColouredDrawing(ColouredDrawing&&) noexcept;
    ColouredDrawing& operator=(ColouredDrawing&&) noexcept;

    /// The colours in use, each once, in the order in which they are painted: "#rrggbb", and "" for
    /// gradients.
    [[nodiscard]] std::vector<std::string> colours() const;
    /// The colour that is seen at a point; none where nothing is filled.
    [[nodiscard]] std::optional<std::string> colour_at(geometry::Point2 point) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::outlines
