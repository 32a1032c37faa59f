// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/outlines/svg/svg_page.hpp>

#include <algorithm>

namespace fretwork::outlines::detail {
namespace {

constexpr double kMetresPerPixel = 0.0254 / 96;

/// The size, by CSS, of a drawing that states no size, in pixels.
constexpr double kDefaultWidth = 300;
constexpr double kDefaultHeight = 150;

/// A length of the root element; nothing if the root does not state it, or states a share of the window.
std::optional<double> root_length(const char* name, const SvgElement& root, const SvgDocument& document) {
    const std::string_view text = root.properties().find(name);
    if (text.empty() || text == "auto") return std::nullopt;
    const SvgLength length = document.read(root.node(), name, text, parse_svg_length);
    if (!(length.value > 0))
        document.fail(root.node(), std::string(name) + " is \"" + std::string(text) +
                                       "\", where a length above zero is needed");
    if (length.unit == SvgLength::Unit::Percent) return std::nullopt;
    return length.unit == SvgLength::Unit::Pixel ? length.value : 16 * length.value;
}

struct Size {
    double width;
    double height;
};

/// The size of a drawing whose root does not state it completely.
Size guessed_size(const std::optional<double>& width, const std::optional<double>& height,
                  const std::optional<std::array<double, 4>>& box) {
    const Size whole = box ? Size{(*box)[2], (*box)[3]} : Size{kDefaultWidth, kDefaultHeight};
    if (width) return {*width, *width * whole.height / whole.width};
    if (height) return {*height * whole.width / whole.height, *height};
    return whole;
}

std::string size_text(const Size& size) {
    return in_millimetres(size.width * kMetresPerPixel) + " x " +
           in_millimetres(size.height * kMetresPerPixel) + " mm";
}

}  // namespace

SvgPage page_of(pugi::xml_node root, const SvgDocument& document, Remarks& remarks) {
    const SvgProperties properties(root, document);
    const SvgElement element(root, properties, document);
    const auto box = element.view_box();
    if (box && (!((*box)[2] > 0) || !((*box)[3] > 0)))
        document.fail(root, std::string("viewBox is \"") + root.attribute("viewBox").value() +
                                "\", where four numbers are needed, the last two above zero");
    const auto width = root_length("width", element, document);
    const auto height = root_length("height", element, document);
    Size size{width.value_or(0), height.value_or(0)};
    if (!width || !height) {
        size = guessed_size(width, height, box);
        remarks.add("it does not say its width and height; " +
                    std::string(box ? "from its viewBox" : "as a browser would,") + " it is taken as " +
                    size_text(size));
    }
    const std::array<double, 4> shown = box.value_or(std::array<double, 4>{0, 0, size.width, size.height});
    const Affine scale = map_of_view_box(shown, {0, 0, size.width, size.height},
                                         root.attribute("preserveAspectRatio").value());
    const double x = scale.a * kMetresPerPixel;
    const double y = scale.d * kMetresPerPixel;
    return {x * shown[2],
            y * shown[3],
            {x, 0, 0, -y, -x * shown[0], y * (shown[1] + shown[3])},
            {shown[2], shown[3]}};
}

}  // namespace fretwork::outlines::detail
