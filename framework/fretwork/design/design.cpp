// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/design/checks/designed_project.hpp>
#include <fretwork/design/checks/full_check.hpp>
#include <fretwork/design/design.hpp>
#include <fretwork/design/reach/reach_bound.hpp>
#include <fretwork/design/reach/survey.hpp>
#include <fretwork/design/reach/unknown_fit.hpp>
#include <fretwork/design/search/preparation.hpp>
#include <fretwork/design/search/search.hpp>
#include <fretwork/simulation/results/bar_clearance.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace fretwork::design {
namespace {

using detail::BeamDemand;
using detail::FullCheck;
using detail::Point;
using detail::Search;
using detail::Solved;
using detail::TimeLimit;
using detail::Trial;
using detail::Trials;
using mechanics::NodeValues;

constexpr int kDefectRounds = 6;
/// The number of solutions that other starts leave for one more round.
constexpr int kLeftForLastRound = 3;
/// The largest number of uniform paintings that are checked in full until one has an equilibrium.
constexpr std::size_t kUniformChecks = 3;
/// After a defect round that gains less than this share, the next one searches from other starts.
constexpr double kLeastDefectGain = 0.02;
/// The target is unreachable if the bound is at least this share of the flat surface's misfit.
constexpr double kHopeless = 0.5;
/// The fits of single patterns may exceed the limit of the search by this number of solutions.
constexpr int kMostFitting = 40;

/// The course of one design.
class Designer {
  public:
    Designer(detail::Preparation preparation, const DesignOptions& options, const TimeLimit& time,
             DesignReport& report)
        : trials_(std::move(preparation.parts), options.control.silent()),
          choice_{std::move(preparation.palette), std::move(preparation.coordinates)},
          whole_(std::move(preparation.whole)),
          options_(options),
          time_(time),
          report_(report),
          search_(trials_, options_, time, report) {}

    /// Leaves the best point in best(); after Stopped, the best one of the finished steps, or none.
    void run() {
        require_enough_solutions();
        Search::Beginning beginning = begin();
        require_possible_mass();
        // Without patterns that were not condensed, it would be no bound of the whole palette.
        if (palette().size() >= whole_.size())
            report_.bound = detail::reach_bound(trials_, palette(), options_.control.silent());
        std::vector<Solved> starts = solve_uniform(std::move(beginning.uniform));
        const std::size_t listed = std::min(palette().size(), options_.shortlist);
        search_.set_columns({palette().begin(), palette().begin() + static_cast<std::ptrdiff_t>(listed)},
                            palette());
        if (report_.bound.value_or(0.0) >= kHopeless * misfit_at_rest()) {
            report_.end = DesignEnd::Unreachable;
            return;
        }
        aim_beside(starts);
        put_in_front(std::move(beginning.painted), starts);
        search_.begin_at(starts.front());
        Solved found = search_.improve(starts.front(), reserve());
        best_ = found.point;
        report_.start_misfits.push_back(std::sqrt(found.trial.objective));
        found = search_.improve_from_others(std::move(found), starts, reserve(), search_.left_for_defect());
        best_ = found.point;
        report_.end = search_.end();
        check_and_keep_best(found);
        correct_defect();
        relax();
    }

    [[nodiscard]] const std::optional<Point>& best() const { return best_; }
    /// After a stop, take the best point of the search, which is better than its start.
    void take_best_of_search() {
        if (!is_correcting_ && search_.best_point()) best_ = search_.best_point();
    }
    [[nodiscard]] const Trials& trials() const { return trials_; }
    /// The full model's check of the best point; null if this point was not checked.
    [[nodiscard]] const FullCheck* check_of_best() const {
        return checked_ && best_ == checked_->point ? &checked_->check : nullptr;
    }

    /// Fills in shapes, curvatures and close bars.
    void tell_shapes() const {
        report_.uniform_shapes = uniform_shapes_;
        if (const FullCheck* own = check_of_best()) report_.shapes = detail::shapes_of(trials_, *own);
        detail::add_wanted_curvatures(trials_.parts().surface.tessellation, report_.shapes, report_.gamut);
        report_.close_bars = close_bars_of(*best_);
    }

  private:
    [[nodiscard]] const std::vector<std::size_t>& palette() const { return choice_.palette; }

