#include "harness/measure/hunt.h"

#include <cmath>
#include <iostream>
#include <memory>
#include <optional>

#include "harness/command/commands.h"
#include "harness/command/find_kernel.h"
#include "harness/command/output.h"
#include "harness/input/csv.h"
#include "harness/measure/rays/ray_hunt.h"
#include "harness/scenes/generate.h"

namespace pitbench {
namespace {

constexpr std::size_t kKeep = 5;
constexpr double kLongest = 86400;

struct HuntArguments {
  std::string method;
  std::string scalar = "f64";
  std::string isa;
  bool rays = false;
  double seconds = 0;
  std::uint64_t seed = kDefaultSeed;
  std::string out;
};

// search(T()) for the scalar's T.
template <class Search>
std::string Hunted(Scalar scalar, const Search& search) {
  return scalar == Scalar::kF32 ? search(float{}) : search(double{});
}

std::string HuntPoints(const HuntArguments& a) {
  const Scalar scalar = FloatScalar(a.scalar);
  const Kernel& kernel =
      FindCaseKernel(a.method, scalar, a.isa, RayMethodKeys());
  return Hunted(scalar, [&]<class T>(T) {
    return HuntCsv(kernel, Hunt<T>(kernel, a.seconds, a.seed, kKeep));
  });
}

std::string HuntForRays(const HuntArguments& a) {
  const Scalar scalar = FloatScalar(a.scalar);
  const RayKernel& kernel = FindRayPairsKernel(a.method, scalar, a.isa);
  return Hunted(scalar, [&]<class T>(T) {
    return HuntRaysCsv(kernel, HuntRays<T>(kernel, a.seconds, a.seed, kKeep));
  });
}

void RunHunt(const HuntArguments& a) {
  if (!(a.seconds > 0 && a.seconds <= kLongest)) {
    throw InputError("--seconds: give more than 0 and at most 86400 (a day)");
  }
  std::optional<OutputFile> out;
  if (!a.out.empty()) out.emplace(a.out);
  const std::string text =
      MeansRays(a.method, a.rays) ? HuntForRays(a) : HuntPoints(a);
  std::cout << text << std::flush;
  if (!std::cout) throw InputError("cannot write to standard output");
  if (out) out->Commit(text);
}

}  // namespace

void AddHunt(CLI::App& app) {
  CLI::App* hunt = app.add_subcommand(
      "hunt",
      "Searches for the inputs on which a method is most wrong and prints\n"
      "them, the worst first, as CSV with hexadecimal floats");
  const auto a = std::make_shared<HuntArguments>();
  hunt->add_option("--method", a->method, "a method, of points or of rays")
      ->required();
  hunt->add_flag("--rays", a->rays,
                 "the method of rays, where points have one of that name");
  hunt->add_option("--scalar", a->scalar, "f32 or f64")->capture_default_str();
  hunt->add_option("--isa", a->isa,
                   "an ISA; the widest that runs here unless given");
  hunt->add_option("--seconds", a->seconds, "how long to search")->required();
  hunt->add_option("--seed", a->seed, "of the random inputs")
      ->capture_default_str();
  hunt->add_option("--out", a->out, "a CSV file to write as well");
  hunt->callback([a] { RunHunt(*a); });
}

}  // namespace pitbench
