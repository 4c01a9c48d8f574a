// Is a text well-formed as XML, as far as tags, attributes and escapes go?
#pragma once

#include <regex>
#include <string>
#include <vector>

namespace alate::test {

/// The tag with every quoted value emptied: std::regex recurses once a character, and points of drawings are long.
inline std::string without_values(const std::string& tag) {
  std::string result;
  bool quoted = false;
  for (const char c : tag) {
    if (!quoted || c == '"' || c == '<') result += c;
    if (c == '"') quoted = !quoted;
  }
  return result;
}

/// Empty if every tag is closed in order, attributes are quoted and no stray `<` or `&` is left; else what is wrong.
inline std::string xml_fault(std::string text) {
  const std::size_t style = text.find("<style>");
  if (style != std::string::npos) text.erase(style + 7, text.find("</style>") - style - 7);
  static const std::regex kEntity("&(?!(amp|lt|gt|quot|#39|#160);)");
  if (std::smatch m; std::regex_search(text, m, kEntity)) return "stray & at " + std::to_string(m.position());
  static const std::regex kTag(R"re(^<(/?)([A-Za-z][A-Za-z0-9]*)((?:\s+[A-Za-z][A-Za-z0-9:-]*="")*)\s*(/?)>)re",
                               std::regex::optimize);
  std::vector<std::string> open;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    if (text.compare(at, 2, "<?") == 0 || text.compare(at, 2, "<!") == 0) continue;
    const std::string tag = without_values(text.substr(at, text.find('>', at) - at + 1));
    std::smatch m;
    if (!std::regex_search(tag, m, kTag)) return "no tag: " + tag.substr(0, 80);
    if (m[4] == "/") continue;
    if (m[1] != "/") {
      open.push_back(m[2]);
    } else {
      if (open.empty() || open.back() != m[2]) return "closes what is not open: " + tag;
      open.pop_back();
    }
  }
  return open.empty() ? "" : "never closed: " + open.back();
}

}  // namespace alate::test
