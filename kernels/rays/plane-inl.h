// Where a ray meets the plane of a triangle, which has the same x·N everywhere.
#if defined(PITBENCH_KERNELS_RAYS_PLANE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_RAYS_PLANE_INL_H_
#undef PITBENCH_KERNELS_RAYS_PLANE_INL_H_
#else
#define PITBENCH_KERNELS_RAYS_PLANE_INL_H_
#endif

#include "kernels/rays/ray_method-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// a + t·b
template <bool kFma, class V>
HWY_INLINE V Along(V a, V t, V b) {
  if constexpr (kFma) {
    return MulAdd(t, b, a);
  } else {
    return Add(a, Mul(t, b));
  }
}

template <class D, bool kFma>
class Plane {
 public:
  template <class Triangle>
  HWY_INLINE Plane(D d, const Triangle& t)
      : n_(Normal<kFma>(d, t)),
        constant_(d, Dot<kFma>(n_.x.In(d), n_.y.In(d), n_.z.In(d), t.a.x.In(d),
                               t.a.y.In(d), t.a.z.In(d))) {}

  // t = (A·N − O·N) / (D·N). False where D·N is infinite or NaN: t then says
  // nothing. Where D·N is 0, t is infinite or NaN.
  template <class E, class Ray>
  HWY_INLINE Mask<E> Meet(E e, const Ray& ray, Vec<E>& t) const {
    const auto from =
        Dot<kFma>(n_.x.In(e), n_.y.In(e), n_.z.In(e), ray.origin.x.In(e),
                  ray.origin.y.In(e), ray.origin.z.In(e));
    const auto along =
        Dot<kFma>(n_.x.In(e), n_.y.In(e), n_.z.In(e), ray.direction.x.In(e),
                  ray.direction.y.In(e), ray.direction.z.In(e));
    t = Div(Sub(constant_.In(e), from), along);
    return IsFinite(e, along);
  }

  HWY_INLINE Vec<D> NormalZ(D d) const { return n_.z.In(d); }

 private:
  PointLanes<Held<D>> n_;
  Held<D> constant_;
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
