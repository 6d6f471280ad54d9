#include "harness/measure/input_scenes.h"

#include <string>
#include <string_view>

namespace pitbench {
namespace {

// Lanes one by one, and as many as the CPU has.
const std::vector<Isa> kNarrowAndWide = {Isa::kScalar, Isa::kAvx2, Isa::kAvx512,
                                         Isa::kNeon, Isa::kSve2};

}  // namespace

void AddHitRates(std::vector<ProfileScene>& scenes, Scalar scalar,
                 std::initializer_list<int> percents,
                 std::initializer_list<const char*> sets) {
  for (const int percent : percents) {
    for (const char* kind : sets) {
      std::string name = "uniform:hit=" + std::to_string(percent);
      name.append(":bytes=24k:sets=").append(kind);
      scenes.push_back({name,
                        {Loop::kOneTriangle},
                        scalar,
                        /*weights=*/false,
                        {"cross_product", "cross_product_early_out"},
                        {Isa::kScalar, Isa::kAutovecV3, Isa::kAvx2,
                         Isa::kAvx512, Isa::kNeon, Isa::kSve2}});
    }
  }
}

void AddSizes(std::vector<ProfileScene>& scenes, Scalar scalar,
              const std::vector<std::int64_t>& sizes, const char* sets) {
  for (const std::int64_t n : sizes) {
    std::string name = "uniform:hit=50:n=" + std::to_string(n);
    name.append(":sets=").append(sets);
    scenes.push_back(
        {name,
         {Loop::kOneTriangle},
         scalar,
         /*weights=*/false,
         {"cross_product", "cross_product_unhoisted", "cross_product_centered",
          "edge_function", "edge_function_fma", "edge_slope_fma",
          "barycentric_inverse", "barycentric_determinant", "uv_projection",
          "exact"},
         kNarrowAndWide});
  }
}

void AddSideBySide(std::vector<ProfileScene>& scenes, Scalar scalar,
                   const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    scenes.push_back({name,
                      {Loop::kOneTriangleAos},
                      scalar,
                      /*weights=*/false,
                      {"edge_function", "edge_function_fma"},
                      kNarrowAndWide});
  }
}

void AddThreads(std::vector<ProfileScene>& scenes, Scalar scalar,
                const char* bytes) {
  std::string name = "uniform:hit=50:bytes=";
  name.append(bytes).append(":sets=fresh");
  scenes.push_back({name,
                    {Loop::kOneTriangle},
                    scalar,
                    /*weights=*/false,
                    {"cross_product", "edge_function_fma"},
                    kNarrowAndWide,
                    /*threads=*/true});
}

std::vector<std::int64_t> PointCounts(int first, int last, int step) {
  std::vector<std::int64_t> values;
  for (int k = first; k <= last; k += step) {
    values.push_back(std::int64_t{1} << k);
  }
  return values;
}

}  // namespace pitbench
