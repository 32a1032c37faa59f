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

/// Parse a CSS colour: a name, a hexadecimal colour or rgb() ("red", "#f00", "rgb(255, 0, 0)"). Returns
/// "#rrggbb", without the opacity. Throws InputError for all other texts, also for hsl().
std::string parse_colour(std::string_view text);

/// The filled areas of an SVG, by colour. Coordinates are in metres from the lower left corner of the
/// viewBox, as in an outline read from the same file.
class ColouredDrawing {
  public:
    /// Read a drawing. Throws InputError or GeometryError with file and place.
    explicit ColouredDrawing(const std::filesystem::path& path);
    /// Parse a drawing; `source` names it in messages. Throws as the constructor.
    static ColouredDrawing parse(std::string_view text, const std::string& source);
    ~ColouredDrawing();
    ColouredDrawing(ColouredDrawing&&) noexcept;
    ColouredDrawing& operator=(ColouredDrawing&&) noexcept;

    /// The colours in use, each once, in the order in which they are drawn: "#rrggbb", and "" for gradients,
    /// patterns and colours that parse_colour() does not know.
    [[nodiscard]] std::vector<std::string> colours() const;
    /// The visible colour at a point, as in colours(); none if no area is filled at the point.
    [[nodiscard]] std::optional<std::string> colour_at(geometry::Point2 point) const;

  private:
    struct Impl;
    explicit ColouredDrawing(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::outlines
