// The loops of the exact methods: a filter decides nearly every point, and the
// few that it cannot decide go to exact arithmetic. What a margin is, is in
// margins-inl.h, and why it can be trusted in filters-inl.h.
#if defined(PITBENCH_KERNELS_LOOPS_FILTERED_INL_H_) == \
    defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_LOOPS_FILTERED_INL_H_
#undef PITBENCH_KERNELS_LOOPS_FILTERED_INL_H_
#else
#define PITBENCH_KERNELS_LOOPS_FILTERED_INL_H_
#endif

#include "kernels/loops/bits-inl.h"
#include "kernels/loops/filters-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

// Answers for items `first` to `end`, of which those that their margin leaves
// undecided are answered by contains(i). `first` is a multiple of 8; bits past
// `end` in its last byte become 0. See WriteFiltered, whose functions are
// copied here: if their addresses got out, every bit stored might change what
// they hold, and the compiler would load it all again for each vector.
template <class D, class MarginAt, class TailAt, class Contains>
static HWY_NOINLINE void Decide(D d, std::size_t first, std::size_t end,
                                TFromD<D> decided_above, std::uint8_t* bits,
                                MarginAt margin_at, TailAt tail_at,
                                Contains contains) {
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t step = HWY_MAX(lanes, std::size_t{8});
  for (; first < end; first += step) {
    const std::size_t count = HWY_MIN(step, end - first);
    std::uint64_t inside = 0;
    std::uint64_t undecided = 0;
    for (std::size_t j = 0; j < count; j += lanes) {
      const std::size_t exist = HWY_MIN(lanes, count - j);
      const auto margin =
          exist == lanes ? margin_at(first + j) : tail_at(first + j, exist);
      const std::uint64_t real = ~std::uint64_t{0} >> (64 - exist);
      const Verdict verdict = VerdictOf(d, margin, decided_above);
      inside |= (verdict.inside & real) << j;
      undecided |= (~(verdict.inside | verdict.outside) & real) << j;
    }
    for (; undecided != 0; undecided &= undecided - 1) {
      const auto bit = hwy::Num0BitsBelowLS1Bit_Nonzero64(undecided);
      inside |= std::uint64_t{contains(first + bit)} << bit;
    }
    std::uint8_t* const to = bits + first / 8;
    if (HWY_LIKELY(count == step)) {  // of a size that is known, mostly
      std::memcpy(to, &inside, step / 8);
    } else {
      std::memcpy(to, &inside, BitBytes(count));
    }
  }
}

// Items of a step: two vectors, or as many as make a byte.
template <class D>
HWY_INLINE std::size_t FilteredStep(D d) {
  return 2 * HWY_MAX(hn::Lanes(d), std::size_t{4});
}

// Writes what the margins of the step of items from `start` on say if they
// decide; gives what tells whether they do, and adds to `watch`.
template <bool kMayBeNaN, class D, class MarginAt>
HWY_INLINE Vec<D> WriteFilteredStep(D d, std::size_t start,
                                    TFromD<D> decided_above, std::uint8_t* to,
                                    const MarginAt& margin_at, Vec<D>& watch) {
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t step = FilteredStep(d);
  std::uint64_t byte = 0;
  auto of_step = watch;
  for (std::size_t j = 0; j < step; j += 2 * lanes) {
    const auto margin0 = margin_at(start + j);
    const auto margin1 = margin_at(start + j + lanes);
    if constexpr (kHalved) {
      StoreInside(d, margin0, margin1, to);
    } else if (lanes >= 8) {
      hn::StoreMaskBits(d, InsideIfDecided(d, margin0, decided_above), to);
      hn::StoreMaskBits(d, InsideIfDecided(d, margin1, decided_above),
                        to + lanes / 8);
    } else {
      const auto inside0 = InsideIfDecided(d, margin0, decided_above);
      const auto inside1 = InsideIfDecided(d, margin1, decided_above);
      byte |= (MaskBits(d, inside0) | MaskBits(d, inside1) << lanes) << j;
    }
    const auto of_two = OfMargins(d, margin0, margin1);
    of_step = j == 0 ? of_two : OfBoth(d, of_step, of_two);
    if constexpr (kMayBeNaN) watch = Watch(watch, margin0, margin1);
  }
  if (!kHalved && lanes < 8) *to = static_cast<std::uint8_t>(byte);
  return of_step;
}

