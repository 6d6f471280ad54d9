// Row spans written as rows of bits.
//
// A span is the difference of two prefixes: the bits from u up to v are those
// below v and not below u, so one exclusive or makes a row, whichever is less.
#if defined(PITBENCH_KERNELS_LOOPS_SPAN_BITS_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_LOOPS_SPAN_BITS_INL_H_
#undef PITBENCH_KERNELS_LOOPS_SPAN_BITS_INL_H_
#else
#define PITBENCH_KERNELS_LOOPS_SPAN_BITS_INL_H_
#endif

#include <cstring>

#include "kernels/loops/row_spans-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// of[k] has its first k bits set.
struct Prefixes {
  alignas(16) std::uint64_t of[kMostColumns + 1][2] = {};

  constexpr Prefixes() {
    for (std::size_t k = 0; k <= kMostColumns; ++k) {
      for (std::size_t bit = 0; bit < k; ++bit) {
        of[k][bit / 64] |= std::uint64_t{1} << (bit % 64);
      }
    }
  }
};
constexpr Prefixes kPrefixes;

// A row of up to 128 bits: those between u and v.
struct WideRow {
  std::uint64_t low, high;
};
HWY_INLINE WideRow RowBetween(std::size_t u, std::size_t v) {
  return {kPrefixes.of[u][0] ^ kPrefixes.of[v][0],
          kPrefixes.of[u][1] ^ kPrefixes.of[v][1]};
}

// The same to 16 bytes at `to`.
HWY_INLINE void StoreRowBetween(std::size_t u, std::size_t v,
                                std::uint8_t* to) {
#if HWY_TARGET == HWY_SCALAR
  const WideRow row = RowBetween(u, v);
  std::memcpy(to, &row, sizeof(row));
#else
  const hn::Full128<std::uint64_t> d;
  const hn::Full128<std::uint8_t> bytes;
  hn::StoreU(hn::BitCast(bytes, hn::Xor(hn::Load(d, kPrefixes.of[u]),
                                        hn::Load(d, kPrefixes.of[v]))),
             bytes, to);
#endif
}

// Triangle k to `rows`, a row of 16 bytes after the other, each over what the
// one before wrote past its end; `spare` is how many bytes behind these rows
// may be written to as well.
HWY_INLINE void WriteSpanRows(const SpanTriangles& t, std::size_t k,
                              std::size_t width, std::size_t height,
                              std::uint8_t* rows, std::size_t spare) {
  const SpanLanes d;
  const std::size_t lanes = hn::Lanes(d);
  HWY_ALIGN std::uint16_t u[kMostRows];
  HWY_ALIGN std::uint16_t v[kMostRows];
  const SpanTriangle triangle = TriangleOf(t, k);
  auto row = hn::Iota(d, std::uint16_t{0});
  for (std::size_t y = 0; y < height; y += lanes) {
    auto from = row;
    auto to = row;
    SpanEnds<true>(d, row, triangle, from, to);
    hn::Store(from, d, u + y);
    hn::Store(to, d, v + y);
    row = Add(row, Set(d, static_cast<std::uint16_t>(lanes)));
  }
  const std::size_t row_bytes = BitBytes(width);
  const std::size_t bytes = row_bytes * height;
  const std::size_t room = bytes + spare;
  std::size_t whole = height;  // rows with 16 bytes to write to
  while (whole > 0 && (whole - 1) * row_bytes + 16 > room) --whole;
  for (std::size_t y = 0; y < whole; ++y) {
    StoreRowBetween(u[y], v[y], rows + y * row_bytes);
  }
  for (std::size_t y = whole; y < height; ++y) {
    const WideRow last = RowBetween(u[y], v[y]);
    std::memcpy(rows + y * row_bytes, &last, row_bytes);
  }
}

#if HWY_TARGET == HWY_AVX3
// Rows of 10 bytes as a stream of words: word j belongs to row j / 5 and has
// its columns from 16·(j mod 5) on. 160 words are 32 rows, so five vectors of
// words and then the next 32 rows in the same way.
inline constexpr std::size_t kWordsARow = 5;
struct WordPlaces {
  alignas(64) std::uint16_t row[kWordsARow][32] = {};
  alignas(64) std::uint16_t column[kWordsARow][32] = {};

  constexpr WordPlaces() {
    for (std::size_t j = 0; j < kWordsARow * 32; ++j) {
      row[j / 32][j % 32] = static_cast<std::uint16_t>(j / kWordsARow);
      column[j / 32][j % 32] = static_cast<std::uint16_t>(j % kWordsARow * 16);
    }
  }
};
inline constexpr WordPlaces kWordPlaces;

// In each word the bits from that many columns on, of those that are ≥ 0.
HWY_INLINE __m512i BitsFrom(__m512i ends, __m512i row, __m512i column) {
  const __m512i end = _mm512_permutexvar_epi16(row, ends);
  // Shifts of 16 and more leave nothing.
  return _mm512_sllv_epi16(_mm512_set1_epi16(-1),
                           _mm512_subs_epu16(end, column));
}

// The same for the words of a vector of which all registers are at hand: left
// to itself, the compiler loads them again for every triangle.
struct WordRegisters {
  __m512i row[kWordsARow], column[kWordsARow];

