// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/mechanics/results/section_stress.hpp>
#include <fretwork/simulation/derivatives/smooth_stress.hpp>
#include <fretwork/simulation/detail/joined_tiles.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace fretwork::simulation {
namespace {

using mechanics::kDofsPerNode;
using mechanics::NodeValues;
using mechanics::SectionForces;
using PowerSum = mechanics::SectionPoints::PowerSum;
using tiling::TileIndex;

/// The matrix from the displacements of both ends to their section forces.
using ForceMatrix = Eigen::Matrix<double, 2 * kDofsPerNode, 2 * kDofsPerNode>;
ForceMatrix force_matrix(const mechanics::BeamSection& section) {
    ForceMatrix matrix;
    for (Eigen::Index i = 0; i < matrix.cols(); ++i) {
        const Eigen::Vector<double, 2 * kDofsPerNode> unit = ForceMatrix::Identity().col(i);
        const auto ends = section.linear(unit.head<kDofsPerNode>(), unit.tail<kDofsPerNode>());
        Eigen::Index row = 0;
        for (const SectionForces& f : ends) {
            matrix.col(i).segment<kDofsPerNode>(row) << f.N, f.V2, f.V3, f.T, f.M2, f.M3;
            row += kDofsPerNode;
        }
    }
    return matrix;
}

/// The p-norm over all beams: the power sums of their ends, two for each beam.
struct PowerNorm {
    double largest = 0.0;  ///< Pa
    double sum = 0.0;
    std::vector<PowerSum> ends;
    [[nodiscard]] double value(double exponent) const { return largest * std::pow(sum, 1.0 / exponent); }
};

PowerNorm power_norm(const BeamState& state, const mechanics::Section& section,
                     const SmoothStressOptions& options) {
    if (state.forces.hasNaN())
        throw base::InputError(
            "the stress of a surface is known where the models of all tiles give the "
            "motions of their beams");
    PowerNorm norm;
    if (state.forces.rows() > 0) norm.largest = state.forces.col(kVonMisesField).maxCoeff();
    norm.ends.resize(static_cast<std::size_t>(state.forces.rows()));
    if (norm.largest == 0.0) return norm;
    const mechanics::SectionPoints points(section);
    base::parallel_for(norm.ends.size(), options.threads, [&](std::size_t end) {
        const auto row = state.forces.row(static_cast<Eigen::Index>(end));
        norm.ends[end] = points.power_sum({row[0], row[1], row[2], row[3], row[4], row[5]},
                                          {.reference = norm.largest, .exponent = options.exponent});
    });
    for (const PowerSum& end : norm.ends) norm.sum += end.value;
    return norm;
}

/// The gradient of the sum of a norm, tile by tile.
class TileGradients {
  public:
    TileGradients(const Session& session, const mechanics::Solution& solution, const SurfaceBeams& beams,
                  std::span<const mechanics::BeamSection> sections, const PowerNorm& norm)
        : session_(session), solution_(solution), beams_(beams), sections_(sections), norm_(norm) {}

    /// The gradient with respect to the interface nodes.
    [[nodiscard]] NodeValues of(TileIndex tile) const {
        const auto gradient = session_.motion_gradient(tile, solution_, by_beams(tile));
        if (!gradient)
            throw base::InputError(
                "the derivatives of stress are known of condensed and corotational tiles; "
                "tile " +
                std::to_string(tile.value) + " has another model");
        return *gradient;
    }

