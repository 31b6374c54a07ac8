/// What `evaluate` makes of the kernels: P22, D, visible normals, G1, every form of G2, and the BRDFs that have no
/// kernel of their own.
#include "accuracy/directions.hpp"
#include "brdf/evaluate.hpp"

#include <doctest/doctest.h>

namespace {

using namespace brdfplot;
using namespace brdfplot::accuracy;
using reference::G2Form;
using reference::Model;

using ExactStretch = reference::Stretch<Quad>;
using ExactVector = reference::Vector<Quad>;

struct Form {
  const char* name;
  G2Form form;
  const char* factor; ///< of the direction, or nothing
  bool has_kernel;    ///< of the whole BRDF
};
constexpr std::array<Form, 8> forms = {
    {{"none", G2Form::none, "", true},
     {"separable", G2Form::separable, "", true},
     {"minimum", G2Form::minimum, "", true},
     {"height_correlated", G2Form::height_correlated, "", true},
     {"direction_correlated; ginneken", G2Form::direction_correlated, "ginneken", false},
     {"direction_correlated; ashikhmin", G2Form::direction_correlated, "ashikhmin", false},
     {"height_direction_correlated; ginneken", G2Form::height_direction_correlated, "ginneken", false},
     {"height_direction_correlated; ashikhmin", G2Form::height_direction_correlated, "ashikhmin", false}}};

bool is_ashikhmin(const Form& form) { return form.factor[0] == 'a'; }

std::string type_of(const Form& form) {
  const std::string name = form.name;
  return name.substr(0, name.find(';'));
}

Material material_of(Model model, const kernels::Stretch& k, const Form& form) {
  TermDescription description;
  description.distribution.type = model == Model::beckmann ? "beckmann" : "ggx";
  description.distribution.values.set("alpha_x", k.alpha_x);
  description.distribution.values.set("alpha_y", k.alpha_y);
  description.distribution.values.set("correlation", k.correlation);
  description.distribution.values.set("mean_slope", Vec2{k.mean_x, k.mean_y});
  ModelChoice shadowing{.type = type_of(form), .values = {}};
  if (*form.factor != 0) shadowing.values.set("lambda", std::string(form.factor));
  description.shadowing = shadowing;
  return build(description);
}

Quad factor_of(const Form& form, const ExactVector& o, const ExactVector& i) {
  if (*form.factor == 0) return 0;
  const Quad phi = reference::azimuth_difference(o, i);
  return form.factor[0] == 'g' ? reference::direction_factor_ginneken(phi) : reference::direction_factor_ashikhmin(phi);
}

/// The exponent of Bound at a vector of any length.
double exponent(const ExactStretch& k, const ExactVector& m) {
  if (!(m.z > 0)) return 0;
  const Quad e = reference::slope_norm2(k, Quad(-m.x / m.z), Quad(-m.y / m.z));
  return e > 1e6 ? 1e6 : static_cast<double>(e);
}

/// Whether the projected area of the mesosurface is more than the rounding of the direction.
bool is_clear(const ExactStretch& k, const ExactVector& omega) {
  return abs(reference::mesosurface_area(k, omega)) > Quad(0x1p-51);
}

/// The directions of a case, in arrays; those of the normals are the other case's viewers.
struct Inputs {
  Arrays<double> o, i;
  std::size_t n;

  explicit Inputs(const Case<double>& in) : n(in.pairs.size()) {
    for (const auto& pair : in.pairs) {
      o.push_back(pair.o);
      i.push_back(pair.i);
    }
  }
  static Columns columns(const Arrays<double>& v) { return {v.x.data(), v.y.data(), v.z.data()}; }
};

/// The rows of one model, domain and instruction set.
struct Rows {
  Row p22, d_visible, g1;
  std::vector<Row> g2, brdf;

