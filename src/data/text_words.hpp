// The words of a line.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace alate {

/// Parts of a line between blanks and tabs; of long lines the first are kept and the others counted.
class TextWords {
 public:
  void split(std::string_view line) {
    constexpr std::string_view kBlanks = " \t";
    line_ = line;
    words_ = {};
    count_ = 0;
    for (std::size_t begin = line.find_first_not_of(kBlanks); begin < line.size(); ++count_) {
      const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
      if (count_ < words_.size()) words_.at(count_) = line.substr(begin, end - begin);
      begin = line.find_first_not_of(kBlanks, end);
    }
  }
  std::size_t count() const { return count_; }
  /// Empty behind the last word.
  std::string_view operator[](std::size_t word) const { return words_.at(word); }
  /// Where it begins, from 1.
  int column(std::size_t word) const { return static_cast<int>(words_.at(word).data() - line_.data()) + 1; }

 private:
  std::array<std::string_view, 12> words_;
  std::string_view line_;
  std::size_t count_ = 0;
};

}  // namespace alate
