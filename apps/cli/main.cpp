#include <fmt/core.h>

#include "alate/core/version.hpp"

int main() {
  fmt::print("alate {}\n", alate::version());
  return 0;
}
