// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that knows Boost.Beast.
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <studio/server/http_server.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <utility>  // Boost.Asio 1.74 needs it and does not include it

namespace fretwork::studio {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using ErrorCode = beast::error_code;

constexpr int kUsualPort = 8080;
constexpr int kPortsTried = 100;
constexpr std::size_t kMostConnections = 64;
/// The largest number of these whose request has not come yet. Any program on this machine can open them,
/// without the token.
constexpr std::size_t kMostWaiting = 32;
constexpr std::size_t kMostHeaderBytes = 16384;
/// A file of 64 MB in Base64, and the rest of its message.
constexpr std::size_t kMostMessageBytes = 90'000'000;
/// The pause after the system has refused a connection, such as when all descriptors are taken.
constexpr std::chrono::milliseconds kAcceptPause{200};

/// The response to a request that is not even read.
constexpr std::string_view kTooMany =
    "HTTP/1.1 429 Too Many Requests\r\nContent-Type: text/plain; charset=utf-8\r\n"
    "Content-Length: 21\r\nConnection: close\r\n\r\ntoo many connections\n";

using HttpRequest = http::request<http::string_body>;
using Response = http::response<http::string_body>;

std::string_view view(beast::string_view text) {
    return {text.data(), text.size()};
}

/// Scripts and styles are inside of the page; nothing is fetched from elsewhere, and no other page may frame
/// it.
constexpr const char* kContentPolicy =
    "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; worker-src blob:; "
    "style-src 'unsafe-inline'; img-src data: blob:; font-src data:; media-src data: blob:; "
    "connect-src 'self' data: blob: ws://127.0.0.1:* ws://localhost:*; frame-ancestors 'none'; "
    "base-uri 'none'; form-action 'none'";

/// A name that is safe in a header and as a file.
std::string safe_name(const std::string& name) {
    std::string safe;
    for (const char c : name) {
        const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                              c == '.' || c == '-' || c == '_';
        safe += is_plain ? c : '_';
    }
    return safe;
}

Response response_to(const HttpRequest& request, HttpAnswer answer) {
    Response response(static_cast<http::status>(answer.status), request.version());
    response.set(http::field::content_type, answer.type);
    response.set(http::field::cache_control, "no-store");
    response.set("Content-Security-Policy", kContentPolicy);
    response.set("X-Content-Type-Options", "nosniff");
    response.set("Referrer-Policy", "no-referrer");
    if (!answer.download_name.empty())
        response.set(http::field::content_disposition,
                     "attachment; filename=\"" + safe_name(answer.download_name) + "\"");
    if (!answer.remark.empty()) response.set("Fretwork-Remark", answer.remark);
    response.keep_alive(false);
    response.content_length(answer.body.size());
    if (request.method() != http::verb::head) response.body() = std::move(answer.body);
    return response;
}

HttpAnswer refusal(http::status status, const std::string& why) {
    return {.status = static_cast<unsigned>(status), .body = why + "\n"};
}

}  // namespace

/// The accepting socket, and who is connected.
class HttpServer::Impl {
  public:
    Impl(const ServerOptions& options, Service& service)
        : service_(service),
          token_(options.token),
          request_time_(options.request_time),
          acceptor_(context_),
          pause_(context_) {
        listen(options);
        accept();
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() { clients_.clear(); }  // so that disconnected() is not called any more

    [[nodiscard]] int port() const { return acceptor_.local_endpoint().port(); }
    void run() { context_.run(); }
    void stop() { context_.stop(); }
    void post(std::function<void()> work) { asio::post(context_, std::move(work)); }
    void send(ClientId client, const Outgoing& outgoing);

  private:
    class Connection;
    class Client;

    void listen(const ServerOptions& options);
    bool try_listen(const tcp::endpoint& endpoint, ErrorCode& error);
    void accept();
    void accept_later();
    void take(tcp::socket socket);
    /// If there are too many, the connection that has waited longest for its request is closed.
    void make_room();

    Service& service_;
    std::string token_;
    std::chrono::milliseconds request_time_;
    std::size_t connections_ = 0;
    std::deque<std::weak_ptr<Connection>> waiting_;  ///< connections without a request yet, the oldest first
    std::int64_t last_client_ = 0;
    std::map<ClientId, std::weak_ptr<Client>> clients_;
    // Pending operations hold connections, which use the members above when they end: the context goes first.
    asio::io_context context_{1};
    tcp::acceptor acceptor_;
    asio::steady_timer pause_;
};

/// One page at the other end of a WebSocket.
class HttpServer::Impl::Client : public std::enable_shared_from_this<Client> {
  public:
    Client(Impl& server, beast::tcp_stream stream)
        : server_(server), socket_(std::move(stream)), id_(ClientId{++server.last_client_}) {
        ++server_.connections_;
        socket_.read_message_max(kMostMessageBytes);
        socket_.auto_fragment(false);  // one frame a message: nothing is copied
        socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    }
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;
    ~Client() {
        --server_.connections_;
        if (server_.clients_.erase(id_) > 0) server_.service_.disconnected(id_);
    }

