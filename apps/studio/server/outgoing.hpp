// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>

#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace fretwork::studio {

/// One message of the WebSocket. Clients share its bytes.
struct Part {
    enum class Kind { Text, Binary };
    Kind kind = Kind::Text;
    std::shared_ptr<const std::string> bytes;
};
Part text_part(std::string text);
/// An event or an answer. Bytes that are not UTF-8, which an error may quote from a file, are replaced, so
/// that every message can be sent.
Part json_part(const base::Json& json);
Part binary_part(std::string bytes);

/// Parts that are sent together and in this order.
struct Outgoing {
    std::vector<Part> parts;
    /// The key of messages that replace each other. An unsent message with the same key is dropped, so that a
    /// slow reader gets the newest positions. Empty: no message is dropped.
    std::string stream{};
};

/// The messages that wait to be sent to one client. Their size is bounded: newer solutions replace older
/// ones, and a client with more than kMostBytes of unsent messages is too far behind. It is disconnected, and
/// has to come back.
class OutgoingQueue {
  public:
    /// The limit of waiting messages. A document of 10,000 tiles with its beams takes some 10 MB.
    static constexpr std::size_t kMostBytes = std::size_t{64} << 20U;

    void add(Outgoing outgoing);
    [[nodiscard]] bool is_empty() const { return waiting_.empty(); }
    [[nodiscard]] bool is_too_far_behind() const { return bytes_ > kMostBytes; }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }
    /// The next part. Messages that were begun are sent to their end.
    Part take();

  private:
    std::deque<Outgoing> waiting_;
    bool is_first_begun_ = false;
    std::size_t bytes_ = 0;
};

}  // namespace fretwork::studio
