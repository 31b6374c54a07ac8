#include "figure/compare_figures.hpp"

#include "choice/compare/compare.hpp"
#include "figure/series/channel.hpp"

#include "base/errors.hpp"

#include <cmath>
#include <numbers>

namespace brdfplot::plot {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// The channel to draw: none of a grey material.
std::vector<Setting> settings_of(const MaterialDescription& material) {
  try {
    require_channel(material, build(material), std::nullopt, "brdf_cos");
    return {};
  } catch (const InputError&) {
    return {{"channel", std::string("luminance")}};
  }
}

Expression lobe_of(const MaterialDescription& material, std::vector<Setting> at) {
  for (Setting& setting : settings_of(material)) at.push_back(std::move(setting));
  Expression out;
  out.term = {"brdf_cos", material, std::move(at), {}};
  return out;
}

Axis angle_axis(const std::string& label, const std::string& column, double from, double to) {
  Axis axis;
  axis.label = label;
  axis.column = column;
  axis.unit = Unit::degrees;
  axis.from = from * degree;
  axis.to = to * degree;
  return axis;
}

Axis value_axis() {
  Axis axis;
  axis.label = "ρ cos θ_i (1/sr)";
  axis.column = "value";
  return axis;
}

FigureDescription figure_of(const std::string& id, Kind kind, const std::string& title, const std::string& caption) {
  FigureDescription out;
  out.id = id;
  out.kind = kind;
  out.title = title;
  out.caption = caption;
  return out;
}

FigureDescription lobes(const std::vector<MaterialDescription>& materials) {
  FigureDescription out =
      figure_of("lobes", Kind::polar, "Lobes in the plane of incidence",
                "ρ cos θ_i of each material for four angles of the viewer; of what is coloured the luminance.");
  out.columns = 2;
  for (const double theta : {20.0, 45.0, 70.0, 85.0}) {
    PanelDescription panel;
    panel.title = "θ_o = " + std::to_string(std::lround(theta)) + "°";
    panel.x = angle_axis("θ_i", "theta_i", -90, 90);
    panel.y = value_axis();
    panel.arrows = {{"ω_o", theta * degree, false}, {"mirror", -theta * degree, false}};
    for (const MaterialDescription& material : materials)
      panel.series.push_back({material.name, lobe_of(material, {{"theta_o", theta * degree}}), std::nullopt});
    out.panels.push_back(std::move(panel));
  }
  return out;
}

FigureDescription differences(const std::vector<MaterialDescription>& materials) {
  FigureDescription out =
      figure_of("difference", Kind::heatmap, "Difference in the plane of incidence",
                "ρ cos θ_i of each material minus that of " + materials[0].name +
                    " over the angles of viewer and light in one plane; θ_i < 0 is opposite to the viewer.");
  out.columns = 2;
  for (std::size_t k = 1; k < materials.size(); ++k) {
    PanelDescription panel;
    panel.title = materials[k].name;
    panel.x = angle_axis("θ_i", "theta_i", -89, 89);
    panel.y = angle_axis("θ_o", "theta_o", 0, 89);
    panel.value = value_axis();
    Expression difference;
    difference.operation = Expression::Operation::difference;
    difference.operands = {lobe_of(materials[k], {}), lobe_of(materials[0], {})};
    panel.series.push_back({"", std::move(difference), std::nullopt});
    out.panels.push_back(std::move(panel));
  }
  return out;
}

FigureDescription spheres(const std::vector<MaterialDescription>& materials) {
  FigureDescription out =
      figure_of("spheres", Kind::spheres, "Lit spheres",
                "The spheres of which ΔE_ITP is told: a key light 45° from the viewer, a rim light at 140° and a "
                "fill light at 70°, with discs of 3°.");
  out.columns = static_cast<int>(std::min<std::size_t>(materials.size(), 3));
  for (const MaterialDescription& material : materials) {
    PanelDescription panel;
    panel.title = material.name;
    panel.x.column = "position";
    panel.y.column = "radiance";
    panel.sphere = SphereDescription{material};
    for (const choice::AdviceLight& light : choice::comparison_lights()) {
      Light one;
      one.type = Light::Type::sphere;
      one.theta = light.theta;
      one.phi = light.phi;
      one.radius = light.radius;
      // Of a disc of even radiance the irradiance across its direction is that times pi sin^2 of the radius.
      const double area = std::numbers::pi * std::sin(light.radius) * std::sin(light.radius);
      one.colour = light.irradiance;
      for (double& channel : one.colour.value) channel /= area;
      panel.sphere->lights.push_back(one);
    }
    out.panels.push_back(std::move(panel));
  }
  return out;
}

} // namespace

std::vector<FigureDescription> compare_figures(const std::vector<MaterialDescription>& materials) {
  return {lobes(materials), differences(materials), spheres(materials)};
}

} // namespace brdfplot::plot
