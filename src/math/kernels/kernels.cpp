#include "math/kernels/kernels.hpp"

#include "math/kernels/directions.hpp"
#include "math/kernels/isa_here.hpp"
#include "math/kernels/table.hpp"

#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace brdfplot::kernels {

namespace {

constexpr std::array all_isas = {Isa::baseline, Isa::avx2, Isa::avx512};

bool available(Isa isa) {
#ifdef BRDFPLOT_KERNELS_X86
  if (isa == Isa::avx2) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (isa == Isa::avx512)
    return available(Isa::avx2) && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
#endif
  return isa == Isa::baseline;
}

const detail::Table* table_of([[maybe_unused]] Isa isa) {
#ifdef BRDFPLOT_KERNELS_X86
  if (isa == Isa::avx2) return &detail::avx2_table;
  if (isa == Isa::avx512) return &detail::avx512_table;
#endif
  return &detail::baseline_table;
}

/// The one that BRDFPLOT_ISA names, when it can be had.
std::optional<Isa> requested_isa() {
  const char* const request = std::getenv("BRDFPLOT_ISA");
  if (request == nullptr) return std::nullopt;
  for (const Isa isa : available_isas())
    if (name(isa) == request) return isa;
  return std::nullopt;
}

std::atomic<Isa>& active() {
  static std::atomic<Isa> isa = requested_isa().value_or(available_isas().back());
  return isa;
}

/// What IsaHere has set on this thread.
thread_local const detail::Table* table_here = nullptr;

const detail::Table& table() {
  return table_here != nullptr ? *table_here : *table_of(active().load(std::memory_order_relaxed));
}

template <class T>
const detail::Kernels<T>& kernels() {
  if constexpr (sizeof(T) == sizeof(double))
    return table().for_double;
  else
    return table().for_float;
}

template <class T>
detail::Constant<T> constant(long double value) {
  const T high = static_cast<T>(value);
  return {high, static_cast<T>(value - static_cast<long double>(high))};
}

/// The constants in T of a stretch whose parameters are rounded to `Parameter` before, not after: the kernels then
/// compute for one and the same stretch throughout.
template <class T, class Parameter>
detail::StretchConstants<T> constants_of(const Stretch& stretch) {
  const auto parameter = [](double value) { return static_cast<long double>(static_cast<Parameter>(value)); };
  const long double x = parameter(stretch.alpha_x), y = parameter(stretch.alpha_y);
  const long double r = parameter(stretch.correlation);
  const long double across = y * std::sqrt((1 - r) * (1 + r));
  const long double pi_det = std::numbers::pi_v<long double> * x * across;
  detail::StretchConstants<T> k{};
  k.alpha_x = static_cast<T>(x);
  k.alpha_y = static_cast<T>(y);
  // The product is wanted exactly, also where long double is double.
  k.skew.high = static_cast<T>(r) * k.alpha_y;
  k.skew.low = std::fma(static_cast<T>(r), k.alpha_y, -k.skew.high);
  k.across = constant<T>(across);
  k.mean_x = static_cast<T>(parameter(stretch.mean_x));
  k.mean_y = static_cast<T>(parameter(stretch.mean_y));
  k.plain = r == 0 && k.mean_x == 0 && k.mean_y == 0;
  k.inverse_x = constant<T>(1 / x);
  k.inverse_y = constant<T>(1 / y);
  k.inverse_det = constant<T>(1 / (x * across));
  k.pi_det = static_cast<T>(pi_det);
  k.inverse_pi_det = static_cast<T>(1 / pi_det);
  return k;
}

/// Adds the parts of `terms` up without loss, so that each is what the sum of those before lacks (Ogita, Rump, Oishi
/// 2005).
template <std::size_t size>
void distil(std::array<double, size>& terms) {
  for (std::size_t pass = 0; pass + 1 < size; ++pass)
    for (std::size_t j = size - 1; j > 0; --j) {
      const double sum = terms[j] + terms[j - 1], part = sum - terms[j];
      terms[j] = (terms[j] - (sum - part)) + (terms[j - 1] - part);
      terms[j - 1] = sum;
    }
}

detail::IndexConstants constants_of(double eta, double absorption) {
  const double eta2 = eta * eta, k2 = absorption * absorption;
  std::array<double, 5> above = {-1, eta2, -k2, std::fma(eta, eta, -eta2), -std::fma(absorption, absorption, -k2)};
  distil(above);
  const long double n = eta, k = absorption, imaginary = 2 * n * k;
  const long double contrast = ((n - 1) * (n - 1) + k * k) * ((n + 1) * (n + 1) + k * k);
  return {{above[0], above[1], above[2]},
          static_cast<double>(imaginary),
          static_cast<double>(imaginary * imaginary),
          static_cast<double>(contrast)};
}

/// sqrt(pi) e^(x^2) erfc(x), 0 <= x <= 9.
double scaled_complement(double x) { return std::sqrt(std::numbers::pi) * std::exp(x * x) * std::erfc(x); }

/// What the guess and the steps for Beckmann's slopes need, of c and s.
void add_facing(detail::VisibleConstants& k) {
  const double a = k.s > 0 ? std::fmin(k.c / k.s, 9.0) : 9, angle = std::atan2(k.s, k.c);
  k.first_power = 1 + angle * (-0.876 + angle * (0.4265 - 0.0594 * angle));
  k.below = std::erfc(a);
  k.rest = 2 - k.below;
  k.lowest = -a;
  k.c_root_pi = k.c * std::sqrt(std::numbers::pi);
  k.share_lost = 0.5 * std::exp(-a * a) * (k.s - k.c * scaled_complement(a));
  k.whole = k.c_root_pi + k.share_lost;
  k.inverse_whole = 1 / k.whole;
  k.rise = a < 9 ? std::sqrt(2 * k.whole * std::exp(a * a) / k.s) : 0;
  k.bend = 2 * a / 3;
}

detail::VisibleConstants constants_of(const Stretch& stretch, const SeenFrom& from) {
  const double across = stretch.alpha_y * std::sqrt((1 - stretch.correlation) * (1 + stretch.correlation));
  const double skew = stretch.correlation * stretch.alpha_y, p = from.along_x, q = from.along_y;
  detail::VisibleConstants k{};
  k.o[0] = from.x, k.o[1] = from.y, k.o[2] = from.z;
  k.c = from.c, k.s = from.s;
  k.versine = from.s * from.s / (1 + from.c);
  k.facing[0] = stretch.alpha_x * p, k.facing[1] = skew * p + across * q;
  k.across[0] = -stretch.alpha_x * q, k.across[1] = across * p - skew * q;
  k.mean[0] = stretch.mean_x, k.mean[1] = stretch.mean_y;
  k.density = 1 / (4 * from.visible_area * std::numbers::pi * stretch.alpha_x * across);
  return k;
}

template <class T>
void run_project(const Stretch& stretch, Vectors<T> omega, T* c, T* s, std::size_t n) {
  const auto k = constants_of<T, T>(stretch);
  kernels<T>().project[k.plain](k, omega, c, s, n);
}

template <class T>
void run_density(const Stretch& stretch, Distribution distribution, Vectors<T> m, T* d, std::size_t n) {
  const auto k = constants_of<double, T>(stretch);
  kernels<T>().density[static_cast<int>(distribution)][k.plain](k, m, d, n);
}

template <class T>
void run_brdf(const Stretch& stretch, Distribution distribution, Shadowing shadowing, Vectors<T> o, Vectors<T> i,
              T* value, std::size_t n) {
  const auto k = constants_of<double, T>(stretch);
  kernels<T>().brdf[static_cast<int>(distribution)][static_cast<int>(shadowing)][k.plain](k, o, i, value, n);
}

} // namespace

