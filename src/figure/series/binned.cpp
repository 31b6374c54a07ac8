#include "base/number.hpp"
#include "brdf/evaluate.hpp"
#include "figure/series/simulated.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace brdfplot::plot {

namespace {

/// No rays: the mean of the BRDF itself over the bins in which `surface` counts them, by the middle points of a grid.
class BinsSource final : public SimulationSource {
public:
  std::string name() const override { return "bins"; }
  std::string doc() const override {
    return "no rays, but the quantity itself, averaged over the bins in which \"surface\" counts them";
  }
  std::vector<std::string> quantities() const override { return {"brdf_cos"}; }

  void check(const Term& term, const Configuration::Ready& at) const override {
    if (!at.o || !at.i) throw InputError("", std::string("this mean needs ") + (at.o ? "theta_i" : "theta_o"));
    require(at.material, info_of(Quantity::brdf_cos), true, true, false);
    require_channel(at.description, at.material, at.channel, term.quantity);
  }

  std::string group(const Term&, const Configuration::Ready&) const override { return ""; }

  std::string key(const Term& term, const Points& points) const override {
    std::string text = "bins " + std::to_string(term.simulate->samples) + " " +
                       format_number(term.simulate->half_width) + " " + defining_text(term, {});
    for (const auto& point : points)
      text += "\n" + defining_text(Term{term.quantity, point.description, {}, {}}, {}) + defining_text(*point.o) +
              defining_text(*point.i);
    return text;
  }

  simulation::Result run(const Term& term, const Points& points, int) const override {
    simulation::Estimates means;
    means.points = points.size();
    for (const auto& point : points) means.values.push_back(mean(*term.simulate, point));
    // Twice the same: no error.
    means.values.insert(means.values.end(), means.values.begin(),
                        means.values.begin() + static_cast<std::ptrdiff_t>(points.size()));
    return {{"brdf_cos", means}};
  }

  double work(const Term&, const Points&) const override { return 0; }
  std::string output(const Term& term) const override { return term.quantity; }
  bool is_binned(const Term&) const override { return true; }

private:
  static double mean(const Simulate& bins, const Configuration::Ready& at) {
    constexpr int along = 16, across = 16;
    constexpr std::size_t all = std::size_t{along} * across;
    const Direction& plane = std::hypot(at.o->x, at.o->y) > 0 ? *at.o : *at.i;
    const double length = std::hypot(plane.x, plane.y);
    const double px = length > 0 ? plane.x / length : 1, py = length > 0 ? plane.y / length : 0;
    const double middle = std::atan2(px * at.i->x + py * at.i->y, at.i->z), width = std::numbers::pi / bins.samples;
    std::array<std::vector<double>, 3> i, o;
    for (int k = 0; k < along; ++k)
      for (int l = 0; l < across; ++l) {
        const double a = middle + width * ((k + 0.5) / along - 0.5);
        const double sine = std::sin(bins.half_width) * (2 * (l + 0.5) / across - 1),
                     cosine = std::sqrt(1 - sine * sine);
        i[0].push_back(cosine * std::sin(a) * px - sine * py);
        i[1].push_back(cosine * std::sin(a) * py + sine * px);
        i[2].push_back(cosine * std::cos(a));
      }
    for (std::size_t k = 0; k < 3; ++k) o[k].assign(all, std::array{at.o->x, at.o->y, at.o->z}[k]);
    const auto channels = static_cast<std::size_t>(channels_of(at.material, Quantity::brdf_cos));
    std::vector<double> values(channels * all);
    const auto columns = [](const auto& d) { return Columns{d[0].data(), d[1].data(), d[2].data()}; };
    evaluate(at.material, Quantity::brdf_cos, {all, columns(o), columns(i), {}}, values.data());
    const Rgb weights = channels == 1 ? Rgb{1, 0, 0} : weights_of(at.channel.value_or(Channel::r));
    double sum = 0;
    for (std::size_t k = 0; k < values.size(); ++k) sum += weights.at(k / all) * values[k] / all;
    return sum;
  }
};

} // namespace

const SimulationSource& bins_source() {
  static const BinsSource source;
  return source;
}

} // namespace brdfplot::plot
