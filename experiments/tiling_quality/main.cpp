// SPDX-License-Identifier: GPL-3.0-or-later
// How regular the tilings of outlines are, inside and at the rim, and what they cost. See README.md.
#include <fretwork/base/error.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace fretwork;
using tiling::Tessellation;

/// Sides and angles of one kind of tiles.
struct Shapes {
    std::vector<double> sides;  // m
    double smallest_angle = std::numbers::pi;
    int tiles = 0;
    int hexagons = 0;

    [[nodiscard]] double spread() const {
        double sum = 0.0;
        double squares = 0.0;
        for (const double side : sides) {
            sum += side;
            squares += side * side;
        }
        const double count = static_cast<double>(sides.size());
        return count > 0 ? std::sqrt(std::max(0.0, squares * count / (sum * sum) - 1)) : 0.0;
    }
};

void add_tile(const geometry::Polygon& polygon, Shapes& shapes) {
    ++shapes.tiles;
    shapes.hexagons += polygon.size() == 6 ? 1 : 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto& a = polygon[i];
        const auto& b = polygon[(i + 1) % polygon.size()];
        const auto& c = polygon[(i + 2) % polygon.size()];
        shapes.sides.push_back(std::hypot(b.x - a.x, b.y - a.y));
        const double back = std::atan2(a.y - b.y, a.x - b.x);
        const double forth = std::atan2(c.y - b.y, c.x - b.x);
        shapes.smallest_angle =
            std::min(shapes.smallest_angle, std::abs(std::remainder(forth - back, 2 * std::numbers::pi)));
    }
}

/// The vertices of sides that only one tile has.
std::vector<bool> rim_vertices(const Tessellation& tessellation) {
    std::map<std::pair<int, int>, int> sides;
    for (const tiling::Tile& tile : tessellation.tiles) {
        for (std::size_t i = 0; i < tile.vertices.size(); ++i) {
            const int from = tile.vertices[i].value;
            const int to = tile.vertices[(i + 1) % tile.vertices.size()].value;
            ++sides[std::minmax(from, to)];
        }
    }
    std::vector<bool> is_at_rim(tessellation.vertices.size(), false);
    for (const auto& [ends, count] : sides) {
        if (count > 1) continue;
        is_at_rim[static_cast<std::size_t>(ends.first)] = true;
        is_at_rim[static_cast<std::size_t>(ends.second)] = true;
    }
    return is_at_rim;
}

void print_row(const std::string& name, const tiling::TessellationResult& result, double seconds) {
    const auto is_at_rim = rim_vertices(result.tessellation);
    Shapes rim;
    Shapes inside;
    for (std::size_t t = 0; t < result.tessellation.tiles.size(); ++t) {
        const auto& vertices = result.tessellation.tiles[t].vertices;
        const bool at_rim = std::ranges::any_of(
            vertices, [&](tiling::VertexIndex v) { return is_at_rim[static_cast<std::size_t>(v.value)]; });
        add_tile(tiling::tile_polygon(result.tessellation, tiling::TileIndex(t)), at_rim ? rim : inside);
    }
    const auto degrees = [](double angle) { return angle * 180 / std::numbers::pi; };
    const auto share = [](int some, int all) { return all > 0 ? 100.0 * some / all : 0.0; };
    const tiling::TessellationReport& report = result.report;
    std::printf("%s,%d,%.1f,%.1f,%.3f,%.3f,%.3f,%.1f,%.1f,%.2f,%.2f,%.1f,%.3f\n", name.c_str(), report.tiles,
                share(inside.hexagons, inside.tiles), share(rim.hexagons, rim.tiles), inside.spread(),
                rim.spread(), report.smallest_side / report.mean_side, degrees(inside.smallest_angle),
                degrees(rim.smallest_angle), 100 * report.covered_share, 100 * report.outside_share,
                100 * report.refined_share, seconds);
}

double cpu_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void run(const std::vector<std::string>& files, double edge_length) {
    const auto layout = pattern::find_node_layout("paper7");
    std::printf(
        "outline,tiles,hexagons_inside,hexagons_rim,spread_inside,spread_rim,smallest_over_mean,"
        "angle_inside,angle_rim,covered,outside,refined,cpu_seconds\n");
    int tiled = 0;
    for (const std::string& file : files) {
        const std::string name = std::filesystem::path(file).stem().string();
        const double before = cpu_seconds();
        try {
            const auto result =
                tiling::tessellate(outlines::read_outline(file), layout, {.edge_length = edge_length});
            print_row(name, result, cpu_seconds() - before);
            ++tiled;
        } catch (const base::Error& error) {
            std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
        }
        std::fflush(stdout);
    }
    std::fprintf(stderr, "%d of %zu outlines tiled\n", tiled, files.size());
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("How regular the tilings of outlines are");
    std::vector<std::string> files;
    double edge_length = 0.026;
    app.add_option("outlines", files, "Outline files")->required();
    app.add_option("--edge-length", edge_length, "Wanted mean side, m")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    run(files, edge_length);
    return 0;
}
