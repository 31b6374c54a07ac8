// Closed forms of diffuse and cloth terms against the equations as they are printed (Disney's f_ss: also as its
// source has it), with 50 digits and h = normalised (o + i).
#include "../materials.hpp"
#include "../sample.hpp"
#include "analysis/integrals.hpp"
#include "analysis/properties.hpp"
#include "analysis/property_tests.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <doctest/doctest.h>

#include <array>
#include <functional>
#include <random>

using namespace test;

namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

/// Of a pair of directions.
struct Cosines {
  Real v, l, lv, lh, nh;
};

Cosines cosines(const Direction& o, const Direction& i) {
  const std::array<Real, 3> a = {o.x, o.y, o.z}, b = {i.x, i.y, i.z};
  const Real length =
      sqrt(Real((a[0] + b[0]) * (a[0] + b[0]) + (a[1] + b[1]) * (a[1] + b[1]) + (a[2] + b[2]) * (a[2] + b[2])));
  // l.h of unit vectors is half the length of their sum; of rounded ones, whose length is not 1, it is so within 1e-16
  // of that length, which is much where o and i are opposite.
  return {a[2], b[2], a[0] * b[0] + a[1] * b[1] + a[2] * b[2], length / 2, (a[2] + b[2]) / length};
}

Real pi() { return boost::math::constants::pi<Real>(); }
Real fifth_of(const Real& x) { return pow(x, 5); }
Real schlick(const Real& f0, const Real& c) { return f0 + (1 - f0) * fifth_of(1 - c); }

Real shirley(const Real& f0, const Cosines& p) {
  return Real(21) / 20 * (1 - f0) * (1 - fifth_of(1 - p.l)) * (1 - fifth_of(1 - p.v));
}

Real fujii(const Real& r, const Cosines& p) {
  const Real s = p.lv - p.l * p.v;
  const Real t = s > 0 ? (p.l > p.v ? p.l : p.v) : Real(1);
  const Real k1 = Real(1) / 2 - 2 / (3 * pi());
  return (1 + r * s / t) / ((1 + k1 * r) * pi());
}

Real fujii_albedo(const Real& r, const Real& mu) {
  const Real k1 = Real(1) / 2 - 2 / (3 * pi()), a = 1 / (1 + k1 * r), s = sqrt(Real(1 - mu * mu));
  const Real g = s * (acos(mu) - s * mu) + Real(2) / 3 * (s / mu * (1 - s * s * s) - s);
  return a + r * a / pi() * g;
}

Real eon(const Real& rho, const Real& r, const Cosines& p) {
  const Real k1 = Real(1) / 2 - 2 / (3 * pi()), k2 = Real(2) / 3 - 28 / (15 * pi());
  const Real mean = (1 + k2 * r) / (1 + k1 * r);
  const Real multiple = rho * rho * mean / (1 - rho * (1 - mean));
  const Real further =
      r == 0 ? Real(0) : multiple / pi() * (1 - fujii_albedo(r, p.v)) * (1 - fujii_albedo(r, p.l)) / (1 - mean);
  return rho * fujii(r, p) + further;
}

Real disney(const Real& alpha, const Real& k, bool printed, const Cosines& p) {
  const Real m_l = fifth_of(1 - p.l), m_v = fifth_of(1 - p.v), ss90 = sqrt(alpha) * p.lh * p.lh;
  const Real d90 = Real(1) / 2 + 2 * ss90;
  const Real fd = (1 + (d90 - 1) * m_l) * (1 + (d90 - 1) * m_v);
  const Real fs = (1 + (ss90 - 1) * m_l) * (1 + (ss90 - 1) * m_v);
  const Real among = printed ? p.l * p.v : p.l + p.v;
  return ((1 - k) * fd + Real(5) / 4 * k * ((1 / among - Real(1) / 2) * fs + Real(1) / 2)) / pi();
}

