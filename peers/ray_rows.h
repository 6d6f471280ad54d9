// From a library's call to the rows of rays; as rows.h has it for points.
//
// A call is a class template over the scalar T:
//
//   template <class T>
//   struct Call {
//     explicit Call(const PeerTriangle3<T>& triangle);  // set-up
//     bool Hit(const PeerRay<T>& ray, PeerTuv<T>& tuv) const;
//   };
//
// A call that only tells whether a ray hits leaves tuv alone and has no rows
// that need it.
#ifndef PITBENCH_PEERS_RAY_ROWS_H_
#define PITBENCH_PEERS_RAY_ROWS_H_

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "kernels/rays/ray_kernels.h"
#include "peers/rows.h"

namespace pitbench {

template <class T>
struct PeerPoint3 {
  T x, y, z;

  PeerPoint3(const Xyz<T>& of, std::size_t i)
      : x(of.x[i]), y(of.y[i]), z(of.z[i]) {}
  bool IsFinite() const {
    return std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
  }
};

template <class T>
struct PeerTriangle3 {
  PeerPoint3<T> a, b, c;

  PeerTriangle3(const RayBatch<T>& in, std::size_t i)
      : a(in.a, i), b(in.b, i), c(in.c, i) {}
  bool IsFinite() const { return a.IsFinite() && b.IsFinite() && c.IsFinite(); }
};

template <class T>
struct PeerRay {
  PeerPoint3<T> origin, direction;

  PeerRay(const RayBatch<T>& in, std::size_t i)
      : origin(in.origin, i), direction(in.direction, i) {}
  bool IsFinite() const { return origin.IsFinite() && direction.IsFinite(); }
};

template <class T>
struct PeerTuv {
  static constexpr T kNone = std::numeric_limits<T>::quiet_NaN();
  T t = kNone;
  T u = kNone;
  T v = kNone;
};

// What is thrown, or was when the call was set up, is a miss.
template <class T, class Call>
bool PeerHit(const std::optional<Call>& call, const PeerRay<T>& ray,
             PeerTuv<T>& tuv) {
  return call && FalseIfThrown([&] { return call->Hit(ray, tuv); });
}

template <class T, template <class> class Call>
std::optional<Call<T>> SetUp(const RayBatch<T>& in, std::size_t i) {
  std::optional<Call<T>> call;
  FalseIfThrown([&] {
    call.emplace(PeerTriangle3<T>(in, i));
    return true;
  });
  return call;
}

// Writes answer i as `answer(i, tuv)` gives it.
template <bool kWithTuv, class T, class Answer>
void WriteHits(std::size_t n, const RayResult<T>& out, Answer answer) {
  WriteBits(n, out.bits, [&](std::size_t i) {
    PeerTuv<T> tuv;
    const bool hit = answer(i, tuv);
    if constexpr (kWithTuv) {
      if (!hit) tuv = {};
      out.t[i] = tuv.t;
      out.u[i] = tuv.u;
      out.v[i] = tuv.v;
    }
    return hit;
  });
}

template <class T, template <class> class Call, bool kWithTuv>
void PeerOneTriangleRays(const RayBatch<T>& in, const RayResult<T>& out) {
  const std::optional<Call<T>> call = SetUp<T, Call>(in, 0);
  WriteHits<kWithTuv>(in.n, out, [&](std::size_t i, PeerTuv<T>& tuv) {
    return PeerHit(call, PeerRay<T>(in, i), tuv);
  });
}

template <class T, template <class> class Call, bool kWithTuv>
void PeerRayPairs(const RayBatch<T>& in, const RayResult<T>& out) {
  WriteHits<kWithTuv>(in.n, out, [&](std::size_t i, PeerTuv<T>& tuv) {
    return PeerHit(SetUp<T, Call>(in, i), PeerRay<T>(in, i), tuv);
  });
}

template <class T, template <class> class Call>
void PeerOneRay(const RayBatch<T>& in, const RayResult<T>& out) {
  const PeerRay<T> ray(in, 0);
  T nearest = PeerTuv<T>::kNone;
  std::size_t at = kNoTriangle;
  for (std::size_t i = 0; i < in.n; ++i) {
    PeerTuv<T> tuv;
    if (!PeerHit(SetUp<T, Call>(in, i), ray, tuv)) continue;
    if (at != kNoTriangle && !(tuv.t < nearest)) continue;
    nearest = tuv.t;
    at = i;
  }
  *out.t = nearest;
  *out.nearest = at;
}

template <class T>
void AddRayPeerRow(const RayMethod& method, RayLoop loop, RayOutput output,
                   RayFunction<T> function, std::vector<RayKernel>& rows) {
  RayKernel row{.method = method,
                .scalar = ScalarOf<T>(),
                .isa = Isa::kLibrary,
                .loop = loop,
                .output = output};
  if constexpr (std::is_same_v<T, float>) {
    row.f32 = function;
  } else {
    row.f64 = function;
  }
  rows.push_back(row);
}

// The rows of a call that tells whether a ray hits.
template <class T, template <class> class Call>
void AddHitRows(const RayMethod& method, std::vector<RayKernel>& rows) {
  using enum RayLoop;
  using enum RayOutput;
  AddRayPeerRow<T>(method, kOneTriangleRays, kHits,
                   PeerOneTriangleRays<T, Call, false>, rows);
  AddRayPeerRow<T>(method, kRayPairs, kHits, PeerRayPairs<T, Call, false>,
                   rows);
}

// The rows of a call that tells where, too.
template <class T, template <class> class Call>
void AddTuvRows(const RayMethod& method, std::vector<RayKernel>& rows) {
  using enum RayLoop;
  using enum RayOutput;
  AddHitRows<T, Call>(method, rows);
  AddRayPeerRow<T>(method, kOneTriangleRays, kTuv,
                   PeerOneTriangleRays<T, Call, true>, rows);
  AddRayPeerRow<T>(method, kRayPairs, kTuv, PeerRayPairs<T, Call, true>, rows);
  AddRayPeerRow<T>(method, kOneRay, kNearest, PeerOneRay<T, Call>, rows);
}

}  // namespace pitbench

#endif  // PITBENCH_PEERS_RAY_ROWS_H_
