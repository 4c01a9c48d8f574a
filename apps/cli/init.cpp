// alate init: a commented scenario to start from.
#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "alate/data/scenario_file.hpp"
#include "commands.hpp"

namespace alate::cli {

namespace {

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

int write_template(const std::string& name, const FaultList& faults) {
  faults.throw_if_any();
  // "x": made by us or not at all; what is there is never overwritten.
  std::unique_ptr<std::FILE, FileCloser> file(std::fopen(name.c_str(), "wx"));
  if (!file && errno == EEXIST) throw InputError(Fault{.file = name, .message = "is there already; it is left alone"});
  if (!file) throw InputError(Fault{.file = name, .message = fmt::format("cannot be written: {}", strerror(errno))});
  const std::string text = scenario_template();
  if (std::fputs(text.c_str(), file.get()) < 0 || std::fflush(file.get()) != 0) {
    std::remove(name.c_str());
    throw std::runtime_error(fmt::format("{} cannot be written: {}", name, strerror(errno)));
  }
  fmt::print("Wrote {}. Next: alate plan {}\n", name, name);
  return kDone;
}

}  // namespace

void add_init(CLI::App& app, Command& chosen) {
  const auto file = std::make_shared<Text>();
  CLI::App& command = *add_command(app, "init", "Write a commented scenario to start from", "alate init my.yaml");
  add_text(command, "FILE", *file, "file to write (default scenario.yaml); never overwritten");
  command.callback([&chosen, file] {
    chosen = [file](const FaultList& faults) { return write_template(file->value_or("scenario.yaml"), faults); };
  });
}

}  // namespace alate::cli
