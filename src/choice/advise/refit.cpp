#include "choice/advise/refit.hpp"

#include "choice/advise/shader/mirror.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace brdfplot::choice {

namespace {

/// One number among the free parameters.
struct Coordinate {
  FreeParameter parameter;
  std::size_t channel = 0;
  bool of_all = true; ///< of all channels at once
};

Value value_of(const TermDescription& term, const std::string& key) {
  if (key == "weight") return term.weight;
  const auto& map = (key == "f0" && !term.values.has(key) ? term.fresnel.values : term.values).map();
  return map.find(key)->second;
}

/// F82's factor as far up as another f0 asks for, so that F stays >= 0.
void lift_f82(ModelChoice& fresnel) {
  const Rgb f0 = fresnel.values.rgb("f0");
  Rgb factor = fresnel.values.rgb("f82");
  for (std::size_t c = 0; c < 3; ++c) factor[c] = std::max(factor[c], F82Fresnel::least_f82(f0[c]));
  fresnel.values.set("f82", fresnel.values.is_rgb("f82") ? Value(factor) : Value(factor[0]));
}

void set_value(TermDescription& term, const std::string& key, const Value& value) {
  if (key == "weight") {
    term.weight = value;
  } else if (key == "f0" && !term.values.has(key)) {
    const bool constant = forms::is_constant(term.fresnel);
    term.fresnel.values.set(key, value);
    if (constant) term.fresnel.values.set("f90", value);
    if (term.fresnel.type == "f82") lift_f82(term.fresnel);
  } else {
    term.values.set(key, value);
  }
}

bool has_value(const TermDescription& term, const std::string& key) {
  return key == "weight" || term.values.has(key) || (key == "f0" && term.fresnel.values.has(key));
}

std::vector<Coordinate> coordinates_of(Draft& draft) {
  std::vector<Coordinate> out;
  for (const FreeParameter& one : draft.free) {
    const TermDescription* term = draft.find(one.term);
    if (one.key == "alpha") {
      out.push_back({one});
    } else if (has_value(*term, one.key)) {
      const bool rgb = std::holds_alternative<Rgb>(value_of(*term, one.key));
      for (std::size_t c = 0; c < (rgb ? 3 : 1); ++c) out.push_back({one, c, !rgb});
    }
  }
  return out;
}

/// The value of a coordinate; of alpha the logarithm of the factor, which is 0 in the draft.
double get(Draft& draft, const Coordinate& at) {
  if (at.parameter.key == "alpha") return 0;
  const TermDescription& term = *draft.find(at.parameter.term);
  const Value value = value_of(term, at.parameter.key);
  return at.of_all ? std::get<double>(value) : std::get<Rgb>(value)[at.channel];
}

double within(const Coordinate& at, double x) {
  if (at.parameter.key == "alpha") return std::clamp(x, -std::log(8.0), std::log(8.0));
  return std::clamp(x, 0.0, at.parameter.key == "weight" ? 1e6 : 1.0);
}

void scale_alpha(TermDescription& term, double factor) {
  for (const char* key : {"alpha", "alpha_x", "alpha_y"})
    if (term.distribution.values.has(key))
      term.distribution.values.set(key, std::clamp(term.distribution.values.number(key) * factor, 1e-6, 1e6));
}

MaterialDescription with(const Draft& draft, const std::vector<Coordinate>& coordinates, const Eigen::VectorXd& x) {
  Draft out = draft;
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    const Coordinate& at = coordinates[k];
    TermDescription& term = *out.find(at.parameter.term);
    const double value = x[static_cast<Eigen::Index>(k)];
    if (at.parameter.key == "alpha") {
      scale_alpha(term, std::exp(value));
    } else if (at.of_all) {
      set_value(term, at.parameter.key, value);
    } else {
      Rgb rgb = std::get<Rgb>(value_of(term, at.parameter.key));
      rgb[at.channel] = value;
      set_value(term, at.parameter.key, rgb);
    }
  }
  return out.material;
}

/// The logarithms of what the screen shows in the lit places, weighted by the root of their share.
class Residuals {
public:
  Residuals(const Draft& draft, const std::vector<Coordinate>& coordinates, Renderer& renderer, const FitTarget& target)
      : draft_(draft), coordinates_(coordinates), renderer_(renderer), target_(target),
        aim_(logarithms(target.picture)) {}

