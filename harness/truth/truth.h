// The exact answer for a point and a triangle, whatever their coordinates.
//
// Everything pitbench says about accuracy is judged against this, so it uses
// exact arithmetic (GMP) on the binary values that it is given. A filter in
// double precision stands before it, proven in orientation.cc;
// tests/truth_filter_test.cc shows that the two agree on millions of hard
// inputs.
#ifndef PITBENCH_HARNESS_TRUTH_TRUTH_H_
#define PITBENCH_HARNESS_TRUTH_TRUTH_H_

#include <array>
#include <string_view>

namespace pitbench {

enum class Position { kInside, kBoundary, kOutside, kDegenerate };

std::string_view Name(Position position);

template <class T>
struct Point {
  T x;
  T y;
};

template <class T>
struct Triangle {
  Point<T> a;
  Point<T> b;
  Point<T> c;
};

// Whether no coordinate is NaN or infinite. T is float, double, std::int32_t,
// std::int16_t, std::uint8_t or mpq_class.
template <class T>
bool IsFinite(const Triangle<T>& triangle, const Point<T>& p);

// Where `p` lies. A triangle of area 0 is kDegenerate for every point; a
// coordinate that is NaN or infinite makes the answer kOutside. T is float,
// double, std::int32_t, or mpq_class for numbers that none of those hold. Never
// overflows, underflows or throws.
template <class T>
Position Classify(const Triangle<T>& triangle, const Point<T>& p);

// The same by GMP alone, without the filter.
template <class T>
Position ClassifyExactly(const Triangle<T>& triangle, const Point<T>& p);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_TRUTH_TRUTH_H_
