// Vectors and masks that count, and Highway's tags for them: 64 bytes, as on
// AVX-512.
#ifndef PITBENCH_KERNELS_COUNTING_VECTORS_H_
#define PITBENCH_KERNELS_COUNTING_VECTORS_H_

#include <algorithm>
#include <array>

#include "kernels/counting/number.h"

namespace hwy::N_COUNTING {

using pitbench::counting::Code;
using pitbench::counting::CurrentTape;
using pitbench::counting::Id;
using pitbench::counting::Kind;
using pitbench::counting::Note;
using pitbench::counting::Number;

template <class Type, std::size_t kCount>
struct Simd {
  using T = Type;
  static constexpr std::size_t kLanes = kCount;
};

template <class D>
using TFromD = typename D::T;
template <class T, std::size_t kMost>
using CappedTag = Simd<T, std::min(kMost, 64 / sizeof(T))>;
template <class T>
using ScalableTag = CappedTag<T, 64>;
template <class T, class D>
using Rebind = Simd<T, D::kLanes>;
template <class D>
using Half = Simd<TFromD<D>, std::max<std::size_t>(D::kLanes / 2, 1)>;
template <class D>
using RebindToSigned = Rebind<MakeSigned<TFromD<D>>, D>;
template <class D>
using RebindToUnsigned = Rebind<MakeUnsigned<TFromD<D>>, D>;
template <class T, class D>
using Repartition = Simd<T, D::kLanes * sizeof(TFromD<D>) / sizeof(T)>;

template <class D>
constexpr std::size_t Lanes(D) {
  return D::kLanes;
}
template <class D>
constexpr std::size_t MaxLanes(D) {
  return D::kLanes;
}

// The values of the lanes, and the place on the tape of all of them together.
template <class Type, std::size_t kCount>
struct Vector {
  using T = Type;
  static constexpr std::size_t kLanes = kCount;
  std::array<T, kCount> lane;
  Id id;
};
template <class Type, std::size_t kCount>
struct MaskOf {
  using T = Type;
  static constexpr std::size_t kLanes = kCount;
  std::array<bool, kCount> lane;
  Id id;
};
template <class D>
using Vec = Vector<TFromD<D>, D::kLanes>;
template <class D>
using Mask = MaskOf<TFromD<D>, D::kLanes>;
template <class V>
using DFromV = Simd<typename V::T, V::kLanes>;

// f(a's lane, b's lane, …) lane by lane.
template <class Out, class F, class... In>
Out LaneByLane(Id id, const F& f, const In&... in) {
  Out out;
  out.id = id;
  for (std::size_t i = 0; i < Out::kLanes; ++i) {
    out.lane[i] =
        static_cast<typename decltype(out.lane)::value_type>(f(in.lane[i]...));
  }
  return out;
}

// The operations below, where they are the same for every type: noted, and
// then done lane by lane. An operand order that makes no difference is noted
// in one order only.
template <class Out, class In, class F>
Out Unary(Kind kind, Code code, const In& a, const F& f,
          std::uint64_t immediate = 0) {
  return LaneByLane<Out>(
      Note<typename In::T>(kind, code, In::kLanes, a.id, 0, 0, immediate), f,
      a);
}
template <class Out, class In, class F>
Out Binary(Kind kind, Code code, const In& a, const In& b, const F& f) {
  return LaneByLane<Out>(
      Note<typename In::T>(kind, code, In::kLanes, a.id, b.id), f, a, b);
}
template <class Out, class In, class F>
Out Commutative(Kind kind, Code code, const In& a, const In& b, const F& f) {
  return LaneByLane<Out>(
      Note<typename In::T>(kind, code, In::kLanes, std::min(a.id, b.id),
                           std::max(a.id, b.id)),
      f, a, b);
}

// --- constants and memory ---------------------------------------------------

template <class D>
Vec<D> Set(D, TFromD<D> value) {
  Vec<D> v;
  v.id = Note<TFromD<D>>(Kind::kFree, Code::kConstant, D::kLanes, 0, 0, 0,
                         pitbench::counting::Bits(value));
  v.lane.fill(value);
  return v;
}
// A kept number in all lanes: once for the whole loop.
template <class D>
Vec<D> Set(D, Number<TFromD<D>> number) {
  Vec<D> v;
  v.id = D::kLanes == 1
             ? number.id
             : Note<TFromD<D>>(Kind::kFree, Code::kSame, D::kLanes, number.id);
  v.lane.fill(number.value);
  return v;
}
template <class D>
Vec<D> Zero(D d) {
  return Set(d, TFromD<D>{0});
}
// The sign bit of each lane.
template <class D>
Vec<D> SignBit(D d) {
  return Set(d, TFromD<D>{-0.0});
}
template <class D>
Vec<D> Iota(D, TFromD<D> first) {
  Vec<D> v;
  v.id = Note<TFromD<D>>(Kind::kFree, Code::kIota, D::kLanes, 0, 0, 0,
                         pitbench::counting::Bits(first));
  for (auto& lane : v.lane) lane = first++;
  return v;
}
template <class T, std::size_t kN>
Number<T> GetLane(const Vector<T, kN>& v) {
  return {v.lane[0],
          kN == 1 ? v.id : Note<T>(Kind::kFree, Code::kSame, 1, v.id)};
}

// The same lanes from the same address are the same value: read once.
template <class D>
Vec<D> LoadU(D, const TFromD<D>* from) {
  using T = TFromD<D>;
  Vec<D> v;
  std::copy_n(from, D::kLanes, v.lane.begin());
  std::uint64_t content = reinterpret_cast<std::uintptr_t>(from);
  for (const T lane : v.lane) {
    content = (content ^ pitbench::counting::Bits(lane)) * 0x9e3779b97f4a7c15u;
    content ^= content >> 29;
  }
  v.id = Note<T>(Kind::kLoad, Code::kLoad, D::kLanes, 0, 0, 0, content);
  return v;
}
template <class D>
Vec<D> Load(D d, const TFromD<D>* from) {
  return LoadU(d, from);
}

// Notes a store of `id`, which never is the same as another.
template <class T>
void Stored(std::size_t lanes, Id id) {
  static thread_local std::uint64_t stores = 0;
  CurrentTape().Need(
      Note<T>(Kind::kStore, Code::kStore, lanes, id, 0, 0, ++stores));
}
template <class T, std::size_t kN, class D>
void StoreU(const Vector<T, kN>& v, D, T* to) {
  std::copy_n(v.lane.begin(), kN, to);
  Stored<T>(kN, v.id);
}
template <class T, std::size_t kN, class D>
void Store(const Vector<T, kN>& v, D d, T* to) {
  StoreU(v, d, to);
}
template <class D>
std::size_t StoreMaskBits(D, const Mask<D>& mask, std::uint8_t* to) {
  for (std::size_t i = 0; i < D::kLanes; ++i) {
    if (i % 8 == 0) to[i / 8] = 0;
    to[i / 8] = static_cast<std::uint8_t>(to[i / 8] | mask.lane[i] << i % 8);
  }
  Stored<TFromD<D>>(D::kLanes, mask.id);
  return (D::kLanes + 7) / 8;
}
template <class D>
Mask<D> FirstN(D, std::size_t n) {
  Mask<D> mask;
  mask.id =
      Note<TFromD<D>>(Kind::kFree, Code::kFirstLanes, D::kLanes, 0, 0, 0, n);
  for (std::size_t i = 0; i < D::kLanes; ++i) mask.lane[i] = i < n;
  return mask;
}
// A mask from numbers that are not noted.
template <class D>
Mask<D> LoadMaskBits(D, const std::uint8_t* bits) {
  Mask<D> mask;
  std::uint64_t content = 0;
  for (std::size_t i = 0; i < D::kLanes; ++i) {
    mask.lane[i] = (bits[i / 8] >> i % 8 & 1) != 0;
    content |= std::uint64_t{mask.lane[i]} << i;
  }
  mask.id = Note<TFromD<D>>(Kind::kFree, Code::kConstant, D::kLanes, 0, 0, 0,
                            content);
  return mask;
}

// A branch follows.
template <class D>
bool AllTrue(D, const Mask<D>& mask) {
  CurrentTape().Need(mask.id);
  return std::all_of(mask.lane.begin(), mask.lane.end(),
                     [](bool lane) { return lane; });
}
template <class D>
bool AllFalse(D, const Mask<D>& mask) {
  CurrentTape().Need(mask.id);
  return std::none_of(mask.lane.begin(), mask.lane.end(),
                      [](bool lane) { return lane; });
}

}  // namespace hwy::N_COUNTING

#endif  // PITBENCH_KERNELS_COUNTING_VECTORS_H_
