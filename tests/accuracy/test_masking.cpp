/// Lambda, masked area, sigma and G1: the scalar functions and the kernels, by the ratio a = c / s.
#include "accuracy/measure.hpp"
#include "microfacet/beckmann_lambda.hpp"
#include "microfacet/distributions/beckmann.hpp"
#include "microfacet/distributions/ggx.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <doctest/doctest.h>

namespace {

using namespace brdfplot;
using namespace brdfplot::accuracy;
using boost::multiprecision::cpp_bin_float;
/// 1 + 1 / a^2 needs 2 log2(a) bits and 53 more.
using Wide = boost::multiprecision::number<cpp_bin_float<2200, boost::multiprecision::digit_base_2>,
                                           boost::multiprecision::et_off>;

/// Where a GGX Lambda in 113 bits has lost less than 2^-60 of itself.
constexpr double quad_is_enough = 1e6;

double draw_a(Random& random, const std::string& domain, double largest) {
  if (domain == "a in [0; 30]") return random.uniform(0, largest);
  if (domain == "a log-uniform") return random.log_uniform(1e-8, 1e3);
  return random.log_uniform(26, 27.5);
}

void check_scalar(const char* name, Bound bound, double (*function)(double), reference::Model model, bool times_a,
                  const std::string& domain) {
  Row row(name, "double", "scalar", domain, bound);
  Random random(1);
  for (std::size_t k = 0; k < inputs_per_row(); ++k) {
    const double a = domain == "bit patterns" ? random.pattern(0x1p-1000, quad_is_enough) : draw_a(random, domain, 30);
    const Quad lambda = reference::lambda(model, Quad(a));
    row.add(ulp_error(function(a), times_a ? Quad(lambda * a) : lambda), [&] { return text(a); });
  }
  finish(row);
}

double ggx_a_lambda(double a) { return GgxShape::a_lambda(a); }

/// A function of the arrays c and s: a kernel, or what is composed of one.
template <class T>
struct Function {
  const char* name;
  Bound bound;
  void (*run)(const T* c, const T* s, T* out, std::size_t n);
  Quad (*exact)(const Quad& c, const Quad& s);
};

template <class R>
R tau(reference::Model model, const R& c, const R& s) {
  return s == 0 ? R(c < 0 ? R(-c) : R(0)) : R(c * reference::lambda(model, R(c / s)));
}

template <class T, auto kernel>
void sigma_of(const T* c, const T* s, T* out, std::size_t n) {
  kernel(c, s, out, n);
  for (std::size_t k = 0; k < n; ++k) out[k] += c[k];
}

template <class T, auto kernel>
void g1_of(const T* c, const T* s, T* out, std::size_t n) {
  kernel(c, s, out, n);
  for (std::size_t k = 0; k < n; ++k) out[k] = c[k] / (c[k] + out[k]);
}

template <class T>
using Kernel = void (*)(const T*, const T*, T*, std::size_t);

template <class T>
Bound lambda_bound(reference::Model model) {
  const bool beckmann = model == reference::Model::beckmann;
  if (sizeof(T) == sizeof(float)) return beckmann ? bounds::float_lambda_beckmann : bounds::float_lambda_ggx;
  return beckmann ? bounds::lambda_beckmann : bounds::lambda_ggx;
}

template <class T, reference::Model model>
std::vector<Function<T>> functions() {
  constexpr bool beckmann = model == reference::Model::beckmann;
  constexpr Kernel<T> area = beckmann ? Kernel<T>(kernels::masked_area_beckmann) : Kernel<T>(kernels::masked_area_ggx);
  constexpr Kernel<T> lambda_kernel = beckmann ? Kernel<T>(kernels::lambda_beckmann) : Kernel<T>(kernels::lambda_ggx);
  const auto exact_tau = [](const Quad& c, const Quad& s) { return tau(model, c, s); };
  const auto exact_sigma = [](const Quad& c, const Quad& s) { return Quad(c + tau(model, c, s)); };
  const auto exact_lambda = [](const Quad& c, const Quad& s) { return reference::lambda(model, Quad(c / s)); };
  const auto exact_g1 = [](const Quad& c, const Quad& s) { return Quad(c / (c + tau(model, c, s))); };
  using namespace bounds;
  const bool single = sizeof(T) == sizeof(float);
  const Bound area_bound = single ? (beckmann ? float_masked_area_beckmann : float_masked_area_ggx)
                                  : (beckmann ? masked_area_beckmann : masked_area_ggx);
  const Bound sigma_bound =
      single ? (beckmann ? float_sigma_beckmann : float_sigma_ggx) : (beckmann ? sigma_beckmann : sigma_ggx);
  const Bound g1_bound = single ? (beckmann ? float_g1_beckmann : float_g1_ggx) : (beckmann ? g1_beckmann : g1_ggx);
  return {{beckmann ? "c Lambda (Beckmann)" : "c Lambda (GGX)", area_bound, area, exact_tau},
          {beckmann ? "sigma (Beckmann)" : "sigma (GGX)", sigma_bound, sigma_of<T, area>, exact_sigma},
          {beckmann ? "G1 (Beckmann)" : "G1 (GGX)", g1_bound, g1_of<T, area>, exact_g1},
          {beckmann ? "Lambda (Beckmann)" : "Lambda (GGX)", lambda_bound<T>(model), lambda_kernel, exact_lambda}};
}

template <class T>
struct Pairs {
  std::vector<T> c, s;
};

/// `domain` of c / s, at roughnesses of every size that the kernels are for.
template <class T>
Pairs<T> draw_pairs(const std::string& domain, std::size_t n) {
  const bool single = sizeof(T) == sizeof(float);
  Random random(2);
  Pairs<T> pairs;
  while (pairs.c.size() < n) {
    T s = static_cast<T>(random.log_uniform(1e-6, 1e3));
    T c = static_cast<T>(draw_a(random, domain, single ? 11 : 30) * static_cast<double>(s));
    if (domain == "bit patterns") {
      s = single ? static_cast<T>(random.pattern(0x1p-100f, 0x1p20f))
                 : static_cast<T>(random.pattern(0x1p-900, 0x1p200));
      c = single ? static_cast<T>(random.pattern(0x1p-100f, 0x1p99f))
                 : static_cast<T>(random.pattern(0x1p-900, 0x1p999));
      const double a = static_cast<double>(c) / static_cast<double>(s);
      if (a > quad_is_enough || a < (single ? 0x1p-120 : 0x1p-1000)) continue;
    }
    if (domain == "subnormal results" && single) c = static_cast<T>(random.uniform(8.9, 10.3) * static_cast<double>(s));
    pairs.c.push_back(c);
    pairs.s.push_back(s);
  }
  return pairs;
}

template <class T>
void check_kernel(const Function<T>& function, const std::string& domain) {
  const Pairs<T> in = draw_pairs<T>(domain, inputs_per_row());
  std::vector<Quad> exact;
  for (std::size_t k = 0; k < in.c.size(); ++k) exact.push_back(function.exact(Quad(in.c[k]), Quad(in.s[k])));
  for_each_isa([&](const std::string& isa) {
    std::vector<T> out(in.c.size());
    function.run(in.c.data(), in.s.data(), out.data(), out.size());
    Row row(function.name, type_name<T>(), isa, domain, function.bound);
    for (std::size_t k = 0; k < out.size(); ++k)
      row.add(ulp_error(out[k], exact[k]), [&] {
        return "c = " + text(static_cast<double>(in.c[k])) + " s = " + text(static_cast<double>(in.s[k]));
      });
    finish(row);
  });
}

/// sigma = c + c Lambda of the models, one projection after the other.
template <class Model>
void check_scalar_sigma(const char* name, Bound bound, reference::Model model, const std::string& domain) {
  Row row(name, "double", "scalar", domain, bound);
  const Pairs<double> in = draw_pairs<double>(domain, inputs_per_row());
  for (std::size_t k = 0; k < in.c.size(); ++k) {
    const Quad c = in.c[k], s = in.s[k];
    row.add(ulp_error(in.c[k] + Model{}.masked_area({in.c[k], in.s[k]}), Quad(c + tau(model, c, s))),
            [&] { return "c = " + text(in.c[k]) + " s = " + text(in.s[k]); });
  }
  finish(row);
}

template <class T>
void check_of_a(const char* name, void (*kernel)(const T*, T*, std::size_t), reference::Model model,
                const std::string& domain) {
  const Pairs<T> in = draw_pairs<T>(domain, inputs_per_row());
  std::vector<T> a;
  std::vector<Quad> exact;
  for (std::size_t k = 0; k < in.c.size(); ++k) {
    a.push_back(in.c[k] / in.s[k]);
    if (!(a.back() > 0)) a.back() = 1;
    exact.push_back(reference::lambda(model, Quad(a.back())));
  }
  for_each_isa([&](const std::string& isa) {
    std::vector<T> out(a.size());
    kernel(a.data(), out.data(), out.size());
    Row row(name, type_name<T>(), isa, domain, lambda_bound<T>(model));
    for (std::size_t k = 0; k < out.size(); ++k)
      row.add(ulp_error(out[k], exact[k]), [&] { return "a = " + text(static_cast<double>(a[k])); });
    finish(row);
  });
}

template <class T>
void check_kernels() {
  for (const char* domain : {"a in [0; 30]", "a log-uniform", "subnormal results", "bit patterns"}) {
    for (const auto& function : functions<T, reference::Model::beckmann>()) check_kernel(function, domain);
    for (const auto& function : functions<T, reference::Model::ggx>()) check_kernel(function, domain);
    check_of_a<T>("Lambda(a) (Beckmann)", kernels::lambda_beckmann, reference::Model::beckmann, domain);
    check_of_a<T>("Lambda(a) (GGX)", kernels::lambda_ggx, reference::Model::ggx, domain);
  }
}

} // namespace