    void accept(const HttpRequest& request) {
        socket_.async_accept(request, [self = shared_from_this()](ErrorCode error) {
            if (error) return;
            self->server_.clients_[self->id_] = self;
            self->server_.service_.connected(self->id_);
            self->read();
        });
    }

    void send(const Outgoing& outgoing) {
        queue_.add(outgoing);
        if (queue_.is_too_far_behind()) return beast::get_lowest_layer(socket_).close();
        if (!writing_.bytes) write();
    }

  private:
    void read() {
        socket_.async_read(buffer_, [self = shared_from_this()](ErrorCode error, std::size_t) {
            if (error) return self->leave();
            if (!self->socket_.got_text()) return self->leave();
            const auto bytes = self->buffer_.cdata();
            self->server_.service_.received(
                self->id_, {static_cast<const char*>(bytes.data()), static_cast<std::size_t>(bytes.size())});
            self->buffer_.consume(self->buffer_.size());
            constexpr std::size_t kKept = std::size_t{1} << 20U;
            if (self->buffer_.capacity() > kKept) self->buffer_.shrink_to_fit();
            self->read();
        });
    }

    void write() {
        if (queue_.is_empty()) return;
        writing_ = queue_.take();
        socket_.binary(writing_.kind == Part::Kind::Binary);
        socket_.async_write(asio::buffer(*writing_.bytes),
                            [self = shared_from_this()](ErrorCode error, std::size_t) {
                                self->writing_ = {};
                                if (error) return self->leave();
                                self->write();
                            });
    }

    /// Closes the socket. Pending operations then end with an error, and release this object.
    void leave() { beast::get_lowest_layer(socket_).close(); }

    Impl& server_;
    websocket::stream<beast::tcp_stream> socket_;
    ClientId id_;
    beast::flat_buffer buffer_;
    OutgoingQueue queue_;
    Part writing_{};  ///< without bytes: nothing is being written
};

/// One request, which is answered or becomes a WebSocket.
class HttpServer::Impl::Connection : public std::enable_shared_from_this<Connection> {
  public:
    Connection(Impl& server, tcp::socket socket) : server_(server), stream_(std::move(socket)) {
        ++server_.connections_;
        parser_.header_limit(kMostHeaderBytes);
        parser_.body_limit(std::uint64_t{0});
    }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    ~Connection() { --server_.connections_; }

    void read() {
        stream_.expires_after(server_.request_time_);
        http::async_read(stream_, buffer_, parser_,
                         [self = shared_from_this()](ErrorCode error, std::size_t) { self->serve(error); });
    }
    [[nodiscard]] bool is_waiting() const { return is_waiting_; }
    void close() {
        is_waiting_ = false;
        stream_.close();
    }

  private:
    void serve(ErrorCode error) {
        is_waiting_ = false;
        if (error == http::error::end_of_stream || error == asio::error::operation_aborted ||
            error == beast::error::timeout)
            return;
        if (error == http::error::body_limit)
            return answer(refusal(http::status::payload_too_large, "a request here has no body"));
        if (error == http::error::header_limit || error == http::error::buffer_overflow)
            return answer(refusal(http::status::request_header_fields_too_large, "the request is too long"));
        if (error) return answer(refusal(http::status::bad_request, "the request is malformed"));
        serve(parser_.get());
    }

    void serve(const HttpRequest& request) {
        const std::string address = own_address();
        const std::size_t origins = request.count(http::field::origin);
        if (request.count(http::field::host) != 1 || !is_own_host(view(request[http::field::host]), address))
            return answer(refusal(http::status::forbidden, "the Host is not this machine"));
        if (origins > 1 || (origins == 1 && !is_own_origin(view(request[http::field::origin]), address)))
            return answer(refusal(http::status::forbidden, "the Origin is not this machine"));
        const auto target = parse_target(view(request.target()));
        if (!target) return answer(refusal(http::status::bad_request, "the address is malformed"));
        if (!is_token(target->value("token"), server_.token_))
            return answer(refusal(http::status::forbidden,
                                  "the token is missing or wrong: use the address "
                                  "that 'fretwork studio' printed"));
        if (websocket::is_upgrade(request)) return upgrade(*target);
        if (request.method() != http::verb::get && request.method() != http::verb::head)
            return answer(refusal(http::status::method_not_allowed, "only GET is possible here"));
        if (target->path == "/socket")
            return answer(refusal(http::status::upgrade_required, "a WebSocket is needed here"));
        stream_.expires_never();
        server_.service_.get(*target, [self = released_on_server_thread()](HttpAnswer given) {
            self->answer(std::move(given));
        });
    }

