// SPDX-License-Identifier: GPL-3.0-or-later
// Child processes that are killed, or that find the disk full.
#pragma once

#include <csignal>
#include <functional>
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

/// Kill a process of its own that does `work` after so many microseconds. False if it had ended before.
inline bool kill_after(useconds_t delay, const std::function<void()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        work();
        ::_exit(0);
    }
    ::usleep(delay);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status);
}

/// Limit the files of this process to `bytes`. A write beyond raises SIGXFSZ, whose handler decides.
inline void limit_files(rlim_t bytes, void (*handler)(int)) {
    std::signal(SIGXFSZ, handler);
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
}

}  // namespace fretwork::library::test