    /// Makes a first painting to show early, then condenses the rest of the palette. There is no early
    /// painting if unknowns are free (they must be fitted first), with max_patterns, or with few solutions.
    Search::Beginning begin() {
        Search::Beginning beginning;
        const bool has_solutions =
            search_.most_solutions() >= 2 * static_cast<int>(options_.uniform_paintings);
        if (trials_.initial_unknowns().size() == 0 && options_.max_patterns == 0 && has_solutions)
            beginning = search_.begin(palette());
        if (!whole_.empty()) choice_ = detail::extend_palette(trials_, whole_, options_);
        return beginning;
    }

    /// Puts a painting before the starts if it is better than the best of them: the search begins there.
    void put_in_front(std::optional<Solved> painted, std::vector<Solved>& starts) {
        if (!painted) return;
        painted->trial.objective = trials_.objective_of(painted->trial.displacements);
        if (!search_.is_better(*painted, starts.front())) return;
        if (search_.keeps_mass(painted->point)) best_ = painted->point;  // in case the search is stopped
        starts.insert(starts.begin(), std::move(*painted));
    }

    [[nodiscard]] double reserve() const { return 2.5 * check_seconds_; }

    [[nodiscard]] double misfit_at_rest() const {
        const auto nodes = std::ssize(trials_.parts().surface.tessellation.interface_nodes);
        detail::Trial rest;
        rest.displacements.assign(trials_.parts().cases.size(), NodeValues::Zero(nodes, 6));
        return std::sqrt(trials_.scaled_objective(rest));
    }

    void require_possible_mass() const {
        if (options_.max_mass <= 0.0) return;
        const detail::Lightest lightest = trials_.lightest(palette());
        if (lightest.mass <= options_.max_mass) return;
        throw base::InputError(
            "the lightest painting weighs " + base::format_number(lightest.mass, 4) +
            " kg (its lightest pattern is " + trials_.parts().candidates.patterns()[lightest.pattern].id +
            "), more than the " + base::format_number(options_.max_mass, 4) + " kg that it may");
    }

    /// One painting takes a solution for each load case.
    void require_enough_solutions() const {
        if (search_.may_solve()) return;
        throw base::InputError(
            "a search of at most " +
            base::counted(static_cast<std::size_t>(search_.most_solutions()), "nonlinear solution") +
            " tries no painting: the target has " + std::to_string(trials_.parts().cases.size()) +
            " load cases, and each takes one");
    }

    [[nodiscard]] std::string no_equilibrium() const {
        if (search_.may_solve() || report_.uniform_tried == palette().size())
            return "no single pattern of the palette has a stable equilibrium under this load: a smaller "
                   "load may have one";
        return "no single pattern of the " + std::to_string(report_.uniform_tried) +
               " for which the solutions were enough has a stable equilibrium under this load: a smaller "
               "load may have one, or a search with more solutions may find one";
    }

    /// Returns solved uniform paintings, the best first; the most promising ones get their own best
    /// unknowns. Checks them in full until one has an equilibrium, at most kUniformChecks.
    std::vector<Solved> solve_uniform(std::vector<Solved> known) {
        std::vector<Solved> starts = search_.try_uniform(palette(), choice_.coordinates, std::move(known));
        if (starts.empty()) throw base::InputError(no_equilibrium());
        best_ = starts.front().point;
        detail::survey(trials_, starts, report_);
        if (search_.may_solve())
            report_.reach_of_ten_loads =
                detail::reach_of_ten_loads(trials_, starts, report_, options_.control);
        if (trials_.initial_unknowns().size() > 0) {
            const int before = trials_.solutions();
            DesignOptions fitting = options_;
            fitting.most_solutions = search_.most_solutions() + kMostFitting;
            detail::fit_starts(trials_, starts, fitting, time_);
            search_.grant(trials_.solutions() - before);
            search_.note(starts.front());
            detail::add_reached_curvatures(trials_, starts, report_.gamut);
        }
        best_ = starts.front().point;
        report_.uniform_solutions = trials_.solutions();
        check_uniform(starts);
        return starts;
    }