Real hammon(const Real& rho, const Real& f0, const Real& alpha, const Cosines& p) {
  const Real facing = (1 + p.lv) / 2;
  const Real rough = facing * (Real(9) / 10 - Real(4) / 10 * facing) * (Real(1) / 2 + p.nh) / p.nh;
  return rho / pi() * ((1 - alpha) * shirley(f0, p) + alpha * rough + rho * Real(3641) / 10000 * alpha);
}

Real velvet_cloth(const Real& rho, const Real& f0, const Real& alpha, const Real& k, const Cosines& p) {
  const Real f = schlick(f0, p.lh), c2 = p.nh * p.nh, s2 = 1 - c2;
  const Real d = (1 + k * exp(Real(-c2 / (alpha * alpha * s2))) / (s2 * s2)) / (pi() * (1 + k * alpha * alpha));
  return (1 - f) * rho / pi() + f * d / (4 * (p.l + p.v - p.l * p.v));
}

struct Case {
  std::string type;
  std::vector<std::pair<std::string, Value>> values;
  std::function<Real(const Cosines&)> rho;
};

Real real(double x) { return Real(x); }

/// Each with parameters inside and at the ends of their domains.
std::vector<Case> cases() {
  std::vector<Case> all;
  for (const double f0 : {0.0, 0.04, 0.9}) {
    for (const std::string at : {"normal", "half"})
      all.push_back({"fresnel_lambert", {{"albedo", 0.5}, {"f0", f0}, {"at", at}}, [=](const Cosines& p) -> Real {
                       return real(0.5) / pi() * (1 - schlick(f0, at == "half" ? p.lh : p.l));
                     }});
    all.push_back({"shirley", {{"albedo", 0.5}, {"f0", f0}}, [=](const Cosines& p) -> Real {
                     return real(0.5) / pi() * shirley(f0, p);
                   }});
    for (const double alpha : {0.0, 0.3, 1.0})
      all.push_back({"hammon_diffuse", {{"albedo", 0.7}, {"f0", f0}, {"alpha", alpha}}, [=](const Cosines& p) -> Real {
                       return hammon(0.7, f0, alpha, p);
                     }});
    for (const double alpha : {0.01, 0.3, 1.0})
      all.push_back({"velvet_cloth",
                     {{"albedo", 0.7}, {"f0", f0}, {"alpha", alpha}, {"amplitude", 4.0}},
                     [=](const Cosines& p) -> Real { return velvet_cloth(0.7, f0, alpha, 4, p); }});
  }
  for (const double r : {0.0, 1e-8, 0.4, 1.0})
    for (const double rho : {0.3, 1.0}) {
      all.push_back({"fujii_oren_nayar", {{"albedo", rho}, {"roughness", r}}, [=](const Cosines& p) -> Real {
                       return rho * fujii(r, p);
                     }});
      all.push_back(
          {"eon", {{"albedo", rho}, {"roughness", r}}, [=](const Cosines& p) -> Real { return eon(rho, r, p); }});
    }
  for (const double alpha : {0.0, 0.25, 1.0})
    for (const double k : {0.0, 0.4, 1.0})
      for (const bool printed : {false, true})
        all.push_back({"disney_diffuse",
                       {{"albedo", 1.0}, {"alpha", alpha}, {"subsurface", k}, {"printed", printed}},
                       [=](const Cosines& p) -> Real { return disney(alpha, k, printed, p); }});
  all.push_back(
      {"disney_sheen", {{"color", 0.8}}, [](const Cosines& p) -> Real { return real(0.8) * fifth_of(1 - p.lh); }});
  all.push_back(
      {"uncharted2",
       {{"albedo", 0.5}, {"rim", 2.0}, {"rim_power", 3.5}, {"inner", 0.5}, {"inner_power", 2.0}, {"diffuse", 0.25}},
       [](const Cosines& p) -> Real {
         return real(0.5) / pi() * (2 * pow(p.v, real(3.5)) + real(0.5) * pow(1 - p.v, real(2)) + real(0.25));
       }});
  return all;
}

