#include "config/figure/scope.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "figure/series/simulated.hpp"

#include <cmath>

namespace brdfplot::config {

bool is_numeric(const Json& value) { return angle()->matches(value); }

namespace {

/// "phi_o+180deg" or "-theta_o"; nothing where it is no such text.
std::optional<plot::Tie> parse_tie(std::string text) {
  std::erase(text, ' ');
  plot::Tie out;
  if (text.starts_with("-")) {
    out.sign = -1;
    text.erase(0, 1);
  }
  if (!text.starts_with("theta_") && !text.starts_with("phi_")) return std::nullopt;
  const auto end = text.find_first_of("+-");
  out.to = text.substr(0, end);
  if (end == std::string::npos) return out;
  const std::string offset = text.substr(text[end] == '+' ? end + 1 : end);
  const auto angle = parse_angle(offset);
  if (!angle || parse_number(offset) || !std::isfinite(*angle)) return std::nullopt;
  out.offset = *angle;
  return out;
}

} // namespace

plot::Setting to_setting(const std::string& variable, const Json& value) {
  if (is_numeric(value)) return {variable, to_number(value)};
  const auto text = value.get<std::string>();
  if (const auto tie = parse_tie(text)) return {variable, *tie};
  return {variable, text};
}

std::string word_for(const Json& value) {
  if (value.is_number()) return format_number(value.get<double>());
  auto text = value.get<std::string>();
  const auto unit = text.find("deg");
  if (!is_numeric(value) || unit == std::string::npos) return text;
  constexpr const char* blank = " \t\r";
  const auto first = text.find_first_not_of(blank);
  return text.substr(first, text.find_last_not_of(blank, unit - 1) + 1 - first) + "°";
}

std::string substituted(std::string text, const std::map<std::string, std::string>& words) {
  for (const auto& [variable, word] : words) {
    const std::string mark = "{" + variable + "}";
    for (auto at = text.find(mark); at != std::string::npos; at = text.find(mark, at + word.size()))
      text.replace(at, mark.size(), word);
  }
  return text;
}

plot::Simulate read_simulate(const Json& value) {
  plot::Simulate out;
  out.source = value["source"].get<std::string>();
  out.bounces = value.value("bounces", out.bounces);
  out.facets = value.value("facets", out.facets);
  out.paths = value.value("paths", out.paths);
  out.seed = value.value("seed", out.seed);
  out.realisations = value.value("realisations", out.realisations);
  out.cells = value.value("cells", out.cells);
  if (value.contains("half_width")) out.half_width = to_number(value["half_width"]);
  out.samples = value.value("samples", out.samples);
  return out;
}

namespace {

/// Runs `attempt`, with its errors told at a place of the file.
template <class Attempt>
void at_place(const JsonFile& file, const std::string& place, const Attempt& attempt) {
  try {
    attempt();
  } catch (const InputError& error) {
    file.fail(place, error.what());
  }
}

/// Where the value of a parameter was set last, if not in the material itself.
std::optional<std::string> place_of(const std::string& parameter, const Scope& scope, const std::vector<Sweep>& swept) {
  for (std::size_t k = scope.at.size(); k > 0; --k)
    if (scope.at[k - 1].variable == parameter) return scope.places[k - 1];
  for (const Sweep& sweep : swept)
    if (sweep.variable == parameter) return sweep.place;
  return std::nullopt;
}

/// A setting of the term itself that changes nothing is a mistake, and so is a BRDF over omega_m; outer levels set what
/// only some terms use, and a constant may be drawn beside a curve.
void check_used(const JsonFile& file, const plot::Term& term, const std::string& pointer, const Scope& scope,
                const std::vector<Sweep>& swept) {
  const auto check = [&](const std::string& variable, const std::string& place) {
    if (!plot::depends_on(term.quantity, variable))
      file.fail(place, "\"" + term.quantity + "\" does not depend on \"" + variable + "\"");
  };
  for (std::size_t k = 0; k < scope.at.size(); ++k)
    if (scope.places[k].starts_with(pointer + "/")) check(scope.at[k].variable, scope.places[k]);
  for (const Sweep& sweep : swept)
    if (term.quantity == "brdf" || term.quantity == "brdf_cos") check(sweep.variable, sweep.place);
}

} // namespace

void check_term(const JsonFile& file, const plot::Term& term, const std::string& pointer, const Scope& scope,
                const std::vector<Sweep>& swept, double tolerance) {
  plot::Configuration configuration(term.material);
  for (std::size_t k = 0; k < scope.at.size(); ++k)
    at_place(file, scope.places[k], [&] { configuration.set(scope.at[k]); });
  std::vector<std::string> variables;
  std::vector<double> from, to;
  for (const Sweep& sweep : swept) {
    for (const double end : {sweep.from, sweep.to})
      at_place(file, sweep.place, [&] { configuration.set({sweep.variable, end}); });
    variables.push_back(sweep.variable);
    from.push_back(sweep.from);
    to.push_back(sweep.to);
  }
  const auto told = [&](const std::string& place, const auto& attempt) {
    try {
      attempt();
    } catch (const MaterialError& error) {
      const auto set = place_of(error.pointer().substr(error.pointer().rfind('/') + 1), scope, swept);
      if (set) file.fail(*set, error.reason());
      file.fail(pointer, error.pointer() + ": " + error.reason());
    } catch (const InputError& error) {
      file.fail(place, error.what());
    }
  };
  const auto check = [&](auto& function, const std::string& place, const auto&... settings) {
    told(place, [&] { function.emplace(term, variables, settings...); });
    for (const auto* end : {&from, &to}) told(pointer, [&] { function->check(*end); });
  };
  std::optional<plot::SimulatedTerm> simulated;
  std::optional<plot::TermFunction> computed;
  if (term.simulate)
    check(simulated, pointer);
  else
    check(computed, pointer + "/quantity", tolerance);
  check_used(file, term, pointer, scope, swept);
}

} // namespace brdfplot::config
