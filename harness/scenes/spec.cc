#include "harness/scenes/spec.h"

#include <algorithm>
#include <charconv>

#include "harness/input/nearest.h"

namespace pitbench {
namespace {

std::vector<std::string_view> Split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  std::size_t first = 0;
  while (true) {
    const std::size_t end = text.find(separator, first);
    parts.push_back(text.substr(first, end - first));
    if (end == std::string_view::npos) return parts;
    first = end + 1;
  }
}

}  // namespace

const std::vector<FamilyInfo>& Families() {
  static const std::vector<FamilyInfo> families = {
      {"uniform", "hit:bytes|n:sets",
       "Points uniform in the unit square, triangles that cover hit percent of "
       "it; a call reads about so many bytes, or has n items. sets=fresh (as "
       "without it) takes another triangle, for one_point and pairs other "
       "points, at every call; sets=fixed always the same."},
      {"near_edge", "ulps:sets",
       "Points rounded onto an edge of a well-shaped triangle in the unit "
       "square and then moved off it, to either side, by this many "
       "representable numbers; of ulps=0 half are exactly on the edge."},
      {"needle", "aspect:sets",
       "Triangles of length 1 and altitude 2^-aspect in any direction; points "
       "around them within twice their altitude."},
      {"offset", "ratio:sets",
       "Well-shaped triangles and points in a unit square whose corner is at "
       "(2^ratio, 2^ratio)."},
      {"grid_80x50", "sets",
       "Triangles with random whole vertices against every pixel of a grid of "
       "80 columns and 50 rows, as in qTriangle's program."},
      {"grid_points_80x50", "sets",
       "The same triangles and the same pixels, but these as an array of 4000 "
       "points, as i32, i16 and u8; a call is one triangle."},
      {"own", "", "Triangles and points from your own CSV files."},
      {"on_edge", "percent:sets",
       "Points of which so many percent are exactly on an edge, and all others "
       "are uniform in the unit square; well-shaped triangles."},
      {"on_boundary", "at:binades:sets",
       "Points all exactly on an edge (at=edge) or vertices of the triangle "
       "(at=vertex), whose coordinates have exponents that spread over so many "
       "binades."},
      {"near_vertex", "ulps:sets",
       "Points this many representable numbers away from a vertex of a "
       "well-shaped triangle in the unit square."},
      {"scale", "exponent:sets",
       "Well-shaped triangles and points in a square of side 2^exponent at the "
       "origin, from subnormal numbers to nearly the largest."},
      {"exponent_spread", "binades:sets",
       "Triangles whose coordinates have exponents from -binades to 0 and "
       "either sign; points rounded onto their edges."},
      {"cancellation", "binades:sets",
       "Triangles with an edge from v to -v; points v times 2^-binades, "
       "exactly "
       "on it or up to two representable numbers off."},
      {"whole_numbers", "bits:sets",
       "Triangles and points with whole coordinates from -2^bits to 2^bits; "
       "points on an edge or as near to it as whole numbers can be."},
      {"degenerate", "kind:sets",
       "Triangles without area, exactly: kind=collinear, doubled (two vertices "
       "are one) or single (all are one). Points on their line and near it."},
      {"special", "kind:sets",
       "Well-shaped triangles with special values among the coordinates: "
       "kind=nan, infinite, minus_zero (on the axes), subnormal or largest "
       "(up to the largest finite number)."},
      {"mesh_pair", "ulps",
       "Two triangles that share an edge, each asked about points rounded onto "
       "the edge and moved off it by this many representable numbers."},
      {"mesh_fan", "ulps",
       "Eight triangles around a vertex, each asked about points that many "
       "representable numbers from the vertex and from the edges to it."},
      {"mesh_triangulation", "ulps",
       "A random triangulation of 10 000 triangles; points that many "
       "representable numbers off its edges, on its vertices, and anywhere."},
      {"corpus", "",
       "The cases of tests/cases/real_world.csv, from published bug reports."},
      {"rays_uniform", "hit:bytes|n:sets",
       "Rays through one point in directions about (1, 1, 1), from anywhere "
       "behind it; triangles that hit percent of them meet. bytes, n and sets "
       "as for uniform, with a ray for the point."},
      {"rays_near_edge", "ulps:sets",
       "Rays to a point rounded onto an edge of a well-shaped triangle in the "
       "unit cube and then moved across it by this many representable "
       "numbers."},
      {"rays_near_vertex", "ulps:sets",
       "Rays to a point this many representable numbers away from a vertex of "
       "a well-shaped triangle in the unit cube."},
      {"rays_grazing", "exponent:sets",
       "Rays at an angle of about 2^-exponent to the triangle's plane, exactly "
       "drawn, that meet it in the triangle and beside it."},
      {"rays_needle", "aspect:sets",
       "Triangles of length 1 and altitude 2^-aspect in any direction in "
       "space; rays to points around them within twice their altitude."},
      {"rays_far_origin", "exponent:sets",
       "Rays of length 1 from 2^exponent away to points in a well-shaped "
       "triangle in the unit cube and around it."},
      {"rays_offset", "ratio:sets",
       "Well-shaped triangles in a unit cube whose corner is at (2^ratio, "
       "2^ratio, 2^ratio), and rays from near by."},
      {"rays_degenerate", "kind:sets",
       "Misses, exactly: kind=collinear, doubled or single (triangles without "
       "area, as for degenerate), zero_direction, or parallel (rays in the "
       "triangle's plane or parallel to it)."},
      {"rays_special", "kind:sets",
       "Special values among the numbers of triangles and rays: kind=nan, "
       "infinite, minus_zero (on the axes), subnormal or largest (up to the "
       "largest finite number)."},
      {"rays_icosphere", "ulps",
       "A closed sphere of 1280 triangles; rays from inside to triangles, and "
       "this many representable numbers off edges and vertices, asked of all "
       "triangles around. Each crosses the sphere once."},
      {"rays_tiled_plane", "ulps",
       "A tilted plane of 1152 triangles, exactly flat; rays from above, aimed "
       "and asked in the same way."},
      {"rays_corpus", "",
       "The cases of tests/cases/rays.csv, from published bug reports."},
  };
  return families;
}

