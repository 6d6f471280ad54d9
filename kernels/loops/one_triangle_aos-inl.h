// Loop one_triangle_aos: triangle 0 against n points, each with its x and its y
// side by side, as one array of points holds them.
//
// A method takes a vector of x and one of y, so something has to take the pairs
// apart. To do it in the order of the points means moving lanes across the
// whole of a register, which where registers have more than 128 bits takes a
// third of the time of the fastest methods. So there the pairs are taken apart
// within each 128 bits, by one shuffle for x and one for y, and it is the bits
// of the answers that are put in order: one exchange for a whole word of them.
// Multiplying the pairs as they lie and adding neighbours would take as many
// shuffles and round otherwise; here every answer is that of one_triangle.
#if defined(PITBENCH_KERNELS_LOOPS_ONE_TRIANGLE_AOS_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_LOOPS_ONE_TRIANGLE_AOS_INL_H_
#undef PITBENCH_KERNELS_LOOPS_ONE_TRIANGLE_AOS_INL_H_
#else
#define PITBENCH_KERNELS_LOOPS_ONE_TRIANGLE_AOS_INL_H_
#endif

#include "kernels/loops/bits-inl.h"
#include "kernels/loops/one_triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
// Takes the pairs of `a` and `b` apart within each 128 bits: lane by lane, what
// comes of `a` is followed by what comes of `b`.
#if HWY_TARGET == HWY_AVX3
HWY_INLINE void TakeApart(hn::Vec512<float> a, hn::Vec512<float> b,
                          hn::Vec512<float>& x, hn::Vec512<float>& y) {
  x.raw = _mm512_shuffle_ps(a.raw, b.raw, _MM_SHUFFLE(2, 0, 2, 0));
  y.raw = _mm512_shuffle_ps(a.raw, b.raw, _MM_SHUFFLE(3, 1, 3, 1));
}
HWY_INLINE void TakeApart(hn::Vec512<double> a, hn::Vec512<double> b,
                          hn::Vec512<double>& x, hn::Vec512<double>& y) {
  x.raw = _mm512_unpacklo_pd(a.raw, b.raw);
  y.raw = _mm512_unpackhi_pd(a.raw, b.raw);
}
#else
HWY_INLINE void TakeApart(hn::Vec256<float> a, hn::Vec256<float> b,
                          hn::Vec256<float>& x, hn::Vec256<float>& y) {
  x.raw = _mm256_shuffle_ps(a.raw, b.raw, _MM_SHUFFLE(2, 0, 2, 0));
  y.raw = _mm256_shuffle_ps(a.raw, b.raw, _MM_SHUFFLE(3, 1, 3, 1));
}
HWY_INLINE void TakeApart(hn::Vec256<double> a, hn::Vec256<double> b,
                          hn::Vec256<double>& x, hn::Vec256<double>& y) {
  x.raw = _mm256_unpacklo_pd(a.raw, b.raw);
  y.raw = _mm256_unpackhi_pd(a.raw, b.raw);
}
#endif

// How many points share one exchange of their bits, and a word for them.
#if HWY_TARGET == HWY_AVX3
using BlockBits = std::uint64_t;
#else
using BlockBits = std::uint32_t;
#endif
inline constexpr std::size_t kBlockPoints = 8 * sizeof(BlockBits);

// A word of bits in the order of the points.
template <class T>
HWY_INLINE BlockBits OrderedBits(BlockBits word) {
#if HWY_TARGET == HWY_AVX3
  // In the bits of a vector those of `a` and of `b` take turns, one by one or
  // two by two; those of `a` are the first half of them.
  constexpr bool kPairs = sizeof(T) == 4;
  constexpr BlockBits kOfA = kPairs ? 0x3333333333333333 : 0x5555555555555555;
  constexpr BlockBits kFirst = kPairs ? 0x00FF00FF00FF00FF : 0x0F0F0F0F0F0F0F0F;
  return _pdep_u64(_pext_u64(word, kOfA), kFirst) |
         _pdep_u64(_pext_u64(word, ~kOfA), ~kFirst);
#else
  // A vector has two 128-bit lanes, so that it is only the second quarter of
  // its bits and the third that change places. (Gathering takes as long, and on
  // some AMD CPUs a hundred times as long.)
  constexpr unsigned kShift = sizeof(T) == 4 ? 2 : 1;
  constexpr BlockBits kSecond = sizeof(T) == 4 ? 0x0C0C0C0Cu : 0x22222222u;
  const BlockBits differ = (word ^ (word >> kShift)) & kSecond;
  return word ^ differ ^ (differ << kShift);
#endif
}

// Answers for the points of one block, which is read from first to last: f64
// out of order came half as fast from memory (edge_function_fma, Zen 5).
template <class D, class Form>
HWY_INLINE void WriteBlock(D d, const TFromD<D>* block, std::uint8_t* bits,
                           const Form& form) {
  BlockBits word = 0;
#pragma GCC unroll 8
  for (std::size_t v = 0; v < kBlockPoints / kMaxLanes<D>; ++v) {
    const TFromD<D>* const pairs = block + 2 * v * kMaxLanes<D>;
    Vec<D> x, y;
    TakeApart(InRegister(hn::LoadU(d, pairs)),
              InRegister(hn::LoadU(d, pairs + kMaxLanes<D>)), x, y);
    word |= static_cast<BlockBits>(MaskBits(d, form.Inside(d, x, y)))
            << (v * kMaxLanes<D>);
  }
  word = OrderedBits<TFromD<D>>(word);
  std::memcpy(bits, &word, sizeof(word));
}

