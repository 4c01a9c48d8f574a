// Runs a real program as a user would: arguments, standard input, folder; what it printed and how it ended.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alate::test {

struct Command {
  std::vector<std::string> words;  ///< Program first.
  std::string input;               ///< Standard input; empty: at its end from the start.
  std::filesystem::path folder;    ///< To run in; empty: this process's own.
};

struct Finished {
  int code = 0;  ///< Exit code; 128 + signal if a signal ended it; -1 if it took too long and was killed.
  std::string out;
  std::string err;
  double seconds = 0;
};

/// A new empty folder that goes away with this value.
class TempFolder {
 public:
  TempFolder();
  ~TempFolder();
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  bool empty() const { return std::filesystem::is_empty(path_); }

 private:
  std::filesystem::path path_;
};

/// A program while it runs. Its output goes through files, so that it can never block on us.
class Process {
 public:
  explicit Process(const Command& command);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void send(int signal) const;
  /// Has the program taken `signal` into its own hands (blocked it), which it does before it plans?
  bool blocks(int signal) const;
  /// Is it still running?
  bool running();
  /// Waits for the end; kills it after `limit_s`.
  Finished wait(double limit_s);

 private:
  TempFolder streams_;
  double started_s_;
  int pid_;
  std::optional<int> status_;
};

Finished run(const Command& command, double limit_s = 120);

void write_file(const std::filesystem::path& file, const std::string& text);
std::string read_file(const std::filesystem::path& file);

}  // namespace alate::test
