#include "figure/series/simulated.hpp"

#include "models/registry.hpp"
#include "simulation/simulate.hpp"
#include "simulation/surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot::plot {

namespace {

using simulation::MeasureDescription;
using simulation::SceneDescription;
using simulation::Table;

using std::numbers::pi;

/// What of the tables of measures is shown: type of the measure, column of the quantity.
struct Shown {
  const char* quantity;
  const char* measure;
};

constexpr Shown shown[] = {
    {"brdf_cos", "lobe"}, {"albedo", "bounces"}, {"g1", "g1"}, {"g2", "g2"}, {"direction_factor", "g2"},
};

const char* measure_of(const Term& term) {
  for (const auto& [quantity, measure] : shown)
    if (term.quantity == quantity) return measure;
  return "";
}

double theta_of(const Direction& d) { return std::atan2(std::hypot(d.x, d.y), d.z); }
bool at_normal(const Direction& d) { return d.x == 0 && d.y == 0; }
/// 0 at the normal, which has no azimuth.
double phi_of(const Direction& d) { return at_normal(d) ? 0 : std::atan2(d.y + 0.0, d.x); }

/// phi_i - phi_o, wrapped to [-pi, pi].
double azimuth_between(const Direction& o, const Direction& i) {
  if (at_normal(o)) return phi_of(i);
  if (at_normal(i)) return 0;
  return std::atan2(o.x * i.y - o.y * i.x + 0.0, o.x * i.x + o.y * i.y);
}

/// What the plane of incidence goes through beside the normal: omega_o, or the first omega_i where that is the normal.
const Direction& in_plane_of(const Points& points) {
  return at_normal(*points.front().o) ? *points.front().i : *points.front().o;
}

/// The angle of omega_i in that plane, signed as theta_i is when phi_i = phi_o.
double signed_theta(const Direction& plane, const Direction& i) {
  const double sign = plane.x * i.x + plane.y * i.y < 0 ? -1 : 1;
  return sign * theta_of(i);
}

template <class D>
constexpr bool is_simulated = requires {
  D::UnitShape::simulated_surface;
};

/// The type of surface of a material: that for which its masking is exact, else that of its distribution.
std::string surface_type_of(const Microsurface& surface) {
  return std::visit(
      []<class M, class D>(const M&, const D&) -> std::string {
        if constexpr (requires { M::exact_for_surface; })
          return M::exact_for_surface;
        else if constexpr (is_simulated<D>)
          return D::UnitShape::simulated_surface;
        else
          return {}; // refused by check()
      },
      surface.masking, surface.distribution);
}

bool has_parameter(const std::string& surface_type, const std::string& key) {
  const auto& specs = specs_of<simulation::Surface>();
  const auto spec = std::ranges::find(specs, surface_type, &ModelSpec::type);
  return spec != specs.end() && std::ranges::find(spec->parameters, key, &ParameterSpec::key) != spec->parameters.end();
}

/// The surface of a material. `cells` along each side where it is a mesh; the material's distribution of slopes where
/// the surface can have several.
ModelChoice surface_of(const Configuration::Ready& at, int cells) {
  const Microsurface& of = at.material.surface();
  const SlopeMap& slopes = of.slopes();
  ModelChoice surface{.type = surface_type_of(of), .values = {}};
  surface.values.set("alpha_x", slopes.alpha_x);
  surface.values.set("alpha_y", slopes.alpha_y);
  surface.values.set("correlation", slopes.correlation);
  surface.values.set("mean_slope", Vec2{slopes.mean_x, slopes.mean_y});
  if (has_parameter(surface.type, "slopes"))
    surface.values.set("slopes", std::visit([]<class D>(const D&) { return D::spec().type; }, of.distribution));
  if (has_parameter(surface.type, "samples")) surface.values.set("samples", static_cast<double>(cells));
  return surface;
}

/// Every realisation is one estimate, so that what surfaces differ in is in the standard error.
class SurfaceSource final : public SimulationSource {
public:
  std::string name() const override { return "surface"; }

  std::string doc() const override { return "rays on random surfaces (see brdfplot simulate)"; }

  std::vector<std::string> quantities() const override {
    std::vector<std::string> names;
    for (const Shown& one : shown) names.emplace_back(one.quantity);
    return names;
  }

  void check(const Term& term, const Configuration::Ready& at) const override {
    if (!at.o) throw InputError("", "this simulation needs theta_o");
    const bool pair = is_g2(term) || is_lobe(term);
    if (pair && !at.i) throw InputError("", "this simulation needs theta_i");
    if (is_lobe(term) && !in_plane(at)) throw InputError("", "this simulation needs omega_i in the plane of incidence");
    if (!std::visit([]<class D>(const D&) { return is_simulated<D>; }, at.material.surface().distribution))
      throw InputError("",
                       "surfaces are simulated for the distributions " +
                           types_that<Distribution>([]<class D>(std::type_identity<D>) { return is_simulated<D>; }));
    const WeightedTerm& only = at.material.terms.front();
    if (at.material.terms.size() > 1 || only.fresnel() == nullptr)
      throw InputError("", "surfaces are simulated with facets that are mirrors; found \"" +
                               at.description.terms.back().type + "\", accepted: one term, mirror");
    const bool all = std::visit(
        []<class F>(const F&) {
          return requires { F::reflects_all; };
        },
        *only.fresnel());
    if (!all || only.weight.value != Rgb{1, 1, 1})
      throw InputError("", "surfaces are simulated without a Fresnel term and without a weight");
    simulation::check(scene(term, {at}, 0));
  }

