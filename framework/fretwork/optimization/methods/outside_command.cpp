// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/methods/detail/child_process.hpp>
#include <fretwork/optimization/methods/outside_command.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace fretwork::optimization {
namespace {

using detail::ChildProcess;

constexpr const char* kSpent = "spent";
constexpr const char* kOutside = "outside";
/// The largest number of requests that a program may send after the answer `spent`.
constexpr int kMostAfterSpent = 100;
/// The largest number of points outside the bounds in succession. They cost nothing, so no budget ends them.
constexpr int kMostOutside = 100'000;
/// The longest time in which a program may neither write nor read after the time of its budget is over, or in
/// which it may read nothing while a mebibyte of its requests waits.
constexpr auto kLongestSilence = std::chrono::seconds(1);
constexpr const char* kWhatIsValid = "; valid are 'value' or 'gradient' with a point, and 'done'";

std::string number_text(double value) {
    return std::isfinite(value) ? base::format_number(value) : "inf";
}

std::string line_of(const std::string& word, const Eigen::VectorXd& numbers) {
    std::string line = word;
    for (const double number : numbers) line += " " + number_text(number);
    return line;
}

/// The words of a line; those that are empty are left out.
std::vector<std::string> words_of(const std::string& line) {
    std::vector<std::string> words = base::split(line, ' ');
    std::erase(words, "");
    return words;
}

/// One run of the command.
class Conversation {
  public:
    Conversation(const OutsideCommand& method, Evaluator& evaluator)
        : method_(method), evaluator_(evaluator), child_(method.command, evaluator.control()) {}

    RunOutcome hold(const OptimizerOptions& options) {
        const Bounds& bounds = evaluator_.bounds();
        write("dimension " + std::to_string(bounds.dimension()));
        write(line_of("lower", bounds.lower));
        write(line_of("upper", bounds.upper));
        write("seed " + std::to_string(options.seed));
        write("starts " + std::to_string(options.starts));
        while (const auto line = next_line()) {
            const std::vector<std::string> words = words_of(*line);
            if (!words.empty() && words.front() == "done") return end(words, *line);
            if (is_spent_ && ++asked_after_spent_ > kMostAfterSpent) return outcome(Ending::Stopped);
            const std::string reply = answer(words, *line);
            outside_in_succession_ = reply == kOutside ? outside_in_succession_ + 1 : 0;
            if (outside_in_succession_ > kMostOutside) return outcome(Ending::Stopped);
            write(reply);
        }
        if (is_given_up_) return outcome(Ending::Stopped);
        const std::optional<int> exit_code = child_.finish();
        if (!is_spent_)
            refuse((exit_code ? "ended with exit code " + std::to_string(*exit_code) : "closed its output") +
                   " before it said 'done'");
        return outcome(Ending::BudgetSpent);
    }

  private:
    using Clock = std::chrono::steady_clock;

    /// The end of one wait for the program: it returns true once the program is given up.
    std::function<bool()> patience() {
        return [this, late_since = std::optional<Clock::time_point>()]() mutable {
            if (!evaluator_.is_late() && !child_.is_full()) return false;
            if (!late_since) late_since = Clock::now();
            is_given_up_ = Clock::now() - *late_since >= kLongestSilence;
            return is_given_up_;
        };
    }

    void write(const std::string& line) {
        if (!is_given_up_) child_.write_line(line, patience());
    }

    /// The program's next line; none at its end, or if it is given up.
    std::optional<std::string> next_line() {
        if (is_given_up_) return std::nullopt;
        return base::located("optimizer '" + method_.name + "'", "",
                             [&] { return child_.read_line(patience()); });
    }

    [[noreturn]] void refuse(const std::string& complaint) const {
        throw base::InputError(
            "optimizer '" + method_.name + "'", "",
            "its command '" + base::shortened(base::printable(method_.command), 80) + "' " + complaint);
    }
    [[noreturn]] void refuse_line(const std::string& line) const {
        refuse("said '" + base::shortened(base::printable(line), 60) + "'" + kWhatIsValid);
    }

    [[nodiscard]] Eigen::VectorXd point_of(const std::vector<std::string>& words,
                                           const std::string& line) const {
        const int dimension = evaluator_.bounds().dimension();
        if (std::ssize(words) != dimension + 1)
            refuse("said '" + base::shortened(base::printable(line), 60) + "' with " +
                   base::counted(words.size() - 1, "number") + ", where a point has " +
                   std::to_string(dimension));
        Eigen::VectorXd point(dimension);
        for (int i = 0; i < dimension; ++i) {
            const auto number = base::read_number<double>(words[static_cast<std::size_t>(i) + 1]);
            if (!number) refuse_line(line);
            point[i] = *number;
        }
        return point;
    }

