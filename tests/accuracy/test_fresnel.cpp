/// Reflectances against Fresnel's equations in complex arithmetic, and Schlick's formula, in multiprecision.
#include "accuracy/measure.hpp"
#include "microfacet/fresnel.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <doctest/doctest.h>

#include <array>

namespace {

using namespace brdfplot;
using namespace brdfplot::accuracy;
using boost::multiprecision::cpp_bin_float;
template <unsigned bits>
using Binary = boost::multiprecision::number<cpp_bin_float<bits, boost::multiprecision::digit_base_2>,
                                             boost::multiprecision::et_off>;

/// Inputs of one set of parameters, so that the kernels compute vectors of them.
constexpr std::size_t batch = 50;
using Cosines = std::array<double, batch>;

/// The parameters of the kernels: an index, or those of Schlick's formula.
struct Parameters {
  double eta = 1, k = 0;
  double f0 = 0, f90 = 1, exponent = 5;
  std::string text() const {
    using accuracy::text;
    if (f0 == 0 && f90 == 1) return " eta = " + text(eta) + " k = " + text(k);
    return " f0 = " + text(f0) + " f90 = " + text(f90) + " exponent = " + text(exponent);
  }
};

/// A number near x, from a tenth of it away down to the next one and x itself.
double draw_near(Random& random, double x) {
  if (random.chance(0.2)) return x;
  return x * (1 + (random.chance(0.5) ? 1 : -1) * random.log_uniform(1e-16, 0.1));
}

/// Cosines uniform, grazing and near the normal, both ends, and about the critical one.
double draw_cosine(Random& random, double eta) {
  const double kind = random.uniform();
  if (kind < 0.02) return 0;
  if (kind < 0.04) return 1;
  if (kind < 0.4) return random.uniform();
  if (kind < 0.5) return random.log_uniform(1e-300, 1);
  if (kind < 0.6) return 1 - random.log_uniform(1e-16, 1);
  if (kind < 0.8 || eta >= 1) return random.log_uniform(1e-20, 1);
  return std::min(1.0, draw_near(random, std::sqrt((1 - eta) * (1 + eta))));
}

/// Indices from one end of the domain to the other, and about 1.
double draw_eta(Random& random) {
  const double kind = random.uniform();
  if (kind < 0.05) return 1;
  if (kind < 0.3) return draw_near(random, 1);
  if (kind < 0.6) return random.uniform(0.05, 5);
  return random.log_uniform(1e-6, 1e6);
}

/// 0, from one end to the other, and about where the real part of the squared index is 0 or 1.
double draw_absorption(Random& random, double eta) {
  const double kind = random.uniform();
  if (kind < 0.1) return 0;
  if (kind < 0.3) return random.uniform(0, 10);
  if (kind < 0.5) return random.log_uniform(1e-140, 1e6);
  if (kind < 0.7) return random.log_uniform(1e-20, 1);
  if (kind < 0.8 || eta <= 1) return std::min(1e6, draw_near(random, eta));
  return std::min(1e6, draw_near(random, std::sqrt((eta - 1) * (eta + 1))));
}

void run_dielectric(const double* c, const Parameters& p, double* f) {
  kernels::reflectance_dielectric(c, p.eta, f, batch);
}

void run_conductor(const double* c, const Parameters& p, double* f) {
  kernels::reflectance_conductor(c, p.eta, p.k, f, batch);
}

void run_schlick(const double* c, const Parameters& p, double* f) {
  kernels::reflectance_schlick(c, p.f0, p.f90, p.exponent, f, batch);
}

struct ExactDielectric {
  template <class R>
  static R of(double c, const Parameters& p) {
    return c == 0 && p.eta == 1 ? R(0) : reference::dielectric(R(c), R(p.eta)); // without an interface 0
  }
};

struct ExactConductor {
  template <class R>
  static R of(double c, const Parameters& p) {
    return c == 0 && p.eta == 1 && p.k == 0 ? R(0) : reference::conductor(R(c), R(p.eta), R(p.k));
  }
};

struct ExactSchlick {
  template <class R>
  static R of(double c, const Parameters& p) {
    return c == 1 ? R(p.f0) : reference::schlick(R(c), R(p.f0), R(p.f90), R(p.exponent));
  }
};

/// 1 - c^2 needs 2 log2(1 / c) bits and 53 more, the phase of n^2 2 log2(1 / k).
template <class Exact>
Quad exact(double c, const Parameters& p) {
  const auto is_large = [](double x) { return x == 0 || x > 1e-30; };
  return is_large(c) && is_large(p.k) ? Quad(Exact::template of<Binary<512>>(c, p))
                                      : Quad(Exact::template of<Binary<2100>>(c, p));
}

/// One function, with its parameters at random.
struct Function {
  std::string name, domain;
  Bound bound;
  Parameters (*draw)(Random&);
  void (*run)(const double*, const Parameters&, double*);
  Quad (*exact)(double, const Parameters&);
};

const std::vector<Function> functions = {
    {"Fresnel (Schlick)", "f0 and f90 in [0; 1]", bounds::schlick,
     [](Random& random) {
       return Parameters{.f0 = random.uniform(), .f90 = random.chance(0.3) ? 0 : random.uniform()};
     },
     run_schlick, exact<ExactSchlick>},
    {"Fresnel (Schlick to any power)", "exponent in [1e-3; 1e3]", bounds::schlick,
     [](Random& random) {
       return Parameters{.f0 = random.chance(0.3) ? 0 : random.uniform(),
                         .f90 = random.chance(0.3) ? 0 : random.uniform(),
                         .exponent = random.log_uniform(1e-3, 1e3)};
     },
     run_schlick, exact<ExactSchlick>},
    {"Fresnel (dielectric)", "eta in [1.3; 4]", bounds::dielectric,
     [](Random& random) { return Parameters{.eta = random.uniform(1.3, 4)}; }, run_dielectric, exact<ExactDielectric>},
    {"Fresnel (dielectric)", "eta in [1e-6; 1e6]", bounds::dielectric,
     [](Random& random) { return Parameters{.eta = draw_eta(random)}; }, run_dielectric, exact<ExactDielectric>},
    {"Fresnel (conductor)", "eta in [0.05; 5]; k in [0.5; 10]", bounds::conductor,
     [](Random& random) { return Parameters{.eta = random.log_uniform(0.05, 5), .k = random.uniform(0.5, 10)}; },
     run_conductor, exact<ExactConductor>},
    {"Fresnel (conductor)", "eta in [1e-6; 1e6]; k in [0; 1e6]", bounds::conductor,
     [](Random& random) {
       const double eta = draw_eta(random);
       return Parameters{.eta = eta, .k = draw_absorption(random, eta)};
     },
     run_conductor, exact<ExactConductor>},
};

/// On every instruction set against the same exact values.
void check(const Function& function) {
  const auto isas = kernels::available_isas();
  std::vector<Row> rows;
  for (const kernels::Isa isa : isas)
    rows.emplace_back(function.name, "double", std::string(kernels::name(isa)), function.domain, function.bound);
  Random random(6);
  for (std::size_t n = 0; n < inputs_per_row(); n += batch) {
    const Parameters p = function.draw(random);
    Cosines c, f;
    std::array<Quad, batch> truth;
    for (std::size_t j = 0; j < batch; ++j) {
      c[j] = draw_cosine(random, p.eta);
      truth[j] = function.exact(c[j], p);
    }
    auto row = rows.begin();
    for_each_isa([&](const std::string&) {
      function.run(c.data(), p, f.data());
      for (std::size_t j = 0; j < batch; ++j)
        row->add(ulp_error(f[j], truth[j]), [&] { return "c = " + text(c[j]) + p.text(); });
      ++row;
    });
  }
  for (const Row& row : rows) finish(row);
}

} // namespace

