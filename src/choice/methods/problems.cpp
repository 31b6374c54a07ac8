#include "choice/methods/problems.hpp"

#include "choice/methods/add.hpp"

namespace brdfplot::choice {

std::vector<Problem> problems() {
  std::vector<Problem> all;
  for (const ListedProblem& listed : problem_list) all.push_back(listed.make());
  return all;
}

std::vector<std::string> problem_names() {
  std::vector<std::string> names;
  for (const ListedProblem& listed : problem_list) names.emplace_back(listed.name);
  return names;
}

std::optional<Problem> make_problem(const std::string& name) {
  for (const ListedProblem& listed : problem_list)
    if (listed.name == name) return listed.make();
  return std::nullopt;
}

Problem lambda_of_a(const std::string& name, const std::string& doc, const std::string& source, double largest,
                    std::function<Exact(std::span<const double>)> exact) {
  return {.name = name,
          .doc = doc,
          .source = source,
          .inputs = {{"a", "cot(theta) / alpha", 1e-4, largest, Scale::logarithmic, std::array<double, 2>{0.05, 20}}},
          .exact = std::move(exact),
          .methods = {},
          .least = 0,
          .monotone = {-1},
          .seen = [](double lambda) { return 1 / (1 + lambda); },
          .seen_as = "G1",
          .samples = 8192};
}

std::optional<Operations> operations_of(const Problem& problem, const std::string& name) {
  for (const Method& method : problem.methods)
    if (method.name == name) return method.operations;
  return std::nullopt;
}

} // namespace brdfplot::choice
