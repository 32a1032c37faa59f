// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <studio/server/background.hpp>
#include <studio/server/binary_messages.hpp>
#include <studio/server/http_server.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace fretwork::studio {

/// A page's request that waits for its answer.
struct Request {
    ClientId client;
    base::Json id;  ///< null if the message does not give it
    base::JsonReader json;
};

/// The event that shows people a warning.
/// @param revision  of the document that is shown
base::Json warning_event(const std::string& text, std::int64_t revision);

/// The pages that have said hello, with the fields of bars that each shows; and what is sent to them. Used on
/// the server's thread, except the work of in_background().
class Pages {
  public:
    explicit Pages(HttpServer& server) : server_(server) {}

    void show(ClientId client, BeamFields fields) { fields_[client] = fields; }
    void remove(ClientId client) { fields_.erase(client); }
    [[nodiscard]] bool contains(ClientId client) const { return fields_.contains(client); }
    [[nodiscard]] const BeamFields& fields(ClientId client) const { return fields_.at(client); }
    /// The fields that at least one page shows.
    [[nodiscard]] BeamFields shown_fields() const;

    void send(ClientId client, const Outgoing& outgoing) { server_.send(client, outgoing); }
    void send(ClientId client, const base::Json& event);
    void broadcast(const Outgoing& outgoing);
    void broadcast(const base::Json& event);
    /// Send each page what `message` gives for its fields; no parts: nothing. Pages that show the same fields
    /// get the same bytes.
    void broadcast(const std::function<Outgoing(const BeamFields&)>& message);

    void answer(const Request& request, base::Json members = base::Json::object());
    /// @param more  further members of the refusal
    void refuse(const Request& request, const std::string& error,
                const base::Json& more = base::Json::object());
    void refuse(ClientId client, const base::Json& id, const std::string& error,
                const base::Json& more = base::Json::object());

    /// Do work on another thread. The work returns a function, which the server's thread then calls; an
    /// error becomes a refusal.
    void in_background(Background& thread, const Request& request,
                       std::function<std::function<void()>(const base::Control&)> work);

  private:
    HttpServer& server_;
    std::map<ClientId, BeamFields> fields_;
};

}  // namespace fretwork::studio
