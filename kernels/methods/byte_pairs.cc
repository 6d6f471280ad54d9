// Point in triangle by two edge functions of bytes, two products an
// instruction.
//
//   e_k = (A_k, B_k)·(x, y) + C_k, inside iff e_0 ⊞ e_1 ≤ K as unsigned numbers
//
// The three edge functions add up to K, twice the area, everywhere, so the
// third is not negative iff e_0 + e_1 ≤ K. Taken as unsigned numbers of 16
// bits, a negative e_0 or e_1 is greater than any K, and ⊞, the sum that
// saturates, is not less than either: one comparison decides all three. x86
// multiplies bytes in pairs and adds the two products to one number of 16 bits
// (maddubs), so that x and y stay two bytes of a lane. Other ISAs have no such
// instruction: they widen the bytes to lanes of 16 bits. Set-up: 2 edges, 4
// multiplications, and the area. Per point: 2 products of pairs, 3 additions, 1
// compare. Boundary: closed. Winding: fixed by the set-up. Degenerate: contains
// nothing. Range: coordinates of points and triangles from 0 to 127. A and B
// are then signed bytes; A·x + B·y, C and e are at most 2·127² in size and K at
// most 127², so nothing saturates before ⊞ and a negative e is at least 2^16 −
// 2·127² > K.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/byte_pairs.cc"
#include <hwy/foreach_target.h>

#include "kernels/loops/byte_points-inl.h"
#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// A·x + B·y + C of edges AB and BC, not negative inside, and the sum of all
// three.
struct ByteEdges {
  std::int16_t a[2], b[2], c[2];
  std::uint16_t sum;

  // The winding is neither branched on, since no predictor knows that of the
  // next triangle, nor multiplied by, since the points wait for all of this. A
  // triangle without area is below 0 everywhere.
  HWY_INLINE explicit ByteEdges(const Batch<std::uint8_t>& t) {
    const int x[] = {*t.ax, *t.bx, *t.cx};
    const int y[] = {*t.ay, *t.by, *t.cy};
    const int area =
        (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    const int clockwise = -int{area < 0};
    const int real = -int{area != 0};
    const auto turned = [clockwise, real](int v) {
      return ((v ^ clockwise) - clockwise) & real;
    };
    for (int k = 0; k < 2; ++k) {
      const int right = y[k] - y[k + 1];
      const int down = x[k + 1] - x[k];
      a[k] = static_cast<std::int16_t>(turned(right));
      b[k] = static_cast<std::int16_t>(turned(down));
      c[k] = static_cast<std::int16_t>(turned(-(right * x[k] + down * y[k])));
    }
    c[0] = static_cast<std::int16_t>(c[0] - int{area == 0});
    sum = static_cast<std::uint16_t>(turned(area));
  }
};

// e_0 ⊞ e_1, lanes of 16 bits taken as unsigned.
template <class V>
HWY_INLINE auto Sum(V e0, V e1) {
  const hn::RebindToUnsigned<hn::DFromV<V>> u;
  return hn::SaturatedAdd(hn::BitCast(u, e0), hn::BitCast(u, e1));
}

#if HWY_TARGET == HWY_SSSE3 || HWY_TARGET == HWY_SSE4 || \
    HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3

using Bytes = hn::ScalableTag<std::uint8_t>;
using Words = hn::ScalableTag<std::int16_t>;

// Sums of the products of pairs.
HWY_INLINE Vec<Words> SumOfPairs(Vec<Bytes> points, Vec<Words> factors) {
#if HWY_TARGET == HWY_AVX3
  return Vec<Words>{_mm512_maddubs_epi16(points.raw, factors.raw)};
#elif HWY_TARGET == HWY_AVX2
  return Vec<Words>{_mm256_maddubs_epi16(points.raw, factors.raw)};
#else
  return Vec<Words>{_mm_maddubs_epi16(points.raw, factors.raw)};
#endif
}

class EdgesOfPairs {
 public:
  HWY_INLINE explicit EdgesOfPairs(const ByteEdges& edges)
      : ab_(Factors(edges, 0)),
        bc_(Factors(edges, 1)),
        c_ab_(Set(Words(), edges.c[0])),
        c_bc_(Set(Words(), edges.c[1])) {}

  // e_0 ⊞ e_1 of the points that are the pairs of bytes of `pairs`.
  HWY_INLINE auto Sums(Vec<Bytes> pairs) const {
    return Sum(Add(SumOfPairs(pairs, ab_), c_ab_),
               Add(SumOfPairs(pairs, bc_), c_bc_));
  }

