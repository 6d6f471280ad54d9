#include "harness/measure/verify.h"

#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "harness/command/commands.h"
#include "harness/command/find_kernel.h"
#include "harness/input/csv.h"
#include "harness/scenes/generate.h"

namespace pitbench {
namespace {

struct VerifyArguments {
  std::string method;
  std::string scalar = "f64";
  std::string isa;
  double points = 1e7;
  std::uint64_t seed = kDefaultSeed;
};

template <class T>
Verification Run(const VerifyArguments& a) {
  FindPairsKernel(a.method, ScalarOf<T>(), a.isa);  // throws if there is none
  std::vector<const Kernel*> kernels;
  for (const Kernel& kernel : AllKernels()) {
    if (kernel.method.key == a.method && kernel.scalar == ScalarOf<T>() &&
        kernel.output == Output::kInside && RunsHere(kernel.isa) &&
        (a.isa.empty() || Name(kernel.isa) == a.isa)) {
      kernels.push_back(&kernel);
    }
  }
  std::size_t shown = 0;
  return Verify<T>(kernels, static_cast<std::size_t>(a.points), a.seed,
                   [&](const Verification& v) {
                     const auto percent = static_cast<std::size_t>(
                         100 * static_cast<double>(v.points) / a.points);
                     if (percent <= shown) return;
                     shown = percent;
                     std::cerr << percent << " %, " << v.wrong << " wrong\n";
                   });
}

void RunVerify(const VerifyArguments& a) {
  if (!(a.points >= 1 && a.points <= 1e15)) {
    throw InputError("--points: give a number from 1 to 1e15");
  }
  const Verification v =
      FloatScalar(a.scalar) == Scalar::kF32 ? Run<float>(a) : Run<double>(a);
  std::cout << v.points << " points (" << v.boundary << " on a boundary), "
            << v.answers << " answers, " << v.wrong << " wrong\n"
            << std::flush;
  if (v.wrong != 0) throw std::runtime_error(v.first_wrong);
}

}  // namespace

void AddVerify(CLI::App& app) {
  CLI::App* verify = app.add_subcommand(
      "verify",
      "Holds every answer of a method to hard scenes against truth, those\n"
      "about boundary points included; exit 1 if one is wrong");
  const auto a = std::make_shared<VerifyArguments>();
  verify->add_option("--method", a->method, "a method, such as exact")
      ->required();
  verify->add_option("--scalar", a->scalar, "f32 or f64")
      ->capture_default_str();
  verify->add_option("--isa", a->isa, "an ISA; all that run here unless given");
  verify
      ->add_option("--points", a->points,
                   "at least so many; 1e9 take about half an hour")
      ->capture_default_str();
  verify->add_option("--seed", a->seed, "of the scenes")->capture_default_str();
  verify->callback([a] { RunVerify(*a); });
}

}  // namespace pitbench