  HWY_INLINE WordRegisters() {
    for (std::size_t j = 0; j < kWordsARow; ++j) {
      row[j] = _mm512_load_si512(kWordPlaces.row[j]);
      column[j] = _mm512_load_si512(kWordPlaces.column[j]);
      asm("" : "+v"(row[j]), "+v"(column[j]));
    }
  }
};

// Writes up to kWordsARow vectors: `words` words, and where kSpare says that
// there is room behind them the rest of a vector too.
template <bool kSpare>
HWY_INLINE void WriteWords(const WordRegisters& at, __m512i u, __m512i v,
                           std::size_t words, std::uint8_t* to) {
  const auto bits = [&](std::size_t j) HWY_ATTR {
    return _mm512_xor_si512(BitsFrom(u, at.row[j], at.column[j]),
                            BitsFrom(v, at.row[j], at.column[j]));
  };
  HWY_UNROLL(5)
  for (std::size_t j = 0; j < kWordsARow; ++j) {
    if (words <= 32 * j) return;
    if (kSpare || words >= 32 * (j + 1)) {
      _mm512_storeu_si512(to + 64 * j, bits(j));
    } else {
      const std::uint64_t rest = (std::uint64_t{1} << (words - 32 * j)) - 1;
      _mm512_mask_storeu_epi16(to + 64 * j, static_cast<__mmask32>(rest),
                               bits(j));
    }
  }
}

// Triangles 0 to `count` of rows of 10 bytes, of which 64 bytes behind them
// may be written to as well if kSpare.
template <bool kSpare>
HWY_INLINE void WriteSpanWords(const SpanTriangles& t, std::size_t first,
                               std::size_t behind, std::size_t height,
                               std::uint8_t* rows) {
  const SpanLanes d;
  const WordRegisters at;
  const auto low_rows = hn::Iota(d, std::uint16_t{0});
  const auto high_rows = hn::Iota(d, std::uint16_t{32});
  const std::size_t words = kWordsARow * height;
  for (std::size_t k = first; k < behind; ++k) {
    const SpanTriangle triangle = TriangleOf(t, k);
    auto low_u = low_rows;
    auto low_v = low_rows;
    auto high_u = low_rows;
    auto high_v = low_rows;
    // Both before the first is stored, which might, as far as the compiler
    // knows, change what the second is made of.
    SpanEnds<false>(d, low_rows, triangle, low_u, low_v);
    if (height > 32) {
      SpanEnds<false>(d, high_rows, triangle, high_u, high_v);
    }
    WriteWords<kSpare>(at, low_u.raw, low_v.raw, words, rows);
    if (height > 32) {
      WriteWords<kSpare>(at, high_u.raw, high_v.raw, words - 160, rows + 320);
    }
    rows += 2 * words;
  }
}
#endif

// Triangles set up kAtOnce lanes at a time: a vector of them, or one by one.
template <bool kMany>
static void RowSpans(const Batch<std::int32_t>& batch,
                     const Result<std::int32_t>& result) {
  const Batch<std::int32_t> b = batch;  // local, so that no store can alias it
  const std::size_t bytes = b.height * BitBytes(b.width);
  if (bytes == 0) return;
  const bool fits = b.width <= kMostColumns && b.height <= kMostRows;
  const hn::CappedTag<std::int32_t, kMany ? kSpanBlock : 1> d;
  const OneLane<std::int32_t> one;
  const std::size_t lanes = hn::Lanes(d);
  SpanTriangles spans;
  for (std::size_t first = 0; first < b.n; first += kSpanBlock) {
    const std::size_t count = HWY_MIN(kSpanBlock, b.n - first);
    bool in_grid = fits;
    if (fits) {
      std::size_t k = 0;
      for (; k + lanes <= count; k += lanes) {
        in_grid &= SetUpSpans(d, b, first + k, spans, k);
      }
      for (; k < count; ++k) {
        in_grid &= SetUpSpans(one, b, first + k, spans, k);
      }
      k = 0;
#if HWY_TARGET == HWY_AVX3
      if (BitBytes(b.width) == 2 * kWordsARow) {
        // Behind all but the last few triangles of the call there is room.
        const std::size_t need = 63 / bytes + 1;
        const std::size_t last = b.n - HWY_MIN(need, b.n);
        const std::size_t roomy = HWY_MIN(count, last - HWY_MIN(last, first));
        std::uint8_t* const rows = result.bits + first * bytes;
        WriteSpanWords<true>(spans, 0, roomy, b.height, rows);
        WriteSpanWords<false>(spans, roomy, count, b.height,
                              rows + roomy * bytes);
        k = count;
      }
#endif
      for (; k < count; ++k) {
        std::uint8_t* const rows = result.bits + (first + k) * bytes;
        const std::size_t spare = (b.n - 1 - first - k) * bytes;
        WriteSpanRows(spans, k, b.width, b.height, rows, spare);
      }
    }
    if (in_grid) continue;
    for (std::size_t t = first; t < first + count; ++t) {
      if (fits && LiesInGrid(b, t)) continue;
      IncrementalTriangle<true>(b, t, result.bits + t * bytes, 0);
    }
  }
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
