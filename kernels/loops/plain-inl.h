// The plain loops of the autovec ISAs: one item after another into a byte
// each, as people write it, and bytes into bits. What becomes of them is the
// compiler's affair.
#if defined(PITBENCH_KERNELS_LOOPS_PLAIN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_LOOPS_PLAIN_INL_H_
#undef PITBENCH_KERNELS_LOOPS_PLAIN_INL_H_
#else
#define PITBENCH_KERNELS_LOOPS_PLAIN_INL_H_
#endif

#include <cstring>

#include "kernels/method-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// Eight bytes, each 0 or 1, as the bits of one byte, the first lowest: the
// product gathers byte k into bit 56 + k.
HWY_INLINE std::uint8_t PackBytes(const std::uint8_t* bytes) {
  std::uint64_t word;
  std::memcpy(&word, bytes, sizeof(word));
  return static_cast<std::uint8_t>((word * 0x0102040810204080u) >> 56);
}

// Writes inside(i), 0 or 1, for i < n as bits.
template <class Inside>
HWY_INLINE void WritePlainBits(std::size_t n, std::uint8_t* bits,
                               const Inside& inside) {
  constexpr std::size_t kBlock = 512;  // bytes; they stay in L1
  for (std::size_t first = 0; first < n; first += kBlock) {
    const std::size_t count = HWY_MIN(kBlock, n - first);
    std::uint8_t bytes[kBlock];
    for (std::size_t i = 0; i < count; ++i) bytes[i] = inside(first + i);
    for (std::size_t i = count; i % 8 != 0; ++i) bytes[i] = 0;
    for (std::size_t i = 0; i < count; i += 8) {
      bits[(first + i) / 8] = PackBytes(bytes + i);
    }
  }
}

template <template <class> class M, class T, Output kOutput>
static void OneTriangle(const Batch<T>& batch, const Result<T>& result) {
  const OneLane<T> one;
  const M<OneLane<T>> method(
      one, {one, batch.ax, batch.ay, batch.bx, batch.by, batch.cx, batch.cy});
  const T* const px = batch.px;
  const T* const py = batch.py;
  WritePlainBits(batch.n, result.bits, [&](std::size_t i) {
    return static_cast<std::uint8_t>(
        method.Inside(one, Set(one, px[i]), Set(one, py[i])).bits & 1);
  });
}

template <template <class> class M, class T>
static void OneTriangleAos(const Batch<T>& batch, const Result<T>& result) {
  const OneLane<T> one;
  const M<OneLane<T>> method(
      one, {one, batch.ax, batch.ay, batch.bx, batch.by, batch.cx, batch.cy});
  const T* const xy = batch.pxy;
  WritePlainBits(batch.n, result.bits, [&](std::size_t i) {
    return static_cast<std::uint8_t>(
        method.Inside(one, Set(one, xy[2 * i]), Set(one, xy[2 * i + 1])).bits &
        1);
  });
}

template <template <class> class M, class T, Output kOutput>
static void OnePoint(const Batch<T>& batch, const Result<T>& result) {
  const OneLane<T> one;
  const Batch<T> b = batch;
  const T x = b.n == 0 ? T{0} : *b.px;
  const T y = b.n == 0 ? T{0} : *b.py;
  WritePlainBits(b.n, result.bits, [&](std::size_t i) {
    const M<OneLane<T>> method(
        one, {one, b.ax + i, b.ay + i, b.bx + i, b.by + i, b.cx + i, b.cy + i});
    return static_cast<std::uint8_t>(
        method.Inside(one, Set(one, x), Set(one, y)).bits & 1);
  });
}

template <template <class> class M, class T, Output kOutput>
static void Pairs(const Batch<T>& batch, const Result<T>& result) {
  const OneLane<T> one;
  const Batch<T> b = batch;
  WritePlainBits(b.n, result.bits, [&](std::size_t i) {
    const M<OneLane<T>> method(
        one, {one, b.ax + i, b.ay + i, b.bx + i, b.by + i, b.cx + i, b.cy + i});
    return static_cast<std::uint8_t>(
        method.Inside(one, Set(one, b.px[i]), Set(one, b.py[i])).bits & 1);
  });
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
