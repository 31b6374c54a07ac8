/// \file
/// What the live page calls: the library's evaluation and integrals of one material, by memory that both sides see. A
/// function that can fail returns 0, or 1 with the error's text in message().

#include "analysis/integrals.hpp"
#include "brdf/evaluate.hpp"
#include "brdf/terms.hpp"
#include "config/load.hpp"
#include "models/registry.hpp"
#include "version.hpp"

#include <nlohmann/json.hpp>

#include <exception>
#include <optional>

namespace brdfplot::live {

namespace {

using Json = nlohmann::ordered_json;

struct State {
  std::vector<char> text;      ///< what the page writes: a material
  std::vector<double> numbers; ///< nine columns of directions (o, i, m), then three of results
  std::size_t rows = 0;
  std::string message;
  std::optional<Material> material;
};

State& state() {
  static State all;
  return all;
}

template <class Work>
int told(const Work& work) {
  try {
    state().message.clear();
    work();
    return 0;
  } catch (const std::exception& error) {
    state().message = error.what();
    return 1;
  }
}

Json finite(double bound) { return bound - bound == 0 ? Json(bound) : Json(); }

Json described(const ParameterSpec& parameter) {
  static constexpr std::array kinds = {"number", "number_or_rgb", "vec2", "vec3",      "boolean",
                                       "choice", "formula",       "text", "components"};
  Json out = {{"key", parameter.key},
              {"kind", kinds[static_cast<std::size_t>(parameter.kind)]},
              {"doc", parameter.doc},
              {"min", finite(parameter.bounds.min)},
              {"max", finite(parameter.bounds.max)},
              {"choices", parameter.choices}};
  if (parameter.fallback)
    std::visit(
        [&]<class T>(const T& value) {
          if constexpr (!std::is_same_v<T, WeightedChoices>) out["fallback"] = value;
        },
        *parameter.fallback);
  return out;
}

Json described(const std::vector<ModelSpec>& specs) {
  Json all = Json::array();
  for (const ModelSpec& spec : specs) {
    Json parameters = Json::array();
    for (const ParameterSpec& parameter : spec.parameters) parameters.push_back(described(parameter));
    all.push_back({{"type", spec.type},
                   {"doc", spec.doc},
                   {"source", spec.source},
                   {"parameters", parameters},
                   {"alternatives", spec.alternatives}});
  }
  return all;
}

Columns columns(std::size_t first) {
  const double* const all = state().numbers.data();
  const std::size_t n = state().rows;
  return {all + first * n, all + (first + 1) * n, all + (first + 2) * n};
}

} // namespace

} // namespace brdfplot::live

using namespace brdfplot;
using live::state;

#define BRDFPLOT_EXPORT(name) extern "C" __attribute__((export_name(#name)))

/// Memory for a text of so many bytes.
BRDFPLOT_EXPORT(text) char* live_text(std::size_t bytes) {
  state().text.resize(bytes);
  return state().text.data();
}

/// Memory for so many rows: columns x, y and z of o, i and m, then up to three of results.
BRDFPLOT_EXPORT(numbers) double* live_numbers(std::size_t rows) {
  state().rows = rows;
  state().numbers.resize(12 * rows);
  return state().numbers.data();
}

BRDFPLOT_EXPORT(message) const char* live_message() { return state().message.data(); }
BRDFPLOT_EXPORT(message_size) std::size_t live_message_size() { return state().message.size(); }

/// The material that text() holds from now on. A wrong one leaves the last.
BRDFPLOT_EXPORT(material) int live_material() {
  return live::told([] {
    const std::string json(state().text.begin(), state().text.end());
    state().material.emplace(build(config::material_from_text(json, "material")));
  });
}

/// Models with their parameters, quantities and integrals, as JSON in message().
BRDFPLOT_EXPORT(describe) int live_describe() {
  std::string out;
  const int failed = live::told([&] {
    live::Json quantities = live::Json::array(), integrals = live::Json::array();
    for (const QuantityInfo& one : brdfplot::quantities()) quantities.push_back({{"name", one.name}, {"doc", one.doc}});
    for (const IntegralInfo& one : brdfplot::integrals()) integrals.push_back({{"name", one.name}, {"doc", one.doc}});
    out = live::Json{{"version", std::string(version)},
                     {"quantities", quantities},
                     {"integrals", integrals},
                     {"distribution", live::described(specs_of<Distribution>())},
                     {"masking", live::described(specs_of<Masking>())},
                     {"shadowing", live::described(specs_of<Shadowing>())},
                     {"fresnel", live::described(specs_of<Fresnel>())}}
              .dump();
  });
  if (failed == 0) state().message = out;
  return failed;
}

/// In place: in each of o, i and m the columns theta and phi (radians) become x, y and z.
BRDFPLOT_EXPORT(directions) void live_directions() {
  const std::size_t n = state().rows;
  for (std::size_t first = 0; first < 9; first += 3) {
    double* const x = state().numbers.data() + first * n;
    for (std::size_t k = 0; k < n; ++k) {
      const Direction d = from_angles(x[k], x[n + k]);
      x[k] = d.x, x[n + k] = d.y, x[2 * n + k] = d.z;
    }
  }
}

/// The number of columns of results, or 0 with a message. `given`: 1 for o, 2 for i, 4 for m, or a sum of them.
BRDFPLOT_EXPORT(evaluate) int live_evaluate(std::size_t quantity, unsigned given) {
  int channels = 0;
  live::told([&] {
    if (!state().material) throw InputError("material", "there is none");
    const QuantityInfo& info = quantities().at(quantity);
    const Material& material = *state().material;
    require(material, info, (given & 1U) != 0, (given & 2U) != 0, (given & 4U) != 0);
    Batch batch{state().rows, {}, {}, {}};
    if ((given & 1U) != 0) batch.o = live::columns(0);
    if ((given & 2U) != 0) batch.i = live::columns(3);
    if ((given & 4U) != 0) batch.m = live::columns(6);
    evaluate(material, info.quantity, used_by(info.quantity, batch), state().numbers.data() + 9 * state().rows);
    channels = channels_of(material, info.quantity);
  });
  return channels;
}

/// The same for an integral, by quadrature.
BRDFPLOT_EXPORT(integrate) int live_integrate(std::size_t integral, double tolerance) {
  int channels = 0;
  live::told([&] {
    if (!state().material) throw InputError("material", "there is none");
    const IntegralInfo& info = integrals().at(integral);
    const Material& material = *state().material;
    require(material, info);
    const std::size_t n = state().rows;
    const double* const o = state().numbers.data();
    for (std::size_t k = 0; k < n; ++k) {
      const Rgb values = compute_channels_or_throw(info.integral, material, {o[k], o[n + k], o[2 * n + k]}, tolerance);
      for (std::size_t c = 0; c < 3; ++c) state().numbers[(9 + c) * n + k] = values[c];
    }
    channels = info.coloured && material.channels() > 1 ? 3 : 1;
  });
  return channels;
}
