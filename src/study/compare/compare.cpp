// Who takes part in a comparison, and the runs.
#include "alate/study/compare.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <set>

#include "study/compare/peers.hpp"
#include "study/run_loop.hpp"

namespace alate {

namespace {

constexpr std::array kPercents{1, 3, 10, 30, 100};  ///< Of the whole time.

std::string rules_of(const Verdict& verdict) {
  std::string rules;
  std::set<std::string> seen;
  for (const Violation& violation : verdict.violations)
    if (seen.insert(violation.rule).second) rules += (rules.empty() ? "" : ", ") + violation.rule;
  for (const NotChecked& rule : verdict.not_checked)
    if (rule.unknown && seen.insert(rule.rule).second) rules += (rules.empty() ? "" : ", ") + rule.rule + " (unknown)";
  return rules;
}

struct Judged {
  CompareMark mark;
  Verdict verdict;
};

Judged judge(const Site& site, const Route& route) {
  Judged judged{.mark = {.metrics = measure(site, route)}, .verdict = check(site, route)};
  judged.mark.standing = judged.verdict.ok() ? Standing::passed : Standing::refused;
  judged.mark.broken = rules_of(judged.verdict);
  return judged;
}

/// A contender of ours, ready to run.
struct OwnPlanner {
  Contender contender;
  Planner planner;
};

class Comparer {
 public:
  Comparer(const World& world, const CompareOptions& options)
      : site_(world.site()), problem_(world), options_(options), comparison_{.world = world, .seeds = options.seeds} {
    for (const int percent : kPercents) comparison_.times_s.push_back(percent * options.seconds / 100);
    gather_planners();
    gather_peers();
    choose();
  }

  Comparison run() {
    std::uint64_t done = 0;
    std::uint64_t all = 0;
    for (const Contender& contender : comparison_.contenders) all += contender.chance ? options_.seeds : 1;
    for (std::uint64_t seed = 1; seed <= options_.seeds; ++seed) {
      for (std::size_t c = 0; c < comparison_.contenders.size() && !comparison_.stopped; ++c) {
        if (seed > 1 && !comparison_.contenders[c].chance) continue;
        CompareRun run = c < planners_.size() ? run_own(c, seed) : run_other(c, seed);
        comparison_.stopped = options_.stop.stop_requested();
        if (comparison_.stopped) break;
        comparison_.runs.push_back(std::move(run));
        ++done;
        if (options_.on_progress)
          options_.on_progress({.iteration = done, .fraction = static_cast<double>(done) / static_cast<double>(all)});
      }
    }
    return std::move(comparison_);
  }

 private:
  void gather_planners() {
    for (const PlannerEntry& entry : builtin_planners().entries()) {
      if (std::string why = entry.refuses(problem_); !why.empty()) {
        comparison_.refusals.push_back({entry.name, "it " + why});
        continue;
      }
      const ChosenPlanner chosen = choose_planner(builtin_planners(), problem_, {.name = entry.name});
      planners_.push_back({.contender = {.name = chosen.name,
                                         .preset = chosen.preset,
                                         .help = entry.help,
                                         .peer = false,
                                         .chance = !entry.can_on(site_).deterministic},
                           .planner = chosen.planner});
    }
  }

  void gather_peers() {
    if (options_.peers.empty()) {
      comparison_.notes.emplace_back("No program with planners of others was found: only ours are compared.");
      return;
    }
    const PeerList list = list_peers(options_.peers, site_, options_.stop);
    if (list.end.ending != PeerEnding::finished)
      comparison_.notes.push_back(fmt::format("{} could not be asked for its planners: {}, {}.", options_.peers,
                                              to_string(list.end.ending), list.end.note));
    for (const PeerPlanner& peer : list.planners) {
      if (peer.refuses.empty())
        peers_.push_back({.name = peer.name, .preset = "", .help = peer.help, .peer = true});
      else
        comparison_.refusals.push_back({peer.name, peer.refuses});
    }
  }

  bool is_wanted(const std::string& name) const {
    return options_.only.empty() || std::ranges::find(options_.only, name) != options_.only.end();
  }