    /// A pointer to this for callbacks that other threads may keep. Whichever thread drops the last copy, the
    /// connection is released on the server's thread.
    std::shared_ptr<Connection> released_on_server_thread() {
        return {this, [owner = shared_from_this()](Connection*) mutable {
                    Impl& server = owner->server_;
                    server.post([last = std::move(owner)] {});
                }};
    }

    void upgrade(const Target& target) {
        if (target.path != "/socket")
            return answer(refusal(http::status::not_found, "the WebSocket is at /socket"));
        stream_.expires_never();  // the WebSocket has its own timeouts
        std::make_shared<Client>(server_, std::move(stream_))->accept(parser_.get());
    }

    /// The address at which this connection came in.
    [[nodiscard]] std::string own_address() const {
        ErrorCode error;
        const auto endpoint = stream_.socket().local_endpoint(error);
        return error ? "" : endpoint.address().to_string();
    }

    void answer(HttpAnswer given) {
        response_ = response_to(parser_.get(), std::move(given));
        stream_.expires_after(server_.request_time_);
        http::async_write(stream_, response_, [self = shared_from_this()](ErrorCode, std::size_t) {
            ErrorCode ignored;
            self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
        });
    }

    Impl& server_;
    beast::tcp_stream stream_;
    beast::flat_buffer buffer_;
    http::request_parser<http::string_body> parser_;
    Response response_;
    bool is_waiting_ = true;
};

bool HttpServer::Impl::try_listen(const tcp::endpoint& endpoint, ErrorCode& error) {
    acceptor_ = tcp::acceptor(context_);
    acceptor_.open(endpoint.protocol(), error);
    if (!error) acceptor_.set_option(asio::socket_base::reuse_address(true), error);
    if (!error) acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
    return !error;
}

void HttpServer::Impl::listen(const ServerOptions& options) {
    ErrorCode error;
    const auto address = asio::ip::make_address(options.address, error);
    if (error)
        throw base::InputError("--address", "",
                               "'" + options.address + "' is not an address, such as 127.0.0.1 or ::1");
    const int first = options.port.value_or(kUsualPort);
    const int last = options.port ? first : first + kPortsTried - 1;
    for (int port = first; port <= last; ++port) {
        if (try_listen({address, static_cast<unsigned short>(port)}, error)) return;
        if (error != asio::error::address_in_use) break;
    }
    throw base::IoError("cannot listen at " + options.address + ", port " + std::to_string(first) +
                        (options.port ? "" : " and those after it") + ": " + error.message());
}

void HttpServer::Impl::accept() {
    acceptor_.async_accept([this](ErrorCode error, tcp::socket socket) {
        if (error == asio::error::operation_aborted) return;
        if (error) return accept_later();
        take(std::move(socket));
        accept();
    });
}

void HttpServer::Impl::accept_later() {
    pause_.expires_after(kAcceptPause);
    pause_.async_wait([this](ErrorCode error) {
        if (!error) accept();
    });
}

/// Called before each connection, which counts even if it never sends a request.
void HttpServer::Impl::make_room() {
    std::erase_if(waiting_, [](const std::weak_ptr<Connection>& one) {
        const auto connection = one.lock();
        return !connection || !connection->is_waiting();
    });
    if (waiting_.size() < kMostWaiting) return;
    waiting_.front().lock()->close();
    waiting_.pop_front();
}

void HttpServer::Impl::take(tcp::socket socket) {
    ErrorCode ignored;
    make_room();
    if (connections_ >= kMostConnections) {
        socket.non_blocking(true, ignored);  // a client that does not read gets no answer
        socket.write_some(asio::buffer(kTooMany), ignored);
        return;
    }
    socket.set_option(tcp::no_delay(true), ignored);
    const auto connection = std::make_shared<Connection>(*this, std::move(socket));
    waiting_.push_back(connection);
    connection->read();
}

void HttpServer::Impl::send(ClientId client, const Outgoing& outgoing) {
    const auto found = clients_.find(client);
    if (found == clients_.end()) return;
    if (const auto connected = found->second.lock()) connected->send(outgoing);
}

HttpServer::HttpServer(const ServerOptions& options, Service& service)
    : impl_(std::make_unique<Impl>(options, service)) {}
HttpServer::~HttpServer() = default;
int HttpServer::port() const {
    return impl_->port();
}
void HttpServer::run() {
    impl_->run();
}
void HttpServer::stop() {
    impl_->stop();
}
void HttpServer::post(std::function<void()> work) {
    impl_->post(std::move(work));
}
void HttpServer::send(ClientId client, const Outgoing& outgoing) {
    impl_->send(client, outgoing);
}

}  // namespace fretwork::studio
