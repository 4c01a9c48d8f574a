#include <fmt/core.h>

#include <algorithm>

#include "alate/study/reproduce.hpp"

namespace alate {

namespace {

constexpr std::size_t kColumns = 100;
constexpr std::string_view kIndent = "    ";

/// Broken between words and indented.
std::string paragraph(std::string_view text) {
  std::string lines;
  std::size_t column = kColumns;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    const bool new_line = column + word.size() + 1 > kColumns;
    if (new_line) {
      if (!lines.empty()) lines += '\n';
      lines += kIndent;
      column = kIndent.size();
    } else {
      lines += ' ';
      ++column;
    }
    lines += word;
    column += word.size();
    text.remove_prefix(std::min(text.size(), word.size() + 1));
  }
  return lines + "\n";
}

std::string number(const std::optional<double>& value, int decimals) {
  return value ? fmt::format("{:.{}f}", *value, decimals) : "-";
}

std::string claim_text(const Claim& claim) {
  std::string text = fmt::format("{:<15} {}\n", to_string(claim.verdict), claim.text);
  if (claim.published || claim.ours) {
    const std::string unit = claim.unit.empty() ? "" : " " + claim.unit;
    text += fmt::format("{}published {}, ours {}{}", kIndent, number(claim.published, 2), number(claim.ours, 2), unit);
    for (std::size_t i = 0; i < claim.by_case.size(); ++i)
      text += fmt::format("{}{} {:.2f}", i == 0 ? ": " : ", ", claim.by_case[i].first, claim.by_case[i].second);
    text += '\n';
  }
  return text + paragraph(claim.why);
}

/// Rows of one width: names of methods differ much in length.
std::string cells_text(const std::vector<Cell>& cells) {
  std::size_t width = 0;
  for (const Cell& cell : cells) width = std::max(width, cell.method.size());
  std::string text = fmt::format("{:<10} {:<{}} {:>9} {:>9} {:>7} {:>9} {:>9} {:>9}\n", "case", "method", width,
                                 "found", "mean", "sd", "best", "bound", "wall_s");
  for (const Cell& cell : cells)
    text += fmt::format("{:<10} {:<{}} {:>9} {:>9} {:>7} {:>9} {:>9.2f} {:>9.4f}\n", cell.case_name, cell.method, width,
                        fmt::format("{}/{}", cell.found, cell.runs), number(cell.mean, 2), number(cell.sd, 2),
                        number(cell.best, 2), cell.lower_bound, cell.wall_s);
  return text;
}

}  // namespace

std::string to_text(const Reproduction& reproduction) {
  std::string text = fmt::format("{}: {}\n", reproduction.paper, reproduction.title);
  if (!reproduction.notes.empty()) text += "\nWhat must be known first\n\n";
  for (const std::string& note : reproduction.notes) text += paragraph(note);
  text += "\nClaims\n\n";
  for (const Claim& claim : reproduction.claims) text += claim_text(claim);
  text += "\nRuns\n\n" + cells_text(reproduction.cells);
  text += "\nWhat is wrong with the published definition\n\n";
  for (const Defect& defect : reproduction.defects)
    text += defect.title + "\n" + paragraph(defect.text + (defect.measured.empty() ? "" : " " + defect.measured));
  text += "\nSettings\n\n";
  for (const auto& [name, value] : reproduction.settings) text += fmt::format("{:<24} {}\n", name, to_text(value));
  return text;
}

}  // namespace alate
