#include "alate/study/reproduce.hpp"

#include <algorithm>
#include <array>

#include "alate/core/fault.hpp"
#include "out/output_folder.hpp"
#include "study/konatowski2019/reproduction.hpp"
#include "study/mai2023/reproduction.hpp"
#include "study/yin2021/reproduction.hpp"
#include "study/zhou2020/reproduction.hpp"

namespace alate {

namespace {

using Reproduce = std::optional<Reproduction> (*)(Executor&, const ReproduceOptions&);

struct Paper {
  const char* name;
  Reproduce reproduce;
};

constexpr std::array<Paper, 4> kPapers{{{"konatowski2019", konatowski2019::reproduce},
                                        {"mai2023", mai2023::reproduce},
                                        {"yin2021", yin2021::reproduce},
                                        {"zhou2020", zhou2020::reproduce}}};

auto find(std::string_view paper) {
  return std::ranges::find(kPapers, paper, [](const Paper& each) { return std::string_view(each.name); });
}

Fault unknown_paper(const std::string& paper) {
  const std::vector<std::string> known = reproducible_papers();
  Fault fault{.field = "PAPER", .value = paper, .message = "unknown paper"};
  if (const std::string near = nearest(paper, known); !near.empty()) fault.message += "; did you mean " + near + "?";
  for (const std::string& name : known) fault.limit += (fault.limit.empty() ? "" : " | ") + name;
  return fault;
}

}  // namespace

const char* to_string(ClaimVerdict verdict) {
  switch (verdict) {
    case ClaimVerdict::holds:
      return "holds";
    case ClaimVerdict::does_not_hold:
      return "does_not_hold";
    case ClaimVerdict::impossible:
      return "impossible";
    case ClaimVerdict::cannot_be_told:
      break;
  }
  return "cannot_be_told";
}

std::vector<std::string> reproducible_papers() {
  std::vector<std::string> names;
  for (const Paper& paper : kPapers) names.emplace_back(paper.name);
  return names;
}

void require_reproducible(const std::string& paper) {
  if (find(paper) == kPapers.end()) throw InputError(unknown_paper(paper));
}

std::optional<Reproduction> reproduce(const std::string& paper, Executor& executor, const ReproduceOptions& options) {
  require_reproducible(paper);
  return find(paper)->reproduce(executor, options);
}

std::vector<std::string> write_reproduction(const std::string& folder, const Reproduction& reproduction) {
  OutputFolder output(folder);
  output.write("reproduce.html", reproduction.page);
  output.write("reproduce.json", to_json(reproduction));
  output.publish();
  return {"reproduce.html", "reproduce.json"};
}

}  // namespace alate
