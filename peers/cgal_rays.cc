// CGAL: a Ray_3 and a Triangle_3.
//
//   cgal_do_intersect            do_intersect() of the kernel with exact
//                                predicates: whether they meet.
//   cgal_intersection            intersection() of the same kernel: the point
//                                in which they meet, rounded.
//   cgal_cartesian_do_intersect  the same two calls with Simple_cartesian: all
//   cgal_cartesian_intersection  in the scalar itself, rounded as it comes.
//
// A Ray_3 seems to be kept as two points, O and O + D (concluded from its
// errors in f64, not read in its source). That sum is a construction and
// rounds, so exact predicates are about a ray turned a little; of f32, which
// that kernel has as doubles, the sum is exact but for very unlike exponents.
//
// intersection() gives a point. From it t is worked out here along the largest
// axis of D, and u and v in the plane without the largest axis of the normal,
// in the scalar of CGAL's kernel; these roundings add to those of the point.
//
// Closed. CGAL wants neither degenerate triangles and rays nor NaN and
// infinity: those are asked about beforehand, as its user has to, and are
// misses. A ray in the plane of the triangle meets it by CGAL's rule: for
// do_intersect() that is a hit, while intersection() gives a segment, which is
// taken for a miss. No index: loop one_ray asks every triangle.
//
// Set-up: the Triangle_3.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/intersections.h>

#include <boost/variant/get.hpp>
#include <cmath>

#include "peers/libraries.h"
#include "peers/ray_rows.h"

namespace pitbench {
namespace {

using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Geometry, class T>
class Meeting {
 public:
  explicit Meeting(const PeerTriangle3<T>& t)
      : triangle_(At(t.a), At(t.b), At(t.c)),
        sound_(t.IsFinite() && !triangle_.is_degenerate()) {}

 protected:
  using Number = typename Geometry::FT;
  using Point = typename Geometry::Point_3;
  using Vector = typename Geometry::Vector_3;
  using Ray = typename Geometry::Ray_3;

  static Point At(const PeerPoint3<T>& p) { return {p.x, p.y, p.z}; }
  static Vector Along(const PeerPoint3<T>& d) { return {d.x, d.y, d.z}; }

  bool MayBeAsked(const PeerRay<T>& asked, const Ray& ray) const {
    return sound_ && asked.IsFinite() && !ray.is_degenerate();
  }

  typename Geometry::Triangle_3 triangle_;

 private:
  bool sound_;
};

template <class Geometry, class T>
class DoIntersect : Meeting<Geometry, T> {
 public:
  using Meeting<Geometry, T>::Meeting;

  bool Hit(const PeerRay<T>& asked, PeerTuv<T>& /*tuv*/) const {
    const typename Geometry::Ray_3 ray(this->At(asked.origin),
                                       this->Along(asked.direction));
    return this->MayBeAsked(asked, ray) &&
           CGAL::do_intersect(this->triangle_, ray);
  }
};

template <class Geometry, class T>
class Intersection : Meeting<Geometry, T> {
  using Base = Meeting<Geometry, T>;
  using typename Base::Number;
  using typename Base::Point;
  using typename Base::Vector;

 public:
  using Base::Base;

  bool Hit(const PeerRay<T>& asked, PeerTuv<T>& tuv) const {
    const Point origin = this->At(asked.origin);
    const Vector along = this->Along(asked.direction);
    const typename Geometry::Ray_3 ray(origin, along);
    if (!this->MayBeAsked(asked, ray)) return false;
    const auto met = CGAL::intersection(this->triangle_, ray);
    if (!met) return false;
    const Point* const at = boost::get<Point>(&*met);
    if (at == nullptr) return false;
    const int axis = Largest(along);
    tuv.t = static_cast<T>(((*at)[axis] - origin[axis]) / along[axis]);
    const Point& a = this->triangle_[0];
    const Vector b = this->triangle_[1] - a;
    const Vector c = this->triangle_[2] - a;
    const Vector p = *at - a;
    const int dropped = Largest(CGAL::cross_product(b, c));
    const int i = (dropped + 1) % 3;
    const int j = (dropped + 2) % 3;
    const Number area = b[i] * c[j] - b[j] * c[i];
    tuv.u = static_cast<T>((p[i] * c[j] - p[j] * c[i]) / area);
    tuv.v = static_cast<T>((b[i] * p[j] - b[j] * p[i]) / area);
    return true;
  }

 private:
  static int Largest(const Vector& v) {
    int axis = 0;
    for (const int k : {1, 2}) {
      if (std::abs(v[k]) > std::abs(v[axis])) axis = k;
    }
    return axis;
  }
};

template <class T>
using ExactDoIntersect = DoIntersect<Exact, T>;
template <class T>
using ExactIntersection = Intersection<Exact, T>;
template <class T>
using CartesianDoIntersect = DoIntersect<CGAL::Simple_cartesian<T>, T>;
template <class T>
using CartesianIntersection = Intersection<CGAL::Simple_cartesian<T>, T>;

}  // namespace

void AddCgalRays(std::vector<RayKernel>& rows) {
  // Rounded signs may contradict each other; what CGAL then throws is caught,
  // and it should not tell of it on stderr as well.
  CGAL::set_error_handler(
      [](const char*, const char*, const char*, int, const char*) {});
  const RayMethod do_intersect{
      .key = "cgal_do_intersect",
      .source = "CGAL",
      .formula = "exact predicates: do_intersect(Triangle_3, Ray_3)"};
  AddHitRows<float, ExactDoIntersect>(do_intersect, rows);
  AddHitRows<double, ExactDoIntersect>(do_intersect, rows);
  const RayMethod intersection{
      .key = "cgal_intersection",
      .source = "CGAL",
      .formula =
          "exact predicates: intersection(Triangle_3, Ray_3), its point"};
  AddTuvRows<float, ExactIntersection>(intersection, rows);
  AddTuvRows<double, ExactIntersection>(intersection, rows);
  const RayMethod cartesian_do_intersect{
      .key = "cgal_cartesian_do_intersect",
      .source = "CGAL",
      .formula = "Simple_cartesian: do_intersect(Triangle_3, Ray_3)"};
  AddHitRows<float, CartesianDoIntersect>(cartesian_do_intersect, rows);
  AddHitRows<double, CartesianDoIntersect>(cartesian_do_intersect, rows);
  const RayMethod cartesian_intersection{
      .key = "cgal_cartesian_intersection",
      .source = "CGAL",
      .formula =
          "Simple_cartesian: intersection(Triangle_3, Ray_3), its point"};
  AddTuvRows<float, CartesianIntersection>(cartesian_intersection, rows);
  AddTuvRows<double, CartesianIntersection>(cartesian_intersection, rows);
}

}  // namespace pitbench
