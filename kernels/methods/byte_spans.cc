// Point in triangle by the span of the point's row, looked up in a table of
// bytes.
//
//   x − first[y] < count[y] as unsigned numbers
//
// A triangle has one span of columns in each row of points with whole
// coordinates: count[y] columns from first[y] on, none in most rows. A table of
// them is as good as the triangle, and points cost two look-ups, a subtraction
// and a compare, whatever the triangle is. From Ice Lake and Zen 4 on x86 looks
// up 64 bytes in a table of 128 by one instruction (AVX-512 VBMI: VPERMI2B,
// asked for when the kernel runs); elsewhere a look-up has 16 rows, and one is
// taken for each 16 that the triangle reaches into.
// Set-up: 3 edges with a reciprocal each and two divisions a row, each as
// multiplications of 32 rows at once; why these are exact is proved in
// kernels/loops/row_spans-inl.h. A triangle that reaches beyond row 63 has its
// rows divided one by one.
// Boundary: closed. Winding: does not matter. Degenerate: contains nothing.
// Range: coordinates of points and triangles from 0 to 127.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/methods/byte_spans.cc"
#include <hwy/foreach_target.h>

#include "kernels/loops/byte_points-inl.h"
#include "kernels/loops/row_spans-inl.h"
#include "kernels/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

constexpr int kSide = 128;  // coordinates are less

// The vertices by row, each as one number, x + y·2^8, so that minima and maxima
// sort them without a branch.
struct SortedByRow {
  int low, middle, high;
  int area;  // twice; above 0 where the middle lies right of the whole edge

  HWY_INLINE explicit SortedByRow(const Batch<std::uint8_t>& t) {
    const int a = *t.ax | *t.ay << 8;
    const int b = *t.bx | *t.by << 8;
    const int c = *t.cx | *t.cy << 8;
    low = HWY_MIN(HWY_MIN(a, b), c);
    high = HWY_MAX(HWY_MAX(a, b), c);
    middle = a ^ b ^ c ^ low ^ high;
    area = (X(middle) - X(low)) * (Y(high) - Y(low)) -
           (X(high) - X(low)) * (Y(middle) - Y(low));
  }

  static HWY_INLINE int X(int vertex) { return vertex & 0xFF; }
  static HWY_INLINE int Y(int vertex) { return vertex >> 8; }
};

// The edges of one triangle, which is within kMostRows: the whole one, the one
// below the middle vertex and the one above it.
class ByteSpanEdges {
 public:
  HWY_INLINE explicit ByteSpanEdges(const SortedByRow& t)
      : first_(Twice(SortedByRow::Y(t.low))),
        middle_(Twice(SortedByRow::Y(t.middle))),
        last_(Twice(t.area == 0 ? -1 : SortedByRow::Y(t.high))) {
    const int whole_left = -int{t.area > 0};
    const int parts_left = -int{t.area < 0};
#if HWY_TARGET == HWY_SCALAR
    const OneLane<std::int32_t> d;
    const auto set = [&](int from, int to, int left, std::size_t k) {
      SetUp(d, Set(d, from), Set(d, to), Set(d, left), k);
    };
    set(t.low, t.high, whole_left, 0);
    set(t.low, t.middle, parts_left, 1);
    set(t.middle, t.high, parts_left, 2);
#else
    // The three in one vector; the fourth lane is idle.
    const hn::CappedTag<std::int32_t, 4> d;
    SetUp(d, hn::ConcatUpperLower(d, Set(d, t.middle), Set(d, t.low)),
          hn::InterleaveLower(d, Set(d, t.high), Set(d, t.middle)),
          IfThenElse(hn::FirstN(d, 1), Set(d, whole_left), Set(d, parts_left)),
          0);
#endif
  }

  HWY_INLINE SpanTriangle Triangle() const {
    return {{edges_, 0}, {edges_, 1}, {edges_, 2}, first_, middle_, last_};
  }

 private:
  template <class D>
  HWY_INLINE void SetUp(D d, Vec<D> from, Vec<D> to, Vec<D> left,
                        std::size_t k) {
    const auto x = Set(d, 0xFF);
    SetUpEdge(d, And(from, x), hn::ShiftRight<8>(from), And(to, x),
              hn::ShiftRight<8>(to), left, edges_, k);
  }

  SpanEdges edges_;
  std::uint32_t first_, middle_, last_;
};

