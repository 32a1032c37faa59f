// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <studio/document/state.hpp>

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace fretwork::studio {

/// A state that an edit made.
struct Edited {
    State state;
    std::string label;  ///< what the edit is called: "paint 3 tiles"
    /// Successive edits with the same key are one step: a drag, a stroke of the brush. Empty: a separate
    /// step.
    std::string merge{};
    std::vector<std::string> remarks{};  ///< for the page that asked
};

/// The states of a document: the present one, those before it, and those that were undone. Its memory is
/// bounded: the oldest are forgotten.
class History {
  public:
    struct Limits {
        std::size_t steps = 1000;
        std::size_t bytes = std::size_t{64} << 20U;
    };
    explicit History(State first) : History(std::move(first), Limits()) {}
    History(State first, Limits limits);

    [[nodiscard]] const StatePtr& now() const { return steps_[now_].state; }
    void add(Edited edited);
    /// False if there is nothing to undo, or to redo.
    bool undo();
    bool redo();
    /// The step that would be undone, or redone.
    [[nodiscard]] std::optional<std::string> undo_label() const;
    [[nodiscard]] std::optional<std::string> redo_label() const;
    [[nodiscard]] std::size_t steps() const { return steps_.size(); }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

  private:
    struct Step {
        StatePtr state;
        std::string label;
        std::string merge;
        std::size_t bytes = 0;  ///< of what it does not share with the one before
    };
    [[nodiscard]] Step make_step(Edited edited) const;
    void forget_undone();
    void forget_oldest();

    Limits limits_;
    std::deque<Step> steps_;
    std::size_t now_ = 0;
    std::size_t bytes_ = 0;
};

}  // namespace fretwork::studio
