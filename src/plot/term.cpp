#include "plot/term.hpp"

#include "math/interrupt.hpp"
#include "math/number.hpp"
#include "microfacet/registry.hpp"

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

template <class List>
void append_parameters(std::vector<std::string>& names, const ModelChoice& choice) {
  for (const ModelSpec& spec : specs_of<List>()) {
    if (spec.type != choice.type) continue;
    for (const auto& parameter : spec.parameters)
      if (parameter.kind == ParameterKind::number || parameter.kind == ParameterKind::number_or_rgb)
        names.push_back(parameter.key);
  }
}

/// Every variable that can be a number for this material.
std::vector<std::string> numeric_variables(const MaterialDescription& material) {
  std::vector<std::string> names = direction_variables();
  append_parameters<Distribution>(names, material.distribution);
  append_parameters<Masking>(names, material.masking);
  if (material.shadowing) append_parameters<Shadowing>(names, *material.shadowing);
  append_parameters<Fresnel>(names, material.fresnel);
  return names;
}

Direction stretched(const Direction& d, double x, double y) { return normalized({d.x * x, d.y * y, d.z}); }

/// The names under which a term's quantity may go.
std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (const auto& info : quantities()) names.push_back(info.name);
  for (const auto& info : integrals()) names.push_back(info.name);
  return names;
}

} // namespace

const std::vector<std::string>& direction_variables() {
  static const std::vector<std::string> names = {"theta_o", "phi_o", "theta_i",   "phi_i",     "theta_m", "phi_m",
                                                 "a",       "slope", "stretch_x", "stretch_y", "shear_x", "shear_y"};
  return names;
}

bool depends_on(const std::string& quantity, const std::string& variable) {
  const bool of_m = variable == "theta_m" || variable == "phi_m" || variable == "slope";
  const bool of_i = variable == "theta_i" || variable == "phi_i";
  const bool of_o_alone =
      quantity == "lambda" || std::ranges::find(integrals(), quantity, &IntegralInfo::name) != integrals().end();
  if (of_o_alone) return !of_m && !of_i;
  return !of_m || (quantity != "brdf" && quantity != "brdf_cos");
}

void Configuration::set_model(const std::string& variable, const std::string& type) {
  if (variable == "distribution") {
    set_type<Distribution>(material_.distribution, variable, type);
  } else if (variable == "masking") {
    material_.masking.values = {};
    set_type<Masking>(material_.masking, variable, type);
  } else if (variable == "shadowing") {
    material_.shadowing = ModelChoice{};
    set_type<Shadowing>(*material_.shadowing, variable, type);
  } else if (variable == "fresnel") {
    set_type<Fresnel>(material_.fresnel, variable, type);
  } else {
    const auto numbers = numeric_variables(material_);
    if (std::ranges::find(numbers, variable) != numbers.end())
      throw InputError("", "\"" + variable + "\" cannot be \"" + type + "\"; accepted: a number");
    throw InputError("", unknown_name("variable", variable, {"distribution", "masking", "shadowing", "fresnel"}));
  }
}

void Configuration::set(const Setting& setting) {
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
  } else if (index == 6) {
    a_ = value;
  } else if (index == 7) {
    slope_ = value;
  } else if (index < 10) {
    if (!(value > 0)) throw InputError("", "found " + format_number(value) + ", accepted: a number > 0");
    stretch_[index - 8] = value;
  } else {
    shear_[index - 10] = value;
  }
}

std::optional<double> Configuration::angle(const std::string& variable) const {
  const auto& names = direction_variables();
  return angle_.at(static_cast<std::size_t>(std::ranges::find(names, variable) - names.begin()));
}

Vec2 Configuration::mean_slope() const {
  const Values& values = material_.distribution.values;
  return values.has("mean_slope") ? values.vec2("mean_slope") : Vec2{0, 0};
}

std::optional<Direction> Configuration::direction(std::size_t which) const {
  const auto& theta = angle_[2 * which];
  const auto& phi = angle_[2 * which + 1];
  if (!theta) return std::nullopt;
  return from_angles(*theta, phi.value_or(0));
}

