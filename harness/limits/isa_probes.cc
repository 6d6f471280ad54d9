// The probes, once for each of Highway's targets.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "harness/limits/isa_probes.cc"
#include "harness/limits/isa_probes.h"

#include <hwy/foreach_target.h>

#include <type_traits>

#include "kernels/isa-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR
constexpr bool kOneLane = true;
template <class T>
using Lanes = hn::Sisd<T>;
#else
constexpr bool kOneLane = false;
template <class T>
using Lanes = hn::ScalableTag<T>;
#endif
// One-lane kernels are compiled for the oldest CPU, which has no multiply-add.
#undef PITBENCH_FUSED
#define PITBENCH_FUSED (HWY_NATIVE_FMA && HWY_TARGET != HWY_SCALAR)
template <class D>
using Vec = hn::Vec<D>;

// The register that a vector lies in.
template <class V>
HWY_INLINE auto& Raw(V& v) {
#if HWY_HAVE_SCALABLE
  return v;
#else
  return v.raw;
#endif
}

// The compiler knows nothing of `v` after this.
template <class V>
HWY_INLINE void Launder(V& v) {
#if HWY_ARCH_X86
#define PITBENCH_VECTOR_REGISTER "v"
#else
#define PITBENCH_VECTOR_REGISTER "w"
#endif
  if constexpr (kOneLane && !hwy::IsFloat<hn::TFromV<V>>()) {
    asm volatile("" : "+r"(Raw(v)));
  } else {
    asm volatile("" : "+" PITBENCH_VECTOR_REGISTER(Raw(v)));
  }
}

// `v` has to be computed.
template <class V>
HWY_INLINE void Keep(const V& v) {
  if constexpr (kOneLane && !hwy::IsFloat<hn::TFromV<V>>()) {
    asm volatile("" ::"r"(Raw(v)));
  } else {
    asm volatile("" ::PITBENCH_VECTOR_REGISTER(Raw(v)));
  }
}

// What a step does to each chain. `c` and `d` are 1, and unknown to the
// compiler; values stay finite and normal.
struct AddStep {
  template <class D, class V>
  HWY_INLINE void operator()(D, V& x, V& c, V&) const {
    x = hn::Add(x, c);
  }
};
struct MultiplyStep {
  template <class D, class V>
  HWY_INLINE void operator()(D, V& x, V& c, V&) const {
    x = hn::Mul(x, c);
  }
};
struct MultiplyAddStep {
  template <class D, class V>
  HWY_INLINE void operator()(D, V& x, V& c, V& d) const {
    x = hn::MulAdd(x, c, d);
  }
};
struct DivideStep {
  template <class D, class V>
  HWY_INLINE void operator()(D, V& x, V& c, V&) const {
    x = hn::Div(x, c);
  }
};
struct MinStep {
  template <class D, class V>
  HWY_INLINE void operator()(D, V& x, V& c, V&) const {
#if HWY_TARGET == HWY_SCALAR
    // One instruction; Highway's own treats NaN apart.
    x.raw = x.raw < c.raw ? x.raw : c.raw;
#else
    x = hn::Min(x, c);
#endif
  }
};
// Sets the flags as one-lane code does, and no register: the instruction for
// that waits for the register's old value.
template <class T>
HWY_INLINE void CompareFlags(T a, T b) {
#if HWY_ARCH_X86
  if constexpr (std::is_same_v<T, float>) {
    asm volatile("comiss %1, %0" ::"x"(a), "x"(b) : "cc");
  } else if constexpr (std::is_same_v<T, double>) {
    asm volatile("comisd %1, %0" ::"x"(a), "x"(b) : "cc");
  } else {
    asm volatile("cmp %1, %0" ::"r"(a), "r"(b) : "cc");
  }
#elif HWY_ARCH_ARM_A64
  if constexpr (std::is_same_v<T, float>) {
    asm volatile("fcmp %s0, %s1" ::"w"(a), "w"(b) : "cc");
  } else if constexpr (std::is_same_v<T, double>) {
    asm volatile("fcmp %d0, %d1" ::"w"(a), "w"(b) : "cc");
  } else {
    asm volatile("cmp %w0, %w1" ::"r"(a), "r"(b) : "cc");
  }
#endif
}

struct CompareStep {
  template <class D, class V>
  HWY_INLINE void operator()(D d, V& x, V& c, V&) const {
    (void)d;
#if HWY_TARGET == HWY_SCALAR
    CompareFlags(x.raw, c.raw);
#elif HWY_TARGET == HWY_AVX3
    asm volatile("" ::"k"(hn::Gt(c, x).raw));
#elif HWY_HAVE_SCALABLE
    asm volatile("" ::"Upa"(hn::Gt(c, x)));
#else
    // Over x: two-operand instructions would need a copy otherwise.
    x = hn::VecFromMask(d, hn::Gt(x, c));
#endif
  }
};