TermDescription describe_term(const std::string& type, const std::vector<std::pair<std::string, Value>>& values) {
  TermDescription term;
  term.type = type;
  for (const auto& [key, value] : values) term.values.set(key, value);
  return term;
}

/// Pairs above the horizon, in and out of the plane, near the normal, near grazing, near each other and opposite.
std::vector<std::pair<Direction, Direction>> pairs() {
  std::vector<std::pair<Direction, Direction>> all;
  const std::array<double, 9> thetas = {0, 1e-9, 1e-4, 0.4, 1.1, 1.5, 1.5707, 1.5707963, 1.570796326794};
  for (const double theta_o : thetas)
    for (const double theta_i : thetas)
      for (const double phi : {0.0, 1e-7, 0.9, 1.5707963, 2.4, std::numbers::pi})
        all.emplace_back(from_angles(theta_o, 0.3), from_angles(theta_i, 0.3 + phi));
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 300; ++k)
    all.emplace_back(from_angles(1.57 * unit(engine), 6 * unit(engine)),
                     from_angles(1.57 * unit(engine), 6 * unit(engine)));
  return all;
}

double furnace_at_89(const TermDescription& term) {
  return compute(Integral::furnace, build(term), from_angles(89 * degree, 0), 1e-7).value;
}

Verdict verdict_of(Property property, const TermDescription& term) {
  const PropertySubject subject{MaterialDescription(term)};
  WorstResidual worst(1e-6);
  test_property(property, subject, {}, worst);
  return worst.residual().verdict;
}

} // namespace

TEST_CASE("diffuse terms: the printed equations with 50 digits, at every angle and at the ends of each parameter") {
  // The directions have a length of 1 within 1e-16, which the equations feel as several roundings near grazing.
  constexpr double bound = 4e-15;
  const kernels::Isa before = kernels::active_isa();
  for (const Case& one : cases()) {
    const Material m = build(describe_term(one.type, one.values));
    double worst = 0;
    for (const auto& [o, i] : sample_of(pairs(), 7)) {
      const Real exact = one.rho(cosines(o, i));
      // What all but vanishes is compared with what it is elsewhere. Where o and i are opposite at grazing, 1 + r s
      // does; the rounding of the directions determines it to 1e-16.
      const bool of_s = one.type == "eon" || one.type == "fujii_oren_nayar";
      const double scale = std::fmax(std::fabs(static_cast<double>(exact)), of_s ? 1e-2 : 1e-3);
      for (const kernels::Isa isa : kernels::available_isas()) {
        kernels::use_isa(isa);
        const double value = test::value(m, Quantity::brdf, o, i);
        const double error = std::fabs(static_cast<double>(Real(value) - exact)) / scale;
        worst = std::fmax(worst, std::isnan(value) ? value : error);
        REQUIRE(!std::isnan(value));
      }
      kernels::use_isa(before);
    }
    CAPTURE(one.type);
    CHECK(worst <= bound);
  }
}

TEST_CASE("diffuse terms: a row is the same to the last bit alone and in a batch, in one channel and in three") {
  const auto all = pairs();
  std::array<std::vector<double>, 6> d;
  for (const auto& [o, i] : all) {
    const std::array<double, 6> row = {o.x, o.y, o.z, i.x, i.y, i.z};
    for (std::size_t k = 0; k < 6; ++k) d[k].push_back(row[k]);
  }
  const Batch batch{all.size(), {d[0].data(), d[1].data(), d[2].data()}, {d[3].data(), d[4].data(), d[5].data()}, {}};
  const kernels::Isa before = kernels::active_isa();
  for (const kernels::Isa isa : kernels::available_isas()) {
    kernels::use_isa(isa);
    for (const Case& one : cases()) {
      auto coloured = one.values;
      const double colour = std::get<double>(coloured[0].second);
      coloured[0].second = Rgb{0.25, colour, 1};
      const Material m = build(describe_term(one.type, one.values)), rgb = build(describe_term(one.type, coloured));
      for (const Quantity q : {Quantity::brdf, Quantity::brdf_cos}) {
        std::vector<double> values(all.size()), channels(3 * all.size());
        evaluate(m, q, batch, values.data());
        evaluate(rgb, q, batch, channels.data());
        std::size_t differ = 0;
        for (std::size_t k = 0; k < all.size(); ++k)
          differ += values[k] != value(m, q, all[k].first, all[k].second) || values[k] != channels[all.size() + k];
        CAPTURE(one.type);
        CHECK(differ == 0);
      }
    }
  }
  kernels::use_isa(before);
}

