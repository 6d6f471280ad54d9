// What the tables of 2D kernels and of ray kernels are put together with.
#if defined(PITBENCH_KERNELS_TABLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PITBENCH_KERNELS_TABLE_INL_H_
#undef PITBENCH_KERNELS_TABLE_INL_H_
#else
#define PITBENCH_KERNELS_TABLE_INL_H_
#endif

#include <array>
#include <span>

#include "kernels/isa-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pitbench {
namespace PITBENCH_ISA {

template <class K, std::size_t kA, std::size_t kB>
constexpr std::array<K, kA + kB> operator+(const std::array<K, kA>& a,
                                           const std::array<K, kB>& b) {
  std::array<K, kA + kB> joined{};
  for (std::size_t i = 0; i < kA; ++i) joined[i] = a[i];
  for (std::size_t i = 0; i < kB; ++i) joined[kA + i] = b[i];
  return joined;
}

}  // namespace PITBENCH_ISA
}  // namespace pitbench
HWY_AFTER_NAMESPACE();

#undef PITBENCH_EXPORT_ROWS
#define PITBENCH_EXPORT_ROWS(K, function, ...) \
  HWY_BEFORE_NAMESPACE();                      \
  namespace pitbench {                         \
  namespace PITBENCH_ISA {                     \
  std::span<const K> function();               \
  std::span<const K> function() {              \
    static constexpr auto kRows = __VA_ARGS__; \
    return {kRows.data(), kRows.size()};       \
  }                                            \
  }                                            \
  }                                            \
  HWY_AFTER_NAMESPACE()

#endif  // include guard that Highway toggles
