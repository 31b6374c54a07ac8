#include "figure/series/configuration.hpp"

#include "base/number.hpp"
#include "models/registry.hpp"

#include <algorithm>

namespace brdfplot::plot {

namespace {

/// Sets a model's type by name; `values` that the new type may not have are its caller's business.
template <class List>
void set_type(ModelChoice& choice, const std::string& what, const std::string& type) {
  const auto names = names_of(specs_of<List>());
  if (std::ranges::find(names, type) == names.end()) throw InputError("", unknown_name(what, type, names));
  choice.type = type;
}

/// Every variable that can be a number for this material.
std::vector<std::string> numeric_variables(const MaterialDescription& material) {
  std::vector<std::string> names = direction_variables();
  const auto keys = parameter_keys(material);
  names.insert(names.end(), keys.begin(), keys.end());
  return names;
}

/// "coat.masking" as the term that it is of and what of it; without a dot, of the only term.
std::pair<TermDescription*, std::string> term_of(MaterialDescription& material, const std::string& variable) {
  const std::size_t dot = variable.find('.');
  if (!material.listed) return {&material.terms.front(), variable};
  std::string names;
  for (TermDescription& term : material.terms) {
    const std::string& name = term.name.empty() ? term.type : term.name;
    if (dot != std::string::npos && variable.substr(0, dot) == name) return {&term, variable.substr(dot + 1)};
    names += (names.empty() ? "" : ", ") + name;
  }
  throw InputError("", "found \"" + variable + "\"; accepted: TERM. before the name of what is set, of " + names);
}

Direction stretched(const Direction& d, double x, double y) { return normalized({d.x * x, d.y * y, d.z}); }

/// So many of direction_variables() are theta and phi of o, i and m.
constexpr std::ptrdiff_t angles = 6;

} // namespace

const std::vector<std::string>& direction_variables() {
  static const std::vector<std::string> names = {"theta_o",   "phi_o",     "theta_i", "phi_i",  "theta_m", "phi_m",
                                                 "theta_h",   "phi_h",     "theta_d", "phi_d",  "a",       "slope",
                                                 "stretch_x", "stretch_y", "shear_x", "shear_y"};
  return names;
}

void Configuration::set_model(const std::string& variable, const std::string& type) {
  if (variable == "channel") {
    const auto found = std::ranges::find(channel_names(), type);
    if (found == channel_names().end())
      throw InputError("", unknown_name(variable, type, channel_names()) +
                               "; all three are \"channel\": \"rgb\" of a figure, panel or series");
    channel_ = static_cast<Channel>(found - channel_names().begin());
    return;
  }
  if (variable == "strategy") {
    const std::vector<std::string> names = strategy_names();
    if (std::ranges::find(names, type) == names.end()) throw InputError("", unknown_name(variable, type, names));
    strategy_ = type;
    return;
  }
  const auto numbers = numeric_variables(material_);
  if (std::ranges::find(numbers, variable) != numbers.end()) {
    const bool follows =
        std::ranges::find(numbers.begin(), numbers.begin() + angles, variable) != numbers.begin() + angles;
    throw InputError("", "\"" + variable + "\" cannot be \"" + type + "\"; accepted: a number" +
                             (follows ? ", or another angle, as \"phi_o+180deg\"" : ""));
  }
  const auto [term, model] = term_of(material_, variable);
  if (model == "distribution") {
    set_type<Distribution>(term->distribution, variable, type);
  } else if (model == "masking") {
    term->masking.values = {};
    set_type<Masking>(term->masking, variable, type);
  } else if (model == "shadowing") {
    term->shadowing = ModelChoice{};
    set_type<Shadowing>(*term->shadowing, variable, type);
  } else if (model == "fresnel") {
    set_type<Fresnel>(term->fresnel, variable, type);
  } else {
    throw InputError("", unknown_name("variable", variable,
                                      {"distribution", "masking", "shadowing", "fresnel", "channel", "strategy"}));
  }
}

void Configuration::set_tie(const std::string& variable, const Tie& tie) {
  const std::vector<std::string> names(direction_variables().begin(), direction_variables().begin() + angles);
  const auto index = static_cast<std::size_t>(std::ranges::find(names, variable) - names.begin());
  if (index == names.size())
    throw InputError("", "\"" + variable + "\" cannot follow \"" + tie.to +
                             "\"; accepted: a number; theta and phi of o, i and m may follow each other");
  auto at = static_cast<std::size_t>(std::ranges::find(names, tie.to) - names.begin());
  if (at == names.size()) throw InputError("", unknown_name("angle", tie.to, names));
  while (at != index && tie_[at]) at = static_cast<std::size_t>(std::ranges::find(names, tie_[at]->to) - names.begin());
  if (at == index)
    throw InputError("", "\"" + variable + "\" follows itself by way of \"" + tie.to + "\"; accepted: another");
  angle_[index].reset();
  tie_[index] = tie;
}

void Configuration::set(const Setting& setting) {
  if (const auto* tie = std::get_if<Tie>(&setting.value)) return set_tie(setting.variable, *tie);
  if (const auto* text = std::get_if<std::string>(&setting.value)) return set_model(setting.variable, *text);
  const double value = std::get<double>(setting.value);
  const auto& names = direction_variables();
  const auto found = std::ranges::find(names, setting.variable);
  if (found == names.end()) {
    const auto accepted = numeric_variables(material_);
    if (std::ranges::find(accepted, setting.variable) == accepted.end())
      throw InputError("", unknown_name("variable", setting.variable, accepted));
    return set_parameter(material_, setting.variable, value);
  }
  const auto index = static_cast<std::size_t>(found - names.begin());
  if (index < 6) {
    angle_[index] = value;
    tie_[index].reset();
  } else if (index < 10) {
    half_[index - 6] = value;
  } else if (index == 10) {
    a_ = value;
  } else if (index == 11) {
    slope_ = value;
  } else if (index < 14) {
    if (!(value > 0)) throw InputError("", "found " + format_number(value) + ", accepted: a number > 0");
    stretch_[index - 12] = value;
  } else {
    shear_[index - 14] = value;
  }
}

std::optional<double> Configuration::angle(std::size_t which) const {
  if (!tie_.at(which)) return angle_[which];
  const auto& names = direction_variables();
  const Tie& tie = *tie_[which];
  const auto target = static_cast<std::size_t>(std::ranges::find(names, tie.to) - names.begin());
  std::optional<double> from = angle(target);
  if (!from && target % 2 == 1) from = 0; // a phi that is not set
  if (!from) return std::nullopt;
  return tie.sign * *from + tie.offset;
}

std::optional<double> Configuration::angle(const std::string& variable) const {
  const auto& names = direction_variables();
  return angle(static_cast<std::size_t>(std::ranges::find(names, variable) - names.begin()));
}

std::vector<Vec2> Configuration::mean_slopes() const {
  std::vector<Vec2> all;
  const auto add = [&](const Values& values) {
    const Vec2 mean = values.has("mean_slope") ? values.vec2("mean_slope") : Vec2{0, 0};
    if (std::ranges::find(all, mean) == all.end()) all.push_back(mean);
  };
  for (const TermDescription& term : material_.terms) {
    const Values& values = term.distribution.values;
    if (!values.has("components"))
      add(values);
    else
      for (const WeightedChoice& part : values.components("components")) add(part.model.values);
  }
  return all;
}

std::optional<Direction> Configuration::direction(std::size_t which) const {
  const auto theta = angle(2 * which), phi = angle(2 * which + 1);
  for (const std::size_t k : {2 * which, 2 * which + 1})
    if (tie_[k] && !angle(k))
      throw InputError("", "\"" + direction_variables()[k] + "\" follows \"" + tie_[k]->to + "\", which is not set");
  if (!theta) return std::nullopt;
  return from_angles(*theta, phi.value_or(0));
}

std::optional<ViewerAndLight> Configuration::pair() const {
  const auto first_of = [](const auto& is_set, std::size_t count, std::size_t from) {
    for (std::size_t k = 0; k < count; ++k)
      if (is_set(k)) return direction_variables()[from + k];
    return std::string();
  };
  const std::string half = first_of([&](std::size_t k) { return half_[k].has_value(); }, half_.size(), 6);
  if (half.empty()) return std::nullopt;
  const auto is_set = [&](std::size_t k) { return angle_[k] || tie_[k]; };
  const std::string other = a_ ? "a" : first_of(is_set, 4, 0);
  if (!other.empty())
    throw InputError("", "found \"" + half + "\" beside \"" + other +
                             "\"; accepted: the directions of viewer and light, or their half and difference angles");
  if (!half_[0] || !half_[2])
    throw InputError("", "found \"" + half + "\" without \"" + (half_[0] ? "theta_d" : "theta_h") +
                             "\"; accepted: theta_h and theta_d together");
  return pair_of({*half_[0], half_[1].value_or(0), *half_[2], half_[3].value_or(0)});
}

MaterialDescription Configuration::transformed(const Material& material) const {
  const Microsurface& surface = material.surface();
  MaterialDescription description = material_;
  TermDescription& term = description.terms[term_with_surface(description)];
  if (!std::visit([](const auto& d) { return d.shape_invariant; }, surface.distribution))
    throw InputError("", "stretching and shearing need a shape-invariant distribution, and \"" +
                             term.distribution.type + "\" is none");
  for (const TermDescription& other : description.terms)
    if (!other.of.empty())
      throw InputError("", "stretching and shearing do not reach the term within \"" + other.type +
                               "\"; accepted: the name of one beside it");
  const SlopeMap& map = surface.slopes();
  set_parameter(term, "alpha_x", map.alpha_x / stretch_[0]);
  set_parameter(term, "alpha_y", map.alpha_y / stretch_[1]);
  term.distribution.values.set("correlation", map.correlation);
  term.distribution.values.set("mean_slope",
                               Vec2{map.mean_x / stretch_[0] + shear_[0], map.mean_y / stretch_[1] + shear_[1]});
  return description;
}

Configuration::Surface Configuration::surface() const {
  Material material = build(material_);
  const SlopeMap before = a_ ? material.surface().slopes() : material.mesosurface();
  if (!is_transformed()) return {material_, std::move(material), before};
  MaterialDescription description = transformed(material);
  material = build(description);
  return {std::move(description), std::move(material), before};
}

Directions Configuration::directions(const Surface& surface) const {
  Directions out{direction(0), direction(1), direction(2)};
  if (const auto both = pair()) {
    out.o = both->o;
    out.i = both->i;
  }
  if (a_) {
    const double phi = angle(1).value_or(0);
    const double alpha_o = surface.before.project(from_angles(std::acos(0.0), phi)).s;
    out.o = from_angles(std::atan2(1.0, *a_ * alpha_o), phi);
  }
  if (slope_) out.m = from_angles(std::atan(*slope_), angle(5).value_or(0));
  if (!is_transformed()) return out;
  for (auto* direction : {&out.o, &out.i}) {
    if (!*direction) continue;
    const Direction d = stretched(**direction, stretch_[0], stretch_[1]);
    *direction = normalized({d.x, d.y, d.z + shear_[0] * d.x + shear_[1] * d.y});
  }
  if (out.m) {
    const Direction d = stretched(*out.m, 1 / stretch_[0], 1 / stretch_[1]);
    out.m = normalized({d.x - shear_[0] * d.z, d.y - shear_[1] * d.z, d.z});
  }
  return out;
}

Configuration::Ready Configuration::ready() const {
  Surface made = surface();
  const Directions at = directions(made);
  return {std::move(made.description), std::move(made.material), at.o, at.i, at.m, channel_};
}

} // namespace brdfplot::plot
