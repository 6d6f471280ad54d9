#include "harness/truth/ray_truth.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "harness/truth/ray_integers.h"
#include "harness/truth/vector3.h"

namespace pitbench {
namespace {

// A number that is computed, and more than it can be off by.
struct Bounded {
  double value;
  double bound;

  std::optional<int> Sign() const {
    if (value > bound) return 1;
    if (-value > bound) return -1;
    return std::nullopt;
  }
};

// p·(q × r), where every component of p, q and r is a given number or the
// rounded difference of two.
//
// The bound. u = 2^-53, η = 2^-1075 (half the smallest subnormal). The exact
// determinant is a sum of six products; S is the sum of their magnitudes. On
// its way into `value` each meets eight roundings at most: three differences
// (which never underflow), q·r, the difference of two of those, p times it, and
// two sums. So without underflow
//   |value − exact| ≤ γ S,  γ = (1−u)^-8 − 1,
// and `size`, computed alike from magnitudes alone, is (1−u)^8 S or more:
//   |value − exact| ≤ γ (1−u)^-8 size < 9u · size.
// Where products underflow, q·r is off by η twice in each component, which p
// multiplies, and p times it by η in each: with P = |p.x| + |p.y| + |p.z|,
// `value` and `size` are off by less than 4 (1 + P) η = 2^-1073 (1 + P)
// besides. Together
//   |value − exact| < 9u · size + 2^-1072 (1 + P).
// The code has fl(16u · size) + fl(2^-1022 · (1 + P)), of which rounding takes
// a few u and one η: more than that.
// Overflow: no number on the way into `value` is larger than the one in its
// place on the way into `size`, which sums magnitudes (rounding is monotone).
// So what overflows makes the bound infinite or NaN, and no sign comes of it.
//
// Needs -ffp-contract=off and gradual underflow (no flush to zero).
Bounded Determinant(const Vector3& p, const Vector3& q, const Vector3& r) {
  constexpr double k16u = 8 * std::numeric_limits<double>::epsilon();
  const double yz = q.y * r.z;
  const double zy = q.z * r.y;
  const double zx = q.z * r.x;
  const double xz = q.x * r.z;
  const double xy = q.x * r.y;
  const double yx = q.y * r.x;
  const double px = std::abs(p.x);
  const double py = std::abs(p.y);
  const double pz = std::abs(p.z);
  const double size = px * (std::abs(yz) + std::abs(zy)) +
                      py * (std::abs(zx) + std::abs(xz)) +
                      pz * (std::abs(xy) + std::abs(yx));
  return {.value = p.x * (yz - zy) + p.y * (zx - xz) + p.z * (xy - yx),
          .bound = k16u * size +
                   std::numeric_limits<double>::min() * (1 + (px + py + pz))};
}

// height − limit · facing, which has the sign of (t − limit) · facing.
//
// The product is off by |limit| times what facing is off by, and by u of itself
// and η; the difference by u of itself. The product is at most (1 + u) ·
// |limit| times facing's `size`, so all of it is less than
//   9u · (height's size) + 10u · |limit| · (facing's size) + u |value|
// and as much for underflow as above, and u |value| is nothing beside `value`
// itself. The sum of the two bounds has 16u for 9u and for 10u.
Bounded Beyond(const Bounded& height, const Bounded& facing, double limit) {
  return {.value = height.value - limit * facing.value,
          .bound = height.bound + std::abs(limit) * facing.bound};
}

// What is known of the signs that decide.
struct Signs {
  std::optional<int> facing;
  std::array<std::optional<int>, 3> weights;
  std::optional<int> beyond_min;  // of (t − t_min) · facing
  std::optional<int> beyond_max;
};

// The sign of height − limit · facing, exactly.
template <class T>
int CompareExactly(RayIntegers& exact, T limit) {
  thread_local std::array<mpz_class, 1> scaled;
  thread_local mpz_class right;
  const int exponent = ScaleToIntegers<T, 1>({limit}, scaled);
  if (scaled[0] == 0) return sgn(exact.Height());
  right = exact.Facing() * scaled[0];
  const mpz_class& height = exact.Height();
  // height · 2^(length − direction) against right · 2^exponent.
  const int shift = exact.length() - exact.direction() - exponent;
  if (shift < 0) {
    right <<= static_cast<mp_bitcnt_t>(-shift);
    const int order = cmp(height, right);
    return (order > 0) - (order < 0);
  }
  const mpz_class left = height << static_cast<mp_bitcnt_t>(shift);
  const int order = cmp(left, right);
  return (order > 0) - (order < 0);
}

bool IsZero(IntegerVector v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

// The answer, from exact arithmetic where a sign is not known.
template <class T>
RayPosition Decide(const Triangle3<T>& triangle, const Ray<T>& ray,
                   const Signs& known) {
  thread_local RayIntegers exact;
  bool taken = false;
  const auto sign = [&](std::optional<int> own, const auto& exactly) -> int {
    if (own) return *own;
    if (!taken) exact.Take(triangle, ray);
    taken = true;
    return exactly();
  };
  const int facing = sign(known.facing, [] { return sgn(exact.Facing()); });
  if (facing == 0) {
    if (IsZero(exact.d())) return RayPosition::kDegenerate;
    for (std::size_t k = 0; k < 3; ++k) {
      if (exact.Normal(k) != 0) return RayPosition::kCoplanar;
    }
    return RayPosition::kDegenerate;
  }
  bool boundary = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const int weight =
        sign(known.weights[k], [k] { return sgn(exact.Weight(k)); });
    if (weight == -facing) return RayPosition::kMiss;
    boundary = boundary || weight == 0;
  }
  const int beyond_min = sign(
      known.beyond_min, [&ray] { return CompareExactly(exact, ray.t_min); });
  if (beyond_min == -facing) return RayPosition::kMiss;
  if (!std::isinf(ray.t_max)) {
    const int beyond_max = sign(
        known.beyond_max, [&ray] { return CompareExactly(exact, ray.t_max); });
    if (beyond_max == facing) return RayPosition::kMiss;
  }
  return boundary ? RayPosition::kBoundary : RayPosition::kHit;
}

}  // namespace

std::string_view Name(RayPosition position) {
  switch (position) {
    case RayPosition::kHit:
      return "hit";
    case RayPosition::kBoundary:
      return "boundary";
    case RayPosition::kMiss:
      return "miss";
    case RayPosition::kCoplanar:
      return "coplanar";
    case RayPosition::kDegenerate:
      return "degenerate";
  }
  return "unknown";
}

template <class T>
bool IsFinite(const Triangle3<T>& triangle, const Ray<T>& ray) {
  for (const Point3<T>* p :
       {&triangle.a, &triangle.b, &triangle.c, &ray.origin, &ray.direction}) {
    if (!std::isfinite(p->x) || !std::isfinite(p->y) || !std::isfinite(p->z)) {
      return false;
    }
  }
  return std::isfinite(ray.t_min) && !std::isnan(ray.t_max) &&
         ray.t_max != -std::numeric_limits<T>::infinity();
}

template <class T>
RayPosition ClassifyExactly(const Triangle3<T>& triangle, const Ray<T>& ray) {
  if (!IsFinite(triangle, ray)) return RayPosition::kMiss;
  return Decide(triangle, ray, {});
}

// One sign that is surely wrong makes a miss of it, whatever is not known of
// the others.
template <class T>
RayPosition Classify(const Triangle3<T>& triangle, const Ray<T>& ray) {
  if (!IsFinite(triangle, ray)) return RayPosition::kMiss;
  const Vector3 origin = Widened(ray.origin);
  const Vector3 d = Widened(ray.direction);
  const Vector3 vertex_a = Widened(triangle.a);
  const Vector3 e = Widened(triangle.b) - vertex_a;
  const Vector3 f = Widened(triangle.c) - vertex_a;
  const Bounded facing = Determinant(d, e, f);
  Signs known{.facing = facing.Sign()};
  // Without that sign nothing else says anything.
  if (!known.facing) return Decide(triangle, ray, known);

  const Vector3 a = vertex_a - origin;
  const Vector3 b = Widened(triangle.b) - origin;
  const Vector3 c = Widened(triangle.c) - origin;
  known.weights = {Determinant(d, b, c).Sign(), Determinant(d, c, a).Sign(),
                   Determinant(d, a, b).Sign()};
  for (const std::optional<int>& weight : known.weights) {
    if (weight && *weight != *known.facing) return RayPosition::kMiss;
  }
  const Bounded height = Determinant(a, e, f);
  known.beyond_min =
      Beyond(height, facing, static_cast<double>(ray.t_min)).Sign();
  if (known.beyond_min && *known.beyond_min != *known.facing) {
    return RayPosition::kMiss;
  }
  if (!std::isinf(ray.t_max)) {
    known.beyond_max =
        Beyond(height, facing, static_cast<double>(ray.t_max)).Sign();
    if (known.beyond_max && *known.beyond_max == *known.facing) {
      return RayPosition::kMiss;
    }
  }
  return Decide(triangle, ray, known);
}

template <class T>
bool IsFrontFacing(const Triangle3<T>& triangle, const Ray<T>& ray) {
  const Vector3 a = Widened(triangle.a);
  const std::optional<int> sign =
      Determinant(Widened(ray.direction), Widened(triangle.b) - a,
                  Widened(triangle.c) - a)
          .Sign();
  if (sign) return *sign < 0;
  thread_local RayIntegers exact;
  exact.Take(triangle, ray);
  return exact.Facing() < 0;
}

#define PITBENCH_INSTANTIATE(T)                                             \
  template bool IsFinite(const Triangle3<T>&, const Ray<T>&);               \
  template RayPosition ClassifyExactly(const Triangle3<T>&, const Ray<T>&); \
  template RayPosition Classify(const Triangle3<T>&, const Ray<T>&);        \
  template bool IsFrontFacing(const Triangle3<T>&, const Ray<T>&)
PITBENCH_INSTANTIATE(float);
PITBENCH_INSTANTIATE(double);
#undef PITBENCH_INSTANTIATE

}  // namespace pitbench
