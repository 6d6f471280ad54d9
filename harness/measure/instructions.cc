#include "harness/measure/instructions.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "harness/measure/answers.h"
#include "harness/scenes/generate.h"
#include "harness/scenes/rays/ray_scene.h"
#include "harness/scenes/spec.h"

namespace pitbench {
namespace {

// Calls that do nothing, for what is around the traced ones.
template <class T>
void DoNothing(const Batch<T>&, const Result<T>&) {}
template <class T>
void DoNothing(const RayBatch<T>&, const RayResult<T>&) {}

// As many items as the kernel's loop works off in its longest stretch, so that
// n and 2n items differ by whole ones: a block of bytes in the plain loops
// (loops/plain-inl.h), else 8 vectors, or 8 bytes of bits if those are more
// (loops/filtered-inl.h).
std::size_t WholeStretch(Isa isa, Scalar scalar) {
  switch (isa) {
    case Isa::kAutovecV2:
    case Isa::kAutovecV3:
    case Isa::kAutovecV4:
      return 512;
    case Isa::kAvx512:
      return scalar == Scalar::kF32 ? 128 : 64;
    default:
      return 64;
  }
}

// What a traced kernel writes.
template <class T>
struct Written {
  Bits bits;
  T t;
  std::size_t nearest;

  Result<T> Of(const Scene<T>&) { return {.bits = bits.data()}; }
  RayResult<T> Of(const RayScene<T>&) {
    return {.bits = bits.data(), .t = &t, .nearest = &nearest};
  }
};

// Of a kernel's function, or of DoNothing, on the first n items of a scene.
template <class Function, class S>
Trace TraceCall(Function function, const S& scene, std::size_t n) {
  auto call = scene.calls.front();
  call.n = n;
  Written<typename S::Coordinate> written{.bits =
                                              Bits(scene.OutputBytes(call))};
  const auto batch = scene.BatchOf(call);
  const auto result = written.Of(scene);
  function(batch, result);  // once before, so that no library is loaded in it
  return TraceOf([&] { function(batch, result); });
}

template <class Function, class S>
SteadyLoop TraceOn(Function function, const S& scene, std::size_t n) {
  constexpr Function kNothing = DoNothing<typename S::Coordinate>;
  const Trace nothing = TraceCall(kNothing, scene, n);
  return FindSteadyLoop(TraceCall(function, scene, n),
                        TraceCall(function, scene, 2 * n), n, nothing.size());
}

template <class T>
SteadyLoop TraceFloat(const Kernel& kernel) {
  const std::size_t n = WholeStretch(kernel.isa, kernel.scalar);
  return TraceOn(
      FunctionOf<T>(kernel),
      MakeScene<T>(ParseScene("uniform:hit=50:bytes=64k:sets=fixed"),
                   kernel.loop, {.groups = 1, .size = 2 * n}, kDefaultSeed),
      n);
}

template <class T>
SteadyLoop TraceFloat(const RayKernel& kernel) {
  const std::size_t n = WholeStretch(kernel.isa, kernel.scalar);
  return TraceOn(
      FunctionOf<T>(kernel),
      MakeRayScene<T>(ParseScene("rays_uniform:hit=50:bytes=128k:sets=fixed"),
                      kernel.loop, {.groups = 1, .size = 2 * n}, kDefaultSeed),
      n);
}

// Whether a kernel is one of those that are traced.
bool IsTraced(const Kernel& kernel) {
  return kernel.output == Output::kInside && kernel.loop != Loop::kGrid &&
         kernel.loop != Loop::kOneTriangleAos && IsFloat(kernel.scalar);
}
// Ray kernels are long, and each instruction takes a microsecond or more to
// trace: those of one loop on the widest ISA that runs here have to do.
bool IsTraced(const RayKernel& kernel) {
  static const Isa widest = [] {
    Isa isa = Isa::kScalar;
    for (const RayKernel& k : AllRayKernels()) {
      if (RunsHere(k.isa)) isa = std::max(isa, k.isa);
    }
    return isa;
  }();
  return kernel.loop == RayLoop::kOneTriangleRays &&
         kernel.output == RayOutput::kHits && kernel.isa == widest;
}

}  // namespace

SteadyLoop TraceKernel(const Kernel& kernel) {
  return kernel.scalar == Scalar::kF32 ? TraceFloat<float>(kernel)
                                       : TraceFloat<double>(kernel);
}
SteadyLoop TraceKernel(const RayKernel& kernel) {
  return kernel.scalar == Scalar::kF32 ? TraceFloat<float>(kernel)
                                       : TraceFloat<double>(kernel);
}

nlohmann::json InstructionsOf(const NameFilter& filter) {
  nlohmann::json rows = nlohmann::json::array();
  const std::string reason = CannotTrace();
  const auto add = [&](const auto& kernels) {
    for (const auto& kernel : kernels) {
      if (!IsTraced(kernel)) continue;
      const std::string loop(Name(kernel.loop));
      const std::string method(kernel.method.key);
      const std::string scalar(Name(kernel.scalar));
      const std::string isa(Name(kernel.isa));
      std::string name = loop;
      name.append("/").append(method).append("/").append(scalar);
      name.append("/").append(isa);
      if (!filter.Finds(name)) continue;
      if (!RunsHere(kernel.isa)) continue;
      const SteadyLoop steady = TraceKernel(kernel);
      rows.push_back({{"method", method},
                      {"scalar", scalar},
                      {"loop", loop},
                      {"isa", isa},
                      {"per_call", steady.per_call},
                      {"per_item", steady.per_item},
                      {"items_per_iteration", steady.items},
                      {"iteration", InstructionBytes(steady.iteration)}});
    }
  };
  if (reason.empty()) {
    add(AllKernels());
    add(AllRayKernels());
  }
  return {{"schema", "instructions-1"}, {"reason", reason}, {"rows", rows}};
}

}  // namespace pitbench
