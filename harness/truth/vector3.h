// Vectors of doubles, for what need not be exact.
#ifndef PITBENCH_HARNESS_TRUTH_VECTOR3_H_
#define PITBENCH_HARNESS_TRUTH_VECTOR3_H_

#include <cmath>

#include "harness/truth/ray_truth.h"

namespace pitbench {

using Vector3 = Point3<double>;

inline Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector3 operator*(double s, const Vector3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double Dot(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector3 Cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double Length(const Vector3& a) { return std::sqrt(Dot(a, a)); }
inline Vector3 Unit(const Vector3& a) { return 1 / Length(a) * a; }

template <class T>
Vector3 Widened(const Point3<T>& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y),
          static_cast<double>(p.z)};
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_TRUTH_VECTOR3_H_
