// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>

namespace fretwork::base {
namespace {

/// A text of JSON may have a NUL, at which what(), a C string, would end. It is shown as printable() shows
/// it.
std::string with_nul_shown(std::string text) {
    if (text.find('\0') == std::string::npos) return text;
    std::string shown;
    for (const char c : text) {
        if (c == '\0')
            shown += "\\x00";
        else
            shown += c;
    }
    return shown;
}

}  // namespace

std::string text_of(const ErrorData& data) {
    std::string text;
    for (const auto& [source, place] : data.where) {
        if (!source.empty()) text += source + ": ";
        if (!place.empty()) text += place + ": ";
    }
    return with_nul_shown(text + data.problem);
}

Failure handled_failure() {
    try {
        throw;
    } catch (const Error& error) {
        return {error.what()};
    } catch (const std::filesystem::filesystem_error& error) {
        const std::string file = error.path1().string();
        return {(file.empty() ? "" : file + ": ") + error.code().message()};
    } catch (const std::system_error& error) {  // no thread can be started, for example
        return {error.code().message()};
    } catch (const std::bad_alloc&) {
        return {"out of memory"};
    } catch (const std::exception& defect) {
        return {
            std::string("a defect of the program; please report it with what led to it: ") + defect.what(),
            true};
    }
}

bool names_source(const Error& error, const std::string& source) {
    return std::ranges::find(error.data().where, source, &ErrorPlace::source) != error.data().where.end();
}

}  // namespace fretwork::base
