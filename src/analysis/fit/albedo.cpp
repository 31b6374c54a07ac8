#include "analysis/fit/albedo.hpp"

#include "analysis/fit/dialect.hpp"
#include "analysis/fit/minimax/maximin.hpp"
#include "base/errors.hpp"
#include "base/threads/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace brdfplot {

namespace {

constexpr double integral_tolerance = 1e-7;
/// What no nearer to the horizon changes by more than the integrals' own errors.
constexpr double least_cosine = 1e-6;
constexpr std::size_t most_in_x = 12, most_in_y = 6;

struct Place {
  double cosine, alpha, albedo;
};

/// x^i u^(d - i) for i = 0 ... d.
template <class Real>
std::vector<Real> mixed_powers(std::size_t degree, Real x, Real u) {
  std::vector<Real> powers(degree + 1, Real(1));
  Real of_x = 1, of_u = 1;
  for (std::size_t i = 0; i <= degree; ++i) {
    powers[i] *= of_x;
    powers[degree - i] *= of_u;
    of_x *= x;
    of_u *= u;
  }
  return powers;
}

template <class Real>
struct FormPowers {
  std::vector<Real> of_x, of_y;

  FormPowers(const AlbedoForm& form, Real cos_theta, Real alpha) {
    const Real c = std::max(cos_theta, Real(0));
    const Real k = form.by_alpha ? std::min(std::max(alpha, Real(form.from)), Real(form.to)) : Real(form.k);
    const Real q = Real(1) / (c + k);
    of_x = mixed_powers(form.dx, c * q, k * q);
    const Real scale = Real(1 / (form.to - form.from));
    of_y = form.by_alpha ? mixed_powers(form.dy, (k - Real(form.from)) * scale, (Real(form.to) - k) * scale)
                         : std::vector<Real>{1};
  }
};

/// Places denser towards the horizon, the normal and small alpha, both rims among them.
std::vector<Place> places_of(const AlbedoForm& form, std::size_t cosines, std::size_t alphas) {
  std::vector<Place> places;
  for (std::size_t j = 0; j < (form.by_alpha ? alphas : 1); ++j) {
    const double s = static_cast<double>(j) / static_cast<double>(alphas - 1);
    const double alpha = form.by_alpha ? form.from + (form.to - form.from) * s * s : form.k;
    for (std::size_t i = 0; i < cosines; ++i) {
      // In turns even in the cosine, and in sqrt(x) from 0 to that of 1 / (1 + alpha).
      const double t = static_cast<double>(i) / static_cast<double>(cosines - 1), x = t * t / (1 + alpha);
      places.push_back({std::min(i % 2 == 0 ? t : alpha * x / (1 - x), 1.0), alpha, 0});
    }
    places.back().cosine = 1;
  }
  return places;
}

class Albedo {
public:
  Albedo(const MaterialDescription& description, const AlbedoFitOptions& options, bool by_alpha)
      : description_(description), options_(options), by_alpha_(by_alpha) {}

