// CGAL: the side of a Triangle_2 on which a point lies.
//
//   cgal_cartesian    Simple_cartesian: bounded_side in the scalar itself,
//                     rounded as it comes.
//   cgal_exact        Exact_predicates_inexact_constructions_kernel: the same
//                     call, exact: an interval filter and exact numbers behind
//                     it. That kernel has double coordinates; f32 is widened,
//                     which loses nothing.
//   cgal_orientation  the same kernel, three calls of orientation() in the
//                     place of bounded_side, as the filter is cheaper there.
//
// Set-up: none to speak of. The kernels check nothing in a release build and
// are asked about finite numbers only.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

#include "peers/libraries.h"
#include "peers/rows.h"

namespace pitbench {
namespace {

using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Geometry, class T>
class BoundedSide {
 public:
  explicit BoundedSide(const PeerTriangle<T>& t)
      : triangle_({t.ax, t.ay}, {t.bx, t.by}, {t.cx, t.cy}),
        degenerate_(triangle_.is_degenerate()) {}
  bool Inside(T x, T y) const {
    return !degenerate_ &&
           triangle_.bounded_side({x, y}) != CGAL::ON_UNBOUNDED_SIDE;
  }

 private:
  typename Geometry::Triangle_2 triangle_;
  bool degenerate_;  // bounded_side must not be asked then
};

template <class T>
using CartesianSide = BoundedSide<CGAL::Simple_cartesian<T>, T>;
template <class T>
using ExactSide = BoundedSide<Exact, T>;

template <class T>
class ThreeOrientations {
 public:
  explicit ThreeOrientations(const PeerTriangle<T>& t)
      : a_(t.ax, t.ay),
        b_(t.bx, t.by),
        c_(t.cx, t.cy),
        winding_(CGAL::orientation(a_, b_, c_)) {}
  bool Inside(T x, T y) const {
    const Exact::Point_2 p(x, y);
    return winding_ != CGAL::COLLINEAR &&
           CGAL::orientation(a_, b_, p) != -winding_ &&
           CGAL::orientation(b_, c_, p) != -winding_ &&
           CGAL::orientation(c_, a_, p) != -winding_;
  }

 private:
  Exact::Point_2 a_, b_, c_;
  CGAL::Orientation winding_;
};

}  // namespace

PeerLibrary AddCgal(std::vector<Kernel>& rows) {
  AddPeerRowsOfBoth<CartesianSide>(
      {.key = "cgal_cartesian",
       .source = "CGAL",
       .formula = "Simple_cartesian: Triangle_2::bounded_side(point)",
       .boundary = Boundary::kClosed},
      rows);
  AddPeerRowsOfBoth<ExactSide>(
      {.key = "cgal_exact",
       .source = "CGAL",
       .formula = "exact predicates: Triangle_2::bounded_side(point)",
       .boundary = Boundary::kClosed,
       .finite_only = true},
      rows);
  AddPeerRowsOfBoth<ThreeOrientations>(
      {.key = "cgal_orientation",
       .source = "CGAL",
       .formula = "exact predicates: orientation() of each edge and the point",
       .boundary = Boundary::kClosed,
       .finite_only = true},
      rows);
  return {"cgal", CGAL_VERSION_STR};
}

}  // namespace pitbench