// Answers for the points of as many whole blocks as there are; says how many.
// A block of the first half of the array and one of the second take turns:
// from memory two streams come faster than one, which the CPU does not fetch
// ahead past the end of a page. (Arrays of x and of y are two by themselves.)
template <class D, class Form>
HWY_INLINE std::size_t WriteBlocks(D d, const TFromD<D>* xy, std::size_t n,
                                   std::uint8_t* bits, const Form& form) {
  const std::size_t done = n / kBlockPoints * kBlockPoints;
  const std::size_t half = n / (2 * kBlockPoints) * kBlockPoints;
  for (std::size_t i = 0; i < half; i += kBlockPoints) {
    WriteBlock(d, xy + 2 * i, bits + i / 8, form);
    WriteBlock(d, xy + 2 * (half + i), bits + (half + i) / 8, form);
  }
  if (2 * half < done) {  // the one that is left of an odd number
    WriteBlock(d, xy + 4 * half, bits + half / 4, form);
  }
  return done;
}
#else
template <class D, class Form>
HWY_INLINE std::size_t WriteBlocks(D, const TFromD<D>*, std::size_t,
                                   std::uint8_t*, const Form&) {
  return 0;
}
#endif

// The last `count` points of an array that ends with them, as a whole vector of
// points: nothing past the end is read.
template <class D>
class TailOfPoints {
  using T = TFromD<D>;

 public:
  HWY_INLINE TailOfPoints(const T* from, std::size_t count) {
    std::memcpy(pairs_, from, 2 * count * sizeof(T));
  }
  const T* data() const { return pairs_; }

 private:
  HWY_ALIGN T pairs_[2 * kMaxLanes<D>] = {};
};

// The inside mask for the vector of points at `pairs`.
template <class D, class Form>
HWY_INLINE Mask<D> InsidePairs(D d, const TFromD<D>* pairs, const Form& form) {
  Vec<D> x, y;
  hn::LoadInterleaved2(d, pairs, x, y);
  return form.Inside(d, x, y);
}

// For the filtered loops, as PointsInTwoArrays: a filter looks at its vectors
// in the order of the points.
template <class T>
struct PointsSideBySide {
  template <bool kExchanged>
  struct Vectors {
    const T* xy;
    template <class D, class Margin>
    static HWY_INLINE Vec<D> Of(D d, const T* pairs, const Margin& margin) {
      Vec<D> x, y;
      hn::LoadInterleaved2(d, pairs, x, y);
      return kExchanged ? margin(y, x, x) : margin(x, y, y);
    }
    template <class D, class Margin>
    HWY_INLINE Vec<D> At(D d, std::size_t i, const Margin& margin) const {
      return Of(d, xy + 2 * i, margin);
    }
    template <class D, class Margin>
    HWY_INLINE Vec<D> TailAt(D d, std::size_t i, std::size_t count,
                             const Margin& margin) const {
      const TailOfPoints<D> tail(xy + 2 * i, count);
      return Of(d, tail.data(), margin);
    }
  };

  HWY_INLINE explicit PointsSideBySide(const Batch<T>& batch) : xy(batch.pxy) {}
  HWY_INLINE T x(std::size_t i) const { return xy[2 * i]; }
  HWY_INLINE T y(std::size_t i) const { return xy[2 * i + 1]; }
  template <class Use>
  HWY_INLINE void Of(bool exchanged, const Use& use) const {
    if (exchanged) {
      use(Vectors<true>{xy});
    } else {
      use(Vectors<false>{xy});
    }
  }

  const T* xy;
};

template <template <class> class M, class T>
static void OneTriangleAos(const Batch<T>& batch, const Result<T>& to) {
  const Result<T> result = to;  // local, so that no store can alias them
  const std::size_t n = batch.n;
  const T* const xy = batch.pxy;
  const OneLane<T> one;
  const M<OneLane<T>> method(
      one, {one, batch.ax, batch.ay, batch.bx, batch.by, batch.cx, batch.cy});
  const Lanes<T> d;
  WalkForm(method, [=](const auto& chosen) HWY_ATTR {
    const auto form = chosen;
    const std::size_t done = WriteBlocks(d, xy, n, result.bits, form);
    const T* const rest = xy + 2 * done;
    WriteBits<4>(
        d, n - done, result.bits + done / 8,
        [=](std::size_t i)
            HWY_ATTR { return InsidePairs(d, rest + 2 * i, form); },
        [=](std::size_t i, std::size_t count) HWY_ATTR {
          const TailOfPoints<Lanes<T>> tail(rest + 2 * i, count);
          return And(InsidePairs(d, tail.data(), form), hn::FirstN(d, count));
        });
  });
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
