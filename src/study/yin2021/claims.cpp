#include "study/yin2021/claims.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "study/yin2021/findings.hpp"

namespace alate::yin2021 {

namespace {

using Ask = Finding (*)(const Study&, std::size_t reading);

struct Asked {
  const char* id = nullptr;
  const char* text = nullptr;
  std::optional<double> published;
  const char* unit = nullptr;
  Ask ask = nullptr;
};

constexpr std::array<Asked, 13> kClaims{{
    {"length", "1. The route is 6.4 % shorter than the baseline's (map not stated; ours: 30x30)", kLengthChange_percent,
     "%", length},
    {"variance", "2. The variance of the best length over 30 runs is 85.78 % smaller (map not stated; ours: 30x30)",
     kVarianceChange_percent, "%", variance},
    {"turns-10x10", "3. 10x10: the best route has fewer turns, 4 against 6", -2.0, "turns", fewer_turns},
    {"turns-30x30", "4. 30x30: the best route has more turns, 19 against 16, yet is shorter", 3.0, "turns",
     more_turns_yet_shorter},
    {"mean-length-10x10", "5. 10x10: mean best lengths hardly differ", {}, "%", equal_lengths},
    {"first-length-10x10",
     "6. 10x10: in the first iteration the route is longer than the baseline's, later shorter",
     {},
     "%",
     longer_then_shorter},
    {"height-10x10", "7. 10x10: the height deviation is steady within 5 iterations, the baseline's later", 5.0, "",
     heights_settle_small},
    {"height-30x30", "8. 30x30: the height deviation is steady within 10 iterations, the baseline's later", 10.0, "",
     heights_settle_large},
    {"turns-curve-10x10",
     "9. 10x10: turns are equal at first and drop to fewer after iteration 5; the baseline's stay",
     {},
     "turns",
     turns_drop},
    {"first-length-30x30",
     "10. 30x30: in the first iteration the route is shorter than the baseline's",
     {},
     "%",
     first_length_shorter},
    {"composite", "11. Both: S and the ants' mean S are lower and settle earlier", {}, "%", better_scores},
    {"iterations", "12. Both: fewer iterations to the final length", {}, "", settles_earlier},
    {"equal-height",
     "13. Both: at the start the height deviations are equal, though the lengths are not",
     {},
     "%",
     equal_heights},
}};

/// "Another verdict under other readings: holds: as coded, no bounds."
std::string other_readings(const Study& study, const Asked& asked, ClaimVerdict main) {
  std::string words;
  for (const ClaimVerdict verdict : {ClaimVerdict::holds, ClaimVerdict::does_not_hold, ClaimVerdict::cannot_be_told}) {
    if (verdict == main) continue;
    std::string names;
    for (std::size_t r = 1; r < readings().size(); ++r)
      if (asked.ask(study, r).verdict == verdict) names += (names.empty() ? "" : ", ") + readings()[r].name;
    if (names.empty()) continue;
    std::string said = to_string(verdict);
    std::ranges::replace(said, '_', ' ');
    words += fmt::format("{} it {} with: {}", words.empty() ? " Under other readings" : ";", said, names);
  }
  return words.empty() ? " The same under every other reading." : words + ".";
}

Claim claim(const Study& study, const Asked& asked) {
  const Finding main = asked.ask(study, 0);
  Claim claim{.id = asked.id,
              .text = asked.text,
              .published = asked.published,
              .ours = main.ours,
              .unit = asked.unit,
              .verdict = main.verdict,
              .why = {},
              .by_case = main.by_case};
  for (const ClaimPart& part : main.parts) claim.why += (claim.why.empty() ? "" : " ") + part.words;
  claim.why += main.more + other_readings(study, asked, main.verdict);
  return claim;
}

}  // namespace

std::vector<Claim> claims(const Study& study) {
  std::vector<Claim> all;
  for (const Asked& asked : kClaims) all.push_back(claim(study, asked));
  return all;
}

}  // namespace alate::yin2021
