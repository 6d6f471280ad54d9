#include "harness/measure/benchmarks.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "harness/measure/quiet.h"

namespace pitbench {
namespace {

using nlohmann::json;

json RowOf(const std::string& name) {
  return {{"name", name}, {"run_name", name}, {"run_type", "iteration"}};
}

}  // namespace

void Benchmarks::Add(const std::string& name, const TimedCalls& calls,
                     const Work& work, int threads) {
  rows_.push_back({name, work, threads});
  calls_.push_back(calls);
}

void Benchmarks::Refuse(const std::string& name, const std::string& why) {
  refusals_.push_back(RowOf(name));
  refusals_.back()["error_occurred"] = true;
  refusals_.back()["error_message"] = why;
}

SpeedRun Benchmarks::Run(const SliceBudget& budget) const {
  if (cells_ == 0) return {};
  const OccupancyMeter meter;
  std::array<Pace, 2> halves;
  QuietPlace place;
  const SliceTimes times = TimeInSlices(calls_, budget, kRepetitions,
                                        {.look = [&] { return place.Look(); },
                                         .between =
                                             [&](double done) {
                                               Pace& half =
                                                   halves[done < 0.5 ? 0 : 1];
                                               half = Best(half, SamplePace());
                                             }});
  const Occupancy occupancy = meter.Read();
  json rows = json::array();
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const auto& [name, work, threads] = rows_[k];
    for (std::size_t index = 0; index < times.rows[k].size(); ++index) {
      const Repetition& repetition = times.rows[k][index];
      json row = RowOf(name);
      row["repetitions"] = kRepetitions;
      row["repetition_index"] = index;
      row["threads"] = threads;
      row["iterations"] = repetition.calls;
      row["real_time"] = 1e9 * repetition.call_seconds;
      row["mean_time"] = 1e9 * repetition.mean_call_seconds;
      row["time_unit"] = "ns";
      row["items_per_second"] =
          static_cast<double>(work.items) / repetition.call_seconds;
      row["items"] = work.items;
      row["working_set_bytes"] = work.working_set_bytes;
      row["bytes_per_item"] = work.bytes_per_item;
      row["scene_bytes"] = work.scene_bytes;
      rows.push_back(std::move(row));
    }
  }
  for (const json& refusal : refusals_) rows.push_back(refusal);
  return {{{"context", json::object()}, {"benchmarks", std::move(rows)}},
          cells_,
          refusals_.size(),
          occupancy,
          halves,
          times.quiet_share};
}

}  // namespace pitbench
