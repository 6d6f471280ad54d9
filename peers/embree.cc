// Embree: rays against a scene of triangles, f32 only.
//
//   embree_single         rtcIntersect1, or rtcOccluded1 where nothing but
//                         whether a ray hits is asked
//   embree_packet4/8/16   the same of 4, 8 or 16 rays at once
//   …_robust              with RTC_SCENE_FLAG_ROBUST, which is there to
//                         close the gaps between triangles
//
// Embree looks triangles up in a tree of boxes (BVH). It is asked about scenes
// of one triangle, where that tree is one leaf, and in loop one_ray about a
// scene of all n triangles: that row alone of all rows does not look at every
// triangle. Loop ray_pairs has a scene an item and is there to be judged, not
// to be timed; each lane of a packet then has the same ray.
//
// Set-up: building the scene. It is no part of what is timed (KeptScenes);
// copying rays from our arrays into Embree's is.
//
// Embree must not be asked about NaN, infinity and what is beyond 1.844e18: its
// user has to look for those, so that is timed, and they are missed. Debian's
// Embree is compiled with its assertions, which cost it some time.
//
// Closed at edges; without the flag t_min itself is outside the range of t.
// Embree chooses an instruction set for itself, whatever this file is compiled
// for, and works with one thread here. The CPU's flags for subnormal numbers
// stay as they are (Embree would have them flushed).
#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "peers/libraries.h"
#include "peers/ray_rows.h"

namespace pitbench {
namespace {

// Lives as long as the program.
RTCDevice Device() {
  static const RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
  if (device == nullptr) throw std::runtime_error("Embree makes no device");
  return device;
}

struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Scene = std::shared_ptr<std::remove_pointer_t<RTCScene>>;

// The scene of n triangles from element `first` on.
Scene Build(const RayBatch<float>& in, std::size_t first, std::size_t n,
            bool robust) {
  Scene scene(rtcNewScene(Device()), ReleaseScene());
  if (robust) rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  const RTCGeometry geometry =
      rtcNewGeometry(Device(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertex = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                              RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * n));
  auto* index = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
                              RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), n));
  for (std::size_t i = first; i < first + n; ++i) {
    for (const Xyz<float>* corner : {&in.a, &in.b, &in.c}) {
      *vertex++ = corner->x[i];
      *vertex++ = corner->y[i];
      *vertex++ = corner->z[i];
    }
  }
  for (std::size_t k = 0; k < 3 * n; ++k) {
    index[k] = static_cast<std::uint32_t>(k);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene.get());
  return scene;
}

// Scenes by where their triangles lie, how many these are, and whether it is
// robust.
struct Kept {
  bool keeps = false;
  std::map<std::tuple<const float*, std::size_t, bool>, Scene> scenes;
};

Kept& AllKept() {
  static Kept kept;
  return kept;
}

Scene SceneOf(const RayBatch<float>& in, std::size_t n, bool robust) {
  Kept& kept = AllKept();
  if (!kept.keeps) return Build(in, 0, n, robust);
  Scene& scene = kept.scenes[{in.a.x, n, robust}];
  if (!scene) scene = Build(in, 0, n, robust);
  return scene;
}

// A number of lane k, of a packet or of the one ray.
template <class Field>
auto& Lane(Field& field, std::size_t k) {
  if constexpr (std::is_array_v<Field>) {
    return field[k];
  } else {
    (void)k;
    return field;
  }
}

template <int kLanes>
struct Rays;
template <>
struct Rays<1> {
  using WithHit = RTCRayHit;
  static void Intersect(const int* valid, RTCScene scene,
                        RTCIntersectContext* context, RTCRayHit* rays) {
    if (*valid != 0) rtcIntersect1(scene, context, rays);
  }
  static void Occluded(const int* valid, RTCScene scene,
                       RTCIntersectContext* context, RTCRay* rays) {
    if (*valid != 0) rtcOccluded1(scene, context, rays);
  }
};
template <>
struct Rays<4> {
  using WithHit = RTCRayHit4;
  static constexpr auto Intersect = rtcIntersect4;
  static constexpr auto Occluded = rtcOccluded4;
};
template <>
struct Rays<8> {
  using WithHit = RTCRayHit8;
  static constexpr auto Intersect = rtcIntersect8;
  static constexpr auto Occluded = rtcOccluded8;
};
template <>
struct Rays<16> {
  using WithHit = RTCRayHit16;
  static constexpr auto Intersect = rtcIntersect16;
  static constexpr auto Occluded = rtcOccluded16;
};

