/// \file
/// The tests behind properties.hpp.
#pragma once

#include "analysis/properties.hpp"

#include <optional>

namespace brdfplot {

/// Collects residuals, and the verdict that follows from all of them.
class WorstResidual {
public:
  explicit WorstResidual(double tolerance) : tolerance_(tolerance) {}

  /// The roughness of what comes next.
  void at_alpha(double alpha) { alpha_ = alpha; }
  /// A residual with its error, at a viewer. NaN: it could not be computed.
  void take(double residual, double error, double theta_o, double phi_o);
  /// Without one the property does not apply.
  Residual residual() const;

private:
  double tolerance_;
  double alpha_ = 0;
  Residual worst_;
  bool any_ = false, one_fails_ = false, all_hold_ = true;
};

/// A material with what its tests vary.
struct PropertySubject {
  explicit PropertySubject(const MaterialDescription& from);
  PropertySubject(const PropertySubject&) = delete;
  PropertySubject(PropertySubject&&) = delete;
  PropertySubject& operator=(const PropertySubject&) = delete;
  PropertySubject& operator=(PropertySubject&&) = delete;
  ~PropertySubject() = default;

  MaterialDescription description;
  Material material;
  const Microsurface* surface = nullptr; ///< the only one; null where there is none or are several
  std::vector<double> azimuths;          ///< of the viewer: 0 alone where the material is isotropic

  /// The direction at polar angles about the normal of the mesosurface, after the shear that levels it (Heitz 2014,
  /// section 5.5): c is cos theta times the length.
  Direction viewer(double theta, double phi) const;
};

void test_property(Property property, const PropertySubject& subject, const PropertySearch& search,
                   WorstResidual& worst);

} // namespace brdfplot
