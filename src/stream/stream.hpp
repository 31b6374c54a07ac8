/// \file
/// Quantities of a material for a stream of directions: CSV in, CSV out.
#pragma once

#include "analysis/integrals.hpp"
#include "base/text_files.hpp"
#include "stream/rows.hpp"

#include <string>
#include <variant>
#include <vector>

namespace brdfplot {

/// The density (1/sr) of directions of the light that a sampler draws.
struct DensityInfo {
  std::string name = "pdf";
  std::string doc = "density of omega_i as it is drawn from omega_o (--strategy), 1/sr over the whole sphere";
};

/// A quantity with a closed form, an integral at omega_o, or the density of what is sampled.
struct StreamQuantity {
  std::string name; ///< as it was asked for: "g1", or "coat.g1" of one term
  std::string term; ///< none: of the material, or its only term
  std::variant<QuantityInfo, IntegralInfo, DensityInfo> info;

  const QuantityInfo* closed_form() const { return std::get_if<QuantityInfo>(&info); }
  const IntegralInfo* integral() const { return std::get_if<IntegralInfo>(&info); }
  bool is_density() const { return std::holds_alternative<DensityInfo>(info); }
};

/// What quantities() and integrals() offer, and pdf, by name, after the name of a term or without. \throws InputError
/// at `where` for an unknown name, or one that is there twice.
std::vector<StreamQuantity> select_quantities(const std::vector<std::string>& names, const std::string& where);

struct StreamOptions {
  std::vector<StreamQuantity> quantities;
  double tolerance = default_tolerance; ///< of integrals
  int threads = 1;
  bool single_precision = false;    ///< closed forms in float; there are no integrals in it, nor pdf
  std::string strategy = "default"; ///< of pdf
};

/// Reads directions (see DirectionColumns) and writes every row as it was, followed by a column per quantity: `brdf`,
/// or `brdf_r,brdf_g,brdf_b` for a quantity that has as many channels as the material. g2, brdf and brdf_cos are taken
/// at the half vector, whether or not there are columns of omega_m; the others that need omega_m take the columns, or
/// without them the half vector.
///
/// Memory does not grow with the number of rows, and what is written does not depend on the number of threads: before a
/// row that is wrong, all rows above it.
/// \throws InputError for an integral or pdf in single precision, and a strategy that a term has not; naming FILE:LINE
/// for the first row that is wrong, AccuracyError for the first integral that misses the tolerance, FileError when
/// reading or writing fails.
void evaluate_stream(const Material& material, const StreamOptions& options, RowSource& in, OutputFile& out);
void evaluate_stream(const Material& material, const StreamOptions& options, InputFile& in, OutputFile& out);

} // namespace brdfplot