    [[nodiscard]] BeamDemand demand() const {
        if (!trials_.parts().surface.setting.strength) return BeamDemand::None;
        return options_.max_utilization > 0.0 ? BeamDemand::UtilizationAndError : BeamDemand::Utilization;
    }

    FullCheck check(const Point& point) {
        const double before = time_.seconds();
        FullCheck found = detail::check_in_full(trials_, point, demand(), options_.control);
        check_seconds_ = std::max(check_seconds_, time_.seconds() - before);
        report_.full_solutions += found.solutions;
        return found;
    }

    void check_uniform(const std::vector<Solved>& starts) {
        for (std::size_t i = 0; i < std::min(starts.size(), kUniformChecks); ++i) {
            FullCheck found = check(starts[i].point);
            if (!found.has_converged) continue;
            take_uniform(starts[i].point, found);
            best_ = starts[i].point;
            checked_ = {starts[i].point, std::move(found)};
            checked_->is_allowed = is_allowed(checked_->point, checked_->check);
            return;
        }
    }

    /// A checked painting of one pattern is a single pattern to compare with, also if the search found it.
    void take_uniform(const Point& point, const FullCheck& found) {
        if (std::ranges::adjacent_find(point.patterns, std::ranges::not_equal_to{}) != point.patterns.end())
            return;
        if (report_.best_uniform && report_.best_uniform->mean <= found.error.mean) return;
        report_.best_uniform = found.error;
        report_.best_uniform_pattern = trials_.parts().candidates.patterns()[point.patterns.front()].id;
        uniform_shapes_ = detail::shapes_of(trials_, found);
    }

    /// Moves the aim by the error of the reduced model at the checked uniform painting, and sorts the starts.
    void aim_beside(std::vector<Solved>& starts) {
        const auto known = std::ranges::find_if(
            starts, [this](const Solved& start) { return checked_ && start.point == checked_->point; });
        if (known == starts.end()) return;
        trials_.set_aims(defect(known->trial, checked_->check));
        for (Solved& start : starts) start.trial.objective = trials_.objective_of(start.trial.displacements);
        std::ranges::stable_sort(starts, std::bind_front(&Search::is_better, &search_));
        search_.forget_solved();
    }

    /// The displacements, reduced minus full model.
    static std::vector<NodeValues> defect(const Trial& trial, const FullCheck& full) {
        std::vector<NodeValues> difference;
        for (std::size_t c = 0; c < trial.displacements.size(); ++c)
            difference.push_back(trial.displacements[c] -
                                 full.displacements[c].topRows(trial.displacements[c].rows()));
        return difference;
    }

    /// Number of pairs of bars with a gap below the clearance.
    [[nodiscard]] std::size_t close_bars_of(const Point& point) const {
        if (!options_.clearance) return 0;
        return simulation::close_bars(trials_.surface_at(point), *options_.clearance).size();
    }

    [[nodiscard]] bool is_allowed(const Point& point, const FullCheck& check) const {
        if (!check.has_converged || !check.error.is_stable) return false;
        if (!search_.keeps_mass(point) || close_bars_of(point) > 0) return false;
        return keeps_utilization(options_, check.largest_utilization, check.utilization_error);
    }

    /// Checks a point. The best checked point, if any, becomes the best point.
    void check_and_keep_best(const Solved& solved) {
        if (!is_correcting_) best_ = solved.point;  // in case the check is stopped
        FullCheck found = check(solved.point);
        if (found.has_converged) take_uniform(solved.point, found);
        Checked own{solved.point, std::move(found)};
        own.is_allowed = is_allowed(own.point, own.check);
        if (own.check.has_converged && is_better(own)) {
            report_.model_error = model_error(solved, own.check);
            checked_ = std::move(own);
        }
        if (checked_) best_ = checked_->point;
    }

    [[nodiscard]] double model_error(const Solved& solved, const FullCheck& full) const {
        double sum = 0.0;
        double count = 0.0;
        for (std::size_t c = 0; c < full.displacements.size(); ++c) {
            const NodeValues& reduced = solved.trial.displacements[c];
            const NodeValues difference = full.displacements[c].topRows(reduced.rows()) - reduced;
            sum += difference.leftCols<3>().rowwise().norm().sum();
            count += static_cast<double>(difference.rows());
        }
        return sum / count / trials_.largest_wanted();
    }

