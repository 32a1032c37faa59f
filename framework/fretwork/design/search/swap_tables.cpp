// SPDX-License-Identifier: GPL-3.0-or-later
// The predicted effects of swaps at the last equilibrium.
#include <fretwork/base/parallel.hpp>
#include <fretwork/design/search/free_section.hpp>
#include <fretwork/design/search/trials.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace fretwork::design::detail {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The largest steps: of a factor, as a share of it; of a prescribed displacement, as a share of the largest
/// wanted one; of a prescribed rotation, in rad.
constexpr double kFactorStep = 0.5;
constexpr double kPrescribedStep = 0.25;
constexpr double kTurnStep = 0.25;
/// The largest step of a width or thickness, as a share of it, and the share for its finite differences.
constexpr double kSectionStep = 0.2;
constexpr double kSectionDifference = 1e-2;

Index rows_of(const std::vector<CaseModel>& models) {
    Index rows = 0;
    for (const CaseModel& model : models) rows += model.residual.size();
    return rows;
}

/// A table with the residuals of all cases, but without responses, energies and masses.
SwapTable residuals_of(const std::vector<CaseModel>& models) {
    SwapTable table;
    for (const CaseModel& model : models) {
        table.unreached += model.unreached;
        table.energy += model.energy;
    }
    table.residual.resize(rows_of(models));
    Index row = 0;
    for (const CaseModel& model : models) {
        table.residual.segment(row, model.residual.size()) = model.residual;
        row += model.residual.size();
    }
    return table;
}

/// The largest number of operations for a table of pairs. A larger one takes longer than the solutions that
/// it saves.
constexpr double kMostPairWork = 3e8;

}  // namespace

std::vector<CaseModel> Trials::models_at(const Trial& trial, const std::vector<std::size_t>& columns,
                                         std::uint64_t seed, Between between, const base::Control& control) {
    refresh_candidates(control);
    const SwapSample sample{.candidates = parts_.candidates,
                            .strains = strains_,
                            .painting = painted_,
                            .patterns = columns,
                            .seed = seed,
                            .threads = parts_.threads,
                            .between_tiles = between == Between::Tiles};
    std::vector<CaseModel> models;
    for (std::size_t c = 0; c < sessions_.size(); ++c) {
        const CaseState state{sessions_[c], parts_.cases[c].goals, trial.displacements[c], aims_[c],
                              scale_,       unit_loads_[c]};
        models.push_back(linearize_case(state, sample, control.silent()));
    }
    return models;
}

SwapTable Trials::table_of(const std::vector<CaseModel>& models, const Point& point,
                           const std::vector<std::size_t>& columns, const base::Control& control) const {
    SwapTable table = residuals_of(models);
    table.responses.resize(parts_.groups.size());
    table.energies.resize(std::ssize(columns), std::ssize(parts_.groups));
    table.masses.resizeLike(table.energies);
    base::parallel_for(parts_.groups.size(), parts_.threads, [&](std::size_t group) {
        control.check();
        fill_group(group, models, columns, table);
    });
    add_unknowns(models, point, table);
    return table;
}

SwapTable Trials::table(const Point& point, const Trial& trial, const std::vector<std::size_t>& columns,
                        std::uint64_t seed, const base::Control& control) {
    return table_of(models_at(trial, columns, seed, Between::Nothing, control), point, columns, control);
}

bool Trials::has_few_pairs(std::size_t columns) const {
    const auto strains = [&](std::size_t group) {
        double sum = 0.0;
        for (const TileGroup::Member& member : parts_.groups[group].members)
            sum += static_cast<double>(strains_.basis(parts_.candidates.class_of(member.tile)).cols());
        return sum;
    };
    double work = 0.0;
    for (std::size_t h = 0; h < parts_.groups.size(); ++h) {
        for (std::size_t g = 0; g < h; ++g) work += std::pow(strains(g) + strains(h), 3.0);
    }
    return work * static_cast<double>(columns * columns) <= kMostPairWork;
}

PairTable Trials::pair_table(const Point& point, const Trial& trial, const std::vector<std::size_t>& columns,
                             std::uint64_t seed, const base::Control& control) {
    const std::vector<CaseModel> models = models_at(trial, columns, seed, Between::Tiles, control);
    PairTable table{table_of(models, point, columns, control), {}};
    const std::size_t groups = parts_.groups.size();
    const std::size_t count = columns.size();
    table.crosses.resize(groups * (groups - 1) / 2);
    base::parallel_for(table.crosses.size(), parts_.threads, [&](std::size_t place) {
        std::size_t h = 1;
        while (pair_place(0, h + 1) <= place) ++h;
        const std::size_t g = place - pair_place(0, h);
        auto& crosses = table.crosses[place];
        crosses.resize(table.swaps.residual.size(), static_cast<Index>(count * count));
        for (std::size_t d = 0; d < count; ++d) {
            control.check();
            for (std::size_t c = 0; c < count; ++c)
                crosses.col(static_cast<Index>(c + count * d)) =
                    joint_response(models, {{g, columns[c]}, {h, columns[d]}}).residuals -
                    table.swaps.responses[g].col(static_cast<Index>(c)) -
                    table.swaps.responses[h].col(static_cast<Index>(d));
        }
    });
    return table;
}

