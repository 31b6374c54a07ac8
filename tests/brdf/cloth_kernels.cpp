// Cloth by kernels, against the equations as they are printed, with 50 digits, on every instruction set.
#include "../materials.hpp"
#include "../sample.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <doctest/doctest.h>

#include <array>
#include <functional>
#include <random>

using namespace test;

namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
using Pair = std::pair<Direction, Direction>;

Real pi() { return boost::math::constants::pi<Real>(); }
Real clamped(const Real& x) { return x < 0 ? Real(0) : x > 1 ? Real(1) : x; }

/// Inside, at the normal, near grazing, near each other and opposite.
std::vector<Pair> pairs() {
  std::vector<Pair> all;
  const std::array<double, 8> thetas = {0, 1e-9, 1e-4, 0.4, 1.1, 1.5, 1.5707, 1.5707963};
  for (const double theta_o : thetas)
    for (const double theta_i : thetas)
      for (const double phi : {0.0, 1e-7, 0.9, 2.4, std::numbers::pi})
        all.emplace_back(from_angles(theta_o, 0.3), from_angles(theta_i, 0.3 + phi));
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 300; ++k)
    all.emplace_back(from_angles(1.57 * unit(engine), 6 * unit(engine)),
                     from_angles(1.57 * unit(engine), 6 * unit(engine)));
  return all;
}

/// The largest error over the pairs and instruction sets, of the exact value or of `least`.
double worst_error(const Material& material, Quantity quantity, const std::vector<Pair>& all, double least,
                   const std::function<Real(const Direction&, const Direction&)>& exact) {
  const kernels::Isa before = kernels::active_isa();
  double worst = 0;
  for (const auto& [o, i] : all) {
    const Real wanted = exact(o, i);
    for (const kernels::Isa isa : kernels::available_isas()) {
      kernels::use_isa(isa);
      const double value = test::value(material, quantity, o, i);
      const double size = std::fmax(std::fabs(static_cast<double>(wanted)), least);
      const double error = std::fabs(static_cast<double>(Real(value) - wanted)) / size;
      worst = std::isnan(error) ? error : std::fmax(worst, error);
    }
    kernels::use_isa(before);
  }
  return worst;
}

TermDescription term_of(const std::string& type, const std::vector<std::pair<std::string, Value>>& values) {
  TermDescription term;
  term.type = type;
  for (const auto& [key, value] : values) term.values.set(key, value);
  return term;
}

/// sin^2 of the half vector, and its cosine.
std::pair<Real, Real> half_of(const Direction& o, const Direction& i) {
  const Real x = Real(o.x) + i.x, y = Real(o.y) + i.y, z = Real(o.z) + i.z, length2 = x * x + y * y + z * z;
  return {(x * x + y * y) / length2, z / sqrt(length2)};
}

Real fitted_lambda(double alpha, const Real& c) {
  const Real r = alpha, t = (1 - r) * (1 - r);
  const auto mix = [&](const char* at_0, const char* at_1) { return Real(t * Real(at_0) + (1 - t) * Real(at_1)); };
  const Real a = mix("25.3245", "21.5473"), b = mix("3.32435", "3.82987"), p = mix("0.16801", "0.19823");
  const Real d = mix("-1.27393", "-1.97760"), e = mix("-4.85967", "-4.32054");
  const auto l = [&](const Real& x) { return Real(a / (1 + b * (x > 0 ? Real(pow(x, p)) : Real(0))) + d * x + e); };
  const Real half = Real(1) / 2;
  return c < half ? Real(exp(l(c))) : Real(exp(2 * l(half) - l(1 - c)));
}

} // namespace

