#include "brdf/measured/rgl_table.hpp"

#include "base/memory.hpp"
#include "base/number.hpp"
#include "brdf/measured/tensor_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot {

namespace {

using std::numbers::pi;

/// A place on an axis of n values: the interval, and how far into it.
struct Place {
  std::size_t index;
  double t;
};

Place place_on(double u, std::size_t n) {
  const double x = std::clamp(u, 0.0, 1.0) * static_cast<double>(n - 1);
  const std::size_t index = std::min(static_cast<std::size_t>(x), n - 2);
  return {index, x - static_cast<double>(index)};
}

/// The same among values in ascending order; beyond their ends, at these.
Place place_among(const std::vector<float>& values, double x) {
  if (values.size() == 1) return {0, 0};
  const auto above = std::upper_bound(values.begin() + 1, values.end() - 1, x);
  const auto index = static_cast<std::size_t>(above - values.begin()) - 1;
  const double from = values[index], to = values[index + 1];
  return {index, std::clamp((x - from) / (to - from), 0.0, 1.0)};
}

double between(double t, double a, double b) { return (1 - t) * a + t * b; }

Vec2 square_of(double theta, double phi) {
  const double turn = (phi + pi) / (2 * pi);
  return {std::sqrt(theta * (2 / pi)), turn - std::floor(turn)};
}

double theta_of(const Direction& d) { return std::atan2(std::hypot(d.x, d.y), d.z); }

/// Grids of one size that follow each other.
struct Grids {
  std::size_t nx, ny;
  std::vector<float> values;
  Bilinear bilinear() && { return {nx, ny, std::move(values)}; }
};

/// Of at least two by two. \throws InputError
Grids grids_of(TensorFile& file, const std::string& name, std::size_t dimensions, bool may_be_negative) {
  const auto& shape = file.shape(name, dimensions);
  const std::size_t nx = shape[dimensions - 1], ny = shape[dimensions - 2];
  if (nx < 2 || ny < 2)
    file.fail("found the array \"" + name + "\" of " + std::to_string(ny) + " rows of " + std::to_string(nx) +
              "; accepted: 2 or more of each");
  std::vector<float> values = file.floats(name);
  if (const auto least = std::ranges::min_element(values); !may_be_negative && least != values.end() && *least < 0)
    file.fail("found " + format_number(static_cast<double>(*least)) + " in the array \"" + name +
              "\"; accepted: a number >= 0");
  return {nx, ny, std::move(values)};
}

/// Whether the array has a grid for each direction. \throws InputError
void require_slices(const TensorFile& file, const std::string& name, const std::vector<std::size_t>& shape,
                    std::size_t phis, std::size_t thetas) {
  if (shape[0] != phis || shape[1] != thetas)
    file.fail("found the array \"" + name + "\" for " + std::to_string(shape[0]) + " phi_i and " +
              std::to_string(shape[1]) + " theta_i; accepted: " + std::to_string(phis) + " and " +
              std::to_string(thetas) + ", as many as there are");
}

} // namespace

double Bilinear::at(const Vec2& u, std::size_t slice) const {
  const Place x = place_on(u[0], nx_), y = place_on(u[1], ny_);
  const float* low = row(slice, y.index) + x.index;
  const float* high = low + nx_;
  return between(y.t, between(x.t, low[0], low[1]), between(x.t, high[0], high[1]));
}

