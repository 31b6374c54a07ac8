#include "analysis/integrals.hpp"
#include "choice/methods/add.hpp"
#include "choice/methods/problems.hpp"

#include <cmath>
#include <memory>
#include <mutex>

namespace brdfplot::choice {

namespace {

/// The albedo of GGX with Smith's height-correlated G2 under Schlick's F is F0 A + F90 B; A + B is that of F = 1.
enum class Scale90 { a, b, sum };

Material albedo_material(double alpha, Scale90 scale) {
  TermDescription term;
  term.name = "GGX";
  term.distribution.type = "ggx";
  term.distribution.values.set("alpha", alpha);
  if (scale != Scale90::sum) {
    term.fresnel.type = "schlick";
    term.fresnel.values.set("f0", scale == Scale90::a ? 1.0 : 0.0);
    term.fresnel.values.set("f90", scale == Scale90::a ? 0.0 : 1.0);
  }
  return build(term);
}

Estimate albedo_estimate(double alpha, double c, Scale90 scale, double tolerance) {
  const double s = std::sqrt((1 - c) * (1 + c));
  return compute(Integral::albedo, albedo_material(alpha, scale), {s, 0, c}, tolerance);
}

template <class T>
T at_most_one(const T& x) {
  using std::max, std::min;
  return min(max(x, T(0)), T(1));
}

/// MaterialX's rational in cos and alpha (Lucasfilm 2019, mx_ggx_dir_albedo): A = r_0 / r_2, B = r_1 / r_3.
struct MaterialXAlbedo {
  Scale90 scale;

  template <class T>
  T operator()(const std::array<T, 2>& in) const {
    if (scale == Scale90::a) return at_most_one(part<T, 0>(in));
    if (scale == Scale90::b) return at_most_one(part<T, 1>(in));
    return at_most_one(part<T, 0>(in)) + at_most_one(part<T, 1>(in));
  }

  template <class T, std::size_t which>
  static T part(const std::array<T, 2>& in) {
    return polynomial<T, which>(in) / polynomial<T, which + 2>(in);
  }

  /// r_k = c0 + c1 x + c2 y + c3 x y + c4 x^2 + c5 y^2 + c6 x^2 y + c7 x y^2 + c8 x^2 y^2, x = cos, y = alpha.
  template <class T, std::size_t which>
  static T polynomial(const std::array<T, 2>& in) {
    constexpr double c[4][9] = {{0.1003, -0.6303, 9.748, -2.038, 29.34, -8.245, -26.44, 19.99, -5.448},
                                {0.9345, -2.323, 2.229, -3.748, 1.424, -0.7684, 1.436, 0.2913, 0.6286},
                                {1, -1.765, 8.263, 11.53, 28.96, -7.507, -36.11, 15.86, 33.37},
                                {1, 0.2281, 15.94, -55.83, 13.08, 41.26, 54.9, 300.2, -285.1}};
    const auto& k = c[which];
    const T y = in[0], x = in[1], x2 = x * x, y2 = y * y;
    const T constant = T(k[0]) + y * T(k[2]) + y2 * T(k[5]);
    const T linear = T(k[1]) + y * T(k[3]) + y2 * T(k[7]);
    const T square = T(k[4]) + y * T(k[6]) + y2 * T(k[8]);
    return constant + x * linear + x2 * square;
  }
};

/// Unreal's GGXEnergyLookup, r = sqrt(alpha): A + B = 1 - clamp(r^(c/r) (r c + .0266916) / (.466495 + c)),
/// B = (1 - c)^5 (2.36651 c^(4.7703 r) + .0387332)^r.
struct UnrealAlbedo {
  Scale90 scale;

  template <class T>
  T operator()(const std::array<T, 2>& in) const {
    using std::pow, std::sqrt;
    const T r = sqrt(in[0]), c = in[1];
    if (scale == Scale90::sum) return energy(r, c);
    const T u = T(1) - c, u2 = u * u;
    const T b = u2 * u2 * u * pow(T(2.36651) * pow(c, T(4.7703) * r) + T(0.0387332), r);
    return scale == Scale90::b ? b : energy(r, c) - b;
  }