TEST_CASE("accuracy: scalar Lambda") {
  for (const char* domain : {"a in [0; 30]", "a log-uniform", "subnormal results", "bit patterns"}) {
    check_scalar("Lambda (Beckmann)", bounds::scalar_lambda_beckmann, beckmann_lambda, reference::Model::beckmann,
                 false, domain);
    check_scalar("a Lambda (Beckmann)", bounds::scalar_a_lambda_beckmann, beckmann_a_lambda, reference::Model::beckmann,
                 true, domain);
    check_scalar("a Lambda (GGX)", bounds::scalar_a_lambda_ggx, ggx_a_lambda, reference::Model::ggx, true, domain);
  }
}

TEST_CASE("accuracy: scalar sigma") {
  for (const char* domain : {"a in [0; 30]", "a log-uniform", "subnormal results", "bit patterns"}) {
    check_scalar_sigma<Beckmann>("sigma (Beckmann)", bounds::scalar_sigma_beckmann, reference::Model::beckmann, domain);
    check_scalar_sigma<Ggx>("sigma (GGX)", bounds::scalar_sigma_ggx, reference::Model::ggx, domain);
  }
}

TEST_CASE("accuracy: masking kernels, double") { check_kernels<double>(); }

TEST_CASE("accuracy: masking kernels, float") { check_kernels<float>(); }

