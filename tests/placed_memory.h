// Arrays of a kernel's call in guarded memory, and whether what lies around its
// outputs is still what it was.
#ifndef PITBENCH_TESTS_PLACED_MEMORY_H_
#define PITBENCH_TESTS_PLACED_MEMORY_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "tests/guarded_memory.h"

namespace pitbench {

constexpr std::uint8_t kCanary = 0xA5;

// An output and what lies within 256 bytes of it, as far as that is ours.
struct Around {
  static constexpr std::ptrdiff_t kMargin = 256;
  std::uint8_t* start;
  std::uint8_t* output;
  std::uint8_t* output_end;
  std::uint8_t* end;

  Around(const GuardedMemory& memory, void* at, std::size_t bytes)
      : output(static_cast<std::uint8_t*>(at)), output_end(output + bytes) {
    auto* const first = memory.AtStart<std::uint8_t>();
    auto* const last = memory.AtEnd<std::uint8_t>(0);
    start = output - std::min(kMargin, output - first);
    end = output_end + std::min(kMargin, last - output_end);
  }
  void Fill() const { std::fill(start, end, kCanary); }
  bool Intact() const {
    const auto kept = [](std::uint8_t byte) { return byte == kCanary; };
    return std::all_of(start, output, kept) &&
           std::all_of(output_end, end, kept);
  }
};

// Where the arrays of a call lie in the memory that each of them has.
struct Place {
  bool at_end;         // each ends where a page that traps begins, or
  std::size_t offset;  // begins so many elements behind one
};
constexpr Place kAtEnd{true, 0};
constexpr Place kAtStart{false, 0};

// Numbers of items: from none to three vectors and one of the widest (512 bit,
// f32), and then what takes several words, several blocks of the plain loops,
// and `most`.
inline std::vector<std::size_t> SizesUpTo(std::size_t most) {
  std::vector<std::size_t> sizes = {63, 64, 65, 127, 129, 511, 513, most};
  for (std::size_t n = 0; n <= 3 * 16 + 1; ++n) sizes.push_back(n);
  return sizes;
}

template <class T>
T* At(const GuardedMemory& memory, std::size_t n, Place place) {
  return place.at_end ? memory.AtEnd<T>(n) : memory.AtStart<T>() + place.offset;
}

// Bit for bit, or both NaN.
template <class T>
bool Same(T x, T y) {
  return std::memcmp(&x, &y, sizeof(T)) == 0 || (x != x && y != y);
}

}  // namespace pitbench

#endif  // PITBENCH_TESTS_PLACED_MEMORY_H_
