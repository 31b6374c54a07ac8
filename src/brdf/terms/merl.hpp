/// \file
/// Measured reflectance of the MERL database.
#pragma once

#include "brdf/integrals/kinks.hpp"
#include "brdf/term.hpp"

#include <functional>
#include <memory>

namespace brdfplot {

class MerlTable;

/// rho of three channels from a MERL file (see read_merl()), isotropic and reciprocal by its coordinates. rho is that
/// of the cell in which the pair lies, as MERL's own reader has it: piecewise constant, with a jump at the edges of
/// cells and nothing in between. An edge belongs to the cell beyond it.
struct Merl {
  static constexpr bool piecewise_constant = true;
  std::shared_ptr<const MerlTable> table;

  static ModelSpec spec();
  static Merl from(const TermDescription& description);

  int channels() const { return 3; }
  void evaluate(const PairBlock& block, SurfaceBlock& work, const ChannelRows& out) const;
  Merl white() const { return *this; } ///< what of it absorbs is not known
  ColourEstimate reflected_light(const Direction& omega_o, double tolerance, const ChannelRange& channels,
                                 const std::function<double(const Direction& omega_i)>& weight) const;
};

} // namespace brdfplot
