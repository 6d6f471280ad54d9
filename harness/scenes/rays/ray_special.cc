// Special values among the coordinates of triangles and rays.
//
// nan, infinite: one number of a quarter of the triangles and of half of the
// rays is replaced. minus_zero: vertices and origins on the axes and at 0,
// every zero with either sign. subnormal: lengths that are small multiples of
// the smallest number there is, directions as small or scaled up to a normal
// size. largest: coordinates up to the largest finite number, so that
// differences overflow.
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include "harness/scenes/rays/ray_families.h"
#include "harness/scenes/special_numbers.h"

namespace pitbench {
namespace {

// A well-shaped triangle and rays at points in it and around, of which some
// have one number replaced.
template <class T>
struct Replaced {
  bool nan;

  void Replace(Random& random, Point3<T>& p) const {
    T& replaced = Axis(p, random.Below(3));
    replaced = NotFinite<T>(random, nan);
  }
  Triangle3<T> Spoilt(Random& random, Triangle3<T> t) const {
    Point3<T>* const vertices[] = {&t.a, &t.b, &t.c};
    if (random.Below(4) == 0) Replace(random, *vertices[random.Below(3)]);
    return t;
  }
  Ray<T> Spoilt(Random& random, Ray<T> ray) const {
    if (random.Below(2) == 0) {
      Replace(random, random.Below(2) == 0 ? ray.origin : ray.direction);
    }
    return ray;
  }

  Triangle3<T> DrawTriangle(Random& random) const {
    return Spoilt(random, Rounded<T>(WellShaped3(random)));
  }
  Ray<T> DrawRay(Random& random) const {
    const Vector3 from = 3 * AnyDirection(random);
    return Spoilt(random, RayTo(from, Rounded<T>(InUnitCube(random))));
  }
  Ray<T> RayFor(Random& random, const Triangle3<T>&) const {
    return DrawRay(random);
  }
  Triangle3<T> TriangleFor(Random& random, const Ray<T>&) const {
    return DrawTriangle(random);
  }
};

// A family whose vertices and origins are drawn alike, by Numbers' `Draw`. Rays
// go to points at quarters of the edges, in the triangle or a quarter beside
// it; the direction is half of the way there, so that it is finite.
template <class T, class Numbers>
struct Drawn : Numbers {
  Point3<T> DrawOne(Random& random) const {
    const T x = this->Draw(random);
    const T y = this->Draw(random);
    return {x, y, this->Draw(random)};
  }
  // a/2 · u + b/2 · v + c/2 · w − o/2.
  static Point3<T> HalfWay(const Triangle3<T>& t, T u, T v,
                           const Point3<T>& o) {
    const auto at = [u, v](T a, T b, T c, T from) {
      return a / 2 * (1 - u - v) + b / 2 * u + c / 2 * v - from / 2;
    };
    return {at(t.a.x, t.b.x, t.c.x, o.x), at(t.a.y, t.b.y, t.c.y, o.y),
            at(t.a.z, t.b.z, t.c.z, o.z)};
  }
  static bool AllFinite(const Point3<T>& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  }

  Triangle3<T> DrawTriangle(Random& random) const {
    const Point3<T> a = DrawOne(random);
    const Point3<T> b = DrawOne(random);
    return {a, b, DrawOne(random)};
  }
  Ray<T> DrawRay(Random& random) const {
    const Point3<T> origin = DrawOne(random);
    return RayAlong(origin, this->Stretched(random, DrawOne(random)));
  }
  Ray<T> RayFor(Random& random, const Triangle3<T>& t) const {
    const Point3<T> origin = DrawOne(random);
    const T u = static_cast<T>(random.Below(5)) / 4;
    const T v = static_cast<T>(random.Below(5)) / 4;
    const Point3<T> along = HalfWay(t, u, std::min(v, T{1.25} - u), origin);
    return RayAlong(origin,
                    this->Stretched(random, AllFinite(along) ? along : origin));
  }
  // The ray's point at t = 2 is in the middle between c and the middle of ab.
  Triangle3<T> TriangleFor(Random& random, const Ray<T>& ray) const {
    Triangle3<T> t = DrawTriangle(random);
    const auto beyond = [](T o, T d, T a, T b) {
      return 2 * (o + 2 * d) - (a / 2 + b / 2);
    };
    const Point3<T> c = {beyond(ray.origin.x, ray.direction.x, t.a.x, t.b.x),
                         beyond(ray.origin.y, ray.direction.y, t.a.y, t.b.y),
                         beyond(ray.origin.z, ray.direction.z, t.a.z, t.b.z)};
    if (random.Below(4) != 0 && AllFinite(c)) t.c = c;
    return t;
  }
};

template <class T>
struct MinusZero {
  T Draw(Random& random) const { return EighthOrZero<T>(random); }
  Point3<T> Stretched(Random&, const Point3<T>& p) const { return p; }
};

// Multiples of 8 smallest numbers up to 32 times that: halves of quarters of
// them are numbers too.
template <class T>
struct Subnormal {
  T Draw(Random& random) const { return 8 * SmallestNumbers<T>(random); }
  // Half of all directions as they are, the others of a normal size.
  Point3<T> Stretched(Random& random, const Point3<T>& p) const {
    if (random.Below(2) == 0) return p;
    constexpr int kUp = std::numeric_limits<T>::digits -
                        std::numeric_limits<T>::min_exponent - 8;
    const auto up = [](T x) { return std::ldexp(x, kUp); };
    return {up(p.x), up(p.y), up(p.z)};
  }
};

template <class T>
struct Largest {
  T Draw(Random& random) const { return UpToLargest<T>(random); }
  Point3<T> Stretched(Random&, const Point3<T>& p) const { return p; }
};

}  // namespace

template <class T>
RayScene<T> RaysSpecialScene(const SceneSpec& spec, RayLoop loop,
                             SceneSize size, std::uint64_t seed) {
  const std::string_view kind = spec.Word(
      "kind", {"nan", "infinite", "minus_zero", "subnormal", "largest"});
  const auto assemble = [&](const auto& family) {
    return AssembleRays<T>(family, spec, loop, size, seed);
  };
  if (kind == "minus_zero") return assemble(Drawn<T, MinusZero<T>>{});
  if (kind == "subnormal") return assemble(Drawn<T, Subnormal<T>>{});
  if (kind == "largest") return assemble(Drawn<T, Largest<T>>{});
  return assemble(Replaced<T>{kind == "nan"});
}

PITBENCH_INSTANTIATE_RAYS(RaysSpecialScene);

}  // namespace pitbench
