#include "choice/methods/newton_slope.hpp"

#include <boost/math/special_functions/erf.hpp>

namespace brdfplot::choice {

double erf_inverse(double x) { return boost::math::erf_inv(x); }
float erf_inverse(float x) { return boost::math::erf_inv(x); }
Counted erf_inverse(const Counted& x) {
  ++Counted::operations().transcendentals;
  return {boost::math::erf_inv(x.value())};
}

} // namespace brdfplot::choice
