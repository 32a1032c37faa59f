// SPDX-License-Identifier: GPL-3.0-or-later
#include "symmetric_stiffness.hpp"

#include <fretwork/reduction/models/condensed_tile.hpp>
#include <fretwork/reduction/response.hpp>

#include <Eigen/QR>

#include <cmath>
#include <numbers>

namespace fretwork::tile_models {
namespace {

using Complex = std::complex<double>;
using Basis = Eigen::Matrix<Complex, 3, Eigen::Dynamic, 0, 3, 3>;
using Factor = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;
using Plane = SymmetricStiffness::Plane;
using Kind = SymmetricStiffness::Kind;
constexpr int kHarmonics = 4;

std::size_t index(Plane plane) {
    return static_cast<std::size_t>(plane);
}

/// One of the eight blocks, and where its parameters begin.
struct BlockPlace {
    Plane plane;
    int harmonic;
    int first;
    [[nodiscard]] int size() const { return harmonic < 2 ? 2 : 3; }
    [[nodiscard]] bool is_real() const { return harmonic == 0 || harmonic == 3; }
    [[nodiscard]] int couplings() const { return size() * (size() - 1) / 2; }
    [[nodiscard]] int count() const { return size() + couplings() * (is_real() ? 1 : 2); }
};

std::vector<BlockPlace> make_places() {
    std::vector<BlockPlace> places;
    int first = 0;
    for (const Plane plane : {Plane::Membrane, Plane::Bending}) {
        for (int m = 0; m < kHarmonics; ++m) {
            places.push_back({plane, m, first});
            first += places.back().count();
        }
    }
    return places;
}

const std::vector<BlockPlace>& places() {
    static const std::vector<BlockPlace> table = make_places();
    return table;
}

/// The part of a harmonic that is not rigid, orthonormal. A turn in the plane is (0, 1, 1) in m = 0, a shift
/// (1, i, 0) in m = 1; out of the plane a shift is (1, 0, 0) in m = 0, a turn (-i, 1, i) in m = 1.
Basis basis_of(Plane plane, int harmonic) {
    constexpr Complex i(0.0, 1.0);
    const double half = std::sqrt(0.5);
    Basis basis = Basis::Identity(3, harmonic < 2 ? 2 : 3);
    if (harmonic == 0 && plane == Plane::Membrane) basis.col(1) << 0.0, half, -half;
    if (harmonic == 1 && plane == Plane::Membrane) basis << half, 0.0, -half * i, 0.0, 0.0, 1.0;
    if (harmonic == 0 && plane == Plane::Bending) basis << 0.0, 0.0, 1.0, 0.0, 0.0, 1.0;
    if (harmonic == 1 && plane == Plane::Bending) {
        basis.col(0) << half, 0.0, half;
        basis.col(1) << 1.0, -2.0 * i, -1.0;
        basis.col(1) /= std::sqrt(6.0);
    }
    return basis;
}

/// The factors L and D of a block.
struct Factors {
    Factor L;
    Eigen::VectorXd D;
};

/// The place of the coupling (row, column) among those of its block, row by row.
int coupling_index(int row, int column) {
    return row * (row - 1) / 2 + column;
}

Factors factors_of(const BlockPlace& place, std::span<const double> values) {
    const int n = place.size();
    const auto own = values.subspan(static_cast<std::size_t>(place.first));
    Factors result{Factor::Identity(n, n), Eigen::VectorXd(n)};
    for (int i = 0; i < n; ++i) result.D[i] = own[static_cast<std::size_t>(i)];
    for (int i = 1; i < n; ++i) {
        for (int j = 0; j < i; ++j) {
            const auto at = static_cast<std::size_t>(n + coupling_index(i, j));
            const auto couplings = static_cast<std::size_t>(place.couplings());
            result.L(i, j) = Complex(own[at], place.is_real() ? 0.0 : own[at + couplings]);
        }
    }
    return result;
}

Eigen::Matrix3cd in_basis(const BlockPlace& place, const Factor& inner) {
    const Basis V = basis_of(place.plane, place.harmonic);
    return V * inner * V.adjoint();
}

double area_of(const geometry::Polygon& polygon) {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto& a = polygon[i];
        const auto& b = polygon[(i + 1) % polygon.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return twice / 2.0;
}

/// The centroid-to-side distance of the regular polygon of as many sides and the same area.
double size_of(const geometry::Polygon& polygon) {
    const auto n = static_cast<double>(polygon.size());
    return std::sqrt(area_of(polygon) / (n * std::tan(std::numbers::pi / n)));
}

double reference_size(const reduction::Setting& setting) {
    return size_of(geometry::regular_polygon(setting.sides, setting.tile_side));
}

/// A node's three components of a plane, by its six.
Eigen::Matrix<double, 3, 6> node_axes(Plane plane, double angle, double h) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    Eigen::Matrix<double, 3, 6> axes = Eigen::Matrix<double, 3, 6>::Zero();
    if (plane == Plane::Membrane) {
        axes.block<2, 2>(0, 0) << c, s, -s, c;
        axes(2, 5) = h;
    } else {
        axes(0, 2) = 1.0;
        axes.block<2, 2>(1, 3) << h * c, h * s, -h * s, h * c;
    }
    return axes;
}

/// The six rigid motions of nodes at these places.
Eigen::MatrixXd rigid_motions(const std::vector<Eigen::Vector2d>& nodes) {
    Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(6 * nodes.size()), 6);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const double x = nodes[i].x();
        const double y = nodes[i].y();
        auto rows = motions.middleRows<6>(static_cast<Eigen::Index>(6 * i));
        rows.setIdentity();
        rows(2, 3) = y;  // a turn about x lifts what lies at y
        rows(2, 4) = -x;
        rows(0, 5) = -y;
        rows(1, 5) = x;
    }
    return motions;
}

}  // namespace