void Configuration::transform(MaterialDescription& material, std::optional<Direction>& o, std::optional<Direction>& i,
                              std::optional<Direction>& m) const {
  const Material before = build(material);
  if (!std::visit([](const auto& d) { return d.shape_invariant; }, before.distribution))
    throw InputError("", "stretching and shearing need a shape-invariant distribution, and \"" +
                             material.distribution.type + "\" is none");
  const SlopeMap& map = before.slopes();
  Values values;
  values.set("alpha_x", map.alpha_x / stretch_[0]);
  values.set("alpha_y", map.alpha_y / stretch_[1]);
  values.set("correlation", map.correlation);
  values.set("mean_slope", Vec2{map.mean_x / stretch_[0] + shear_[0], map.mean_y / stretch_[1] + shear_[1]});
  material.distribution.values = values;
  for (auto* direction : {&o, &i}) {
    if (!*direction) continue;
    const Direction d = stretched(**direction, stretch_[0], stretch_[1]);
    *direction = normalized({d.x, d.y, d.z + shear_[0] * d.x + shear_[1] * d.y});
  }
  if (m) {
    const Direction d = stretched(*m, 1 / stretch_[0], 1 / stretch_[1]);
    *m = normalized({d.x - shear_[0] * d.z, d.y - shear_[1] * d.z, d.z});
  }
}

Configuration::Ready Configuration::ready() const {
  auto o = direction(0), i = direction(1), m = direction(2);
  MaterialDescription material = material_;
  if (a_) {
    const double phi = angle_[1].value_or(0);
    const double alpha_o = build(material).slopes().project(from_angles(std::acos(0.0), phi)).s;
    o = from_angles(std::atan2(1.0, *a_ * alpha_o), phi);
  }
  if (slope_) m = from_angles(std::atan(*slope_), angle_[5].value_or(0));
  if (stretch_ != Vec2{1, 1} || shear_ != Vec2{0, 0}) transform(material, o, i, m);
  Material built = build(material);
  return {std::move(material), std::move(built), o, i, m};
}

SweptConfiguration::SweptConfiguration(const Term& term, std::vector<std::string> swept)
    : fixed_(term.material), swept_(std::move(swept)) {
  for (const auto& setting : term.at) fixed_.set(setting);
  for (const auto& variable : swept_)
    is_fixed_.push_back(std::ranges::find(term.at, variable, &Setting::variable) != term.at.end());
}

Configuration::Ready SweptConfiguration::at(const std::vector<double>& values) const {
  Configuration configuration = fixed_;
  for (std::size_t k = 0; k < swept_.size(); ++k)
    if (!is_fixed_[k]) configuration.set({swept_[k], values[k]});
  return configuration.ready();
}

TermFunction::TermFunction(const Term& term, std::vector<std::string> swept, double tolerance)
    : configuration_(term, std::move(swept)), tolerance_(tolerance) {
  for (const auto& info : quantities())
    if (info.name == term.quantity) quantity_ = info.quantity;
  for (const auto& info : integrals())
    if (info.name == term.quantity) integral_ = info.integral;
  if (!quantity_ && !integral_) throw InputError("", unknown_name("quantity", term.quantity, quantity_names()));
}

void TermFunction::require_directions(const Configuration::Ready& ready) const {
  if (integral_ && !ready.o) throw InputError("", "this quantity needs theta_o");
  if (quantity_)
    require(ready.material, quantities()[static_cast<std::size_t>(*quantity_)], ready.o.has_value(),
            ready.i.has_value(), ready.m.has_value());
}

void TermFunction::check(const std::vector<double>& values) const { require_directions(configuration_.at(values)); }

double TermFunction::operator()(const std::vector<double>& values) const {
  throw_if_interrupted();
  const auto ready = configuration_.at(values);
  require_directions(ready);
  if (integral_) return compute_or_throw(*integral_, ready.material, *ready.o, tolerance_);
  const double value = evaluate(ready.material, *quantity_, ready.o.value_or(Direction{0, 0, 1}), ready.i, ready.m);
  if (is_told(*quantity_, value)) return value;
  throw AccuracyError("", "\"" + quantities()[static_cast<std::size_t>(*quantity_)].name + "\": found " +
                              format_number(value) + ", accepted: a finite number");
}

} // namespace brdfplot::plot