std::string_view name(Isa isa) {
  constexpr std::array<std::string_view, 3> names = {"baseline", "avx2", "avx512"};
  return names[static_cast<std::size_t>(isa)];
}

std::vector<Isa> available_isas() {
  std::vector<Isa> isas;
  for (const Isa isa : all_isas)
    if (available(isa)) isas.push_back(isa);
  return isas;
}

Isa active_isa() { return active().load(std::memory_order_relaxed); }

std::optional<std::string> isa_request_error() {
  const char* const request = std::getenv("BRDFPLOT_ISA");
  if (request == nullptr || requested_isa()) return std::nullopt;
  std::string accepted;
  for (const Isa isa : available_isas()) accepted.append(accepted.empty() ? "" : ", ").append(name(isa));
  return "found \"" + std::string(request) + "\"; accepted on this machine: " + accepted;
}

bool use_isa(Isa isa) {
  if (!available(isa)) return false;
  active().store(isa, std::memory_order_relaxed);
  return true;
}

IsaHere::IsaHere(Isa isa) : before_(table_here) { table_here = table_of(isa); }
IsaHere::~IsaHere() { table_here = static_cast<const detail::Table*>(before_); }

void reflectance_dielectric(const double* c, double eta, double* f, std::size_t n) {
  table().fresnel.dielectric(constants_of(eta, 0), c, f, n);
}

void reflectance_conductor(const double* c, double eta, double k, double* f, std::size_t n) {
  table().fresnel.conductor(constants_of(eta, k), c, f, n);
}

