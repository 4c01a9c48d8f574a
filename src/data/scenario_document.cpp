#include "data/scenario_document.hpp"

#include <fmt/core.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "data/limits.hpp"
#include "data/scenario_text.hpp"

namespace alate {

namespace {

Place place_of(const YAML::Mark& mark) { return {.line = mark.line + 1, .column = mark.column + 1}; }

/// Builds the tree from the parser's events. A node's children are complete when it is closed, so the open nodes
/// are kept on a stack.
class TreeBuilder final : public YAML::EventHandler {
 public:
  TreeBuilder(const std::string& file, std::vector<Fault>& faults) : file_(file), faults_(faults) {}

  Node root;

  void OnDocumentStart(const YAML::Mark& /*mark*/) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override { add({.place = place_of(mark)}); }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override {
    report(place_of(mark), "YAML aliases are not supported");
    add({.kind = Node::Kind::broken, .place = place_of(mark)});
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t /*anchor*/,
                const std::string& value) override {
    refuse_tag(mark, tag);
    add({.kind = Node::Kind::scalar, .text = value, .quoted = tag == "!", .place = place_of(mark)});
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t /*anchor*/,
                       YAML::EmitterStyle::value /*style*/) override {
    open(mark, tag, Node::Kind::list);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t /*anchor*/,
                  YAML::EmitterStyle::value /*style*/) override {
    open(mark, tag, Node::Kind::map);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override { close(); }

 private:
  /// A list or map under construction; `key` waits for its value in a map.
  struct Level {
    Node node;
    Node key;
    bool has_key = false;
    std::map<std::string, int> first_lines;
  };

  void report(const Place& place, std::string message, const std::string& field = "") {
    faults_.push_back({.file = file_,
                       .line = place.line,
                       .column = place.column,
                       .field = shortened(field),
                       .message = std::move(message)});
  }

  /// Dotted path of a key in the innermost open map.
  std::string path_of(const std::string& key) const {
    std::string path;
    for (std::size_t i = 0; i + 1 < levels_.size(); ++i) {
      const Level& level = levels_[i];
      const bool in_list = level.node.kind == Node::Kind::list;
      path += (in_list ? std::to_string(level.node.children.size()) : level.key.text) + ".";
    }
    return path + key;
  }

  void refuse_tag(const YAML::Mark& mark, const std::string& tag) {
    if (!tag.empty() && tag != "?" && tag != "!") report(place_of(mark), "YAML tags are not supported");
  }

  void open(const YAML::Mark& mark, const std::string& tag, Node::Kind kind) {
    refuse_tag(mark, tag);
    if (levels_.size() == kMaxNesting) {
      throw InputError({.file = file_,
                        .line = place_of(mark).line,
                        .column = place_of(mark).column,
                        .limit = fmt::format("{}", kMaxNesting),
                        .unit = "levels",
                        .message = "groups and lists are nested too deeply"});
    }
    levels_.push_back({.node = {.kind = kind, .place = place_of(mark)}});
  }

  void close() {
    Node done = std::move(levels_.back().node);
    levels_.pop_back();
    add(std::move(done));
  }

  void add(Node node) {
    if (levels_.empty()) {
      root = std::move(node);
      return;
    }
    Level& level = levels_.back();
    if (level.node.kind == Node::Kind::list) {
      level.node.children.push_back(std::move(node));
    } else if (!level.has_key) {
      level.key = std::move(node);
      level.has_key = true;
    } else {
      level.has_key = false;
      add_entry(level, std::move(node));
    }
  }

  void add_entry(Level& level, Node node) {
    const Node& key = level.key;
    if (key.kind == Node::Kind::broken) return;
    if (key.kind != Node::Kind::scalar) return report(key.place, "a key must be a word");
    const auto [first, is_new] = level.first_lines.emplace(key.text, key.place.line);
    if (!is_new)
      return report(key.place, fmt::format("given twice, first in line {}", first->second), path_of(key.text));
    node.key = key.text;
    node.key_place = key.place;
    level.node.children.push_back(std::move(node));
  }

  const std::string& file_;
  std::vector<Fault>& faults_;
  std::vector<Level> levels_;
};

}  // namespace

const Node* Node::find(const std::string& name) const {
  const auto found = std::ranges::find(children, name, &Node::key);
  return kind != Kind::map || found == children.end() ? nullptr : &*found;
}

Node* Node::find(const std::string& name) {
  const auto found = std::ranges::find(children, name, &Node::key);
  return kind != Kind::map || found == children.end() ? nullptr : &*found;
}

Node parse_document(const std::string& text, const std::string& file, std::vector<Fault>& faults) {
  std::istringstream stream(text);
  TreeBuilder builder(file, faults);
  try {
    YAML::Parser parser(stream);
    parser.HandleNextDocument(builder);
    Node root = std::move(builder.root);
    if (parser.HandleNextDocument(builder)) faults.push_back({.file = file, .message = "holds more than one document"});
    return root;
  } catch (const YAML::Exception& error) {
    const Place place = place_of(error.mark);
    faults.push_back({.file = file, .line = place.line, .column = place.column, .message = "YAML: " + error.msg});
  } catch (const InputError& error) {
    faults.push_back(error.faults().front());
  }
  return {.kind = Node::Kind::broken};
}

}  // namespace alate
