// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
Part binary_part(std::string bytes);

/// What is sent together and in this order.
struct Outgoing {
    std::vector<Part> parts;
    /// What of an older state of the same thing has not been sent when this comes is left out: a slow reader
    /// gets the newest positions. Empty: nothing may be left out.
    std::string stream{};
};

/// What waits to be sent to one client. Bounded: where a client does not read, solutions give way to newer
/// ones; what else it does not read in time makes it too far behind, and it has to come back.
class OutgoingQueue {
  public:
    /// What may wait. A document of 10,000 tiles with its beams takes some 10 MB.
    static constexpr std::size_t kMostBytes = std::size_t{64} << 20U;

    void add(Outgoing outgoing);
    [[nodiscard]] bool is_empty() const { return waiting_.empty(); }
    [[nodiscard]] bool is_too_far_behind() const { return bytes_ > kMostBytes; }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }
    /// The next message. What was begun is sent to its end.
    Part take();

  private:
    std::deque<Outgoing> waiting_;
    bool is_first_begun_ = false;
    std::size_t bytes_ = 0;
};

}  // namespace fretwork::studio
