// From a library's call to the rows of a table.
//
// A call is a class template over the scalar T:
//
//   template <class T>
//   struct Call {
//     explicit Call(const PeerTriangle<T>& triangle);  // set-up
//     bool Inside(T x, T y) const;
//   };
#ifndef PITBENCH_PEERS_ROWS_H_
#define PITBENCH_PEERS_ROWS_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <type_traits>
#include <vector>

#include "kernels/kernels.h"

namespace pitbench {

template <class T>
struct PeerTriangle {
  T ax, ay, bx, by, cx, cy;

  PeerTriangle(const Batch<T>& in, std::size_t i)
      : ax(in.ax[i]),
        ay(in.ay[i]),
        bx(in.bx[i]),
        by(in.by[i]),
        cx(in.cx[i]),
        cy(in.cy[i]) {}

  // Twice the area, positive where the vertices go counter-clockwise. Rounded:
  // good enough to choose the order in which a library wants them.
  T DoubleArea() const { return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax); }
};

// What a library throws makes the answer "outside".
template <class Answer>
bool FalseIfThrown(Answer answer) {
  try {
    return answer();
  } catch (const std::exception&) {
    return false;
  }
}

template <class Answer>
void WriteBits(std::size_t n, std::uint8_t* bits, Answer answer) {
  for (std::size_t first = 0; first < n; first += 8) {
    const std::size_t count = std::min<std::size_t>(8, n - first);
    unsigned byte = 0;
    for (std::size_t k = 0; k < count; ++k) {
      byte |= static_cast<unsigned>(answer(first + k)) << k;
    }
    bits[first / 8] = static_cast<std::uint8_t>(byte);
  }
}

template <class T, template <class> class Call>
void PeerOneTriangle(const Batch<T>& in, const Result<T>& out) {
  std::optional<Call<T>> call;
  FalseIfThrown([&] {
    call.emplace(PeerTriangle<T>(in, 0));
    return true;
  });
  WriteBits(in.n, out.bits, [&](std::size_t i) {
    return call &&
           FalseIfThrown([&] { return call->Inside(in.px[i], in.py[i]); });
  });
}

template <class T, template <class> class Call>
void PeerOnePoint(const Batch<T>& in, const Result<T>& out) {
  const T x = in.px[0];
  const T y = in.py[0];
  WriteBits(in.n, out.bits, [&](std::size_t i) {
    return FalseIfThrown(
        [&] { return Call<T>(PeerTriangle<T>(in, i)).Inside(x, y); });
  });
}

template <class T, template <class> class Call>
void PeerPairs(const Batch<T>& in, const Result<T>& out) {
  WriteBits(in.n, out.bits, [&](std::size_t i) {
    return FalseIfThrown([&] {
      return Call<T>(PeerTriangle<T>(in, i)).Inside(in.px[i], in.py[i]);
    });
  });
}

template <class T>
void AddPeerRow(const Method& method, Loop loop, KernelFunction<T> function,
                std::vector<Kernel>& rows) {
  Kernel row{.method = method,
             .scalar = ScalarOf<T>(),
             .isa = Isa::kLibrary,
             .loop = loop,
             .output = Output::kInside};
  if constexpr (std::is_same_v<T, float>) {
    row.f32 = function;
  } else {
    row.f64 = function;
  }
  rows.push_back(row);
}

// The rows of one call and scalar: one a loop.
template <class T, template <class> class Call>
void AddPeerRows(const Method& method, std::vector<Kernel>& rows) {
  AddPeerRow<T>(method, Loop::kOneTriangle, PeerOneTriangle<T, Call>, rows);
  AddPeerRow<T>(method, Loop::kOnePoint, PeerOnePoint<T, Call>, rows);
  AddPeerRow<T>(method, Loop::kPairs, PeerPairs<T, Call>, rows);
}

template <template <class> class Call>
void AddPeerRowsOfBoth(const Method& method, std::vector<Kernel>& rows) {
  AddPeerRows<float, Call>(method, rows);
  AddPeerRows<double, Call>(method, rows);
}

}  // namespace pitbench

#endif  // PITBENCH_PEERS_ROWS_H_