// Of each row the first column inside and how many there are.
HWY_INLINE void FirstAndCount(SpanLanes d, Vec<SpanLanes> rows,
                              const SpanTriangle& t, Vec<SpanLanes>& first,
                              Vec<SpanLanes>& count) {
  auto u = rows;
  auto v = rows;
  SpanEnds<true>(d, rows, t, u, v);
  first = hn::Min(u, v);
  count = Sub(hn::Max(u, v), first);
}

// The spans of the rows from 0 on.
struct ByteSpans {
  HWY_ALIGN std::uint8_t first[kSide] = {};
  HWY_ALIGN std::uint8_t count[kSide] = {};
};

// Fills in the spans of a triangle of any height, a row and an edge at a time.
HWY_INLINE void DivideRows(const SortedByRow& t, ByteSpans& spans) {
  const int vertices[] = {t.low, t.middle, t.high};
  const int turned = t.area > 0 ? 1 : -1;
  for (int y = SortedByRow::Y(t.low); y <= SortedByRow::Y(t.high); ++y) {
    int first = 0;
    int last = kSide - 1;
    for (int k = 0; k < 3; ++k) {
      const int p = vertices[k];
      const int q = vertices[(k + 1) % 3];
      // A·x + rest ≥ 0 inside.
      const int a = (SortedByRow::Y(p) - SortedByRow::Y(q)) * turned;
      const int b = (SortedByRow::X(q) - SortedByRow::X(p)) * turned;
      const int rest = b * (y - SortedByRow::Y(p)) - a * SortedByRow::X(p);
      const auto floor = [](int n, int d) {
        return n >= 0 ? n / d : -((d - 1 - n) / d);
      };
      if (a > 0) {
        first = HWY_MAX(first, -floor(rest, a));
      } else if (a < 0) {
        last = HWY_MIN(last, floor(rest, -a));
      } else if (rest < 0) {
        last = -1;
      }
    }
    spans.first[y] = static_cast<std::uint8_t>(first);
    spans.count[y] = static_cast<std::uint8_t>(HWY_MAX(last + 1 - first, 0));
  }
}

#if HWY_TARGET == HWY_AVX3

// What looks up bytes in one vector of 64, and in two. As text, since the
// compiler is not told that the CPU has it: HasByteTables says so.
HWY_INLINE bool HasByteTables() {
  return __builtin_cpu_supports("avx512vbmi") != 0;
}
HWY_INLINE __m512i LookUp(__m512i table, __m512i at) {
  __m512i found;
  asm("vpermb %2, %1, %0" : "=v"(found) : "v"(at), "v"(table));
  return found;
}
HWY_INLINE __m512i LookUp(__m512i low, __m512i high, __m512i at) {
  asm("vpermi2b %2, %1, %0" : "+v"(at) : "v"(low), "v"(high));
  return at;
}

// The lower halves of 64 words.
HWY_INLINE __m512i LowerHalves(__m512i words0, __m512i words1) {
  HWY_ALIGN static constexpr auto kEven = [] {
    std::array<std::uint8_t, 64> even{};
    for (std::size_t k = 0; k < 64; ++k) {
      even[k] = static_cast<std::uint8_t>(2 * k);
    }
    return even;
  }();
  return LookUp(words0, words1, _mm512_load_si512(kEven.data()));
}

// What lies behind row 63 is in the second table, where the triangle is too.
static void ByVectorTables(const Batch<std::uint8_t>& batch,
                           const Result<std::uint8_t>& result,
                           const SortedByRow& t) {
  if (HWY_LIKELY(SortedByRow::Y(t.high) < int{kMostRows})) {
    const ByteSpanEdges edges(t);
    const SpanTriangle triangle = edges.Triangle();
    const SpanLanes d;
    const auto rows0 = hn::Iota(d, std::uint16_t{0});
    const auto rows1 = hn::Iota(d, std::uint16_t{32});
    Vec<SpanLanes> first0, first1, count0, count1;
    FirstAndCount(d, rows0, triangle, first0, count0);
    FirstAndCount(d, rows1, triangle, first1, count1);
    const __m512i first = LowerHalves(first0.raw, first1.raw);
    const __m512i count = LowerHalves(count0.raw, count1.raw);
    const __m512i none = _mm512_setzero_si512();
    WriteBytePointWords(batch, result, [=](__m512i x, __m512i y) HWY_ATTR {
      asm("" : "+v"(y));  // else it is loaded twice
      return _mm512_cmplt_epu8_mask(_mm512_sub_epi8(x, LookUp(first, y)),
                                    LookUp(count, none, y));
    });
  } else {
    ByteSpans spans;
    if (t.area != 0) DivideRows(t, spans);
    const __m512i first0 = _mm512_load_si512(spans.first);
    const __m512i first1 = _mm512_load_si512(spans.first + 64);
    const __m512i count0 = _mm512_load_si512(spans.count);
    const __m512i count1 = _mm512_load_si512(spans.count + 64);
    WriteBytePointWords(batch, result, [=](__m512i x, __m512i y) HWY_ATTR {
      const __m512i first = LookUp(first0, first1, y);
      return _mm512_cmplt_epu8_mask(_mm512_sub_epi8(x, first),
                                    LookUp(count0, count1, y));
    });
  }
}