  Rows(const std::string& model, bool is_beckmann, const std::string& isa, const std::string& domain)
      : p22("P22 (" + model + ")", "double", isa, domain, is_beckmann ? bounds::p22_beckmann : bounds::p22_ggx),
        d_visible("D_o (" + model + ")", "double", isa, domain,
                  is_beckmann ? bounds::d_visible_beckmann : bounds::d_visible_ggx),
        g1("G1 (" + model + "; directions)", "double", isa, domain, bounds::g1_of_directions) {
    for (const Form& form : forms) {
      g2.emplace_back("G2 (" + model + "; " + form.name + ")", "double", isa, domain,
                      is_ashikhmin(form) ? bounds::g2_ashikhmin : bounds::g2);
      brdf.emplace_back("BRDF (" + model + "; " + form.name + ")", "double", isa, domain,
                        is_beckmann          ? bounds::brdf_beckmann
                        : is_ashikhmin(form) ? bounds::brdf_ggx_ashikhmin
                                             : bounds::brdf_ggx);
    }
  }
  void finish_all() const {
    for (const Row* row : {&p22, &d_visible, &g1}) finish(*row);
    for (const Row& row : g2) finish(row);
    for (std::size_t f = 0; f < forms.size(); ++f)
      if (!forms[f].has_kernel) finish(brdf[f]);
  }
};

/// Exact values of one pair; those of a model with every form.
struct Exact {
  bool clear_o, clear_both;
  Quad p22, d_visible, g1;
  std::array<Quad, forms.size()> g2, brdf;
  double exponent_m, exponent_h, exponent_phi;
};

Exact exact_of(Model model, const ExactStretch& k, const accuracy::Pair<double>& pair) {
  const ExactVector o = exact(pair.o), i = exact(pair.i);
  const ExactVector h{o.x + i.x, o.y + i.y, o.z + i.z};
  Exact e{};
  e.clear_o = is_clear(k, o);
  e.clear_both = e.clear_o && is_clear(k, i);
  e.exponent_m = exponent(k, i);
  e.exponent_h = exponent(k, h);
  const auto phi = static_cast<double>(reference::azimuth_difference(o, i));
  e.exponent_phi = 7.3 * phi * phi;
  e.p22 = i.z > 0 ? reference::p22(model, k, Quad(-i.x / i.z), Quad(-i.y / i.z)) : Quad(0);
  e.d_visible = reference::d_visible(model, k, o, i);
  const bool seen = reference::dot(o, i) > 0 && i.z > 0;
  e.g1 = seen ? reference::g1(model, k, o) : Quad(0);
  const bool lit = reference::mesosurface_area(k, o) > 0 && reference::mesosurface_area(k, i) > 0 && h.z > 0;
  if (!lit) return e;
  const Quad lambda_o = reference::lambda(model, k, o), lambda_i = reference::lambda(model, k, i);
  for (std::size_t f = 0; f < forms.size(); ++f) {
    const Quad factor = factor_of(forms[f], o, i);
    e.g2[f] = reference::g2(forms[f].form, lambda_o, lambda_i, factor);
    if (!forms[f].has_kernel) e.brdf[f] = reference::brdf(model, forms[f].form, k, o, i, factor);
  }
  return e;
}

void add_case(Rows& rows, Model model, const Case<double>& in, const Exact* exact_values) {
  const Inputs inputs(in);
  const std::size_t n = inputs.n;
  const Columns o = Inputs::columns(inputs.o), i = Inputs::columns(inputs.i);
  std::vector<double> out(n);
  const auto add = [&](Row& row, const auto& value_of, const auto& exponent_of, const auto& counts) {
    for (std::size_t k = 0; k < n; ++k)
      if (counts(exact_values[k]))
        row.add(
            ulp_error(out[k], value_of(exact_values[k])), [&] { return text(in, in.pairs[k]); },
            exponent_of(exact_values[k]));
  };
  const auto always = [](const Exact&) { return true; };
  const auto clear_o = [](const Exact& e) { return e.clear_o; };
  const auto clear_both = [](const Exact& e) { return e.clear_both; };
  const auto none = [](const Exact&) { return 0.0; };
  const auto of_m = [](const Exact& e) { return e.exponent_m; };
  const auto of_phi = [](const Exact& e) { return e.exponent_phi; };
  const Material plain = material_of(model, in.stretch, forms[0]);
  // The pair's second direction is the normal here.
  evaluate(plain, Quantity::p22, {n, {}, {}, i}, out.data());
  add(
      rows.p22, [](const Exact& e) { return e.p22; }, of_m, always);
  evaluate(plain, Quantity::d_visible, {n, o, {}, i}, out.data());
  add(
      rows.d_visible, [](const Exact& e) { return e.d_visible; }, of_m, clear_o);
  evaluate(plain, Quantity::g1, {n, o, {}, i}, out.data());
  add(
      rows.g1, [](const Exact& e) { return e.g1; }, none, clear_o);
  for (std::size_t f = 0; f < forms.size(); ++f) {
    const Material material = material_of(model, in.stretch, forms[f]);
    evaluate(material, Quantity::g2, {n, o, i, {}}, out.data());
    add(
        rows.g2[f], [f](const Exact& e) { return e.g2[f]; }, of_phi, clear_both);
    if (forms[f].has_kernel) continue;
    evaluate(material, Quantity::brdf, {n, o, i, {}}, out.data());
    const bool gauss = model == Model::beckmann, ashikhmin = is_ashikhmin(forms[f]);
    const auto of_both = [=](const Exact& e) { return (gauss ? e.exponent_h : 0) + (ashikhmin ? e.exponent_phi : 0); };
    add(
        rows.brdf[f], [f](const Exact& e) { return e.brdf[f]; }, of_both, clear_both);
  }
}

void check_domain(Model model, const std::string& domain) {
  const auto cases = draw_cases<double>(domain, inputs_per_row());
  std::vector<std::vector<Exact>> exact_values;
  for (const auto& in : cases) {
    auto& list = exact_values.emplace_back();
    for (const auto& pair : in.pairs) list.push_back(exact_of(model, in.exact_stretch(), pair));
  }
  const bool is_beckmann = model == Model::beckmann;
  for_each_isa([&](const std::string& isa) {
    Rows rows(is_beckmann ? "Beckmann" : "GGX", is_beckmann, isa, domain);
    for (std::size_t k = 0; k < cases.size(); ++k) add_case(rows, model, cases[k], exact_values[k].data());
    rows.finish_all();
  });
}

} // namespace

TEST_CASE("accuracy: evaluation, Beckmann") {
  for (const char* domain : direction_domains) check_domain(Model::beckmann, domain);
}

TEST_CASE("accuracy: evaluation, GGX") {
  for (const char* domain : direction_domains) check_domain(Model::ggx, domain);
}
