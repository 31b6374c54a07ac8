#include "choice/methods/problems.hpp"

namespace brdfplot::choice {

std::vector<Problem> problems() {
  std::vector<Problem> all;
  for (const auto make : problem_list) all.push_back(make());
  return all;
}

} // namespace brdfplot::choice
