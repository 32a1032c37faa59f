// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/exports/detail/binary_text.hpp>
#include <fretwork/exports/making/detail/millimetres.hpp>
#include <fretwork/exports/making/making_files.hpp>

#include <bit>
#include <cmath>
#include <cstdint>

namespace fretwork::exports {
namespace {

using fabrication::Solid;
using Vector = std::array<double, 3>;

void append_float(std::string& text, double value) {
    detail::append_bits(text, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

Vector normal(const Vector& a, const Vector& b, const Vector& c) {
    const Vector u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const Vector v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    Vector n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (double& component : n) component = length > 0.0 ? component / length : 0.0;
    return n;
}

/// A vertex as a reader of STL finds it: millimetres in 32 bits.
Vector in_file(const Solid& solid, int index) {
    Vector place = solid.vertices[index];
    for (double& coordinate : place) coordinate = static_cast<float>(1e3 * coordinate);
    return place;
}

}  // namespace

std::string solid_stl(const Solid& solid) {
    constexpr std::size_t kHeader = 80;
    std::string text = std::string(base::kMadeBy) + "; units: millimetres";
    text.resize(kHeader, ' ');
    text.reserve(kHeader + 4 + 50 * solid.triangles.size());
    detail::append_bits(text, static_cast<std::uint32_t>(solid.triangles.size()));
    for (const auto& [a, b, c] : solid.triangles) {
        const std::array<Vector, 3> corners = {in_file(solid, a), in_file(solid, b), in_file(solid, c)};
        for (const double component : normal(corners[0], corners[1], corners[2]))
            append_float(text, component);
        for (const Vector& corner : corners)
            for (const double coordinate : corner) append_float(text, coordinate);
        text.append(2, '\0');
    }
    return text;
}

std::string solid_obj(const Solid& solid) {
    std::string text = "# " + std::string(base::kMadeBy) + ": lengths in millimetres\n";
    for (const Vector& place : solid.vertices) {
        text += 'v';
        for (const double coordinate : place) {
            text += ' ';
            detail::append_millimetres(text, coordinate);
        }
        text += '\n';
    }
    for (const auto& triangle : solid.triangles) {
        text += 'f';
        for (const int corner : triangle) text += " " + std::to_string(corner + 1);
        text += '\n';
    }
    return text;
}

std::string solid_ply(const Solid& solid) {
    std::string text = "ply\nformat ascii 1.0\ncomment " + std::string(base::kMadeBy) +
                       ": lengths in millimetres\nelement vertex " + std::to_string(solid.vertices.size()) +
                       "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                       std::to_string(solid.triangles.size()) +
                       "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Vector& place : solid.vertices) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (i > 0) text += ' ';
            detail::append_millimetres(text, place[i]);
        }
        text += '\n';
    }
    for (const auto& triangle : solid.triangles) {
        text += '3';
        for (const int corner : triangle) text += " " + std::to_string(corner);
        text += '\n';
    }
    return text;
}

}  // namespace fretwork::exports
