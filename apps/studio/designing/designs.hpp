// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <studio/designing/design_report.hpp>
#include <studio/designing/design_request.hpp>
#include <studio/server/background.hpp>
#include <studio/server/pages.hpp>

#include <functional>
#include <optional>

namespace fretwork::studio {

/// The design of the document that is shown: one at a time, on a thread of its own. It is given up as soon as
/// somebody else changes what it works on. Used on the server's thread.
class Designs {
  public:
    /// @param take  paints the document; called on the server's thread
    Designs(HttpServer& server, Pages& pages, std::function<void(const DesignFound&)> take);

    /// Throws InputError if one is at work.
    void begin(const StatePtr& state, DesignWish wish, std::int64_t revision);
    /// End the search; its best painting so far is taken.
    void stop() { thread_.cancel(); }
    /// Another document is shown: nothing of the present design is taken any more.
    void forget();
    /// Tell the present document, after any edit. An edit of the tiles, painting, load cases or setting that
    /// the design did not make ends the design.
    void follow(const StatePtr& now);
    /// The document as the design has painted it.
    void painted(const StatePtr& now);
    /// The key that merges the edits of one design into one step of undo.
    [[nodiscard]] std::string merge_key() const { return "design:" + std::to_string(number_); }
    /// Send a page the last report of the design at work or, until the next edit, of the one that ended.
    void send(ClientId client) { pages_.send(client, last_); }

  private:
    struct Run {
        StatePtr state;  ///< as the design knows the document
        std::int64_t revision = 0;
    };
    /// The input of the thread.
    struct Work {
        int number = 0;
        StatePtr state;
        DesignWish wish;
        std::int64_t revision = 0;
    };
    void run(const Work& work, const base::Control& control);
    void tell_progress(const Work& work, const design::DesignProgress& progress);
    void give(const Work& work, DesignFound found);
    void fail(int number, std::int64_t revision, const std::string& error);
    void show(const base::Json& event);

    HttpServer& server_;
    Pages& pages_;
    std::function<void(const DesignFound&)> take_;
    int number_ = 0;  ///< of the last design
    std::optional<Run> run_;
    Outgoing last_;
    Background thread_;
};

}  // namespace fretwork::studio
