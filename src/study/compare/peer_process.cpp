#include "study/compare/peer_process.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>

#include "alate/core/run_context.hpp"
#include "out/output_folder.hpp"

namespace alate {

namespace {

constexpr std::size_t kMaxLineBytes = 67'108'864;
constexpr int kPoll_ms = 20;
constexpr std::size_t kTailBytes = 4096;

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

/// A file without a name: gone with its last descriptor.
Descriptor nameless_file(const std::string& content) {
  std::string name = (std::filesystem::temp_directory_path() / "alate-peer-XXXXXX").string();
  Descriptor file(mkostemp(name.data(), O_CLOEXEC));
  if (file.get() < 0) fail("making a temporary file");
  unlink(name.c_str());
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t count = write(file.get(), content.data() + done, content.size() - done);
    if (count < 0 && errno != EINTR) fail("writing a temporary file");
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  lseek(file.get(), 0, SEEK_SET);
  return file;
}

/// The last line that says anything.
std::string last_line(int file) {
  const off_t size = lseek(file, 0, SEEK_END);
  std::array<char, kTailBytes> tail{};
  const off_t from = std::max<off_t>(0, size - static_cast<off_t>(tail.size()));
  const ssize_t count = pread(file, tail.data(), tail.size(), from);
  std::string text(tail.data(), static_cast<std::size_t>(std::max<ssize_t>(0, count)));
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  return text.substr(text.find_last_of('\n') + 1);
}

/// What the child is given: its streams, no signal blocked, a process group of its own.
class SpawnSetting {
 public:
  SpawnSetting(int input, int output, int error) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, error, STDERR_FILENO);
    posix_spawnattr_init(&attributes_);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnSetting() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSetting(const SpawnSetting&) = delete;
  SpawnSetting& operator=(const SpawnSetting&) = delete;

  /// Process id, or minus the error.
  pid_t spawn(std::vector<std::string> words) const {
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    pid_t pid = 0;
    const int error = posix_spawn(&pid, pointers.front(), &actions_, &attributes_, pointers.data(), environ);
    return error == 0 ? pid : -error;
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

class Child {
 public:
  explicit Child(const PeerCall& call) : error_(nameless_file("")) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("making a pipe");
    output_.emplace(ends[0]);
    const Descriptor writing(ends[1]);
    const Descriptor input = nameless_file(call.input);
    pid_ = SpawnSetting(input.get(), writing.get(), error_.get()).spawn(call.words);
  }
  ~Child() { end(); }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Why it was not started; empty if it was.
  std::string trouble() const { return pid_ > 0 ? "" : fmt::format("cannot be started: {}", std::strerror(-pid_)); }
  int output() const { return output_->get(); }
  std::string last_words() const { return last_line(error_.get()); }

  /// Has it ended by itself?
  bool has_ended() {
    int status = 0;
    if (!status_ && waitpid(pid_, &status, WNOHANG) == pid_) status_ = status;
    return status_.has_value();
  }
  PeerEnd own_end() const {
    if (WIFSIGNALED(*status_)) {
      const int signal = WTERMSIG(*status_);
      return {PeerEnding::aborted, fmt::format("signal {}, {}", signal, strsignal(signal))};
    }
    if (WEXITSTATUS(*status_) == 0) return {};
    return {PeerEnding::failed, fmt::format("exit code {}", WEXITSTATUS(*status_))};
  }

 private:
  /// The whole group: what it has started goes with it.
  void end() {
    if (pid_ <= 0) return;
    kill(-pid_, SIGKILL);
    int status = 0;
    if (!status_ && waitpid(pid_, &status, 0) == pid_) status_ = status;
  }

  Descriptor error_;
  std::optional<Descriptor> output_;
  pid_t pid_ = 0;
  std::optional<int> status_;
};

/// What it says, line by line, until it falls silent or a limit is over.
class Listener {
 public:
  Listener(Child& child, const PeerCall& call, const std::stop_token& stop, const HearPeer& hear)
      : child_(child), call_(call), hear_(hear), clock_(alone_, {.stop = stop}), deadline_s_(call.start_limit_s) {}

  PeerEnd listen() {
    while (const auto more = wait_for_words()) {
      if (!*more) return end_of_silence();
      if (!take_lines()) return {PeerEnding::rubbish, "said: " + line_.substr(0, 80)};
    }
    return interruption();
  }

 private:
  /// True with more to read, false at the end of its output, nothing when a limit is over.
  std::optional<bool> wait_for_words() {
    while (is_on()) {
      pollfd waiting{.fd = child_.output(), .events = POLLIN, .revents = 0};
      if (poll(&waiting, 1, kPoll_ms) <= 0) continue;
      std::array<char, 65'536> buffer{};
      const ssize_t count = read(child_.output(), buffer.data(), buffer.size());
      if (count == 0) return false;
      if (count < 0) continue;
      text_.append(buffer.data(), static_cast<std::size_t>(count));
      return true;
    }
    return std::nullopt;
  }

  bool take_lines() {
    std::size_t from = 0;
    for (std::size_t end = text_.find('\n'); end != std::string::npos; end = text_.find('\n', from)) {
      line_ = text_.substr(from, end - from);
      from = end + 1;
      if (!hear_(line_, clock_.elapsed_s())) return false;
      if (!spoken_) deadline_s_ = clock_.elapsed_s() + call_.limit_s;
      spoken_ = true;
    }
    text_.erase(0, from);
    if (text_.size() <= kMaxLineBytes) return true;
    line_ = text_.substr(0, kTailBytes);
    return false;
  }

  PeerEnd end_of_silence() {
    while (!child_.has_ended()) {
      if (!is_on()) return interruption();
      poll(nullptr, 0, 1);
    }
    return child_.own_end();
  }

  bool is_on() { return clock_.keep_going() && clock_.elapsed_s() < deadline_s_; }
  PeerEnd interruption() {
    if (!clock_.keep_going()) return {PeerEnding::stopped, ""};
    return {PeerEnding::hung, fmt::format("killed after {:.1f} s", clock_.elapsed_s())};
  }

  Child& child_;
  const PeerCall& call_;
  const HearPeer& hear_;
  Executor alone_{1};
  RunContext clock_;
  double deadline_s_;
  std::string text_;
  std::string line_;
  bool spoken_ = false;
};

}  // namespace

const char* to_string(PeerEnding ending) {
  switch (ending) {
    case PeerEnding::finished:
      return "finished";
    case PeerEnding::aborted:
      return "aborted";
    case PeerEnding::failed:
      return "failed";
    case PeerEnding::hung:
      return "hung";
    case PeerEnding::rubbish:
      return "rubbish";
    case PeerEnding::stopped:
      return "stopped";
  }
  return "";
}

PeerEnd call_peer(const PeerCall& call, const std::stop_token& stop, const HearPeer& hear) {
  Child child(call);
  if (const std::string trouble = child.trouble(); !trouble.empty()) return {PeerEnding::failed, trouble};
  PeerEnd end = Listener(child, call, stop, hear).listen();
  if (end.ending == PeerEnding::finished || end.ending == PeerEnding::stopped) return end;
  if (const std::string words = child.last_words(); !words.empty()) end.note += "; " + words;
  return end;
}

}  // namespace alate