    /// Defect correction: moves the aim by the error of the reduced model, and searches on. After a round
    /// that gains little, the search continues from other starts.
    void correct_defect() {
        is_correcting_ = true;
        bool has_gained = true;
        for (int round = 0; checked_ && round < kDefectRounds && search_.may_go_on(reserve()); ++round) {
            Solved solved{checked_->point, trials_.solve(checked_->point, options_.control)};
            if (!solved.trial.is_found) return;
            trials_.set_aims(defect(solved.trial, checked_->check));
            solved.trial.objective = trials_.objective_of(solved.trial.displacements);
            search_.forget_solved();
            search_.begin_at(solved);
            const Solved found =
                has_gained ? search_.improve(std::move(solved), reserve())
                           : search_.improve_from_others(std::move(solved), {}, reserve(), kLeftForLastRound);
            if (found.point == checked_->point && !has_gained) return;
            const double before = checked_->check.error.mean;
            if (found.point != checked_->point) check_and_keep_best(found);
            has_gained = checked_->check.error.mean < (1.0 - kLeastDefectGain) * before;
        }
    }

    /// Predicts the misfit of the best mixtures of patterns, from a table at the best painting.
    void relax() {
        if (!best_ || !time_.has_left(reserve())) return;
        const int before = trials_.solutions();
        const Trial trial = trials_.solve(*best_, options_.control);
        trials_.count_solutions(before - trials_.solutions());  // those of relax() do not count
        if (!trial.is_found) return;
        report_.relaxed = search_.relaxed_misfit({*best_, trial});
    }

    struct Checked {
        Point point;
        FullCheck check;
        bool is_allowed = false;  ///< stable and within the limits of the options
    };
    [[nodiscard]] bool is_better(const Checked& own) const {
        if (!checked_) return true;
        if (own.is_allowed != checked_->is_allowed) return own.is_allowed;
        return own.is_allowed && own.check.error.mean < checked_->check.error.mean;
    }

    Trials trials_;
    detail::ExtendedPalette choice_;
    std::vector<pattern::NamedPattern> whole_;
    const DesignOptions& options_;
    const TimeLimit& time_;
    DesignReport& report_;
    Search search_;
    std::optional<Point> best_;
    std::optional<Checked> checked_;  ///< the best of those that were checked
    std::vector<CaseShape> uniform_shapes_;
    double check_seconds_ = 0.0;
    bool is_correcting_ = false;  ///< true: only checked points may be the best
};

}  // namespace

std::string_view design_end_name(DesignEnd end) {
    switch (end) {
        case DesignEnd::NoSwapImproves:
            return "no-swap-improves";
        case DesignEnd::SolutionsSpent:
            return "solutions-spent";
        case DesignEnd::TimeSpent:
            return "time-spent";
        case DesignEnd::Unreachable:
            return "unreachable";
        default:
            return "stopped";
    }
}

DesignReport design(const simulation::Project& project, const library::Library* library, const Target& target,
                    const DesignOptions& options) {
    options.validate(project);
    const TimeLimit time(options.seconds);
    const base::Task task(
        options.control, "design",
        static_cast<std::size_t>(detail::solution_limit(options, project.tessellation.tiles.size())));
    DesignReport report;
    report.project = project;
    report.seed = options.seed;
    detail::Preparation preparation =
        detail::prepare(project, library, target, options, detail::kFirstPatterns);
    const std::vector<std::string> names = preparation.load_cases;
    report.warnings = preparation.warnings;
    Designer designer(std::move(preparation), options, time, report);
    try {
        designer.run();
    } catch (const base::Stopped&) {
        designer.take_best_of_search();
        if (!designer.best()) throw;
        report.end = DesignEnd::Stopped;
    }
    if (const FullCheck* check = designer.check_of_best()) {
        report.error = check->error;
        report.largest_utilization = check->largest_utilization;
        report.utilization_error = check->utilization_error;
    }
    for (const auto& own : designer.trials().parts().cases)
        report.slides = report.slides || own.goals.slides();
    designer.tell_shapes();
    detail::write_point(designer.trials(), *designer.best(), names, report);
    report.solutions = designer.trials().solutions();
    report.seconds = time.seconds();
    return report;
}

}  // namespace fretwork::design
