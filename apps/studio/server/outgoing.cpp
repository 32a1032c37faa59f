// SPDX-License-Identifier: GPL-3.0-or-later
#include <studio/server/outgoing.hpp>

namespace fretwork::studio {
namespace {

std::size_t size_of(const Outgoing& outgoing) {
    std::size_t size = 0;
    for (const Part& part : outgoing.parts) size += part.bytes->size();
    return size;
}

}  // namespace

Part text_part(std::string text) {
    return {Part::Kind::Text, std::make_shared<const std::string>(std::move(text))};
}

Part json_part(const base::Json& json) {
    return text_part(json.dump(-1, ' ', false, base::Json::error_handler_t::replace));
}

Part binary_part(std::string bytes) {
    return {Part::Kind::Binary, std::make_shared<const std::string>(std::move(bytes))};
}

void OutgoingQueue::add(Outgoing outgoing) {
    if (outgoing.parts.empty()) return;
    if (!outgoing.stream.empty()) {
        const auto first_unsent = waiting_.begin() + (is_first_begun_ ? 1 : 0);
        for (auto waiting = first_unsent; waiting != waiting_.end();) {
            const bool gives_way = waiting->stream == outgoing.stream;
            if (gives_way) bytes_ -= size_of(*waiting);
            waiting = gives_way ? waiting_.erase(waiting) : waiting + 1;
        }
    }
    bytes_ += size_of(outgoing);
    waiting_.push_back(std::move(outgoing));
}

Part OutgoingQueue::take() {
    std::vector<Part>& parts = waiting_.front().parts;
    Part part = std::move(parts.front());
    parts.erase(parts.begin());
    bytes_ -= part.bytes->size();
    is_first_begun_ = !parts.empty();
    if (parts.empty()) waiting_.pop_front();
    return part;
}

}  // namespace fretwork::studio
