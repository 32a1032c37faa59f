// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork studio: a server of one document, for a page in the browser.
#include "file_identity.hpp"
#include "interrupt.hpp"
#include "options/file_options.hpp"
#include "output.hpp"
#include "verbs.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <studio/studio.hpp>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <memory>
#include <spawn.h>
#include <stop_token>
#include <unistd.h>

namespace fretwork::app {
namespace {

/// The place of this program's page: ../share/fretwork/studio.html, seen from the program's folder. The file
/// may be missing.
std::filesystem::path usual_page_path() {
    std::error_code unknown;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
    return program.parent_path().parent_path() / "share" / "fretwork" / "studio.html";
}

struct StudioOptions {
    std::string project;
    std::string page;
    std::string layout;
    bool draws_layout = false;
    bool no_browser = false;
    studio::StudioOptions studio;
};

/// The folder for what outlives a run: fretwork in $XDG_STATE_HOME, else in ~/.local/state.
std::filesystem::path state_folder() {
    const char* state = std::getenv("XDG_STATE_HOME");
    if (state != nullptr && *state == '/') return std::filesystem::path(state) / "fretwork";
    const char* home = std::getenv("HOME");
    const std::filesystem::path root = home != nullptr && *home == '/' ? home : "/tmp";
    return root / ".local" / "state" / "fretwork";
}

/// Opens an address by the desktop's command, if there is one. The address is printed, too.
void open_browser(std::string address) {
    std::string program = "xdg-open";
    char* arguments[] = {program.data(), address.data(), nullptr};
    posix_spawn_file_actions_t quiet;
    ::posix_spawn_file_actions_init(&quiet);
    for (const int stream : {1, 2})
        ::posix_spawn_file_actions_addopen(&quiet, stream, "/dev/null", O_WRONLY, 0);
    // The browser need not ignore the signals that this program ignores.
    sigset_t usual;
    ::sigemptyset(&usual);
    ::sigaddset(&usual, SIGXFSZ);
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    ::posix_spawnattr_setsigdefault(&attributes, &usual);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    pid_t child = 0;
    (void)::posix_spawnp(&child, program.c_str(), &quiet, &attributes, arguments, environ);
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&quiet);
}

/// The text by which the page asks for a layout: its name, or the absolute path of its file.
std::string layout_to_draw(const std::string& text) {
    if (text.empty())
        throw base::InputError(
            "--layout '' is empty: give the name or the file of a layout, or --layout alone for " +
            pattern::layout_names().front());
    (void)pattern::find_node_layout(text);  // errors name the text as it was typed
    if (pattern::is_layout_name(text)) return text;
    return std::filesystem::absolute(text).lexically_normal().string();
}

void run(StudioOptions options) {
    if (!options.project.empty()) {
        if (content_of(options.project) == kLibraryContent)
            throw base::InputError(options.project, "", "is a pattern library, where a project is needed");
        options.studio.project = std::filesystem::absolute(options.project);
    }
    if (options.draws_layout) {
        if (!options.project.empty())
            throw base::InputError("'" + options.project +
                                   "' is a project, and --layout draws a node layout: give one of them");
        options.studio.layout = layout_to_draw(options.layout);
    }
    if (!options.page.empty() && !std::filesystem::exists(options.page))
        throw base::InputError(options.page, "",
                               "there is no such file; the page is 'studio.html' of a build");
    options.studio.page = options.page.empty() ? usual_page_path() : std::filesystem::path(options.page);
    options.studio.state_folder = state_folder();
    LongWork work(LongWork::StopsAt::HangUp);
    studio::Studio studio(options.studio);
    const std::stop_callback stop(work.control().stop, [&studio] { studio.stop(); });
    std::printf("%s\n", studio.address().c_str());
    std::fflush(stdout);
    if (const std::string warning = studio.warning(); !warning.empty()) warn(warning);
    if (!options.no_browser) open_browser(studio.address());
    studio.run();
}

}  // namespace

void add_studio(CLI::App& app, ExitCode&) {
    CLI::App* verb = app.add_subcommand(
        "studio", "Paint, support and load a surface in the browser, and see it bend. Ctrl-C ends it");
    const auto options = std::make_shared<StudioOptions>();
    verb->add_option("project", options->project, "Project file (default: a screen to choose one from)");
    verb->add_option("--layout", options->layout,
                     "Draw a node layout instead: the name of a layout, or its file")
        ->expected(0, 1)
        ->default_str(pattern::layout_names().front())
        ->type_name("[LAYOUT]");
    verb->add_option("--address", options->studio.address, "Address to listen at")->capture_default_str();
    verb->add_option("--port", options->studio.port, "Port (default: 8080, or the next one that is free)")
        ->check(CLI::Range(1, 65535));
    verb->add_flag("--no-browser", options->no_browser, "Print the address, and open no browser");
    verb->add_option("--page", options->page,
                     "Page to serve (default: the one that was built with the program)");
    declare_files(*verb, {input("project"), input("--page"), input("--layout")});
    verb->footer(
        "Examples:\n"
        "  fretwork studio project.json\n"
        "  fretwork studio --layout mine.json\n"
        "On another machine: ssh -L 8080:localhost:8080 MACHINE fretwork studio --no-browser --port 8080 "
        "project.json");
    verb->callback([options, verb] {
        options->draws_layout = verb->count("--layout") > 0;
        run(*options);
    });
}

}  // namespace fretwork::app