TEST_CASE("accuracy: Fresnel") {
  for (const Function& function : functions) check(function);
}

TEST_CASE("reflectances: a cosine alone, and on another instruction set, has the same bytes") {
  Random random(16);
  for (std::size_t n = 0; n < 40; ++n) {
    const double eta = draw_eta(random), k = draw_absorption(random, eta), f0 = random.uniform(),
                 f90 = random.uniform();
    const double exponent = random.log_uniform(1e-3, 1e3);
    Cosines c, of_dielectric, of_conductor, of_fifth, of_power;
    for (double& cosine : c) cosine = draw_cosine(random, eta);
    const kernels::Isa chosen = kernels::active_isa();
    kernels::use_isa(kernels::Isa::baseline);
    kernels::reflectance_dielectric(c.data(), eta, of_dielectric.data(), batch);
    kernels::reflectance_conductor(c.data(), eta, k, of_conductor.data(), batch);
    kernels::reflectance_schlick(c.data(), f0, f90, 5, of_fifth.data(), batch);
    kernels::use_isa(chosen);
    for_each_isa([&](const std::string& isa) {
      CAPTURE(isa);
      kernels::reflectance_schlick(c.data(), f0, f90, exponent, of_power.data(), batch);
      for (std::size_t j = 0; j < batch; ++j) {
        CAPTURE(c[j]);
        CHECK(dielectric_reflectance(c[j], eta) == of_dielectric[j]);
        CHECK(conductor_reflectance(c[j], eta, k) == of_conductor[j]);
        CHECK(schlick_reflectance(c[j], f0, f90, 5) == of_fifth[j]);
        CHECK(schlick_reflectance(c[j], f0, f90, exponent) == of_power[j]);
      }
    });
  }
}
