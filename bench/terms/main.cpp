/// \file
/// Nanoseconds a pair of the diffuse and cloth terms in a batch, beside a plain transcription of the published formula
/// in double, with its parameters in an object: called once a pair, as a renderer calls it, and written into a loop
/// over all pairs. Three channels where a term is coloured. The three take turns, and the fastest turn of each counts.
#include "brdf/evaluate.hpp"
#include "transcriptions.hpp"

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
using std::numbers::pi;

constexpr std::size_t pairs = 1000;
const Rgb albedo{0.8, 0.5, 0.2}, f0{0.04, 0.05, 0.06};
constexpr double roughness = 0.7, subsurface = 0.3, alpha = 0.5;

/// Aligned, as the vectors of a processor want it.
template <std::size_t size>
struct alignas(64) Aligned : std::array<double, size> {};

struct Pairs {
  Aligned<pairs> ox, oy, oz, ix, iy, iz;
};

const Pairs& input() {
  static const Pairs made = [] {
    Pairs p;
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> unit(0, 1);
    for (std::size_t k = 0; k < pairs; ++k) {
      const Direction o = from_angles(0.5 * pi * unit(engine), 2 * pi * unit(engine));
      const Direction i = from_angles(0.5 * pi * unit(engine), 2 * pi * unit(engine));
      p.ox[k] = o.x, p.oy[k] = o.y, p.oz[k] = o.z;
      p.ix[k] = i.x, p.iy[k] = i.y, p.iz[k] = i.z;
    }
    return p;
  }();
  return made;
}

Aligned<3 * pairs>& output() {
  static Aligned<3 * pairs> values;
  return values;
}

/// A term as a renderer has it: called once a pair, by its address.
struct Transcription {
  virtual ~Transcription() = default;
  virtual Rgb called(const Direction& o, const Direction& i) const = 0;
  /// Over all pairs, without a call: what the compiler makes of the formula in a loop of its own.
  virtual void inlined(int channels) const = 0;
};

/// Over all pairs.
template <class F>
void one_by_one(int channels, const F& rho) {
  const Pairs& p = input();
  double* const out = output().data();
  for (std::size_t k = 0; k < pairs; ++k) {
    const Direction o{p.ox[k], p.oy[k], p.oz[k]}, i{p.ix[k], p.iy[k], p.iz[k]};
    const Rgb value = o.z > 0 && i.z > 0 ? rho(o, i) : Rgb{};
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) out[c * pairs + k] = value[c];
  }
}

template <class T>
struct TranscriptionOf final : Transcription {
  T term;
  explicit TranscriptionOf(const T& of) : term(of) {}
  Rgb called(const Direction& o, const Direction& i) const override { return term.rho(o, i); }
  void inlined(int channels) const override {
    one_by_one(channels, [this](const Direction& o, const Direction& i) { return term.rho(o, i); });
  }
};

/// Seconds of `run`, repeated to be measurable.
double seconds(const std::function<void()>& run) {
  constexpr int repetitions = 50;
  const auto begin = std::chrono::steady_clock::now();
  for (int k = 0; k < repetitions; ++k) run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / repetitions;
}

void compare(const std::string& name, const TermDescription& description, const Transcription& transcription) {
  const Material material = build(description);
  const int channels = channels_of(material, Quantity::brdf);
  const Pairs& p = input();
  const Batch batch{pairs, {p.ox.data(), p.oy.data(), p.oz.data()}, {p.ix.data(), p.iy.data(), p.iz.data()}, {}};
  const auto in_batch = [&] { evaluate(material, Quantity::brdf, batch, output().data()); };
  const auto called = [&] {
    one_by_one(channels, [&](const Direction& o, const Direction& i) { return transcription.called(o, i); });
  };
  const auto inlined = [&] { transcription.inlined(channels); };
  called();
  const Aligned<3 * pairs> expected = output();
  in_batch();
  double apart = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(channels) * pairs; ++k)
    apart = std::max(apart, std::fabs(output()[k] - expected[k]) / std::fmax(1e-3, std::fabs(expected[k])));
  double ours = infinity, by_call = infinity, in_loop = infinity;
  for (int round = 0; round < 200; ++round) {
    ours = std::min(ours, seconds(in_batch));
    by_call = std::min(by_call, seconds(called));
    in_loop = std::min(in_loop, seconds(inlined));
  }
  const double scale = 1e9 / static_cast<double>(pairs);
  std::printf("| %s | %.2f | %.2f | %.1f | %.2f | %.1f | %.0e |\n", name.c_str(), scale * ours, scale * by_call,
              by_call / ours, scale * in_loop, in_loop / ours, apart);
}