  Eigen::VectorXd at(const Eigen::VectorXd& x) const {
    return logarithms(renderer_.picture(with(draft_, coordinates_, x), target_.model, false)) - aim_;
  }

private:
  Eigen::VectorXd logarithms(const Picture& picture) const {
    const Places& places = renderer_.places();
    const std::size_t n = places.at.size();
    Eigen::VectorXd out(static_cast<Eigen::Index>(3 * n));
    for (std::size_t k = 0; k < n; ++k) {
      const Rgb reference = colour_at(target_.picture, n, k);
      const bool lit = std::max({reference[0], reference[1], reference[2]}) > 0;
      const Rgb seen = shown(colour_at(picture, n, k), target_.exposure);
      for (std::size_t c = 0; c < 3; ++c)
        out[static_cast<Eigen::Index>(c * n + k)] = lit ? std::sqrt(places.share[k]) * std::log(seen[c]) : 0;
    }
    return out;
  }

  const Draft& draft_;
  const std::vector<Coordinate>& coordinates_;
  Renderer& renderer_;
  const FitTarget& target_;
  Eigen::VectorXd aim_;
};

/// Derivatives by differences, towards the inside of the bounds. Channels of one colour are changed at once, since a
/// channel of the picture depends on its own alone.
Eigen::MatrixXd jacobian(const Residuals& residuals, const std::vector<Coordinate>& coordinates,
                         const Eigen::VectorXd& x, const Eigen::VectorXd& now) {
  const auto count = static_cast<Eigen::Index>(coordinates.size());
  const Eigen::Index n = now.size() / 3;
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(now.size(), count);
  for (Eigen::Index k = 0; k < count;) {
    const Coordinate& at = coordinates[static_cast<std::size_t>(k)];
    const Eigen::Index channels = at.of_all ? 1 : 3;
    Eigen::VectorXd y = x;
    for (Eigen::Index c = k; c < k + channels; ++c) {
      const double step = at.parameter.key == "alpha" ? 0.01 : std::max(0.01 * std::fabs(x[c]), 1e-4);
      y[c] = within(at, x[c] + step) == x[c] + step ? x[c] + step : x[c] - step;
    }
    const Eigen::VectorXd change = residuals.at(y) - now;
    for (Eigen::Index c = 0; c < channels; ++c) {
      const double step = y[k + c] - x[k + c];
      if (channels == 1)
        out.col(k) = change / step;
      else
        out.block(c * n, k + c, n, 1) = change.segment(c * n, n) / step;
    }
    k += channels;
  }
  return out;
}

} // namespace

MaterialDescription refitted(const Draft& draft, Renderer& renderer, const FitTarget& target) {
  Draft start = draft;
  const std::vector<Coordinate> coordinates = coordinates_of(start);
  if (coordinates.empty()) return draft.material;
  const Residuals residuals(start, coordinates, renderer, target);
  const auto count = static_cast<Eigen::Index>(coordinates.size());
  Eigen::VectorXd x(count);
  for (Eigen::Index k = 0; k < count; ++k) x[k] = get(start, coordinates[static_cast<std::size_t>(k)]);
  Eigen::VectorXd now = residuals.at(x);
  Eigen::MatrixXd j = jacobian(residuals, coordinates, x, now);
  double damping = 1e-3;
  for (int iteration = 0; iteration < 4; ++iteration) {
    const Eigen::MatrixXd normal = j.transpose() * j;
    const Eigen::VectorXd gradient = j.transpose() * now;
    Eigen::MatrixXd damped = normal;
    damped.diagonal() += damping * normal.diagonal() + Eigen::VectorXd::Constant(count, 1e-14);
    Eigen::VectorXd y = x - damped.ldlt().solve(gradient);
    for (Eigen::Index k = 0; k < count; ++k) y[k] = within(coordinates[static_cast<std::size_t>(k)], y[k]);
    const Eigen::VectorXd next = residuals.at(y);
    const double before = now.squaredNorm(), after = next.squaredNorm();
    if (!(after < before)) {
      damping *= 20;
      continue;
    }
    x = y;
    now = next;
    damping *= 0.2;
    if (after > 0.97 * before) break;
    j = jacobian(residuals, coordinates, x, now);
  }
  return with(start, coordinates, x);
}

} // namespace brdfplot::choice
