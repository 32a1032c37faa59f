// SPDX-License-Identifier: GPL-3.0-or-later
// Child processes that are killed, or that find the disk full.
#pragma once

#include <csignal>
#include <functional>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fretwork::library::test {

/// The exit status of a child process that does `work`.
inline int status_of(const std::function<void()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        work();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
}

/// Kill a process of its own `delay` microseconds after it has begun `step`, which `prepare` gave. The
/// process waits for its end when the step is done, so that it is always a living one that is killed.
inline void kill_within(useconds_t delay, const std::function<std::function<void()>()>& prepare) {
    int begun[2];
    if (::pipe(begun) != 0) throw std::runtime_error("no pipe");
    const pid_t child = ::fork();
    if (child == 0) {
        const std::function<void()> step = prepare();
        (void)!::write(begun[1], "b", 1);
        step();
        while (true) ::pause();
    }
    ::close(begun[1]);
    char letter = 0;
    const bool has_begun = ::read(begun[0], &letter, 1) == 1;
    ::close(begun[0]);
    ::usleep(delay);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (!has_begun || !WIFSIGNALED(status))
        throw std::runtime_error("the process ended before it was killed");
}

/// Limit the files of this process to `bytes`. A write beyond raises SIGXFSZ, whose handler decides.
inline void limit_files(rlim_t bytes, void (*handler)(int)) {
    std::signal(SIGXFSZ, handler);
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
}

}  // namespace fretwork::library::test
