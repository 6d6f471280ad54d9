// Loop one_ray: ray 0 against n triangles, of which the nearest one hit is
// wanted. Each lane keeps the nearest of its own, and no lane branches; in the
// end the lanes are compared.
#if defined(PITBENCH_KERNELS_RAYS_LOOPS_ONE_RAY_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_RAYS_LOOPS_ONE_RAY_INL_H_
#undef PITBENCH_KERNELS_RAYS_LOOPS_ONE_RAY_INL_H_
#else
#define PITBENCH_KERNELS_RAYS_LOOPS_ONE_RAY_INL_H_
#endif

#include "kernels/rays/loops/ray_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// A triangle and the t of its hit; kNoTriangle and NaN if there is none.
template <class T>
struct NearestHit {
  std::size_t triangle = kNoTriangle;
  T t = std::numeric_limits<T>::quiet_NaN();
};

// Takes the nearest of each lane into `nearest`; of several the first one.
// A lane without a hit has t = ∞. Lane indices count from `first`.
template <class D, class DI>
HWY_INLINE void TakeLanes(D d, Vec<D> t, DI di, Vec<DI> index,
                          std::size_t first, NearestHit<TFromD<D>>& nearest) {
  using T = TFromD<D>;
  HWY_ALIGN T lane_t[kMaxLanes<D>];
  HWY_ALIGN TFromD<DI> lane_index[kMaxLanes<D>];
  hn::Store(t, d, lane_t);
  hn::Store(index, di, lane_index);
  std::size_t best = 0;
  for (std::size_t k = 1; k < hn::Lanes(d); ++k) {
    if (lane_t[k] < lane_t[best] ||
        (lane_t[k] == lane_t[best] && lane_index[k] < lane_index[best])) {
      best = k;
    }
  }
  if (lane_t[best] == std::numeric_limits<T>::infinity()) return;
  if (nearest.triangle == kNoTriangle || lane_t[best] < nearest.t) {
    nearest.triangle = first + static_cast<std::size_t>(lane_index[best]);
    nearest.t = lane_t[best];
  }
}

template <template <class> class M, class T>
static void OneRay(const RayBatch<T>& batch, const RayResult<T>& result) {
  using D = Lanes<T>;
  const D d;
  const hn::RebindToSigned<D> di;
  using Index = TFromD<decltype(di)>;
  constexpr Turn kTurn = M<D>::kTurn;
  constexpr bool kTurnOnce = kTurn == Turn::kDirection;
  const RayBatch<T> b =
      TurnedAsFirst < kTurnOnce ? kTurn : Turn::kNone > (batch);
  const Range<T> range(b);
  const auto ray = FirstRay(b);
  const auto hits = [=](const auto& triangle, Vec<D>& t) HWY_ATTR {
    return WithTurned < kTurnOnce
               ? Turn::kNone
               : kTurn > (d, ValidTriangle(d, triangle), ray,
                          [&](const auto& turned, const auto& turned_ray)
                              HWY_ATTR {
                                auto u = Zero(d);
                                auto v = Zero(d);
                                return M<D>(d, turned).Hit(d, turned_ray, range,
                                                           t, u, v);
                              });
  };
  const std::size_t lanes = hn::Lanes(d);
  const auto step = Set(di, static_cast<Index>(lanes));
  constexpr std::size_t kBlock = std::size_t{1} << 30;  // its indices fit i32
  NearestHit<T> nearest;
  for (std::size_t first = 0; first < b.n; first += kBlock) {
    const std::size_t count = HWY_MIN(kBlock, b.n - first);
    auto best_t = Set(d, std::numeric_limits<T>::infinity());
    auto best = Zero(di);
    auto index = hn::Iota(di, Index{0});
    auto t = best_t;
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
      const auto hit = hits(LoadTriangles(d, b, first + i), t);
      const auto is_closer = AndLt(hit, t, best_t);
      best_t = IfThenElse(is_closer, t, best_t);
      best = IfThenElse(hn::RebindMask(di, is_closer), index, best);
      index = Add(index, step);
    }
    if (i < count) {
      const TrianglesTail<D> tail(b, first + i, count - i);
      const auto hit = And(hits(tail.In(d), t), hn::FirstN(d, count - i));
      const auto is_closer = AndLt(hit, t, best_t);
      best_t = IfThenElse(is_closer, t, best_t);
      best = IfThenElse(hn::RebindMask(di, is_closer), index, best);
    }
    TakeLanes(d, best_t, di, best, first, nearest);
  }
  *result.nearest = nearest.triangle;
  *result.t = nearest.t;
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
