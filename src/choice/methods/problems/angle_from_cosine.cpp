#include "choice/methods/add.hpp"
#include "choice/methods/exact.hpp"
#include "choice/methods/problems.hpp"

namespace brdfplot::choice {

namespace {

/// From the third component alone.
struct AngleByCosine {
  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    using std::acos, std::sqrt;
    return acos(sqrt((T(1) - x[0]) * (T(1) + x[0])));
  }
};

/// From both.
struct AngleByBoth {
  template <class T>
  T operator()(const std::array<T, 1>& x) const {
    using std::atan2, std::sqrt;
    return atan2(x[0], sqrt((T(1) - x[0]) * (T(1) + x[0])));
  }
};

Exact exact_angle(std::span<const double> x) { return exact_of(Real(asin(Real(x[0])))); }

} // namespace

Problem angle_from_cosine() {
  Problem p{.name = "angle_from_cosine",
            .doc = "Angle of a direction (x, 0, z) to the normal",
            .source = "the definition",
            .inputs = {{"x", "its horizontal component", 1e-12, 1, Scale::logarithmic}},
            .exact = exact_angle,
            .least = 0,
            .monotone = {1}};
  add_formula<1>(p, "acos", "acos(z)", "the definition", Kind::printed, AngleByCosine{}, {{0.5}});
  add_formula<1>(p, "atan2", "atan2(x, z)", "the definition, rewritten", Kind::rewritten, AngleByBoth{}, {{0.5}});
  return p;
}

} // namespace brdfplot::choice
