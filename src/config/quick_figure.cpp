#include "config/quick_figure.hpp"

#include "analysis/integrals.hpp"
#include "base/echo.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/split.hpp"
#include "brdf/quantity.hpp"
#include "config/figure/labels.hpp"
#include "figure/series/channel.hpp"
#include "models/parameters.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace brdfplot::config {

namespace {

using Ordered = nlohmann::ordered_json;

/// How a quantity is drawn where nothing else is said.
struct Drawn {
  std::string quantity, label;
  std::vector<std::string> swept; ///< the first of these that is not fixed
  bool lobe = false;
  bool needs_theta_o = false;
};

const std::vector<Drawn>& drawn_quantities() {
  static const std::vector<Drawn> all = {
      {"lambda", "Λ", {"theta_o"}},
      {"p22", "P_{22}", {"theta_m"}},
      {"d", "D (1/sr)", {"theta_m"}},
      {"d_cos", "D cos θ_m (1/sr)", {"theta_m"}},
      {"g1", "G_1", {"theta_o", "theta_m"}},
      {"g2", "G_2", {"theta_i", "theta_o"}, false, true},
      {"d_visible", "D_{ωo} (1/sr)", {"theta_m", "theta_o"}, true, true},
      {"fresnel", "F", {"theta_d"}},
      {"brdf", "ρ (1/sr)", {"theta_i", "theta_o"}, true, true},
      {"brdf_cos", "ρ cos θ_i (1/sr)", {"theta_i", "theta_o"}, true, true},
  };
  return all;
}

Drawn drawn(const std::string& quantity) {
  const auto found = std::ranges::find(drawn_quantities(), quantity, &Drawn::quantity);
  if (found != drawn_quantities().end()) return *found;
  std::vector<std::string> names;
  for (const Drawn& one : drawn_quantities()) names.push_back(one.quantity);
  for (const IntegralInfo& integral : integrals()) {
    if (integral.name == quantity) return {quantity, quantity, {"theta_o"}};
    names.push_back(integral.name);
  }
  throw InputError("-q", unknown_name("quantity", quantity, names));
}

/// "ρ" of "ρ (1/sr)", for titles.
std::string without_unit(const std::string& label) { return label.substr(0, label.find(" (")); }

/// Where lobes and curves begin and end.
std::pair<std::string, std::string> range_of(const std::string& variable, bool lobe) {
  if (lobe) return {"-90deg", "90deg"};
  if (variable == "theta_o") return {"0deg", "89deg"};
  if (variable == "theta_d") return {"0deg", "90deg"};
  return {"-89deg", "89deg"};
}

/// A flag's "NAME=TEXT".
struct Assignment {
  std::string name, text;
};

Assignment assignment(const std::string& flag, const std::string& words, const std::string& accepted) {
  const auto sign = words.find('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == words.size())
    throw InputError(flag, "found \"" + echo(words) + "\"; accepted: " + accepted);
  return {words.substr(0, sign), words.substr(sign + 1)};
}

/// A number where it is one; "60deg" and names of types stay text.
Ordered value_of(const std::string& text) {
  const auto number = parse_number(text);
  return number ? Ordered(*number) : Ordered(text);
}

/// A material as series name it.
struct NamedMaterial {
  std::string name;
  Ordered json; ///< a reference or the material itself
  MaterialDescription description;
};

/// `name`, with a number where another has it already.
std::string unique_name(const std::string& name, const std::vector<NamedMaterial>& others) {
  std::string out = name;
  for (int k = 2; std::ranges::find(others, out, &NamedMaterial::name) != others.end(); ++k)
    out = name + " " + std::to_string(k);
  return out;
}

std::vector<NamedMaterial> materials_of(const QuickFigure& figure, const std::string& folder) {
  std::vector<NamedMaterial> out;
  for (const std::string& argument : figure.materials) {
    MaterialDescription description = material_of_argument(argument);
    const Ordered json = is_material_text(argument)
                             ? Ordered::parse(argument)
                             : Ordered{{"$ref", std::filesystem::proximate(argument, folder).generic_string()}};
    out.push_back({unique_name(description.name, out), json, std::move(description)});
  }
  if (out.empty()) throw InputError("plot", "a material is missing: MATERIAL.json or -m '{...}'");
  return out;
}

/// Makes the figure of a request.
class Maker {
public:
  Maker(const QuickFigure& request, const std::string& folder)
      : request_(request), materials_(materials_of(request, folder)) {
    for (const std::string& words : request.at) {
      const auto [name, text] = assignment("--at", words, "VARIABLE=VALUE");
      at_[name] = value_of(text);
      fixed_.push_back(name);
    }
    for (const std::string& words : request.over)
      fixed_.push_back(assignment("--over", words, "VARIABLE=VALUE,VALUE...").name);
    std::vector<std::string> channels = plot::channel_names();
    channels.emplace_back("rgb");
    if (!request.channel.empty() && std::ranges::find(channels, request.channel) == channels.end())
      throw InputError("--channel", unknown_name("channel", request.channel, channels));
    if (request.quantities.empty()) throw InputError("plot", "-q QUANTITY is missing");
    for (const std::string& quantity : request.quantities) drawn_.push_back(drawn(quantity));
    if (request.x.empty() && std::ranges::any_of(drawn_, &Drawn::needs_theta_o) && at_.contains("theta_o")) {
      viewer_ = at_["theta_o"];
      at_.erase("theta_o");
    }
  }

  Ordered figure() {
    Ordered out;
    std::string names;
    for (const NamedMaterial& material : materials_) names += (names.empty() ? "" : ", ") + material.name;
    out["id"] = id();
    out["kind"] = kind_of(drawn_.front());
    out["title"] = drawn_.size() == 1 ? without_unit(drawn_[0].label) + ": " + names : names;
    out["caption"] = "Drawn by brdfplot plot.";
    if (drawn_.size() > 1) out["columns"] = 2;
    for (const NamedMaterial& material : materials_) out["materials"][material.name] = material.json;
    if (!at_.empty()) out["at"] = at_;
    for (const Drawn& one : drawn_) out["panels"].push_back(panel(one));
    return out;
  }

private:
  std::string id() const {
    std::string out;
    for (const char c : materials_[0].name + "_" + drawn_[0].quantity)
      out += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' ? c : '_';
    return out;
  }

  bool is_lobe(const Drawn& one) const { return one.lobe && request_.x.empty(); }
  std::string kind_of(const Drawn& one) const { return is_lobe(one) ? "polar" : "lines"; }

  /// Whether `--at` or `--over` fixes it for a quantity.
  bool is_fixed(const std::string& variable, const Drawn& one) const {
    if (variable == "theta_o" && viewer_ && !one.needs_theta_o) return false;
    return std::ranges::find(fixed_, variable) != fixed_.end();
  }

  Ordered swept(const Drawn& one) const {
    if (!request_.x.empty()) {
      const auto [name, text] = assignment("--x", request_.x, "VARIABLE=FROM:TO");
      const auto ends = split(text, ':');
      if (ends.size() != 2) throw InputError("--x", "found \"" + echo(request_.x) + "\"; accepted: VARIABLE=FROM:TO");
      return axis(name, value_of(ends[0]), value_of(ends[1]));
    }
    const auto found = std::ranges::find_if(one.swept, [&](const std::string& name) { return !is_fixed(name, one); });
    if (found == one.swept.end())
      throw InputError("--at", "nothing is left to sweep for " + one.quantity + "; leave out " + one.swept.front() +
                                   ", or sweep something else by --x VARIABLE=FROM:TO");
    const auto [from, to] = range_of(*found, is_lobe(one));
    return axis(*found, from, to);
  }

  static Ordered axis(const std::string& variable, const Ordered& from, const Ordered& to) {
    const bool angle = variable.starts_with("theta_") || variable.starts_with("phi_");
    Ordered out = {{"variable", variable}, {"label", symbol(variable)}, {"from", from}, {"to", to}};
    if (angle) out["unit"] = "degrees";
    return out;
  }

  Ordered panel(const Drawn& one) const {
    Ordered out;
    if (drawn_.size() > 1) out["title"] = without_unit(one.label);
    if (kind_of(one) != kind_of(drawn_.front())) out["kind"] = kind_of(one);
    out["x"] = swept(one);
    out["y"] = {{"label", one.label}};
    const auto sweeps = out["x"]["variable"].get<std::string>();
    Ordered at;
    // An arrow stands for a direction of the panel: what is looked from is said there.
    if (one.needs_theta_o && viewer_)
      at["theta_o"] = *viewer_;
    else if (one.needs_theta_o && !is_fixed("theta_o", one) && sweeps != "theta_o")
      at["theta_o"] = "45deg";
    if (one.quantity == "fresnel" && !is_fixed("theta_h", one)) at["theta_h"] = 0;
    if (one.quantity == "g1" && sweeps != "theta_m" && !is_fixed("theta_m", one)) at["theta_m"] = 0;
    if (!at.empty()) out["at"] = at;
    if (is_lobe(one) && at.contains("theta_o"))
      out["arrows"] = one.quantity == "d_visible" ? Ordered{"omega_o"} : Ordered{"omega_o", "mirror"};
    for (const NamedMaterial& material : materials_)
      for (const auto& variant : variants()) out["series"].push_back(series(one, material, variant));
    return out;
  }

  /// The settings of `--vs`, without any first.
  std::vector<std::optional<Assignment>> variants() const {
    std::vector<std::optional<Assignment>> out = {std::nullopt};
    for (const std::string& words : request_.vs)
      out.emplace_back(assignment("--vs", words, "a file, or masking=TYPE, shadowing=TYPE, VARIABLE=VALUE"));
    return out;
  }

  Ordered series(const Drawn& one, const NamedMaterial& material, const std::optional<Assignment>& variant) const {
    Ordered out;
    std::vector<std::string> words;
    if (materials_.size() > 1) words.push_back(material.name);
    if (variant) words.push_back(symbol(variant->name) + " = " + variant->text);
    if (!variant && materials_.size() == 1 && !request_.vs.empty()) words.push_back(material.name);
    Ordered loops = Ordered::array();
    for (const std::string& over : request_.over) {
      const auto [name, text] = assignment("--over", over, "VARIABLE=VALUE,VALUE...");
      Ordered values = Ordered::array();
      for (const std::string& value : split(text, ',')) values.push_back(value_of(value));
      loops.push_back({{"variable", name}, {"values", values}});
      words.push_back(symbol(name) + " = {" + name + "}");
    }
    if (plot::channels_differ(material.description, build(material.description), one.quantity))
      out["channel"] = request_.channel.empty() ? "rgb" : request_.channel;
    std::string label;
    for (const std::string& word : words) label += (label.empty() ? "" : ", ") + word;
    if (!label.empty()) out["label"] = label;
    out["quantity"] = one.quantity;
    out["material"] = material.name;
    if (variant) out["at"] = {{variant->name, value_of(variant->text)}};
    if (!loops.empty()) out["for_each"] = loops.size() == 1 ? loops[0] : loops;
    return out;
  }

  const QuickFigure& request_;
  std::vector<NamedMaterial> materials_;
  Ordered at_ = Ordered::object(); ///< for every panel
  std::optional<Ordered> viewer_;  ///< theta_o of --at, where it is for the quantities that need one only
  std::vector<std::string> fixed_;
  std::vector<Drawn> drawn_;
};

} // namespace

std::string quick_figure(const QuickFigure& figure, const std::string& folder) {
  return Maker(figure, folder.empty() ? "." : folder).figure().dump(2) + "\n";
}

} // namespace brdfplot::config