  std::string group(const Term& term, const Configuration::Ready& at) const override {
    std::string text = defining_text(at.description) + " " + at.description.terms.front().masking.type;
    if (!is_g1(term)) text += " from " + defining_text(*at.o);
    return text;
  }

  std::string key(const Term& term, const Points& points) const override {
    std::string text = "surface";
    for (int k = 0; k < term.simulate->realisations; ++k)
      text += "\n" + simulation::canonical_text(scene(term, points, k));
    return text;
  }

  simulation::Result run(const Term& term, const Points& points, int threads) const override {
    simulation::Result out;
    for (int k = 0; k < term.simulate->realisations; ++k) {
      const auto result = simulation::simulate(scene(term, points, k), {threads, {}, false});
      append(term, result.tables.at(0), points, out);
    }
    return out;
  }

  double work(const Term& term, const Points&) const override { return static_cast<double>(term.simulate->paths); }

  std::string output(const Term& term) const override {
    return is_g1(term) || is_g2(term) ? term.quantity : term.quantity + "/" + term.simulate->bounces;
  }

  bool is_binned(const Term& term) const override { return is_lobe(term); }

private:
  static bool is_lobe(const Term& term) { return term.quantity == "brdf_cos"; }
  static bool is_g1(const Term& term) { return term.quantity == "g1"; }
  static bool is_g2(const Term& term) { return std::string(measure_of(term)) == "g2"; }

  static bool in_plane(const Configuration::Ready& at) {
    if (at_normal(*at.o)) return true;
    const double azimuth = std::fabs(azimuth_between(*at.o, *at.i));
    return std::fmin(azimuth, pi - azimuth) < 1e-9 || std::hypot(at.i->x, at.i->y) < 1e-9;
  }

  static SceneDescription scene(const Term& term, const Points& points, int realisation) {
    MeasureDescription measure;
    measure.id = measure.type = measure_of(term);
    measure.rays = std::ceil(static_cast<double>(term.simulate->paths) / term.simulate->realisations);
    measure.phi_o = {phi_of(is_lobe(term) ? in_plane_of(points) : *points.front().o)};
    measure.theta_o.clear();
    for (const auto& point : points)
      if (is_g1(term) || measure.theta_o.empty()) measure.theta_o.push_back(theta_of(*point.o));
    if (is_lobe(term)) {
      measure.bins = term.simulate->samples;
      measure.half_width = term.simulate->half_width;
    }
    if (is_g2(term)) {
      measure.theta_i = {theta_of(*points.front().i)};
      for (const auto& point : points) measure.delta_phi.push_back(azimuth_between(*point.o, *point.i));
    }
    const auto seed = term.simulate->seed * 1000 + static_cast<std::uint64_t>(realisation);
    return {"", surface_of(points.front(), term.simulate->cells), seed, 1, {measure}};
  }

  /// Adds the estimate of one surface.
  static void append(const Term& term, const Table& table, const Points& points, simulation::Result& out) {
    const auto add = [&](const std::string& output, std::size_t count, const auto& value) {
      simulation::Estimates& estimates = out[output];
      estimates.points = count;
      for (std::size_t k = 0; k < count; ++k) estimates.values.push_back(value(k));
    };
    const auto cell = [&](std::size_t row, const char* column) { return table.rows.at(row).at(table.column(column)); };
    if (is_lobe(term)) {
      const auto row = [&](std::size_t k) { return bin_of(table, signed_theta(in_plane_of(points), *points[k].i)); };
      const auto single = [&](std::size_t k) { return cell(row(k), "brdf_cos"); };
      const auto multiple = [&](std::size_t k) { return cell(row(k), "multiple"); };
      add("brdf_cos/1", points.size(), single);
      add("brdf_cos/2+", points.size(), multiple);
      add("brdf_cos/all", points.size(), [&](std::size_t k) { return single(k) + multiple(k); });
    } else if (is_g2(term)) {
      add("g2", points.size(), [&](std::size_t k) { return cell(k, "g2"); });
      add("direction_factor", points.size(), [&](std::size_t k) { return cell(k, "lambda"); });
    } else if (is_g1(term)) {
      add("g1", points.size(), [&](std::size_t k) { return cell(k, "g1"); });
    } else {
      const auto energy = [&](std::size_t first, std::size_t last) {
        double sum = 0;
        for (std::size_t k = first; k <= std::min(last, table.rows.size() - 1); ++k) sum += cell(k, "energy");
        return sum;
      };
      add("albedo/1", 1, [&](std::size_t) { return energy(1, 1); });
      add("albedo/2", 1, [&](std::size_t) { return energy(2, 2); });
      add("albedo/3", 1, [&](std::size_t) { return energy(3, 3); });
      add("albedo/4", 1, [&](std::size_t) { return energy(4, 4); });
      add("albedo/2+", 1, [&](std::size_t) { return energy(2, 1000); });
      add("albedo/all", 1, [&](std::size_t) { return energy(1, 1000); });
    }
  }

  /// The row of the bin in which an angle is; the bins are even over [-pi/2, pi/2].
  static std::size_t bin_of(const Table& table, double theta) {
    const auto bins = static_cast<double>(table.rows.size());
    const double place = std::floor((theta / pi + 0.5) * bins);
    return static_cast<std::size_t>(std::fmin(std::fmax(place, 0), bins - 1));
  }
};

} // namespace

const SimulationSource& surface_source() {
  static const SurfaceSource source;
  return source;
}

} // namespace brdfplot::plot