 private:
  static HWY_INLINE Vec<Words> Factors(const ByteEdges& edges, int k) {
    const int pair = (edges.a[k] & 0xFF) | (edges.b[k] & 0xFF) << 8;
    return Set(Words(), static_cast<std::int16_t>(pair));
  }

  Vec<Words> ab_, bc_, c_ab_, c_bc_;
};

#if HWY_TARGET == HWY_AVX3

// Interleaving makes pairs in two vectors, which hold in turn eight points
// each: so do the bytes of their two masks.
static void BytePairs(const Batch<std::uint8_t>& batch,
                      const Result<std::uint8_t>& result) {
  const ByteEdges factors(batch);
  const EdgesOfPairs edges(factors);
  const __m512i sum = _mm512_set1_epi16(static_cast<std::int16_t>(factors.sum));
  const auto inside = [=](__m512i px, __m512i py) HWY_ATTR {
    // Else the compiler loads both twice.
    asm("" : "+v"(px), "+v"(py));
    const Vec<Bytes> x{px};
    const Vec<Bytes> y{py};
    const auto low = edges.Sums(hn::InterleaveLower(Bytes(), x, y));
    const auto high = edges.Sums(hn::InterleaveUpper(Bytes(), x, y));
    return _pdep_u64(_mm512_cmple_epu16_mask(low.raw, sum),
                     0x00FF00FF00FF00FF) |
           _pdep_u64(_mm512_cmple_epu16_mask(high.raw, sum),
                     0xFF00FF00FF00FF00);
  };
  WriteBytePointWords(batch, result, inside);
}

#else

// Two vectors of 16-bit lanes as one of bytes that saturate, within each block
// of 16 bytes.
HWY_INLINE Vec<Bytes> Pack(Vec<Words> low, Vec<Words> high) {
#if HWY_TARGET == HWY_AVX2
  return Vec<Bytes>{_mm256_packs_epi16(low.raw, high.raw)};
#else
  return Vec<Bytes>{_mm_packs_epi16(low.raw, high.raw)};
#endif
}

// Interleaving makes pairs in two vectors and packing joins these, both within
// blocks of 16 bytes, so that points come out in their order.
static void BytePairs(const Batch<std::uint8_t>& batch,
                      const Result<std::uint8_t>& result) {
  const Bytes d;
  const ByteEdges factors(batch);
  const EdgesOfPairs edges(factors);
  const hn::RebindToUnsigned<Words> u;
  const auto sum = Set(u, factors.sum);
  // 0 where a pair is inside.
  const auto beyond = [&](Vec<Bytes> pairs) HWY_ATTR {
    return hn::BitCast(Words(), hn::SaturatedSub(edges.Sums(pairs), sum));
  };
  const auto inside = [&](const std::uint8_t* px,
                          const std::uint8_t* py) HWY_ATTR {
    const auto x = hn::LoadU(d, px);
    const auto y = hn::LoadU(d, py);
    return hn::Eq(Pack(beyond(hn::InterleaveLower(d, x, y)),
                       beyond(hn::InterleaveUpper(d, x, y))),
                  Zero(d));
  };
  WriteBytePoints(d, d, batch, result, inside);
}

#endif
#else

static void BytePairs(const Batch<std::uint8_t>& batch,
                      const Result<std::uint8_t>& result) {
  const Lanes<std::int16_t> d;
  const hn::Rebind<std::uint8_t, decltype(d)> bytes;
  const hn::RebindToUnsigned<decltype(d)> u;
  const ByteEdges edges(batch);
  const auto inside = [&](const std::uint8_t* px,
                          const std::uint8_t* py) HWY_ATTR {
    const auto x = hn::PromoteTo(d, hn::LoadU(bytes, px));
    const auto y = hn::PromoteTo(d, hn::LoadU(bytes, py));
    const auto at = [&](int k) HWY_ATTR {
      return Add(Add(Mul(Set(d, edges.a[k]), x), Mul(Set(d, edges.b[k]), y)),
                 Set(d, edges.c[k]));
    };
    const auto sum = Sum(at(0), at(1));  // unsigned: no Le on every target
    return hn::RebindMask(d, hn::Eq(hn::Min(sum, Set(u, edges.sum)), sum));
  };
  WriteBytePoints(d, bytes, batch, result, inside);
}

#endif

constexpr Method kBytePairs{
    .key = "byte_pairs",
    .source = "Pineda 1988, as pairs of bytes",
    .formula =
        "(A, B)·(x, y) + C for two edges, their saturating sum ≤ twice the "
        "area",
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(byte_pairs,
                 Rows<1>{MakeKernel<std::uint8_t>(kBytePairs,
                                                  Loop::kOneTriangle,
                                                  Output::kInside, BytePairs)});
