#include "data/scenario_writer.hpp"

#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "alate/data/scenario_file.hpp"
#include "data/scenario_fields.hpp"

namespace alate {

namespace {

/// JSON strings are YAML strings.
std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

class Writer {
 public:
  explicit Writer(Comments comments) : commented_(comments == Comments::all) {}

  /// `gap` comes before every field.
  std::string write(const Description& description, const char* gap = "") {
    std::string text;
    for (const Field& field : description.fields) text.append(gap).append(write(field));
    return text;
  }

 private:
  std::string write(const Field& field) {
    const std::string value =
        field.written ? std::visit([&](const auto& slot) { return value_of(slot); }, field.slot) : "";
    if (!commented_) return value.empty() ? "" : fmt::format("{}:{}\n", field.key, value);
    const std::string help = field.unit.empty() ? field.help : fmt::format("{} ({})", field.help, field.unit);
    if (value.starts_with('\n')) return fmt::format("# {}\n{}:{}\n", help, field.key, value);
    if (!value.empty()) return fmt::format("{}:{}  # {}\n", field.key, value, help);
    return fmt::format("# {}:{}  # {}\n", field.key, keys_of(field.slot), help);
  }

  /// The keys of a group that is not given: " {lat: , lon: }".
  static std::string keys_of(const Slot& slot) {
    const auto* group = std::get_if<Group>(&slot);
    if (group == nullptr) return "";
    std::vector<std::string> keys;
    for (const Field& field : group->open().fields) keys.push_back(field.key);
    return fmt::format(" {{{}: }}", fmt::join(keys, ": , "));
  }

  // What follows "key:", numbers in the fewest digits that read back to the same; empty if there is nothing to write.
  static std::string value_of(const Text& slot) { return slot.value ? fmt::format(" {}", quoted(*slot.value)) : ""; }
  static std::string value_of(const Flag& slot) { return slot.value ? " true" : " false"; }
  static std::string value_of(const Number& slot) { return slot.value ? fmt::format(" {}", *slot.value) : ""; }
  static std::string value_of(const Numbers& slot) {
    return slot.value.empty() ? "" : fmt::format(" [{}]", fmt::join(slot.value, ", "));
  }
  static std::string value_of(const Choice& slot) { return fmt::format(" {}", slot.words[slot.value]); }
  std::string value_of(const Group& slot) {
    const std::string inner = slot.present ? write(slot.open()) : "";
    return inner.empty() ? "" : fmt::format("\n{}", indented(inner, "  "));
  }
  /// Only the first item of a list carries comments.
  std::string value_of(const Groups& slot) const {
    std::string items;
    for (std::size_t i = 0; i < slot.count; ++i) {
      Writer writer(commented_ && i == 0 ? Comments::all : Comments::none);
      items += fmt::format("\n{}", indented(writer.write(slot.at(i)), "  - "));
    }
    return items;
  }
  std::string value_of(const FileOrGroups& slot) const {
    return slot.file.value ? value_of(slot.file) : value_of(slot.items);
  }
  static std::string value_of(const Words& slot) {
    std::string inner;
    for (const auto& [key, value] : *slot.values) inner += fmt::format("\n  {}: {}", quoted(key), quoted(value));
    return inner;
  }

  /// Every line indented, the first by `lead`; without the last line end.
  static std::string indented(const std::string& text, const std::string& lead) {
    std::string result = lead;
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
      result += text[i];
      if (text[i] == '\n') result += std::string(lead.size(), ' ');
    }
    return result;
  }

  bool commented_;
};

}  // namespace

std::string write_scenario(Scenario scenario, Comments comments) {
  return Writer(comments).write(describe(scenario), comments == Comments::all ? "\n" : "");
}

std::string to_yaml(const Scenario& scenario) { return write_scenario(scenario, Comments::none); }

}  // namespace alate
