// One run's hold on an output folder: no other run writes there meanwhile, and files appear whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace alate {

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : fd_(other.fd_) { other.fd_ = -1; }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor& operator=(Descriptor&&) = delete;

  int get() const { return fd_; }

 private:
  int fd_;
};

class OutputFolder {
 public:
  /// Makes the folder if it is missing and locks it with `.alate.lock`. Throws InputError (field `--out`) if it cannot
  /// be made or written, or if another run holds it.
  explicit OutputFolder(const std::string& folder);
  /// Removes what was not published, and the lock.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Writes the file aside. Throws std::system_error if the disk fails.
  void write(const std::string& name, const std::string& content);
  /// Renames all files written aside to their names.
  void publish();
  /// Removes a file of an earlier run, if there is one.
  void remove(const std::string& name);

 private:
  std::filesystem::path aside(const std::string& name) const { return folder_ / ("." + name + ".tmp"); }

  std::filesystem::path folder_;
  Descriptor lock_;
  std::vector<std::string> written_;
};

}  // namespace alate
