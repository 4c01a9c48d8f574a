#include "app.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <new>
#include <span>
#include <string_view>
#include <system_error>

#include "alate/core/version.hpp"
#include "alate/out/result.hpp"
#include "commands.hpp"

namespace alate::cli {

namespace {

constexpr const char* kAbout =
    "alate plans routes that an aircraft can really fly: round threats, over real terrain,\n"
    "within its turn and climb limits.";

constexpr const char* kFooter =
    "\nExample:\n  alate plan examples/jacksboro/scenario.yaml --out out/jacksboro\n"
    "\nExit codes: 0 done, nothing broken; 1 no route, or it breaks a rule; 2 bad input; 3 internal fault;\n"
    "130 interrupted, with the best so far written.";

std::string unknown_message(const CLI::App& app, const std::string& word) {
  std::vector<std::string> known;
  const bool option = word.starts_with("-");
  if (option) {
    for (const CLI::Option* each : app.get_options()) known.push_back(each->get_name());
  } else {
    for (const CLI::App* each : app.get_subcommands({})) known.push_back(each->get_name());
  }
  const std::string near = nearest(word.substr(0, word.find('=')), known);
  const std::string message = option ? "unknown option" : known.empty() ? "unexpected argument" : "unknown command";
  return near.empty() ? message : fmt::format("{}; did you mean {}?", message, near);
}

/// What CLI11 could not place, as faults beside those of the values.
void collect_unknown(const CLI::App& app, FaultList& faults) {
  for (const std::string& word : app.remaining()) faults.add({.file = word, .message = unknown_message(app, word)});
  for (const CLI::App* chosen : app.get_subcommands()) collect_unknown(*chosen, faults);
}

/// Help and version end the parse with a success; everything else that CLI11 throws is wrong usage.
int end_of_parse(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    app.exit(error);
    return kDone;
  }
  const auto chosen = app.get_subcommands();
  const std::string command = chosen.empty() ? "alate" : "alate " + chosen.front()->get_name();
  throw InputError(Fault{.file = command, .message = error.what()});
}

int parse_and_run(int argc, const char* const* argv) {
  CLI::App app(kAbout, "alate");
  app.footer(kFooter);
  app.set_version_flag("--version", fmt::format("alate {}", version()));
  app.require_subcommand(0, 1);
  app.allow_extras();
  Command command;
  add_plan(app, command);
  add_replan(app, command);
  add_check(app, command);
  add_planners(app, command);
  add_reproduce(app, command);
  add_study(app, command);
  add_compare(app, command);
  add_scen(app, command);
  add_generate(app, command);
  add_init(app, command);
  add_schema(app, command);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return end_of_parse(app, error);
  }
  FaultList faults;
  collect_unknown(app, faults);
  if (command) return command(std::move(faults));
  faults.throw_if_any();
  fmt::print(stderr, "{}", app.help());
  return kBadInput;
}

int report_faults(const InputError& error, bool json) {
  for (const Fault& fault : error.faults()) fmt::print(stderr, "alate: {}\n", to_string(fault));
  if (json) fmt::print("{}\n", to_json(error.faults()));
  return kBadInput;
}

int report_internal(std::string_view what) {
  fmt::print(stderr, "alate: internal fault: {}\n", what);
  return kInternalFault;
}

int run_with_messages(int argc, const char* const* argv) {
  const std::span words(argv, static_cast<std::size_t>(argc));
  const bool json = std::ranges::find(words, std::string_view("--json")) != words.end();
  try {
    return parse_and_run(argc, argv);
  } catch (const InputError& error) {
    return report_faults(error, json);
  } catch (const std::bad_alloc&) {
    return report_internal("not enough memory");
  } catch (const std::system_error& error) {
    return report_internal(fmt::format("the system refused: {}", error.what()));
  } catch (const std::exception& error) {
    return report_internal(error.what());
  }
}

}  // namespace

int run(int argc, const char* const* argv) noexcept {
  try {
    const int code = run_with_messages(argc, argv);
    return std::fflush(stdout) == 0 ? code : report_internal("standard output cannot be written");
  } catch (...) {
    return kInternalFault;
  }
}

}  // namespace alate::cli
