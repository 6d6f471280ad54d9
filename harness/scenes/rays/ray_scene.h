// A scene of rays: the flat arrays that the kernels of one loop read, and which
// parts of them each call reads.
#ifndef PITBENCH_HARNESS_SCENES_RAYS_RAY_SCENE_H_
#define PITBENCH_HARNESS_SCENES_RAYS_RAY_SCENE_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "harness/scenes/generate.h"
#include "harness/scenes/scene.h"
#include "harness/truth/ray_truth.h"
#include "kernels/rays/ray_kernels.h"

namespace pitbench {

template <class T>
struct Points3 {
  Array<T> x, y, z;

  void Add(const Point3<T>& p) {
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
  }
  Point3<T> At(std::size_t i) const { return {x[i], y[i], z[i]}; }
  Xyz<T> From(std::size_t i) const { return {&x[i], &y[i], &z[i]}; }
  std::size_t size() const { return x.size(); }
};

// What one call of a kernel reads: n items from these elements on. A side that
// the loop does not batch is that one element.
struct RayCall {
  std::size_t triangle;
  std::size_t ray;
  std::size_t n;
};

// The loop of points that batches the same side (see scene.h).
inline Loop ShapeOf(RayLoop loop) {
  switch (loop) {
    case RayLoop::kOneTriangleRays:
      return Loop::kOneTriangle;
    case RayLoop::kOneRay:
      return Loop::kOnePoint;
    case RayLoop::kRayPairs:
      break;
  }
  return Loop::kPairs;
}

template <class T>
struct RayScene {
  using Coordinate = T;

  std::string name;  // e.g. "rays_near_edge:ulps=1"
  RayLoop loop;
  Points3<T> a, b, c;
  Points3<T> origin, direction;
  T t_min;
  T t_max;
  std::vector<RayCall> calls;
  // Mesh scenes only: which query each answer is about, in the order of calls
  // and answers; else empty. A query is a ray that crosses the surface exactly
  // once within its range, asked of every triangle that could be hit; all of
  // them show it their fronts.
  std::vector<std::uint32_t> query;

  void Add(const Triangle3<T>& t) {
    a.Add(t.a);
    b.Add(t.b);
    c.Add(t.c);
  }
  void AddRay(const Point3<T>& from, const Point3<T>& along) {
    origin.Add(from);
    direction.Add(along);
  }

  // The range of t is that of the scene.
  void Add(const Ray<T>& ray) { AddRay(ray.origin, ray.direction); }

  // How many triangles there are, and rays that they are asked about.
  std::size_t Triangles() const { return a.size(); }
  std::size_t Probes() const { return origin.size(); }

  Triangle3<T> TriangleAt(std::size_t i) const {
    return {a.At(i), b.At(i), c.At(i)};
  }
  Ray<T> RayAt(std::size_t i) const {
    return {origin.At(i), direction.At(i), t_min, t_max};
  }

  RayBatch<T> BatchOf(const RayCall& call) const {
    const std::size_t t = call.triangle;
    const std::size_t r = call.ray;
    return {a.From(t),         b.From(t), c.From(t), origin.From(r),
            direction.From(r), call.n,    t_min,     t_max};
  }

  // How many answers a call gives; they lie in one row of bits, answer i in bit
  // i.
  std::size_t Answers(const RayCall& call) const { return call.n; }
  std::size_t AnswersInRow(const RayCall& call) const { return call.n; }
  std::size_t BitOf(std::size_t i) const { return i; }
  // How many bytes of bits a call writes.
  std::size_t OutputBytes(const RayCall& call) const {
    return BitBytes(call.n);
  }

  // The triangle and the ray that answer i of a call is about.
  Triangle3<T> TriangleOf(const RayCall& call, std::size_t i) const {
    return TriangleAt(loop == RayLoop::kOneTriangleRays ? call.triangle
                                                        : call.triangle + i);
  }
  Ray<T> RayOf(const RayCall& call, std::size_t i) const {
    return RayAt(loop == RayLoop::kOneRay ? call.ray : call.ray + i);
  }

  // Bytes that all calls together read, and that one call reads.
  std::size_t Bytes() const {
    return (9 * a.size() + 6 * origin.size()) * sizeof(T);
  }
  std::size_t BytesRead(const RayCall& call) const {
    const std::size_t triangles =
        loop == RayLoop::kOneTriangleRays ? 1 : call.n;
    const std::size_t rays = loop == RayLoop::kOneRay ? 1 : call.n;
    return (9 * triangles + 6 * rays) * sizeof(T);
  }
};

// The scene that the name says, for a loop; as MakeScene (generate.h) has it
// for 2D. The range of t is from 0 to infinity. T is float or double. Throws
// SceneError if the family is none of rays or a parameter is out of its range.
template <class T>
RayScene<T> MakeRayScene(const SceneSpec& spec, RayLoop loop, SceneSize size,
                         std::uint64_t seed);

// Whether the family is one of rays: its name begins with "rays_".
bool IsRayFamily(std::string_view family);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_SCENES_RAYS_RAY_SCENE_H_
