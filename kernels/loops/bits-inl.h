// How the answers of a loop become bits, and how its tail is read.
#if defined(PITBENCH_KERNELS_LOOPS_BITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_LOOPS_BITS_INL_H_
#undef PITBENCH_KERNELS_LOOPS_BITS_INL_H_
#else
#define PITBENCH_KERNELS_LOOPS_BITS_INL_H_
#endif

#include <cstring>

#include "kernels/method-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

#if HWY_TARGET == HWY_SSSE3 || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2
HWY_INLINE unsigned SignBits(__m128 v) {
  return static_cast<unsigned>(_mm_movemask_ps(v));
}
HWY_INLINE unsigned SignBits(__m128d v) {
  return static_cast<unsigned>(_mm_movemask_pd(v));
}
#if HWY_TARGET == HWY_AVX2
HWY_INLINE unsigned SignBits(__m256 v) {
  return static_cast<unsigned>(_mm256_movemask_ps(v));
}
HWY_INLINE unsigned SignBits(__m256d v) {
  return static_cast<unsigned>(_mm256_movemask_pd(v));
}
#endif
#endif

// The lanes of `mask` as bits, lane 0 in bit 0. The word is no wider than the
// mask, so that the compiler keeps it in a register.
template <class D>
HWY_INLINE std::uint64_t MaskBits(D d, Mask<D> mask) {
#if HWY_TARGET == HWY_SSSE3 || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2
  // What StoreMaskBits does, without the detour over a byte.
  if constexpr (std::is_floating_point_v<TFromD<D>>) return SignBits(mask.raw);
#endif
#if HWY_HAVE_SCALABLE
  std::uint64_t word = 0;
#else
  constexpr std::size_t kLanes = kMaxLanes<D>;
  std::conditional_t<
      (kLanes <= 8), std::uint8_t,
      std::conditional_t<
          (kLanes <= 16), std::uint16_t,
          std::conditional_t<(kLanes <= 32), std::uint32_t, std::uint64_t>>>
      word = 0;
#endif
  hn::StoreMaskBits(d, mask, reinterpret_cast<std::uint8_t*>(&word));
  return word;
}

// Writes the answers for items i to i + max(Lanes(d), 8) to `to`.
template <class D, class MaskAt>
HWY_INLINE void WriteStep(D d, std::size_t i, std::uint8_t* to,
                          const MaskAt& mask_at) {
  const std::size_t lanes = hn::Lanes(d);
  if (lanes >= 8) {
    hn::StoreMaskBits(d, mask_at(i), to);
  } else {
    std::uint64_t byte = 0;
    for (std::size_t j = 0; j < 8; j += lanes) {
      byte |= MaskBits(d, mask_at(i + j)) << j;
    }
    *to = static_cast<std::uint8_t>(byte);
  }
}

// Writes n answers to `bits`. mask_at(i) answers for items i to i + Lanes(d),
// all of which exist; tail_at(i, count) for the last count < Lanes(d) items
// and false for the lanes after them. Both should hold what they need by value:
// what they hold by reference the compiler loads again after each store of
// bits. kVectors a round: what a loop costs by itself shows where an answer
// takes a few instructions.
template <std::size_t kVectors = 1, class D, class MaskAt, class TailAt>
HWY_INLINE void WriteBits(D d, std::size_t n, std::uint8_t* bits,
                          const MaskAt& mask_at, const TailAt& tail_at) {
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t step = HWY_MAX(lanes, std::size_t{8});
  constexpr std::size_t kSteps =
      HWY_MAX(std::size_t{1}, HWY_MIN(kVectors, kVectors * kMaxLanes<D> / 8));
  std::size_t i = 0;
  // Counted apart from i: to divide it takes longer.
  std::uint8_t* to = bits;
  for (std::size_t left = n / (kSteps * step); left != 0; --left) {
#pragma GCC unroll 4
    for (std::size_t k = 0; k < kSteps; ++k) {
      WriteStep(d, i + k * step, to + k * (step / 8), mask_at);
    }
    i += kSteps * step;
    to += kSteps * (step / 8);
  }
  if constexpr (kSteps > 1) {
    for (; i + step <= n; i += step, to += step / 8) {
      WriteStep(d, i, to, mask_at);
    }
  }
  if (i == n) return;
  std::uint64_t word = 0;
  const std::size_t first = i;
  for (; i + lanes <= n; i += lanes) {
    word |= MaskBits(d, mask_at(i)) << (i - first);
  }
  if (i < n) word |= MaskBits(d, tail_at(i, n - i)) << (i - first);
  std::memcpy(to, &word, BitBytes(n - first));
}

// The last `count` elements of an array that ends with them, as a whole
// vector: nothing past the end is read.
template <class D>
class Tail {
  using T = TFromD<D>;

 public:
  HWY_INLINE Tail(const T* from, std::size_t count) {
    std::memcpy(lanes_, from, count * sizeof(T));
  }
  const T* data() const { return lanes_; }

 private:
  HWY_ALIGN T lanes_[kMaxLanes<D>] = {};
};

// Stores `v` at `to`, but only its first `count` lanes.
template <class D>
HWY_INLINE void StoreTail(D d, Vec<D> v, TFromD<D>* to, std::size_t count) {
  HWY_ALIGN TFromD<D> lanes[kMaxLanes<D>];
  hn::Store(v, d, lanes);
  std::memcpy(to, lanes, count * sizeof(TFromD<D>));
}

// Stores `a`, `b` and `c`; their first `count` lanes unless kWhole promises
// that there is room for all.
template <bool kWhole, class D, class T = TFromD<D>>
HWY_INLINE void StoreThree(D d, Vec<D> a, Vec<D> b, Vec<D> c, T* to_a, T* to_b,
                           T* to_c, std::size_t count) {
  if constexpr (kWhole) {
    hn::StoreU(a, d, to_a);
    hn::StoreU(b, d, to_b);
    hn::StoreU(c, d, to_c);
  } else {
    StoreTail(d, a, to_a, count);
    StoreTail(d, b, to_b, count);
    StoreTail(d, c, to_c, count);
  }
}

// The inside mask of `method`; stores the weights as well where kOutput says
// so. `count` lanes are real; kWhole promises that all of them are.
template <Output kOutput, bool kWhole, class M, class D>
HWY_INLINE Mask<D> Answer(const M& method, D d, Vec<D> x, Vec<D> y,
                          const Result<TFromD<D>>& result, std::size_t i,
                          std::size_t count) {
  if constexpr (kOutput == Output::kWeights) {
    auto wa = x;
    auto wb = x;
    auto wc = x;
    method.Weights(d, x, y, wa, wb, wc);
    StoreThree<kWhole>(d, wa, wb, wc, result.w[0] + i, result.w[1] + i,
                       result.w[2] + i, count);
  }
  const auto inside = method.Inside(d, x, y);
  if constexpr (kWhole) {
    return inside;
  } else {
    return And(inside, hn::FirstN(d, count));
  }
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