  void fill(std::vector<Place>& places) const {
    parallel_for(places.size(), options_.threads, [&](std::size_t n) {
      MaterialDescription at = description_;
      if (by_alpha_) set_parameter(at, "alpha", places[n].alpha);
      const double c = std::max(places[n].cosine, least_cosine);
      places[n].albedo =
          compute_or_throw(options_.quantity, build(at), {std::sqrt((1 - c) * (1 + c)), 0, c}, integral_tolerance);
    });
  }

private:
  const MaterialDescription& description_;
  const AlbedoFitOptions& options_;
  bool by_alpha_;
};

/// Whether there are coefficients within the tolerance at all places: `form` gets them.
bool fit_within(AlbedoForm& form, const std::vector<Place>& places, double tolerance) {
  const std::size_t half = (form.dx + 1) * (form.dy + 1);
  std::vector<double> weight(half); // of Bernstein's polynomials, which have one size
  for (std::size_t j = 0; j <= form.dy; ++j)
    for (std::size_t i = 0; i <= form.dx; ++i)
      weight[j * (form.dx + 1) + i] = binomial(form.dx, i) * binomial(form.dy, j);
  Rows rows{2 * half};
  std::vector<double> basis(half);
  for (const Place& place : places) {
    const FormPowers<double> powers(form, place.cosine, place.alpha);
    for (std::size_t j = 0; j <= form.dy; ++j)
      for (std::size_t i = 0; i <= form.dx; ++i) {
        const std::size_t k = j * (form.dx + 1) + i;
        basis[k] = weight[k] * powers.of_x[i] * powers.of_y[j];
      }
    for (const double sign : {1.0, -1.0}) {
      for (const double b : basis) rows.values.push_back((tolerance + sign * (1 - place.albedo)) * b);
      for (const double b : basis) rows.values.push_back((tolerance - sign * place.albedo) * b);
    }
  }
  for (std::size_t k = 0; k < 2 * half; ++k) {
    rows.values.resize(rows.values.size() + 2 * half, 0.0);
    rows.values[rows.values.size() - 2 * half + k] = 1;
  }
  const Maximin found = maximin(rows);
  if (!(found.value > 0)) return false;
  const double largest = *std::ranges::max_element(found.v);
  form.n.resize(half);
  form.m.resize(half);
  for (std::size_t k = 0; k < half; ++k) {
    form.n[k] = static_cast<float>(weight[k] * found.v[k] / largest);
    form.m[k] = static_cast<float>(weight[k] * found.v[half + k] / largest);
  }
  return true;
}

/// The first square form within the tolerance, then with its degrees lowered as far as that stays so, then as near as
/// it gets; none: false.
bool cheapest(AlbedoForm& form, const std::vector<Place>& places, double tolerance) {
  const auto with = [&](std::size_t dx, std::size_t dy) {
    AlbedoForm out = form;
    out.dx = dx;
    out.dy = form.by_alpha ? dy : 0;
    return out;
  };
  std::optional<AlbedoForm> best;
  for (std::size_t degree = 1; degree <= most_in_x && !best; ++degree) {
    AlbedoForm square = with(degree, std::min(degree, most_in_y));
    if (fit_within(square, places, tolerance)) best = square;
  }
  if (!best) return false;
  for (bool lower = true; lower;) {
    lower = false;
    for (const bool in_y : {false, true}) {
      if ((in_y ? best->dy : best->dx) == 0) continue;
      AlbedoForm next = with(best->dx - (in_y ? 0 : 1), best->dy - (in_y ? 1 : 0));
      if (!fit_within(next, places, tolerance)) continue;
      best = next;
      lower = true;
      break;
    }
  }
  for (double closer = 0.85 * tolerance; fit_within(*best, places, closer); closer *= 0.85) {
  }
  form = *best;
  return true;
}

/// What the largest form comes within, of the doubles of a tolerance.
double reached(AlbedoForm form, const std::vector<Place>& places, double tolerance) {
  form.dx = most_in_x;
  form.dy = form.by_alpha ? most_in_y : 0;
  while (tolerance < 1 && !fit_within(form, places, tolerance)) tolerance *= 2;
  return tolerance;
}

void measure(AlbedoFit& fit, const std::vector<Place>& places) {
  fit.places = places.size();
  fit.in_double = fit.in_float = 0;
  for (const Place& place : places) {
    const double error = std::fabs(fit.form.value(place.cosine, place.alpha) - place.albedo);
    // In float the direction is what it is rounded to, within half a unit of the cosine's last place.
    const float in_float = fit.form.value(static_cast<float>(place.cosine), static_cast<float>(place.alpha));
    fit.in_float = std::max(fit.in_float, std::fabs(static_cast<double>(in_float) - place.albedo));
    if (error > fit.in_double) fit.in_double = error, fit.cosine = place.cosine, fit.alpha = place.alpha;
  }
}

std::string two_digits(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2g", value * 1.05); // upwards, as a bound
  return text;
}

std::string name_of(Integral quantity) { return quantity == Integral::furnace ? "furnace" : "albedo"; }

/// "x * x", "u3 * x": x^i u^(degree - i) of names whose powers from 2 on are variables.
std::string product_text(const std::string& x, std::size_t i, const std::string& u, std::size_t rest,
                         const std::string& one) {
  const auto power = [](const std::string& name, std::size_t k) { return k > 1 ? name + std::to_string(k) : name; };
  if (i == 0 && rest == 0) return one;
  if (i == 0) return power(u, rest);
  return rest == 0 ? power(x, i) : power(x, i) + " * " + power(u, rest);
}

class AlbedoWriter : private FitDialect {
public:
  AlbedoWriter(const AlbedoFit& fit, FitLanguage language) : FitDialect(language), form_(fit.form) {
    const std::string name = fit_identifier(fit.material) + "_" + name_of(fit.quantity);
    if (cpp()) line("template <class Real>");
    line((cpp() ? "inline " : "") + real() + " " + name + "(" + real() + " cos_theta" +
         (form_.by_alpha ? ", " + real() + " alpha) {" : ") {"));
    line(local("c") + max("cos_theta", number(0)) + ";");
    line(local("k") + (form_.by_alpha ? min(max("alpha", number(form_.from)), number(form_.to)) : number(form_.k)) +
         ";");
    line(local("q") + number(1) + " / (c + k);");
    line(local("x") + "c * q;");
    line(local("u") + "k * q;");
    powers("x", form_.dx);
    powers("u", form_.dx);
    if (form_.by_alpha && form_.dy > 0) {
      const std::string scale = number(1 / (form_.to - form_.from));
      line(local("y") + "(k - " + number(form_.from) + ") * " + scale + ";");
      line(local("v") + "(" + number(form_.to) + " - k) * " + scale + ";");
      powers("y", form_.dy);
      powers("v", form_.dy);
      for (std::size_t j = 0; j <= form_.dy; ++j)
        line(local("b" + std::to_string(j)) + product_text("y", j, "v", form_.dy - j, number(1)) + ";");
    }
    sum("n", form_.n);
    sum("m", form_.m);
    line("  return " + min("n / (n + m)", number(1)) + ";");
    line("}");
  }
  const std::string& text() const { return out_; }

private:
  void line(const std::string& text) { out_ += text + "\n"; }

