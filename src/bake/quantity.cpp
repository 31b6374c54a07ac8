#include "bake/quantity.hpp"

#include "analysis/integrals.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/threads/interrupt.hpp"
#include "brdf/integrals/albedo_table.hpp"
#include "models/parameters.hpp"
#include "sampling/direct_lobe.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot::bake {

namespace {

/// The nearest to the horizon that integrals are taken: where a node is at or beyond it, its value is that of a viewer
/// so far above it, from which it differs by no more than the integrals' own errors.
constexpr double least_cosine = 1e-6;

constexpr const char* angles[] = {"cos_theta_o", "theta_o", "phi_o"};

bool is_angle(const std::string& variable) { return std::ranges::find(angles, variable) != std::end(angles); }

bool is_inverse(const std::string& quantity) { return quantity.starts_with("inverse_"); }

bool is_mean(const std::string& quantity) { return quantity == "mean_albedo" || quantity == "mean_furnace"; }

/// The integral of which a table or a mean is made.
Integral integral_of(const std::string& quantity) {
  return quantity == "furnace" || quantity == "mean_furnace" ? Integral::furnace
         : quantity == "mean_fresnel"                        ? Integral::mean_fresnel
                                                             : Integral::albedo;
}

const IntegralInfo& info_of(Integral integral) {
  return *std::ranges::find(integrals(), integral, &IntegralInfo::integral);
}

std::vector<std::string> channel_names(const Material& material, const std::string& quantity) {
  if (quantity == "dfg") return {"scale", "bias"};
  if (is_inverse(quantity)) return {"cosine"};
  if (material.channels() == 1 || !info_of(integral_of(quantity)).coloured) return {quantity};
  return {quantity + "_r", quantity + "_g", quantity + "_b"};
}

/// The microsurface with Schlick's factor (1 - o.h)^5 for F, as `furnace` has it with 1.
Material schlick_factor(MaterialDescription description) {
  description.terms.front().weight = 1.0;
  description.terms.front().fresnel = {.type = "schlick", .values = {}};
  description.terms.front().fresnel.values.set("f0", 0.0);
  return build(description);
}

bool is_isotropic(const Material& material) {
  return std::ranges::all_of(material.terms, [](const WeightedTerm& term) { return term.is_isotropic(); });
}

/// The distribution of the normals of an inverse cumulative table. \throws InputError where there is none, or their
/// azimuth counts too
const Distribution& isotropic_normals(const Material& material) {
  const WeightedTerm& term = material.terms.front();
  const Distribution* const facets = term.facets();
  if (material.terms.size() != 1 || facets == nullptr || !term.is_isotropic() || components(*facets).size() != 1)
    throw InputError("-q", "found \"inverse_normals\" of " + material.name +
                               ", accepted: a material of one term that has an isotropic distribution, no mixture");
  return *facets;
}

/// The matte part of an inverse cumulative table. \throws InputError where there is none
const Complement& matte_part(const Material& material) {
  const Complement* found = nullptr;
  for (const WeightedTerm& term : material.terms) {
    const auto* const complement = std::get_if<Complement>(&term.term);
    if (complement == nullptr) continue;
    if (found != nullptr || !complement->isotropic()) {
      found = nullptr;
      break;
    }
    found = complement;
  }
  if (found == nullptr)
    throw InputError("-q", "found \"inverse_complement\" of " + material.name +
                               ", accepted: a material that has one isotropic term \"complement\"");
  return *found;
}

/// The cosine beyond which, towards the horizon, a share u lies.
double inverse_cosine(const std::string& quantity, const Material& material, double u) {
  const SamplePoint nearest_to_horizon{1 - 0x1p-53, 0, 0};
  if (quantity == "inverse_normals")
    return Facets(isotropic_normals(material)).normal({std::min(1 - u, nearest_to_horizon[0]), 0, 0}).z;
  return matte_lobe(matte_part(material).of)->sample({0, 0, 1}, {u, 0, 0}).z;
}

std::vector<std::string> accepted_variables(const MaterialDescription& material, const std::string& quantity) {
  std::vector<std::string> names;
  if (is_inverse(quantity))
    names.emplace_back(share_axis);
  else if (!is_mean(quantity))
    names.assign(std::begin(angles), std::end(angles));
  for (const std::string& key : parameter_keys(material)) names.push_back(key);
  return names;
}

std::vector<double> values_of(const Rgb& rgb, std::size_t channels) {
  return {rgb.begin(), rgb.begin() + static_cast<std::ptrdiff_t>(channels)};
}

} // namespace

const std::vector<BakedInfo>& baked_quantities() {
  static const std::vector<BakedInfo> all = {
      {"albedo", "E, the directional albedo, of each channel"},
      {"mean_albedo", "the mean of E over viewers, weighted by the cosine, of each channel"},
      {"furnace", "E with F = 1: R_sF1 of the light of further bounces (RTR4, Eq. 9.56)"},
      {"mean_furnace", "the mean of that, weighted by the cosine"},
      {"dfg", "scale and bias of E = f0 scale + bias with Schlick's F (Karis 2013; Lazarov 2013)"},
      {"mean_fresnel", "F averaged over the visible normals (Heitz 2014, Eq. 105)"},
      {"inverse_normals", "cos theta_m by the share u of D cos theta_m that lies beyond it: normals for sampling"},
      {"inverse_complement", "cos theta_i by the share u of the matte part that lies beyond it (Kelemen 2001, sec. 4)"},
  };
  return all;
}