  template <class T>
  static T energy(const T& r, const T& c) {
    using std::pow;
    return T(1) - at_most_one(pow(r, c / r) * (r * c + T(0.0266916)) / (T(0.466495) + c));
  }
};

/// Lazarov's for Call of Duty: Black Ops II (2013), made for Blinn's lobe of the exponent 8192^g, of which alpha^2 =
/// 2 / (exponent + 2), and another G: B = g min(0.475 g, 2^(-9.28 c)) / 0.96 + (0.0175 g - 0.015) / 0.96,
/// A + B = (g + 3) / 4. Below alpha = 0.0156 g is above 1, beyond what it was made for.
struct LazarovAlbedo {
  Scale90 scale;

  template <class T>
  T operator()(const std::array<T, 2>& in) const {
    using std::exp2, std::log2, std::max, std::min;
    const T exponent = max(T(2) / (in[0] * in[0]) - T(2), T(1));
    const T g = log2(exponent) * T(1.0 / 13), c = in[1];
    const T b = g * T(1 / 0.96) * min(T(0.475) * g, exp2(T(-9.28) * c)) + (T(0.0175) * g - T(0.015)) * T(1 / 0.96);
    const T sum = T(0.25) * g + T(0.75);
    return scale == Scale90::b ? b : scale == Scale90::sum ? sum : sum - b;
  }
};

/// Karis's for mobile (2014), after Lazarov 2013; made for another G.
struct KarisAlbedo {
  Scale90 scale;

  template <class T>
  T operator()(const std::array<T, 2>& in) const {
    using std::exp2, std::min, std::sqrt;
    const T r = sqrt(in[0]), c = in[1];
    const T x = T(1) - r, y = T(0.0425) - T(0.0275) * r, z = T(1.04) - T(0.572) * r, w = T(0.022) * r - T(0.04);
    const T a004 = min(x * x, exp2(T(-9.28) * c)) * x + y;
    const T a = T(-1.04) * a004 + z, b = T(1.04) * a004 + w;
    return scale == Scale90::a ? a : scale == Scale90::b ? b : a + b;
  }
};

/// Bilinear over (alpha, cos), both from 0 to 1 at equal steps.
struct AlbedoTable {
  std::size_t steps;
  std::vector<double> entries; ///< [alpha][cos]

  /// Blank.
  explicit AlbedoTable(std::size_t n) : steps(n), entries((n + 1) * (n + 1)) {}
  void fill(Scale90 scale) {
    for (std::size_t i = 0; i <= steps; ++i)
      for (std::size_t j = 0; j <= steps; ++j)
        entries[i * (steps + 1) + j] = albedo_estimate(at(i), at(j), scale, 1e-6).value;
  }
  /// A place; instead of 0 something just above it: there is no roughness 0, and no cosine at the horizon.
  double at(std::size_t index) const {
    return index == 0 ? 1e-3 : static_cast<double>(index) / static_cast<double>(steps);
  }

