// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/box.hpp>
#include <fretwork/geometry/plane.hpp>

#include <algorithm>

namespace fretwork::geometry {

double Box::diagonal() const {
    return length({width(), height()});
}

Box box_of(std::span<const Point2> points) {
    Box box{points.front().x, points.front().y, points.front().x, points.front().y};
    for (const Point2& point : points) box = united(box, point);
    return box;
}

Box united(const Box& box, Point2 point) {
    return {std::min(box.xmin, point.x), std::min(box.ymin, point.y), std::max(box.xmax, point.x),
            std::max(box.ymax, point.y)};
}

Box united(const Box& left, const Box& right) {
    return {std::min(left.xmin, right.xmin), std::min(left.ymin, right.ymin), std::max(left.xmax, right.xmax),
            std::max(left.ymax, right.ymax)};
}

Box grown(const Box& box, double margin) {
    return {box.xmin - margin, box.ymin - margin, box.xmax + margin, box.ymax + margin};
}

}  // namespace fretwork::geometry
