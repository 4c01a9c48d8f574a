// The open labels of a best-first search.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace alate {

/// Binary heap of label indices, least key first, equal keys in the order of the indices.
class LabelQueue {
 public:
  struct Entry {
    double key = 0;
    std::uint32_t label = 0;
  };

  bool empty() const { return entries_.empty(); }
  const Entry& top() const { return entries_.front(); }

  void push(double key, std::uint32_t label) {
    entries_.push_back({key, label});
    std::ranges::push_heap(entries_, is_later);
  }
  Entry pop() {
    std::ranges::pop_heap(entries_, is_later);
    const Entry least = entries_.back();
    entries_.pop_back();
    return least;
  }

 private:
  static bool is_later(const Entry& a, const Entry& b) {
    return a.key > b.key || (a.key == b.key && a.label > b.label);
  }
  std::vector<Entry> entries_;
};

}  // namespace alate
