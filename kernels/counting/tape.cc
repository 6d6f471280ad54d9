#include "kernels/counting/tape.h"

#include <utility>

namespace pitbench::counting {

std::string_view Name(Kind kind) {
  switch (kind) {
    case Kind::kAdd:
      return "add";
    case Kind::kMultiply:
      return "multiply";
    case Kind::kMultiplyAdd:
      return "multiply_add";
    case Kind::kDivide:
      return "divide";
    case Kind::kMinMax:
      return "min_max";
    case Kind::kCompare:
      return "compare";
    case Kind::kIntegerMinMax:
      return "integer_min_max";
    case Kind::kIntegerMultiply:
      return "integer_multiply";
    case Kind::kLogic:
      return "logic";
    case Kind::kConvert:
      return "convert";
    case Kind::kLoad:
      return "load";
    case Kind::kStore:
      return "store";
    case Kind::kFree:
      return "free";
  }
  return "?";
}

std::size_t OperationHash::operator()(const Operation& operation) const {
  std::uint64_t hash = operation.code;
  const auto mix = [&hash](std::uint64_t value) {
    hash = (hash ^ value) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
  };
  mix(operation.lanes);
  mix(operation.immediate);
  for (const Id id : operation.operands) mix(id);
  return hash;
}

Id Tape::Note(Kind kind, const Operation& operation) {
  const auto [place, is_new] =
      known_.try_emplace(operation, static_cast<Id>(entries_.size()));
  if (is_new) {
    entries_.push_back({kind, operation.lanes, operation.operands});
  }
  return place->second;
}

Operations Tape::Count() const {
  std::vector<bool> used(entries_.size());
  for (const Id id : needed_) used[id] = true;
  Operations counts = {};
  // Operands always stand before what is computed from them.
  for (std::size_t i = entries_.size() - 1; i > 0; --i) {
    if (!used[i]) continue;
    const Entry& entry = entries_[i];
    for (const Id id : entry.operands) used[id] = true;
    if (entry.kind != Kind::kFree) {
      counts[static_cast<std::size_t>(entry.kind)] += entry.lanes;
    }
  }
  return counts;
}

void Tape::Clear() { *this = Tape(); }

Tape& CurrentTape() {
  static thread_local Tape tape;
  return tape;
}

}  // namespace pitbench::counting
