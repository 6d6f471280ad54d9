// Asks the widest cross_product kernel that runs here about three points.
// Kernels are listed from narrow to wide.
#include <cstdio>

#include "kernels/kernels.h"

int main() {
  const pitbench::Kernel* widest = nullptr;
  for (const pitbench::Kernel& kernel : pitbench::AllKernels()) {
    if (kernel.method.key == "cross_product" &&
        kernel.scalar == pitbench::Scalar::kF32 &&
        kernel.loop == pitbench::Loop::kOneTriangle &&
        pitbench::RunsHere(kernel.isa)) {
      widest = &kernel;
    }
  }
  if (widest == nullptr) return 1;
  const float ax = 0, ay = 0, bx = 4, by = 0, cx = 0, cy = 4;
  const float px[] = {1, 3, 2};
  const float py[] = {1, 3, 2};
  std::uint8_t bits = 0xff;
  widest->f32({&ax, &ay, &bx, &by, &cx, &cy, px, py, 3}, {.bits = &bits});
  std::printf("%.*s: %d\n", static_cast<int>(Name(widest->isa).size()),
              Name(widest->isa).data(), bits);
  return bits == 0b101 ? 0 : 1;  // (1, 1) inside, (3, 3) outside, (2, 2) on BC
}
