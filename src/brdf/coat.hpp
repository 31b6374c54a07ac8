/// \file
/// What a clear coat lets through to what lies beneath it.
#pragma once

#include "brdf/integrals/kinks.hpp"
#include "brdf/integrals/term_albedo.hpp"
#include "brdf/terms/diffuse/flat.hpp"
#include "microfacet/fresnel.hpp"
#include "microfacet/slopes.hpp"

#include <optional>
#include <string>
#include <vector>

namespace brdfplot {

struct MaterialDescription;
struct Material;

/// A coat over other terms (Akenine-Moller et al. 2018, section 9.12): these are multiplied, for each channel, by
///   both         (1 - w F(c_o)) (1 - w F(c_i)), F the Fresnel term of the coat, w its weight, c the cosine of a
///                direction with the normal of the mesosurface: light is lost on its way in and out
///   half         1 - w F(c_o), the viewer's alone, as glTF's KHR_materials_clearcoat has it; not reciprocal
///   half_vector  1 - w F(o.h), as Filament has it
///   albedo       the smaller of 1 - E(o) and 1 - E(i), E the coat's albedo with its weight: what a sheen leaves
///   (Estevez
///                and Kulla 2017). An isotropic coat; E is a table (term_albedo.hpp)
///   none         1, as in Burley 2012
/// times tint^((1 / c_o' + 1 / c_i') / 2): `tint` is what goes down and up along the normal, c' the cosine within the
/// coat, sqrt(1 - (1 - c^2) / eta^2) (Beer and Lambert); it asks for a dielectric coat, whose eta is the index within.
///
/// Terms beneath are evaluated at the directions outside: refraction narrows no lobe, and light is not reflected
/// between the two. Relative error of the factor below 1e-14, also near grazing, where F nears 1: 1 - w F is
/// (1 - w) + w (1 - F), and 1 - F what is refracted or absorbed. With `albedo`, absolute error 1e-8.
class Coat {
public:
  /// Its parameters: attenuation and tint.
  static std::vector<ParameterSpec> parameters();
  /// \throws MaterialError at "/attenuation" or "/tint", within the coated term, where the coat has not what they need
  Coat(const TermDescription& coat, const Values& values);

  int channels() const;
  /// Where the factor bends, for integrals over half vectors.
  std::vector<Switch> kinks(const Direction& omega_o) const;
  /// Multiplies `factor`, of n a channel, by what passes at each pair of directions above the mesosurface.
  void attenuate(const Columns& o, const Columns& i, std::size_t n, int channels, std::vector<double>& factor) const;

private:
  void attenuate_by_fresnel(const Columns& o, const Columns& i, std::size_t n, std::size_t channel,
                            double* factor) const;
  void attenuate_by_albedo(const Columns& o, const Columns& i, std::size_t n, std::size_t channel,
                           double* factor) const;
  void absorb(const Columns& o, const Columns& i, std::size_t n, std::size_t channel, double* factor) const;
  double cosine(const Direction& omega) const;

  std::string attenuation_;
  Colour weight_;
  Colour tint_;
  Fresnel fresnel_;
  std::optional<TermAlbedo> albedo_;
  SlopeMap mesosurface_;
};

/// Gives the terms of a material the coats that lie over them. \throws MaterialError
void lay_coats(const MaterialDescription& description, Material& material);

/// What passes all coats, of n a channel; empty where there are none.
std::vector<double> let_through(const std::vector<Coat>& coats, const Columns& o, const Columns& i, std::size_t n,
                                int channels);

} // namespace brdfplot