TEST_CASE("cloth: wrap lighting in its three readings, from below the horizon too") {
  auto all = pairs();
  for (const double theta : {1.5708, 1.7, 2.0, 2.2, 3.1})
    for (const double theta_o : {0.2, 1.5}) all.emplace_back(from_angles(theta_o, 1), from_angles(theta, 2));
  for (const std::string form : {"printed", "ratio", "conserving"})
    for (const double w : {0.0, 0.3, 1.0})
      for (const double scatter : {0.0, 0.4, 1.0}) {
        const Material m = build(term_of("wrap", {{"albedo", 0.5}, {"w", w}, {"form", form}, {"scatter", scatter}}));
        const auto light = [&](const Direction&, const Direction& i) -> Real {
          const Real l = i.z, up = l > 0 ? l : Real(0), from = l + w > 0 ? Real(l + w) : Real(0);
          const Real wrapped = form == "printed" ? Real(clamped(l + w) / (1 + Real(w)))
                               : form == "ratio" ? clamped(from / (1 + Real(w)))
                                                 : Real(from / ((1 + Real(w)) * (1 + Real(w))));
          return Real(0.5) / pi() * clamped(scatter + up) * wrapped;
        };
        CAPTURE(form);
        CAPTURE(w);
        CHECK(worst_error(m, Quantity::brdf_cos, sample_of(all, 5), 1e-3, light) < 1e-15);
        const auto rho = [&](const Direction& o, const Direction& i) -> Real {
          return i.z > 0 ? Real(light(o, i) / i.z) : Real(0);
        };
        CHECK(worst_error(m, Quantity::brdf, sample_of(all, 5), 1e-3, rho) < 1e-15);
      }
}

TEST_CASE("cloth: mirrors of sheen with the published fit and with the denominator of Eq. 9.74") {
  for (const double alpha : {1e-3, 0.05, 0.3, 1.0, 1e3})
    for (const bool fitted : {true, false}) {
      TermDescription term;
      term.distribution.type = "sheen";
      term.distribution.values.set("alpha", alpha);
      if (fitted && alpha > 1) continue; // the fit is for r up to 1
      if (fitted) term.masking.type = "sheen_fit";
      term.shadowing = ModelChoice{fitted ? "height_correlated" : "neubelt"};
      const Material m = build(term);
      const Real power = 1 / (2 * Real(alpha));
      const auto rho = [&](const Direction& o, const Direction& i) -> Real {
        const auto [sin2, z] = half_of(o, i);
        if (!(sin2 > 0)) return 0;
        const Real d = (1 + power) / pi() * exp(Real(power * log(sin2)));
        const Real v = o.z, l = i.z;
        if (!fitted) return d / (4 * (l + v - l * v));
        return d / (4 * l * v * (1 + fitted_lambda(alpha, v) + fitted_lambda(alpha, l)));
      };
      const auto with_cosine = [&](const Direction& o, const Direction& i) -> Real { return rho(o, i) * i.z; };
      CAPTURE(alpha);
      CAPTURE(fitted);
      // Of the power 1 / alpha the sine's rounding is felt so many times over.
      const double bound = 1e-14 + 2e-16 / alpha;
      CHECK(worst_error(m, Quantity::brdf, sample_of(pairs(), 5), 1e-3, rho) < bound);
      CHECK(worst_error(m, Quantity::brdf_cos, sample_of(pairs(), 5), 1e-3, with_cosine) < bound);
    }
}

TEST_CASE("cloth: powers of uncharted2 with exponents from none to a thousand, and cosines that are subnormal") {
  for (const double power : {1e-3, 0.1, 1.0, 30.0, 1e3}) {
    const Material m = build(term_of("uncharted2", {{"albedo", 1.0},
                                                    {"rim", 1.0},
                                                    {"rim_power", power},
                                                    {"inner", 1.0},
                                                    {"inner_power", power},
                                                    {"diffuse", 0.0}}));
    std::vector<Pair> all;
    const Direction i = from_angles(0.3, 0);
    for (const double v : {5e-324, 1e-310, 1e-300, 1e-17, 1e-3, 0.3, 0.5, 0.999, 1 - 1e-12, 1.0})
      all.emplace_back(Direction{1, 0, v}, i);
    const auto rho = [&](const Direction& o, const Direction&) -> Real {
      const Real v = o.z, rest = 1 - v;
      return (exp(Real(power * log(v))) + (rest > 0 ? Real(exp(Real(power * log(rest)))) : Real(0))) / pi();
    };
    CAPTURE(power);
    CHECK(worst_error(m, Quantity::brdf, all, 1, rho) < 1e-15);
  }
}
