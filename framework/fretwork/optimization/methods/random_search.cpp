// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>
#include <fretwork/optimization/methods/random_search.hpp>

namespace fretwork::optimization {
namespace {

class RandomSearch final : public Optimizer {
  public:
    explicit RandomSearch(const OptimizerOptions& options) : options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        base::RandomStream random(options_.seed, 0);
        Eigen::VectorXd shares(evaluator.bounds().dimension());
        Eigen::VectorXd point;
        do {
            for (double& share : shares) share = random.uniform();
            point = evaluator.bounds().at_shares(shares);
        } while (evaluator.value(point));
        return {Ending::BudgetSpent, point};
    }

  private:
    OptimizerOptions options_;
};

}  // namespace

std::unique_ptr<Optimizer> make_random_search(const OptimizerOptions& options) {
    options.validate();
    return std::make_unique<RandomSearch>(options);
}

}  // namespace fretwork::optimization
