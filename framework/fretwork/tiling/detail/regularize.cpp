// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/detail/plane.hpp>
#include <fretwork/tiling/detail/regularize.hpp>

#include <complex>
#include <numbers>

namespace fretwork::tiling::detail {
namespace {

using Complex = std::complex<double>;

/// exp(2 pi i k / count) for each k, made once for each count.
class RootsOfUnity {
  public:
    const std::vector<Complex>& of(std::size_t count) {
        if (roots_.size() <= count) roots_.resize(count + 1);
        std::vector<Complex>& roots = roots_[count];
        for (std::size_t k = roots.size(); k < count; ++k) {
            const double turns = static_cast<double>(k) / static_cast<double>(count);
            roots.push_back(std::polar(1.0, 2 * std::numbers::pi * turns));
        }
        return roots;
    }

  private:
    std::vector<std::vector<Complex>> roots_;
};

/// The regular polygon that is nearest to a polygon in the least-squares sense: its mean, and the first
/// Fourier coefficient of its vertices.
Polygon nearest_regular_polygon(const Polygon& polygon, const std::vector<Complex>& roots) {
    Complex mean;
    Complex first;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Complex place(polygon[i].x, polygon[i].y);
        mean += place;
        first += place * std::conj(roots[i]);
    }
    const double share = 1.0 / static_cast<double>(polygon.size());
    Polygon regular;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Complex place = share * (mean + first * roots[i]);
        regular.push_back({place.real(), place.imag()});
    }
    return regular;
}

}  // namespace

void regularize(Dual& dual, const Rim& rim, int iterations, Work& work) {
    work.advance(1);
    RootsOfUnity roots;
    for (int iteration = 0; iteration < iterations; ++iteration) {
        std::vector<Point2> sums(dual.vertices.size());
        std::vector<int> counts(dual.vertices.size());
        for (std::size_t cell = 0; cell < dual.cells.size(); ++cell) {
            work.check();
            const Polygon polygon = polygon_of(dual, cell);
            const Polygon wanted = nearest_regular_polygon(polygon, roots.of(polygon.size()));
            for (std::size_t i = 0; i < wanted.size(); ++i) {
                const auto vertex = static_cast<std::size_t>(dual.cells[cell][i]);
                sums[vertex] = sums[vertex] + wanted[i];
                ++counts[vertex];
            }
        }
        for (std::size_t v = 0; v < dual.vertices.size(); ++v) {
            work.check();
            DualVertex& vertex = dual.vertices[v];
            if (counts[v] == 0 || vertex.is_fixed) continue;
            vertex.place = (1.0 / counts[v]) * sums[v];
            if (vertex.loop >= 0)
                vertex.place = rim.curves[static_cast<std::size_t>(vertex.loop)].nearest(vertex.place);
        }
    }
}

}  // namespace fretwork::tiling::detail
