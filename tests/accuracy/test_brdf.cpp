/// Projection, distributions of normals and BRDFs: the kernels, over stretches and pairs of directions.
#include "accuracy/directions.hpp"

#include <doctest/doctest.h>

namespace {

using namespace brdfplot;
using namespace brdfplot::accuracy;
using reference::G2Form;
using reference::Model;

constexpr std::array<const char*, 2> model_names = {"Beckmann", "GGX"};
constexpr std::array<const char*, 4> form_names = {"none", "separable", "minimum", "height_correlated"};

/// The exponent of Bound at a vector of any length.
double exponent(const reference::Stretch<Quad>& k, const reference::Vector<Quad>& m) {
  if (!(m.z > 0)) return 0;
  const Quad e = reference::slope_norm2(k, Quad(-m.x / m.z), Quad(-m.y / m.z));
  return e > 1e6 ? 1e6 : static_cast<double>(e);
}

/// The exact results of one pair.
struct Exact {
  Quad c, s;
  std::array<Quad, 2> d;
  std::array<std::array<Quad, 4>, 2> brdf;
  double exponent_d, exponent_brdf;
};

template <class T>
Exact exact_of(const reference::Stretch<Quad>& k, const accuracy::Pair<T>& pair) {
  const auto o = exact(pair.o), i = exact(pair.i);
  const reference::Vector<Quad> h{o.x + i.x, o.y + i.y, o.z + i.z};
  Exact e;
  e.c = reference::mesosurface_area(k, o);
  e.s = reference::projected_roughness(k, o);
  e.exponent_d = exponent(k, o);
  e.exponent_brdf = exponent(k, h);
  const Quad c_i = reference::mesosurface_area(k, i);
  const bool lit = e.c > 0 && c_i > 0 && h.z > 0;
  const Quad norm = lit ? Quad(sqrt(reference::dot(h, h))) : Quad(1);
  for (const Model model : {Model::beckmann, Model::ggx}) {
    const auto m = static_cast<std::size_t>(model);
    e.d[m] = reference::d(model, k, o);
    if (!lit) continue;
    // reference::brdf, with what the four forms share computed once.
    const Quad d = reference::d(model, k, {h.x / norm, h.y / norm, h.z / norm});
    const Quad lambda_o = reference::lambda(model, k, o), lambda_i = reference::lambda(model, k, i);
    for (const G2Form form : {G2Form::none, G2Form::separable, G2Form::minimum, G2Form::height_correlated})
      e.brdf[m][static_cast<std::size_t>(form)] =
          d * reference::g2(form, lambda_o, lambda_i, Quad(0)) / (4 * e.c * c_i);
  }
  return e;
}

template <class T>
struct Rows {
  Row c, s;
  std::vector<Row> d, brdf;

  Rows(const std::string& isa, const std::string& domain)
      : c("c", type_name<T>(), isa, domain, single() ? bounds::float_projected_area : bounds::projected_area),
        s("s", type_name<T>(), isa, domain,
          single() ? bounds::float_projected_roughness : bounds::projected_roughness) {
    for (std::size_t m = 0; m < 2; ++m) {
      const std::string model = model_names[m];
      d.emplace_back("D (" + model + ")", type_name<T>(), isa, domain,
                     single() ? bounds::float_d
                     : m == 0 ? bounds::d_beckmann
                              : bounds::d_ggx);
      for (const char* form : form_names)
        brdf.emplace_back("BRDF (" + model + "; " + form + ")", type_name<T>(), isa, domain,
                          single() ? bounds::float_brdf
                          : m == 0 ? bounds::brdf_beckmann
                                   : bounds::brdf_ggx);
    }
  }
  static constexpr bool single() { return sizeof(T) == sizeof(float); }
};

template <class T>
void add_case(Rows<T>& rows, const Case<T>& in, const Exact* exact) {
  Arrays<T> o, i;
  for (const auto& pair : in.pairs) {
    o.push_back(pair.o);
    i.push_back(pair.i);
  }
  const std::size_t n = in.pairs.size();
  std::vector<T> out(n), other(n);
  // Where c vanishes to within the rounding of the components it is that rounding.
  const double least_c = Rows<T>::single() ? 0x1p-22 : 0x1p-51;
  const auto add = [&](Row& row, const std::vector<T>& values, const auto& exact_value, const auto& exponent_of) {
    for (std::size_t k = 0; k < n; ++k)
      row.add(
          ulp_error(values[k], exact_value(exact[k])), [&] { return text(in, in.pairs[k]); }, exponent_of(exact[k]));
  };
  const auto no_exponent = [](const Exact&) { return 0.0; };
  kernels::project(in.stretch, o.view(), out.data(), other.data(), n);
  for (std::size_t k = 0; k < n; ++k)
    if (abs(exact[k].c) > least_c) rows.c.add(ulp_error(out[k], exact[k].c), [&] { return text(in, in.pairs[k]); });
  add(
      rows.s, other, [](const Exact& e) { return e.s; }, no_exponent);
  for (std::size_t m = 0; m < 2; ++m) {
    (m == 0 ? kernels::d_beckmann(in.stretch, o.view(), out.data(), n)
            : kernels::d_ggx(in.stretch, o.view(), out.data(), n));
    add(
        rows.d[m], out, [m](const Exact& e) { return e.d[m]; }, [](const Exact& e) { return e.exponent_d; });
    for (std::size_t form = 0; form < 4; ++form) {
      kernels::brdf(in.stretch, m == 0 ? kernels::Distribution::beckmann : kernels::Distribution::ggx,
                    static_cast<kernels::Shadowing>(form), o.view(), i.view(), out.data(), n);
      add(
          rows.brdf[4 * m + form], out, [=](const Exact& e) { return e.brdf[m][form]; },
          [](const Exact& e) { return e.exponent_brdf; });
    }
  }
}

template <class T>
void check_domain(const std::string& domain) {
  std::vector<Case<T>> cases = draw_cases<T>(domain, inputs_per_row());
  std::vector<std::vector<Exact>> exact;
  for (const auto& in : cases) {
    auto& list = exact.emplace_back();
    for (const auto& pair : in.pairs) list.push_back(exact_of(in.exact_stretch(), pair));
  }
  for_each_isa([&](const std::string& isa) {
    Rows<T> rows(isa, domain);
    for (std::size_t k = 0; k < cases.size(); ++k) add_case(rows, cases[k], exact[k].data());
    finish(rows.c);
    finish(rows.s);
    for (const Row& row : rows.d) finish(row);
    for (const Row& row : rows.brdf) finish(row);
  });
}

} // namespace

TEST_CASE("accuracy: projection, distributions and BRDFs, double") {
  for (const char* domain : direction_domains) check_domain<double>(domain);
}

TEST_CASE("accuracy: projection, distributions and BRDFs, float") {
  for (const char* domain : direction_domains) check_domain<float>(domain);
}