#endif

using Bytes = Lanes<std::uint8_t>;

// Where a table of the 16 rows from `row` on has y; what it has nothing for is
// sent where TableLookupBytesOr0 finds 0.
HWY_INLINE Vec<Bytes> PlaceInTable(Bytes d, Vec<Bytes> y, int row) {
  const auto place = hn::Xor(y, Set(d, static_cast<std::uint8_t>(row)));
#if HWY_ARCH_X86
  return hn::SaturatedAdd(place, Set(d, std::uint8_t{0x70}));
#else
  return Or(place, hn::VecFromMask(d, Gt(place, Set(d, std::uint8_t{15}))));
#endif
}

static void ByTables(const Batch<std::uint8_t>& batch,
                     const Result<std::uint8_t>& result, const SortedByRow& t) {
  const int low = SortedByRow::Y(t.low) & ~15;
  const int high = SortedByRow::Y(t.high);
  ByteSpans spans;
  if (high >= int{kMostRows}) {
    if (t.area != 0) DivideRows(t, spans);
  } else {
    const ByteSpanEdges edges(t);
    const SpanTriangle triangle = edges.Triangle();
    const SpanLanes d;
    const hn::Rebind<std::int16_t, SpanLanes> s;
    const hn::Rebind<std::uint8_t, SpanLanes> bytes;
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int y = low & ~(lanes - 1); y <= high; y += lanes) {
      const auto rows = hn::Iota(d, static_cast<std::uint16_t>(y));
      Vec<SpanLanes> first, count;
      FirstAndCount(d, rows, triangle, first, count);
      hn::StoreU(hn::DemoteTo(bytes, hn::BitCast(s, first)), bytes,
                 spans.first + y);
      hn::StoreU(hn::DemoteTo(bytes, hn::BitCast(s, count)), bytes,
                 spans.count + y);
    }
  }
  const Bytes d;
  const auto inside = [&](const std::uint8_t* px,
                          const std::uint8_t* py) HWY_ATTR {
#if HWY_TARGET == HWY_SCALAR
    const auto first = Set(d, spans.first[*py % kSide]);
    const auto count = Set(d, spans.count[*py % kSide]);
#else
    const auto y = hn::LoadU(d, py);
    auto first = Zero(d);
    auto count = Zero(d);
    for (int row = low; row <= high; row += 16) {
      const auto place = PlaceInTable(d, y, row);
      first = Or(first, hn::TableLookupBytesOr0(
                            hn::LoadDup128(d, spans.first + row), place));
      count = Or(count, hn::TableLookupBytesOr0(
                            hn::LoadDup128(d, spans.count + row), place));
    }
#endif
    // Unsigned numbers are not compared by every ISA.
    const auto left = hn::SaturatedSub(count, Sub(hn::LoadU(d, px), first));
    return hn::Ne(left, Zero(d));
  };
  WriteBytePoints(d, d, batch, result, inside);
}

static void LookUpSpans(const Batch<std::uint8_t>& batch,
                        const Result<std::uint8_t>& result) {
  const SortedByRow triangle(batch);
#if HWY_TARGET == HWY_AVX3
  if (HWY_LIKELY(HasByteTables())) {
    ByVectorTables(batch, result, triangle);
    return;
  }
#endif
  ByTables(batch, result, triangle);
}

constexpr Method kByteSpans{
    .key = "byte_spans",
    .source = "rasterisers' scan lines, as a table of bytes",
    .formula = "x − first[y] < count[y], the span of each row looked up",
};

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

PITBENCH_KERNELS(byte_spans,
                 Rows<1>{
                     MakeKernel<std::uint8_t>(kByteSpans, Loop::kOneTriangle,
                                              Output::kInside, LookUpSpans)});
