// GLM. It has no point-in-triangle test, so these are the two ways to one:
//
//   glm_cross         the 2D cross product of gtx/exterior_product for each
//                     edge and the point; inside if no two signs differ.
//                     Closed; a degenerate triangle contains its line.
//   glm_ray_triangle  intersectRayTriangle of gtx/intersect (Möller and
//                     Trumbore) with a ray along z. Closed. It calls a triangle
//                     parallel to the ray whose double area is not above the
//                     scalar's epsilon, whatever the size of its coordinates.
//
// Set-up: none.
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtx/exterior_product.hpp>
#include <glm/gtx/intersect.hpp>
#include <string>

#include "peers/libraries.h"
#include "peers/rows.h"

namespace pitbench {
namespace {

template <class T>
class Cross {
 public:
  explicit Cross(const PeerTriangle<T>& t)
      : a_(t.ax, t.ay), b_(t.bx, t.by), c_(t.cx, t.cy) {}
  bool Inside(T x, T y) const {
    const Vec p(x, y);
    const T ab = glm::cross(b_ - a_, p - a_);
    const T bc = glm::cross(c_ - b_, p - b_);
    const T ca = glm::cross(a_ - c_, p - c_);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
  }

 private:
  using Vec = glm::vec<2, T>;
  Vec a_, b_, c_;
};

template <class T>
class RayTriangle {
 public:
  explicit RayTriangle(const PeerTriangle<T>& t)
      : a_(t.ax, t.ay, 0), b_(t.bx, t.by, 0), c_(t.cx, t.cy, 0) {}
  bool Inside(T x, T y) const {
    glm::vec<2, T> weights;
    T distance;
    return glm::intersectRayTriangle(Vec(x, y, -1), Vec(0, 0, 1), a_, b_, c_,
                                     weights, distance);
  }

 private:
  using Vec = glm::vec<3, T>;
  Vec a_, b_, c_;
};

}  // namespace

PeerLibrary AddGlm(std::vector<Kernel>& rows) {
  AddPeerRowsOfBoth<Cross>(
      {.key = "glm_cross",
       .source = "GLM",
       .formula =
           "gtx/exterior_product: cross(edge, way to the point) per edge",
       .boundary = Boundary::kClosed},
      rows);
  AddPeerRowsOfBoth<RayTriangle>(
      {.key = "glm_ray_triangle",
       .source = "GLM",
       .formula = "gtx/intersect: intersectRayTriangle, the ray along z",
       .boundary = Boundary::kClosed},
      rows);
  return {"glm", std::to_string(GLM_VERSION_MAJOR) + "." +
                     std::to_string(GLM_VERSION_MINOR) + "." +
                     std::to_string(GLM_VERSION_PATCH) + "." +
                     std::to_string(GLM_VERSION_REVISION)};
}

}  // namespace pitbench
