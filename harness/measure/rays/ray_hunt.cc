#include "harness/measure/rays/ray_hunt.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include "harness/measure/climb.h"
#include "harness/measure/rays/ray_candidates.h"
#include "harness/scenes/rays/ray_scene.h"
#include "harness/truth/ray_distance.h"

namespace pitbench {
namespace {

// What climb.h asks of rays and triangles.
template <class T>
class RayQuarry : public RayCandidateSource<T> {
 public:
  using Candidate = RayCandidate<T>;
  using Found = WrongRay<T>;
  // The ray's coordinates, then the triangle's.
  static constexpr std::array<std::size_t, 15> kShortenedFirst = {
      12, 13, 14, 9, 10, 11, 0, 1, 2, 3, 4, 5, 6, 7, 8};

  RayQuarry(const RayKernel& kernel, std::uint64_t seed)
      : RayCandidateSource<T>(seed), kernel_(kernel) {}

  static bool Admissible(const Candidate& c) {
    return pitbench::Admissible<T>(c);
  }

  void Ask(const std::vector<Candidate>& batch,
           std::vector<std::uint8_t>& bits) {
    RayScene<T> scene{.name = "", .loop = RayLoop::kRayPairs};
    for (const Candidate& c : batch) {
      const Ray<T> ray = RayOf(c);
      scene.t_min = ray.t_min;
      scene.t_max = ray.t_max;
      scene.Add(TriangleOf(c));
      scene.Add(ray);
    }
    bits.resize(BitBytes(batch.size()));
    if (batch.empty()) return;
    FunctionOf<T>(kernel_)(scene.BatchOf({0, 0, batch.size()}),
                           {.bits = bits.data()});
  }

  static double Estimate(const Candidate& c) {
    return AnswerDistanceEstimate(TriangleOf(c), RayOf(c));
  }

  bool IsWrong(const Candidate& c, bool said_hit) const {
    const RayPosition truth = TruthOf(c);
    return truth != RayPosition::kBoundary &&
           said_hit != (truth == RayPosition::kHit);
  }

  Found Report(const Candidate& c, bool said_hit) const {
    const Triangle3<T> triangle = TriangleOf(c);
    const Ray<T> ray = RayOf(c);
    return {triangle, ray, said_hit, TruthOf(c),
            AnswerDistanceInUlps(triangle, ray)};
  }

 private:
  RayPosition TruthOf(const Candidate& c) const {
    return ClassifyFor(kernel_.method, TriangleOf(c), RayOf(c));
  }

  const RayKernel& kernel_;
};

}  // namespace

template <class T>
RayPosition ClassifyFor(const RayMethod& method, const Triangle3<T>& triangle,
                        const Ray<T>& ray) {
  const RayPosition position = Classify(triangle, ray);
  return position == RayPosition::kHit && method.culls_backface &&
                 !IsFrontFacing(triangle, ray)
             ? RayPosition::kMiss
             : position;
}

template <class T>
std::vector<WrongRay<T>> HuntRays(const RayKernel& kernel, double seconds,
                                  std::uint64_t seed, std::size_t keep) {
  RayQuarry<T> quarry(kernel, seed);
  return WorstOfClimbs(quarry, seconds, keep);
}

template <class T>
std::string HuntRaysCsv(const RayKernel& kernel,
                        const std::vector<WrongRay<T>>& found) {
  std::vector<HuntRow> rows;
  for (const WrongRay<T>& input : found) {
    HuntRow row{.said = input.said_hit ? "hit" : "miss",
                .truth = Name(input.truth),
                .distance_ulps = input.distance_ulps};
    const auto& [a, b, c] = input.triangle;
    for (const Point3<T>& p :
         {a, b, c, input.ray.origin, input.ray.direction}) {
      for (const T x : {p.x, p.y, p.z}) {
        row.coordinates.push_back(static_cast<double>(x));
      }
    }
    rows.push_back(row);
  }
  return HuntLines(kernel.method.key, Name(kernel.scalar),
                   "ax,ay,az,bx,by,bz,cx,cy,cz,ox,oy,oz,dx,dy,dz", rows);
}

template RayPosition ClassifyFor(const RayMethod&, const Triangle3<float>&,
                                 const Ray<float>&);
template RayPosition ClassifyFor(const RayMethod&, const Triangle3<double>&,
                                 const Ray<double>&);
template std::vector<WrongRay<float>> HuntRays(const RayKernel&, double,
                                               std::uint64_t, std::size_t);
template std::vector<WrongRay<double>> HuntRays(const RayKernel&, double,
                                                std::uint64_t, std::size_t);
template std::string HuntRaysCsv(const RayKernel&,
                                 const std::vector<WrongRay<float>>&);
template std::string HuntRaysCsv(const RayKernel&,
                                 const std::vector<WrongRay<double>>&);

}  // namespace pitbench
