// The name of a scene and what it means: a family and its parameters,
// `family:key=value:…`, e.g. `uniform:hit=50:bytes=24k:sets=fresh`.
#ifndef PITBENCH_HARNESS_SCENES_SPEC_H_
#define PITBENCH_HARNESS_SCENES_SPEC_H_

#include <cstdint>
#include <initializer_list>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pitbench {

// A scene that does not exist, or a parameter out of range; says what to do.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct SceneSpec {
  std::string name;
  std::string family;
  std::map<std::string, std::string, std::less<>> parameters;

  // The value of a parameter; SceneError if it is no whole number in
  // [low, high]. A suffix k or M stands for 2^10 or 2^20.
  std::int64_t Number(std::string_view key, std::int64_t low,
                      std::int64_t high) const;
  // The value of a parameter; SceneError if it is none of `allowed`.
  std::string_view Word(std::string_view key,
                        std::initializer_list<std::string_view> allowed) const;
  // Whether parameter `sets` is `fresh`, as it is where the name does not give
  // it (else it is `fixed`).
  bool Fresh() const;
  // The name without `sets`: what the random numbers depend on, so that the
  // fixed twin of a scene is the first set of the fresh one.
  std::string Drawn() const;
};

struct FamilyInfo {
  std::string_view name;
  std::string_view parameters;  // in the order in which names give them; one
                                // of those with a | between them; a last
                                // `sets` may be left out of a name
  std::string_view describes;
};

// Every family of scenes.
const std::vector<FamilyInfo>& Families();

// Throws SceneError if the family or a key is unknown or missing; suggests the
// nearest name.
SceneSpec ParseScene(std::string_view name);

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_SCENES_SPEC_H_
