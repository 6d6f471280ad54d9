// Pictures of leaks: how many triangles of a closed surface claim each ray of a
// small window of directions.
#ifndef PITBENCH_HARNESS_MEASURE_RAYS_RAY_MAPS_H_
#define PITBENCH_HARNESS_MEASURE_RAYS_RAY_MAPS_H_

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "harness/input/name_filter.h"
#include "harness/scenes/rays/ray_scene.h"

namespace pitbench {

inline constexpr std::size_t kRayMapSide = 64;  // in directions

// A window of directions around a vertex of the icosphere (ray_surface.h), as
// seen from a point within it: call k asks all rays of the k-th triangle around
// the vertex. Ray j · kRayMapSide + i has the direction that leads to the
// vertex, plus (i − kRayMapSide / 2) and (j − kRayMapSide / 2) steps along the
// two axes that are not its longest; a step is the gap between the numbers of T
// from ½ to 1, where the longest component is, so all directions are exact.
// Each ray crosses the surface once, in one of these triangles or on their
// common edges. T is float or double.
template <class T>
RayScene<T> RayMapScene();

// "ray_windows", "ray_maps" and "ray_cases" of harness/schema/maps.schema.json:
// of the maps and cases that `filter` finds, named like cells with ray_map and
// rays_corpus for the scene: "one_triangle_rays/ray_map/watertight/f32/avx2".
nlohmann::json MakeRayMaps(const NameFilter& filter);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_RAYS_RAY_MAPS_H_
