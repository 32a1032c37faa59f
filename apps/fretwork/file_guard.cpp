// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_identity.hpp"
#include "program.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace fretwork::app {
namespace {

namespace fs = std::filesystem;

/// A file that the command line names.
struct NamedFile {
    fs::path path;
    FileRole role;
    FileKind kind;
};

bool is_there(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

bool is_folder(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored);
}

/// The folder of the file that is written, whatever links lead to it.
fs::path folder_of(const fs::path& path) {
    std::error_code ignored;
    return fs::absolute(base::link_target(path), ignored).parent_path();
}

std::vector<std::string> words(std::string_view text) {
    return text.empty() ? std::vector<std::string>{} : base::split(text, ' ');
}

std::vector<NamedFile> named_files(const Program& program) {
    std::vector<NamedFile> files;
    for (const FileOption& declared : program.file_options()) {
        for (const std::string& path : declared.option->results()) {
            if (path.empty() && declared.option->get_expected_min() == 0) continue;  // given without a value
            if (path.empty())
                throw base::InputError(declared.option->get_name(), "",
                                       "is empty, where the name of a file is needed");
            files.push_back({path, declared.role, declared.kind});
        }
    }
    return files;
}

/// Refuses a link to a file with another ending, because that file is of another kind. Files that are updated
/// may be such links.
void check_link(const NamedFile& file) {
    const fs::path target = base::link_target(file.path);
    if (file.role == FileRole::Update || base::ending_of(target) == base::ending_of(file.path)) return;
    throw base::InputError(file.path.string(), "",
                           "is a link to " + target.string() + ", whose name has another ending");
}

/// An existing file that is updated may have any ending.
void check_ending(const NamedFile& file) {
    if (file.kind.endings.empty() || (file.role == FileRole::Update && is_there(file.path))) return;
    const std::string name = base::in_small_letters(file.path.string());
    for (const std::string& ending : words(file.kind.endings)) {
        if (name.ends_with(ending)) return;
    }
    throw base::InputError(file.path.string(), "",
                           "is to be " + std::string(file.kind.name) + ", whose name ends in " +
                               base::join(words(file.kind.endings), " or "));
}

void check_place(const NamedFile& file) {
    if (is_folder(file.path))
        throw base::InputError(file.path.string(), "", "is a folder, where a file is to be written");
    const fs::path folder = folder_of(file.path);
    if (!is_folder(folder))
        throw base::InputError(file.path.string(), "",
                               "cannot be written: there is no folder " + folder.string());
    if (::access(folder.c_str(), W_OK) != 0)
        throw base::InputError(file.path.string(), "",
                               "cannot be written: folder " + folder.string() + ": " + std::strerror(errno));
    base::check_protection(file.path);
}

bool is_of_kind(const std::string& content, const FileKind& kind) {
    return std::ranges::count(words(kind.contents), content) > 0;
}

/// Refuses to replace a file, unless the file is empty or has content of this kind.
void check_replaced(const fs::path& path, const FileKind& kind) {
    const std::string present = content_of(path);
    if (present.empty() || is_of_kind(present, kind)) return;
    const bool may_be_older = is_table(present) || present == kOtherContent;
    throw base::InputError(path.string(), "",
                           "is " + in_words(present) + ", and would be replaced by " +
                               std::string(kind.name) + "; name another file" +
                               (may_be_older ? ", or remove it first" : ""));
}

/// Content that is not ours passes: the reader of the file says what is wrong with it.
void check_updated(const fs::path& path, const FileKind& kind) {
    const std::string present = content_of(path);
    if (present.empty() || present == kOtherContent || is_of_kind(present, kind)) return;
    throw base::InputError(path.string(), "",
                           "is " + in_words(present) + ", where " + std::string(kind.name) + " is needed");
}

void check_output(const NamedFile& file) {
    if (is_device(file.path) && file.kind.is_several)
        throw base::InputError(file.path.string(), "",
                               "is a device, which takes one file; " + std::string(file.kind.name) +
                                   " is several, and its name ends in " + std::string(file.kind.endings));
    if (is_device(file.path)) return;
    check_place(file);
    check_ending(file);
    check_link(file);
    file.role == FileRole::Update ? check_updated(file.path, file.kind)
                                  : check_replaced(file.path, file.kind);
}

/// How a file's name matches those that a command makes in a folder.
enum class MadeName { None, ByEnding, Whole };

MadeName made_name(const fs::path& path, const FileKind& folder) {
    const std::string name = path.filename().string();
    for (const std::string& made : words(folder.endings)) {
        if (name == made) return MadeName::Whole;
        if (made.front() == '.' && name.ends_with(made)) return MadeName::ByEnding;
    }
    return MadeName::None;
}

bool is_made_in_folder(const fs::path& path, const FileKind& folder) {
    return made_name(path, folder) != MadeName::None;
}

bool has_our_table(const fs::path& folder) {
    std::error_code ignored;
    return std::ranges::any_of(fs::directory_iterator(folder, ignored), [](const fs::directory_entry& entry) {
        return is_table(content_of(entry.path()));
    });
}

/// A library is in the way of an output with its name or ending. Any other file, except a table, is in the
/// way of an output that has its whole name and is not compared.
bool is_in_the_way(MadeName name, const std::string& content, const FileKind& folder) {
    if (content == kLibraryContent) return name != MadeName::None;
    return name == MadeName::Whole && !folder.is_compared && !is_table(content);
}

/// By the ending alone, only databases are refused. People write settings and layouts, too: a setting.json or
/// layout.json counts as an older output only if a table of ours lies beside it.
void check_folder(const NamedFile& folder) {
    if (!is_there(folder.path)) return;
    if (!is_folder(folder.path))
        throw base::InputError(folder.path.string(), "", "is a file, where a folder is needed");
    std::error_code ignored;
    const bool is_ours = has_our_table(folder.path);
    for (const auto& entry : fs::directory_iterator(folder.path, ignored)) {
        const fs::path& path = entry.path();
        const MadeName name = made_name(path, folder.kind);
        const std::string content = content_of(path);
        const std::string older = is_ours ? path.stem().string() : "";
        if (is_in_the_way(name, content, folder.kind))
            check_replaced(path, {"a file of this command", "", older});
    }
}

bool lies_in(const NamedFile& file, const NamedFile& folder) {
    return is_same_file(folder_of(file.path), folder.path) && is_made_in_folder(file.path, folder.kind);
}

bool is_only_read(const NamedFile& file) {
    return file.role == FileRole::Input;
}

/// Whether two names of one command lead to one file, also if one is a folder in which the command makes it.
bool collide(const NamedFile& first, const NamedFile& second) {
    if (is_device(first.path) || is_device(second.path)) return false;
    const bool is_folder_first = first.role == FileRole::OutputFolder;
    const bool is_folder_second = second.role == FileRole::OutputFolder;
    if (is_folder_first && is_folder_second) return false;  // one folder may take files of both kinds
    if (is_folder_first) return lies_in(second, first);
    if (is_folder_second) return lies_in(first, second);
    return is_same_file(first.path, second.path);
}

void check_pair(const NamedFile& first, const NamedFile& second) {
    if ((is_only_read(first) && is_only_read(second)) || !collide(first, second)) return;
    const std::string written = (is_only_read(second) ? first : second).path.string();
    const auto is_read = [](const NamedFile& file) {
        return file.role == FileRole::Input || file.role == FileRole::Update;
    };
    if (is_read(first) || is_read(second))
        throw base::InputError(written, "", "is read by this command, and would be overwritten by it");
    throw base::InputError(written, "", "is named for two outputs of this command");
}

}  // namespace

void check_files(const Program& program) {
    const std::vector<NamedFile> files = named_files(program);
    for (std::size_t i = 0; i < files.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) check_pair(files[j], files[i]);
    }
    for (const NamedFile& file : files) {
        if (file.role == FileRole::OutputFolder) check_folder(file);
        if (file.role == FileRole::Output || file.role == FileRole::Update) check_output(file);
    }
}

void check_files_beside(const CLI::App& verb, const std::vector<fs::path>& made) {
    const CLI::App* root = &verb;
    while (root->get_parent() != nullptr) root = root->get_parent();
    const std::vector<NamedFile> files = named_files(dynamic_cast<const Program&>(*root));
    for (const fs::path& path : made) {
        for (const NamedFile& file : files) check_pair({path, FileRole::Output, {}}, file);
    }
}

}  // namespace fretwork::app
