// Points uniform in the unit square; triangles that cover a given share of it.
//
// The share of points inside is then the hit rate, whatever the triangle. The
// points stay and the triangles change (fresh), so the arrays a call reads are
// as near in the caches as in the fixed twin and only the answers are new: a
// branch predictor cannot learn them.
#include <algorithm>
#include <array>
#include <cmath>

#include "harness/scenes/families.h"
#include "harness/scenes/uniform_sets.h"

namespace pitbench {
namespace {

// A convex polygon: a triangle cut by four lines has at most seven vertices.
class Polygon {
 public:
  Polygon() = default;
  explicit Polygon(const Triangle<double>& t) : at_{t.a, t.b, t.c}, size_(3) {}

  std::size_t size() const { return size_; }
  const Point<double>& operator[](std::size_t i) const { return at_[i]; }
  void Append(const Point<double>& p) { at_[size_++] = p; }

 private:
  std::array<Point<double>, 8> at_{};
  std::size_t size_ = 0;
};

// The part of `polygon` where sign·coordinate ≤ limit (Sutherland and Hodgman
// 1974).
Polygon Clip(const Polygon& polygon, double Point<double>::*coordinate,
             double sign, double limit) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point<double>& p = polygon[i];
    const Point<double>& q = polygon[(i + 1) % polygon.size()];
    const double before = limit - sign * p.*coordinate;
    const double after = limit - sign * q.*coordinate;
    if (before >= 0) kept.Append(p);
    if ((before < 0) != (after < 0)) {
      const double s = before / (before - after);
      kept.Append({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y)});
    }
  }
  return kept;
}

// The area that a triangle and the unit square share.
double CoveredArea(const Triangle<double>& t) {
  Polygon polygon(t);
  polygon = Clip(polygon, &Point<double>::x, 1, 1);
  polygon = Clip(polygon, &Point<double>::x, -1, 0);
  polygon = Clip(polygon, &Point<double>::y, 1, 1);
  polygon = Clip(polygon, &Point<double>::y, -1, 0);
  double double_area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point<double>& p = polygon[i];
    const Point<double>& q = polygon[(i + 1) % polygon.size()];
    double_area += p.x * q.y - p.y * q.x;
  }
  return std::abs(double_area) / 2;
}

// `t` scaled about its centroid, which is moved to `centre`.
Triangle<double> AtCentre(const Triangle<double>& t,
                          const Point<double>& centre, double scale) {
  const Point<double> centroid{(t.a.x + t.b.x + t.c.x) / 3,
                               (t.a.y + t.b.y + t.c.y) / 3};
  const auto place = [&](const Point<double>& p) -> Point<double> {
    return {centre.x + scale * (p.x - centroid.x),
            centre.y + scale * (p.y - centroid.y)};
  };
  return {place(t.a), place(t.b), place(t.c)};
}

}  // namespace

Triangle<double> Covering(Random& random, double share) {
  const Triangle<double> shape = WellShaped(random);
  const Point<double> centre = InUnitSquare(random);
  if (share <= 0) return AtCentre(shape, {centre.x + 3, centre.y}, 1);
  // The covered area grows with the scale: halve its interval, in the
  // geometric mean, until doubles tell no more.
  double low = 0x1p-10;
  double high = 0x1p10;
  for (int k = 0; k < 60; ++k) {
    const double middle = std::sqrt(low * high);
    const bool covers =
        CoveredArea(AtCentre(shape, centre, middle)) >= share - 1e-9;
    (covers ? high : low) = middle;
  }
  // 1 percent more where the whole square has to be inside, edges and all.
  return AtCentre(shape, centre, share >= 1 ? high * 1.01 : high);
}

template <class T>
Scene<T> UniformScene(const SceneSpec& spec, Loop loop, SceneSize /*size*/,
                      std::uint64_t seed) {
  const double share = static_cast<double>(spec.Number("hit", 0, 100)) / 100;
  Scene<T> scene{.name = spec.name, .loop = loop};
  AddUniformSets(
      spec, seed, {.point = 2 * sizeof(T), .triangle = 6 * sizeof(T)},
      [](Random& random) { return Rounded<T>(InUnitSquare(random)); },
      [share](Random& random) { return Rounded<T>(Covering(random, share)); },
      scene);
  return scene;
}

template Scene<float> UniformScene(const SceneSpec&, Loop, SceneSize,
                                   std::uint64_t);
template Scene<double> UniformScene(const SceneSpec&, Loop, SceneSize,
                                    std::uint64_t);

}  // namespace pitbench
