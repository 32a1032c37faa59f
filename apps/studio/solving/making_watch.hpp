// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <studio/document/document.hpp>
#include <studio/server/background.hpp>
#include <studio/server/pages.hpp>

#include <functional>
#include <utility>

namespace fretwork::studio {

/// Looks in the background whether the shown surface can be made, once its painting rests, and reports it to
/// the pages; not again while the same bars lie in the same places. Used on the server's thread.
class MakingWatch {
  public:
    /// @param now  gives the state that is shown
    MakingWatch(HttpServer& server, Pages& pages, std::function<StatePtr()> now)
        : server_(server), pages_(pages), now_(std::move(now)) {}

    /// Another document is shown.
    void begin();
    /// Another state is shown, and perhaps not for long enough to be looked at.
    void follow(const State& now);
    void look_at(const Document& document);
    /// Send a page the report on what is shown, if there is one.
    void send(ClientId client);

  private:
    void report(const StatePtr& state, const base::Json& event);

    HttpServer& server_;
    Pages& pages_;
    std::function<StatePtr()> now_;
    StatePtr looked_at_;  ///< its surface was or is being looked at
    Outgoing report_;     ///< on that surface
    /// Whether other bars were shown since: then pages have dropped the report.
    bool was_left_ = false;
    Background thread_;
};

}  // namespace fretwork::studio
