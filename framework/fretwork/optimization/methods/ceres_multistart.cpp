// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/methods/ceres_multistart.hpp>
#include <fretwork/optimization/methods/detail/ceres_descent.hpp>

namespace fretwork::optimization {
namespace {

class CeresMultistart final : public Optimizer {
  public:
    explicit CeresMultistart(const MultistartOptions& options) : options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        return detail::run_multistart(evaluator, options_, [&](Eigen::VectorXd start) {
            return std::make_unique<detail::CeresDescent>(evaluator, options_.continuation, std::move(start));
        });
    }

  private:
    MultistartOptions options_;
};

}  // namespace

std::unique_ptr<Optimizer> make_ceres_multistart(const MultistartOptions& options) {
    options.validate();
    return std::make_unique<CeresMultistart>(options);
}

}  // namespace fretwork::optimization
