#include "study/matrix/journal.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <system_error>

#include "alate/core/fault.hpp"
#include "study/matrix/checksum.hpp"
#include "study/matrix/record.hpp"

namespace alate {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* kPrefix = "journal-";
constexpr const char* kSuffix = ".jsonl";
constexpr mode_t kMode = 0666;  ///< As the user's umask allows.

fs::path journal_file(const std::string& folder, std::size_t rank) {
  return fs::path(folder) / fmt::format("{}{}{}", kPrefix, rank, kSuffix);
}

/// The JSON of a whole line; discarded if it is none.
Json parse_line(const std::string& line) {
  const std::size_t blank = line.find(' ');
  if (blank == std::string::npos || checksum(std::string_view(line).substr(blank + 1)) != line.substr(0, blank))
    return Json::value_t::discarded;
  return Json::parse(line.substr(blank + 1), nullptr, false);
}

/// Calls `use` for each line that counts and returns where the next one would begin.
std::streamoff for_lines(const fs::path& file, const std::function<void(const Json&)>& use) {
  std::ifstream stream(file, std::ios::binary);
  std::streamoff end = 0;
  for (std::string line; std::getline(stream, line) && !stream.eof();) {
    const Json json = parse_line(line);
    if (json.is_discarded()) break;
    use(json);
    end += static_cast<std::streamoff>(line.size()) + 1;
  }
  return end;
}

InputError other_study(const fs::path& file, const Study& study) {
  return InputError(Fault{.field = "--out",
                          .value = file.parent_path().string(),
                          .message = fmt::format("{} holds runs of another study than {}, or of another version; take "
                                                 "another folder, or remove the journals",
                                                 file.filename().string(), study.file)});
}

void read_journal(const fs::path& file, const Study& study, StudyRecords& records) {
  bool first = true;
  for_lines(file, [&](const Json& line) {
    if (first && line.value("study", "") != study.fingerprint) throw other_study(file, study);
    if (!first) {
      const auto job = line.at("job").get<std::size_t>();
      if (job < records.size()) records[job] = record_from(line.at("run"));
    }
    first = false;
  });
}

std::vector<fs::path> journals_in(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(kPrefix) && name.ends_with(kSuffix)) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

[[noreturn]] void refuse(const fs::path& file) {
  throw InputError(Fault{.field = "--out",
                         .value = file.parent_path().string(),
                         .message = fmt::format("cannot write {}: {}", file.filename().string(),
                                                std::error_code(errno, std::generic_category()).message())});
}

}  // namespace

StudyRecords read_journals(const Study& study, const std::string& folder) {
  StudyRecords records(study.jobs.size());
  for (const fs::path& file : journals_in(folder)) read_journal(file, study, records);
  return records;
}

Journal::Journal(const std::string& folder, std::size_t rank, const Study& study)
    : file_(journal_file(folder, rank)),
      descriptor_(open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, kMode)) {
  if (descriptor_.get() < 0) refuse(file_);
  const std::streamoff end = for_lines(file_, [](const Json&) {});
  if (ftruncate(descriptor_.get(), end) != 0) refuse(file_);
  if (end == 0) write_line(Json{{"study", study.fingerprint}, {"jobs", study.jobs.size()}}.dump());
}

void Journal::add(std::size_t job, const StudyRecord& record) {
  write_line(Json{{"job", job}, {"run", to_json_value(record)}}.dump());
}

void Journal::write_line(const std::string& json) {
  const std::string line = checksum(json) + " " + json + "\n";
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t count = write(descriptor_.get(), line.data() + done, line.size() - done);
    if (count < 0 && errno != EINTR)
      throw std::system_error(errno, std::generic_category(), "writing " + file_.string());
    if (count > 0) done += static_cast<std::size_t>(count);
  }
}

}  // namespace alate
