// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/library/detail/rows.hpp>

#include <array>
#include <ctime>
#include <unistd.h>

namespace fretwork::library::detail {
namespace {

std::string host_name() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

std::string utc_time() {
    const std::time_t now = std::time(nullptr);
    std::tm fields{};
    ::gmtime_r(&now, &fields);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &fields);
    return text.data();
}

}  // namespace

void record_writer(const Database& database) {
    const std::int64_t session =
        query_integer(database, "SELECT coalesce(max(session), 0) + 1 FROM provenance").value_or(1);
    Statement insert(database, "INSERT INTO provenance VALUES (?, ?, ?)");
    for (const auto& [name, value] : base::provenance()) insert.bind_all(session, name, value).run();
    insert.bind_all(session, "host", host_name()).run();
    insert.bind_all(session, "time", utc_time()).run();
}

}  // namespace fretwork::library::detail
