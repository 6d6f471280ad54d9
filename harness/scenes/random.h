// Random numbers that are the same on every platform.
//
// xoshiro256++ 1.0 (Blackman and Vigna 2019), its state filled by SplitMix64
// (Steele, Lea and Flood 2014). The standard library's distributions are not
// used: their results differ from one library to the next.
#ifndef PITBENCH_HARNESS_SCENES_RANDOM_H_
#define PITBENCH_HARNESS_SCENES_RANDOM_H_

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

namespace pitbench {

class Random {
 public:
  explicit Random(std::uint64_t seed) {
    for (std::uint64_t& word : state_) {
      seed += 0x9e3779b97f4a7c15u;
      std::uint64_t z = seed;
      z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
      z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
      word = z ^ (z >> 31);
    }
  }

  // 64 random bits.
  std::uint64_t Bits() {
    const std::uint64_t result =
        std::rotl(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t t = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = std::rotl(state_[3], 45);
    return result;
  }

  // Uniform in [0, 1), a multiple of 2^-53.
  double Unit() { return static_cast<double>(Bits() >> 11) * 0x1p-53; }

  // Uniform in [low, high).
  double In(double low, double high) { return low + (high - low) * Unit(); }

  // Uniform in 0 … n − 1 (Lemire's multiplication; the bias is below n·2^-64).
  std::uint64_t Below(std::uint64_t n) {
    __extension__ using Wide = unsigned __int128;
    return static_cast<std::uint64_t>((static_cast<Wide>(Bits()) * n) >> 64);
  }

 private:
  std::array<std::uint64_t, 4> state_;
};

// A seed of its own for every name: FNV-1a of the name, mixed with `seed`.
inline std::uint64_t SeedFor(std::string_view name, std::uint64_t seed) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : name) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }
  return hash ^ (seed * 0x9e3779b97f4a7c15u);
}

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_SCENES_RANDOM_H_
