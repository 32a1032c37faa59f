// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/exports/tables/library_stiffness.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>

#include <algorithm>
#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace fretwork::exports {
namespace {

static_assert(std::endian::native == std::endian::little, "the array is written as it lies in memory");

/// The header of a .npy file: magic, version 1.0, the length of the text, and the text, padded so that the
/// data begin at a multiple of 64 bytes (NumPy's format description, numpy.lib.format).
std::string npy_header(std::size_t count, std::size_t side) {
    constexpr std::size_t kAlignment = 64;
    constexpr std::size_t kBeforeText = 10;
    std::string text = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(count) + ", " +
                       std::to_string(side) + ", " + std::to_string(side) + "), }";
    while ((kBeforeText + text.size() + 1) % kAlignment != 0) text += ' ';
    text += '\n';
    std::string header("\x93NUMPY\x01\x00", 8);
    header += static_cast<char>(text.size() % 256);
    header += static_cast<char>(text.size() / 256);
    return header + text;
}

Eigen::MatrixXd stiffness_of(const library::Library& library, const pattern::NamedPattern& entry, int nodes) {
    const mechanics::Frame frame =
        reduction::pattern_frame(library.layout(), entry.pattern, library.setting());
    return base::located("pattern " + entry.id, "", [&] { return reduction::condensed_frame(frame, nodes); });
}

namespace fs = std::filesystem;

/// Pre: `ours` can be read.
bool has_content_of(const fs::path& theirs, const fs::path& ours, const base::Control& control) {
    constexpr std::streamsize kPiece = 1 << 20;
    std::error_code ignored;
    if (!fs::is_regular_file(theirs, ignored)) return false;
    if (fs::file_size(theirs, ignored) != fs::file_size(ours, ignored)) return false;
    std::ifstream own(ours, std::ios::binary);
    std::ifstream other(theirs, std::ios::binary);
    std::string own_piece(kPiece, '\0');
    std::string other_piece(kPiece, '\0');
    while (own.read(own_piece.data(), kPiece) || own.gcount() > 0) {
        control.check();
        other.read(other_piece.data(), kPiece);
        const auto size = static_cast<std::size_t>(own.gcount());
        if (other.gcount() != own.gcount() || own_piece.compare(0, size, other_piece, 0, size) != 0)
            return false;
    }
    return true;
}

}  // namespace

std::string stiffness_array(const library::Library& library, std::span<const pattern::NamedPattern> patterns,
                            const StiffnessOptions& options) {
    const int nodes = library.setting().sides * static_cast<int>(library.layout().interface_nodes().size());
    const auto side = static_cast<std::size_t>(6 * nodes);
    const std::size_t bytes = side * side * sizeof(double);
    std::string text = npy_header(patterns.size(), side);
    const std::size_t begin = text.size();
    text.resize(begin + patterns.size() * bytes);
    const base::Task task(options.control, "stiffness", patterns.size());
    constexpr std::size_t kBatch = 256;  // patterns between two reports
    for (std::size_t first = 0; first < patterns.size(); first += kBatch) {
        task.update(first);
        base::parallel_for(std::min(kBatch, patterns.size() - first), options.threads, [&](std::size_t i) {
            options.control.check();
            const Eigen::MatrixXd stiffness = stiffness_of(library, patterns[first + i], nodes);
            std::memcpy(text.data() + begin + (first + i) * bytes, stiffness.data(), bytes);
        });
    }
    return text;
}

void add_stiffness(const library::Library& library, std::span<const pattern::NamedPattern> patterns,
                   const StiffnessOptions& options, base::FolderBatch& batch) {
    batch.add("stiffness.npy", stiffness_array(library, patterns, options));
    std::string ids;
    for (const pattern::NamedPattern& entry : patterns) ids += entry.id + "\n";
    batch.add("patterns.txt", ids);
}

void require_same_stiffness(const fs::path& folder, const base::FolderBatch& batch,
                            const base::Control& control) {
    for (const auto& entry : fs::directory_iterator(batch.path())) {
        const fs::path there = folder / entry.path().filename();
        std::error_code ignored;
        if (fs::symlink_status(there, ignored).type() == fs::file_type::not_found) continue;
        if (has_content_of(there, entry.path(), control)) continue;
        throw base::InputError(there.string(), "",
                               "is there with other content: of other patterns or another setting, or not "
                               "of this export; name another folder, or remove it first");
    }
}

}  // namespace fretwork::exports
