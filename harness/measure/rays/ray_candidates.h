// What a hunt for rays tries; as candidates.h has it for 2D.
#ifndef PITBENCH_HARNESS_MEASURE_RAYS_RAY_CANDIDATES_H_
#define PITBENCH_HARNESS_MEASURE_RAYS_RAY_CANDIDATES_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "harness/measure/mutants.h"
#include "harness/scenes/rays/ray_families.h"

namespace pitbench {

// A, B, C, O and D, three coordinates each.
template <class T>
using RayCandidate = std::array<T, 15>;

template <class T>
Point3<T> PointAt(const RayCandidate<T>& c, std::size_t first) {
  return {c[first], c[first + 1], c[first + 2]};
}
template <class T>
Triangle3<T> TriangleOf(const RayCandidate<T>& c) {
  return {PointAt(c, 0), PointAt(c, 3), PointAt(c, 6)};
}
template <class T>
Ray<T> RayOf(const RayCandidate<T>& c) {
  return RayAlong(PointAt(c, 9), PointAt(c, 12));
}

// Whether it is one that ray_hunt.h allows.
template <class T>
bool Admissible(const RayCandidate<T>& c) {
  const auto is_large = [](T x) { return std::abs(x) >= static_cast<T>(0.5); };
  return AreConfined(c) && std::any_of(c.begin(), c.begin() + 12, is_large) &&
         std::any_of(c.begin() + 12, c.end(), is_large);
}

template <class T>
class RayCandidateSource {
 public:
  explicit RayCandidateSource(std::uint64_t seed)
      : random_(SeedFor("ray_hunt", seed)) {}

  // A ray aimed at an edge or the line of one, at a vertex or anywhere around a
  // triangle that is well shaped, a needle, or small where it lies, from
  // anywhere or almost from the triangle's plane. Not always admissible.
  RayCandidate<T> Draw() {
    const std::array<Point3<T>, 3> v = AnyTriangle();
    const Vector3 a = Widened(v[0]);
    const Vector3 to_b = Widened(v[1]) - a;
    const Vector3 to_c = Widened(v[2]) - a;
    double u = random_.In(-0.5, 1.5);
    double w = random_.In(-0.5, 1.5);
    const std::uint64_t aim = random_.Below(3);
    if (aim == 0) {
      u = random_.In(-0.1, 1.1);
      w = 0;
    }
    if (aim == 1) u = w = 0;
    const Point3<T> target = Nudged(Rounded<T>(a + u * to_b + w * to_c));
    const Point3<T> origin = Rounded<T>(
        random_.Below(2) == 0 ? Anywhere() : BesidePlane(target, to_b, to_c));
    const Point3<T> d = Towards(target, origin);
    RayCandidate<T> c;
    auto to = c.begin();
    for (const Point3<T>& p : {v[0], v[1], v[2], origin, d}) {
      for (const T x : {p.x, p.y, p.z}) *to++ = x;
    }
    return c;
  }

  // Not always admissible.
  RayCandidate<T> Mutant(const RayCandidate<T>& c) {
    return MutantOf<3>(c, random_);
  }

 private:
  Vector3 Anywhere() { return 2 * InUnitCube(random_) - Vector3{1, 1, 1}; }

  // In [−1, 1]³, of any size and altitude, beginning with any vertex.
  std::array<Point3<T>, 3> AnyTriangle() {
    const Triangle3<double> t = WellShaped3(random_);
    const double size = random_.Below(2) == 0 ? 1 : AnyLength<T>(random_);
    const double altitude = random_.Below(2) == 0 ? 1 : AnyLength<T>(random_);
    const Vector3 corner = Anywhere();
    const Vector3 along = t.b - t.a;
    const Vector3 foot = random_.Unit() * along;
    const Vector3 rise = t.c - t.a - foot;
    std::array<Point3<T>, 3> v = {
        Rounded<T>(corner), Rounded<T>(corner + size * along),
        Rounded<T>(corner + size * (foot + altitude * rise))};
    std::rotate(v.begin(), v.begin() + static_cast<int>(random_.Below(3)),
                v.end());
    return v;
  }

  // In two cases of three with a coordinate moved by some ulps.
  Point3<T> Nudged(Point3<T> p) {
    T* const axes[] = {&p.x, &p.y, &p.z};
    T& x = *axes[random_.Below(3)];
    if (random_.Below(3) != 0) x = Moved(x, AnyUlps<T>(random_));
    return p;
  }

  // Away from `target` along the triangle's plane, and off it by little.
  Vector3 BesidePlane(const Point3<T>& target, const Vector3& to_b,
                      const Vector3& to_c) {
    const Vector3 normal = Cross(to_b, to_c);
    const double length =
        std::max(Length(normal), std::numeric_limits<double>::min());
    const Vector3 away = AnyWay(random_, 0.1, 1);
    const double off = Dot(away, normal) / (length * length);
    const double height = AnyLength<T>(random_) / length;
    return Widened(target) + away + (height - off) * normal;
  }

  // The direction from `origin` to `target`, scaled by a power of two until its
  // largest coordinate is between 1/2 and 1; nudged, or as it rounds.
  Point3<T> Towards(const Point3<T>& target, const Point3<T>& origin) {
    Vector3 d = Widened(target) - Widened(origin);
    const double largest =
        std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    if (largest == 0) return {};
    d = std::ldexp(1.0, -std::ilogb(largest) - 1) * d;
    for (double* const x : {&d.x, &d.y, &d.z}) {
      if (std::abs(*x) < kLeastMagnitude) *x = 0;
    }
    return random_.Below(2) == 0 ? Nudged(Rounded<T>(d)) : Rounded<T>(d);
  }

  Random random_;
};

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_RAYS_RAY_CANDIDATES_H_