  void powers(const std::string& name, std::size_t degree) {
    for (std::size_t k = 2; k <= degree; ++k)
      line(local(name + std::to_string(k)) + name + (k > 2 ? std::to_string(k - 1) : "") + " * " + name + ";");
  }

  void sum(const std::string& name, const std::vector<float>& coefficients) {
    std::string text;
    for (std::size_t i = 0; i <= form_.dx; ++i) {
      std::string of_y;
      for (std::size_t j = 0; j <= form_.dy; ++j)
        of_y += (j > 0 ? " + " : "") + literal(shortest_digits(coefficients[j * (form_.dx + 1) + i], true)) +
                (form_.dy > 0 ? " * b" + std::to_string(j) : "");
      const std::string of_x = product_text("x", i, "u", form_.dx - i, number(1));
      text += (i > 0 ? "\n    + " : "") + of_x + " * " + (form_.dy > 0 ? "(" + of_y + ")" : of_y);
    }
    line(local(name) + text + ";");
  }

  const AlbedoForm& form_;
  std::string out_;
};

} // namespace

template <class Real>
Real AlbedoForm::value(Real cos_theta, Real alpha) const {
  const FormPowers<Real> powers(*this, cos_theta, alpha);
  Real sum_n = 0, sum_m = 0;
  for (std::size_t i = 0; i <= dx; ++i) {
    Real of_n = 0, of_m = 0;
    for (std::size_t j = 0; j <= dy; ++j) {
      of_n += static_cast<Real>(n[j * (dx + 1) + i]) * powers.of_y[j];
      of_m += static_cast<Real>(m[j * (dx + 1) + i]) * powers.of_y[j];
    }
    sum_n += powers.of_x[i] * of_n;
    sum_m += powers.of_x[i] * of_m;
  }
  return std::min(sum_n / (sum_n + sum_m), Real(1));
}
template double AlbedoForm::value(double, double) const;
template float AlbedoForm::value(float, float) const;