void reflectance_schlick(const double* c, double f0, double f90, double exponent, double* f, std::size_t n) {
  table().fresnel.schlick[exponent == 5]({f0, f90, exponent}, c, f, n);
}

void flat_brdf(FlatTerm term, const FlatParameters& parameters, Vectors<double> o, Vectors<double> i, bool times_cosine,
               int channels, double* const* out, std::size_t n) {
  table().flat.flat[static_cast<int>(term)][times_cosine][channels > 1](parameters, o, i, out, n);
}

void half_vectors(Vectors<double> o, Vectors<double> i, double* x, double* y, double* z, std::size_t n) {
  table().directions.half_vectors(o, i, x, y, z, n);
}

void careful_dots(Vectors<double> u, Vectors<double> v, double* out, std::size_t n) {
  table().directions.careful_dots(u, v, out, n);
}

void wrap(const WrapParameters& parameters, const double* o_z, const double* i_z, bool times_cosine, int channels,
          double* const* out, std::size_t n) {
  table().cloth.wrap[times_cosine][channels > 1](parameters, o_z, i_z, out, n);
}

void sheen_brdf(SheenMasking masking, const SheenParameters& parameters, Vectors<double> o, Vectors<double> i,
                bool times_cosine, double* out, std::size_t n) {
  const SheenParameters& k = parameters;
  const double at_half = k.a / (1 + k.b * std::pow(0.5, k.power)) + (0.5 * k.d + k.e);
  table().cloth.sheen[static_cast<int>(masking)][times_cosine](k, at_half, o, i, out, n);
}

void mirror_at_visible_normals(Distribution distribution, const Stretch& stretch, const SeenFrom& from,
                               const double* u1, const double* u2, const MirroredAtNormals& out, std::size_t n) {
  detail::VisibleConstants k = constants_of(stretch, from);
  if (distribution == Distribution::beckmann) add_facing(k);
  table().sampling.mirror[static_cast<int>(distribution)](k, u1, u2, out, n);
}

#define BRDFPLOT_DEFINE(T)                                                                                             \
  void project(const Stretch& stretch, Vectors<T> omega, T* c, T* s, std::size_t n) {                                  \
    run_project(stretch, omega, c, s, n);                                                                              \
  }                                                                                                                    \
  void masked_area_beckmann(const T* c, const T* s, T* tau, std::size_t n) {                                           \
    kernels<T>().masked_area_beckmann(c, s, tau, n);                                                                   \
  }                                                                                                                    \
  void masked_area_ggx(const T* c, const T* s, T* tau, std::size_t n) { kernels<T>().masked_area_ggx(c, s, tau, n); }  \
  void masked_area_beckmann_walter(const T* c, const T* s, T* tau, std::size_t n) {                                    \
    kernels<T>().masked_area_walter(c, s, tau, n);                                                                     \
  }                                                                                                                    \
  void lambda_beckmann(const T* c, const T* s, T* lambda, std::size_t n) {                                             \
    kernels<T>().lambda_beckmann(c, s, lambda, n);                                                                     \
  }                                                                                                                    \
  void lambda_ggx(const T* c, const T* s, T* lambda, std::size_t n) { kernels<T>().lambda_ggx(c, s, lambda, n); }      \
  void lambda_beckmann_walter(const T* c, const T* s, T* lambda, std::size_t n) {                                      \
    kernels<T>().lambda_walter(c, s, lambda, n);                                                                       \
  }                                                                                                                    \
  void lambda_beckmann(const T* a, T* lambda, std::size_t n) { kernels<T>().lambda_beckmann_of_a(a, lambda, n); }      \
  void lambda_ggx(const T* a, T* lambda, std::size_t n) { kernels<T>().lambda_ggx_of_a(a, lambda, n); }                \
  void d_beckmann(const Stretch& stretch, Vectors<T> omega_m, T* d, std::size_t n) {                                   \
    run_density(stretch, Distribution::beckmann, omega_m, d, n);                                                       \
  }                                                                                                                    \
  void d_ggx(const Stretch& stretch, Vectors<T> omega_m, T* d, std::size_t n) {                                        \
    run_density(stretch, Distribution::ggx, omega_m, d, n);                                                            \
  }                                                                                                                    \
  void brdf(const Stretch& stretch, Distribution distribution, Shadowing shadowing, Vectors<T> omega_o,                \
            Vectors<T> omega_i, T* value, std::size_t n) {                                                             \
    run_brdf(stretch, distribution, shadowing, omega_o, omega_i, value, n);                                            \
  }

BRDFPLOT_DEFINE(double)
BRDFPLOT_DEFINE(float)

#undef BRDFPLOT_DEFINE

} // namespace brdfplot::kernels