TEST_CASE("diffuse terms: disney_sheen keeps its digits where it vanishes, and is 0 for o = i") {
  const Material m = build(describe_term("disney_sheen", {{"color", 0.8}}));
  const kernels::Isa before = kernels::active_isa();
  double worst = 0;
  for (const auto& [o, i] : pairs()) {
    // 1 - l.h = |o - i|^2 / (4 (1 + l.h)).
    const Real x = Real(o.x) - i.x, y = Real(o.y) - i.y, z = Real(o.z) - i.z, apart = x * x + y * y + z * z;
    if (apart > 0 && apart < 1e-14) continue;
    const Real exact = real(0.8) * fifth_of(apart / (4 + 4 * cosines(o, i).lh));
    for (const kernels::Isa isa : kernels::available_isas()) {
      kernels::use_isa(isa);
      const Real error = test::value(m, Quantity::brdf, o, i) - exact;
      worst = std::fmax(worst, apart > 0 ? std::fabs(static_cast<double>(error / exact)) : error == 0 ? 0 : infinity);
    }
    kernels::use_isa(before);
  }
  CHECK(worst <= 5e-15);
}

TEST_CASE("diffuse terms: those without a fused operation have the same bytes on every instruction set") {
  const kernels::Isa before = kernels::active_isa();
  for (const Material& m : {build(describe_term("lambert", {{"albedo", 0.3}})),
                            build(describe_term("fresnel_lambert", {{"albedo", 0.3}, {"f0", 0.1}})),
                            build(describe_term("shirley", {{"albedo", 0.3}, {"f0", 0.1}})),
                            build(describe_term("oren_nayar", {{"sigma", 0.3}, {"form", std::string("qualitative")}}))})
    for (const Quantity q : {Quantity::brdf, Quantity::brdf_cos})
      for (const auto& [o, i] : pairs()) {
        kernels::use_isa(kernels::Isa::baseline);
        const double expected = value(m, q, o, i);
        for (const kernels::Isa isa : kernels::available_isas()) {
          kernels::use_isa(isa);
          REQUIRE(value(m, q, o, i) == expected);
        }
      }
  kernels::use_isa(before);
}

TEST_CASE("diffuse terms: rho cos where rho itself is too large for a number") {
  const auto alone = [](const std::string& type, const std::vector<std::pair<std::string, Value>>& values) {
    return build(describe_term(type, values));
  };
  for (const double l : {1e-300, 1e-308, 1e-310, 5e-324}) {
    const Direction o{1, 0, l}, i{0, 1, l};
    // w / (l + v) = 1/2 and w / max(l, v) = 1; h is (1, 1, 2 l) / sqrt 2, and what is not divided by l vanishes.
    CHECK(value(alone("velvet_cloth", {{"alpha", 1.0}, {"f0", 1.0}, {"amplitude", 0.0}}), Quantity::brdf_cos, o, i) ==
          doctest::Approx(0.125 * std::numbers::inv_pi).epsilon(1e-14));
    // F_ss at grazing is ss90^2, ss90 = (h.l)^2 = 1/2.
    CHECK(value(alone("disney_diffuse", {{"alpha", 1.0}, {"subsurface", 1.0}}), Quantity::brdf_cos, o, i) ==
          doctest::Approx(1.25 * std::numbers::inv_pi * 0.5 * 0.25).epsilon(1e-14));
    // k (0.9 - 0.4 k) n.h^-1 / 2 with k = (l.h)^2 = 1/2: (0.9 - 0.4 k) k (l.h) / (l + v).
    CHECK(value(alone("hammon_diffuse", {{"alpha", 1.0}}), Quantity::brdf_cos, o, i) ==
          doctest::Approx(std::numbers::inv_pi * 0.7 * 0.5 * std::sqrt(0.5) * 0.5).epsilon(1e-14));
    // tan beta cos = 1: 0.45 s / (s + 0.09) in the plane.
    CHECK(value(alone("oren_nayar", {{"sigma", 0.3}, {"form", std::string("qualitative")}}), Quantity::brdf_cos, o,
                o) == doctest::Approx(std::numbers::inv_pi * 0.225).epsilon(1e-14));
    CHECK(value(alone("fujii_oren_nayar", {{"roughness", 1.0}}), Quantity::brdf_cos, o, o) ==
          doctest::Approx(std::numbers::inv_pi / (1.5 - 2 / (3 * std::numbers::pi))).epsilon(1e-14));
    CHECK(value(alone("eon", {{"roughness", 1.0}}), Quantity::brdf_cos, o, o) ==
          doctest::Approx(std::numbers::inv_pi / (1.5 - 2 / (3 * std::numbers::pi))).epsilon(1e-14));
  }
}