void RglTable::check_axes(const TensorFile& file) {
  for (const auto& [name, values] : {std::pair{"phi_i", &phi_i_}, std::pair{"theta_i", &theta_i_}}) {
    const bool ascending = std::ranges::adjacent_find(*values, std::greater_equal<>()) == values->end();
    if (values->empty() || !ascending)
      file.fail(std::string("found the array \"") + name + "\" without or with values that do not ascend");
  }
  if (theta_i_.front() < 0 || static_cast<double>(theta_i_.back()) > 0.5 * pi + 1e-6)
    file.fail("found theta_i from " + format_number(static_cast<double>(theta_i_.front())) + " to " +
              format_number(static_cast<double>(theta_i_.back())) + "; accepted: within [0, pi/2]");
  relative_ = phi_i_.size() <= 2;
  if (relative_) return;
  const double from = phi_i_.front(), to = phi_i_.back();
  middle_ = 0.5 * (from + to);
  copies_ = static_cast<int>(std::lround(2 * pi / (to - from)));
  const bool known = copies_ == 1 || copies_ == 2 || copies_ == 4;
  if (!known || std::fabs((to - from) * copies_ - 2 * pi) > 0.01)
    file.fail("found phi_i over " + format_number(to - from) + " rad; accepted: the circle, its half or its quarter");
}

void RglTable::normalise(const TensorFile& file, std::vector<float> values, std::size_t nx, std::size_t ny) {
  const std::size_t slices = values.size() / (nx * ny);
  row_sums_.resize(slices * ny);
  marginal_.resize(slices * ny);
  for (std::size_t slice = 0; slice < slices; ++slice) {
    float* const grid = &values[slice * nx * ny];
    double* const sums = &row_sums_[slice * ny];
    double total = 0;
    for (std::size_t y = 0; y < ny; ++y) {
      const float* row = grid + y * nx;
      sums[y] = 0;
      for (std::size_t x = 0; x + 1 < nx; ++x)
        sums[y] += 0.5 * (static_cast<double>(row[x]) + static_cast<double>(row[x + 1]));
      if (y > 0) total += 0.5 * (sums[y - 1] + sums[y]);
      marginal_[slice * ny + y] = total;
    }
    if (!(total > 0)) file.fail("found a slice of the array \"vndf\" that is 0 everywhere; accepted: a density");
    for (std::size_t k = 0; k < nx * ny; ++k) grid[k] = static_cast<float>(static_cast<double>(grid[k]) / total);
    for (std::size_t y = 0; y < ny; ++y) {
      sums[y] /= total;
      marginal_[slice * ny + y] /= total;
    }
  }
  vndf_ = {nx, ny, std::move(values)};
}

RglTable::Shares RglTable::shares(const Direction& omega_i) const {
  // pi and -pi are one azimuth, and only one of them may be in a half of the circle.
  const double from_middle = std::remainder(std::atan2(omega_i.y, omega_i.x) - middle_, 2 * pi);
  const Place p = place_among(phi_i_, middle_ + from_middle);
  const Place t = place_among(theta_i_, theta_of(omega_i));
  const std::size_t n = theta_i_.size();
  // Where an axis has one value, there is no next one, and its weight is 0.
  const std::size_t next_p = phi_i_.size() > 1 ? n : 0, next_t = n > 1 ? 1 : 0;
  const std::size_t first = p.index * n + t.index;
  return {Share{first, (1 - p.t) * (1 - t.t)}, Share{first + next_t, (1 - p.t) * t.t},
          Share{first + next_p, p.t * (1 - t.t)}, Share{first + next_p + next_t, p.t * t.t}};
}

Vec2 RglTable::place_of(const Direction& h, const Direction& omega_i) const {
  const double phi_i = relative_ ? std::atan2(omega_i.y, omega_i.x) : 0;
  return square_of(theta_of(h), std::atan2(h.y, h.x) - phi_i);
}

Vec2 RglTable::placed(const Direction& omega_i, const Vec2& u) const { return placed(shares(omega_i), u); }

