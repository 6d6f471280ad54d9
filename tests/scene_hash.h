// The bits of a scene as one number.
#ifndef PITBENCH_TESTS_SCENE_HASH_H_
#define PITBENCH_TESTS_SCENE_HASH_H_

#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <type_traits>

#include "harness/scenes/scene.h"

namespace pitbench {

// FNV-1a of all arrays, byte by byte, least significant byte first.
template <class T>
std::uint64_t HashOf(std::initializer_list<const Array<T>*> arrays) {
  using Word = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const Array<T>* array : arrays) {
    for (const T value : *array) {
      const auto word = std::bit_cast<Word>(value);
      for (std::size_t byte = 0; byte < sizeof(T); ++byte) {
        hash = (hash ^ (word >> (8 * byte) & 0xff)) * 0x100000001b3u;
      }
    }
  }
  return hash;
}

}  // namespace pitbench

#endif  // PITBENCH_TESTS_SCENE_HASH_H_
