// What every ray method is written with: triangles and rays a lane, the range
// of t, products of vectors, and which triangles can be hit at all.
//
// A method is a class template over a Highway tag D, set up from one triangle
// a lane. Where D has one lane, its rays may come in any wider tag.
//
//   template <class D> class M {
//    public:
//     M(D d, const auto& triangle);          the set-up, from TriangleLanes
//     template <class E>
//     Mask<E> Hit(E e, const auto& ray, const Range<T>& range,
//                 Vec<E>& t, Vec<E>& u, Vec<E>& v) const;    from RayLanes
//   };
//
// t, u and v are what a hit has; without one they may be anything. The loops
// see to it that a triangle which can never be hit, being degenerate or not
// finite, has NaN for A's x, so that a method misses it by arithmetic. A ray
// that is not finite or has no direction is the method's affair.
//
// A method may ask for the axes to be renamed, cyclically, so that one of its
// choice is the last: kTurn says which (see turn-inl.h).
#if defined(PITBENCH_KERNELS_RAYS_RAY_METHOD_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_RAYS_RAY_METHOD_INL_H_
#undef PITBENCH_KERNELS_RAYS_RAY_METHOD_INL_H_
#else
#define PITBENCH_KERNELS_RAYS_RAY_METHOD_INL_H_
#endif

#include "kernels/method-inl.h"
#include "kernels/rays/ray_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// A vector of numbers as it was loaded: Held, but for a scalable vector it is
// where the numbers lie.
#if HWY_HAVE_SCALABLE
template <class D>
class Loaded {
 public:
  HWY_INLINE Loaded(D, const TFromD<D>* from) : from_(from) {}
  HWY_INLINE Vec<D> In(D d) const { return hn::LoadU(d, from_); }

 private:
  const TFromD<D>* from_;
};
#else
template <class D>
class Loaded : public Held<D> {
 public:
  HWY_INLINE Loaded(D d, const TFromD<D>* from)
      : Held<D>(d, InRegister(hn::LoadU(d, from))) {}
};
#endif

// A number for all lanes of any tag.
template <class T>
class Broadcast : public Held<OneLane<T>> {
 public:
  explicit HWY_INLINE Broadcast(T number)
      : Held<OneLane<T>>(OneLane<T>(), Set(OneLane<T>(), number)) {}
};

// H is Loaded, Broadcast or Held. A's x may be held in another way.
template <class H, class HX = H>
struct PointLanes {
  HX x;
  H y, z;
};
template <class H, class HX = H>
struct TriangleLanes {
  PointLanes<H, HX> a;
  PointLanes<H> b, c;
};
template <class H>
struct RayLanes {
  PointLanes<H> origin, direction;
};

// Element 0 of three arrays, and triangle 0 and ray 0, for all lanes.
template <class T>
HWY_INLINE PointLanes<Broadcast<T>> FirstPoint(const Xyz<T>& p) {
  return {Broadcast<T>(*p.x), Broadcast<T>(*p.y), Broadcast<T>(*p.z)};
}
template <class T>
HWY_INLINE TriangleLanes<Broadcast<T>> FirstTriangle(const RayBatch<T>& b) {
  return {FirstPoint(b.a), FirstPoint(b.b), FirstPoint(b.c)};
}
template <class T>
HWY_INLINE RayLanes<Broadcast<T>> FirstRay(const RayBatch<T>& b) {
  return {FirstPoint(b.origin), FirstPoint(b.direction)};
}

// The range of t as kernels compare with it: nothing that is not finite lies
// within, whatever the caller's t_max.
template <class T>
struct Range {
  T least, most;

  explicit HWY_INLINE Range(const RayBatch<T>& batch)
      : least(batch.t_min >= -std::numeric_limits<T>::max()
                  ? batch.t_min
                  : std::numeric_limits<T>::quiet_NaN()),
        most(batch.t_max > std::numeric_limits<T>::max()
                 ? std::numeric_limits<T>::max()
                 : batch.t_max) {}
};

// `mask` where t is within the range; false where t is NaN.
template <class E>
HWY_INLINE Mask<E> AndWithin(E e, Mask<E> mask, Vec<E> t,
                             const Range<TFromD<E>>& range) {
  return AndLe(AndGe(mask, t, Set(e, range.least)), t, Set(e, range.most));
}

// Where `value` is neither infinite nor NaN.
template <class E>
HWY_INLINE Mask<E> IsFinite(E e, Vec<E> value) {
  return Lt(Abs(value), Set(e, std::numeric_limits<TFromD<E>>::infinity()));
}

// `mask` where u ≥ 0, v ≥ 0 and u + v ≤ most; false where any is NaN. (Where
// only u is, so is the sum.)
template <class E>
HWY_INLINE Mask<E> AndInTriangle(E e, Mask<E> mask, Vec<E> u, Vec<E> v,
                                 Vec<E> most) {
  return AndLe(AndGe(mask, MinOrSecond(u, v), Zero(e)), Add(u, v), most);
}

// a·b. With kFma all but the first product go unrounded into the sum: what a
// compiler makes of it that may contract.
template <bool kFma, class V>
HWY_INLINE V Dot(V ax, V ay, V az, V bx, V by, V bz) {
  const V xy = SumOfProducts<kFma>(ay, by, ax, bx);
  if constexpr (kFma) {
    return MulAdd(az, bz, xy);
  } else {
    return Add(xy, Mul(az, bz));
  }
}

// a × b
template <bool kFma, class V>
HWY_INLINE void Cross(V ax, V ay, V az, V bx, V by, V bz, V& x, V& y, V& z) {
  x = DifferenceOfProducts<kFma>(ay, bz, az, by);
  y = DifferenceOfProducts<kFma>(az, bx, ax, bz);
  z = DifferenceOfProducts<kFma>(ax, by, ay, bx);
}

// (B − A) × (C − A)
template <bool kFma, class D, class Triangle>
HWY_INLINE PointLanes<Held<D>> Normal(D d, const Triangle& t) {
  const auto ax = t.a.x.In(d);
  const auto ay = t.a.y.In(d);
  const auto az = t.a.z.In(d);
  auto x = Zero(d);
  auto y = x;
  auto z = x;
  Cross<kFma>(Sub(t.b.x.In(d), ax), Sub(t.b.y.In(d), ay), Sub(t.b.z.In(d), az),
              Sub(t.c.x.In(d), ax), Sub(t.c.y.In(d), ay), Sub(t.c.z.In(d), az),
              x, y, z);
  return {Held<D>(d, x), Held<D>(d, y), Held<D>(d, z)};
}

// The triangle with NaN for A's x where it is degenerate or not finite. Not
// contracted, so that the products of parallel edges cancel. A coordinate that
// is infinite or NaN makes a component of the normal infinite or NaN.
template <class D, class H>
HWY_INLINE TriangleLanes<H, Held<D>> ValidTriangle(D d,
                                                   const TriangleLanes<H>& t) {
  const auto n = Normal<false>(d, t);
  const auto size = Add(Add(Abs(n.x.In(d)), Abs(n.y.In(d))), Abs(n.z.In(d)));
  return {
      {Held<D>(d, ValidOrNaN(d, size, t.a.x.In(d))), t.a.y, t.a.z}, t.b, t.c};
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
