// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/outlines/coloured_drawing.hpp>
#include <fretwork/outlines/detail/coloured_picture.hpp>
#include <fretwork/outlines/svg/css.hpp>
#include <fretwork/outlines/svg/shown.hpp>

#include <algorithm>
#include <utility>

namespace fretwork::outlines {

using detail::Picture;
using geometry::Point2;

std::string parse_colour(std::string_view text) {
    if (const auto colour = detail::css_colour(text)) return *colour;
    throw base::InputError("'" + std::string(text) +
                           "' is not a colour: expected one such as red, #f00 or rgb(255, 0, 0)");
}

struct ColouredDrawing::Impl {
    detail::ColouredPicture drawn;
};

ColouredDrawing::ColouredDrawing(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ColouredDrawing::ColouredDrawing(const std::filesystem::path& path)
    : ColouredDrawing(parse(base::read_text_file(path), path.string())) {}
ColouredDrawing ColouredDrawing::parse(std::string_view text, const std::string& source) {
    return base::with_source(source, [&] {
        return ColouredDrawing(std::make_unique<Impl>(Impl{detail::parse_svg_colours(text, source)}));
    });
}
ColouredDrawing::~ColouredDrawing() = default;
ColouredDrawing::ColouredDrawing(ColouredDrawing&&) noexcept = default;
ColouredDrawing& ColouredDrawing::operator=(ColouredDrawing&&) noexcept = default;

std::vector<std::string> ColouredDrawing::colours() const {
    std::vector<std::string> list;
    for (const std::string& colour : impl_->drawn.colours) {
        if (std::ranges::find(list, colour) == list.end()) list.push_back(colour);
    }
    return list;
}

std::optional<std::string> ColouredDrawing::colour_at(Point2 point) const {
    const Picture& picture = impl_->drawn.picture;
    for (std::size_t i = picture.shapes.size(); i-- > 0;) {
        if (detail::is_filled_at(picture.shapes[i], point) &&
            detail::is_shown_at(picture, picture.shapes[i].clip, point))
            return impl_->drawn.colours[i];
    }
    return std::nullopt;
}

}  // namespace fretwork::outlines
