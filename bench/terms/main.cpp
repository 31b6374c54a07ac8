/// \file
/// Nanoseconds a pair of the diffuse and cloth terms in a batch, beside a plain transcription of the published formula,
/// one pair after the other in double: three channels where a term is coloured. The two take turns, and the fastest
/// turn of each counts.
#include "brdf/evaluate.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace brdfplot;
using std::numbers::inv_pi;
using std::numbers::pi;

constexpr std::size_t pairs = 1000;
const Rgb albedo{0.8, 0.5, 0.2}, f0{0.04, 0.05, 0.06};

struct Pairs {
  std::vector<double> ox, oy, oz, ix, iy, iz;
};

const Pairs& input() {
  static const Pairs made = [] {
    Pairs p;
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> unit(0, 1);
    for (std::size_t k = 0; k < pairs; ++k) {
      const Direction o = from_angles(0.5 * pi * unit(engine), 2 * pi * unit(engine));
      const Direction i = from_angles(0.5 * pi * unit(engine), 2 * pi * unit(engine));
      p.ox.push_back(o.x), p.oy.push_back(o.y), p.oz.push_back(o.z);
      p.ix.push_back(i.x), p.iy.push_back(i.y), p.iz.push_back(i.z);
    }
    return p;
  }();
  return made;
}

std::vector<double>& output() {
  static std::vector<double> values(3 * pairs);
  return values;
}

Direction half(const Direction& o, const Direction& i) {
  const Direction h = o + i;
  return (1 / std::sqrt(dot(h, h))) * h;
}

double pow5(double x) { return x * x * x * x * x; }
Rgb times(double s) { return {albedo[0] * s, albedo[1] * s, albedo[2] * s}; }
double schlick(double f, double c) { return f + (1 - f) * pow5(1 - c); }

/// By channel.
template <class F>
Rgb each(const F& f) {
  return {f(std::size_t{0}), f(std::size_t{1}), f(std::size_t{2})};
}

Rgb lambert(const Direction&, const Direction&) { return times(inv_pi); }

Rgb fresnel_lambert(const Direction&, const Direction& i) {
  return each([&](std::size_t c) { return (1 - schlick(f0[c], i.z)) * albedo[c] * inv_pi; });
}

Rgb fresnel_lambert_half(const Direction& o, const Direction& i) {
  const double lh = dot(half(o, i), i);
  return each([&](std::size_t c) { return (1 - schlick(f0[c], lh)) * albedo[c] * inv_pi; });
}

double through_both(double l, double v) { return (1 - pow5(1 - l)) * (1 - pow5(1 - v)); }

Rgb shirley(const Direction& o, const Direction& i) {
  const double both = 21 / (20 * pi) * through_both(i.z, o.z);
  return each([&](std::size_t c) { return both * (1 - f0[c]) * albedo[c]; });
}

constexpr double roughness = 0.7, subsurface = 0.3;

Rgb disney(const Direction& o, const Direction& i) {
  const double lh = dot(half(o, i), i), m_l = pow5(1 - i.z), m_v = pow5(1 - o.z);
  const double ss90 = roughness * lh * lh, d90 = 0.5 + 2 * ss90;
  const double f_d = (1 + (d90 - 1) * m_l) * (1 + (d90 - 1) * m_v);
  const double f_s = (1 + (ss90 - 1) * m_l) * (1 + (ss90 - 1) * m_v);
  return times(inv_pi * ((1 - subsurface) * f_d + 1.25 * subsurface * ((1 / (i.z + o.z) - 0.5) * f_s + 0.5)));
}

Rgb sheen(const Direction& o, const Direction& i) { return times(pow5(1 - dot(half(o, i), i))); }

constexpr double alpha = 0.5;

Rgb hammon(const Direction& o, const Direction& i) {
  const double facing = 0.5 + 0.5 * dot(o, i), nh = half(o, i).z;
  const double rough = facing * (0.9 - 0.4 * facing) * ((0.5 + nh) / nh), both = 1.05 * through_both(i.z, o.z);
  return each([&](std::size_t c) {
    return albedo[c] * inv_pi * ((1 - alpha) * both * (1 - f0[c]) + alpha * rough + albedo[c] * (0.3641 * alpha));
  });
}

