// What a kernel computes, written down value by value, and the operations that
// it takes.
//
// The counting build of a kernel computes with types that leave a note here of
// every operation: its kind, its operands, its lanes. A value that was computed
// before from the same operands is the same value and gets no second note; a
// value from which no answer follows is noted but not counted. That is what
// the compiler does with the text as well (common subexpressions, dead code,
// what does not change in a loop), and so the counts are those of the
// instructions that are left, not of the text.
#ifndef PITBENCH_KERNELS_COUNTING_TAPE_H_
#define PITBENCH_KERNELS_COUNTING_TAPE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace pitbench::counting {

// What an operation counts as. An operation on n lanes counts n times.
enum class Kind : std::uint8_t {
  kAdd,              // and subtract
  kMultiply,         // floating point
  kMultiplyAdd,      // a·b + c with one rounding
  kDivide,           // and square root
  kMinMax,           // and the smaller in magnitude
  kCompare,          // into a mask, also under a mask
  kIntegerMinMax,    // of the bits of numbers too
  kIntegerMultiply,  // also of pairs of bytes, with their sum
  kLogic,            // and, or, select, shift, sign; of vectors and of masks
  kConvert,          // to another number type, and lanes moved for it
  kLoad,             // a vector, from memory
  kStore,            // a vector or the bits of a mask
  kFree,             // no instruction: constants, names for the same bits
};
inline constexpr std::size_t kKinds = static_cast<std::size_t>(Kind::kFree);

// "add", "multiply", …, "store".
std::string_view Name(Kind kind);

using Operations = std::array<std::uint64_t, kKinds>;  // by Kind

// A value's place on the tape; 0 is no value.
using Id = std::uint32_t;

// What tells an operation from the others of its kind, e.g. a sum from a
// difference.
struct Operation {
  std::uint32_t code;
  std::uint32_t lanes;
  std::uint64_t immediate = 0;
  std::array<Id, 3> operands = {};

  bool operator==(const Operation&) const = default;
};

struct OperationHash {
  std::size_t operator()(const Operation& operation) const;
};

class Tape {
 public:
  // The value of `operation`; noted unless it is there already.
  Id Note(Kind kind, const Operation& operation);
  // An answer follows from this value: it is stored, or a branch depends on it.
  void Need(Id id) { needed_.push_back(id); }
  // The operations behind all values that were needed.
  Operations Count() const;
  void Clear();

 private:
  struct Entry {
    Kind kind;
    std::uint32_t lanes;
    std::array<Id, 3> operands;
  };
  std::vector<Entry> entries_ = {{}};
  std::unordered_map<Operation, Id, OperationHash> known_;
  std::vector<Id> needed_;
};

// The tape on which this thread's counting kernels write.
Tape& CurrentTape();

}  // namespace pitbench::counting

#endif  // PITBENCH_KERNELS_COUNTING_TAPE_H_