// The same for a block of items; in of_all is kept what was there as well, but
// not if kFirst.
template <bool kMayBeNaN, bool kFirst, class D, class MarginAt>
HWY_INLINE void WriteFilteredBlock(D d, std::size_t start,
                                   TFromD<D> decided_above, std::uint8_t* to,
                                   const MarginAt& margin_at, Vec<D>& of_all,
                                   Vec<D>& watch) {
  const std::size_t block = 8 * HWY_MAX(hn::Lanes(d), std::size_t{8});
  const std::size_t step = FilteredStep(d);
#pragma GCC unroll 8
  for (std::size_t i = 0; i < block; i += step) {
    const auto of_step = WriteFilteredStep<kMayBeNaN>(
        d, start + i, decided_above, to + i / 8, margin_at, watch);
    of_all = kFirst && i == 0 ? of_step : OfBoth(d, of_all, of_step);
  }
}

// Writes n answers. margin_at(i) gives the margins of the items from i on, all
// of which exist; tail_at(i, count) those of the last count < Lanes(d) items.
// Where they do not decide, contains(i) answers for one item exactly.
// kMayBeNaN: a margin may, where an item is not finite.
template <bool kMayBeNaN, class D, class MarginAt, class TailAt, class Contains>
HWY_INLINE void WriteFiltered(D d, std::size_t n, TFromD<D> decided_above,
                              std::uint8_t* bits, const MarginAt& margin_at,
                              const TailAt& tail_at, const Contains& contains) {
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t block = 8 * HWY_MAX(lanes, std::size_t{8});
  // So many blocks share one look at whether all items are decided, which takes
  // as long as one vector or two. Where they are not, each block is looked at
  // by itself: again, or at what was kept of it, which pays where undecided
  // items are not rare, but not on AVX-512.
  constexpr std::size_t kShare = 16;
  constexpr bool kKeep = sizeof(TFromD<D>) == 4 && !kHalved;
  HWY_ALIGN TFromD<D> kept[kKeep ? kShare * kMaxLanes<D> : 1];
  std::size_t left = n / block;
  std::size_t first = 0;
  while (left != 0) {
    // No call in this loop, so that its constants stay in registers.
    std::size_t shared = 0;
    bool decided = true;
    bool numbers = true;
    while (left != 0) {
      shared = HWY_MIN(kShare, left);
      auto of_all = OfNoMargin(d);
      auto watch = Zero(d);
      std::size_t start = first;
      std::uint8_t* to = bits + first / 8;
      for (std::size_t k = 0; k != shared; ++k) {
        if constexpr (kKeep) {
          auto of_block = of_all;
          WriteFilteredBlock<kMayBeNaN, true>(d, start, decided_above, to,
                                              margin_at, of_block, watch);
          hn::Store(of_block, d, kept + k * lanes);
          of_all = OfBoth(d, of_all, of_block);
        } else {
          WriteFilteredBlock<kMayBeNaN, false>(d, start, decided_above, to,
                                               margin_at, of_all, watch);
        }
        start += block;
        to += block / 8;
      }
      decided = AllDecided(d, of_all, decided_above);
      if constexpr (kMayBeNaN) numbers = NoneIsNaN(d, watch);
      if (HWY_UNLIKELY(!(decided && numbers))) break;
      first = start;
      left -= shared;
    }
    if (decided && numbers) continue;
    left -= shared;
    for (std::size_t k = 0; k != shared; ++k) {
      bool block_decided = false;
      if constexpr (kKeep) {
        const auto of_block = hn::Load(d, kept + k * lanes);
        block_decided = numbers && AllDecided(d, of_block, decided_above);
      } else {
        auto of_block = OfNoMargin(d);
        auto watch = Zero(d);
        WriteFilteredBlock<kMayBeNaN, true>(d, first, decided_above,
                                            bits + first / 8, margin_at,
                                            of_block, watch);
        block_decided = AllDecided(d, of_block, decided_above) &&
                        (!kMayBeNaN || NoneIsNaN(d, watch));
      }
      if (!block_decided) {
        Decide(d, first, first + block, decided_above, bits, margin_at, tail_at,
               contains);
      }
      first += block;
    }
  }
  if (HWY_LIKELY(first == n)) return;
  // What is left behind the last block: as many whole steps as there are, if
  // they decide, and the rest by itself.
  const std::size_t step = FilteredStep(d);
  auto of_all = OfNoMargin(d);
  auto watch = Zero(d);
  std::size_t start = first;
  for (std::size_t steps = (n - first) / step; steps != 0; --steps) {
    const auto of_step = WriteFilteredStep<kMayBeNaN>(
        d, start, decided_above, bits + start / 8, margin_at, watch);
    of_all = OfBoth(d, of_all, of_step);
    start += step;
  }
  if (AllDecided(d, of_all, decided_above) &&
      (!kMayBeNaN || NoneIsNaN(d, watch))) {
    first = start;
  }
  if (first < n) {
    Decide(d, first, n, decided_above, bits, margin_at, tail_at, contains);
  }
}

