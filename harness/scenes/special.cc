// Special values among the coordinates of well-shaped triangles and points.
//
// nan, infinite: one coordinate of a quarter of the triangles and of half of
// the points is replaced. minus_zero: vertices and points on the axes and at
// the origin, every zero with either sign. subnormal: coordinates that are
// small multiples of the smallest number there is, alone and mixed with normal
// ones. largest: coordinates up to the largest finite number, so that
// differences overflow.
#include <string_view>

#include "harness/scenes/families.h"
#include "harness/scenes/special_numbers.h"
#include "harness/truth/orientation.h"

namespace pitbench {
namespace {

// A family of which points and vertices are drawn alike, and alone.
template <class T, class Family>
struct Independent : Family {
  Triangle<T> DrawTriangle(Random& random) const {
    while (true) {
      const Point<T> a = this->DrawPoint(random);
      const Point<T> b = this->DrawPoint(random);
      const Point<T> c = this->DrawPoint(random);
      if (Orientation(a, b, c) != 0) return {a, b, c};
    }
  }
  Point<T> PointFor(Random& random, const Triangle<T>&) const {
    return this->DrawPoint(random);
  }
  Triangle<T> TriangleFor(Random& random, const Point<T>&) const {
    return DrawTriangle(random);
  }
};

template <class T>
struct Replaced {
  bool nan;

  Triangle<T> DrawTriangle(Random& random) const {
    Triangle<T> t = Rounded<T>(WellShaped(random));
    if (random.Below(4) != 0) return t;
    T* const coordinates[] = {&t.a.x, &t.a.y, &t.b.x, &t.b.y, &t.c.x, &t.c.y};
    T& replaced = *coordinates[random.Below(6)];
    replaced = NotFinite<T>(random, nan);
    return t;
  }
  Point<T> DrawPoint(Random& random) const {
    Point<T> p = Rounded<T>(InUnitSquare(random));
    if (random.Below(2) == 0) return p;
    T& replaced = random.Below(2) == 0 ? p.x : p.y;
    replaced = NotFinite<T>(random, nan);
    return p;
  }
  Point<T> PointFor(Random& random, const Triangle<T>&) const {
    return DrawPoint(random);
  }
  Triangle<T> TriangleFor(Random& random, const Point<T>&) const {
    return DrawTriangle(random);
  }
};

template <class T>
struct MinusZero {
  Point<T> DrawPoint(Random& random) const {
    const T x = EighthOrZero<T>(random);
    return {x, EighthOrZero<T>(random)};
  }
};

template <class T>
struct Subnormal {
  // Most are small, so that most triangles are; the others normal in both
  // coordinates or in one.
  Point<T> DrawPoint(Random& random) const {
    const Point<T> normal = Rounded<T>(InUnitSquare(random));
    const T x = SmallestNumbers<T>(random);
    Point<T> p = {x, SmallestNumbers<T>(random)};
    switch (random.Below(16)) {
      case 0:
        p = normal;
        break;
      case 1:
        p.x = normal.x;
        break;
      case 2:
        p.y = normal.y;
        break;
      default:
        break;
    }
    return p;
  }
};

template <class T>
struct Largest {
  Point<T> DrawPoint(Random& random) const {
    const T x = UpToLargest<T>(random);
    return {x, UpToLargest<T>(random)};
  }
};

}  // namespace

template <class T>
Scene<T> SpecialScene(const SceneSpec& spec, Loop loop, SceneSize size,
                      std::uint64_t seed) {
  const std::string_view kind = spec.Word(
      "kind", {"nan", "infinite", "minus_zero", "subnormal", "largest"});
  const auto assemble = [&](const auto& family) {
    return Assemble<T>(family, spec, loop, size, seed);
  };
  if (kind == "minus_zero") return assemble(Independent<T, MinusZero<T>>{});
  if (kind == "subnormal") return assemble(Independent<T, Subnormal<T>>{});
  if (kind == "largest") return assemble(Independent<T, Largest<T>>{});
  return assemble(Replaced<T>{kind == "nan"});
}

template Scene<float> SpecialScene(const SceneSpec&, Loop, SceneSize,
                                   std::uint64_t);
template Scene<double> SpecialScene(const SceneSpec&, Loop, SceneSize,
                                    std::uint64_t);

}  // namespace pitbench
