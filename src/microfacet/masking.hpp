/// \file
/// The list of masking functions. A new one is one file in masking/ and one line here.
///
/// Each has either (`has_lambda`) c Lambda, independent of the normal, as `masked_area(projection, omega)` or, over
/// arrays, `masked_areas(distribution, c, s, t, n)`, or `unmasked_area(projection, o_dot_m, z_m)` = c / G1. Both are
/// finite at grazing, where Lambda is not. Only `custom` is asked with more, since a formula may use it.
///
/// What is not smooth in the direction declares where, so that integrals can be cut there: `kink(projection)`, or
/// `kink(projection, o_dot_m, z_m)` where it depends on the normal, changes its sign. May be declared beside:
///   kink_is_line       G1 depends on the normal by o.m / z_m alone, and the kink is where that is 2 c: the line u_1 =
///                      -a
///   is_of_several_a    Lambda is no function of a = c / s alone
///   is_formula         it may depend on anything, and has no symmetry
///   FitsOnly           the one distribution it is for
///   default_shadowing  a type of shadowing.hpp, where it is neither height_correlated (with a Lambda) nor separable
///                      (without)
///   exact_for_surface  a type of simulation/surface.hpp, where it is exact for surfaces that are not Smith's
///   takes_lambda_of_distribution()
#pragma once

#include "microfacet/masking/custom.hpp"
#include "microfacet/masking/implicit.hpp"
#include "microfacet/masking/karis.hpp"
#include "microfacet/masking/kelemen.hpp"
#include "microfacet/masking/published_fit.hpp"
#include "microfacet/masking/schlick_smith.hpp"
#include "microfacet/masking/smith.hpp"
#include "microfacet/masking/smith_rational.hpp"
#include "microfacet/masking/v_cavity.hpp"

#include <variant>

namespace brdfplot {

using Masking = std::variant<Smith,                //
                             SmithRational,        //
                             SheenFit,             //
                             StudentTFit,          //
                             VCavity,              //
                             Implicit,             //
                             SchlickSmith,         //
                             SchlickSmithRational, //
                             Karis,                //
                             Kelemen,              //
                             CustomMasking>;

} // namespace brdfplot