Baked::Baked(MaterialDescription material, std::string quantity, const std::vector<Axis>& axes, double tolerance)
    : material_(std::move(material)), quantity_(std::move(quantity)), tolerance_(tolerance) {
  std::vector<std::string> names;
  for (const BakedInfo& info : baked_quantities()) names.push_back(info.name);
  if (std::ranges::find(names, quantity_) == names.end())
    throw InputError("-q", unknown_name("quantity", quantity_, names));
  const Material built = build(material_);
  if (quantity_ == "dfg" && (built.terms.size() != 1 || built.terms.front().fresnel() == nullptr))
    throw InputError("-q",
                     "found \"dfg\" of " + material_.name + ", accepted: a material of one term that has a fresnel");
  if (quantity_ == "dfg") require(built, info_of(Integral::furnace));
  if (quantity_ == "inverse_normals")
    isotropic_normals(built);
  else if (quantity_ == "inverse_complement")
    matte_part(built);
  else
    require(built, info_of(integral_of(quantity_)));
  const std::vector<std::string> accepted = accepted_variables(material_, quantity_);
  for (const Axis& axis : axes) {
    if (std::ranges::find(accepted, axis.variable) == accepted.end())
      throw InputError("--over", unknown_name("variable", axis.variable, accepted));
    if (std::ranges::find(variables_, axis.variable) != variables_.end())
      throw InputError("--over", "\"" + axis.variable + "\" is given twice");
    variables_.push_back(axis.variable);
  }
  const auto has = [&](const char* name) { return std::ranges::find(variables_, name) != variables_.end(); };
  if (has("theta_o") && has("cos_theta_o"))
    throw InputError("--over", "found \"theta_o\" beside \"cos_theta_o\", accepted: one of them");
  if (is_inverse(quantity_) && !has(share_axis)) throw InputError("--over", "\"" + quantity_ + "\" needs an axis u");
  const bool of_viewer = !is_mean(quantity_) && !is_inverse(quantity_);
  if (of_viewer && !has("theta_o") && !has("cos_theta_o"))
    throw InputError("--over", "\"" + quantity_ + "\" needs an axis cos_theta_o or theta_o");
  if (of_viewer && !has("phi_o") && !is_isotropic(built))
    throw InputError("--over", material_.name + " is anisotropic: its table needs an axis phi_o");
  channels_ = channel_names(built, quantity_);
}

MaterialDescription Baked::configured(const std::vector<double>& values) const {
  MaterialDescription description = material_;
  for (std::size_t k = 0; k < variables_.size(); ++k)
    if (!is_angle(variables_[k]) && variables_[k] != share_axis) set_parameter(description, variables_[k], values[k]);
  return description;
}

Direction Baked::viewer(const std::vector<double>& values) const {
  double cosine = 1, phi = 0;
  for (std::size_t k = 0; k < variables_.size(); ++k) {
    if (variables_[k] == "cos_theta_o") cosine = values[k];
    if (variables_[k] == "theta_o") cosine = std::cos(values[k]);
    if (variables_[k] == "phi_o") phi = values[k];
  }
  cosine = std::clamp(cosine, least_cosine, 1.0);
  const double sine = std::sqrt((1 - cosine) * (1 + cosine));
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

std::vector<double> Baked::at(const std::vector<double>& values) const {
  throw_if_interrupted();
  const MaterialDescription description = configured(values);
  const Material material = build(description);
  if (is_inverse(quantity_)) {
    const auto at = static_cast<std::size_t>(std::ranges::find(variables_, share_axis) - variables_.begin());
    if (!(values[at] >= 0 && values[at] <= 1))
      throw InputError("--over", "found u = " + format_number(values[at]) + ", accepted: 0 to 1");
    return {inverse_cosine(quantity_, material, values[at])};
  }
  const Integral integral = integral_of(quantity_);
  const std::size_t count = channels_.size();
  if (is_mean(quantity_)) {
    const auto albedo = [&](const Direction& omega) {
      return compute_channels(integral, material, omega, tolerance_ / 100); // noise would look like a kink
    };
    const AlbedoTable table(count, is_isotropic(material), albedo, tolerance_ / 2);
    if (!(table.error() <= tolerance_))
      throw AccuracyError(material.name, "the mean albedo does not reach the tolerance");
    std::vector<double> means;
    for (std::size_t c = 0; c < count; ++c) means.push_back(table.mean(c));
    return means;
  }
  const Direction omega_o = viewer(values);
  if (quantity_ != "dfg") return values_of(compute_channels_or_throw(integral, material, omega_o, tolerance_), count);
  const double all = compute_or_throw(Integral::furnace, material, omega_o, tolerance_ / 2);
  const double bias = compute_or_throw(Integral::albedo, schlick_factor(description), omega_o, tolerance_ / 2);
  return {all - bias, bias};
}

} // namespace brdfplot::bake
