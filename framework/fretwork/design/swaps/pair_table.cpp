// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/design/swaps/pair_table.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace fretwork::design::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// All choices as a tree: the last group's column is chosen first. Each level has the responses of the groups
/// that are left, with the interactions with the chosen columns added. So a leaf costs one addition and one
/// norm.
class EveryChoice {
  public:
    EveryChoice(const PairTable& table, std::size_t count, const base::Control& control)
        : table_(table), count_(count), control_(control), columns_(table.swaps.groups(), 0) {
        unknowns_ = unknown_basis(table.swaps);
        for (const MatrixXd& own : table.crosses) crosses_.push_back(left_by_unknowns(unknowns_, own));
        levels_.resize(columns_.size() + 1);
        Level& top = levels_.back();
        top.residual = left_by_unknowns(unknowns_, table.swaps.residual);
        for (const MatrixXd& own : table.swaps.responses)
            top.responses.push_back(left_by_unknowns(unknowns_, own));
        for (std::size_t g = 0; g + 1 < levels_.size(); ++g) levels_[g].responses.resize(g);
    }

    std::vector<Choice> best() {
        descend(columns_.size());
        std::ranges::sort(kept_);
        std::vector<Choice> choices;
        for (auto& [objective, columns] : kept_) choices.push_back(finished(std::move(columns)));
        return choices;
    }

  private:
    /// The residual, and the responses of the groups below the level's index, if all others are chosen.
    struct Level {
        VectorXd residual;
        std::vector<MatrixXd> responses;
    };
    using Scored = std::pair<double, std::vector<std::size_t>>;

    void descend(std::size_t level) {
        const std::size_t group = level - 1;
        if (group == 0) return score_last();
        if (group > 1) control_.check();
        const auto columns = static_cast<Index>(table_.swaps.columns());
        const Level& own = levels_[level];
        Level& next = levels_[group];
        for (Index c = 0; c < columns; ++c) {
            columns_[group] = static_cast<std::size_t>(c);
            next.residual.noalias() = own.residual + own.responses[group].col(c);
            for (std::size_t g = 0; g < group; ++g)
                next.responses[g].noalias() =
                    own.responses[g] + crosses_[pair_place(g, group)].middleCols(columns * c, columns);
            descend(group);
        }
    }

    void score_last() {
        const Level& own = levels_[1];
        for (Index c = 0; c < own.responses.front().cols(); ++c) {
            const double objective = (own.residual + own.responses.front().col(c)).squaredNorm();
            if (objective >= worst_) continue;
            columns_.front() = static_cast<std::size_t>(c);
            keep(objective);
        }
    }

    /// Keeps the best choices in a heap with the worst in front. Equal choices are ordered by their columns.
    void keep(double objective) {
        kept_.emplace_back(objective, columns_);
        std::ranges::push_heap(kept_);
        if (kept_.size() > count_) {
            std::ranges::pop_heap(kept_);
            kept_.pop_back();
        }
        if (kept_.size() == count_) worst_ = kept_.front().first;
    }

    [[nodiscard]] Choice finished(std::vector<std::size_t> columns) const {
        const SwapTable& swaps = table_.swaps;
        VectorXd residual = swaps.residual;
        Choice choice{std::move(columns), {}, 0.0, 0.0, 0};
        for (std::size_t h = 0; h < choice.columns.size(); ++h) {
            const auto column = static_cast<Index>(choice.columns[h]);
            residual += swaps.responses[h].col(column);
            choice.energy += swaps.energies(column, static_cast<Index>(h));
            for (std::size_t g = 0; g < h; ++g)
                residual += table_.crosses[pair_place(g, h)].col(
                    static_cast<Index>(choice.columns[g] + swaps.columns() * choice.columns[h]));
        }
        choice.steps = best_steps(swaps, residual);
        if (choice.steps.size() > 0) residual += swaps.by_unknowns * choice.steps;
        choice.objective = swaps.unreached + residual.squaredNorm();
        return choice;
    }

    const PairTable& table_;
    std::size_t count_;
    const base::Control& control_;
    MatrixXd unknowns_;
    std::vector<MatrixXd> crosses_;
    std::vector<Level> levels_;
    std::vector<std::size_t> columns_;
    std::vector<Scored> kept_;
    double worst_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::size_t choice_count(std::size_t groups, std::size_t columns, std::size_t limit) {
    std::size_t count = 1;
    for (std::size_t g = 0; g < groups; ++g) {
        if (columns > 0 && count > limit / columns) return limit + 1;
        count *= columns;
    }
    return count;
}

std::vector<Choice> best_of_all(const PairTable& table, std::size_t count, const base::Control& control) {
    return EveryChoice(table, count, control).best();
}

}  // namespace fretwork::design::detail