TEST_CASE("accuracy: GGX for a up to 1e300") {
  for_each_isa([](const std::string& isa) {
    Row row("Lambda (GGX)", "double", isa, "a to 1e300", bounds::lambda_ggx);
    Random random(3);
    const std::size_t n = std::min<std::size_t>(inputs_per_row() / 20, 10000);
    for (std::size_t k = 0; k < n; ++k) {
      const double s = random.log_uniform(1e-6, 1e3), c = s * random.log_uniform(quad_is_enough, 1e297);
      double out = 0;
      kernels::lambda_ggx(&c, &s, &out, 1);
      row.add(ulp_error(out, reference::lambda_ggx(Wide(Wide(c) / s))),
              [&] { return "c = " + text(c) + " s = " + text(s); });
    }
    finish(row);
  });
}

TEST_CASE("accuracy: below the horizon of the mesosurface") {
  for_each_isa([](const std::string& isa) {
    for (const auto model : {reference::Model::beckmann, reference::Model::ggx}) {
      const bool beckmann = model == reference::Model::beckmann;
      Row row(beckmann ? "c Lambda (Beckmann)" : "c Lambda (GGX)", "double", isa, "c < 0",
              beckmann ? bounds::masked_area_beckmann : bounds::masked_area_ggx);
      Random random(4);
      for (std::size_t k = 0; k < inputs_per_row(); ++k) {
        const double s = random.log_uniform(1e-6, 1e3), c = -s * random.log_uniform(1e-8, 1e3);
        double out = 0;
        (beckmann ? Kernel<double>(kernels::masked_area_beckmann) : Kernel<double>(kernels::masked_area_ggx))(&c, &s,
                                                                                                              &out, 1);
        row.add(ulp_error(out, tau(model, Quad(c), Quad(s))), [&] { return "c = " + text(c) + " s = " + text(s); });
      }
      finish(row);
    }
  });
}

TEST_CASE_TEMPLATE("accuracy: Walter's fit", T, double, float) {
  const Pairs<T> in = draw_pairs<T>("a log-uniform", inputs_per_row());
  for_each_isa([&](const std::string& isa) {
    std::vector<T> out(in.c.size());
    kernels::masked_area_beckmann_walter(in.c.data(), in.s.data(), out.data(), out.size());
    Row row("c Lambda (Walter's fit)", type_name<T>(), isa, "a log-uniform", bounds::walter);
    for (std::size_t k = 0; k < out.size(); ++k) {
      const Quad c = in.c[k], s = in.s[k], a = c / s;
      // The unit is that of the sum of the terms, not of their difference.
      const Quad unit = s * (1 + a) / (4 + 2 * a), exact = c * reference::lambda_walter(a);
      const double error = static_cast<double>(abs(Quad(Quad(out[k]) - exact)) / unit);
      const double units =
          a < 1.6 ? error / static_cast<double>(std::numeric_limits<T>::epsilon()) : ulp_error(out[k], exact);
      row.add(units, [&] { return "a = " + text(static_cast<double>(a)); });
    }
    finish(row);
  });
}