using Parameters = std::vector<std::pair<std::string, Value>>;

template <class T>
void measure(const std::string& name, const Parameters& values, const T& transcription) {
  TermDescription description;
  description.type = name.substr(0, name.find(' '));
  for (const auto& [key, value] : values) description.values.set(key, value);
  compare(name, description, TranscriptionOf<T>(transcription));
}

/// A mirror term of sheen.
template <class T>
void measure_sheen(const std::string& name, const std::string& masking, const std::string& shadowing,
                   const T& transcription) {
  TermDescription description;
  description.distribution.type = "sheen";
  description.distribution.values.set("alpha", alpha);
  description.masking.type = masking;
  description.shadowing = ModelChoice{shadowing};
  compare(name, description, TranscriptionOf<T>(transcription));
}

} // namespace

int main() {
  const std::pair<std::string, Value> colour{"albedo", albedo}, normal{"f0", f0};
  std::printf("| term | batch, ns a pair | called, ns | ratio | in a loop, ns | ratio | apart |\n"
              "| --- | --- | --- | --- | --- | --- | --- |\n");
  measure("lambert", {colour}, transcribed::Lambert{albedo});
  measure("fresnel_lambert at the normal", {colour, normal}, transcribed::FresnelLambert{albedo, f0});
  measure("fresnel_lambert at the half vector", {colour, normal, {"at", std::string("half")}},
          transcribed::FresnelLambertHalf{albedo, f0});
  measure("shirley", {colour, normal}, transcribed::Shirley{albedo, f0});
  measure("disney_diffuse", {colour, {"roughness", roughness}, {"subsurface", subsurface}},
          transcribed::Disney{albedo, roughness, subsurface});
  measure("hammon_diffuse", {colour, normal, {"alpha", alpha}}, transcribed::Hammon{albedo, f0, alpha});
  measure("fujii_oren_nayar", {colour, {"roughness", roughness}}, transcribed::Fujii{albedo, roughness});
  measure("eon", {colour, {"roughness", roughness}}, transcribed::Eon{albedo, roughness});
  measure("oren_nayar full", {colour, {"sigma", 0.3}}, transcribed::OrenNayar{albedo, 0.3});
  measure("oren_nayar qualitative", {colour, {"sigma", 0.3}, {"form", std::string("qualitative")}},
          transcribed::OrenNayarQualitative{albedo, 0.3});
  measure("disney_sheen", {{"color", albedo}}, transcribed::DisneySheen{albedo});
  measure("velvet_cloth", {colour, normal, {"alpha", alpha}, {"amplitude", 4.0}},
          transcribed::VelvetCloth{albedo, f0, alpha, 4});
  measure("uncharted2",
          {colour, {"rim", 2.0}, {"rim_power", 3.5}, {"inner", 0.5}, {"inner_power", 2.5}, {"diffuse", 0.25}},
          transcribed::Uncharted2{albedo, 2, 3.5, 0.5, 2.5, 0.25});
  measure("wrap", {colour, {"w", 0.5}}, transcribed::Wrap{albedo, 0.5});
  measure_sheen("mirror of sheen, its fit of Lambda", "sheen_fit", "height_correlated", transcribed::Sheen{alpha});
  measure_sheen("mirror of sheen, neubelt", "smith", "neubelt", transcribed::SheenUnmasked{{alpha}});
}
