#include "support/process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace alate::test {

namespace {

using namespace std::chrono_literals;

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void redirect(const std::filesystem::path& file, int flags, int stream) {
  const int opened = open(file.c_str(), flags, 0600);
  if (opened < 0 || dup2(opened, stream) < 0) _exit(127);
}

[[noreturn]] void become(Command command, const std::filesystem::path& streams) {
  redirect(streams / "in", O_RDONLY, STDIN_FILENO);
  redirect(streams / "out", O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
  redirect(streams / "err", O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
  if (!command.folder.empty() && chdir(command.folder.c_str()) != 0) _exit(127);
  std::vector<char*> words;
  words.reserve(command.words.size() + 1);
  for (std::string& word : command.words) words.push_back(word.data());
  words.push_back(nullptr);
  execv(words.front(), words.data());
  _exit(127);
}

/// Returns the process id.
int start(const Command& command, const std::filesystem::path& streams) {
  write_file(streams / "in", command.input);
  const int pid = fork();
  if (pid < 0) throw std::runtime_error("fork failed");
  if (pid == 0) become(command, streams);
  return pid;
}

int code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

TempFolder::TempFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "alate-test-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = pattern;
}

TempFolder::~TempFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

Process::Process(const Command& command) : started_s_(now_s()), pid_(start(command, streams_.path())) {}

Process::~Process() {
  if (running()) {
    send(SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
}

void Process::send(int signal) const { kill(pid_, signal); }

bool Process::blocks(int signal) const {
  // Until it becomes the program it is a copy of the test, which blocks signals while it is made.
  std::error_code gone;
  const std::string folder = "/proc/" + std::to_string(pid_);
  if (std::filesystem::equivalent(folder + "/exe", "/proc/self/exe", gone) || gone) return false;
  std::istringstream status(read_file(folder + "/status"));
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("SigBlk:")) return ((std::stoull(line.substr(7), nullptr, 16) >> (signal - 1)) & 1U) == 1;
  return false;
}

bool Process::running() {
  int status = 0;
  if (!status_ && waitpid(pid_, &status, WNOHANG) == pid_) status_ = status;
  return !status_;
}

Finished Process::wait(double limit_s) {
  while (running() && now_s() - started_s_ < limit_s) std::this_thread::sleep_for(2ms);
  const double seconds = now_s() - started_s_;
  int code = -1;
  if (running()) {
    send(SIGKILL);
    int status = 0;
    waitpid(pid_, &status, 0);
    status_ = status;
  } else {
    code = code_of(*status_);
  }
  return {.code = code, .out = read_file(streams_ / "out"), .err = read_file(streams_ / "err"), .seconds = seconds};
}

Finished run(const Command& command, double limit_s) { return Process(command).wait(limit_s); }

void write_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string read_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace alate::test
