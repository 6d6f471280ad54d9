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
Triangle<double> Placed(const Triangle<double>& t, const Point<double>& centre,
                        double scale) {
  const Point<double> centroid{(t.a.x + t.b.x + t.c.x) / 3,
                               (t.a.y + t.b.y + t.c.y) / 3};
  const auto place = [&](const Point<double>& p) -> Point<double> {
    return {centre.x + scale * (p.x - centroid.x),
            centre.y + scale * (p.y - centroid.y)};
  };
  return {place(t.a), place(t.b), place(t.c)};
}

// A random triangle that covers `share` of the unit square.
Triangle<double> Covering(Random& random, double share) {
  const Triangle<double> shape = WellShaped(random);
  const Point<double> centre = InUnitSquare(random);
  if (share <= 0) return Placed(shape, {centre.x + 3, centre.y}, 1);
  // The covered area grows with the scale: halve its interval, in the
  // geometric mean, until doubles tell no more.
  double low = 0x1p-10;
  double high = 0x1p10;
  for (int k = 0; k < 60; ++k) {
    const double middle = std::sqrt(low * high);
    const bool covers =
        CoveredArea(Placed(shape, centre, middle)) >= share - 1e-9;
    (covers ? high : low) = middle;
  }
  // 1 percent more where the whole square has to be inside, edges and all.
  return Placed(shape, centre, share >= 1 ? high * 1.01 : high);
}

}  // namespace

template <class T>
Scene<T> UniformScene(const SceneSpec& spec, Loop loop, SceneSize /*size*/,
                      std::uint64_t seed) {
  const auto bytes =
      static_cast<std::size_t>(spec.Number("bytes", 64, std::int64_t{1} << 32));
  const double share = static_cast<double>(spec.Number("hit", 0, 100)) / 100;
  const bool fresh = spec.Fresh();
  const std::size_t item_bytes = loop == Loop::kOneTriangle ? 2 * sizeof(T)
                                 : loop == Loop::kOnePoint  ? 6 * sizeof(T)
                                                            : 8 * sizeof(T);
  const std::size_t n = std::max<std::size_t>(bytes / item_bytes, 1);
  // About a million different answers, or two sets where one is that large.
  const std::size_t most = loop == Loop::kPairs ? 32 : 256;
  const std::size_t sets =
      fresh ? std::clamp<std::size_t>((std::size_t{1} << 20) / n, 2, most) : 1;

  Scene<T> scene{.name = spec.name, .loop = loop};
  // The fixed twin draws the same numbers, so its set is the first fresh one.
  std::string drawn(Name(loop));
  drawn.append("/").append(spec.Drawn());
  Random points(SeedFor(drawn + "/points", seed));
  Random triangles(SeedFor(drawn + "/triangles", seed));
  // Pairs: set k pairs the triangles with the points from k cache lines on.
  const std::size_t shift = loop == Loop::kPairs ? 64 / sizeof(T) : 0;
  const std::size_t point_count =
      loop == Loop::kOnePoint ? sets : n + shift * (sets - 1);
  const std::size_t triangle_count = loop == Loop::kOneTriangle ? sets : n;
  for (std::size_t i = 0; i < point_count; ++i) {
    scene.Add(Rounded<T>(InUnitSquare(points)));
  }
  for (std::size_t i = 0; i < triangle_count; ++i) {
    scene.Add(Rounded<T>(Covering(triangles, share)));
  }
  for (std::size_t k = 0; k < sets; ++k) {
    const std::size_t triangle = loop == Loop::kOneTriangle ? k : 0;
    const std::size_t point = loop == Loop::kOnePoint ? k : shift * k;
    scene.calls.push_back({triangle, point, n});
  }
  return scene;
}

template Scene<float> UniformScene(const SceneSpec&, Loop, SceneSize,
                                   std::uint64_t);
template Scene<double> UniformScene(const SceneSpec&, Loop, SceneSize,
                                    std::uint64_t);

}  // namespace pitbench
