#include "inputs.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace brdfplot::bench {

namespace {

template <class T>
Inputs<T> make() {
  std::mt19937_64 engine(1);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  Inputs<T> in;
  const auto add = [&](Directions<T>& to) {
    const double theta = uniform() * std::numbers::pi / 2, phi = uniform() * 2 * std::numbers::pi;
    to.x.push_back(static_cast<T>(std::sin(theta) * std::cos(phi)));
    to.y.push_back(static_cast<T>(std::sin(theta) * std::sin(phi)));
    to.z.push_back(static_cast<T>(std::cos(theta)));
    return theta;
  };
  for (std::size_t k = 0; k < count; ++k) {
    const double theta = add(in.o), alpha = std::pow(100.0, uniform() - 1);
    in.c.push_back(static_cast<T>(std::cos(theta)));
    in.s.push_back(static_cast<T>(alpha * std::sin(theta)));
    in.a.push_back(in.c.back() / in.s.back());
    add(in.i);
    if (k % batch == 0) in.alpha.push_back(static_cast<double>(static_cast<T>(alpha)));
  }
  return in;
}

} // namespace

template <>
const Inputs<double>& inputs() {
  static const Inputs<double> in = make<double>();
  return in;
}

template <>
const Inputs<float>& inputs() {
  static const Inputs<float> in = make<float>();
  return in;
}

} // namespace brdfplot::bench
