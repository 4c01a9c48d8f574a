// alate_peers: planners of OMPL on flights of alate, for `alate compare` (docs/compare.md tells the protocol).
//
//   alate_peers list                      names them, and says which cannot serve the scenario
//   alate_peers run NAME SECONDS SEED     hands over routes as they get better
//
// The scenario is read from standard input.
#include <fmt/core.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#include <sys/prctl.h>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <nlohmann/json.hpp>
#include <string>

#include "alate/data/scenario_file.hpp"
#include "alate/plan/registry.hpp"
#include "rivals.hpp"

namespace {

using namespace alate;
using namespace alate::peers;
using Json = nlohmann::ordered_json;

/// They fly what ours flies.
std::string refusal(const Problem& problem) {
  const std::string why = builtin_planners().find("interval-astar")->refuses(problem);
  return why.empty() ? "" : "it " + why;
}

void list(const World& world) {
  const std::string refuses = refusal(Problem(world));
  Json peers = Json::array();
  for (const Rival& rival : rivals())
    peers.push_back({{"name", rival.name}, {"help", fmt::format("OMPL: {}", rival.help)}, {"refuses", refuses}});
  fmt::print("{}\n", Json{{"peers", peers}}.dump());
}

void say(const char* word) {
  fmt::print("{}\n", Json{{word, true}}.dump());
  std::fflush(stdout);
}

template <class Number>
Number number(const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw InputError(Fault{.value = text, .message = "is not a number"});
  return value;
}

void run(const World& world, const std::vector<std::string>& words) {
  const auto rival = std::ranges::find(rivals(), words[1], &Rival::name);
  if (rival == rivals().end()) throw InputError(Fault{.value = words[1], .message = "is no peer"});
  const auto seconds = number<double>(words[2]);
  ompl::RNG::setSeed(number<std::uint_fast32_t>(words[3]));
  const Problem problem(world);
  if (const std::string why = refusal(problem); !why.empty()) throw InputError(Fault{.message = why});
  say("ready");
  Recorder recorder(problem, seconds);
  rival->run(recorder.legs(), recorder);
  say("done");
}

}  // namespace

int main(int argc, char** argv) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // It is no use to anyone without its parent.
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if (words != std::vector<std::string>{"list"} && (words.size() != 4 || words[0] != "run"))
      throw InputError(Fault{.message = "usage: alate_peers list, or alate_peers run NAME SECONDS SEED"});
    const World world(load_site(load_scenario("-")));
    if (words[0] == "list")
      list(world);
    else
      run(world, words);
  } catch (const std::exception& error) {
    fmt::print(stderr, "alate_peers: {}\n", error.what());
    return 2;
  }
  return 0;
}
