#include "brdf/measured/merl_table.hpp"

#include "base/binary_file.hpp"
#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/threads/interrupt.hpp"

#include <cmath>
#include <cstdint>
#include <span>

namespace brdfplot {

namespace {

constexpr std::array<double, 3> scale = {1.0 / 1500, 1.15 / 1500, 1.66 / 1500};
constexpr std::array<const char*, 3> channel_names = {"red", "green", "blue"};

/// The numbers of cells, of which the file has exactly as many.
MerlGrid read_header(BinaryFile& file) {
  std::array<std::int32_t, 3> n{};
  file.read_numbers(std::span<std::int32_t>(n), "the header of a MERL file, three numbers of 4 bytes");
  const std::string found = "found " + std::to_string(n[0]) + " x " + std::to_string(n[1]) + " x " +
                            std::to_string(n[2]) + " cells in the header";
  constexpr std::uint64_t bytes_per_cell = 3 * sizeof(double);
  const std::uint64_t held = file.left() / bytes_per_cell;
  std::uint64_t fit = held; // by division, since products of what a header says can be too large
  bool positive = true;
  for (const std::int32_t side : n) {
    positive = positive && side > 0;
    fit = positive ? fit / static_cast<std::uint64_t>(side) : 0;
  }
  if (!positive) file.fail(found + "; accepted: numbers > 0");
  const MerlGrid grid{static_cast<std::size_t>(n[0]), static_cast<std::size_t>(n[1]), static_cast<std::size_t>(n[2])};
  if (fit != 1 || grid.cells() * bytes_per_cell != file.left())
    file.fail(found + ", in a file of " + std::to_string(file.size()) +
              " bytes; accepted: 12 bytes, and 24 a cell (90 x 90 x 180: 34992012)");
  return grid;
}

/// What is wrong with the number of a cell.
void check(const BinaryFile& file, const MerlGrid& grid, std::size_t channel, std::size_t index, double value) {
  if (value >= 0 && std::isfinite(value)) return;
  const MerlCell cell(grid, index);
  if (std::isfinite(value) && !cell.is_above()) return;
  file.fail("found " + format_number(value) + " for " + channel_names[channel] + " in the cell (theta_h " +
            std::to_string(cell.h) + ", theta_d " + std::to_string(cell.d) + ", phi_d " + std::to_string(cell.p) +
            "); accepted: a number >= 0" +
            (std::isfinite(value) ? ", a negative one only where the cell reaches below the horizon" : ""));
}

} // namespace

MerlTable read_merl(const std::string& path) {
  BinaryFile file(path);
  const MerlGrid grid = read_header(file);
  require_memory(static_cast<double>(file.left()), "the MERL file " + path);
  std::vector<double> values(3 * grid.cells());
  file.read_numbers(std::span(values), "the values");
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < grid.cells(); ++k) {
      double& value = values[c * grid.cells() + k];
      check(file, grid, c, k, value);
      value = std::max(value * scale[c], 0.0);
    }
  return {grid, std::move(values)};
}

std::string merl_bytes(const MerlGrid& grid, const MerlSampler& sample) {
  constexpr std::size_t most = 16384;
  std::string bytes;
  const auto append = [&](auto number) {
    auto raw = std::bit_cast<std::array<std::byte, sizeof(number)>>(number);
    if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(raw);
    for (const std::byte b : raw) bytes += static_cast<char>(b);
  };
  for (const std::size_t side : {grid.theta_h, grid.theta_d, grid.phi_d}) append(static_cast<std::int32_t>(side));
  std::vector<double> values(3 * grid.cells(), -1);
  std::vector<std::size_t> cells;
  std::vector<HalfDifference> at;
  std::vector<std::array<double, 3>> rho;
  const auto flush = [&] {
    throw_if_interrupted();
    sample(at, rho);
    for (std::size_t k = 0; k < cells.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c) values[c * grid.cells() + cells[k]] = rho[k][c] / scale[c];
    cells.clear();
    at.clear();
  };
  for (std::size_t k = 0; k < grid.cells(); ++k) {
    const MerlCell cell(grid, k);
    if (!cell.reaches_above()) continue;
    cells.push_back(k);
    at.push_back(cell.sample());
    if (cells.size() == most) flush();
  }
  flush();
  bytes.reserve(bytes.size() + values.size() * sizeof(double));
  for (const double value : values) append(value);
  return bytes;
}

} // namespace brdfplot
