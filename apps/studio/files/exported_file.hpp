// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <studio/document/document.hpp>
#include <studio/server/http_server.hpp>
#include <studio/solving/live_view.hpp>

#include <filesystem>

namespace fretwork::studio {

/// The file that an address `/export?to=..` asks for: the project, or what `fretwork export` writes.
class ExportTarget {
  public:
    /// Throws InputError for keys and kinds of file that do not exist.
    explicit ExportTarget(Target target);

    /// Whether the file shows the solution (the answer to the load). Files for cutting and printing do not.
    [[nodiscard]] bool shows_answer() const;
    /// The file, with its remarks. Throws InputError, for example if a value in the address is invalid, and
    /// Stopped. Safe to call from any thread.
    ///
    /// @param folder  the folder to which paths in a project are relative
    /// @param solved  the solution of the situation; null: the file shows no solution
    [[nodiscard]] HttpAnswer file_of(const Situation& situation, const std::filesystem::path& folder,
                                     const SolvedPtr& solved, const base::Control& control) const;

  private:
    [[nodiscard]] bool is_project() const;

    Target target_;
};

/// The answer to a request that cannot be met, in one line.
HttpAnswer refused(unsigned status, const std::string& why);

}  // namespace fretwork::studio
