#include "choice/methods/fitted.hpp"

#include "analysis/fit/fit.hpp"
#include "base/number.hpp"
#include "choice/methods/add.hpp"

#include <memory>

namespace brdfplot::choice {

namespace {

/// What the code of a fit computes: the projected area c = a at a projected roughness of 1.
struct FittedLambda {
  std::shared_ptr<const FitCode> code;

  template <class T>
  T operator()(const std::array<T, 1>& a) const {
    using std::max;
    const FitTerms<T> terms = code_terms(*code, a[0], T(code->scale), T(0.0));
    return terms.n / max(terms.d, T(1e-30));
  }
};

MaterialDescription material_of(const std::string& distribution) {
  TermDescription term;
  term.name = distribution;
  term.distribution.type = distribution;
  term.distribution.values.set("alpha", 1.0);
  return term;
}

} // namespace

void add_lambda_fits(Problem& problem, const std::string& distribution, const std::vector<double>& tolerances) {
  for (const double tolerance : tolerances) {
    const FitResult result = fit_lambda(material_of(distribution), {.tolerance = tolerance, .fixed = false});
    const std::string bound = format_number(tolerance);
    add_formula<1>(problem, "fit_" + bound, "a rational within " + bound + " of G1", "brdfplot fit", Kind::fit,
                   FittedLambda{std::make_shared<const FitCode>(result.code)}, {{{1.0}}});
  }
}

} // namespace brdfplot::choice