TEST_CASE("diffuse terms: nothing at and below the horizon") {
  for (const Case& one : cases()) {
    const Material m = build(describe_term(one.type, one.values));
    const Direction up = from_angles(0.4, 0);
    for (const Direction& down :
         {Direction{1, 0, 0}, from_angles(2, 1), Direction{0, 0, -1}, Direction{-up.x, 0, -up.z}})
      for (const Quantity q : {Quantity::brdf, Quantity::brdf_cos}) {
        CHECK(value(m, q, up, down) == 0);
        CHECK(value(m, q, down, up) == 0);
        CHECK(value(m, q, down, down) == 0);
      }
  }
}

TEST_CASE("diffuse terms: opposite directions at grazing, whose sum is too short to be squared") {
  const Material m =
      build(describe_term("velvet_cloth", {{"albedo", 0.5}, {"f0", 0.5}, {"alpha", 1.0}, {"amplitude", 100.0}}));
  for (const double e : {1e-150, 1e-160, 1e-165, 1e-170, 1e-250}) {
    // h does not depend on e: (0, 1, 2), normalised. mpmath, 400 digits.
    CHECK(value(m, Quantity::brdf_cos, {1, e, e}, {-1, 0, e}) == doctest::Approx(0.018432465608075196).epsilon(1e-14));
  }
}

TEST_CASE("diffuse terms: albedos that are known") {
  for (const double theta : {0.0, 0.6, 1.2, 1.5, 1.5706}) {
    const Direction o = from_angles(theta, 0.4);
    for (const double r : {0.0, 0.3, 1.0}) {
      const auto albedo = [&](const std::string& type, double rho) {
        return compute(Integral::albedo, build(describe_term(type, {{"albedo", rho}, {"roughness", r}})), o, 1e-8);
      };
      const Estimate white = albedo("eon", 1), one = albedo("fujii_oren_nayar", 1), half = albedo("eon", 0.5);
      CHECK(std::fabs(white.value - 1) <= white.error + 1e-13);
      const double closed = static_cast<double>(fujii_albedo(r, o.z));
      CHECK(std::fabs(one.value - closed) <= one.error + 1e-13);
      // rho E + rho_ms (1 - E), Portsmouth, Kutz and Hill 2024.
      const Real k1 = Real(1) / 2 - 2 / (3 * pi()), k2 = Real(2) / 3 - 28 / (15 * pi());
      const auto mean = static_cast<double>(Real((1 + k2 * r) / (1 + k1 * r)));
      const double multiple = 0.25 * mean / (1 - 0.5 * (1 - mean));
      CHECK(std::fabs(half.value - (0.5 * closed + multiple * (1 - closed))) <= half.error + 1e-13);
      CHECK(white.error <= 1e-8);
    }
    // int (1 - (1 - c)^5) c dc = 1/2 - 1/42: the mean of what leaves is 21/20 of it.
    const Estimate shirley =
        compute(Integral::albedo, build(describe_term("shirley", {{"albedo", 1.0}, {"f0", 0.0}})), o, 1e-8);
    CHECK(std::fabs(shirley.value - (1 - std::pow(1 - o.z, 5))) <= shirley.error + 1e-13);
  }
}