const std::vector<SymmetricStiffness::Parameter>& SymmetricStiffness::parameters() {
    static const std::vector<Parameter> table = [] {
        std::vector<Parameter> rows;
        for (const BlockPlace& place : places()) {
            const std::string block = (place.plane == Plane::Membrane ? "membrane" : "bending") +
                                      std::to_string(place.harmonic) + "_";
            const auto pivot = [&](int i) { return place.first + i - 1; };
            for (int i = 1; i <= place.size(); ++i)
                rows.push_back({block + "d" + std::to_string(i), Kind::Pivot, {pivot(i), pivot(i)}});
            for (const char* part : {"re", "im"}) {
                if (place.is_real() && part[0] == 'i') continue;
                for (int i = 2; i <= place.size(); ++i) {
                    for (int j = 1; j < i; ++j)
                        rows.push_back({block + part + std::to_string(i) + std::to_string(j),
                                        Kind::Coupling,
                                        {pivot(i), pivot(j)}});
                }
            }
        }
        return rows;
    }();
    return table;
}

SymmetricStiffness::SymmetricStiffness(const geometry::Polygon& polygon, double size)
    : sides_(static_cast<int>(polygon.size())), scale_(std::pow(size / size_of(polygon), 3)) {
    const double h = size_of(polygon);
    const geometry::Point2 center = geometry::centroid(polygon);
    std::vector<Eigen::Vector2d> nodes;
    for (Eigen::MatrixXd& strains : strains_) strains = Eigen::MatrixXd::Zero(3 * sides_, 6 * sides_);
    for (int i = 0; i < sides_; ++i) {
        const auto& a = polygon[static_cast<std::size_t>(i)];
        const auto& b = polygon[static_cast<std::size_t>((i + 1) % sides_)];
        nodes.emplace_back((a.x + b.x) / 2 - center.x, (a.y + b.y) / 2 - center.y);
        const double normal = std::atan2(-(b.x - a.x), b.y - a.y);
        for (const Plane plane : {Plane::Membrane, Plane::Bending})
            strains_[index(plane)].block<3, 6>(3 * i, 6 * i) = node_axes(plane, normal, h);
    }
    for (Eigen::MatrixXd& strains : strains_) {
        const Eigen::MatrixXd rigid = strains * rigid_motions(nodes);
        strains -= rigid * rigid.completeOrthogonalDecomposition().solve(strains);
    }
}

void SymmetricStiffness::add_circulant(Plane plane, std::span<const Block> harmonics,
                                       Eigen::MatrixXd& sum) const {
    std::vector<Eigen::Matrix3d> by_distance(static_cast<std::size_t>(sides_), Eigen::Matrix3d::Zero());
    for (int d = 0; d < sides_; ++d) {
        for (int m = 0; m < sides_; ++m) {
            const int own = std::min(m, sides_ - m);
            const Block& block = harmonics[static_cast<std::size_t>(std::min(own, kHarmonics - 1))];
            const Complex phase = std::polar(1.0, 2.0 * std::numbers::pi * m * d / sides_);
            const Block turned = (own == m ? block : Block(block.conjugate())) * phase;
            by_distance[static_cast<std::size_t>(d)] += turned.real() / sides_;
        }
    }
    Eigen::MatrixXd circulant(3 * sides_, 3 * sides_);
    for (int i = 0; i < sides_; ++i) {
        for (int j = 0; j < sides_; ++j)
            circulant.block<3, 3>(3 * i, 3 * j) =
                by_distance[static_cast<std::size_t>((i - j + sides_) % sides_)];
    }
    const Eigen::MatrixXd& strains = strains_[index(plane)];
    const Eigen::MatrixXd stiffness = strains.transpose() * circulant * strains;
    sum += scale_ * 0.5 * (stiffness + stiffness.transpose());
}

