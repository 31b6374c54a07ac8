#include "base/threads/ranks.hpp"

#include "base/number.hpp"

#include <cstdlib>

namespace brdfplot {

Launched launched() {
  const auto number = [](const char* name) {
    const char* text = std::getenv(name);
    return text == nullptr ? std::nullopt : parse_number(text);
  };
  for (const auto& [rank, count] :
       {std::pair("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"), std::pair("PMI_RANK", "PMI_SIZE")})
    if (const auto n = number(count); n && *n >= 1 && *n <= 1e6)
      return {true, static_cast<int>(number(rank).value_or(0)), static_cast<int>(*n)};
  return {};
}

} // namespace brdfplot