  template <class T>
  T operator()(const std::array<T, 2>& in) const {
    using std::min;
    const T n = T(static_cast<double>(steps)), most = T(static_cast<double>(steps - 1));
    const T y = in[0] * n, x = in[1] * n;
    const std::size_t i = whole_part(min(y, most)), j = whole_part(min(x, most));
    const T v = y - T(static_cast<double>(i)), u = x - T(static_cast<double>(j));
    const auto row = [&](std::size_t k) {
      const T low = read_entry<T>(entries[k * (steps + 1) + j]), high = read_entry<T>(entries[k * (steps + 1) + j + 1]);
      return low + u * (high - low);
    };
    const T low = row(i), high = row(i + 1);
    return low + v * (high - low);
  }
};

/// Takes a while to fill, so that it is done when the first value is asked for.
class LateAlbedoTable {
public:
  LateAlbedoTable(std::size_t steps, Scale90 scale) : table_(steps), scale_(scale) {}
  const AlbedoTable& get() {
    std::call_once(filled_, [this] { table_.fill(scale_); });
    return table_;
  }

private:
  AlbedoTable table_;
  Scale90 scale_;
  std::once_flag filled_;
};

void add_albedo_table(Problem& p, Scale90 scale, std::size_t steps) {
  const AlbedoTable blank(steps);
  Method method = method_of<double, 2>("table_" + std::to_string(steps), "bilinear in alpha and cos", "table",
                                       choice::Kind::table, blank, {{0.3, 0.5}});
  method.bytes = blank.entries.size() * sizeof(double);
  method.run = Run<double>(
      [late = std::make_shared<LateAlbedoTable>(steps, scale)](std::size_t n, const double* const* in, double* out) {
        const AlbedoTable& table = late->get();
        for (std::size_t i = 0; i < n; ++i) out[i] = table(std::array<double, 2>{in[0][i], in[1][i]});
      });
  p.methods.push_back(std::move(method));
}

/// About what one value of the integrand costs: D and G2 of a direction, with two roots and a division.
constexpr Operations integrand_operations{.multiply_adds = 30, .comparisons = 2, .divisions = 1, .square_roots = 2};

Operations times(Operations operations, std::size_t n) {
  return {operations.multiply_adds * n, operations.comparisons * n,  operations.divisions * n,
          operations.square_roots * n,  operations.exponentials * n, operations.transcendentals * n,
          operations.table_reads * n};
}

/// The program's quadrature at a tolerance; its operations those of the evaluations at a few directions, the most.
void add_albedo_quadrature(Problem& p, Scale90 scale, double tolerance) {
  std::size_t evaluations = 0;
  for (const double alpha : {0.05, 0.3, 1.0})
    for (const double c : {0.1, 0.9})
      evaluations = std::max(evaluations, albedo_estimate(alpha, c, scale, tolerance).evaluations);
  const std::string text = "1e" + std::to_string(std::lround(std::log10(tolerance)));
  p.methods.push_back({.name = "quadrature_" + text,
                       .doc = "the quadrature of this program at a tolerance of " + text + ", " +
                              std::to_string(evaluations) + " evaluations or fewer",
                       .source = "brdfplot eval -q albedo",
                       .kind = Kind::quadrature,
                       .run = Run<double>([scale, tolerance](std::size_t n, const double* const* in, double* out) {
                         for (std::size_t i = 0; i < n; ++i)
                           out[i] = albedo_estimate(in[0][i], in[1][i], scale, tolerance).value;
                       }),
                       .operations = times(integrand_operations, evaluations)});
}

Problem albedo_problem(const std::string& name, const std::string& doc, Scale90 scale) {
  Problem p{.name = name,
            .doc = doc,
            .source = "Heitz 2014, Eqs. 29 and 99, under F0 A + F90 B of Schlick's F",
            .inputs = {{"alpha", "roughness", 0.01, 1, choice::Scale::logarithmic},
                       {"cos_theta", "cosine of the viewer", 0.02, 1, choice::Scale::linear}},
            .exact =
                [scale](std::span<const double> x) {
                  return Exact{albedo_estimate(x[0], x[1], scale, 1e-9).value, 0};
                },
            .methods = {},
            .least = 0,
            .most = 1,
            .seen = {},
            .exact_error = 1e-9,
            .samples = 400};
  const std::vector<std::array<double, 2>> examples = {{0.3, 0.5}};
  add_formula(p, "materialx", "a rational in cos and alpha", "MaterialX 1.39, mx_ggx_dir_albedo_analytic",
              Kind::approximation, MaterialXAlbedo{scale}, examples);
  add_formula(p, "unreal", "powers of sqrt(alpha) and cos", "Unreal Engine 5, GGXEnergyLookup", Kind::approximation,
              UnrealAlbedo{scale}, examples);
  add_formula(p, "lazarov_2013", "made for Blinn's lobe and another G", "Lazarov 2013", Kind::approximation,
              LazarovAlbedo{scale}, examples);
  add_formula(p, "karis_2014", "for mobile; made for another G", "Karis 2014, after Lazarov 2013", Kind::approximation,
              KarisAlbedo{scale}, examples);
  for (const std::size_t steps : {8U, 16U, 32U}) add_albedo_table(p, scale, steps);
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) add_albedo_quadrature(p, scale, tolerance);
  return p;
}

} // namespace

Problem albedo_ggx() { return albedo_problem("albedo_ggx", "Albedo of GGX with F = 1, A + B", Scale90::sum); }
Problem albedo_ggx_a() { return albedo_problem("albedo_ggx_a", "Factor A of F0 in the albedo of GGX", Scale90::a); }
Problem albedo_ggx_b() { return albedo_problem("albedo_ggx_b", "Factor B of F90 in the albedo of GGX", Scale90::b); }

} // namespace brdfplot::choice
