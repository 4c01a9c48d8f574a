// One of several policies, picked by parameters; asked once a step or less often, where it costs little.
#pragma once

#include <variant>

namespace alate {

template <class... Policies>
struct OneOf {
  std::variant<Policies...> policy;

  template <class... Arguments>
  decltype(auto) operator()(Arguments&&... arguments) const {
    return std::visit([&](const auto& one) -> decltype(auto) { return one(arguments...); }, policy);
  }
  template <class... Arguments>
  decltype(auto) operator()(Arguments&&... arguments) {
    return std::visit([&](auto& one) -> decltype(auto) { return one(arguments...); }, policy);
  }
};

}  // namespace alate
