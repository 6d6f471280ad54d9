// GEOS: a point against a polygon. Coordinates are doubles; f32 is widened,
// which loses nothing. Its orientation test is a filter and double-double
// arithmetic behind it. Closed.
//
//   geos_prepared      PreparedPolygon::covers, with a Point made for each
//                      query, as through its C interface and its bindings
//   geos_indexed       IndexedPointInAreaLocator: the same without the Point
//   geos_ray_crossing  PointLocation::locateInRing: ray crossings over the
//                      ring, no index, which is as good for three edges
//
// Set-up: a polygon; for the first two an index over its edges, which GEOS
// builds at the first query.
#include <geos/algorithm/PointLocation.h>
#include <geos/algorithm/locate/IndexedPointInAreaLocator.h>
#include <geos/geom/CoordinateArraySequence.h>
#include <geos/geom/GeometryFactory.h>
#include <geos/geom/LinearRing.h>
#include <geos/geom/Point.h>
#include <geos/geom/Polygon.h>
#include <geos/geom/prep/PreparedGeometry.h>
#include <geos/geom/prep/PreparedGeometryFactory.h>
#include <geos/version.h>

#include <memory>

#include "peers/libraries.h"
#include "peers/rows.h"

namespace pitbench {
namespace {

namespace geom = geos::geom;

template <class T>
std::unique_ptr<geom::CoordinateArraySequence> Ring(const PeerTriangle<T>& t) {
  auto ring = std::make_unique<geom::CoordinateArraySequence>(4u, 2u);
  ring->setAt({t.ax, t.ay}, 0);
  ring->setAt({t.bx, t.by}, 1);
  ring->setAt({t.cx, t.cy}, 2);
  ring->setAt({t.ax, t.ay}, 3);
  return ring;
}

template <class T>
std::unique_ptr<geom::Polygon> MakePolygon(const PeerTriangle<T>& t) {
  const geom::GeometryFactory& factory =
      *geom::GeometryFactory::getDefaultInstance();
  return factory.createPolygon(factory.createLinearRing(Ring(t)));
}

template <class T>
class Prepared {
 public:
  explicit Prepared(const PeerTriangle<T>& t)
      : polygon_(MakePolygon(t)),
        prepared_(
            geom::prep::PreparedGeometryFactory::prepare(polygon_.get())) {}
  bool Inside(T x, T y) const {
    const std::unique_ptr<geom::Point> point(
        geom::GeometryFactory::getDefaultInstance()->createPoint(
            geom::Coordinate(x, y)));
    return prepared_->covers(point.get());
  }

 private:
  std::unique_ptr<geom::Polygon> polygon_;
  std::unique_ptr<geom::prep::PreparedGeometry> prepared_;
};

template <class T>
class Indexed {
 public:
  explicit Indexed(const PeerTriangle<T>& t)
      : polygon_(MakePolygon(t)),
        locator_(std::make_unique<
                 geos::algorithm::locate::IndexedPointInAreaLocator>(
            *polygon_)) {}
  bool Inside(T x, T y) const {
    const geom::Coordinate point(x, y);
    return locator_->locate(&point) != geom::Location::EXTERIOR;
  }

 private:
  std::unique_ptr<geom::Polygon> polygon_;
  std::unique_ptr<geos::algorithm::locate::IndexedPointInAreaLocator> locator_;
};

template <class T>
class RayCrossing {
 public:
  explicit RayCrossing(const PeerTriangle<T>& t) : ring_(Ring(t)) {}
  bool Inside(T x, T y) const {
    return geos::algorithm::PointLocation::locateInRing({x, y}, *ring_) !=
           geom::Location::EXTERIOR;
  }

 private:
  std::unique_ptr<geom::CoordinateArraySequence> ring_;
};

}  // namespace

PeerLibrary AddGeos(std::vector<Kernel>& rows) {
  AddPeerRowsOfBoth<Prepared>(
      {.key = "geos_prepared",
       .source = "GEOS",
       .formula = "PreparedPolygon::covers(Point), a Point per query",
       .boundary = Boundary::kClosed},
      rows);
  AddPeerRowsOfBoth<Indexed>(
      {.key = "geos_indexed",
       .source = "GEOS",
       .formula = "IndexedPointInAreaLocator::locate(Coordinate)",
       .boundary = Boundary::kClosed},
      rows);
  AddPeerRowsOfBoth<RayCrossing>(
      {.key = "geos_ray_crossing",
       .source = "GEOS",
       .formula = "PointLocation::locateInRing(Coordinate, ring)",
       .boundary = Boundary::kClosed},
      rows);
  return {"geos", GEOS_VERSION};
}

}  // namespace pitbench
