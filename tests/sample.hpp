/// \file
/// What a run under sanitizers leaves out. They look at what the code does, not at the numbers that come out, and are
/// ten to thirty times slower: where many inputs walk the same code, some of them walk it there. ctest asks for that in
/// a sanitized build by BRDFPLOT_TEST_SAMPLE=1; without it every test takes every input, in every build.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

namespace test {

inline bool sampled() {
  static const bool asked = std::getenv("BRDFPLOT_TEST_SAMPLE") != nullptr;
  return asked;
}

/// How many inputs a test takes, or how fine a grid: `all`, or in a sampled run `some`.
template <class T>
T inputs(T all, T some) {
  return sampled() ? some : all;
}

/// The same of random inputs, of which the environment variable `name` may ask for any number.
inline std::size_t random_inputs(const char* name, std::size_t all, std::size_t some) {
  const char* const asked = std::getenv(name);
  return asked != nullptr ? std::stoul(asked) : inputs(all, some);
}

/// All of a list, or in a sampled run the first and each `step`th after it.
template <class T>
std::vector<T> sample_of(std::vector<T> all, std::size_t step) {
  if (!sampled()) return all;
  std::vector<T> some;
  for (std::size_t k = 0; k < all.size(); k += step) some.push_back(all[k]);
  return some;
}

} // namespace test
