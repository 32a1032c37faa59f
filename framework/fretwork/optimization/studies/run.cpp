// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/sha256.hpp>
#include <fretwork/optimization/studies/run.hpp>

#include <ctime>

namespace fretwork::optimization::study {
namespace {

double thread_cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double distance_between(const optimization::Bounds& bounds, const Eigen::VectorXd& a,
                        const Eigen::VectorXd& b) {
    return (a - b).cwiseQuotient(bounds.upper - bounds.lower).lpNorm<Eigen::Infinity>();
}

}  // namespace

void RunConditions::validate() const {
    budget.validate();
}

std::uint64_t run_seed(const RunKey& key, std::uint64_t study_seed) {
    const std::string hash = base::sha256(std::to_string(study_seed) + "|" + key.problem + "|" +
                                          key.optimizer + "|" + std::to_string(key.repetition));
    return std::stoull(hash.substr(0, 16), nullptr, 16);
}

RunRecord record_run(const RunTarget& target, const Contender& contender, const RunKey& key,
                     const RunConditions& conditions) {
    const optimization::Problem& problem = target.problem;
    RunRecord record;
    record.key = key;
    record.dimension = problem.bounds().dimension();
    record.kind = contender.method->kind;
    record.starts = contender.starts;
    record.command = contender.method->command;
    record.seed = run_seed(key, conditions.seed);
    record.budget = conditions.budget.cost;
    const double begin = thread_cpu_seconds();
    record.report = optimization::minimize(
        problem, *contender.method, {.starts = contender.starts, .seed = record.seed}, conditions.budget);
    record.cpu_seconds = thread_cpu_seconds() - begin;
    const bool has_last = problem.bounds().contain(record.report.final_point);
    record.last_value = has_last ? problem.value(record.report.final_point) : record.report.value;
    if (target.optimum.size() > 0 && record.report.point.size() > 0) {
        record.distance = distance_between(problem.bounds(), record.report.point, target.optimum);
    }
    return record;
}

}  // namespace fretwork::optimization::study
