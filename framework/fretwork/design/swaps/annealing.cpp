// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>
#include <fretwork/design/swaps/annealing.hpp>

#include <cmath>

namespace fretwork::design::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The first temperature, as a share of the objective at the start, and the last temperature, as a share of
/// the first.
constexpr double kFirstTemperature = 0.1;
constexpr double kTemperatureDrop = 1e-3;
/// Proposals at one temperature.
constexpr long kPlateau = 256;
/// The largest cost that may be accepted, in temperatures.
constexpr double kCertainRefusal = 40.0;

/// The state of the annealing. Let r be the residuals, and v the responses of a group's columns. A change of
/// the group's column from o to c adds 2 r . (v_c - v_o) + |v_c - v_o|^2 to the objective. The products of
/// all v are computed once.
class Annealing {
  public:
    Annealing(const SwapTable& table, const MatrixXd& unknowns, const AnnealingOptions& options)
        : table_(table),
          unknowns_(unknowns),
          most_energy_(options.most_energy),
          columns_(options.start.columns),
          energy_(options.start.energy),
          random_(options.seed),
          known_(columns_.size()) {
        for (std::size_t c = 0; c < options.allowed.size(); ++c) {
            if (options.allowed[c]) choices_.push_back(c);
        }
        residual_ = left_by_unknowns(unknowns_, table.residual);
        for (std::size_t g = 0; g < columns_.size(); ++g) {
            if (unknowns.cols() > 0) projected_.push_back(left_by_unknowns(unknowns_, table.responses[g]));
            residual_ += answers(g).col(static_cast<Index>(columns_[g]));
            products_.emplace_back(answers(g).transpose() * answers(g));
        }
        objective_ = residual_.squaredNorm();
    }

    void propose(double temperature) {
        const std::size_t group = random_.below(columns_.size());
        const std::size_t column = choices_[random_.below(choices_.size())];
        const std::size_t old = columns_[group];
        const double energy = energy_ + energy_of(group, column) - energy_of(group, old);
        if (column == old || energy > most_energy_) return;
        ++scored_;
        const double more = cost(group, static_cast<Index>(column), static_cast<Index>(old));
        if (more > kCertainRefusal * temperature) return;
        if (more > 0.0 && random_.share() >= std::exp(-more / temperature)) return;
        residual_ +=
            answers(group).col(static_cast<Index>(column)) - answers(group).col(static_cast<Index>(old));
        ++version_;
        columns_[group] = column;
        energy_ = energy;
        objective_ += more;
    }

    [[nodiscard]] const std::vector<std::size_t>& columns() const { return columns_; }
    [[nodiscard]] double objective() const { return objective_; }
    [[nodiscard]] long scored() const { return scored_; }

  private:
    [[nodiscard]] const MatrixXd& answers(std::size_t group) const {
        return projected_.empty() ? table_.responses[group] : projected_[group];
    }
    [[nodiscard]] double energy_of(std::size_t group, std::size_t column) const {
        return table_.energies(static_cast<Index>(column), static_cast<Index>(group));
    }
    double cost(std::size_t group, Index column, Index old) {
        const MatrixXd& own = answers(group);
        Known& known = known_[group];
        if (known.version != version_) known = {version_, residual_.dot(own.col(old))};
        const MatrixXd& products = products_[group];
        return 2.0 * (residual_.dot(own.col(column)) - known.product) + products(column, column) -
               2.0 * products(column, old) + products(old, old);
    }

    /// The product r . v of a group's present column; valid as long as r has this version.
    struct Known {
        long version = -1;
        double product = 0.0;
    };
    const SwapTable& table_;
    const MatrixXd& unknowns_;
    double most_energy_;
    std::vector<std::size_t> columns_;
    double energy_;
    base::SplitMix64 random_;
    std::vector<Known> known_;
    std::vector<std::size_t> choices_;
    std::vector<MatrixXd> projected_;
    std::vector<MatrixXd> products_;
    VectorXd residual_;
    double objective_ = 0.0;
    long version_ = 0;
    long scored_ = 0;
};

}  // namespace

Annealed anneal_choice(const SwapTable& table, const MatrixXd& unknowns, const AnnealingOptions& options) {
    Annealing annealing(table, unknowns, options);
    Annealed best{options.start.columns, 0};
    double least = annealing.objective();
    const double first = kFirstTemperature * least;
    const long total = options.proposals * static_cast<long>(table.groups());
    double temperature = first;
    for (long i = 0; i < total; ++i) {
        if (i % kPlateau == 0) {
            options.control.check();
            temperature =
                first * std::pow(kTemperatureDrop, static_cast<double>(i) / static_cast<double>(total));
        }
        annealing.propose(temperature);
        if (annealing.objective() >= least) continue;
        least = annealing.objective();
        best.columns = annealing.columns();
    }
    best.scored = annealing.scored();
    return best;
}

}  // namespace fretwork::design::detail
