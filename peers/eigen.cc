// Eigen: the inverse of the 3×3 matrix of the vertices, times the point.
//
//   eigen_inverse  the inverse is worked out anew for every point, as a test
//                  written for one point does. (With the inverse hoisted this
//                  is barycentric_inverse.) Closed.
#include <Eigen/Dense>
#include <string>

#include "peers/libraries.h"
#include "peers/rows.h"

namespace pitbench {
namespace {

// Not inlined, so that no compiler hoists the inverse.
template <class T>
[[gnu::noinline]] bool ByInverse(const PeerTriangle<T>& t, T x, T y) {
  Eigen::Matrix<T, 3, 3> m;
  m << t.ax, t.bx, t.cx,  //
      t.ay, t.by, t.cy,   //
      1, 1, 1;
  const Eigen::Matrix<T, 3, 1> w =
      m.inverse() * Eigen::Matrix<T, 3, 1>(x, y, 1);
  return (w.array() >= 0).all();
}

template <class T>
class Inverse {
 public:
  explicit Inverse(const PeerTriangle<T>& t) : triangle_(t) {}
  bool Inside(T x, T y) const { return ByInverse(triangle_, x, y); }

 private:
  PeerTriangle<T> triangle_;
};

}  // namespace

PeerLibrary AddEigen(std::vector<Kernel>& rows) {
  AddPeerRowsOfBoth<Inverse>(
      {.key = "eigen_inverse",
       .source = "Eigen",
       .formula = "Matrix3::inverse() · (x, y, 1), all ≥ 0, per point",
       .boundary = Boundary::kClosed},
      rows);
  return {"eigen", std::to_string(EIGEN_WORLD_VERSION) + "." +
                       std::to_string(EIGEN_MAJOR_VERSION) + "." +
                       std::to_string(EIGEN_MINOR_VERSION)};
}

}  // namespace pitbench
