// The calls into other libraries about rays: right where rounding cannot
// matter, with the boundary rule that they declare, and the scenes that are
// kept for them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "harness/measure/measured_kernels.h"
#include "harness/measure/rays/ray_accuracy.h"
#include "harness/measure/rays/ray_answers.h"
#include "peers/peers.h"
#include "tests/rays/ray_kernel_answers.h"

namespace pitbench {
namespace {

template <class T>
constexpr T kInfinity = std::numeric_limits<T>::infinity();

std::string NameOf(const testing::TestParamInfo<RayKernel>& info) {
  const RayKernel& kernel = info.param;
  return std::string(kernel.method.key) + "_" +
         std::string(Name(kernel.scalar)) + "_" +
         std::string(Name(kernel.loop, kernel.output));
}

class RayPeerTest : public testing::TestWithParam<RayKernel> {
 protected:
  template <class Test>
  static void WithScalar(const Test& test) {
    if (GetParam().scalar == Scalar::kF32) {
      test(float{});
    } else {
      test(double{});
    }
  }
};
INSTANTIATE_TEST_SUITE_P(Rows, RayPeerTest,
                         testing::ValuesIn(PeerRayKernels().begin(),
                                           PeerRayKernels().end()),
                         NameOf);

TEST_P(RayPeerTest, is_right_on_the_scene_on_which_it_is_timed) {
  WithScalar([]<class T>(T) {
    const RayScene<T> scene = MakeRayScene<T>(
        ParseScene("rays_uniform:hit=50:bytes=24k:sets=fixed"), GetParam().loop,
        {.groups = 16, .size = 67}, /*seed=*/1);
    const auto refusal =
        Refusal(GetParam(), scene, JudgeRays(scene, /*culls_backface=*/false));
    EXPECT_FALSE(refusal.has_value()) << *refusal;
  });
}

// Triangles on a small grid in planes of several slopes, and rays straight down
// and aslant to grid points: coordinates so small that no rounding is at work,
// a third of the answers on edges and vertices.
template <class T>
std::vector<Triangle3<T>> GridTriangles() {
  constexpr int kSide = 3;
  std::vector<Triangle3<T>> triangles;
  for (const int slope : {0, 1, -2}) {
    const auto at = [slope](int k) {
      const int x = k % kSide;
      const int y = k / kSide;
      return Point3<T>{static_cast<T>(x), static_cast<T>(y),
                       static_cast<T>(slope * x + y)};
    };
    for (int a = 0; a < kSide * kSide; ++a) {
      for (int b = 0; b < kSide * kSide; ++b) {
        for (int c = 0; c < kSide * kSide; ++c) {
          const auto cross = [](int p, int q, int r) {
            return (q % kSide - p % kSide) * (r / kSide - p / kSide) -
                   (q / kSide - p / kSide) * (r % kSide - p % kSide);
          };
          // A power of two: dividing by it is exact.
          const int area = std::abs(cross(a, b, c));
          if (area != 1 && area != 2 && area != 4) continue;
          triangles.push_back({at(a), at(b), at(c)});
        }
      }
    }
  }
  return triangles;
}

template <class T>
std::vector<Ray<T>> GridRays() {
  std::vector<Ray<T>> rays;
  for (int x = -1; x <= 3; ++x) {
    for (int y = -1; y <= 3; ++y) {
      for (const int aslant : {0, 1}) {
        rays.push_back({{static_cast<T>(x), static_cast<T>(y), T{16}},
                        {static_cast<T>(aslant), 0, T{-8}},
                        0,
                        kInfinity<T>});
      }
    }
  }
  return rays;
}

TEST_P(RayPeerTest, hits_edges_and_vertices_where_arithmetic_is_exact) {
  WithScalar([]<class T>(T) {
    std::vector<Triangle3<T>> triangles = GridTriangles<T>();
    std::vector<Ray<T>> rays = GridRays<T>();
    if (GetParam().output == RayOutput::kNearest) {
      // One triangle a call: which of several is nearest says nothing here.
      for (const Triangle3<T>& t : triangles) {
        for (const Ray<T>& ray : rays) {
          const RayPosition position = Classify(t, ray);
          ASSERT_EQ(Hits(GetParam(), t, ray),
                    position == RayPosition::kHit ||
                        position == RayPosition::kBoundary)
              << t << " " << ray;
        }
      }
      return;
    }
    std::size_t boundaries = 0;
    ForEachAnswer(
        GetParam(), SceneOfAll(GetParam().loop, triangles, rays),
        [&](const Triangle3<T>& t, const Ray<T>& ray,
            const RayAnswer<T>& answer) {
          const RayPosition position = Classify(t, ray);
          const bool boundary = position == RayPosition::kBoundary;
          boundaries += boundary ? 1u : 0u;
          ASSERT_EQ(answer.hit, boundary || position == RayPosition::kHit)
              << t << " " << ray;
        });
    EXPECT_GT(boundaries, triangles.size());
  });
}

TEST_P(RayPeerTest, t_u_and_v_are_those_of_the_hit_and_nan_without) {
  if (GetParam().output != RayOutput::kTuv) return;
  WithScalar([]<class T>(T) {
    ForEachAnswer(
        GetParam(),
        SceneOfAll(GetParam().loop, GridTriangles<T>(), GridRays<T>()),
        [&](const Triangle3<T>& t, const Ray<T>& ray,
            const RayAnswer<T>& answer) {
          if (!answer.hit) {
            for (const T x : answer.tuv) ASSERT_NE(x, x);
            return;
          }
          const auto exact = ExactTuv(t, ray);
          for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_NEAR(static_cast<double>(answer.tuv[k]), exact[k].get_d(),
                        8 * std::numeric_limits<T>::epsilon())
                << k << " of " << t << " " << ray;
          }
        });
  });
}

TEST_P(RayPeerTest, misses_nan_and_infinity) {
  WithScalar([]<class T>(T) {
    for (const T value :
         {std::numeric_limits<T>::quiet_NaN(), kInfinity<T>, -kInfinity<T>}) {
      for (std::size_t k = 0; k < 15; ++k) {
        std::array<T, 15> x = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 5, 0, 0, -1};
        x[k] = value;
        EXPECT_FALSE(Hits<T>(
            GetParam(),
            {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}},
            {{x[9], x[10], x[11]}, {x[12], x[13], x[14]}, 0, kInfinity<T>}))
            << value << " in coordinate " << k;
      }
    }
  });
}

