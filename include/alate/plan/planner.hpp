// The one wall with many rooms behind it: a planner as a value.
#pragma once

#include <memory>
#include <utility>

#include "alate/core/run_context.hpp"
#include "alate/world/problem.hpp"

namespace alate {

/// Copyable value over any type with `Plan plan(const Problem&, RunContext&) const`.
class Planner {
 public:
  template <class T>
  explicit Planner(T planner) : self_(std::make_shared<const Model<T>>(std::move(planner))) {}

  /// Never throws for an unsolvable problem; stops within milliseconds when `run` says so. The same problem,
  /// parameters, seed and iterations give the same plan to the last bit at any number of threads.
  Plan plan(const Problem& problem, RunContext& run) const { return self_->plan(problem, run); }

 private:
  struct Concept {
    virtual ~Concept() = default;
    virtual Plan plan(const Problem& problem, RunContext& run) const = 0;
  };
  template <class T>
  struct Model final : Concept {
    explicit Model(T planner) : planner_(std::move(planner)) {}
    Plan plan(const Problem& problem, RunContext& run) const override { return planner_.plan(problem, run); }
    T planner_;
  };
  std::shared_ptr<const Concept> self_;
};

}  // namespace alate
