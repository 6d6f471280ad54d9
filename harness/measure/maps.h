// Pictures of rounding: what every method says of each point of a small grid.
#ifndef PITBENCH_HARNESS_MEASURE_MAPS_H_
#define PITBENCH_HARNESS_MEASURE_MAPS_H_

#include <nlohmann/json_fwd.hpp>

#include "harness/input/name_filter.h"

namespace pitbench {

// "ulp_maps" and "gradients" of harness/schema/maps.schema.json, of the maps
// that `filter` finds. A map is named like a cell, with ulp_map or
// gradient:far_away for the scene: "one_triangle/ulp_map/epsilon/f32/avx2".
//
// An ulp map is the set-up of Kettner, Mehlhorn, Pion, Schirra and Yap (2008)
// with triangles: 256 × 256 points, an ulp apart, from (0.5, 0.5) on, and the
// two triangles that share the diagonal through them. A gradient is the three
// weights of a triangle sampled on a grid that f32 represents, near the origin
// and exactly the same far from it.
nlohmann::json MakeMaps(const NameFilter& filter);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_MAPS_H_
