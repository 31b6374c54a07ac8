/// \file
/// The list of terms that a BRDF may be a sum of. A new one is one file in terms/ and one line here.
#pragma once

#include "brdf/terms/complement.hpp"
#include "brdf/terms/diffuse/disney_diffuse.hpp"
#include "brdf/terms/diffuse/disney_sheen.hpp"
#include "brdf/terms/diffuse/eon.hpp"
#include "brdf/terms/diffuse/facet_diffuse.hpp"
#include "brdf/terms/diffuse/fresnel_lambert.hpp"
#include "brdf/terms/diffuse/hammon_diffuse.hpp"
#include "brdf/terms/diffuse/lambert.hpp"
#include "brdf/terms/diffuse/oren_nayar.hpp"
#include "brdf/terms/diffuse/shirley.hpp"
#include "brdf/terms/diffuse/uncharted2.hpp"
#include "brdf/terms/diffuse/velvet_cloth.hpp"
#include "brdf/terms/diffuse/wrap.hpp"
#include "brdf/terms/kelemen.hpp"
#include "brdf/terms/merl.hpp"
#include "brdf/terms/mirror.hpp"
#include "brdf/terms/multiple_bounce.hpp"
#include "brdf/terms/rgl.hpp"
#include "brdf/terms/turquin.hpp"

#include <variant>

namespace brdfplot {

template <TermModel... T>
using TermList = std::variant<T...>;

using BrdfTerm = TermList<Mirror,         //
                          Kelemen2001,    //
                          Complement,     //
                          MultipleBounce, //
                          Turquin,        //
                          FacetDiffuse,   //
                          OrenNayarFits,  //
                          FujiiOrenNayar, //
                          Eon,            //
                          Lambert,        //
                          FresnelLambert, //
                          Shirley,        //
                          DisneyDiffuse,  //
                          HammonDiffuse,  //
                          DisneySheen,    //
                          VelvetCloth,    //
                          Uncharted2,     //
                          Wrap,           //
                          Merl,           //
                          Rgl>;

} // namespace brdfplot
