// What the numbers were measured on and with.
#ifndef PITBENCH_HARNESS_MEASURE_MACHINE_H_
#define PITBENCH_HARNESS_MEASURE_MACHINE_H_

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace pitbench {

// The contents of machine.json (harness/schema/machine.schema.json). What the
// system does not tell is null.
nlohmann::json DescribeMachine(std::uint64_t seed);

// The git revision that was built, "unknown" outside a checkout, and whether
// the checkout had changes.
std::string_view Revision();
bool Dirty();
// Of the kernels' sources (harness/build_info.cmake).
std::string_view KernelHash();

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_MEASURE_MACHINE_H_
