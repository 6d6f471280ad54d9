// Rays that make an angle of about 2^-exponent with the triangle's plane,
// whatever T is.
//
// Rounding would turn a ray drawn at random by 2^-24 in f32. So all of this is
// exact: the plane is z = α(x − x0) + β(y − y0), the direction (h, k, d) with
// α·h + β·k = 0, hence D·N = d for the normal N = (−α, −β, 1), and d is tiny.
// The ray meets the plane at z = 0, where the smallest numbers are left for the
// height of its origin: in (x0, y0) or from there in steps of (h, k). x and y
// are on the grid, α, β, h and k multiples of 1/16, |z| below 4. At last the
// axes are renamed.
#include <cmath>
#include <cstdint>

#include "harness/scenes/rays/ray_families.h"

namespace pitbench {
namespace {

template <class T>
struct Grazing {
  int exponent;
  double h = 0, k = 0;  // along the plane
  double x0 = 0, y0 = 0;
  std::size_t turn = 0;  // how the axes are renamed

  Point3<T> Turned(const Vector3& p) const {
    const double v[] = {p.x, p.y, p.z};
    return Rounded<T>(Vector3{v[turn], v[(turn + 1) % 3], v[(turn + 2) % 3]});
  }
  static Point<double> OnSquareGrid(const Point<double>& p) {
    return {OnGrid(p.x, kGridBits<T>), OnGrid(p.y, kGridBits<T>)};
  }

  void DrawFrame(Random& random) {
    turn = random.Below(3);
    double squared = 0;
    while (squared < 0.5 || squared > 2) {
      h = (static_cast<double>(random.Below(21)) - 10) / 8;
      k = (static_cast<double>(random.Below(21)) - 10) / 8;
      squared = h * h + k * k;
    }
    const Point<double> p = OnSquareGrid(InUnitSquare(random));
    x0 = p.x;
    y0 = p.y;
  }

  // A slope of ½ or 1 in (h, k); any well-shaped triangle that has (x0, y0) in
  // it, as seen along z.
  Triangle3<T> DrawInFrame(Random& random) const {
    const double slope = random.Below(2) == 0 ? 0.5 : 1.0;
    const double m = random.Below(2) == 0 ? slope : -slope;
    const Triangle<double> t = WellShaped(random);
    const double u = random.Unit();
    const double v = random.In(0, 1 - u);
    const Point<double> off =
        OnSquareGrid({t.a.x + u * (t.b.x - t.a.x) + v * (t.c.x - t.a.x),
                      t.a.y + u * (t.b.y - t.a.y) + v * (t.c.y - t.a.y)});
    const auto at = [&](const Point<double>& vertex) {
      const Point<double> p = OnSquareGrid(vertex);
      const double x = p.x - off.x;
      const double y = p.y - off.y;
      return Turned({x0 + x, y0 + y, m * (h * y - k * x)});
    };
    return {at(t.a), at(t.b), at(t.c)};
  }

  // Through (x0, y0, 0) and `steps` times (h, k, 0) beyond. |N| is 1.06 to 1.73
  // and the length of D that of (h, k) where d is small: 1.25 in the place of
  // |N| leaves the sine of the angle within 0.7 and 1.2 times 2^-exponent.
  Ray<T> RayInFrame(Random& random, double steps) const {
    const double length = OnGrid(1.25 * std::sqrt(h * h + k * k), 4);
    const double d =
        std::ldexp(random.Below(2) == 0 ? length : -length, -exponent);
    const double t = std::ldexp(1.0, static_cast<int>(random.Below(3)) - 1);
    return RayAlong(
        Turned({x0 + (steps - t) * h, y0 + (steps - t) * k, -t * d}),
        Turned({h, k, d}));
  }

  Triangle3<T> DrawTriangle(Random& random) {
    DrawFrame(random);
    return DrawInFrame(random);
  }
  Ray<T> DrawRay(Random& random) {
    DrawFrame(random);
    return RayInFrame(random, 0);
  }
  Ray<T> RayFor(Random& random, const Triangle3<T>&) const {
    const double steps = OnGrid(random.In(-0.5, 0.5), kGridBits<T> - 3);
    return RayInFrame(random, steps);
  }
  // Half of them are met beside their target.
  Triangle3<T> TriangleFor(Random& random, const Ray<T>&) const {
    Grazing moved = *this;
    if (random.Below(2) == 0) {
      const double steps = OnGrid(random.In(-1, 1), kGridBits<T> - 3);
      moved.x0 += steps * h;
      moved.y0 += steps * k;
    }
    return moved.DrawInFrame(random);
  }
};

}  // namespace

template <class T>
RayScene<T> RaysGrazingScene(const SceneSpec& spec, RayLoop loop,
                             SceneSize size, std::uint64_t seed) {
  const Grazing<T> family{static_cast<int>(spec.Number("exponent", 0, 60))};
  return AssembleRays<T>(family, spec, loop, size, seed);
}

PITBENCH_INSTANTIATE_RAYS(RaysGrazingScene);

}  // namespace pitbench
