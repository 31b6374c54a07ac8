/// \file
/// The list of distributions. A new one is one file in distributions/ and one line here.
#pragma once

#include "microfacet/distributions/beckmann.hpp"
#include "microfacet/distributions/custom.hpp"
#include "microfacet/distributions/exponential_power.hpp"
#include "microfacet/distributions/ggx.hpp"
#include "microfacet/distributions/isotropic/gaussian.hpp"
#include "microfacet/distributions/isotropic/gtr.hpp"
#include "microfacet/distributions/isotropic/oren_nayar.hpp"
#include "microfacet/distributions/isotropic/phong.hpp"
#include "microfacet/distributions/isotropic/sheen.hpp"
#include "microfacet/distributions/isotropic/velvet.hpp"
#include "microfacet/distributions/isotropic/ward.hpp"
#include "microfacet/distributions/mixture.hpp"
#include "microfacet/distributions/student_t.hpp"

#include <variant>

namespace brdfplot {

/// The list, which ends with what is made of the others.
template <class... Composed>
using DistributionList = std::variant<Beckmann,         //
                                      Ggx,              //
                                      Phong,            //
                                      Gtr,              //
                                      StudentT,         //
                                      ExponentialPower, //
                                      Velvet,           //
                                      Sheen,            //
                                      Ward,             //
                                      Gaussian,         //
                                      OrenNayar,        //
                                      Custom,           //
                                      Composed...>;

using Mixture = MixtureOf<DistributionList<>>;
using Distribution = DistributionList<Mixture>;

} // namespace brdfplot
