// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.hpp"

#include <fretwork/base/control.hpp>
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <string>
#include <vector>

namespace fretwork::app {
namespace {

/// One line of at most 300 characters, whatever a message quotes.
void complain(std::string message) {
    constexpr std::string_view kStart = "fretwork: ";
    constexpr std::size_t kLongestLine = 300;
    std::ranges::replace(message, '\n', ' ');
    const std::string line = base::shortened(base::printable(message), kLongestLine - kStart.size());
    std::fprintf(stderr, "%s%s\n", std::string(kStart).c_str(), line.c_str());
}

/// `fflush` is where a full disk is reported.
void flush_output() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        throw base::IoError(std::string("the standard output cannot be written: ") + std::strerror(errno));
}

/// CLI11 would only say that a subcommand is required.
void check_verb(const Program& program, int argc, char** argv) {
    if (argc < 2 || argv[1][0] == '-') return;
    std::vector<std::string> names;
    for (const CLI::App* verb : program.get_subcommands({})) names.push_back(verb->get_name());
    if (std::ranges::find(names, argv[1]) != names.end()) return;
    throw base::InputError(base::unknown_name_message("verb", argv[1], names));
}

ExitCode run(int argc, char** argv) {
    ExitCode exit_code = ExitCode::Done;
    Program program(exit_code);
    check_verb(program, argc, argv);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& success) {
        program.exit(success);
    } catch (const CLI::ParseError& error) {
        complain(error.what());
        return ExitCode::BadInput;
    }
    return exit_code;
}

}  // namespace
}  // namespace fretwork::app

int main(int argc, char** argv) {
    using namespace fretwork;
    try {
        const app::ExitCode exit_code = app::run(argc, argv);
        app::flush_output();
        return static_cast<int>(exit_code);
    } catch (const base::Stopped& stopped) {
        app::complain(stopped.what());
        return static_cast<int>(app::ExitCode::DidNotSucceed);
    } catch (const base::Error& error) {
        app::complain(error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        app::complain(error.what());
    } catch (const std::bad_alloc&) {
        app::complain("out of memory");
    }
    return static_cast<int>(app::ExitCode::BadInput);
}
