// SPDX-License-Identifier: GPL-3.0-or-later
#include "interrupt.hpp"
#include "output.hpp"
#include "program.hpp"

#include <fretwork/base/control.hpp>
#include <fretwork/base/error.hpp>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>

namespace fretwork::app {
namespace {

/// `fflush` is where a full disk is reported.
void flush_output() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        throw base::IoError(std::string("the standard output cannot be written: ") + std::strerror(errno));
}

/// CLI11 would only say that a subcommand is required.
void check_verb(const Program& program, char** argv) {
    if (argv[1][0] != '-') (void)find_verb(program, argv[1]);
}

/// The usage of the verb that was typed.
std::string usage_of(const CLI::App& program) {
    const CLI::App* verb = &program;
    std::string words = program.get_name();
    while (!verb->get_subcommands().empty()) {
        verb = verb->get_subcommands().front();
        words += " " + verb->get_name();
    }
    if (!verb->get_subcommands({}).empty()) return "; usage: " + words + " VERB";
    for (const CLI::Option* option : verb->get_options()) {
        if (option->get_positional())
            words += option->get_required() ? " " + option->get_name() : " [" + option->get_name() + "]";
        else if (option->get_required())
            words += " " + option->get_name() + " " + option->get_type_name();
    }
    return "; usage: " + words + " [OPTIONS]";
}

ExitCode run(int argc, char** argv) {
    ExitCode exit_code = ExitCode::Done;
    Program program(exit_code);
    if (argc < 2) {
        std::fputs(program.help().c_str(), stdout);
        return ExitCode::BadInput;
    }
    check_verb(program, argv);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& success) {
        program.exit(success);
    } catch (const CLI::RequiredError& error) {
        complain(error.what() + usage_of(program));
        return ExitCode::BadInput;
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
    // A limit on the size of files (ulimit -f) would end the program without a word. Ignored, the signal
    // makes write() fail, which is reported like a full disk.
    std::signal(SIGXFSZ, SIG_IGN);
    app::end_in_order_when_interrupted();
    try {
        const app::ExitCode exit_code = app::run(argc, argv);
        app::flush_output();
        return static_cast<int>(exit_code);
    } catch (const base::Stopped& stopped) {
        app::complain(stopped.what());
        return static_cast<int>(app::ExitCode::DidNotSucceed);
    } catch (...) {
        const base::Failure failure = base::handled_failure();
        app::complain(failure.text);
        return static_cast<int>(failure.is_defect ? app::ExitCode::Defect : app::ExitCode::BadInput);
    }
}
