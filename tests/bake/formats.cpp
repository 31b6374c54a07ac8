// The files of tables, read back by a few lines of each format's definition.
#include "bake/formats.hpp"
#include "base/errors.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

using namespace brdfplot;

namespace {

bake::BakedTable small_table() {
  return {{"m.json",
           "dfg",
           {{"cos_theta_o", 0, 1, 3, 2}, {"alpha", 0.1, 1, 2, 1}},
           {"scale", "bias"},
           {0.125, 0.25, 0.5, 0.75, 1, 0, 0.1, 0.2, 0.3, 0.4, 0.6, 0.7}},
          1e-6,
          {0.01, 0.02},
          {0.5, 0.5},
          0.05};
}

template <class Number>
Number number_at(const std::string& bytes, std::size_t offset) {
  Number number{};
  REQUIRE(offset + sizeof number <= bytes.size());
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

} // namespace

TEST_CASE("interpolation is exact at nodes and linear between them") {
  const bake::Table table = small_table().table;
  CHECK(table.interpolated({0.5, 0}) == std::vector<double>{0.5, 0.75});
  CHECK(table.interpolated({1, 1}) == std::vector<double>{0.6, 0.7});
  CHECK(table.interpolated({0.25, 0})[0] == doctest::Approx((0.125 + 0.5) / 2));
  CHECK(table.interpolated({0.25, 0.5})[1] == doctest::Approx((0.25 + 0.75 + 0.2 + 0.4) / 4));
  CHECK(table.interpolated({7, -7}) == std::vector<double>{1, 0});
}

TEST_CASE("a half is the nearest one, ties to even") {
  CHECK(bake::rounded(1 + 0x1p-11, bake::Stored::half) == 1);
  CHECK(bake::rounded(1 + 3 * 0x1p-11, bake::Stored::half) == 1 + 0x1p-9);
  CHECK(bake::rounded(0x1p-25, bake::Stored::half) == 0);
  CHECK(bake::rounded(1.5 * 0x1p-25, bake::Stored::half) == 0x1p-24);
  CHECK(bake::rounded(0x1.ffep-15, bake::Stored::half) == 0x1p-14); // the largest subnormal and half a step
  CHECK(bake::rounded(65504, bake::Stored::half) == 65504);
  for (int field = 0; field < 31; ++field)
    for (int fraction = 0; fraction < 1024; ++fraction) {
      const double value = field == 0 ? std::ldexp(fraction, -24) : std::ldexp(1 + fraction / 1024.0, field - 15);
      std::string bytes;
      bake::append_number(bytes, -value, bake::Stored::half);
      const auto bits = number_at<std::uint16_t>(bytes, 0);
      if (bits != (0x8000 | field << 10 | fraction)) FAIL(value);
      if (bake::rounded(value, bake::Stored::half) != value) FAIL(value);
    }
}

TEST_CASE("NumPy's file: header, shape, and the values in C order") {
  const bake::BakedTable table = small_table();
  const std::string bytes = bake::npy_bytes(table, bake::Stored::float64, "");
  CHECK(bytes.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
  const auto length = number_at<std::uint16_t>(bytes, 8);
  CHECK((10 + length) % 64 == 0);
  const std::string header = bytes.substr(10, length);
  CHECK(header.starts_with("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3, 2), }"));
  CHECK(header.back() == '\n');
  REQUIRE(bytes.size() == 10U + length + 12 * 8);
  for (std::size_t k = 0; k < 12; ++k) CHECK(number_at<double>(bytes, 10U + length + 8 * k) == table.table.values[k]);
  CHECK(bake::npy_bytes(table, bake::Stored::half, "").size() == 10U + length + 12 * 2);
}

TEST_CASE("KTX 2: the header, its index and the texels") {
  const bake::BakedTable table = small_table();
  const std::string bytes = bake::ktx2_bytes(table, bake::Stored::float32, "");
  CHECK(bytes.substr(0, 12) == std::string("\xABKTX 20\xBB\r\n\x1A\n", 12));
  const auto word = [&](std::size_t offset) { return number_at<std::uint32_t>(bytes, offset); };
  CHECK(word(12) == 103); // VK_FORMAT_R32G32_SFLOAT
  CHECK(word(16) == 4);
  CHECK(word(20) == 3);
  CHECK(word(24) == 2);
  CHECK(word(28) == 0);
  CHECK(word(36) == 1);
  CHECK(word(40) == 1);
  const std::size_t format = word(48), keys = word(56), keys_length = word(60);
  CHECK(format == 104);
  CHECK(word(format) == word(52)); // the descriptor says its own size
  CHECK(keys == format + word(52));
  const auto level = number_at<std::uint64_t>(bytes, 80), length = number_at<std::uint64_t>(bytes, 88);
  CHECK(level >= keys + keys_length);
  CHECK(level % 8 == 0);
  CHECK(length == 12 * 4);
  REQUIRE(bytes.size() == level + length);
  for (std::size_t k = 0; k < 12; ++k)
    CHECK(number_at<float>(bytes, level + 4 * k) == static_cast<float>(table.table.values[k]));
  // Keys and values fill what is said of them, each padded to 4 bytes.
  std::size_t at = keys;
  while (at < keys + keys_length) at += 4 + (word(at) + 3) / 4 * 4;
  CHECK(at == keys + keys_length);
  bake::BakedTable deep = table;
  deep.table.axes.resize(4, deep.table.axes[0]);
  CHECK_THROWS_AS(bake::ktx2_bytes(deep, bake::Stored::half, "t.ktx2"), InputError);
}

TEST_CASE("OpenEXR: the header, the offsets of its lines, and the values by channel") {
  const bake::BakedTable table = small_table();
  for (const bake::Stored stored : {bake::Stored::float32, bake::Stored::half}) {
    const std::string bytes = bake::exr_bytes(table, stored, "");
    const std::size_t size = stored == bake::Stored::half ? 2 : 4;
    CHECK(number_at<std::uint32_t>(bytes, 0) == 20000630);
    CHECK(number_at<std::uint32_t>(bytes, 4) == 2);
    // Fields until an empty name.
    std::size_t at = 8;
    std::string fields;
    while (bytes.at(at) != '\0') {
      const std::string name = bytes.c_str() + at;
      fields += name + " ";
      at += name.size() + 1;
      const std::string type = bytes.c_str() + at;
      at += type.size() + 1;
      const auto length = number_at<std::uint32_t>(bytes, at);
      at += 4;
      if (name == "dataWindow") CHECK(number_at<std::uint32_t>(bytes, at + 8) == 2);
      if (name == "dataWindow") CHECK(number_at<std::uint32_t>(bytes, at + 12) == 1);
      if (name == "channels") CHECK(bytes.substr(at, 2) == std::string("G\0", 2));
      if (name == "channels") CHECK(length == 2 * 18 + 1);
      at += length;
    }
    CHECK(fields == "brdfplot channels compression dataWindow displayWindow lineOrder pixelAspectRatio "
                    "screenWindowCenter screenWindowWidth ");
    ++at;
    for (std::size_t y = 0; y < 2; ++y) {
      const auto line = number_at<std::uint64_t>(bytes, at + 8 * y);
      CHECK(number_at<std::uint32_t>(bytes, line) == y);
      CHECK(number_at<std::uint32_t>(bytes, line + 4) == 6 * size);
      for (std::size_t x = 0; x < 3; ++x)
        for (const std::size_t c : {0U, 1U}) { // G, which is the second, stands first
          std::string expected;
          bake::append_number(expected, table.table.values[2 * (3 * y + x) + c], stored);
          CHECK(bytes.substr(line + 8 + size * (3 * (1 - c) + x), size) == expected);
        }
    }
    CHECK(bytes.size() == at + 2 * (8 + 8 + 6 * size));
  }
  bake::BakedTable deep = table;
  deep.table.axes.resize(3, deep.table.axes[0]);
  CHECK_THROWS_AS(bake::exr_bytes(deep, bake::Stored::half, "t.exr"), InputError);
}

TEST_CASE("the file's ending says the format") {
  CHECK(bake::format_of("a/b.ktx2").ending == ".ktx2");
  CHECK_THROWS_AS(bake::format_of("a/b.png"), InputError);
  CHECK(bake::csv_text(small_table(), bake::Stored::float64, "")
            .starts_with("cos_theta_o,alpha,scale,bias\n0,0.1,0.125,0.25\n"
                         "0.25,0.1,0.5,0.75\n"));
}
