// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/parallel.hpp>
#include <fretwork/simulation/derivatives/candidate_tiles.hpp>
#include <fretwork/simulation/detail/condensed_pattern.hpp>
#include <fretwork/simulation/detail/own_axes.hpp>

#include <map>
#include <utility>

namespace fretwork::simulation {
namespace {

Eigen::Index packed_size(Eigen::Index size) {
    return size * (size + 1) / 2;
}

void pack(const Eigen::MatrixXd& matrix, Eigen::Ref<Eigen::VectorXd> packed) {
    Eigen::Index next = 0;
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
        const Eigen::Index rows = matrix.rows() - j;
        packed.segment(next, rows) = matrix.col(j).tail(rows);
        next += rows;
    }
}

}  // namespace

CandidateTiles::CandidateTiles(const Surface& surface, std::vector<pattern::NamedPattern> patterns,
                               const Options& options)
    : patterns_(std::move(patterns)) {
    const double grid = detail::congruence_grid(surface.tessellation);
    std::map<std::string, std::size_t> known;
    std::vector<geometry::Polygon> polygons;
    for (const tiling::TileIndex tile : surface.tessellation.tiles.indices()) {
        detail::TilePolygon own = detail::tile_polygon_of(surface, tile, grid);
        const auto [entry, is_new] = known.try_emplace(std::move(own.key), polygons.size());
        if (is_new) polygons.push_back(std::move(own.polygon));
        class_of_.push_back(entry->second);
    }
    classes_.resize(polygons.size());
    const std::size_t count = patterns_.size();
    for (Class& each : classes_) each.masses.resize(count);
    std::vector<Eigen::MatrixXd> stiffness(count * polygons.size());
    base::parallel_for(stiffness.size(), options.threads, [&](std::size_t i) {
        options.control.check();
        auto condensed = detail::condensed_pattern(surface.layout, patterns_[i % count].pattern,
                                                   polygons[i / count], surface.setting);
        classes_[i / count].masses[i % count] = condensed.mass;
        stiffness[i].resize(packed_size(condensed.stiffness.rows()), 1);
        pack(condensed.stiffness, stiffness[i].col(0));
        if (i % count != 0) return;
        classes_[i / count].size = condensed.stiffness.rows();
        classes_[i / count].interface_nodes = std::move(condensed.interface_nodes);
    });
    for (std::size_t c = 0; c < classes_.size(); ++c) {
        classes_[c].packed.resize(packed_size(classes_[c].size), static_cast<Eigen::Index>(count));
        for (std::size_t p = 0; p < count; ++p) {
            classes_[c].packed.col(static_cast<Eigen::Index>(p)) = stiffness[c * count + p];
            stiffness[c * count + p].resize(0, 0);
        }
    }
}

Eigen::MatrixXd CandidateTiles::stiffness(std::size_t tile_class, std::size_t pattern) const {
    const Class& own = classes_[tile_class];
    Eigen::MatrixXd result(own.size, own.size);
    const double* next = own.packed.data() + static_cast<Eigen::Index>(pattern) * own.packed.rows();
    for (Eigen::Index j = 0; j < own.size; ++j) {
        for (Eigen::Index i = j; i < own.size; ++i, ++next) result(i, j) = result(j, i) = *next;
    }
    return result;
}

Eigen::VectorXd CandidateTiles::pack_form(const Eigen::VectorXd& a, const Eigen::VectorXd& e) {
    Eigen::VectorXd form(packed_size(a.size()));
    Eigen::Index next = 0;
    for (Eigen::Index j = 0; j < a.size(); ++j) {
        form[next++] = a[j] * e[j];
        for (Eigen::Index i = j + 1; i < a.size(); ++i) form[next++] = a[i] * e[j] + a[j] * e[i];
    }
    return form;
}

}  // namespace fretwork::simulation
