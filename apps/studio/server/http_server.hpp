// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <studio/server/access.hpp>
#include <studio/server/outgoing.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace fretwork::studio {

/// A page that is connected, over its WebSocket.
enum class ClientId : std::int64_t {};

/// A response to a browser.
struct HttpAnswer {
    unsigned status = 200;
    std::string type = "text/plain; charset=utf-8";
    std::string body;
    std::string download_name{};  ///< name of a file to be stored; empty: the answer is shown
    std::string remark{};         ///< one line about the file, for the person who stores it
};

/// The callbacks of the server. All calls come on the server's thread, and only for requests that are
/// allowed.
class Service {
  public:
    Service() = default;
    Service(const Service&) = delete;
    Service& operator=(const Service&) = delete;
    virtual ~Service() = default;

    /// Answer a request, now or later, from the server's thread.
    virtual void get(const Target& target, std::function<void(HttpAnswer)> answer) = 0;
    virtual void connected(ClientId client) = 0;
    virtual void disconnected(ClientId client) = 0;
    virtual void received(ClientId client, std::string_view message) = 0;
};

struct ServerOptions {
    std::string address = "127.0.0.1";
    /// Without: 8080, or the next one that is free.
    std::optional<int> port{};
    std::string token;
    /// The time after which an incomplete request, or an answer that nobody takes, is given up.
    std::chrono::milliseconds request_time{30'000};
};

/// HTTP and WebSocket (RFC 6455) for a few clients, with limits on their messages and on the messages that
/// wait for them. A request without the token, with a Host or Origin that is not this machine, or with
/// another path or method gets a status of 4xx and one line.
class HttpServer {
  public:
    /// Listens at once. Throws InputError if the address is malformed, IoError if the port is taken or the
    /// address is not this machine's.
    HttpServer(const ServerOptions& options, Service& service);
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;
    ~HttpServer();

    [[nodiscard]] int port() const;
    /// Serve until stop() is called: this is the server's thread.
    void run();
    /// From any thread.
    void stop();
    /// Do something on the server's thread soon. From any thread.
    void post(std::function<void()> work);
    /// Call only on the server's thread. Nothing happens if the client has gone.
    void send(ClientId client, const Outgoing& outgoing);

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::studio