// Of a batch that fills no packet.
TEST_P(RayPeerTest, sets_no_bit_past_the_last_answer) {
  if (GetParam().output == RayOutput::kNearest) return;
  WithScalar([]<class T>(T) {
    const RayScene<T> scene = SceneOfAll<T>(
        GetParam().loop, {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}},
        std::vector<Ray<T>>(21, {{1, 1, 5}, {0, 0, -1}, 0, kInfinity<T>}));
    for (std::size_t n = 0; n <= 21; ++n) {
      std::array<std::uint8_t, 4> bits = {0xAA, 0xAA, 0xAA, 0xAA};
      std::array<std::vector<T>, 3> tuv;
      for (auto& values : tuv) values.resize(22, T{7});
      FunctionOf<T>(GetParam())(scene.BatchOf({0, 0, n}), {.bits = bits.data(),
                                                           .t = tuv[0].data(),
                                                           .u = tuv[1].data(),
                                                           .v = tuv[2].data()});
      for (std::size_t i = 0; i < 8 * BitBytes(n); ++i) {
        ASSERT_EQ(bits[i / 8] >> (i % 8) & 1, i < n ? 1 : 0)
            << i << " of " << n;
      }
      for (std::size_t byte = BitBytes(n); byte < bits.size(); ++byte) {
        ASSERT_EQ(bits[byte], 0xAA) << "n = " << n;
      }
      for (const auto& values : tuv) ASSERT_EQ(values[n], 7) << "n = " << n;
    }
  });
}

// Where a library keeps nothing, a changed triangle is seen at once.
TEST_P(RayPeerTest, keeps_scenes_as_long_as_they_are_wanted_and_no_longer) {
  const bool keeps =
      BuildsScenes(GetParam()) && GetParam().loop != RayLoop::kRayPairs;
  WithScalar([keeps]<class T>(T) {
    RayScene<T> scene =
        SceneOfAll<T>(GetParam().loop, {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}},
                      {{{1, 1, 5}, {0, 0, -1}, 0, kInfinity<T>}});
    const auto hits = [&scene] { return AskRays(GetParam(), scene)[0][0].hit; };
    const auto move = [&scene](T by) {
      for (auto* of : {&scene.a, &scene.b, &scene.c}) of->x[0] += by;
    };
    {
      const KeptIndexes kept;
      EXPECT_TRUE(hits());
      move(64);
      EXPECT_EQ(hits(), keeps);
    }
    EXPECT_FALSE(hits());
    move(-64);
    EXPECT_TRUE(hits());
    {
      const KeptIndexes kept;
      move(64);
      EXPECT_FALSE(hits()) << "kept from the time before";
    }
  });
}

TEST(RayPeersTest, robust_scenes_leak_nowhere_on_a_closed_sphere) {
  const RayScene<float> scene = MakeRayScene<float>(
      ParseScene("rays_icosphere:ulps=0"), RayLoop::kRayPairs,
      {.groups = 2, .size = 67}, /*seed=*/1);
  std::vector<const RayKernel*> robust;
  for (const RayKernel& kernel : PeerRayKernels()) {
    if (kernel.loop == RayLoop::kRayPairs &&
        kernel.method.key.ends_with("_robust")) {
      robust.push_back(&kernel);
    }
  }
  ASSERT_EQ(robust.size(), 4u);
  for (const auto& cell : MeasureRayAccuracyOn(scene, robust)) {
    EXPECT_GT(cell["classes"]["hole"]["of"], 0) << cell["name"];
    EXPECT_EQ(cell["classes"]["hole"]["count"], 0) << cell["name"];
  }
}

TEST(RayPeersTest, the_build_measures_them_behind_its_own_kernels) {
  const auto measured = MeasuredRayKernels();
  ASSERT_EQ(measured.size(), AllRayKernels().size() + PeerRayKernels().size());
  for (const RayKernel& kernel : AllRayKernels()) {
    EXPECT_NE(kernel.isa, Isa::kLibrary) << kernel.method.key;
    EXPECT_TRUE(MayBeTimed(kernel)) << kernel.method.key;
  }
  for (const RayKernel& kernel : measured.last(PeerRayKernels().size())) {
    EXPECT_EQ(kernel.isa, Isa::kLibrary) << kernel.method.key;
  }
}

TEST(RayPeersTest, every_row_names_its_library_and_none_is_a_method_of_points) {
  for (const RayKernel& kernel : PeerRayKernels()) {
    std::size_t of = 0;
    for (const PeerLibrary& library : PeerLibraries()) {
      of += kernel.method.key.starts_with(std::string(library.name) + "_");
    }
    EXPECT_EQ(of, 1u) << kernel.method.key;
    for (const Kernel& other : MeasuredKernels()) {
      EXPECT_NE(other.method.key, kernel.method.key);
    }
  }
}

}  // namespace
}  // namespace pitbench
