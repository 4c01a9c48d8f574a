#include "out/output_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "alate/core/fault.hpp"

namespace alate {

namespace {

constexpr const char* kLockName = ".alate.lock";
constexpr mode_t kMode = 0666;  ///< As the user's umask allows.

InputError fault(const std::filesystem::path& folder, std::string message) {
  return InputError(Fault{.field = "--out", .value = folder.string(), .message = std::move(message)});
}

/// Is it the disk that fails, and not the folder that the user named?
bool is_disk_failure(int error) {
  return error == ENOSPC || error == EDQUOT || error == EFBIG || error == EIO || error == EMFILE || error == ENFILE;
}

[[noreturn]] void fail(const std::filesystem::path& file, int error) {
  const std::error_code code(error, std::generic_category());
  if (is_disk_failure(error)) throw std::system_error(code, "writing " + file.string());
  throw fault(file.parent_path(), "cannot write " + file.filename().string() + ": " + code.message());
}

std::filesystem::path made(const std::filesystem::path& folder) {
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  if (!code && std::filesystem::is_directory(folder, code)) return folder;
  if (is_disk_failure(code.value())) throw std::system_error(code, "making " + folder.string());
  throw fault(folder, code ? "cannot make the folder: " + code.message() : "is not a folder");
}

/// Is the locked file still the one in the folder? A run that ended just now may have removed it.
bool is_current(int fd, const std::filesystem::path& file) {
  struct stat held{};
  struct stat there{};
  return fstat(fd, &held) == 0 && stat(file.c_str(), &there) == 0 && held.st_ino == there.st_ino &&
         held.st_dev == there.st_dev;
}

Descriptor lock(const std::filesystem::path& folder) {
  const auto file = folder / kLockName;
  while (true) {
    Descriptor descriptor(open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, kMode));
    if (descriptor.get() < 0) fail(file, errno);
    if (flock(descriptor.get(), LOCK_EX | LOCK_NB) != 0) throw fault(folder, "another run is writing here");
    if (is_current(descriptor.get(), file)) return descriptor;
  }
}

}  // namespace

Descriptor::~Descriptor() {
  if (fd_ >= 0) close(fd_);
}

OutputFolder::OutputFolder(const std::string& folder) : folder_(made(folder)), lock_(lock(folder_)) {}

OutputFolder::~OutputFolder() {
  for (const std::string& name : written_) unlink(aside(name).c_str());
  unlink((folder_ / kLockName).c_str());
}

void OutputFolder::write(const std::string& name, const std::string& content) {
  const auto file = aside(name);
  const Descriptor descriptor(open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, kMode));
  if (descriptor.get() < 0) fail(file, errno);
  written_.push_back(name);
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t count = ::write(descriptor.get(), content.data() + done, content.size() - done);
    if (count < 0 && errno != EINTR) fail(file, errno);
    if (count > 0) done += static_cast<std::size_t>(count);
  }
}

void OutputFolder::publish() {
  for (const std::string& name : written_) {
    if (rename(aside(name).c_str(), (folder_ / name).c_str()) != 0) fail(folder_ / name, errno);
  }
  written_.clear();
}

void OutputFolder::remove(const std::string& name) {
  if (unlink((folder_ / name).c_str()) != 0 && errno != ENOENT) fail(folder_ / name, errno);
}

}  // namespace alate