// The points of a batch as two arrays. Of(exchanged, use) calls use(vectors),
// whose At(d, i, margin) is margin(u, v, v) for those from i on: u are their x
// and v their y, or, exchanged, the other way round. PointsSideBySide is alike.
template <class T>
struct PointsInTwoArrays {
  struct Vectors {
    const T* u;
    const T* v;
    const T* v_again;
    HWY_INLINE Vectors(const T* first, const T* second)
        : u(first), v(second), v_again(second) {
#if HWY_ARCH_X86 && !defined(PITBENCH_COUNTING)
      // Turned margins take v as an operand in memory, twice, which a compiler
      // does not do with what it knows to be the same.
      if constexpr (kTurned) asm("" : "+r"(v_again));
#endif
    }
    template <class D, class Margin>
    HWY_INLINE Vec<D> At(D d, std::size_t i, const Margin& margin) const {
      const auto from_u = InRegister(hn::LoadU(d, u + i));
      if constexpr (kTurned) {
        return margin(from_u, hn::LoadU(d, v + i), hn::LoadU(d, v_again + i));
      } else {
        const auto from_v = InRegister(hn::LoadU(d, v + i));
        return margin(from_u, from_v, from_v);
      }
    }
    template <class D, class Margin>
    HWY_INLINE Vec<D> TailAt(D d, std::size_t i, std::size_t count,
                             const Margin& margin) const {
      const Tail<D> last_u(u + i, count);
      const Tail<D> last_v(v + i, count);
      const auto from_v = hn::Load(d, last_v.data());
      return margin(hn::Load(d, last_u.data()), from_v, from_v);
    }
  };

  HWY_INLINE explicit PointsInTwoArrays(const Batch<T>& batch)
      : px(batch.px), py(batch.py) {}
  HWY_INLINE T x(std::size_t i) const { return px[i]; }
  HWY_INLINE T y(std::size_t i) const { return py[i]; }
  template <class Use>
  HWY_INLINE void Of(bool exchanged, const Use& use) const {
    use(Vectors(exchanged ? py : px, exchanged ? px : py));
  }

  const T* px;
  const T* py;
};

template <class T>
HWY_INLINE Corners<T> CornersOf(const Batch<T>& one_triangle) {
  const Batch<T>& b = one_triangle;
  return {*b.ax, *b.ay, *b.bx, *b.by, *b.cx, *b.cy};
}

// Writes the answers of one triangle by margin(u, v, v), which is given x as u
// and y as v, or, exchanged, y and x.
template <template <class> class PointsOf, class T, class Margin>
static HWY_INLINE void WriteByMargin(const Batch<T>& batch, const Result<T>& to,
                                     Boundary boundary, bool exchanged,
                                     T decided_above, const Margin& margin) {
  const Lanes<T> d;
  const std::size_t n = batch.n;
  const PointsOf<T> points(batch);
  std::uint8_t* const bits = to.bits;
  // By address: few items need it, and a set-up without copies is shorter.
  const Batch<T>* const b = &batch;
  points.Of(exchanged, [=](auto vectors) HWY_ATTR {
    WriteFiltered<true>(
        d, n, decided_above, bits,
        [=](std::size_t i) HWY_ATTR { return vectors.At(d, i, margin); },
        [=](std::size_t i, std::size_t count)
            HWY_ATTR { return vectors.TailAt(d, i, count, margin); },
        [=](std::size_t i) {
          const PointsOf<T> p(*b);
          return ExactlyContains(boundary, CornersOf(*b), p.x(i), p.y(i));
        });
  });
}

template <template <class> class PointsOf, class T>
static HWY_INLINE void WriteBySlopes(const Batch<T>& batch, const Result<T>& to,
                                     Boundary boundary, bool exchanged,
                                     const SlopeFilter<T>& slopes) {
  using D = Lanes<T>;
  slopes.Choose([&](auto form) HWY_ATTR {
    const D d;
    WriteByMargin<PointsOf>(batch, to, boundary, exchanged,
                            slopes.decided_above,
                            [=](Vec<D> x, Vec<D> y0, Vec<D> y1)
                                HWY_ATTR { return form.Margin(d, x, y0, y1); });
  });
}

