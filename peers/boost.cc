// Boost.Geometry: covered_by of a point and a ring.
//
//   boost_covered_by  its own strategy, winding numbers: where a side test is
//                     near 0 it compares with a relative epsilon, so points
//                     close to an edge may count as on it. Closed.
//   boost_franklin    Randolph Franklin's crossings (PNPOLY): each edge as
//                     x < (x1−x2)·(y−y2)/(y1−y2) + x2 with a division. Which
//                     boundary points it takes follows from its comparisons:
//                     those of left and of bottom edges.
//
// Set-up: a ring of four points, ordered as the library wants it (correct()).
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <boost/version.hpp>
#include <string>

#include "peers/libraries.h"
#include "peers/rows.h"

namespace pitbench {
namespace {

namespace bg = boost::geometry;

template <class T>
using PointOf = bg::model::d2::point_xy<T>;

template <class T>
bg::model::ring<PointOf<T>> CorrectedRing(const PeerTriangle<T>& t) {
  bg::model::ring<PointOf<T>> ring{
      {t.ax, t.ay}, {t.bx, t.by}, {t.cx, t.cy}, {t.ax, t.ay}};
  bg::correct(ring);
  return ring;
}

template <class T>
class CoveredBy {
 public:
  explicit CoveredBy(const PeerTriangle<T>& t) : ring_(CorrectedRing(t)) {}
  bool Inside(T x, T y) const {
    return bg::covered_by(PointOf<T>(x, y), ring_);
  }

 private:
  bg::model::ring<PointOf<T>> ring_;
};

template <class T>
class Franklin {
 public:
  explicit Franklin(const PeerTriangle<T>& t) : ring_(CorrectedRing(t)) {}
  bool Inside(T x, T y) const {
    return bg::covered_by(PointOf<T>(x, y), ring_,
                          bg::strategy::within::franklin<PointOf<T>>());
  }

 private:
  bg::model::ring<PointOf<T>> ring_;
};

}  // namespace

PeerLibrary AddBoost(std::vector<Kernel>& rows) {
  AddPeerRowsOfBoth<CoveredBy>(
      {.key = "boost_covered_by",
       .source = "Boost.Geometry",
       .formula = "covered_by(point, ring), by winding",
       .boundary = Boundary::kClosed},
      rows);
  AddPeerRowsOfBoth<Franklin>(
      {.key = "boost_franklin",
       .source = "Boost.Geometry",
       .formula = "covered_by(point, ring, franklin), by crossings",
       .boundary = Boundary::kBottomLeft},
      rows);
  return {"boost", std::to_string(BOOST_VERSION / 100000) + "." +
                       std::to_string(BOOST_VERSION / 100 % 1000) + "." +
                       std::to_string(BOOST_VERSION % 100)};
}

}  // namespace pitbench
