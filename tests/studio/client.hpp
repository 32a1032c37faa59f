// SPDX-License-Identifier: GPL-3.0-or-later
// A client that sends what a test says and nothing else, also what no browser would.
#pragma once

#include <fretwork/base/internal/json_text.hpp>

#include <arpa/inet.h>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/socket.h>
#include <sys/time.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace fretwork::test {

/// The parts of "http://127.0.0.1:8080/?token=..".
struct StudioAddress {
    explicit StudioAddress(const std::string& address) {
        const std::string_view start = "http://127.0.0.1:";
        const std::size_t slash = address.find('/', start.size());
        port = std::stoi(address.substr(start.size(), slash - start.size()));
        token = address.substr(address.find("token=") + 6);
    }
    int port = 0;
    std::string token;
};

/// A connection to a server on this machine. Waits at most a minute for anything.
class Wire {
  public:
    explicit Wire(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        const timeval longest{60, 0};
        const int yes = 1;
        ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &longest, sizeof longest);
        ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &longest, sizeof longest);
        ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
        // A port of this side rests for a minute after each connection: the fuzzer uses all 28,000.
        bool is_connected = connect(port);
        for (int tenths = 0; !is_connected && errno == EADDRNOTAVAIL && tenths < 600; ++tenths) {
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            is_connected = connect(port);
        }
        if (!is_connected)
            throw std::runtime_error("no server at port " + std::to_string(port) + ": " +
                                     std::strerror(errno));
    }
    Wire(const Wire&) = delete;
    Wire& operator=(const Wire&) = delete;
    ~Wire() { close(); }

    void close() {
        if (socket_ >= 0) ::close(socket_);
        socket_ = -1;
    }
    /// Nothing more is sent; what the server sends still comes.
    void end() const { ::shutdown(socket_, SHUT_WR); }
    /// False if the server has closed the connection.
    bool send(std::string_view bytes) const {
        while (!bytes.empty()) {
            const ssize_t sent =
                again([&] { return ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL); });
            if (sent <= 0) return false;
            bytes.remove_prefix(static_cast<std::size_t>(sent));
        }
        return true;
    }
    /// The next `count` bytes; throws if the server has closed the connection.
    std::string receive(std::size_t count) {
        while (buffer_.size() < count) {
            if (!fill()) throw std::runtime_error("the server closed the connection");
        }
        std::string bytes = buffer_.substr(0, count);
        buffer_.erase(0, count);
        return bytes;
    }
    std::string receive_until(std::string_view end) {
        while (buffer_.find(end) == std::string::npos) {
            if (!fill()) return buffer_;
        }
        return receive(buffer_.find(end) + end.size());
    }
    std::string receive_all() {
        while (fill()) continue;
        return buffer_;
    }

  private:
    /// False, with the reason in errno, if there is no connection.
    [[nodiscard]] bool connect(int port) const {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return true;
        return errno == EINTR && is_connected_at_last();
    }
    /// A connection that a signal interrupted is made all the same. Sets errno as connect() does.
    [[nodiscard]] bool is_connected_at_last() const {
        pollfd made{socket_, POLLOUT, 0};
        const ssize_t ready = again([&] { return ::poll(&made, 1, 60'000); });
        int error = ETIMEDOUT;
        socklen_t size = sizeof error;
        if (ready > 0) ::getsockopt(socket_, SOL_SOCKET, SO_ERROR, &error, &size);
        errno = error;
        return error == 0;
    }
    /// A signal, such as the clock of libFuzzer, interrupts calls on a socket with time limits.
    template <class Call>
    static ssize_t again(Call call) {
        ssize_t result = call();
        while (result < 0 && errno == EINTR) result = call();
        return result;
    }
    bool fill() {
        char bytes[65536];
        const ssize_t got = again([&] { return ::recv(socket_, bytes, sizeof bytes, 0); });
        if (got > 0) buffer_.append(bytes, static_cast<std::size_t>(got));
        return got > 0;
    }
    int socket_;
    std::string buffer_;
};

/// The whole answer to a request, from its first line on.
inline std::string http(int port, const std::string& request) {
    Wire wire(port);
    wire.send(request);
    return wire.receive_all();
}

inline std::string get_request(const std::string& target, const std::string& host = "127.0.0.1",
                               const std::string& more = "") {
    return "GET " + target + " HTTP/1.1\r\nHost: " + host + "\r\n" + more + "\r\n";
}

/// The number of an answer's first line.
inline int status_of(const std::string& answer) {
    return answer.size() > 12 ? std::stoi(answer.substr(9, 3)) : 0;
}

/// A page's WebSocket.
class Client {
  public:
    using Json = base::Json;

    explicit Client(const StudioAddress& address) : wire_(address.port) {
        wire_.send(get_request("/socket?token=" + address.token, "127.0.0.1",
                               "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                               "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"));
        const std::string answer = wire_.receive_until("\r\n\r\n");
        if (status_of(answer) != 101) throw std::runtime_error("no WebSocket: " + answer);
    }

    bool send_text(std::string_view text) const {
        std::string frame = "\x81";
        const std::size_t size = text.size();
        if (size < 126) {
            frame += static_cast<char>(0x80U | size);
        } else {
            const int bytes = size < 65536 ? 2 : 8;
            frame += static_cast<char>(bytes == 2 ? 0xfe : 0xff);
            for (int i = bytes - 1; i >= 0; --i)
                frame += static_cast<char>(size >> (8U * static_cast<unsigned>(i)));
        }
        frame.append(4, '\0');  // a mask of zeros
        return wire_.send(frame) && wire_.send(text);
    }
    bool send_raw(std::string_view bytes) const { return wire_.send(bytes); }
    void leave() { wire_.close(); }

    struct Message {
        Json json;  ///< null: it is binary
        std::string binary;
    };
    /// The next message. Throws if the server has closed the connection.
    Message receive() {
        while (true) {
            const std::string head = wire_.receive(2);
            const auto opcode = static_cast<unsigned char>(head[0]) & 0xfU;
            const std::string bytes = wire_.receive(size_of(static_cast<unsigned char>(head[1])));
            if (opcode == 1) return {Json::parse(bytes), {}};
            if (opcode == 2) return {{}, bytes};
            if (opcode == 8) throw std::runtime_error("the server ended the connection");
        }
    }

    /// Send a request and wait for its answer; what comes before it is kept for events().
    Json ask(const std::string& name, Json more = Json::object()) {
        const int id = ++last_id_;
        Json request = {{"id", id}, {"do", name}};
        request.update(more);
        send_text(request.dump());
        while (true) {
            Message message = receive();
            if (message.json.is_object() && message.json.contains("id") && message.json["id"] == id)
                return message.json;
            kept_.push_back(std::move(message));
        }
    }
    /// The next event of one of these names, from the oldest that was not asked for yet. Others are dropped.
    Json event(std::initializer_list<std::string_view> names) {
        while (true) {
            const Message message = next();
            if (!message.json.is_object() || !message.json.contains("event")) continue;
            for (const std::string_view name : names) {
                if (message.json["event"] == name) return message.json;
            }
        }
    }
    std::string binary() {
        while (true) {
            const Message message = next();
            if (!message.binary.empty()) return message.binary;
        }
    }
    /// Messages that came unasked.
    void forget() { kept_.clear(); }
    void hello() {
        const Json answer = ask("hello", {{"protocol", 1}});
        if (!answer["ok"].get<bool>()) throw std::runtime_error("no hello: " + answer.dump());
    }

  private:
    Message next() {
        if (kept_.empty()) return receive();
        Message message = std::move(kept_.front());
        kept_.erase(kept_.begin());
        return message;
    }
    std::size_t size_of(unsigned char byte) {
        const unsigned size = byte & 0x7fU;
        if (size < 126) return size;
        std::size_t result = 0;
        for (const char c : wire_.receive(size == 126 ? 2 : 8))
            result = (result << 8U) | static_cast<unsigned char>(c);
        return result;
    }

    mutable Wire wire_;
    int last_id_ = 0;
    std::vector<Message> kept_;
};

/// A value of a binary message's header.
inline std::uint32_t header(const std::string& message, std::size_t place) {
    std::uint32_t value = 0;
    std::memcpy(&value, message.data() + 4 * place, sizeof value);
    return value;
}

/// The floats of a binary message behind its header.
inline std::vector<float> floats(const std::string& message, std::size_t first, std::size_t count) {
    std::vector<float> values(count);
    std::memcpy(values.data(), message.data() + 32 + 4 * first, 4 * count);
    return values;
}

}  // namespace fretwork::test
