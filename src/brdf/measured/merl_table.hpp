/// \file
/// Reflectance measured in the cells of half and difference angles, and its file.
#pragma once

#include "brdf/measured/merl_grid.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace brdfplot {

/// rho of three channels in each cell. Immutable; any number of threads.
class MerlTable {
public:
  /// `values`: channel c of cell k at [c * grid.cells() + k], 1/sr, none negative.
  MerlTable(const MerlGrid& grid, std::vector<double> values) : grid_(grid), values_(std::move(values)) {}

  const MerlGrid& grid() const { return grid_; }
  double value(std::size_t channel, std::size_t cell) const { return values_[channel * grid_.cells() + cell]; }

private:
  MerlGrid grid_;
  std::vector<double> values_;
};

/// Reads a MERL file: three int32, the numbers of cells along theta_h, theta_d and phi_d (MERL's own: 90, 90, 180; any
/// that are as many as the file has are read), and as many doubles for each of red, green and blue, all little-endian;
/// rho is 1/1500, 1.15/1500 and 1.66/1500 of them. The length has to be that of the header, and is looked at before
/// memory is taken. A negative number marks a cell that has no value since it is below the horizon; where pairs above
/// it reach into such a cell, there is no more light than below it: rho = 0. A cell that is wholly above the horizon
/// has to have a value.
/// \throws FileError: cannot be read, or there is no memory; InputError: the header or the length are wrong, a number
/// is not finite, or negative where it must not be.
MerlTable read_merl(const std::string& path);

/// What a table is to be made of: rho of one cell's sample() in three channels, of many at a time.
using MerlSampler = std::function<void(const std::vector<HalfDifference>& at, std::vector<std::array<double, 3>>& rho)>;

/// The bytes of a MERL file with rho at the sample() of every cell, -1 in the cells that are below the horizon.
/// \throws what `sample` does
std::string merl_bytes(const MerlGrid& grid, const MerlSampler& sample);

} // namespace brdfplot
