#include "harness/measure/verify.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "harness/command/commands.h"
#include "harness/command/find_kernel.h"
#include "harness/command/output.h"
#include "harness/input/csv.h"
#include "harness/measure/machine.h"
#include "harness/measure/rays/ray_verify.h"
#include "harness/scenes/generate.h"

namespace pitbench {
namespace {

struct VerifyArguments {
  std::string method;
  std::string scalar = "f64";
  std::string isa;
  bool rays = false;
  double points = 1e7;
  std::uint64_t seed = kDefaultSeed;
  std::string out;
};

// What was verified, and what came out.
struct Verified {
  Verification result;
  std::vector<std::string> isas;
  std::vector<std::string> loops;

  template <class K>
  explicit Verified(const std::vector<const K*>& kernels) {
    for (const K* kernel : kernels) {
      AddOnce(std::string(Name(kernel->isa)), isas);
      AddOnce(std::string(Name(kernel->loop, kernel->output)), loops);
    }
  }

 private:
  static void AddOnce(const std::string& name,
                      std::vector<std::string>& names) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
};

// Those of `all` that the arguments mean.
template <class K, class Fits>
std::vector<const K*> Meant(std::span<const K> all, const VerifyArguments& a,
                            Scalar scalar, const Fits& fits) {
  std::vector<const K*> kernels;
  for (const K& kernel : all) {
    if (kernel.method.key == a.method && kernel.scalar == scalar &&
        fits(kernel) && RunsHere(kernel.isa) &&
        (a.isa.empty() || Name(kernel.isa) == a.isa)) {
      kernels.push_back(&kernel);
    }
  }
  return kernels;
}

template <class T>
Verified Run(const VerifyArguments& a) {
  const auto points = static_cast<std::size_t>(a.points);
  const auto progress = [&, shown =
                                std::size_t{0}](const Verification& v) mutable {
    const auto percent = static_cast<std::size_t>(
        100 * static_cast<double>(v.points) / a.points);
    if (percent <= shown) return;
    shown = percent;
    std::cerr << percent << " %, " << v.wrong << " wrong\n";
  };
  // The searches throw if there is no such kernel.
  if (MeansRays(a.method, a.rays)) {
    FindRayPairsKernel(a.method, ScalarOf<T>(), a.isa);
    const auto kernels = Meant(AllRayKernels(), a, ScalarOf<T>(),
                               [](const RayKernel&) { return true; });
    Verified verified(kernels);
    verified.result = VerifyRays<T>(kernels, points, a.seed, progress);
    return verified;
  }
  FindCaseKernel(a.method, ScalarOf<T>(), a.isa, RayMethodKeys());
  const auto kernels = Meant(
      AllKernels(), a, ScalarOf<T>(),
      [](const Kernel& kernel) { return kernel.output == Output::kInside; });
  Verified verified(kernels);
  verified.result = Verify<T>(kernels, points, a.seed, progress);
  return verified;
}

nlohmann::json FileOf(const VerifyArguments& a, const Verified& verified,
                      double seconds) {
  const Verification& v = verified.result;
  return {{"context",
           {{"schema", "pitbench-verify-2"},
            {"revision", Revision()},
            {"dirty", Dirty()},
            {"kernel_hash", KernelHash()},
            {"seed", a.seed}}},
          {"of", MeansRays(a.method, a.rays) ? "rays" : "points"},
          {"method", a.method},
          {"scalar", a.scalar},
          {"isas", verified.isas},
          {"loops", verified.loops},
          {"points", v.points},
          {"boundary_points", v.boundary},
          {"answers", v.answers},
          {"wrong", v.wrong},
          {"first_wrong", v.wrong == 0 ? nlohmann::json(nullptr)
                                       : nlohmann::json(v.first_wrong)},
          {"seconds", seconds},
          {"truth_points_per_second",
           static_cast<double>(v.judged) / v.truth_seconds}};
}

void RunVerify(const VerifyArguments& a) {
  if (!(a.points >= 1 && a.points <= 1e15)) {
    throw InputError("--points: give a number from 1 to 1e15");
  }
  std::optional<OutputFile> out;
  if (!a.out.empty()) out.emplace(a.out);
  const auto start = std::chrono::steady_clock::now();
  const Verified verified =
      FloatScalar(a.scalar) == Scalar::kF32 ? Run<float>(a) : Run<double>(a);
  const std::chrono::duration<double> time =
      std::chrono::steady_clock::now() - start;
  const nlohmann::json file = FileOf(a, verified, time.count());
  const Verification& v = verified.result;
  std::cout << v.points << ' ' << file.at("of").get<std::string>() << " ("
            << v.boundary << " on a boundary), " << v.answers << " answers, "
            << v.wrong << " wrong\n"
            << std::flush;
  std::cerr << "truth: " << file.at("truth_points_per_second").get<double>()
            << " a second\n";
  if (out) out->Commit(file.dump(1) + "\n");
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
  verify->add_flag("--rays", a->rays,
                   "the method of rays, where points have one of that name");
  verify->add_option("--scalar", a->scalar, "f32 or f64")
      ->capture_default_str();
  verify->add_option("--isa", a->isa, "an ISA; all that run here unless given");
  verify
      ->add_option("--points", a->points,
                   "at least so many; 1e9 take about half an hour")
      ->capture_default_str();
  verify->add_option("--seed", a->seed, "of the scenes")->capture_default_str();
  verify->add_option("--out", a->out, "a JSON file that keeps the result");
  verify->callback([a] { RunVerify(*a); });
}

}  // namespace pitbench