AlbedoFit fit_albedo(const MaterialDescription& material, const AlbedoFitOptions& options) {
  const Material built = build(material);
  const auto info = std::ranges::find(integrals(), options.quantity, &IntegralInfo::integral);
  require(built, *info);
  if (info->coloured && built.channels() > 1)
    throw InputError("--quantity", "found \"albedo\" of " + material.name +
                                       ", which has three channels; accepted: a grey one, or \"furnace\"");
  if (!std::ranges::all_of(built.terms, &WeightedTerm::is_isotropic))
    throw InputError("--quantity", material.name + " is anisotropic: its albedo is no function of the cosine");

  AlbedoFit fit{.material = material.name, .quantity = options.quantity, .form = {}, .asked = options.tolerance};
  const std::vector<std::string> keys = parameter_keys(material);
  fit.form.by_alpha = !options.fixed && std::ranges::find(keys, "alpha") != keys.end();
  if (!fit.form.by_alpha) fit.form.k = 0.25;
  const Albedo albedo(material, options, fit.form.by_alpha);
  const bool two = fit.form.by_alpha;
  std::vector<Place> places = places_of(fit.form, two ? 49 : 121, 17),
                     between = places_of(fit.form, two ? 115 : 601, 41);
  albedo.fill(places);
  albedo.fill(between);
  const auto brightest = std::ranges::max_element(between, {}, &Place::albedo);
  if (brightest->albedo > 1 + options.tolerance)
    throw InputError("--quantity", material.name + " reflects " + two_digits(brightest->albedo / 1.05) +
                                       " of the light, more than 1, at cos(theta) = " +
                                       two_digits(brightest->cosine / 1.05) + "; no fit within [0, 1] is near that");
  fit.of_integrals = integral_tolerance;
  const double left = options.tolerance - integral_tolerance;
  for (const double share : {0.95, 0.88, 0.8, 0.7, 0.6, 0.4}) {
    if (!cheapest(fit.form, places, share * left)) break;
    measure(fit, between);
    if (std::max(fit.in_double, fit.in_float) <= left) return fit;
  }
  throw AccuracyError("", "no rational fit of the " + name_of(options.quantity) + " up to degree " +
                              std::to_string(most_in_x) + " is within " + format_number(options.tolerance) +
                              "; one is within " + two_digits(reached(fit.form, places, options.tolerance)));
}

std::vector<std::string> describe(const AlbedoFit& fit) {
  const AlbedoForm& form = fit.form;
  const std::size_t coefficients = form.n.size() + form.m.size();
  std::vector<std::string> lines = {
      name_of(fit.quantity) + " of " + fit.material +
          (fit.quantity == Integral::furnace ? ", which is what it reflects of a white surround with F = 1"
                                             : ", what it reflects of a white surround"),
      "E = N / (N + M), sums of n_ij x^i u^(" + std::to_string(form.dx) + "-i)" +
          (form.by_alpha ? " y^j v^(" + std::to_string(form.dy) + "-j)" : "") +
          ", x = cos(theta) / (cos(theta) + k), u = 1 - x, k = " +
          (form.by_alpha ? "alpha, y = alpha from " + format_number(form.from) + " to " + format_number(form.to) +
                               " as 0 to 1, v = 1 - y"
                         : format_number(form.k)),
      "domain: cos(theta) in [0, 1]" + (form.by_alpha ? ", alpha in [" + format_number(form.from) + ", " +
                                                            format_number(form.to) + "]; beyond, as at its ends"
                                                      : std::string()),
      "asked: within " + format_number(fit.asked),
      "off by at most " + two_digits(fit.in_double + fit.of_integrals) + " in double and " +
          two_digits(fit.in_float + fit.of_integrals) + " in float, as measured at " + std::to_string(fit.places) +
          " places that are not those of the fit, most at cos(theta) = " + two_digits(fit.cosine / 1.05) +
          (form.by_alpha ? ", alpha = " + two_digits(fit.alpha / 1.05) : std::string()),
      "proved: E in [0, 1], rounding included, since no coefficient and no power is negative; no pole",
      "cost: " + std::to_string(coefficients) + " coefficients, 2 divisions"};
  return lines;
}

std::string fit_code(const AlbedoFit& fit, FitLanguage language) {
  std::string out;
  for (const std::string& line : describe(fit)) out += "// " + line + "\n";
  out += "// Made by brdfplot.\n";
  if (language == FitLanguage::cpp) out += "#pragma once\n\n#include <algorithm>\n";
  return out + "\n" + AlbedoWriter(fit, language).text();
}

} // namespace brdfplot
