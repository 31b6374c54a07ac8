#include "integrate/cut_rays.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot {

namespace {

/// Ascending; those that are one place but for rounding, as the sign changes of two switches with the same zeros are,
/// by their switch, so that rays are alike.
void put_in_order(CutRays::Ends& ends) {
  std::ranges::sort(ends, {}, &CutRays::End::z);
  const double close = CutRays::same_place * ends.back().z;
  for (auto from = ends.begin() + 1; from + 1 < ends.end();) {
    auto to = from + 1;
    while (to + 1 < ends.end() && to->z - (to - 1)->z <= close) ++to;
    std::ranges::sort(from, to, {}, &CutRays::End::crossed);
    from = to;
  }
}

} // namespace

const CutRays::Ends& CutRays::at(double psi) {
  if (const auto known = rays_.find(psi); known != rays_.end()) return known->second;
  if (rays_.size() >= most_rays) rays_.clear();
  cos_psi_ = std::cos(psi);
  sin_psi_ = std::sin(psi);
  const SlopeFrame::Reach reach = reach_(cos_psi_, sin_psi_);
  const auto place = [](double r) { return r == infinity ? 1 : r / (spread + r); };
  Ends ends = {{place(reach.from), switches_.size()}, {place(reach.to), switches_.size()}};
  const bool runs = ends[0].z < ends[1].z;
  for (std::size_t k = 0; runs && k < frame_.radii().size(); ++k) {
    const double z = place(frame_.radii()[k]);
    if (z > ends[0].z && z < ends[1].z) ends.push_back({z, switches_.size() + 1 + k});
  }
  for (std::size_t k = 0; runs && k < switches_.size(); ++k) add_sign_changes(k, ends);
  put_in_order(ends);
  return rays_.emplace(psi, std::move(ends)).first->second;
}

void CutRays::evaluate_switch(const NormalIntegrand& of, std::span<const double> z) {
  const std::size_t n = z.size();
  u1_.resize(n);
  u2_.resize(n);
  normals_.resize(n);
  values_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double r = spread * z[k] / (1 - z[k]);
    u1_[k] = r * cos_psi_;
    u2_[k] = r * sin_psi_;
  }
  frame_.normals(u1_.data(), u2_.data(), normals_.data(), n);
  of(normals_, values_);
}

void CutRays::add_sign_changes(std::size_t which, Ends& ends) {
  const NormalIntegrand& of = switches_[which].value;
  constexpr std::size_t probes = 24;
  const double begin = ends[0].z, length = ends[1].z - begin;
  static const auto cosines = [] {
    std::array<double, probes> all{};
    for (std::size_t k = 0; k < probes; ++k) all[k] = std::cos(std::numbers::pi * static_cast<double>(k) / probes);
    return all;
  }();
  std::vector<double> z;
  z.reserve(2 * probes);
  for (const double share : {1e-9, 1e-6, 1e-4})
    z.push_back(begin + share * length); // crossings may leave by the centre
  for (std::size_t k = 1; k < probes; ++k) z.push_back(begin + length * (1 - cosines[k]) / 2);
  z.push_back(begin + length * (1 - 1e-5)); // and by the horizon
  evaluate_switch(of, z);
  std::vector<double> values = values_;
  for (std::size_t k = z.size() - 2; k > 0; --k) {
    const std::array<double, 3> at = {z[k - 1], z[k], z[k + 1]};
    const std::array<double, 3> value = {values[k - 1], values[k], values[k + 1]};
    if (const auto beyond = dip(of, at, value)) {
      const auto behind = static_cast<std::ptrdiff_t>(beyond->first > z[k] ? k + 1 : k);
      z.insert(z.begin() + behind, beyond->first);
      values.insert(values.begin() + behind, beyond->second);
    }
  }
  std::size_t last = 0; // the last one that is not zero
  for (std::size_t k = 1; k < z.size(); ++k) {
    if (values[k] == 0) continue;
    if (values[last] * values[k] < 0)
      ends.push_back({sign_change(of, {z[last], z[k]}, {values[last], values[k]}), which});
    last = k;
  }
}

/// Two sign changes may hide between probes. Where the middle one of three values is nearest to zero, a point
/// between them of the other sign, and its value, if parabolas lead to one.
std::optional<std::pair<double, double>> CutRays::dip(const NormalIntegrand& of, std::array<double, 3> z,
                                                      std::array<double, 3> value) {
  const double side = value[1] > 0 ? 1 : -1;
  for (double& v : value) v *= side;
  if (!(value[1] > 0 && value[0] > value[1] && value[2] > value[1])) return {};
  for (int step = 0; step < 10; ++step) {
    const double left = (z[1] - z[0]) * (value[2] - value[1]), right = (z[2] - z[1]) * (value[0] - value[1]);
    const double vertex = z[1] + 0.5 * ((z[2] - z[1]) * right - (z[1] - z[0]) * left) / (left + right);
    if (!(vertex > z[0] && vertex < z[2]) || std::fabs(vertex - z[1]) < 1e-9 * z[1]) return {};
    evaluate_switch(of, std::span(&vertex, 1));
    const double here = side * values_[0];
    if (here < 0) return std::pair(vertex, side * here);
    const bool lower = here < value[1];
    const std::size_t replaced = (vertex < z[1]) == lower ? 2 : 0;
    z[replaced] = lower ? z[1] : vertex;
    value[replaced] = lower ? value[1] : here;
    if (lower) {
      z[1] = vertex;
      value[1] = here;
    }
  }
  return {};
}

/// Regula falsi, Illinois variant.
double CutRays::sign_change(const NormalIntegrand& of, std::array<double, 2> z, std::array<double, 2> value) {
  for (int step = 0; step < 60 && std::fabs(z[1] - z[0]) > 1e-15 * z[1]; ++step) {
    const double at = (z[0] * value[1] - z[1] * value[0]) / (value[1] - value[0]);
    if (!(at > std::min(z[0], z[1]) && at < std::max(z[0], z[1]))) break;
    evaluate_switch(of, std::span(&at, 1));
    if (values_[0] == 0) return at;
    if (values_[0] * value[1] < 0) {
      z[0] = z[1];
      value[0] = value[1];
    } else {
      value[0] *= 0.5;
    }
    z[1] = at;
    value[1] = values_[0];
  }
  return z[1];
}

} // namespace brdfplot
