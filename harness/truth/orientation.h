// orient2d, exactly: on which side of the line ab the point c lies.
#ifndef PITBENCH_HARNESS_TRUTH_ORIENTATION_H_
#define PITBENCH_HARNESS_TRUTH_ORIENTATION_H_

#include "harness/truth/truth.h"

namespace pitbench {

// The sign of the area of triangle abc: +1 counter-clockwise, −1 clockwise,
// 0 collinear. Right for all finite coordinates (precondition: they are
// finite). T is float, double, std::int32_t or mpq_class.
template <class T>
int Orientation(const Point<T>& a, const Point<T>& b, const Point<T>& c);

// The same by GMP alone, without the filter. T is float, double or
// std::int32_t.
template <class T>
int OrientationExactly(const Point<T>& a, const Point<T>& b, const Point<T>& c);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_TRUTH_ORIENTATION_H_