// Chains multiply, or multiply-add, and additions beside them read what does
// not change: so all chains are left to the operation that takes longer. The
// copy that two-operand instructions need for it takes no unit that computes.
struct MixedStep {
  template <class D, class V>
  HWY_INLINE void operator()(D, V& x, V& c, V& d) const {
    if constexpr (PITBENCH_FUSED) {
      x = hn::MulAdd(x, c, d);
    } else {
      x = hn::Mul(x, c);
    }
    Launder(c);
    const V sum = hn::Add(c, d);
    Keep(sum);
  }
};

struct TwoAddsStep {
  template <class D, class V>
  HWY_INLINE void operator()(D t, V& x, V& c, V& d) const {
    AddStep()(t, x, c, d);
    Launder(x);
    AddStep()(t, x, c, d);
  }
};
// Apart, so that what a comparison leaves in x is not added to.
struct MinAndCompareStep {
  template <class D, class V>
  HWY_INLINE void operator()(D t, V& x, V& c, V& d) const {
    V least = d;
    Launder(least);
    MinStep()(t, least, c, d);
    Keep(least);
    CompareStep()(t, x, c, d);
  }
};

// Runs a step on each chain; `even` for those at an even place.
template <class T, class Even, class Odd, std::size_t kPerStep>
std::size_t Run(std::size_t rounds) {
  constexpr std::size_t kUnrolled = 4;
  // One-lane integers lie in general registers, of which there are 16.
  constexpr bool kManyRegisters =
      (HWY_TARGET == HWY_AVX3 || HWY_ARCH_ARM_A64) &&
      !(kOneLane && !hwy::IsFloat<T>());
  const Lanes<T> t;
  const Even even{};
  const Odd odd{};
  auto c = hn::Set(t, T{1});
  Launder(c);
  auto d = c;
  Launder(d);
  auto x0 = c, x1 = c, x2 = c, x3 = c, x4 = c, x5 = c;
  auto x6 = c, x7 = c, x8 = c, x9 = c, x10 = c, x11 = c;
  auto y0 = c, y1 = c, y2 = c, y3 = c, y4 = c, y5 = c;
  auto y6 = c, y7 = c, y8 = c, y9 = c, y10 = c, y11 = c;
#define PITBENCH_CHAIN(x, step) \
  step(t, x, c, d);             \
  Launder(x)
  for (std::size_t round = 0; round < rounds; ++round) {
    for (std::size_t k = 0; k < kUnrolled; ++k) {
      PITBENCH_CHAIN(x0, even);
      PITBENCH_CHAIN(x1, odd);
      PITBENCH_CHAIN(x2, even);
      PITBENCH_CHAIN(x3, odd);
      PITBENCH_CHAIN(x4, even);
      PITBENCH_CHAIN(x5, odd);
      PITBENCH_CHAIN(x6, even);
      PITBENCH_CHAIN(x7, odd);
      PITBENCH_CHAIN(x8, even);
      PITBENCH_CHAIN(x9, odd);
      PITBENCH_CHAIN(x10, even);
      PITBENCH_CHAIN(x11, odd);
      if constexpr (kManyRegisters) {
        PITBENCH_CHAIN(y0, even);
        PITBENCH_CHAIN(y1, odd);
        PITBENCH_CHAIN(y2, even);
        PITBENCH_CHAIN(y3, odd);
        PITBENCH_CHAIN(y4, even);
        PITBENCH_CHAIN(y5, odd);
        PITBENCH_CHAIN(y6, even);
        PITBENCH_CHAIN(y7, odd);
        PITBENCH_CHAIN(y8, even);
        PITBENCH_CHAIN(y9, odd);
        PITBENCH_CHAIN(y10, even);
        PITBENCH_CHAIN(y11, odd);
      }
    }
  }
#undef PITBENCH_CHAIN
  constexpr std::size_t kChains = kManyRegisters ? 24 : 12;
  return rounds * kUnrolled * kChains * kPerStep * hn::Lanes(t);
}

template <class T, class Step>
std::size_t RunOne(std::size_t rounds) {
  return Run<T, Step, Step, 1>(rounds);
}

template <class T>
std::size_t RunMixed(std::size_t rounds) {
  return Run<T, MixedStep, MixedStep, 2>(rounds);
}

template <class T>
std::size_t RunAddMinMaxCompare(std::size_t rounds) {
  return Run<T, TwoAddsStep, MinAndCompareStep, 2>(rounds);
}

template <class T>
std::size_t RunMultiplyMultiplyAdd(std::size_t rounds) {
  return Run<T, MultiplyStep, MultiplyAddStep, 1>(rounds);
}