Eigen::MatrixXd SymmetricStiffness::stiffness(std::span<const double> values) const {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(6 * sides_, 6 * sides_);
    std::array<std::array<Block, kHarmonics>, 2> blocks;
    for (const BlockPlace& place : places()) {
        const Factors factors = factors_of(place, values);
        blocks[index(place.plane)][static_cast<std::size_t>(place.harmonic)] =
            in_basis(place, factors.L * factors.D.asDiagonal() * factors.L.adjoint());
    }
    for (const Plane plane : {Plane::Membrane, Plane::Bending})
        add_circulant(plane, blocks[index(plane)], sum);
    return sum;
}

std::vector<double> SymmetricStiffness::values_of(const Eigen::MatrixXd& stiffness) const {
    std::vector<double> values(kParameters, 0.0);
    for (const BlockPlace& place : places()) {
        const Basis V = basis_of(place.plane, place.harmonic);
        // Amplitudes of the harmonic's motions that are not rigid, as motions of the nodes.
        Eigen::MatrixXcd motions(3 * sides_, place.size());
        for (int i = 0; i < sides_; ++i) {
            const Complex phase =
                std::polar(1.0 / std::sqrt(sides_), 2.0 * std::numbers::pi * place.harmonic * i / sides_);
            motions.middleRows<3>(3 * i) = phase * V;
        }
        const Eigen::MatrixXd& strains = strains_[index(place.plane)];
        const Eigen::MatrixXcd nodes =
            strains.completeOrthogonalDecomposition().pseudoInverse().cast<Complex>() * motions;
        Factor block = nodes.adjoint() * stiffness.cast<Complex>() * nodes / scale_;
        for (int j = 0; j < place.size(); ++j) {
            const double pivot = block(j, j).real();
            values[static_cast<std::size_t>(place.first + j)] = pivot;
            const Factor column = block.col(j) / pivot;
            for (int i = j + 1; i < place.size(); ++i) {
                const auto at = static_cast<std::size_t>(place.first + place.size() + coupling_index(i, j));
                values[at] = column(i).real();
                if (!place.is_real())
                    values[at + static_cast<std::size_t>(place.couplings())] = column(i).imag();
            }
            block -= pivot * column * column.adjoint();
        }
    }
    return values;
}

reduction::TileModel symmetric_stiffness_model(const std::vector<double>& around) {
    reduction::TileModel model;
    model.name = "symmetric_stiffness";
    model.summary = "any stiffness with the hexagon's symmetry: 44 parameters, calibrated; linear";
    model.sharing = reduction::Sharing::Congruent;
    for (std::size_t k = 0; k < SymmetricStiffness::parameters().size(); ++k) {
        const SymmetricStiffness::Parameter& parameter = SymmetricStiffness::parameters()[k];
        const bool is_pivot = parameter.kind == Kind::Pivot;
        reduction::TileParameter::Bounds bounds;
        if (!around.empty()) {
            const auto pivot = [&](int i) {
                return around[static_cast<std::size_t>(parameter.pivots[static_cast<std::size_t>(i)])];
            };
            const double reach = 0.3 * std::sqrt(pivot(0) / pivot(1));
            bounds = is_pivot ? reduction::TileParameter::Bounds{around[k] / 3.0, around[k] * 3.0}
                              : reduction::TileParameter::Bounds{around[k] - reach, around[k] + reach};
        }
        model.parameters.push_back({parameter.name, is_pivot ? "N/m" : "1",
                                    is_pivot ? reduction::TileParameter::Scale::Logarithmic
                                             : reduction::TileParameter::Scale::Linear,
                                    [bounds](const reduction::Setting&) { return bounds; }});
    }
    model.build = [](const reduction::TileInput& input) {
        return reduction::stiffness_tile(
            SymmetricStiffness(input.polygon, reference_size(input.setting)).stiffness(input.parameters));
    };
    return model;
}

std::vector<double> condensed_values(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                                     const reduction::Setting& setting) {
    const auto polygon = geometry::regular_polygon(setting.sides, setting.tile_side);
    const auto frame =
        reduction::pattern_frame(layout, pattern, polygon, {setting.section, setting.material});
    return SymmetricStiffness(polygon, reference_size(setting))
        .values_of(reduction::condensed_frame(frame, setting.sides));
}

}  // namespace fretwork::tile_models
