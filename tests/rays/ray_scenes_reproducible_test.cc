// Scenes of rays are the same bits on every platform.
#include <gtest/gtest.h>

#include <cstdint>

#include "tests/rays/made_ray_scene.h"
#include "tests/scene_hash.h"

namespace pitbench {
namespace {

template <class T>
std::uint64_t Hash(const RayScene<T>& s) {
  return HashOf({&s.a.x, &s.a.y, &s.a.z, &s.b.x, &s.b.y, &s.b.z, &s.c.x, &s.c.y,
                 &s.c.z, &s.origin.x, &s.origin.y, &s.origin.z, &s.direction.x,
                 &s.direction.y, &s.direction.z});
}

struct Golden {
  const char* name;
  RayLoop loop;
  std::uint64_t f32;
  std::uint64_t f64;
};

constexpr RayLoop kOneTriangle = RayLoop::kOneTriangleRays;
constexpr RayLoop kOneRay = RayLoop::kOneRay;
constexpr RayLoop kPairs = RayLoop::kRayPairs;

// There is no other source for these than the generators themselves; they are
// held here so that another platform or compiler, or a change of a generator,
// shows. Published numbers rest on these bits.
constexpr Golden kGolden[] = {
    {"rays_uniform:hit=50:bytes=4k:sets=fresh", kOneTriangle,
     0xf7462dbd1d2c27d9u, 0x3afb51b2b378ff2au},
    {"rays_uniform:hit=50:bytes=4k:sets=fresh", kOneRay, 0x4219a868360c6dedu,
     0xe344d7b781a77929u},
    {"rays_uniform:hit=50:bytes=4k:sets=fresh", kPairs, 0x423c3bfd400f5eceu,
     0x5231f4dca98df44bu},
    {"rays_near_edge:ulps=1", kOneTriangle, 0x74cfa401c633a43fu,
     0x2ec5dd32e6ab7c0au},
    {"rays_near_edge:ulps=1", kOneRay, 0xb8667a8b22cb222du,
     0x697ef188335d4c99u},
    {"rays_near_edge:ulps=1", kPairs, 0x5120c657245ba54cu, 0xa3f16598d251d04eu},
    {"rays_near_vertex:ulps=16", kOneTriangle, 0x84affda31f1e0372u,
     0x157adc5ef1264b40u},
    {"rays_near_vertex:ulps=16", kOneRay, 0x02c96fee3585a36du,
     0x29562f89505f0ad8u},
    {"rays_near_vertex:ulps=16", kPairs, 0x8c09f57df71bc401u,
     0x4bb5f320b59a517cu},
    {"rays_grazing:exponent=20", kOneTriangle, 0xe549ec82f7207993u,
     0xec5eaebc705e33deu},
    {"rays_grazing:exponent=20", kOneRay, 0xd55ccae50fbb76f6u,
     0x51f94b8f56f03d0cu},
    {"rays_grazing:exponent=20", kPairs, 0x565fc472d54e82c7u,
     0x1143be782b13551au},
    {"rays_needle:aspect=10", kOneTriangle, 0xa47f9da775cfd447u,
     0x39b4382bc3ee0a71u},
    {"rays_needle:aspect=10", kOneRay, 0xc34b4b0d7ac658b4u,
     0x091d981c3dc00df9u},
    {"rays_needle:aspect=10", kPairs, 0x786f0653e3688f46u, 0x369d3dd07066791cu},
    {"rays_far_origin:exponent=12", kOneTriangle, 0x43bfb9f0b85b0d24u,
     0xf515f7fb701cb719u},
    {"rays_far_origin:exponent=12", kOneRay, 0x0115f744a28a7cf0u,
     0x54dbae2408b69f1eu},
    {"rays_far_origin:exponent=12", kPairs, 0xb926145e49bf3346u,
     0xb0e6f938c3db1ae4u},
    {"rays_offset:ratio=8", kOneTriangle, 0x0b7d026649c1745eu,
     0x31551790897bef86u},
    {"rays_offset:ratio=8", kOneRay, 0x1f06e73c49ba5eb0u, 0xdbe3c9a9ad1f0954u},
    {"rays_offset:ratio=8", kPairs, 0x18e5a1584b8188d0u, 0x1843a3431c01f1f4u},
    {"rays_degenerate:kind=collinear", kOneTriangle, 0xe6534d60f2099aa0u,
     0xfa470748523e9514u},
    {"rays_degenerate:kind=collinear", kOneRay, 0xbfc7c8f770b143fbu,
     0xb5b93f44f2df1b6eu},
    {"rays_degenerate:kind=collinear", kPairs, 0xd6e533ec2058f6c0u,
     0x0171b59293b1a1c6u},
    {"rays_degenerate:kind=doubled", kOneTriangle, 0xcda8ca7ecb69e829u,
     0x269269888d1f9cebu},
    {"rays_degenerate:kind=doubled", kOneRay, 0xf156e3a4bdfa95dbu,
     0x6248e69a1b7c83d9u},
    {"rays_degenerate:kind=doubled", kPairs, 0xbeefbfc9c1804fd5u,
     0x35d830dcebd3651eu},
    {"rays_degenerate:kind=single", kOneTriangle, 0xe3a966575b7f37a6u,
     0x3438924a7d808e80u},
    {"rays_degenerate:kind=single", kOneRay, 0xc620b9d996ab2dc1u,
     0x8ffeabc34b3ff4c2u},
    {"rays_degenerate:kind=single", kPairs, 0xedbba882745c94bau,
     0x52239975da42c314u},
    {"rays_degenerate:kind=zero_direction", kOneTriangle, 0xc38463230c68e8b8u,
     0xc7f54360d2b11a5bu},
    {"rays_degenerate:kind=zero_direction", kOneRay, 0x78fd2ef064bd7a48u,
     0x7bae78c157d66c26u},
    {"rays_degenerate:kind=zero_direction", kPairs, 0x9eae21360065532bu,
     0xbd5248512d021223u},
    {"rays_degenerate:kind=parallel", kOneTriangle, 0x3c1f0ac8385b10ccu,
     0xa22aca8a7121d960u},
    {"rays_degenerate:kind=parallel", kOneRay, 0x5dacc32445889f32u,
     0x819be8013073e797u},
    {"rays_degenerate:kind=parallel", kPairs, 0xc692332b85b12326u,
     0x1e890dcf812df50eu},
    {"rays_special:kind=nan", kOneTriangle, 0xe6b7fe97d85e8436u,
     0x6f3afc8fba317224u},
    {"rays_special:kind=nan", kOneRay, 0x439b41ff8d973f79u,
     0xeba21efe25b10c42u},
    {"rays_special:kind=nan", kPairs, 0x8af426fc07dabf92u, 0xccf0f82079d38536u},
    {"rays_special:kind=infinite", kOneTriangle, 0x69e6102105c01bd6u,
     0xfed9724ee7e4fc07u},
    {"rays_special:kind=infinite", kOneRay, 0x4b7861cd09ba957cu,
     0x27683571ed867705u},
    {"rays_special:kind=infinite", kPairs, 0x75625099398212e5u,
     0xafbe1493675bf19fu},
    {"rays_special:kind=minus_zero", kOneTriangle, 0x56b2a08b8ffda1feu,
     0x13d1da98de0402a9u},
    {"rays_special:kind=minus_zero", kOneRay, 0xa00a8d5ae561ff02u,
     0x54dd70fb399515b2u},
    {"rays_special:kind=minus_zero", kPairs, 0x91058b7106b1a9a2u,
     0x1e27a1e18504cc9fu},
    {"rays_special:kind=subnormal", kOneTriangle, 0x76c1f4ebd3ff7780u,
     0xb272b1d9b48f1f4du},
    {"rays_special:kind=subnormal", kOneRay, 0xcb27e5ac83c8865eu,
     0x767593c10d5af6bbu},
    {"rays_special:kind=subnormal", kPairs, 0xa5ffb54e4cdd0d5du,
     0x7fc4427709c89d3au},
    {"rays_special:kind=largest", kOneTriangle, 0xb3fccd9a67afafd2u,
     0x8ddadc9413caca0cu},
    {"rays_special:kind=largest", kOneRay, 0xd09240573707d29bu,
     0x137fe2621f908315u},
    {"rays_special:kind=largest", kPairs, 0xd1260e61564728ecu,
     0xbb26d7f03b5a5504u},
    {"rays_icosphere:ulps=1", kOneTriangle, 0x40467a87272d9252u,
     0x5dda962249f36f4cu},
    {"rays_icosphere:ulps=1", kOneRay, 0x37f768fb230de2b1u,
     0xbe4ff9aa8ed1a5d5u},
    {"rays_icosphere:ulps=1", kPairs, 0x56a70055ab9303b6u, 0x082f2e503736403cu},
    {"rays_tiled_plane:ulps=1", kOneTriangle, 0xa7534a8debe8bdfbu,
     0x6aa080dbfd9b326eu},
    {"rays_tiled_plane:ulps=1", kOneRay, 0x5c47f98f931dbc57u,
     0x1616c83707a86a9bu},
    {"rays_tiled_plane:ulps=1", kPairs, 0xa90715972d3e424eu,
     0x575e8bdef8ab327du},
};

TEST(RayScenesReproducibleTest, SameNameAndSeedGiveTheSameBitsEverywhere) {
  constexpr SceneSize kSize{.groups = 40, .size = 67};
  for (const Golden& golden : kGolden) {
    const SceneSpec spec = ParseScene(golden.name);
    EXPECT_EQ(Hash(MakeRayScene<float>(spec, golden.loop, kSize, 1)),
              golden.f32)
        << golden.name << " " << Name(golden.loop) << " f32";
    EXPECT_EQ(Hash(MakeRayScene<double>(spec, golden.loop, kSize, 1)),
              golden.f64)
        << golden.name << " " << Name(golden.loop) << " f64";
  }
}

TEST(RayScenesReproducibleTest, AnotherSeedGivesOtherBits) {
  constexpr SceneSize kSize{.groups = 2, .size = 3};
  for (const Golden& golden : kGolden) {
    const SceneSpec spec = ParseScene(golden.name);
    EXPECT_NE(Hash(MakeRayScene<float>(spec, golden.loop, kSize, 1)),
              Hash(MakeRayScene<float>(spec, golden.loop, kSize, 2)))
        << golden.name;
  }
}

}  // namespace
}  // namespace pitbench