    std::string answer(const std::vector<std::string>& words, const std::string& line) {
        const bool is_gradient = !words.empty() && words.front() == "gradient";
        if (!is_gradient && (words.empty() || words.front() != "value")) refuse_line(line);
        const Eigen::VectorXd point = point_of(words, line);
        if (is_gradient && !evaluator_.problem().offers(Evaluation::Gradient))
            refuse("asked for a gradient, which problem '" + evaluator_.problem().name() +
                   "' does not offer");
        return is_gradient ? gradient_at(point) : value_at(point);
    }

    std::string value_at(const Eigen::VectorXd& point) {
        const auto value = evaluator_.value(point);
        return value ? number_text(*value) : refusal(Evaluation::Value);
    }

    std::string gradient_at(const Eigen::VectorXd& point) {
        const auto model = evaluator_.gradient(point);
        if (!model) return refusal(Evaluation::Gradient);
        if (!std::isfinite(model->objective) || !model->gradient.allFinite()) return "inf";
        return line_of(number_text(model->objective), model->gradient);
    }

    /// The answer to a request that the evaluator has refused.
    std::string refusal(Evaluation kind) {
        if (evaluator_.can_afford(kind)) return kOutside;
        is_spent_ = true;
        return kSpent;
    }

    RunOutcome end(const std::vector<std::string>& words, const std::string& line) {
        const bool is_stalled = words.size() == 2 && words[1] == "stalled";
        if (words.size() > 1 && !is_stalled) refuse_line(line);
        const int exit_code = child_.finish().value_or(0);
        if (exit_code != 0) refuse("said 'done', but ended with exit code " + std::to_string(exit_code));
        if (evaluator_.evaluations() == 0 && !is_spent_)
            refuse("said 'done' without " + missing_evaluation());
        if (is_spent_) return outcome(Ending::BudgetSpent);
        return outcome(is_stalled ? Ending::Stalled : Ending::Converged);
    }

    [[nodiscard]] std::string missing_evaluation() const {
        const auto outside = static_cast<std::size_t>(evaluator_.points_outside());
        return outside == 0 ? "asking for a value"
                            : "a value; " + base::counted(outside, "point") + " lay outside of the bounds";
    }

    /// A command does not report its final point, so its best point is used; empty if there is no best point.
    [[nodiscard]] RunOutcome outcome(Ending ending) const { return {ending, evaluator_.best_point()}; }

    const OutsideCommand& method_;
    Evaluator& evaluator_;
    ChildProcess child_;
    bool is_spent_ = false;
    bool is_given_up_ = false;
    int asked_after_spent_ = 0;
    int outside_in_succession_ = 0;
};

class CommandOptimizer final : public Optimizer {
  public:
    CommandOptimizer(OutsideCommand method, const OptimizerOptions& options)
        : method_(std::move(method)), options_(options) {
        options_.validate();
    }
    RunOutcome run(Evaluator& evaluator) const override {
        return Conversation(method_, evaluator).hold(options_);
    }

  private:
    OutsideCommand method_;
    OptimizerOptions options_;
};

bool may_be_in_a_name(char letter) {
    return std::string_view("-_.").find(letter) != std::string_view::npos ||
           (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'z') ||
           (letter >= 'A' && letter <= 'Z');
}

}  // namespace

void OutsideCommand::validate() const {
    if (name.empty() || !std::ranges::all_of(name, may_be_in_a_name))
        throw base::InputError("'" + base::printable(name) +
                               "' is no name of a method; it has letters, digits, '-', '_' and '.' alone");
    if (command.empty()) throw base::InputError("method '" + name + "' has no command");
}

OptimizerRow outside_command_row(const OutsideCommand& method) {
    method.validate();
    return {method.name,
            "A program of its own: " + base::shortened(base::printable(method.command), 60),
            OptimizerClass::Random,
            Evaluation::Value,
            [method](const OptimizerOptions& options) -> std::unique_ptr<Optimizer> {
                return std::make_unique<CommandOptimizer>(method, options);
            },
            method.command};
}

}  // namespace fretwork::optimization
