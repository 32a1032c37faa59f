// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/optimization/methods/detail/child_process.hpp>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace fretwork::optimization::detail {
namespace {

constexpr int kPause = 20;  ///< ms between two looks at the control

[[noreturn]] void refuse(const std::string& command, int fault) {
    throw base::IoError(command, "", std::string("cannot be started: ") + std::strerror(fault));
}

/// The state in which the command starts: standard input and output on the socket, default signals, a
/// process group of its own.
class Beginning {
  public:
    explicit Beginning(int socket) {
        ::posix_spawn_file_actions_init(&files_);
        for (const int stream : {STDIN_FILENO, STDOUT_FILENO})
            ::posix_spawn_file_actions_adddup2(&files_, socket, stream);
        ::posix_spawnattr_init(&attributes_);
        sigset_t none;
        ::sigemptyset(&none);
        ::posix_spawnattr_setsigmask(&attributes_, &none);
        sigset_t usual;
        ::sigemptyset(&usual);
        for (const int signal : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM, SIGHUP}) ::sigaddset(&usual, signal);
        ::posix_spawnattr_setsigdefault(&attributes_, &usual);
        ::posix_spawnattr_setpgroup(&attributes_, 0);
        ::posix_spawnattr_setflags(&attributes_,
                                   POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
    }
    ~Beginning() {
        ::posix_spawnattr_destroy(&attributes_);
        ::posix_spawn_file_actions_destroy(&files_);
    }
    Beginning(const Beginning&) = delete;
    Beginning& operator=(const Beginning&) = delete;

    /// Start a shell that runs the command. Returns an error number; 0 if the shell was started.
    int spawn(std::string command, pid_t& process) const {
        std::string shell = "sh";
        std::string option = "-c";
        const std::array<char*, 4> arguments = {shell.data(), option.data(), command.data(), nullptr};
        return ::posix_spawnp(&process, "sh", &files_, &attributes_, arguments.data(), environ);
    }

  private:
    posix_spawn_file_actions_t files_{};
    posix_spawnattr_t attributes_{};
};

int exit_code_of(int status) {
    constexpr int kKilled = 128;
    return WIFEXITED(status) ? WEXITSTATUS(status) : kKilled + WTERMSIG(status);
}

/// True if the process has ended. The process is not reaped, so its id stays in use.
bool has_ended(pid_t process) {
    siginfo_t info{};
    return ::waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == process;
}

}  // namespace

ChildProcess::ChildProcess(const std::string& command, const base::Control& control)
    : control_(control.silent()) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) refuse(command, errno);
    socket_ = ends[0];
    const int fault = Beginning(ends[1]).spawn(command, process_);
    ::close(ends[1]);
    if (fault == 0) return;
    ::close(socket_);
    refuse(command, fault);
}

ChildProcess::~ChildProcess() {
    ::close(socket_);
    if (process_ == 0) return;
    ::kill(-process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
}

bool ChildProcess::wait_for(short event, const std::function<bool()>& gives_up) const {
    pollfd look{socket_, event, 0};
    for (;;) {
        control_.check();
        if (::poll(&look, 1, kPause) > 0) return true;
        if (gives_up()) return false;
    }
}

bool ChildProcess::receive() {
    std::array<char, 4096> part{};
    const ssize_t size = ::recv(socket_, part.data(), part.size(), MSG_DONTWAIT);
    if (size < 0) return errno == EAGAIN || errno == EINTR;
    unread_.append(part.data(), static_cast<std::size_t>(size));
    return size > 0;
}

std::optional<std::string> ChildProcess::read_line(const std::function<bool()>& gives_up) {
    std::size_t end = unread_.find('\n', next_);
    while (end == std::string::npos) {
        if (kept() > kLongestLine) throw base::InputError("a line of more than a mebibyte");
        const std::size_t before = unread_.size();
        if (!wait_for(POLLIN, gives_up)) return std::nullopt;
        if (!receive()) return std::nullopt;  // a last line without LF is dropped
        end = unread_.find('\n', before);
    }
    std::string line = unread_.substr(next_, end - next_);
    next_ = end + 1;
    if (2 * next_ > unread_.size()) {  // less often than each line, because what is behind it moves
        unread_.erase(0, next_);
        next_ = 0;
    }
    if (line.ends_with('\r')) line.pop_back();
    return line;
}

void ChildProcess::write_line(const std::string& text, const std::function<bool()>& gives_up) {
    const std::string line = text + "\n";
    bool is_open = true;
    for (std::size_t sent = 0; sent < line.size();) {
        // A command whose own writing waits for this program would never read.
        const bool receives = is_open && !is_full();
        if (!wait_for(static_cast<short>(receives ? POLLIN | POLLOUT : POLLOUT), gives_up)) return;
        const ssize_t size =
            ::send(socket_, line.data() + sent, line.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
        if (size >= 0) {
            sent += static_cast<std::size_t>(size);
        } else if (errno == EAGAIN) {
            if (gives_up()) return;
            if (receives) is_open = receive();
        } else if (errno != EINTR) {
            return;
        }
    }
}

std::optional<int> ChildProcess::finish() {
    constexpr auto kPatience = std::chrono::seconds(1);
    constexpr auto kStep = std::chrono::milliseconds(2);
    ::shutdown(socket_, SHUT_WR);
    const auto last = std::chrono::steady_clock::now() + kPatience;
    while (!has_ended(process_) && std::chrono::steady_clock::now() <= last) {
        control_.check();
        std::this_thread::sleep_for(kStep);
    }
    const bool is_in_time = has_ended(process_);
    ::kill(-process_, SIGKILL);  // also the processes that it has started
    int status = 0;
    ::waitpid(process_, &status, 0);
    process_ = 0;
    return is_in_time ? std::optional(exit_code_of(status)) : std::nullopt;
}

}  // namespace fretwork::optimization::detail