Vec2 RglTable::placed(const Shares& shares, const Vec2& u) const {
  const std::size_t nx = vndf_.nx(), ny = vndf_.ny();
  const Place x = place_on(u[0], nx), y = place_on(u[1], ny);
  double before = 0, whole = 0; // of the row, up to the interval and to its end
  double left = 0, right = 0;   // its density at the ends of the interval
  double low = 0, high = 0, below = 0;
  for (const Share& share : shares) {
    if (share.weight == 0) continue;
    const float* a = vndf_.row(share.slice, y.index);
    const float* b = a + nx;
    const auto at = [&](std::size_t k) { return share.weight * between(y.t, a[k], b[k]); };
    double sum = -0.5 * at(0);
    for (std::size_t k = 0; k < x.index; ++k) sum += at(k);
    before += x.index > 0 ? sum + 0.5 * at(x.index) : 0;
    left += at(x.index);
    right += at(x.index + 1);
    const std::size_t row = share.slice * ny + y.index;
    low += share.weight * row_sums_[row];
    high += share.weight * row_sums_[row + 1];
    below += share.weight * marginal_[row];
  }
  whole = between(y.t, low, high);
  const double along = before + x.t * (left + 0.5 * x.t * (right - left));
  // A row that nothing is seen of has no distribution: any will do, since its measure is 0.
  return {whole > 0 ? std::clamp(along / whole, 0.0, 1.0) : u[0],
          std::clamp(below + y.t * (low + 0.5 * y.t * (high - low)), 0.0, 1.0)};
}

Rgb RglTable::value(const Direction& omega_i, const Direction& omega_o) const {
  Direction i = omega_i, o = omega_o;
  const double x = std::cos(middle_), y = std::sin(middle_);
  const auto flip = [](double& a, double& b) {
    a = -a;
    b = -b;
  };
  if (copies_ == 2 && i.x * x + i.y * y < 0) {
    flip(i.x, o.x);
    flip(i.y, o.y);
  }
  if (copies_ == 4 && i.x * x < 0) flip(i.x, o.x);
  if (copies_ == 4 && i.y * y < 0) flip(i.y, o.y);
  const Shares shared = shares(i);
  const Vec2 u = place_of(half_vector(o, i), i);
  const Vec2 s = placed(shared, u);
  const double factor = ndf_.at(u) / (4 * sigma_.at(square_of(theta_of(i), std::atan2(i.y, i.x))));
  Rgb out{};
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0;
    for (const Share& share : shared)
      if (share.weight != 0) sum += share.weight * rgb_.at(s, 3 * share.slice + c);
    out[c] = std::max(sum, 0.0) * factor;
  }
  return out;
}

RglTable read_rgl(const std::string& path) {
  TensorFile file(path);
  require_memory(static_cast<double>(file.size()), "the tensor file " + path);
  if (const int jacobian = file.byte("jacobian"); jacobian != 1)
    file.fail("found jacobian " + std::to_string(jacobian) + "; accepted: 1");
  RglTable table;
  file.shape("phi_i", 1);
  file.shape("theta_i", 1);
  table.phi_i_ = file.floats("phi_i");
  table.theta_i_ = file.floats("theta_i");
  table.check_axes(file);
  const std::size_t phis = table.phi_i_.size(), thetas = table.theta_i_.size();
  require_slices(file, "vndf", file.shape("vndf", 4), phis, thetas);
  require_slices(file, "rgb", file.shape("rgb", 5), phis, thetas);
  if (file.shape("rgb", 5)[2] != 3)
    file.fail("found " + std::to_string(file.shape("rgb", 5)[2]) + " channels in the array \"rgb\"; accepted: 3");
  table.ndf_ = grids_of(file, "ndf", 2, false).bilinear();
  Grids sigma = grids_of(file, "sigma", 2, false);
  if (std::ranges::find(sigma.values, 0.0F) != sigma.values.end())
    file.fail("found 0 in the array \"sigma\"; accepted: a number > 0");
  table.sigma_ = std::move(sigma).bilinear();
  table.rgb_ = grids_of(file, "rgb", 5, true).bilinear();
  Grids visible = grids_of(file, "vndf", 4, false);
  table.normalise(file, std::move(visible.values), visible.nx, visible.ny);
  return table;
}

} // namespace brdfplot
