#include "sampling/direct_lobe.hpp"
#include "sampling/piecewise_density.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace brdfplot {

namespace {

class MatteLobe : public DirectLobe {
public:
  explicit MatteLobe(TermAlbedo other) : other_(std::move(other)) {
    constexpr int pieces = 64;
    for (int k = 0; k < pieces; ++k) {
      PiecewiseDensity::Piece piece{static_cast<double>(k) / pieces, static_cast<double>(k + 1) / pieces};
      // cos sin dtheta = 2 t^3 dt with t = sqrt(cos theta), in which albedos are smooth.
      for (std::size_t j = 0; j < PiecewiseDensity::nodes; ++j) {
        const double t = piece.node(j);
        piece.values[j] = loss(t * t) * 2 * t * t * t;
      }
      roots_.add(piece);
    }
  }

  Direction sample(const Direction&, const SamplePoint& point) const override {
    const double root = std::fmin(roots_.inverse(point[0]), 1.0), z = root * root;
    const double s = std::sqrt((1 - z) * (1 + z)), phi = 2 * std::numbers::pi * point[1];
    return {s * std::cos(phi), s * std::sin(phi), z};
  }

  double density(const Direction& omega_o, const Direction& omega_i) const override {
    if (!(omega_o.z > 0 && omega_i.z > 0)) return 0;
    return loss(omega_i.z) * omega_i.z / (2 * std::numbers::pi * roots_.total());
  }

private:
  double loss(double cosine) const {
    const Direction omega{std::sqrt((1 - cosine) * (1 + cosine)), 0, cosine};
    const AlbedoTable& table = other_.table();
    double sum = 0;
    for (std::size_t c = 0; c < table.channels(); ++c) sum += table.loss(c, omega);
    return sum / static_cast<double>(table.channels());
  }

  TermAlbedo other_;
  PiecewiseDensity roots_; ///< of sqrt(cos theta)
};

} // namespace

std::shared_ptr<const DirectLobe> matte_lobe(const TermAlbedo& other) {
  return std::make_shared<const MatteLobe>(other);
}

} // namespace brdfplot
