#include "choice/methods/problems.hpp"

#include "choice/methods/add.hpp"

namespace brdfplot::choice {

std::vector<Problem> problems() {
  std::vector<Problem> all;
  for (const auto make : problem_list) all.push_back(make());
  return all;
}

std::optional<Operations> operations_of(const Problem& problem, const std::string& name) {
  for (const Method& method : problem.methods)
    if (method.name == name) return method.operations;
  return std::nullopt;
}

} // namespace brdfplot::choice
