/// \file
/// A term of a figure as a function of what is swept.
#pragma once

#include "analysis/integrals.hpp"
#include "analysis/weight_moments.hpp"
#include "figure/series/configuration.hpp"

#include <optional>
#include <string>
#include <vector>

namespace brdfplot::plot {

/// "coat.g1" is the quantity g1 of the term coat.
std::string quantity_part(const std::string& name);
std::string term_part(const std::string& name);

/// Whether the quantity of this name is a function of a variable: those of omega_m are nothing to the BRDF, whose
/// facets are those of the half vector, and an integral knows omega_o alone.
bool depends_on(const std::string& name, const std::string& variable);

/// A term at given values of the swept variables.
class TermFunction {
public:
  /// \throws InputError when the quantity is unknown or cannot be had: a direction is missing, a model or parameter is
  /// not there. `swept`: the variables that will be given to operator().
  TermFunction(const Term& term, std::vector<std::string> swept, double tolerance);

  /// The values of all rows. \throws InputError, AccuracyError
  std::vector<double> operator()(const SweptColumns& columns) const;

  /// Throws what operator() would at these values, without computing an integral.
  void check(const std::vector<double>& values) const;

  bool is_integral() const { return integral_ || (sampled_ && sampled_ != SampledQuantity::pdf); }
  const Configuration& fixed() const { return configuration_.fixed(); }

private:
  void require_all(const MaterialDescription& description, const Material& material,
                   const Directions& directions) const;
  double integral_at(const Material& material, const Direction& o) const;
  std::vector<double> sampled(const MaterialDescription& description, const Material& material,
                              const std::vector<Directions>& directions) const;
  std::vector<double> evaluated(const Material& material, const std::vector<Directions>& directions) const;

  std::string name_;
  std::string term_; ///< whose quantity it is; none: the material's, or its only term's
  SweptConfiguration configuration_;
  std::optional<Quantity> quantity_;
  std::optional<Integral> integral_;
  std::optional<SampledQuantity> sampled_;
  double tolerance_;
};

} // namespace brdfplot::plot
