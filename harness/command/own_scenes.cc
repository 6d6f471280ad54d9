#include "harness/command/own_scenes.h"

#include <array>
#include <string_view>

#include "harness/input/csv.h"

namespace pitbench {

template <class T>
std::vector<Scene<T>> OwnScenes(const std::string& triangles_file,
                                const std::string& points_file) {
  constexpr std::array<std::string_view, 6> kTriangles = {"ax", "ay", "bx",
                                                          "by", "cx", "cy"};
  constexpr std::array<std::string_view, 2> kPoints = {"px", "py"};
  const Table<T> triangles = ReadCsv<T>(triangles_file, kTriangles);
  const Table<T> points = ReadCsv<T>(points_file, kPoints);
  if (triangles.rows == 0) throw InputError(triangles_file + ": no triangles");
  if (points.rows == 0) throw InputError(points_file + ": no points");
  Scene<T> all{.name = "own", .loop = Loop::kOneTriangle};
  const auto& t = triangles.columns;
  for (std::size_t i = 0; i < triangles.rows; ++i) {
    all.Add(Triangle<T>{
        {t[0][i], t[1][i]}, {t[2][i], t[3][i]}, {t[4][i], t[5][i]}});
    all.calls.push_back({i, 0, points.rows});
  }
  for (std::size_t i = 0; i < points.rows; ++i) {
    all.Add(Point<T>{points.columns[0][i], points.columns[1][i]});
  }
  std::vector<Scene<T>> scenes = {all};
  Scene<T> one_point = all;
  one_point.loop = Loop::kOnePoint;
  one_point.calls.clear();
  for (std::size_t i = 0; i < points.rows; ++i) {
    one_point.calls.push_back({0, i, triangles.rows});
  }
  scenes.push_back(one_point);
  if (triangles.rows == points.rows) {
    Scene<T> pairs = all;
    pairs.loop = Loop::kPairs;
    pairs.calls = {{0, 0, points.rows}};
    scenes.push_back(pairs);
  }
  return scenes;
}

template std::vector<Scene<float>> OwnScenes(const std::string&,
                                             const std::string&);
template std::vector<Scene<double>> OwnScenes(const std::string&,
                                              const std::string&);

}  // namespace pitbench