TEST_CASE("diffuse terms: which are reciprocal is measured, in every channel") {
  for (const Case& one : cases()) {
    const bool of_one_direction = one.type == "uncharted2" || (one.type == "fresnel_lambert" &&
                                                               std::get<std::string>(one.values[2].second) == "normal");
    CAPTURE(one.type);
    CHECK((verdict_of(Property::reciprocity, describe_term(one.type, one.values)) == Verdict::fails) ==
          of_one_direction);
  }
  // Red and green are black.
  CHECK(verdict_of(Property::reciprocity, describe_term("fresnel_lambert", {{"f0", Rgb{1, 1, 0.04}}})) ==
        Verdict::fails);
}

TEST_CASE("diffuse terms: check finds those that reflect more than they get") {
  const auto disney = describe_term("disney_diffuse", {{"alpha", 1.0}});
  CHECK(furnace_at_89(disney) == doctest::Approx(1.52).epsilon(0.01));
  CHECK(verdict_of(Property::energy, disney) == Verdict::fails);
  const auto hammon = describe_term("hammon_diffuse", {{"alpha", 1.0}, {"f0", 0.0}});
  CHECK(furnace_at_89(hammon) == doctest::Approx(1.15).epsilon(0.01));
  CHECK(verdict_of(Property::energy, hammon) == Verdict::fails);
  const auto nayar = describe_term("oren_nayar", {{"sigma", 0.25}});
  CHECK(furnace_at_89(nayar) == doctest::Approx(1.043).epsilon(0.001));
  CHECK(verdict_of(Property::energy, nayar) == Verdict::fails);
  CHECK(verdict_of(Property::energy, describe_term("eon", {{"roughness", 1.0}})) == Verdict::holds);
  CHECK(verdict_of(Property::energy, describe_term("fujii_oren_nayar", {{"roughness", 1.0}})) == Verdict::holds);
}

TEST_CASE("diffuse terms: the albedo of velvet agrees with a plain sum over the hemisphere") {
  for (const double alpha : {0.01, 0.1, 1.0})
    for (const double theta : {0.0, 0.8, 1.5}) {
      const Material m = build(describe_term("velvet_cloth", {{"alpha", alpha}, {"amplitude", 100.0}, {"f0", 0.3}}));
      const Direction o = from_angles(theta, 0);
      // Midpoints, closer to each other towards the horizon.
      constexpr int n = 600;
      std::vector<double> x(n), y(n), z(n), values(n);
      const std::vector<double> ox(n, o.x), oy(n, o.y), oz(n, o.z);
      const Batch row{n, {ox.data(), oy.data(), oz.data()}, {x.data(), y.data(), z.data()}, {}};
      double sum = 0;
      for (int a = 0; a < n; ++a) {
        const double t = 1 - (a + 0.5) / n, elevation = 0.5 * std::numbers::pi * t * t * t;
        const double c = std::sin(elevation), s = std::cos(elevation);
        const double weight = 1.5 * std::numbers::pi * t * t / n * s * 2 * std::numbers::pi / n;
        for (std::size_t b = 0; b < n; ++b) {
          const double phi = std::numbers::pi * (static_cast<double>(b) + 0.5) / n;
          x[b] = s * std::cos(phi);
          y[b] = s * std::sin(phi);
          z[b] = c;
        }
        evaluate(m, Quantity::brdf_cos, row, values.data());
        for (const double one : values) sum += weight * one;
      }
      const Estimate e = compute(Integral::albedo, m, o, 1e-7);
      CAPTURE(alpha);
      CAPTURE(theta);
      CHECK(e.value == doctest::Approx(sum).epsilon(1e-5));
    }
}