// FilteredOneTriangle of a triangle with an edge that is steep.
template <class T, template <class> class PointsOf>
static HWY_NOINLINE void FilteredSteepTriangle(const Batch<T>& batch,
                                               const Result<T>& to,
                                               Boundary boundary) {
  using D = Lanes<T>;
  const D d;
  const Corners<T> v = CornersOf(batch);
  // With x and y exchanged the lines are flat that were steep.
  const SlopeFilter<T> over_y({v.ay, v.ax, v.by, v.bx, v.cy, v.cx});
  if (over_y.holds) {
    WriteBySlopes<PointsOf>(batch, to, boundary, true, over_y);
    return;
  }
  const AreaFilter<T> area(v);
  if (area.holds) {
    WriteByMargin<PointsOf>(batch, to, boundary, false, area.decided_above,
                            [=](Vec<D> x, Vec<D> y0, Vec<D> y1)
                                HWY_ATTR { return area.Margin(d, x, y0, y1); });
  } else if (ExactOrientation(v) == 0) {
    std::memset(to.bits, 0, BitBytes(batch.n));
  } else {
    HWY_ALIGN T all[6][kMaxLanes<D>];  // every lane has the same triangle
    hn::Store(Set(d, v.ax), d, all[0]);
    hn::Store(Set(d, v.ay), d, all[1]);
    hn::Store(Set(d, v.bx), d, all[2]);
    hn::Store(Set(d, v.by), d, all[3]);
    hn::Store(Set(d, v.cx), d, all[4]);
    hn::Store(Set(d, v.cy), d, all[5]);
    const Triangles<D> same{d, all[0], all[1], all[2], all[3], all[4], all[5]};
    WriteByMargin<PointsOf>(batch, to, boundary, false, T{0},
                            [=](Vec<D> x, Vec<D> y, Vec<D>) HWY_ATTR {
                              return DeterminantMargin(d, same, x, y);
                            });
  }
}

// Loops one_triangle and one_triangle_aos. The lines over x are tried first: to
// guess which lines are flatter would take longer than trying again the one
// triangle in a hundred (f32, random in the unit square) that needs it.
template <class T, template <class> class PointsOf>
static HWY_NOINLINE void FilteredOneTriangle(const Batch<T>& batch,
                                             const Result<T>& to,
                                             Boundary boundary) {
  const SlopeFilter<T> slopes(CornersOf(batch));
  if (HWY_LIKELY(slopes.holds)) {
    WriteBySlopes<PointsOf>(batch, to, boundary, false, slopes);
  } else {
    FilteredSteepTriangle<T, PointsOf>(batch, to, boundary);
  }
}

template <class T, bool kOnePoint>
static HWY_NOINLINE void FilteredManyTriangles(const Batch<T>& batch,
                                               const Result<T>& to,
                                               Boundary boundary) {
  using D = Lanes<T>;
  const D d;
  const Batch<T> b = batch;  // local, so that no store can alias it
  const T x0 = kOnePoint && b.n != 0 ? *b.px : T{0};
  const T y0 = kOnePoint && b.n != 0 ? *b.py : T{0};
  WriteFiltered<false>(
      d, b.n, T{0}, to.bits,
      [=](std::size_t i) HWY_ATTR {
        const Triangles<D> t{d,        b.ax + i, b.ay + i, b.bx + i,
                             b.by + i, b.cx + i, b.cy + i};
        return DeterminantMargin(
            d, t, kOnePoint ? Set(d, x0) : hn::LoadU(d, b.px + i),
            kOnePoint ? Set(d, y0) : hn::LoadU(d, b.py + i));
      },
      [=](std::size_t i, std::size_t count) HWY_ATTR {
        const Tail<D> ax(b.ax + i, count), ay(b.ay + i, count);
        const Tail<D> bx(b.bx + i, count), by(b.by + i, count);
        const Tail<D> cx(b.cx + i, count), cy(b.cy + i, count);
        const Tail<D> px(kOnePoint ? b.px : b.px + i, kOnePoint ? 1 : count);
        const Tail<D> py(kOnePoint ? b.py : b.py + i, kOnePoint ? 1 : count);
        const Triangles<D> t{d,         ax.data(), ay.data(), bx.data(),
                             by.data(), cx.data(), cy.data()};
        return DeterminantMargin(
            d, t, kOnePoint ? Set(d, x0) : hn::Load(d, px.data()),
            kOnePoint ? Set(d, y0) : hn::Load(d, py.data()));
      },
      [=](std::size_t i) {
        return ExactlyContains<T>(
            boundary, {b.ax[i], b.ay[i], b.bx[i], b.by[i], b.cx[i], b.cy[i]},
            kOnePoint ? x0 : b.px[i], kOnePoint ? y0 : b.py[i]);
      });
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#endif  // include guard that Highway toggles
