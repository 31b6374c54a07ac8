/// \file
/// The albedo of a term, of which another term is made.
#pragma once

#include "brdf/integrals/albedo_table.hpp"
#include "brdf/term.hpp"

#include <memory>
#include <string>

namespace brdfplot {

struct WeightedTerm;

/// Whether the planes y = 0 and x = 0 are mirrors of the term, as far as its microsurface tells: it is centred, without
/// correlation, and its masking is no formula.
bool has_mirror_planes(const WeightedTerm& term);

/// The albedo of a term with its weight, as a table that is made when it is first asked for: files are read and checked
/// without. Copies share it, and so do terms of the same description, whatever their names, since figures build a
/// material a value.
class TermAlbedo {
public:
  /// \throws MaterialError at "/of" where the term has not the planes y = 0 and x = 0 for mirrors
  explicit TermAlbedo(const TermDescription& term);

  std::size_t channels() const;
  bool is_isotropic() const;
  /// To about 1e-8, or 3e-7 where it is anisotropic.
  /// \throws InputError where the albedo is above 1 by more than its error; AccuracyError where the integrals do not
  /// reach 1e-6
  const AlbedoTable& table() const;

private:
  struct Shared;
  std::string name_; ///< of the term, which errors tell
  std::shared_ptr<Shared> shared_;
};

} // namespace brdfplot
