#include "accuracy/directions.hpp"

#include <numbers>

namespace brdfplot::accuracy {

namespace {

using Vector = std::array<double, 3>;

/// theta uniform, or close to 0 or to pi / 2 on either side; phi uniform or on an axis.
Vector draw_direction(Random& random) {
  const double kind = random.uniform();
  double sine = 0, cosine = 1;
  if (kind < 0.5) {
    const double theta = random.uniform(0, 1.6);
    sine = std::sin(theta), cosine = std::cos(theta);
  } else if (kind < 0.75) {
    sine = random.log_uniform(1e-300, 1);
    cosine = std::sqrt((1 - sine) * (1 + sine));
  } else {
    cosine = random.log_uniform(random.chance(0.5) ? 1e-16 : 1e-60, 1) * (random.chance(0.1) ? -1 : 1);
    sine = std::sqrt((1 - cosine) * (1 + cosine));
  }
  if (random.chance(0.05)) return random.chance(0.5) ? Vector{sine, 0, cosine} : Vector{0, -sine, cosine};
  const double phi = random.uniform(0, 2 * std::numbers::pi);
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

Vector unit(const Vector& v) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

/// The normal of a slope within a few roughnesses of the mean.
Vector draw_normal(Random& random, const kernels::Stretch& k) {
  const double r = 4 * random.uniform(), phi = random.uniform(0, 2 * std::numbers::pi);
  const double u = r * std::cos(phi), v = r * std::sin(phi);
  const double across = std::sqrt((1 - k.correlation) * (1 + k.correlation));
  return unit({-(k.mean_x + k.alpha_x * u), -(k.mean_y + k.alpha_y * (k.correlation * u + across * v)), 1});
}

/// A direction whose projected area of the mesosurface all but vanishes.
Vector draw_horizon(Random& random, const kernels::Stretch& k) {
  const double phi = random.uniform(0, 2 * std::numbers::pi);
  const double x = std::cos(phi), y = std::sin(phi);
  const double lift = random.log_uniform(1e-16, 1e-2) * (random.chance(0.2) ? -1 : 1);
  return unit({x, y, x * k.mean_x + y * k.mean_y + lift});
}

template <class T>
kernels::Stretch draw_stretch(Random& random, const std::string& domain) {
  kernels::Stretch k;
  k.alpha_x = k.alpha_y = random.log_uniform(1e-6, 1e3);
  if (domain == "isotropic") return k;
  k.alpha_y = std::min(1e3, std::max(1e-6, k.alpha_x * random.log_uniform(1e-4, 1e4)));
  const bool sheared = domain.starts_with("sheared") || domain == "near the mean slope";
  if (domain == "correlation to 1" || sheared) {
    const double gap = random.chance(0.5) ? random.uniform() : random.log_uniform(sizeof(T) == 8 ? 1e-15 : 1e-7, 1);
    k.correlation = (1 - gap) * (random.chance(0.5) ? -1 : 1);
  }
  if (sheared) {
    k.mean_x = random.uniform(-2, 2);
    k.mean_y = random.uniform(-2, 2);
  }
  return k;
}

template <class T>
Pair<T> draw_pair(Random& random, const std::string& domain, const kernels::Stretch& k) {
  Vector o = draw_direction(random), i = draw_direction(random);
  if (domain == "sheared horizon") {
    o = draw_horizon(random, k);
    if (random.chance(0.5)) i = draw_horizon(random, k);
  } else if (domain == "omega_i -> omega_o") {
    const double step = random.chance(0.2) ? 0 : random.log_uniform(1e-17, 1e-2);
    i = {o[0] + step * random.uniform(-1, 1), o[1] + step * random.uniform(-1, 1), o[2] + step * random.uniform(-1, 1)};
  } else if (domain == "omega_i -> -omega_o") {
    // Both above the horizon, so both close to it.
    const double phi = random.uniform(0, 2 * std::numbers::pi), z = random.log_uniform(1e-60, 1e-3);
    o = {std::sqrt((1 - z) * (1 + z)) * std::cos(phi), std::sqrt((1 - z) * (1 + z)) * std::sin(phi), z};
    const double step = random.chance(0.2) ? 0 : random.log_uniform(1e-17, 1e-2);
    i = {-o[0] + step * random.uniform(-1, 1), -o[1] + step * random.uniform(-1, 1), random.log_uniform(1e-60, 1e-3)};
  } else if (domain == "near the mean slope") {
    o = draw_normal(random, k);
    i = random.chance(0.5) ? o : draw_normal(random, k);
  }
  const auto rounded = [](const Vector& v) {
    return std::array<T, 3>{static_cast<T>(v[0]), static_cast<T>(v[1]), static_cast<T>(v[2])};
  };
  return {rounded(o), rounded(i)};
}

} // namespace

template <class T>
std::vector<Case<T>> draw_cases(const std::string& domain, std::size_t n) {
  Random random(5);
  std::vector<Case<T>> cases;
  for (std::size_t k = 0; k < n; k += 50) {
    Case<T> in{draw_stretch<T>(random, domain), {}};
    for (double* p :
         {&in.stretch.alpha_x, &in.stretch.alpha_y, &in.stretch.correlation, &in.stretch.mean_x, &in.stretch.mean_y}) {
      // GCC 12 at -O3 vectorises these conversions there and back, and drops them both; volatile keeps them.
      const volatile T rounded = static_cast<T>(*p);
      *p = static_cast<double>(rounded);
    }
    for (int j = 0; j < 50; ++j) in.pairs.push_back(draw_pair<T>(random, domain, in.stretch));
    cases.push_back(std::move(in));
  }
  return cases;
}

template <class T>
std::string text(const Case<T>& in, const Pair<T>& pair) {
  const kernels::Stretch& k = in.stretch;
  std::string out = "alpha = " + text(k.alpha_x) + " " + text(k.alpha_y) + " r = " + text(k.correlation) +
                    " mean = " + text(k.mean_x) + " " + text(k.mean_y) + " o =";
  for (const T x : pair.o) out += " " + text(static_cast<double>(x));
  out += " i =";
  for (const T x : pair.i) out += " " + text(static_cast<double>(x));
  return out;
}

template std::vector<Case<double>> draw_cases(const std::string&, std::size_t);
template std::vector<Case<float>> draw_cases(const std::string&, std::size_t);
template std::string text(const Case<double>&, const Pair<double>&);
template std::string text(const Case<float>&, const Pair<float>&);

} // namespace brdfplot::accuracy
