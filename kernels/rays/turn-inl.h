// The axes renamed, cyclically, so that a vector is largest along the last one.
//
// (x, y, z) become (y, z, x), (z, x, y) or stay; no handedness changes. Where
// one turn serves a whole call it is the arrays that are exchanged; else the
// coordinates are, lane by lane.
#if defined(PITBENCH_KERNELS_RAYS_TURN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_RAYS_TURN_INL_H_
#undef PITBENCH_KERNELS_RAYS_TURN_INL_H_
#else
#define PITBENCH_KERNELS_RAYS_TURN_INL_H_
#endif

#include "kernels/rays/ray_method-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// What a method wants to be largest along the last axis.
enum class Turn { kNone, kNormal, kDirection };

// In which lanes a vector is largest along x; and in which of the others it is
// along y.
template <class D, class Point>
HWY_INLINE void LargestAlong(D d, const Point& vector, Mask<D>& along_x,
                             Mask<D>& along_y) {
  const auto x = Abs(vector.x.In(d));
  const auto y = Abs(vector.y.In(d));
  const auto z = Abs(vector.z.In(d));
  along_x = And(Ge(x, y), Ge(x, z));
  along_y = Ge(y, z);
}

template <class D, class Point>
HWY_INLINE PointLanes<Held<D>> Turned(D d, const Point& p, Mask<D> along_x,
                                      Mask<D> along_y) {
  const auto x = p.x.In(d);
  const auto y = p.y.In(d);
  const auto z = p.z.In(d);
  return {Held<D>(d, IfThenElse(along_x, y, IfThenElse(along_y, z, x))),
          Held<D>(d, IfThenElse(along_x, z, IfThenElse(along_y, x, y))),
          Held<D>(d, IfThenElse(along_x, x, IfThenElse(along_y, y, z)))};
}

// use(triangle, ray), both turned.
template <Turn kTurn, class D, class Triangle, class Ray, class Use>
HWY_INLINE auto WithTurned(D d, const Triangle& t, const Ray& ray,
                           const Use& use) {
  if constexpr (kTurn == Turn::kNone) {
    return use(t, ray);
  } else {
    auto along_x = Ge(Zero(d), Zero(d));
    auto along_y = along_x;
    if constexpr (kTurn == Turn::kNormal) {
      LargestAlong(d, Normal<false>(d, t), along_x, along_y);
    } else {
      LargestAlong(d, ray.direction, along_x, along_y);
    }
    return use(TriangleLanes<Held<D>>{Turned(d, t.a, along_x, along_y),
                                      Turned(d, t.b, along_x, along_y),
                                      Turned(d, t.c, along_x, along_y)},
               RayLanes<Held<D>>{Turned(d, ray.origin, along_x, along_y),
                                 Turned(d, ray.direction, along_x, along_y)});
  }
}

template <class T>
HWY_INLINE Xyz<T> Turned(const Xyz<T>& p, bool along_x, bool along_y) {
  if (along_x) return {p.y, p.z, p.x};
  if (along_y) return {p.z, p.x, p.y};
  return p;
}

// The batch turned as its triangle 0 (kNormal) or its ray 0 (kDirection) wants
// it; of the other it reads nothing, as there may be none.
template <Turn kTurn, class T>
HWY_INLINE RayBatch<T> TurnedAsFirst(const RayBatch<T>& b) {
  RayBatch<T> turned = b;
  if constexpr (kTurn != Turn::kNone) {
    const OneLane<T> one;
    auto along_x = Ge(Zero(one), Zero(one));
    auto along_y = along_x;
    if constexpr (kTurn == Turn::kNormal) {
      LargestAlong(one, Normal<false>(one, FirstTriangle(b)), along_x, along_y);
    } else {
      LargestAlong(one, FirstPoint(b.direction), along_x, along_y);
    }
    for (Xyz<T>* p :
         {&turned.a, &turned.b, &turned.c, &turned.origin, &turned.direction}) {
      *p = Turned(*p, hn::AllTrue(one, along_x), hn::AllTrue(one, along_y));
    }
  }
  return turned;
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