  /// Those asked for; faults for names that cannot be had.
  void choose() {
    std::vector<std::string> known;
    for (const OwnPlanner& planner : planners_) known.push_back(planner.contender.name);
    for (const Contender& peer : peers_) known.push_back(peer.name);
    std::vector<Fault> faults;
    for (const std::string& name : options_.only) {
      const auto refusal = std::ranges::find(comparison_.refusals, name, &CompareRefusal::name);
      if (std::ranges::find(known, name) != known.end()) continue;
      if (refusal != comparison_.refusals.end())
        faults.push_back({.file = "--only", .value = name, .message = "cannot plan this: " + refusal->why});
      else
        faults.push_back(unknown_name({.file = "--only"}, "planner", name, known));
    }
    if (known.empty())
      faults.push_back({.file = site_.scenario.file, .message = "no planner can plan this: see alate plan"});
    throw_if_any(std::move(faults));
    std::erase_if(planners_, [&](const OwnPlanner& each) { return !is_wanted(each.contender.name); });
    std::erase_if(peers_, [&](const Contender& each) { return !is_wanted(each.name); });
    for (const OwnPlanner& planner : planners_) comparison_.contenders.push_back(planner.contender);
    comparison_.contenders.insert(comparison_.contenders.end(), peers_.begin(), peers_.end());
  }

  /// One run for each time. A run that ended before its time would end no other way with more.
  CompareRun run_own(std::size_t contender, std::uint64_t seed) {
    CompareRun result{.contender = contender, .seed = seed};
    std::optional<StudyRun> run;
    Judged judged;
    for (const double time_s : comparison_.times_s) {
      if (!run || run->plan.stop != Stop::finished) {
        run = run_once(planners_[contender].planner, problem_,
                       {.time_limit_s = time_s, .seed = seed, .stop = options_.stop});
        judged = run->plan.route.empty() ? Judged{} : judge(site_, run->plan.route);
        judged.mark.took_s = run->wall_s;
        comparison_.lower_bound = std::max(comparison_.lower_bound, run->plan.lower_bound);
      }
      result.marks.push_back(judged.mark);
      const bool late = run->wall_s > with_grace(time_s);
      if (late && judged.mark.has_route()) result.marks.back().standing = Standing::late;
    }
    result.route = std::move(run->plan.route);
    result.verdict = std::move(judged.verdict);
    return result;
  }

  /// One run for all times: at each of them what counts is the cheapest route so far that passes the check.
  CompareRun run_other(std::size_t contender, std::uint64_t seed) {
    const PeerTask task{.program = options_.peers,
                        .name = comparison_.contenders[contender].name,
                        .seconds = options_.seconds,
                        .seed = seed};
    const PeerRun run = run_peer(task, site_, options_.stop);
    CompareRun result{.contender = contender,
                      .seed = seed,
                      .routes = run.routes.size(),
                      .ending = to_string(run.end.ending),
                      .note = run.end.note};
    std::vector<Judged> judged;
    for (const PeerRoute& each : run.routes) {
      judged.push_back(judge(site_, each.route));
      judged.back().mark.took_s = each.time_s;
      result.refused += judged.back().mark.standing == Standing::refused ? 1U : 0U;
    }
    for (const double time_s : comparison_.times_s) {
      const auto best = best_by(judged, with_grace(time_s));
      result.marks.push_back(best ? judged[*best].mark : CompareMark{.took_s = time_s});
      if (!best) continue;
      result.route = run.routes[*best].route;
      result.verdict = judged[*best].verdict;
    }
    return result;
  }

  /// The cheapest that passes, of those there by then; if none does, the last one.
  static std::optional<std::size_t> best_by(const std::vector<Judged>& judged, double time_s) {
    std::optional<std::size_t> best;
    const auto passes = [&](std::size_t i) { return judged[i].mark.standing == Standing::passed; };
    for (std::size_t i = 0; i < judged.size(); ++i) {
      if (judged[i].mark.took_s > time_s) continue;
      const bool better =
          !best || (passes(i) ? !passes(*best) || judged[i].mark.metrics.cost < judged[*best].mark.metrics.cost
                              : !passes(*best));
      if (better) best = i;
    }
    return best;
  }

  const Site& site_;
  Problem problem_;
  const CompareOptions& options_;
  Comparison comparison_;
  std::vector<OwnPlanner> planners_;
  std::vector<Contender> peers_;
};

}  // namespace

const char* to_string(Standing standing) {
  switch (standing) {
    case Standing::passed:
      return "passed";
    case Standing::refused:
      return "refused";
    case Standing::late:
      return "late";
    case Standing::none:
      return "none";
  }
  return "";
}

double with_grace(double time_s) {
  constexpr double kShare = 0.05;
  constexpr double kLeast_s = 0.005;
  return time_s + std::max(kShare * time_s, kLeast_s);
}

Comparison compare_planners(const World& world, const CompareOptions& options) {
  return Comparer(world, options).run();
}

}  // namespace alate
