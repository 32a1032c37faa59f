// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace fretwork::studio {

struct StudioOptions {
    std::optional<std::filesystem::path> project{};  ///< to begin with; none: the start screen
    /// The node layout to begin with, a name or the path of a file: the studio then draws layouts. None: the
    /// studio of surfaces.
    std::optional<std::string> layout{};
    std::string address = "127.0.0.1";
    std::optional<int> port{};           ///< none: 8080, or the next one that is free
    std::filesystem::path page;          ///< the page's HTML file
    std::filesystem::path state_folder;  ///< for autosaves of all documents
};

/// The studio's server: one document, shown by any number of pages. The protocol is protocol.md.
class Studio {
  public:
    /// The server listens when the constructor returns. Throws InputError if project or layout cannot be
    /// read or the address is malformed, IoError if the port is taken or the address is not this machine's.
    explicit Studio(const StudioOptions& options);
    Studio(const Studio&) = delete;
    Studio& operator=(const Studio&) = delete;
    ~Studio();

    /// The address to open in a browser.
    [[nodiscard]] std::string address() const;
    /// The reason why unsaved changes cannot be kept, in one line; empty if they are kept.
    [[nodiscard]] std::string warning() const;
    /// Serve until stop() is called.
    void run();
    /// From any thread.
    void stop();

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::studio
