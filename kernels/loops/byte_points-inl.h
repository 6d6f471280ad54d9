// How points of bytes are walked: by vectors, or on AVX-512 64 at a time, whose
// answers are one word.
#if defined(PITBENCH_KERNELS_LOOPS_BYTE_POINTS_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_LOOPS_BYTE_POINTS_INL_H_
#undef PITBENCH_KERNELS_LOOPS_BYTE_POINTS_INL_H_
#else
#define PITBENCH_KERNELS_LOOPS_BYTE_POINTS_INL_H_
#endif

#include <cstring>

#include "kernels/loops/bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// Writes the answers of inside(px, py), which takes as many points as d has
// lanes, from as many bytes as `bytes` has.
template <class D, class Bytes, class Inside>
HWY_INLINE void WriteBytePoints(D d, Bytes, const Batch<std::uint8_t>& batch,
                                const Result<std::uint8_t>& result,
                                const Inside& inside) {
  const std::uint8_t* const px = batch.px;
  const std::uint8_t* const py = batch.py;
  WriteBits(
      d, batch.n, result.bits,
      [&](std::size_t i) HWY_ATTR { return inside(px + i, py + i); },
      [&](std::size_t i, std::size_t count) HWY_ATTR {
        const Tail<Bytes> x(px + i, count);
        const Tail<Bytes> y(py + i, count);
        return And(inside(x.data(), y.data()), hn::FirstN(d, count));
      });
}

#if HWY_TARGET == HWY_AVX3
// Writes the answers of inside(x, y), a bit for each of 64 points. It should
// hold what it needs by value, as those of WriteBits.
template <class Inside>
HWY_INLINE void WriteBytePointWords(const Batch<std::uint8_t>& batch,
                                    const Result<std::uint8_t>& result,
                                    const Inside& inside) {
  const std::uint8_t* const px = batch.px;
  const std::uint8_t* const py = batch.py;
  std::uint8_t* const bits = result.bits;
  const std::size_t n = batch.n;
  const auto write = [=](std::size_t i) HWY_ATTR
      __attribute__((always_inline)) {
    const std::uint64_t word =
        inside(_mm512_loadu_si512(px + i), _mm512_loadu_si512(py + i));
    std::memcpy(bits + i / 8, &word, sizeof(word));
  };
  // Eight vectors a turn: so few turns that a predictor knows the last, and the
  // next call begins before this one has ended.
  std::size_t i = 0;
  for (; i + 512 <= n; i += 512) {
    HWY_UNROLL(8)
    for (std::size_t j = 0; j < 512; j += 64) write(i + j);
  }
  for (; i + 64 <= n; i += 64) write(i);
  if (i == n) return;
  // What a mask leaves out is neither read nor written.
  const std::uint64_t real = (std::uint64_t{1} << (n - i)) - 1;
  const std::uint64_t word =
      real & inside(_mm512_maskz_loadu_epi8(real, px + i),
                    _mm512_maskz_loadu_epi8(real, py + i));
  _mm_mask_storeu_epi8(bits + i / 8,
                       static_cast<__mmask16>((1u << BitBytes(n - i)) - 1),
                       _mm_cvtsi64_si128(static_cast<std::int64_t>(word)));
}
#endif

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
