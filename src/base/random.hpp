/// \file
/// Random numbers that depend on where they are asked for, not on when: the same for any number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace brdfplot {

/// Philox 4x32 with 10 rounds (Salmon et al. 2011, "Parallel random numbers: as easy as 1, 2, 3"): a bijection of the
/// 128-bit counter, chosen by the 64-bit key, whose values pass for random.
inline std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53} * counter[0];
    const std::uint64_t b = std::uint64_t{0xCD9E8D57} * counter[2];
    counter = {static_cast<std::uint32_t>(b >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(b),
               static_cast<std::uint32_t>(a >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(a)};
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  return counter;
}

/// A sequence of numbers, of which there is one for every seed and stream (a path, a pixel, a chunk of work).
class Random {
public:
  Random(std::uint64_t seed, std::uint64_t stream)
      : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)},
        stream_{static_cast<std::uint32_t>(stream), static_cast<std::uint32_t>(stream >> 32)} {}

  /// Uniform in (0, 1), ends excluded: an odd multiple of 2^-53.
  double uniform() { return (static_cast<double>(bits() >> 12) + 0.5) * 0x1p-52; }

  std::uint64_t bits() {
    if (left_ == 0) {
      const auto four = philox(
          {static_cast<std::uint32_t>(block_), static_cast<std::uint32_t>(block_ >> 32), stream_[0], stream_[1]}, key_);
      buffer_ = {four[0] | std::uint64_t{four[1]} << 32, four[2] | std::uint64_t{four[3]} << 32};
      ++block_;
      left_ = buffer_.size();
    }
    return buffer_[--left_];
  }

private:
  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 2> stream_;
  std::uint64_t block_ = 0;
  std::array<std::uint64_t, 2> buffer_{};
  std::size_t left_ = 0;
};

} // namespace brdfplot
