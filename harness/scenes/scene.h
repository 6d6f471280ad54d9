// A scene: the flat arrays that the kernels of one loop read, and which parts
// of them each call reads. Nothing more is modelled.
#ifndef PITBENCH_HARNESS_SCENES_SCENE_H_
#define PITBENCH_HARNESS_SCENES_SCENE_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "harness/truth/truth.h"
#include "kernels/kernels.h"

namespace pitbench {

// Allocates whole cache lines, so that where an array lies does not change
// from run to run.
template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t kLine{128};
  CacheLineAllocator() = default;
  template <class U>
  explicit CacheLineAllocator(const CacheLineAllocator<U>&) {}
  T* allocate(std::size_t n) {
    return static_cast<T*>(::operator new(n * sizeof(T), kLine));
  }
  void deallocate(T* p, std::size_t) { ::operator delete(p, kLine); }
  bool operator==(const CacheLineAllocator&) const = default;
};

template <class T>
using Array = std::vector<T, CacheLineAllocator<T>>;

// The loop that the scenes of a kernel of `loop` have: one_triangle_aos is
// asked about those of one_triangle, whose points it finds laid out otherwise.
constexpr Loop LoopOfScenes(Loop loop) {
  return loop == Loop::kOneTriangleAos ? Loop::kOneTriangle : loop;
}

// What one call of a kernel reads: n items from these elements on. A side that
// the loop does not batch is that one element.
struct Call {
  std::size_t triangle;
  std::size_t point;
  std::size_t n;
};

// The loop of points that batches the same side: of a loop of points itself.
// What draws scenes of points and of rays goes by this.
inline Loop ShapeOf(Loop loop) { return loop; }

template <class T>
struct Scene {
  using Coordinate = T;

  std::string name;  // e.g. "near_edge:ulps=1"
  Loop loop;         // LoopOfScenes of some kernel's, so never one_triangle_aos
  Array<T> ax, ay, bx, by, cx, cy;
  Array<T> px, py;
  std::size_t width = 0;  // of the grid, in pixels; loop grid only
  std::size_t height = 0;
  std::vector<Call> calls;
  // Mesh scenes only: which query each answer is about, in the order of calls
  // and answers; else empty. Queries are numbered from 0; a query is a point in
  // the interior of the mesh's domain, asked of every triangle of the mesh that
  // could hold it.
  std::vector<std::uint32_t> query;

  void Add(const Triangle<T>& t) {
    ax.push_back(t.a.x);
    ay.push_back(t.a.y);
    bx.push_back(t.b.x);
    by.push_back(t.b.y);
    cx.push_back(t.c.x);
    cy.push_back(t.c.y);
  }
  void Add(const Point<T>& p) {
    px.push_back(p.x);
    py.push_back(p.y);
  }

  // How many triangles there are, and points that they are asked about.
  std::size_t Triangles() const { return ax.size(); }
  std::size_t Probes() const { return px.size(); }

  Triangle<T> TriangleAt(std::size_t i) const {
    return {{ax[i], ay[i]}, {bx[i], by[i]}, {cx[i], cy[i]}};
  }
  Point<T> PointAt(std::size_t i) const { return {px[i], py[i]}; }

  // x and y of each point side by side, for loop one_triangle_aos. Made for the
  // one who runs a kernel and not kept here: what changes px and py would have
  // to change it too.
  Array<T> PointsSideBySide() const {
    Array<T> xy;
    xy.reserve(2 * px.size());
    for (std::size_t i = 0; i < px.size(); ++i) {
      xy.push_back(px[i]);
      xy.push_back(py[i]);
    }
    return xy;
  }

  // `xy` is what PointsSideBySide gives, for a kernel that reads it.
  Batch<T> BatchOf(const Call& call, const T* xy = nullptr) const {
    const std::size_t t = call.triangle;
    const std::size_t p = call.point;
    const bool grid = loop == Loop::kGrid;
    return {&ax[t],
            &ay[t],
            &bx[t],
            &by[t],
            &cx[t],
            &cy[t],
            grid ? nullptr : &px[p],
            grid ? nullptr : &py[p],
            call.n,
            width,
            height,
            xy == nullptr ? nullptr : xy + 2 * p};
  }

  // How many answers a call gives.
  std::size_t Answers(const Call& call) const {
    return loop == Loop::kGrid ? call.n * width * height : call.n;
  }
  // How many of them lie in a row of bits, which begins with a new byte.
  std::size_t AnswersInRow(const Call& call) const {
    return loop == Loop::kGrid ? width : call.n;
  }
  // Where the bit of answer i of a call lies, counted from bit 0 of byte 0.
  std::size_t BitOf(std::size_t i) const {
    if (loop != Loop::kGrid) return i;
    return i / width * 8 * BitBytes(width) + i % width;
  }
  // How many bytes of bits a call writes.
  std::size_t OutputBytes(const Call& call) const {
    return loop == Loop::kGrid ? call.n * height * BitBytes(width)
                               : BitBytes(call.n);
  }
  // The triangle and the point that answer i of a call is about.
  Triangle<T> TriangleOf(const Call& call, std::size_t i) const {
    switch (loop) {
      case Loop::kOneTriangle:
      case Loop::kOneTriangleAos:
        return TriangleAt(call.triangle);
      case Loop::kOnePoint:
      case Loop::kPairs:
        return TriangleAt(call.triangle + i);
      case Loop::kGrid:
        break;
    }
    return TriangleAt(call.triangle + i / (width * height));
  }
  Point<T> PointOf(const Call& call, std::size_t i) const {
    switch (loop) {
      case Loop::kOneTriangle:
      case Loop::kOneTriangleAos:
      case Loop::kPairs:
        return PointAt(call.point + i);
      case Loop::kOnePoint:
        return PointAt(call.point);
      case Loop::kGrid:
        break;
    }
    return {static_cast<T>(i % width), static_cast<T>(i / width % height)};
  }

  // Bytes that all calls together read.
  std::size_t Bytes() const {
    return (6 * ax.size() + 2 * px.size()) * sizeof(T);
  }

  // Bytes that a call reads, for the row of results.
  std::size_t BytesRead(const Call& call) const {
    const std::size_t triangle = 6 * sizeof(T);
    const std::size_t point = 2 * sizeof(T);
    switch (loop) {
      case Loop::kOneTriangle:
      case Loop::kOneTriangleAos:
        return triangle + call.n * point;
      case Loop::kOnePoint:
        return point + call.n * triangle;
      case Loop::kPairs:
        return call.n * (triangle + point);
      case Loop::kGrid:
        break;
    }
    return call.n * triangle;
  }
};

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_SCENES_SCENE_H_
