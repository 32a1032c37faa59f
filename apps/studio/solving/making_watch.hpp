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
    /// Pages were told of a change. They dropped the report if other bars were shown before: if it is on the
    /// bars that are shown now, they get it again.
    void follow(const State& before);
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
    Background thread_;
};

}  // namespace fretwork::studio