// Twelve vectors a step, kStreams arrays side by side.
template <class T, Access kAccess, std::size_t kStreams>
void Walk(std::byte* memory, std::size_t bytes, std::size_t rounds) {
  const Lanes<T> t;
  const std::size_t lanes = hn::Lanes(t);
  T* const array = reinterpret_cast<T*>(memory);
  const std::size_t length = bytes / sizeof(T) / kStreams;
  constexpr std::size_t kTogether = 12 / kStreams;
  auto c = hn::Set(t, T{1});
  Launder(c);
  const auto visit = [&](T* at) HWY_ATTR {
    if constexpr (kAccess == Access::kLoad) {
      auto v = hn::LoadU(t, at);
      Keep(v);
    } else {
      hn::StoreU(c, t, at);
      Launder(c);  // or the compiler joins stores of equal values
    }
  };
  for (std::size_t round = 0; round < rounds; ++round) {
    std::size_t i = 0;
    for (; i + kTogether * lanes <= length; i += kTogether * lanes) {
      for (std::size_t k = 0; k < kTogether; ++k) {
        for (std::size_t s = 0; s < kStreams; ++s) {
          visit(array + s * length + i + k * lanes);
        }
      }
    }
    for (; i < length; i += lanes) {
      for (std::size_t s = 0; s < kStreams; ++s) visit(array + s * length + i);
    }
    asm volatile("" ::: "memory");  // each round stores again
  }
}

template <class T, class Step>
constexpr OperationProbe Probe(std::string_view scalar, Operation operation) {
  return {kIsa, scalar, operation, RunOne<T, Step>};
}

// The table of this ISA.
constexpr OperationProbe kOperations[] = {
    Probe<float, AddStep>("f32", Operation::kAdd),
    Probe<float, MultiplyStep>("f32", Operation::kMultiply),
    Probe<float, DivideStep>("f32", Operation::kDivide),
    Probe<float, MinStep>("f32", Operation::kMinMax),
    Probe<float, CompareStep>("f32", Operation::kCompare),
    {kIsa, "f32", Operation::kMixed, RunMixed<float>},
    {kIsa, "f32", Operation::kAddMinMaxCompare, RunAddMinMaxCompare<float>},
#if HWY_HAVE_FLOAT64
    Probe<double, AddStep>("f64", Operation::kAdd),
    Probe<double, MultiplyStep>("f64", Operation::kMultiply),
    Probe<double, DivideStep>("f64", Operation::kDivide),
    Probe<double, MinStep>("f64", Operation::kMinMax),
    Probe<double, CompareStep>("f64", Operation::kCompare),
    {kIsa, "f64", Operation::kMixed, RunMixed<double>},
    {kIsa, "f64", Operation::kAddMinMaxCompare, RunAddMinMaxCompare<double>},
#endif
#if PITBENCH_FUSED
    Probe<float, MultiplyAddStep>("f32", Operation::kMultiplyAdd),
    Probe<double, MultiplyAddStep>("f64", Operation::kMultiplyAdd),
    {kIsa, "f32", Operation::kMultiplyMultiplyAdd,
     RunMultiplyMultiplyAdd<float>},
    {kIsa, "f64", Operation::kMultiplyMultiplyAdd,
     RunMultiplyMultiplyAdd<double>},
#endif
    Probe<std::int32_t, AddStep>("i32", Operation::kAdd),
    Probe<std::int32_t, MultiplyStep>("i32", Operation::kIntegerMultiply),
    Probe<std::int32_t, MinStep>("i32", Operation::kMinMax),
    Probe<std::int32_t, CompareStep>("i32", Operation::kCompare),
    Probe<std::int16_t, AddStep>("i16", Operation::kAdd),
    Probe<std::int16_t, MultiplyStep>("i16", Operation::kIntegerMultiply),
    Probe<std::int16_t, MinStep>("i16", Operation::kMinMax),
    Probe<std::int16_t, CompareStep>("i16", Operation::kCompare),
    Probe<std::uint8_t, AddStep>("u8", Operation::kAdd),
    Probe<std::uint8_t, MinStep>("u8", Operation::kMinMax),
    // Highway flips the sign bits to compare unsigned bytes on some ISAs.
    Probe<std::int8_t, CompareStep>("u8", Operation::kCompare),
};

template <class T, Access kAccess, std::size_t kStreams>
constexpr IsaMemoryProbe WalkProbe(const char* scalar) {
  return {scalar, kAccess, kStreams, Walk<T, kAccess, kStreams>};
}
#define PITBENCH_WALKS(scalar, T)             \
  WalkProbe<T, Access::kLoad, 1>(scalar),     \
      WalkProbe<T, Access::kLoad, 2>(scalar), \
      WalkProbe<T, Access::kLoad, 6>(scalar), \
      WalkProbe<T, Access::kStore, 1>(scalar)

constexpr IsaMemoryProbe kMemory[] = {
#if HWY_TARGET == HWY_SCALAR
    PITBENCH_WALKS("f32", float),        PITBENCH_WALKS("f64", double),
    PITBENCH_WALKS("i32", std::int32_t), PITBENCH_WALKS("i16", std::int16_t),
    PITBENCH_WALKS("u8", std::uint8_t),
#else
    PITBENCH_WALKS("", float),
#endif
};

}  // namespace

IsaProbes Probes();
IsaProbes Probes() {
  return {kOperations, sizeof(kOperations) / sizeof(kOperations[0]), kMemory,
          sizeof(kMemory) / sizeof(kMemory[0])};
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();
