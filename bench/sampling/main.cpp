/// \file
/// Nanoseconds a sample of visible normals: direction, density and weight f cos / pdf (F = 1), in batches at one
/// viewer, beside plain transcriptions of what renderers do, one sample after the other in double; and of every
/// strategy. All take turns, and the fastest turn of each counts.
#include "sampling/points.hpp"
#include "sampling/sampler.hpp"
#include "sampling/weights.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace brdfplot;
using std::numbers::inv_sqrtpi;
using std::numbers::pi;

constexpr std::size_t samples = 1000, viewers = 16;
constexpr double alpha_x = 0.3, alpha_y = 0.5;

struct Sample {
  Direction i;
  double pdf, weight;
};

double square(double x) { return x * x; }
double safe_root(double x) { return std::sqrt(std::max(x, 0.0)); }
double lerp(double t, double a, double b) { return (1 - t) * a + t * b; }
Direction cross(const Direction& a, const Direction& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Direction unit(const Direction& v) { return (1 / std::sqrt(dot(v, v))) * v; }

/// pbrt-v4: TrowbridgeReitzDistribution, and ConductorBxDF::Sample_f.
namespace pbrt {

double tan2_theta(const Direction& w) { return std::max(0.0, 1 - square(w.z)) / square(w.z); }
double cos_phi(const Direction& w) {
  const double sine = safe_root(1 - square(w.z));
  return sine == 0 ? 1 : std::clamp(w.x / sine, -1.0, 1.0);
}
double sin_phi(const Direction& w) {
  const double sine = safe_root(1 - square(w.z));
  return sine == 0 ? 0 : std::clamp(w.y / sine, -1.0, 1.0);
}

double d(const Direction& m) {
  const double tan2 = tan2_theta(m), cos4 = square(square(m.z));
  if (std::isinf(tan2) || cos4 < 1e-16) return 0;
  const double e = tan2 * (square(cos_phi(m) / alpha_x) + square(sin_phi(m) / alpha_y));
  return 1 / (pi * alpha_x * alpha_y * cos4 * square(1 + e));
}

double lambda(const Direction& w) {
  const double tan2 = tan2_theta(w);
  if (std::isinf(tan2)) return 0;
  const double alpha2 = square(cos_phi(w) * alpha_x) + square(sin_phi(w) * alpha_y);
  return (-1 + std::sqrt(1 + alpha2 * tan2)) / 2;
}

Direction normal(const Direction& w, double u1, double u2) {
  Direction wh = unit({alpha_x * w.x, alpha_y * w.y, w.z});
  if (wh.z < 0) wh = -1.0 * wh;
  const Direction t1 = wh.z < 0.99999 ? unit(cross({0, 0, 1}, wh)) : Direction{1, 0, 0}, t2 = cross(wh, t1);
  const double r = std::sqrt(u1), phi = 2 * pi * u2, x = r * std::cos(phi), h = std::sqrt(1 - square(x));
  const double y = lerp((1 + wh.z) / 2, h, r * std::sin(phi)), z = safe_root(1 - (x * x + y * y));
  const Direction nh = x * t1 + y * t2 + z * wh;
  return unit({alpha_x * nh.x, alpha_y * nh.y, std::max(1e-6, nh.z)});
}

Sample sample(const Direction& o, double u1, double u2) {
  const Direction wm = normal(o, u1, u2), i = -1.0 * o + (2 * dot(o, wm)) * wm;
  if (!(o.z * i.z > 0)) return {i, 0, 0};
  const double pdf = d(wm) / (1 + lambda(o)) * std::fabs(dot(o, wm)) / std::fabs(o.z) / (4 * std::fabs(dot(o, wm)));
  const double f = d(wm) / (1 + lambda(o) + lambda(i)) / (4 * std::fabs(i.z) * std::fabs(o.z));
  return {i, pdf, f * std::fabs(i.z) / pdf};
}

} // namespace pbrt

/// Mitsuba 3: MicrofacetDistribution with sample_visible, and roughconductor's sample().
namespace mitsuba {

enum class Type { beckmann, ggx };

/// Dr.Jit's, after Giles 2010.
double erfinv(double x) {
  const double w = -std::log((1 - x) * (1 + x));
  double p = 0;
  if (w < 5) {
    constexpr double c[] = {2.81022636e-08, 3.43273939e-07, -3.5233877e-06, -4.39150654e-06, 0.00021858087,
                            -0.00125372503, -0.00417768164, 0.246640727,    1.50140941};
    for (const double k : c) p = k + p * (w - 2.5);
  } else {
    constexpr double c[] = {-0.000200214257, 0.000100950558, 0.00134934322, -0.00367342844, 0.00573950773,
                            -0.0076224613,   0.00943887047,  1.00167406,    2.83297682};
    for (const double k : c) p = k + p * (std::sqrt(w) - 3);
  }
  return p * x;
}

template <Type type>
double d(const Direction& m) {
  const double n = square(m.x / alpha_x) + square(m.y / alpha_y), cos2 = square(m.z);
  const double value = type == Type::beckmann ? std::exp(-n / cos2) / (pi * alpha_x * alpha_y * square(cos2))
                                              : 1 / (pi * alpha_x * alpha_y * square(n + cos2));
  return value * m.z > 1e-20 ? value : 0;
}

template <Type type>
double g1(const Direction& v, const Direction& m) {
  const double xy2 = square(alpha_x * v.x) + square(alpha_y * v.y), tan2 = xy2 / square(v.z);
  if (dot(v, m) * v.z <= 0) return 0;
  if (xy2 == 0) return 1;
  if (type == Type::ggx) return 2 / (1 + std::sqrt(1 + tan2));
  const double a = 1 / std::sqrt(tan2);
  return a >= 1.6 ? 1 : (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a);
}

/// Shirley and Chiu's concentric map.
std::pair<double, double> disk(double u1, double u2) {
  const double x = 2 * u1 - 1, y = 2 * u2 - 1;
  const bool steep = std::fabs(x) < std::fabs(y);
  const double r = steep ? y : x, other = steep ? x : y;
  double phi = r == 0 ? 0 : 0.25 * pi * other / r;
  if (steep) phi = 0.5 * pi - phi;
  return {r * std::cos(phi), r * std::sin(phi)};
}

template <Type type>
std::pair<double, double> slope(double cos_theta, double u1, double u2) {
  if (type == Type::ggx) {
    const auto [x, first_y] = disk(u1, u2);
    const double y = lerp(0.5 * (1 + cos_theta), safe_root(1 - x * x), first_y), z = safe_root(1 - x * x - y * y);
    const double sin_theta = safe_root(1 - square(cos_theta)), norm = 1 / (sin_theta * y + cos_theta * z);
    return {(cos_theta * y - sin_theta * z) * norm, x * norm};
  }
  const double tan_theta = safe_root(1 - square(cos_theta)) / cos_theta, cot_theta = 1 / tan_theta;
  const double most = std::erf(cot_theta);
  u1 = std::clamp(u1, 1e-6, 1 - 1e-6), u2 = std::clamp(u2, 1e-6, 1 - 1e-6);
  double x = most - (most + 1) * std::erf(std::sqrt(-std::log(u1)));
  u1 *= 1 + most + inv_sqrtpi * tan_theta * std::exp(-square(cot_theta));
  for (int k = 0; k < 3; ++k) {
    const double s = erfinv(x), value = 1 + x + inv_sqrtpi * tan_theta * std::exp(-s * s) - u1;
    x -= value / (1 - s * tan_theta);
  }
  return {erfinv(x), erfinv(2 * u2 - 1)};
}

template <Type type>
Sample sample(const Direction& o, double u1, double u2) {
  const Direction stretched = unit({alpha_x * o.x, alpha_y * o.y, o.z});
  const double sin2 = square(stretched.x) + square(stretched.y), norm = sin2 > 0 ? 1 / std::sqrt(sin2) : 0;
  const double cos_phi = sin2 > 0 ? stretched.x * norm : 1, sin_phi = stretched.y * norm;
  const auto [x, y] = slope<type>(stretched.z, u1, u2);
  const Direction m = unit({-(cos_phi * x - sin_phi * y) * alpha_x, -(sin_phi * x + cos_phi * y) * alpha_y, 1});
  const double pdf = d<type>(m) * g1<type>(o, m) * std::fabs(dot(o, m)) / o.z;
  const Direction i = (2 * dot(o, m)) * m + -1.0 * o;
  if (pdf == 0 || i.z <= 0) return {i, 0, 0};
  return {i, pdf / (4 * dot(i, m)), g1<type>(i, m)};
}

} // namespace mitsuba

std::vector<Direction> all_viewers() {
  std::vector<Direction> all;
  for (std::size_t v = 0; v < viewers; ++v)
    all.push_back(from_angles(0.5 * pi * (static_cast<double>(v) + 0.5) / viewers, static_cast<double>(v)));
  return all;
}

using One = Sample (*)(const Direction&, double, double);

template <One one>
void one_by_one(const Direction& o, const std::vector<SamplePoint>& all, WeightedSamples& out) {
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Sample s = one(o, all[k][0], all[k][1]);
    out.lights.set(k, s.i);
    out.pdf[k] = s.pdf;
    out.weights[k] = s.weight;
  }
}

