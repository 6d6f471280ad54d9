// The maps say what the kernels say, and count it right.
#include "harness/measure/maps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/input/name_filter.h"

namespace pitbench {
namespace {

using nlohmann::json;

// RFC 4648, the other way round.
std::vector<std::uint8_t> FromBase64(const std::string& text) {
  const std::string digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  unsigned held = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    held = held << 6 | static_cast<unsigned>(digits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<std::uint8_t>(held >> bits & 255));
  }
  return bytes;
}

json OnlyUlpMap(const std::string& method) {
  const json maps = MakeMaps(NameFilter("/ulp_map/" + method + "/f64/"));
  EXPECT_EQ(maps.at("gradients").size(), 0u);
  EXPECT_EQ(maps.at("ulp_maps").size(), 1u);
  return maps.at("ulp_maps").at(0);
}

// cross_product compares the rounded products of what (24, 24) − (−12, −12) and
// p − (−12, −12) round to. With ulp(12.5) = 16 ulps of p, the latter is (i, j)
// rounded to multiples of 16, ties to even: the wrong answers of a method
// without other rounding are the points that round onto the diagonal.
TEST(MapsTest, CrossProductLosesFourBitsOfThePoint) {
  std::size_t on_diagonal = 0;
  for (int i = 0; i < 256; ++i) {
    for (int j = 0; j < 256; ++j) {
      // 0.5 + i·2^-53 + 12 = 12.5 + i·2^-53, and ulp(12.5) is 2^-49.
      if (i != j && 12.5 + i * 0x1p-53 == 12.5 + j * 0x1p-53) ++on_diagonal;
    }
  }
  const json map = OnlyUlpMap("cross_product");
  const json& counts = map.at("counts");
  EXPECT_EQ(counts.at("false_inside"), on_diagonal);
  EXPECT_EQ(counts.at("false_outside"), 0);
  EXPECT_EQ(counts.at("boundary_accepted"), 2 * 256);
  EXPECT_EQ(counts.at("holes"), 0);
  EXPECT_EQ(counts.at("double_hits"), on_diagonal + 256);
}

TEST(MapsTest, BitsAreThoseThatWereCounted) {
  const json map = OnlyUlpMap("cross_product_det_fma");
  const std::vector<std::uint8_t> lower = FromBase64(map.at("lower"));
  const std::vector<std::uint8_t> upper = FromBase64(map.at("upper"));
  ASSERT_EQ(lower.size(), 256u * 32);
  ASSERT_EQ(upper.size(), 256u * 32);
  std::size_t false_inside = 0, false_outside = 0, boundary = 0;
  for (std::size_t j = 0; j < 256; ++j) {
    for (std::size_t i = 0; i < 256; ++i) {
      const auto bit = [&](const std::vector<std::uint8_t>& bytes) {
        return (bytes[32 * j + i / 8] >> (i % 8) & 1) != 0;
      };
      for (const auto& [said, holds] :
           {std::pair{bit(lower), i > j}, {bit(upper), i < j}}) {
        if (i == j) {
          boundary += said ? 1 : 0;
        } else if (said != holds) {
          ++(said ? false_inside : false_outside);
        }
      }
    }
  }
  EXPECT_EQ(map.at("counts").at("false_inside"), false_inside);
  EXPECT_EQ(map.at("counts").at("false_outside"), false_outside);
  EXPECT_EQ(map.at("counts").at("boundary_accepted"), boundary);
  EXPECT_GT(false_outside, 0u);
}

double Number(const json& hex) { return std::stod(hex.get<std::string>()); }

// The samples are the same but for a translation that f32 represents, and near
// the origin the weights are right to a few ulps.
TEST(MapsTest, GradientsHoldTheWeightsOfTheSamples) {
  const json maps = MakeMaps(
      NameFilter("one_triangle_weights/gradient:.*/barycentric_determinant/"));
  EXPECT_EQ(maps.at("ulp_maps").size(), 0u);
  ASSERT_EQ(maps.at("gradients").size(), 2u);
  const json& near = maps.at("gradients").at(0);
  const json& far = maps.at("gradients").at(1);
  EXPECT_EQ(near.at("scene"), "near_origin");
  EXPECT_EQ(far.at("scene"), "far_away");
  const double moved = Number(far.at("x0")) - Number(near.at("x0"));
  EXPECT_EQ(moved, 0x1p18);
  for (const char* vertex : {"a", "b", "c"}) {
    for (int axis = 0; axis < 2; ++axis) {
      const double x = Number(far.at(vertex).at(axis));
      EXPECT_EQ(x - Number(near.at(vertex).at(axis)), moved);
      EXPECT_EQ(static_cast<double>(static_cast<float>(x)), x);
    }
  }
  const std::vector<std::uint8_t> bytes = FromBase64(near.at("weights"));
  const std::size_t width = near.at("width");
  const std::size_t height = near.at("height");
  ASSERT_EQ(bytes.size(), width * height * 12);
  EXPECT_EQ(FromBase64(near.at("inside")).size(), width * height / 8);
  const double step = Number(near.at("step"));
  for (std::size_t sample = 0; sample < width * height; ++sample) {
    const double at[] = {
        Number(near.at("x0")) + static_cast<double>(sample % width) * step,
        Number(near.at("y0")) + static_cast<double>(sample / width) * step};
    float w[3];
    std::memcpy(w, &bytes[12 * sample], sizeof(w));
    EXPECT_NEAR(w[0] + w[1] + w[2], 1, 1e-6);
    for (int axis = 0; axis < 2; ++axis) {
      const double interpolated = w[0] * Number(near.at("a").at(axis)) +
                                  w[1] * Number(near.at("b").at(axis)) +
                                  w[2] * Number(near.at("c").at(axis));
      EXPECT_NEAR(interpolated, at[axis], 1e-5) << sample;
    }
  }
}

}  // namespace
}  // namespace pitbench