std::int64_t SceneSpec::Number(std::string_view key, std::int64_t low,
                               std::int64_t high) const {
  const std::string& text = parameters.find(key)->second;
  std::string_view digits = text;
  std::int64_t unit = 1;
  if (digits.ends_with('k')) unit = std::int64_t{1} << 10;
  if (digits.ends_with('M')) unit = std::int64_t{1} << 20;
  if (unit != 1) digits.remove_suffix(1);
  std::int64_t value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() ||
      value < low / unit || value > high / unit) {
    throw SceneError("scene '" + name + "': " + std::string(key) +
                     " must be a whole number from " + std::to_string(low) +
                     " to " + std::to_string(high) + ", not '" + text + "'");
  }
  return value * unit;
}

std::string_view SceneSpec::Word(
    std::string_view key,
    std::initializer_list<std::string_view> allowed) const {
  const std::string& word = parameters.find(key)->second;
  std::string choices;
  for (const std::string_view choice : allowed) {
    if (word == choice) return word;
    if (!choices.empty()) choices += ", ";
    choices += choice;
  }
  throw SceneError("scene '" + name + "': " + std::string(key) +
                   " must be one of " + choices + ", not '" + word + "'");
}

bool SceneSpec::Fresh() const {
  return !parameters.contains("sets") ||
         Word("sets", {"fresh", "fixed"}) == "fresh";
}

std::string SceneSpec::Drawn() const {
  return name.substr(0, name.rfind(":sets="));
}

SceneSpec ParseScene(std::string_view name) {
  SceneSpec spec;
  spec.name = name;
  std::vector<std::string_view> parts = Split(name, ':');
  spec.family = parts.front();
  std::vector<std::string_view> names;
  for (const FamilyInfo& family : Families()) names.push_back(family.name);
  if (std::find(names.begin(), names.end(), spec.family) == names.end()) {
    throw SceneError(NoSuch("scene", spec.family, names));
  }
  const FamilyInfo& family = *std::find_if(
      Families().begin(), Families().end(),
      [&spec](const FamilyInfo& info) { return info.name == spec.family; });
  std::vector<std::string_view> keys;
  if (!family.parameters.empty()) keys = Split(family.parameters, ':');
  parts.erase(parts.begin());
  if (parts.size() + 1 == keys.size() && keys.back() == "sets") {
    keys.pop_back();
  }
  bool fits = parts.size() == keys.size();
  for (std::size_t k = 0; fits && k < keys.size(); ++k) {
    const std::size_t equals = parts[k].find('=');
    const std::string_view key = parts[k].substr(0, equals);
    const std::vector<std::string_view> either = Split(keys[k], '|');
    fits = equals != std::string_view::npos &&
           std::find(either.begin(), either.end(), key) != either.end();
    if (fits) spec.parameters.emplace(key, parts[k].substr(equals + 1));
  }
  if (!fits) {
    std::string form(family.name);
    for (const std::string_view key : keys) {
      form.append(":").append(key).append("=…");
    }
    throw SceneError("scene '" + spec.name + "' must have the form '" + form +
                     "'");
  }
  return spec;
}

}  // namespace pitbench