struct Nearest {
  PeerTuv<float> tuv;
  std::uint32_t triangle = RTC_INVALID_GEOMETRY_ID;
};

// What Embree takes for a number of a ray.
bool MayBeAsked(const RayBatch<float>& in, std::size_t i) {
  const auto sound = [](float x) { return std::abs(x) <= 1.844e18F; };
  return sound(in.origin.x[i]) & sound(in.origin.y[i]) & sound(in.origin.z[i]) &
         sound(in.direction.x[i]) & sound(in.direction.y[i]) &
         sound(in.direction.z[i]);
}

// kLanes rays of a batch against a scene.
template <int kLanes>
class Packet {
 public:
  Packet() { rtcInitIntersectContext(&context_); }

  // Ray first + k goes into lane k; lanes past `count` repeat the last ray and
  // are not valid. With `same`, ray `first` goes into all lanes.
  void Load(const RayBatch<float>& in, std::size_t first, std::size_t count,
            bool same) {
    auto& ray = rays_.ray;
    for (std::size_t k = 0; k < kLanes; ++k) {
      const std::size_t i = first + (same ? 0 : std::min(k, count - 1));
      valid_[k] = (same || k < count) && MayBeAsked(in, i) ? -1 : 0;
      Lane(ray.org_x, k) = in.origin.x[i];
      Lane(ray.org_y, k) = in.origin.y[i];
      Lane(ray.org_z, k) = in.origin.z[i];
      Lane(ray.dir_x, k) = in.direction.x[i];
      Lane(ray.dir_y, k) = in.direction.y[i];
      Lane(ray.dir_z, k) = in.direction.z[i];
      Lane(ray.tnear, k) = in.t_min;
      Lane(ray.tfar, k) = in.t_max;
      Lane(ray.time, k) = 0;
      Lane(ray.mask, k) = ~0U;
      Lane(ray.id, k) = 0;
      Lane(ray.flags, k) = 0;
    }
  }

  void Occluded(RTCScene scene) {
    Rays<kLanes>::Occluded(valid_.data(), scene, &context_, &rays_.ray);
  }
  bool WasOccluded(std::size_t k) {
    return Lane(rays_.ray.tfar, k) == -std::numeric_limits<float>::infinity();
  }

  void Intersect(RTCScene scene) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      Lane(rays_.hit.geomID, k) = RTC_INVALID_GEOMETRY_ID;
      Lane(rays_.hit.instID[0], k) = RTC_INVALID_GEOMETRY_ID;
    }
    Rays<kLanes>::Intersect(valid_.data(), scene, &context_, &rays_);
  }
  Nearest Hit(std::size_t k) {
    if (Lane(rays_.hit.geomID, k) == RTC_INVALID_GEOMETRY_ID) return {};
    return {
        {Lane(rays_.ray.tfar, k), Lane(rays_.hit.u, k), Lane(rays_.hit.v, k)},
        Lane(rays_.hit.primID, k)};
  }

 private:
  // What the packets ask for, 64 bytes at the most.
  alignas(64) std::array<int, kLanes> valid_ = {};
  alignas(64) typename Rays<kLanes>::WithHit rays_ = {};
  RTCIntersectContext context_;
};

