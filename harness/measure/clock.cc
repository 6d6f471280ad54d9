#include "harness/measure/clock.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <string>

namespace pitbench {
namespace {

// 64 additions, each waiting for the one before. Of two registers: additions
// of a constant are folded away by the renamers of recent Intel cores, several
// a cycle.
inline std::uint64_t Chain(std::uint64_t x) {
#if defined(__x86_64__)
  asm volatile(".rept 64\n\tadd %0, %0\n\t.endr" : "+r"(x)::"cc");
#elif defined(__aarch64__)
  asm volatile(".rept 64\n\tadd %0, %0, %0\n\t.endr" : "+r"(x)::"cc");
#else
#error "no dependent chain for this architecture"
#endif
  return x;
}

// 512 operations: 16 times 16 additions of integers, 8 multiplications and 8
// additions of floating-point numbers. Each waits for the one 32 operations
// before it (integers: 8 before it of the 16), which is longer than its latency
// however many a CPU does at once. The registers hold what they may: zeros.
inline void FillPorts() {
#if defined(__x86_64__)
  asm volatile(
      "xor %%eax, %%eax; xor %%ecx, %%ecx; xor %%edx, %%edx\n\t"
      "xor %%esi, %%esi; xor %%edi, %%edi; xor %%r8d, %%r8d\n\t"
      "xor %%r9d, %%r9d; xor %%r10d, %%r10d\n\t"
      ".irp r, 0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15\n\t"
      "xorps %%xmm\\r, %%xmm\\r\n\t"
      ".endr\n\t"
      ".rept 16\n\t"
      "add %%rax, %%rax; add %%rcx, %%rcx; mulps %%xmm0, %%xmm0\n\t"
      "addps %%xmm8, %%xmm8; add %%rdx, %%rdx; add %%rsi, %%rsi\n\t"
      "mulps %%xmm1, %%xmm1; addps %%xmm9, %%xmm9; add %%rdi, %%rdi\n\t"
      "add %%r8, %%r8; mulps %%xmm2, %%xmm2; addps %%xmm10, %%xmm10\n\t"
      "add %%r9, %%r9; add %%r10, %%r10; mulps %%xmm3, %%xmm3\n\t"
      "addps %%xmm11, %%xmm11; add %%rax, %%rax; add %%rcx, %%rcx\n\t"
      "mulps %%xmm4, %%xmm4; addps %%xmm12, %%xmm12; add %%rdx, %%rdx\n\t"
      "add %%rsi, %%rsi; mulps %%xmm5, %%xmm5; addps %%xmm13, %%xmm13\n\t"
      "add %%rdi, %%rdi; add %%r8, %%r8; mulps %%xmm6, %%xmm6\n\t"
      "addps %%xmm14, %%xmm14; add %%r9, %%r9; add %%r10, %%r10\n\t"
      "mulps %%xmm7, %%xmm7; addps %%xmm15, %%xmm15\n\t"
      ".endr" ::
          : "rax", "rcx", "rdx", "rsi", "rdi", "r8", "r9", "r10", "cc", "xmm0",
            "xmm1", "xmm2", "xmm3", "xmm4", "xmm5", "xmm6", "xmm7", "xmm8",
            "xmm9", "xmm10", "xmm11", "xmm12", "xmm13", "xmm14", "xmm15");
#elif defined(__aarch64__)
  asm volatile(
      ".irp r, 0,1,2,3,4,5,6,7\n\t"
      "mov x\\r, xzr\n\t"
      "movi v\\r\\().2d, #0\n\t"
      ".endr\n\t"
      ".irp r, 16,17,18,19,20,21,22,23\n\t"
      "movi v\\r\\().2d, #0\n\t"
      ".endr\n\t"
      ".rept 16\n\t"
      ".irp r, 0,1,2,3,4,5,6,7\n\t"
      "add x\\r, x\\r, x\\r\n\t"
      "fmul v\\r\\().4s, v\\r\\().4s, v\\r\\().4s\n\t"
      ".endr\n\t"
      ".irp r, 0,1,2,3,4,5,6,7\n\t"
      "add x\\r, x\\r, x\\r\n\t"
      ".endr\n\t"
      ".irp r, 16,17,18,19,20,21,22,23\n\t"
      "fadd v\\r\\().4s, v\\r\\().4s, v\\r\\().4s\n\t"
      ".endr\n\t"
      ".endr" ::
          : "x0", "x1", "x2", "x3", "x4", "x5", "x6", "x7", "v0", "v1", "v2",
            "v3", "v4", "v5", "v6", "v7", "v16", "v17", "v18", "v19", "v20",
            "v21", "v22", "v23");
#endif
}

// How often a nanosecond `step` does something that it does `count` times.
template <class Step>
double PerNanosecond(int rounds, double count, const Step& step) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < rounds; ++i) step();
  const std::chrono::duration<double, std::nano> time =
      std::chrono::steady_clock::now() - start;
  return count * rounds / time.count();
}

// The chain of a step takes 64 cycles, filled ports about 105.
Pace PaceOf(int rounds) {
  std::uint64_t x = 0;
  const double gops = PerNanosecond(rounds, 512, [] { FillPorts(); });
  const double ghz = PerNanosecond(3 * rounds, 64, [&] { x = Chain(x); });
  return {ghz, gops};
}

}  // namespace

Pace SamplePace() { return PaceOf(700); }
Pace GlancePace() { return PaceOf(50); }

Pace Best(const Pace& a, const Pace& b) {
  return {std::max(a.clock_ghz, b.clock_ghz),
          std::max(a.throughput_gops, b.throughput_gops)};
}

Pace MeasurePace() {
  Pace best;
  for (int sample = 0; sample < 700; ++sample) best = Best(best, SamplePace());
  return best;
}

double StealSeconds() {
  std::ifstream stat("/proc/stat");
  std::string cpu;
  double user = 0, nice = 0, system = 0, idle = 0, wait = 0, irq = 0, soft = 0;
  double steal = 0;
  stat >> cpu >> user >> nice >> system >> idle >> wait >> irq >> soft >> steal;
  return stat ? steal / static_cast<double>(sysconf(_SC_CLK_TCK)) : 0;
}

}  // namespace pitbench
