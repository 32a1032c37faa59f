// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <studio/server/pages.hpp>
#include <studio/server/words.hpp>

#include <utility>

namespace fretwork::studio {

using base::Json;

namespace {

Outgoing message_of(const Json& json) {
    return {{json_part(json)}};
}

}  // namespace

Json warning_event(const std::string& text, std::int64_t revision) {
    return {{"event", "warning"}, {"revision", revision}, {"text", text}};
}

BeamFields Pages::shown_fields() const {
    BeamFields shown;
    for (const auto& [client, fields] : fields_) shown |= fields;
    return shown;
}

void Pages::send(ClientId client, const Json& event) {
    send(client, message_of(event));
}

// Sending may end a connection, and so change the list.
void Pages::broadcast(const Outgoing& outgoing) {
    for (const auto& [client, fields] : std::map(fields_)) send(client, outgoing);
}

void Pages::broadcast(const Json& event) {
    broadcast(message_of(event));
}

void Pages::broadcast(const std::function<Outgoing(const BeamFields&)>& message) {
    std::map<unsigned long, Outgoing> messages;
    for (const auto& [client, fields] : std::map(fields_)) {
        const auto [entry, is_new] = messages.try_emplace(fields.to_ulong());
        if (is_new) entry->second = message(fields);
        if (!entry->second.parts.empty()) send(client, entry->second);
    }
}

void Pages::answer(const Request& request, Json members) {
    Json json = {{"id", request.id}, {"ok", true}};
    json.update(members);
    send(request.client, json);
}

void Pages::refuse(const Request& request, const std::string& error, const Json& more) {
    refuse(request.client, request.id, error, more);
}

void Pages::refuse(ClientId client, const Json& id, const std::string& error, const Json& more) {
    Json json = {{"id", id}, {"ok", false}, {"error", one_line(error)}};
    json.update(more);
    send(client, json);
}

void Pages::in_background(Background& thread, const Request& request,
                          std::function<std::function<void()>(const base::Control&)> work) {
    const auto failed = [this, request](const std::string& error) {
        server_.post([this, request, error] { refuse(request, error); });
    };
    const auto finish = [this, request](const std::function<void()>& rest) {
        try {
            rest();
        } catch (...) {
            refuse(request, error_in_words());
        }
    };
    thread.add({.work =
                    [this, work = std::move(work), finish](const base::Control& control) {
                        server_.post([finish, rest = work(control)] { finish(rest); });
                    },
                .failed = failed});
}

}  // namespace fretwork::studio
