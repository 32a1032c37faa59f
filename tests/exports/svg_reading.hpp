// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings read again.
#pragma once

#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <algorithm>
#include <cctype>
#include <limits>
#include <sstream>
#include <string>

namespace fretwork::exports::test {

/// A drawing as XML; a failed test if it is not well-formed, or not in millimetres with a view box of the
/// same numbers.
class Svg {
  public:
    explicit Svg(const std::string& text) {
        const auto parsed = document_.load_string(text.c_str());
        EXPECT_TRUE(parsed) << parsed.description();
        const std::string width = root().attribute("width").value();
        const std::string height = root().attribute("height").value();
        EXPECT_TRUE(width.ends_with("mm") && height.ends_with("mm")) << width << " " << height;
        EXPECT_EQ(root().attribute("viewBox").value(),
                  "0 0 " + width.substr(0, width.size() - 2) + " " + height.substr(0, height.size() - 2));
        EXPECT_EQ(text.find("nan"), std::string::npos);
        EXPECT_EQ(text.find("inf"), std::string::npos);
    }
    [[nodiscard]] pugi::xml_node root() const { return document_.child("svg"); }
    [[nodiscard]] double width_mm() const { return root().attribute("width").as_double(); }
    [[nodiscard]] double height_mm() const { return std::stod(root().attribute("height").value()); }
    /// A layer of the drawing or of a panel in it.
    [[nodiscard]] pugi::xml_node layer(const std::string& name) const {
        return document_.select_node((".//*[local-name()='g' and @id='" + name + "']").c_str()).node();
    }
    [[nodiscard]] std::size_t count(const std::string& element) const {
        return document_.select_nodes((".//*[local-name()='" + element + "']").c_str()).size();
    }
    /// All words of the drawing, each text on a line.
    [[nodiscard]] std::string words() const {
        std::string all;
        for (const auto& found : document_.select_nodes(".//*[local-name()='text']"))
            all += std::string(found.node().child_value()) + "\n";
        return all;
    }

    /// The height of the smallest text in points when the drawing is printed as wide as it says, at most as
    /// wide as a page (177 mm); 0 if it does not say.
    [[nodiscard]] double smallest_text_in_print() const {
        const double print = root().attribute("data-print-width").as_double();
        EXPECT_LE(print, 177.0);
        double smallest = std::numeric_limits<double>::infinity();
        for (const auto& found : document_.select_nodes(".//*[local-name()='text']")) {
            double height = found.node().attribute("font-size").as_double();
            for (auto above = found.node().parent(); above != root(); above = above.parent())
                height *= scale_of(above);
            smallest = std::min(smallest, height);
        }
        return smallest * print / width_mm() * 72.0 / 25.4;
    }

  private:
    /// How much larger a panel is drawn than its numbers say.
    static double scale_of(const pugi::xml_node& node) {
        if (!node.attribute("viewBox")) return 1.0;
        double width = 0.0;
        std::istringstream(node.attribute("viewBox").value()) >> width >> width >> width;
        return node.attribute("width").as_double() / width;
    }

    pugi::xml_document document_;
};

/// The smallest text of a journal.
inline constexpr double kLegible = 6.0;

/// The id of the layer that has this label.
inline std::string identifier_of(std::string label) {
    for (char& c : label) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '-';
    }
    return label;
}

inline std::size_t children(const pugi::xml_node& layer, const char* element) {
    const auto list = layer.children(element);
    return static_cast<std::size_t>(std::distance(list.begin(), list.end()));
}

/// How many lines a path draws.
inline std::size_t lines_of(const pugi::xml_node& path) {
    const std::string d = path.attribute("d").value();
    return static_cast<std::size_t>(std::count(d.begin(), d.end(), 'L'));
}

inline std::size_t lines_of_layer(const pugi::xml_node& layer) {
    std::size_t sum = 0;
    for (const pugi::xml_node& path : layer.children("path")) sum += lines_of(path);
    return sum;
}

}  // namespace fretwork::exports::test