  private:
    /// The gradient with respect to the motions of the tile's beams.
    [[nodiscard]] NodeValues by_beams(TileIndex tile) const {
        const std::size_t t = tile;
        const auto& tessellation = session_.surface().tessellation;
        const auto& interface_nodes = tessellation.tiles[tile].interface_nodes;
        const detail::TileRows row_of(interface_nodes, {beams_.interface_nodes, beams_.starts[t].inner_node});
        const std::size_t nodes =
            interface_nodes.size() + beams_.starts[t + 1].inner_node - beams_.starts[t].inner_node;
        NodeValues gradient = NodeValues::Zero(static_cast<Eigen::Index>(nodes), kDofsPerNode);
        for (std::size_t b = beams_.starts[t].beam; b < beams_.starts[t + 1].beam; ++b) {
            Eigen::RowVector<double, 2 * kDofsPerNode> by_forces;
            by_forces << norm_.ends[2 * b].gradient.transpose(), norm_.ends[2 * b + 1].gradient.transpose();
            const Eigen::RowVector<double, 2 * kDofsPerNode> by_ends = by_forces * force_matrix(sections_[b]);
            gradient.row(row_of(beams_.ends[b][0])) += by_ends.head<kDofsPerNode>();
            gradient.row(row_of(beams_.ends[b][1])) += by_ends.tail<kDofsPerNode>();
        }
        return gradient;
    }

    const Session& session_;
    const mechanics::Solution& solution_;
    const SurfaceBeams& beams_;
    std::span<const mechanics::BeamSection> sections_;
    const PowerNorm& norm_;
};

NodeValues gradient_of_sum(const Session& session, const TileGradients& tiles, Eigen::Index rows,
                           int threads) {
    const auto& all = session.surface().tessellation.tiles;
    std::vector<NodeValues> own(all.size());
    base::parallel_for(all.size(), threads, [&](std::size_t t) {
        if (all[t].pattern >= 0) own[t] = tiles.of(TileIndex(t));
    });
    NodeValues sum = NodeValues::Zero(rows, kDofsPerNode);
    for (std::size_t t = 0; t < all.size(); ++t) {
        for (Eigen::Index i = 0; i < own[t].rows(); ++i)
            sum.row(all[t].interface_nodes[static_cast<std::size_t>(i)].value) += own[t].row(i);
    }
    return sum;
}

}  // namespace

void SmoothStressOptions::validate() const {
    if (!(exponent >= 2.0 && std::isfinite(exponent)))
        throw base::InputError("the exponent of a smooth stress is 2 or more, not " +
                               std::to_string(exponent));
}

SmoothStress smooth_stress(const Session& session, const mechanics::Solution& solution,
                           const SmoothStressOptions& options) {
    options.validate();
    const Surface& surface = session.surface();
    const SurfaceBeams beams = surface_beams(surface);
    const auto sections = beam_sections(beams, surface.setting);
    const PowerNorm norm =
        power_norm(beam_state(session, solution, beams, sections), surface.setting.section, options);
    SmoothStress stress{.value = norm.value(options.exponent), .largest = norm.largest, .gradient = {}};
    const TileGradients tiles(session, solution, beams, sections, norm);
    stress.gradient = gradient_of_sum(session, tiles, solution.displacements.rows(), options.threads);
    // The stresses in the sum are relative to the largest one. It cancels in `value`, so the gradient takes
    // it as a constant.
    if (norm.sum > 0.0) stress.gradient *= stress.value / (options.exponent * norm.sum);
    return stress;
}

double smooth_stress_along(const Session& session, const SurfaceResult& result, const SettingCurve& curve,
                           const SmoothStressOptions& options) {
    options.validate();
    SurfaceResult still = result;
    still.subject = result_subject(session.surface(), session.load_case(), session.options());
    Surface surface = session.surface();
    const SurfaceBeams beams = surface_beams(surface);
    const auto value = [&](double at) {
        surface.setting = curve.setting(at);
        const auto sections = beam_sections(beams, surface.setting);
        const BeamState state = beam_state(surface, still, beams, sections, session.options().models);
        return power_norm(state, surface.setting.section, options).value(options.exponent);
    };
    const double h = curve.step;
    return (8.0 * (value(h) - value(-h)) - (value(2.0 * h) - value(-2.0 * h))) / (12.0 * h);
}

}  // namespace fretwork::simulation
