// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/fabrication/detail/fillets.hpp>
#include <fretwork/geometry/plane.hpp>

#include <vector>

namespace fretwork::fabrication::detail {
namespace {

using geometry::Point2;

/// A corner between two lines, and the part of both that its arc takes.
struct Corner {
    double turn = 0.0;   ///< rad, to the right; 0: no fillet
    double taken = 0.0;  ///< m
};

class Filleting {
  public:
    explicit Filleting(const Contour& contour) : contour_(contour) {}

    [[nodiscard]] Contour run(double radius) const {
        std::vector<Corner> corners;
        for (std::size_t i = 0; i < contour_.size(); ++i) {
            const double turn = right_turn(i);
            corners.push_back({turn, turn > 0.0 ? radius * std::tan(0.5 * turn) : 0.0});
        }
        std::vector<double> shares(corners.size(), 1.0);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::size_t j = after(i);
            const double wanted = corners[i].taken + corners[j].taken;
            if (wanted <= 0.0) continue;
            const double share = distance(place(i), place(j)) / wanted;
            shares[i] = std::min(shares[i], share);
            shares[j] = std::min(shares[j], share);
        }
        Contour rounded;
        for (std::size_t i = 0; i < corners.size(); ++i)
            add(rounded, i, {corners[i].turn, corners[i].taken * shares[i]});
        return rounded;
    }

  private:
    [[nodiscard]] std::size_t after(std::size_t i) const { return (i + 1) % contour_.size(); }
    [[nodiscard]] std::size_t before(std::size_t i) const {
        return (i + contour_.size() - 1) % contour_.size();
    }
    [[nodiscard]] const Point2& place(std::size_t i) const { return contour_[i].place; }
    [[nodiscard]] double right_turn(std::size_t i) const {
        if (contour_[i].bulge != 0.0 || contour_[before(i)].bulge != 0.0) return 0.0;
        const Point2 in = place(i) - place(before(i));
        const Point2 out = place(after(i)) - place(i);
        const double turn = -geometry::turn(in, out);
        return turn > kLeastCornerTurn ? turn : 0.0;
    }
    void add(Contour& rounded, std::size_t i, const Corner& corner) const {
        if (corner.turn == 0.0) {
            rounded.push_back(contour_[i]);
            return;
        }
        const Point2 from = place(i) + corner.taken * unit(place(before(i)) - place(i));
        const Point2 to = place(i) + corner.taken * unit(place(after(i)) - place(i));
        constexpr double kSamePoint = 1e-9;  // m: two arcs that leave nothing of the line between them
        if (!rounded.empty() && distance(rounded.back().place, from) < kSamePoint) rounded.pop_back();
        rounded.push_back({from, -std::tan(0.25 * corner.turn)});
        rounded.push_back({to, 0.0});
    }

    const Contour& contour_;
};

}  // namespace

Contour with_fillets(const Contour& contour, double radius) {
    if (!(radius > 0.0)) return contour;
    Contour rounded = Filleting(contour).run(radius);
    if (rounded.size() > 1 && distance(rounded.back().place, rounded.front().place) < 1e-9)
        rounded.pop_back();
    return rounded;
}

}  // namespace fretwork::fabrication::detail