Rgb velvet(const Direction& o, const Direction& i) {
  constexpr double amplitude = 4;
  const Direction h = half(o, i);
  const double lh = dot(h, i), c2 = h.z * h.z, s2 = 1 - c2;
  const double d =
      (1 + amplitude * std::exp(-c2 / (alpha * alpha * s2)) / (s2 * s2)) / (pi * (1 + amplitude * alpha * alpha));
  const double cloth = d / (4 * (i.z + o.z - i.z * o.z));
  return each([&](std::size_t c) {
    const double f = schlick(f0[c], lh);
    return (1 - f) * albedo[c] * inv_pi + f * cloth;
  });
}

Rgb uncharted2(const Direction& o, const Direction&) {
  return times(inv_pi * (2 * std::pow(o.z, 3.5) + 0.5 * std::pow(1 - o.z, 2.5) + 0.25));
}

const double k1 = 0.5 - 2 / (3 * pi), k2 = 2.0 / 3 - 28 / (15 * pi);

double fujii(const Direction& o, const Direction& i) {
  const double s = dot(o, i) - o.z * i.z, t = s > 0 ? std::max(o.z, i.z) : 1;
  return inv_pi / (1 + k1 * roughness) * (1 + roughness * s / t);
}

Rgb fujii_rgb(const Direction& o, const Direction& i) { return times(fujii(o, i)); }

/// E_FON_exact of the authors' shader.
double fujii_albedo(double mu) {
  const double a = 1 / (1 + k1 * roughness), s = std::sqrt(1 - mu * mu);
  const double g = s * (std::acos(mu) - s * mu) + 2.0 / 3 * ((s / mu) * (1 - s * s * s) - s);
  return a + roughness * a * inv_pi * g;
}

Rgb eon(const Direction& o, const Direction& i) {
  const double mean = (1 + k2 * roughness) / (1 + k1 * roughness);
  const double once = fujii(o, i), further = (1 - fujii_albedo(o.z)) * (1 - fujii_albedo(i.z)) / (1 - mean);
  return each([&](std::size_t c) {
    const double a = albedo[c];
    return a * once + inv_pi * a * a * mean / (1 - a * (1 - mean)) * further;
  });
}

/// As in Mitsuba 0.6, with angles.
Rgb oren_nayar(const Direction& o, const Direction& i) {
  constexpr double s = 0.3 * 0.3;
  const double theta_o = std::acos(o.z), theta_i = std::acos(i.z);
  const double a = std::max(theta_o, theta_i), b = std::min(theta_o, theta_i);
  const double k = (o.x * i.x + o.y * i.y) / (std::sin(theta_o) * std::sin(theta_i));
  const double q = 2 * inv_pi * b, angles = 4 * inv_pi * inv_pi * a * b;
  const double c2 = 0.45 * s / (s + 0.09) * (k >= 0 ? std::sin(a) : std::sin(a) - q * q * q);
  const double c3 = 0.125 * s / (s + 0.09) * angles * angles;
  const double once =
      1 - 0.5 * s / (s + 0.33) + k * c2 * std::tan(b) + (1 - std::fabs(k)) * c3 * std::tan(0.5 * (a + b));
  const double twice = 0.17 * s / (s + 0.13) * (1 - k * q * q);
  return each([&](std::size_t c) { return inv_pi * albedo[c] * (once + albedo[c] * twice); });
}

Rgb oren_nayar_qualitative(const Direction& o, const Direction& i) {
  constexpr double s = 0.3 * 0.3;
  const double sin_o = std::sqrt(1 - o.z * o.z), sin_i = std::sqrt(1 - i.z * i.z);
  const double k = std::max(0.0, (o.x * i.x + o.y * i.y) / (sin_o * sin_i));
  const double tan_b = std::min(sin_o, sin_i) / std::max(o.z, i.z);
  return times(inv_pi * (1 - 0.5 * s / (s + 0.33) + 0.45 * s / (s + 0.09) * k * std::max(sin_o, sin_i) * tan_b));
}

