#include "choice/stress/material_problems.hpp"

#include "analysis/integrals.hpp"
#include "base/errors.hpp"
#include "brdf/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

namespace brdfplot::choice {

namespace {

using SharedMaterial = std::shared_ptr<const Material>;

/// The largest angle whose cosine is not 0 or below.
constexpr double at_horizon = std::numbers::pi / 2;
constexpr double not_a_value = std::numeric_limits<double>::quiet_NaN();

/// Unit vectors of two arrays of angles.
struct VectorArrays {
  std::vector<double> x, y, z;
  VectorArrays(std::size_t n, const double* theta, const double* phi) {
    for (std::size_t k = 0; k < n; ++k) {
      const Direction d = from_angles(theta[k], phi[k]);
      x.push_back(d.x);
      y.push_back(d.y);
      z.push_back(d.z);
    }
  }
  Columns columns() const { return {x.data(), y.data(), z.data()}; }
};

/// What of a material, and of which directions.
struct Of {
  Quantity quantity;
  std::string term{};
  std::size_t channel = 0;
};

void evaluate_rows(const Material& material, const Of& of, std::size_t n, const double* const* in, double* out) {
  const Needs& needs = info_of(of.quantity).needs;
  const bool of_normal = needs.m && !needs.o;
  const VectorArrays first(n, in[0], in[1]);
  Batch batch{.n = n, .o = {}, .i = {}, .m = {}};
  (of_normal ? batch.m : batch.o) = first.columns();
  if (!needs.i) {
    evaluate(material, of.quantity, batch, out, of.term);
    return;
  }
  const VectorArrays second(n, in[2], in[3]);
  batch.i = second.columns();
  std::vector<double> all(n * static_cast<std::size_t>(channels_of(material, of.quantity, of.term)));
  evaluate(material, of.quantity, batch, all.data(), of.term);
  std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(of.channel * n), n, out);
}

/// All rows at once, or one by one where one of them is refused.
Run<double> quantity_run(const SharedMaterial& material, const Of& of) {
  return [material, of](std::size_t n, const double* const* in, double* out) {
    try {
      evaluate_rows(*material, of, n, in, out);
    } catch (const InputError&) {
      if (n == 1) {
        *out = not_a_value;
        return;
      }
      for (std::size_t k = 0; k < n; ++k) {
        const double* const row[] = {in[0] + k, in[1] + k, in[2] + k, in[3] + k};
        quantity_run(material, of)(1, row, out + k);
      }
    }
  };
}

/// The largest of the channels.
double largest_albedo(const Material& material, const Direction& o) {
  try {
    const ColourEstimate all = compute_channels(Integral::albedo, material, o, 1e-6);
    return *std::max_element(all.value.begin(), all.value.begin() + material.channels());
  } catch (const InputError&) {
    return not_a_value;
  }
}

/// Two angles, or four.
std::vector<Input> angles(const std::vector<std::string>& letters) {
  std::vector<Input> inputs;
  for (const auto& letter : letters) {
    inputs.push_back({"theta_" + letter, "polar angle, rad", 0, at_horizon});
    inputs.push_back({"phi_" + letter, "azimuth, rad", 0, 2 * std::numbers::pi});
  }
  return inputs;
}

Problem quantity_problem(const SharedMaterial& material, const Of& of, const std::string& name) {
  const QuantityInfo& info = info_of(of.quantity);
  Problem p{.name = material->name,
            .doc = info.doc,
            .source = "the material",
            .inputs = angles(info.needs.i   ? std::vector<std::string>{"o", "i"}
                             : info.needs.o ? std::vector<std::string>{"o"}
                                            : std::vector<std::string>{"m"}),
            .least = 0};
  p.methods.push_back({.name = name, .doc = info.doc, .source = "the material", .run = quantity_run(material, of)});
  return p;
}

/// Two arrays stand for the four that a problem of one direction has not.
Problem of_one_direction(Problem p) {
  Method& method = p.methods.front();
  method.run =
      Run<double>([run = std::get<Run<double>>(method.run)](std::size_t n, const double* const* in, double* out) {
        const double* const four[] = {in[0], in[1], in[0], in[1]};
        run(n, four, out);
      });
  return p;
}

void add_surface_problems(const SharedMaterial& material, const WeightedTerm& term, const std::string& prefix,
                          std::vector<Problem>& all) {
  const Microsurface& surface = *term.surface();
  const bool own_masking = std::holds_alternative<CustomMasking>(surface.masking);
  const bool own_distribution = std::holds_alternative<Custom>(surface.distribution);
  if (surface.has_lambda()) {
    all.push_back(of_one_direction(quantity_problem(material, {Quantity::lambda, term.name}, prefix + "lambda")));
    all.back().seen = [](double lambda) { return 1 / (1 + lambda); };
    all.back().smooth = own_masking;
    all.push_back(of_one_direction(quantity_problem(material, {Quantity::g1, term.name}, prefix + "g1")));
    all.back().most = 1;
    if (material->mesosurface().centred()) all.back().monotone = {-1, 0};
  }
  all.push_back(of_one_direction(quantity_problem(material, {Quantity::d, term.name}, prefix + "d")));
  all.back().smooth = own_distribution;
  all.push_back(quantity_problem(material, {Quantity::g2, term.name}, prefix + "g2"));
  all.back().most = 1;
  all.back().reciprocal = true;
}

void add_brdf_problems(const SharedMaterial& material, std::vector<Problem>& all) {
  const auto channels = static_cast<std::size_t>(channels_of(*material, Quantity::brdf));
  for (std::size_t c = 0; c < channels; ++c) {
    const std::string suffix = channels > 1 ? std::string("_") + "rgb"[c] : "";
    all.push_back(quantity_problem(material, {Quantity::brdf, "", c}, "brdf" + suffix));
    all.back().reciprocal = true;
    all.push_back(quantity_problem(material, {Quantity::brdf_cos, "", c}, "brdf_cos" + suffix));
  }
}

Problem albedo_problem(const SharedMaterial& material) {
  Problem p{.name = material->name,
            .doc = "the albedo",
            .source = "the material",
            .inputs = angles({"o"}),
            .least = 0,
            .albedo = true,
            .samples = 40};
  const bool isotropic = std::ranges::all_of(material->terms, &WeightedTerm::is_isotropic);
  if (isotropic) p.inputs.pop_back();
  p.methods.push_back({.name = "albedo",
                       .doc = "int rho cos theta_i di",
                       .source = "the material",
                       .kind = Kind::quadrature,
                       .run = Run<double>([material, isotropic](std::size_t n, const double* const* in, double* out) {
                         for (std::size_t k = 0; k < n; ++k)
                           out[k] = largest_albedo(*material, from_angles(in[0][k], isotropic ? 0 : in[1][k]));
                       })});
  return p;
}

} // namespace

std::vector<Problem> material_problems(const MaterialDescription& description) {
  const auto material = std::make_shared<const Material>(build(description));
  std::vector<Problem> all;
  const auto surfaces =
      std::ranges::count_if(material->terms, [](const auto& term) { return term.surface() != nullptr; });
  for (const WeightedTerm& term : material->terms)
    if (term.surface() != nullptr) add_surface_problems(material, term, surfaces > 1 ? term.name + "." : "", all);
  add_brdf_problems(material, all);
  all.push_back(albedo_problem(material));
  return all;
}

} // namespace brdfplot::choice
