// Calls each kernel of loop one_triangle for arm64, for an emulator that logs
// which instructions run (harness/measure/emulated_loops.h).
//
// usage: arm64_calls neon|sve|sve2
//
// Writes a line `kernel METHOD SCALAR ISA VECTOR_BITS N` for each kernel, and a
// line `call` before and `done` after each of four calls: of a function that
// does nothing, of the kernel on N points twice, and of the kernel on 2N. All
// by the same path, so that what the log has besides a call is always the same.
#include <sys/prctl.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/kernels.h"

namespace pitbench {

// What CMake compiles for each ISA.
#define PITBENCH_METHOD(key) std::span<const Kernel> key();
namespace neon {
#include "counted/methods.inc"
}
namespace sve {
#include "counted/methods.inc"
}
namespace sve2 {
#include "counted/methods.inc"
}
#undef PITBENCH_METHOD

namespace {

// Whole steps of every loop: 8 vectors of 8 numbers or of fewer.
constexpr std::size_t kPoints = 64;

std::vector<Kernel> KernelsFor(std::string_view isa) {
  std::vector<Kernel> all;
  const auto add = [&all](std::span<const Kernel> rows) {
    all.insert(all.end(), rows.begin(), rows.end());
  };
  if (isa == "neon") {
#define PITBENCH_METHOD(key) add(neon::key());
#include "counted/methods.inc"
#undef PITBENCH_METHOD
  } else if (isa == "sve") {
#define PITBENCH_METHOD(key) add(sve::key());
#include "counted/methods.inc"
#undef PITBENCH_METHOD
  } else if (isa == "sve2") {
#define PITBENCH_METHOD(key) add(sve2::key());
#include "counted/methods.inc"
#undef PITBENCH_METHOD
  }
  return all;
}

int VectorBits(std::string_view isa) {
  constexpr int kNeonBits = 128;
  return isa == "neon" ? kNeonBits
                       : 8 * (prctl(PR_SVE_GET_VL) & PR_SVE_VL_LEN_MASK);
}

void Say(std::string_view line) {
  if (write(STDOUT_FILENO, line.data(), line.size()) < 0) std::abort();
}

template <class T>
void DoNothing(const Batch<T>&, const Result<T>&) {}

// The same for all kernels: making them takes more instructions than a kernel.
template <class T>
struct Input {
  // About half of the points are inside.
  std::array<T, 3> vertex_x = {T{0}, T{1}, T{0.25}};
  std::array<T, 3> vertex_y = {T{0}, T{0.125}, T{1}};
  std::array<T, 2 * kPoints> x;
  std::array<T, 2 * kPoints> y;

  Input() {
    std::minstd_rand random;
    std::uniform_real_distribution<T> within(0, 1);
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = within(random);
      y[i] = within(random);
    }
  }
};

// Not inlined: the log would see each call at a place of its own.
template <class T>
[[gnu::noinline]] void CallOnce(KernelFunction<T> function, const Input<T>& in,
                                std::size_t n) {
  const T* const ax = in.vertex_x.data();
  const T* const ay = in.vertex_y.data();
  const Batch<T> batch = {ax,     ay,          ax + 1,      ay + 1, ax + 2,
                          ay + 2, in.x.data(), in.y.data(), n};
  std::array<std::uint8_t, BitBytes(2 * kPoints)> bits{};
  const Result<T> result{.bits = bits.data()};
  Say("call\n");
  function(batch, result);
  Say("done\n");
}

template <class T>
void CallAll(KernelFunction<T> kernel) {
  static const Input<T> input;
  CallOnce<T>(DoNothing<T>, input, kPoints);
  CallOnce<T>(kernel, input, kPoints);
  CallOnce<T>(kernel, input, kPoints);
  CallOnce<T>(kernel, input, 2 * kPoints);
}

void Announce(const Kernel& kernel, std::string_view scalar,
              std::string_view isa) {
  std::string line = "kernel ";
  line.append(kernel.method.key).append(" ").append(scalar).append(" ");
  line.append(isa).append(" ").append(std::to_string(VectorBits(isa)));
  line.append(" ").append(std::to_string(kPoints)).append("\n");
  Say(line);
}

int Main(std::string_view isa) {
  const std::vector<Kernel> kernels = KernelsFor(isa);
  if (kernels.empty()) {
    Say("usage: arm64_calls neon|sve|sve2\n");
    return 2;
  }
  for (const Kernel& kernel : kernels) {
    if (kernel.loop != Loop::kOneTriangle || kernel.output != Output::kInside) {
      continue;
    }
    if (kernel.scalar == Scalar::kF32) {
      Announce(kernel, "f32", isa);
      CallAll<float>(kernel.f32);
    } else if (kernel.scalar == Scalar::kF64) {
      Announce(kernel, "f64", isa);
      CallAll<double>(kernel.f64);
    }
  }
  return 0;
}

}  // namespace
}  // namespace pitbench

int main(int argc, char** argv) {
  return pitbench::Main(argc == 2 ? argv[1] : "");
}
