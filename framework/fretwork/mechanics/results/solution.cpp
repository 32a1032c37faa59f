// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/results/solution.hpp>

namespace fretwork::mechanics {

std::string_view termination_name(Termination termination) {
    switch (termination) {
        case Termination::Converged:
            return "converged";
        case Termination::LimitLoad:
            return "limit-load";
        case Termination::Diverged:
            return "diverged";
        case Termination::IterationsSpent:
            return "iterations-spent";
    }
    return "";
}

std::string_view stability_test_name(StabilityTest test) {
    switch (test) {
        case StabilityTest::None:
            return "none";
        case StabilityTest::Tangent:
            return "tangent";
        case StabilityTest::SymmetricPart:
            return "symmetric-part";
    }
    return "";
}

const base::Limits& motion_limits(Dof dof) {
    return dof < Dof::rx ? base::kLengthLimits : base::kAngleLimits;
}

void require_sensible_motion(const Solution& solution) {
    const NodeValues& motions = solution.displacements;
    bool is_sensible = true;
    for (Eigen::Index i = 0; i < motions.rows(); ++i) {
        for (int d = 0; d < kDofsPerNode; ++d)
            is_sensible = is_sensible && base::is_within(motions(i, d), motion_limits(static_cast<Dof>(d)));
    }
    if (is_sensible) return;
    const auto largest = [](const auto& columns, std::string_view unit) {
        return base::format_number(columns.cwiseAbs().maxCoeff(), 3) + " " + std::string(unit);
    };
    const auto most = [](const base::Limits& limits) {
        return base::format_number(limits.most) + " " + std::string(limits.unit);
    };
    throw base::NumericalError("the largest displacement is " + largest(motions.leftCols<3>(), "m") +
                               ", the largest rotation " + largest(motions.rightCols<3>(), "rad") +
                               ", where results have at most " + most(motion_limits(Dof::ux)) + " and " +
                               most(motion_limits(Dof::rx)) +
                               ": the load or a stiffness is out of any sensible range");
}

Solution end_of_path(std::span<const Solution> path) {
    Solution end = path.back();
    end.iterations = 0;
    end.stability_losses.clear();
    for (const Solution& solution : path) {
        end.iterations += solution.iterations;
        end.stability_losses.insert(end.stability_losses.end(), solution.stability_losses.begin(),
                                    solution.stability_losses.end());
    }
    return end;
}

}  // namespace fretwork::mechanics