std::vector<TileSwap> Trials::swaps_of(const Choices& choices) const {
    std::vector<TileSwap> swaps;
    for (const auto& [group, pattern] : choices) {
        for (const TileGroup::Member& member : parts_.groups[group].members) {
            const std::size_t old = painted_[static_cast<std::size_t>(member.tile.value)];
            const std::size_t wanted = member_pattern(member, pattern);
            if (wanted == old) continue;
            const std::size_t own = parts_.candidates.class_of(member.tile);
            swaps.push_back({member.tile, strains_.stiffness(own, old), strains_.stiffness(own, wanted),
                             parts_.candidates.mass(own, wanted) - parts_.candidates.mass(own, old)});
        }
    }
    return swaps;
}

JointAnswer Trials::joint_response(const std::vector<CaseModel>& models, const Choices& choices) const {
    const std::vector<TileSwap> swaps = swaps_of(choices);
    JointAnswer response{VectorXd(rows_of(models)), 0.0};
    Index row = 0;
    for (const CaseModel& model : models) {
        const JointAnswer own = joint_answer(model, swaps);
        response.residuals.segment(row, model.residual.size()) = own.residuals;
        response.energy += own.energy;
        row += model.residual.size();
    }
    return response;
}

JointAnswer Trials::added_response(const std::vector<CaseModel>& models, std::size_t group,
                                   std::size_t pattern) const {
    JointAnswer response{VectorXd::Zero(rows_of(models)), 0.0};
    for (const TileSwap& swap : swaps_of({{group, pattern}})) {
        Index row = 0;
        for (const CaseModel& model : models) {
            const CaseModel::Tile& tile = model.tiles[swap.tile];
            const SwapAnswer answer = swap_answer(tile, swap.from, swap.to);
            response.residuals.segment(row, model.residual.size()) +=
                tile.reach * answer.stress + swap.mass * tile.of_weight;
            response.energy += answer.energy;
            row += model.residual.size();
        }
    }
    return response;
}

void Trials::fill_group(std::size_t group, const std::vector<CaseModel>& models,
                        const std::vector<std::size_t>& columns, SwapTable& table) const {
    // Tiles of one group act on each other. Models with the coupling of tiles give their exact joint effect.
    const bool has_joint = models.front().flexibility.size() > 0;
    auto& responses = table.responses[group];
    responses.resize(table.residual.size(), std::ssize(columns));
    for (std::size_t c = 0; c < columns.size(); ++c) {
        const auto column = static_cast<Index>(c);
        const JointAnswer answer = has_joint ? joint_response(models, {{group, columns[c]}})
                                             : added_response(models, group, columns[c]);
        responses.col(column) = answer.residuals;
        table.energies(column, static_cast<Index>(group)) = answer.energy;
        table.masses(column, static_cast<Index>(group)) = group_mass(group, columns[c]);
    }
}

void Trials::add_unknowns(const std::vector<CaseModel>& models, const Point& point, SwapTable& table) const {
    table.by_unknowns.setZero(table.residual.size(), point.unknowns.size());
    table.largest_steps.resize(point.unknowns.size());
    Index row = 0;
    Index next = 0;
    for (std::size_t c = 0; c < models.size(); ++c) {
        const Index rows = models[c].residual.size();
        if (parts_.free.factor) {
            table.by_unknowns.col(next).segment(row, rows) = models[c].by_loads;
            table.largest_steps[next] = kFactorStep * std::abs(point.unknowns[next]);
            ++next;
        }
        const auto& entries = parts_.cases[c].load_case.prescribed;
        for (std::size_t e = 0; parts_.free.prescribed && e < entries.size(); ++e, ++next) {
            table.by_unknowns.col(next).segment(row, rows) =
                models[c].by_prescribed.col(static_cast<Index>(e));
            table.largest_steps[next] =
                static_cast<int>(entries[e].dof) < 3 ? kPrescribedStep * largest_ : kTurnStep;
        }
        row += rows;
    }
    if (parts_.free.width || parts_.free.thickness) add_section(models, point, table);
}

void Trials::add_section(const std::vector<CaseModel>& models, const Point& point, SwapTable& table) const {
    const double width = mechanics::rectangle_width(setting_.section);
    const double thickness = mechanics::rectangle_height(setting_.section);
    const auto add = [&](Index unknown, const auto& setting) {
        const double step = kSectionDifference * point.unknowns[unknown];
        const auto rates = simulation::rates_along(sessions_.front().surface(), setting, step);
        Index row = 0;
        for (const CaseModel& model : models) {
            table.by_unknowns.col(unknown).segment(row, model.residual.size()) =
                residuals_by(model, strains_, parts_.candidates, rates);
            row += model.residual.size();
        }
        table.largest_steps[unknown] = kSectionStep * point.unknowns[unknown];
    };
    Index next = first_of_section();
    if (parts_.free.width)
        add(next++, [&](double more) { return with_section(setting_, width + more, thickness); });
    if (parts_.free.thickness)
        add(next, [&](double more) { return with_section(setting_, width, thickness + more); });
}

}  // namespace fretwork::design::detail