/// A transcription over all pairs.
template <Rgb (*rho)(const Direction&, const Direction&)>
void one_by_one() {
  const Pairs& p = input();
  double* const out = output().data();
  for (std::size_t k = 0; k < pairs; ++k) {
    const Direction o{p.ox[k], p.oy[k], p.oz[k]}, i{p.ix[k], p.iy[k], p.iz[k]};
    const Rgb value = o.z > 0 && i.z > 0 ? rho(o, i) : Rgb{};
    for (std::size_t c = 0; c < 3; ++c) out[c * pairs + k] = value[c];
  }
}

/// Seconds of `run`, repeated to be measurable.
double seconds(const std::function<void()>& run) {
  constexpr int repetitions = 50;
  const auto begin = std::chrono::steady_clock::now();
  for (int k = 0; k < repetitions; ++k) run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / repetitions;
}

void measure(const std::string& name, const std::vector<std::pair<std::string, Value>>& values,
             const std::function<void()>& transcription) {
  TermDescription description;
  description.type = name.substr(0, name.find(' '));
  for (const auto& [key, value] : values) description.values.set(key, value);
  const Material material = build(description);
  const Pairs& p = input();
  const Batch batch{pairs, {p.ox.data(), p.oy.data(), p.oz.data()}, {p.ix.data(), p.iy.data(), p.iz.data()}, {}};
  const auto in_batch = [&] { evaluate(material, Quantity::brdf, batch, output().data()); };
  transcription();
  const std::vector<double> expected = output();
  in_batch();
  double apart = 0;
  for (std::size_t k = 0; k < 3 * pairs; ++k)
    apart = std::max(apart, std::fabs(output()[k] - expected[k]) / std::fmax(1e-3, std::fabs(expected[k])));
  double ours = infinity, theirs = infinity;
  for (int round = 0; round < 200; ++round) {
    ours = std::min(ours, seconds(in_batch));
    theirs = std::min(theirs, seconds(transcription));
  }
  const double scale = 1e9 / static_cast<double>(pairs);
  std::printf("| %s | %.2f | %.2f | %.1f | %.0e |\n", name.c_str(), scale * ours, scale * theirs, theirs / ours, apart);
}

} // namespace

int main() {
  const std::pair<std::string, Value> colour{"albedo", albedo}, normal{"f0", f0};
  std::printf("| term | batch, ns a pair | transcription, ns | ratio | apart |\n| --- | --- | --- | --- | --- |\n");
  measure("lambert", {colour}, one_by_one<lambert>);
  measure("fresnel_lambert at the normal", {colour, normal}, one_by_one<fresnel_lambert>);
  measure("fresnel_lambert at the half vector", {colour, normal, {"at", std::string("half")}},
          one_by_one<fresnel_lambert_half>);
  measure("shirley", {colour, normal}, one_by_one<shirley>);
  measure("disney_diffuse", {colour, {"roughness", roughness}, {"subsurface", subsurface}}, one_by_one<disney>);
  measure("disney_sheen", {{"color", albedo}}, one_by_one<sheen>);
  measure("hammon_diffuse", {colour, normal, {"alpha", alpha}}, one_by_one<hammon>);
  measure("velvet_cloth", {colour, normal, {"alpha", alpha}, {"amplitude", 4.0}}, one_by_one<velvet>);
  measure("uncharted2",
          {colour, {"rim", 2.0}, {"rim_power", 3.5}, {"inner", 0.5}, {"inner_power", 2.5}, {"diffuse", 0.25}},
          one_by_one<uncharted2>);
  measure("fujii_oren_nayar", {colour, {"roughness", roughness}}, one_by_one<fujii_rgb>);
  measure("eon", {colour, {"roughness", roughness}}, one_by_one<eon>);
  measure("oren_nayar full", {colour, {"sigma", 0.3}}, one_by_one<oren_nayar>);
  measure("oren_nayar qualitative", {colour, {"sigma", 0.3}, {"form", std::string("qualitative")}},
          one_by_one<oren_nayar_qualitative>);
}