using Run = std::function<void(const Direction&)>;

/// Seconds of a sample, of all viewers.
double seconds(const std::vector<Direction>& from, const Run& run) {
  const auto begin = std::chrono::steady_clock::now();
  for (const Direction& o : from) run(o);
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return elapsed / static_cast<double>(viewers * samples);
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

Material material_of(const std::string& type, const std::string& shadowing) {
  TermDescription description;
  description.distribution.type = type;
  description.distribution.values.set("alpha_x", alpha_x);
  description.distribution.values.set("alpha_y", alpha_y);
  description.shadowing = ModelChoice{shadowing, {}};
  return build(description);
}

/// `shadowing` as the renderer has it, so that the mean weights are the same but for chance and Walter's fit.
void measure(const std::string& type, const std::string& name, const std::string& shadowing,
             void (*transcription)(const Direction&, const std::vector<SamplePoint>&, WeightedSamples&)) {
  const Material material = material_of(type, shadowing);
  const Sampler sampler(material, "visible_normals");
  const std::vector<SamplePoint> all = points(PointKind::sobol, 1, 0, 0, samples);
  const std::vector<Direction> from = all_viewers();
  WeightedSamples out;
  out.lights.resize(samples);
  out.pdf.resize(samples), out.weights.resize(samples);
  double apart = 0;
  for (const Direction& o : from) {
    transcription(o, all, out);
    const double theirs = mean(out.weights);
    draw(material, sampler, o, all, out);
    apart = std::max(apart, std::fabs(mean(out.weights) - theirs));
  }
  double ours = infinity, theirs = infinity;
  for (int round = 0; round < 200; ++round) {
    ours = std::min(ours, seconds(from, [&](const Direction& o) { draw(material, sampler, o, all, out); }));
    theirs = std::min(theirs, seconds(from, [&](const Direction& o) { transcription(o, all, out); }));
  }
  std::printf("| %s | %.2f | %s | %.1f | %.1f | %.0e |\n", type.c_str(), 1e9 * ours, name.c_str(), 1e9 * theirs,
              theirs / ours, apart);
}

/// Every strategy of mirrors, of one distribution.
void measure_strategies(const std::string& type, const std::vector<std::string>& strategies) {
  const Material material = material_of(type, "height_correlated");
  const std::vector<SamplePoint> all = points(PointKind::sobol, 1, 0, 0, samples);
  const std::vector<Direction> from = all_viewers();
  std::vector<double> fastest(strategies.size(), infinity);
  WeightedSamples out;
  for (int round = 0; round < 100; ++round)
    for (std::size_t k = 0; k < strategies.size(); ++k) {
      const Sampler sampler(material, strategies[k]);
      const auto run = [&](const Direction& o) { draw(material, sampler, o, all, out); };
      fastest[k] = std::min(fastest[k], seconds(from, run));
    }
  for (std::size_t k = 0; k < strategies.size(); ++k)
    std::printf("| %s | %s | %.1f |\n", type.c_str(), strategies[k].c_str(), 1e9 * fastest[k]);
}

} // namespace

int main() {
  std::printf("| distribution | batch, ns a sample | beside | ns | ratio | mean weights apart |\n"
              "| --- | --- | --- | --- | --- | --- |\n");
  measure("ggx", "as pbrt-v4", "height_correlated", one_by_one<pbrt::sample>);
  measure("ggx", "as Mitsuba 3", "separable", one_by_one<mitsuba::sample<mitsuba::Type::ggx>>);
  measure("beckmann", "as Mitsuba 3", "separable", one_by_one<mitsuba::sample<mitsuba::Type::beckmann>>);
  std::printf("\n| distribution | strategy | ns a sample |\n| --- | --- | --- |\n");
  measure_strategies("ggx", {"cosine", "half_vector", "visible_normals", "heitz_2018"});
  measure_strategies("beckmann", {"cosine", "half_vector", "visible_normals"});
}
