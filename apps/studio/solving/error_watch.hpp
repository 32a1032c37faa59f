// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <studio/server/background.hpp>
#include <studio/server/pages.hpp>
#include <studio/solving/live_solver.hpp>

#include <functional>
#include <utility>

namespace fretwork::studio {

/// Estimates in the background the error of a doubtful live solution against the full model, once nothing
/// changes any more, and reports it to the pages. Used on the server's thread.
class ErrorWatch {
  public:
    /// @param now  gives the situation that is shown
    ErrorWatch(HttpServer& server, Pages& pages, std::function<Situation()> now)
        : server_(server), pages_(pages), now_(std::move(now)) {}

    /// Another document is shown.
    void begin();
    void look_at(const SolvedPtr& solved);
    /// Send a page the report on what is shown, if there is one.
    void send(ClientId client);

  private:
    void report(const Situation& of, const base::Json& event);

    HttpServer& server_;
    Pages& pages_;
    std::function<Situation()> now_;
    Situation looked_at_;  ///< its error was or is being estimated
    Outgoing report_;
    Background thread_;
};

}  // namespace fretwork::studio