template <int kLanes, bool kRobust, bool kWithTuv>
void OneTriangleRays(const RayBatch<float>& in, const RayResult<float>& out) {
  if (in.n == 0) return;
  const Scene scene = SceneOf(in, 1, kRobust);
  Packet<kLanes> packet;
  WriteHits<kWithTuv>(in.n, out, [&](std::size_t i, PeerTuv<float>& tuv) {
    const std::size_t lane = i % kLanes;
    if (lane == 0) {
      packet.Load(in, i, std::min<std::size_t>(kLanes, in.n - i), false);
      if constexpr (kWithTuv) {
        packet.Intersect(scene.get());
      } else {
        packet.Occluded(scene.get());
      }
    }
    if constexpr (!kWithTuv) return packet.WasOccluded(lane);
    const Nearest hit = packet.Hit(lane);
    tuv = hit.tuv;
    return hit.triangle != RTC_INVALID_GEOMETRY_ID;
  });
}

template <int kLanes, bool kRobust>
void RayPairs(const RayBatch<float>& in, const RayResult<float>& out) {
  Packet<kLanes> packet;
  WriteBits(in.n, out.bits, [&](std::size_t i) {
    const Scene scene = Build(in, i, 1, kRobust);
    packet.Load(in, i, 1, true);
    packet.Occluded(scene.get());
    return packet.WasOccluded(0);
  });
}

template <bool kRobust>
void OneRay(const RayBatch<float>& in, const RayResult<float>& out) {
  Nearest nearest;
  if (in.n != 0) {
    const Scene scene = SceneOf(in, in.n, kRobust);
    Packet<1> packet;
    packet.Load(in, 0, 1, false);
    packet.Intersect(scene.get());
    nearest = packet.Hit(0);
  }
  *out.t = nearest.tuv.t;
  *out.nearest = nearest.triangle == RTC_INVALID_GEOMETRY_ID ? kNoTriangle
                                                             : nearest.triangle;
}

template <int kLanes, bool kRobust>
void AddLanes(std::string_view key, std::string_view formula,
              std::vector<RayKernel>& rows) {
  using enum RayLoop;
  using enum RayOutput;
  const RayMethod method{.key = key, .source = "Embree", .formula = formula};
  AddRayPeerRow<float>(method, kOneTriangleRays, kHits,
                       OneTriangleRays<kLanes, kRobust, false>, rows);
  AddRayPeerRow<float>(method, kOneTriangleRays, kTuv,
                       OneTriangleRays<kLanes, kRobust, true>, rows);
  AddRayPeerRow<float>(method, kRayPairs, kHits, RayPairs<kLanes, kRobust>,
                       rows);
  if constexpr (kLanes == 1) {
    AddRayPeerRow<float>(method, kOneRay, kNearest, OneRay<kRobust>, rows);
  }
}

}  // namespace

KeptScenes::KeptScenes() { AllKept().keeps = true; }
KeptScenes::~KeptScenes() { AllKept() = {}; }

bool BuildsScenes(const RayKernel& kernel) {
  return kernel.method.key.starts_with("embree_");
}

PeerLibrary AddEmbreeRays(std::vector<RayKernel>& rows) {
  AddLanes<1, false>("embree_single", "rtcIntersect1, rtcOccluded1", rows);
  AddLanes<4, false>("embree_packet4", "rtcIntersect4, rtcOccluded4", rows);
  AddLanes<8, false>("embree_packet8", "rtcIntersect8, rtcOccluded8", rows);
  AddLanes<16, false>("embree_packet16", "rtcIntersect16, rtcOccluded16", rows);
  AddLanes<1, true>("embree_single_robust",
                    "rtcIntersect1, rtcOccluded1; a robust scene", rows);
  AddLanes<4, true>("embree_packet4_robust",
                    "rtcIntersect4, rtcOccluded4; a robust scene", rows);
  AddLanes<8, true>("embree_packet8_robust",
                    "rtcIntersect8, rtcOccluded8; a robust scene", rows);
  AddLanes<16, true>("embree_packet16_robust",
                     "rtcIntersect16, rtcOccluded16; a robust scene", rows);
  return {"embree", RTC_VERSION_STRING};
}

}  // namespace pitbench
