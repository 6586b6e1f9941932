// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "json_report.h"

#include <detection/stages.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace pcl_ops::benchmark {

namespace {

using Json = nlohmann::ordered_json;

Json
numberOrNull (double number)
{
  return std::isnan (number) ? Json() : Json (number);
}

Json
toArray (const std::vector<TargetRow>& rows)
{
  Json array = Json::array();
  for (const TargetRow& row : rows)
    array.push_back (
        {{"id", row.target.id},
         {"name", row.target.text},
         {"unit", row.target.unit.empty() ? Json() : Json (row.target.unit)},
         {"value", numberOrNull (row.value)},
         {"better", row.target.less_is_better ? "less" : "more"},
         {"target", row.target.target},
         {"hoped_for", numberOrNull (row.target.hoped_for)},
         {"reached", toString (reachedBy (row))}});
  return array;
}

Json
toObject (const BestTimes& times)
{
  Json object = Json::object();
  for (const BestTime& time : times) {
    Json& measure = object[time.name];
    measure["runs"] = time.runs;
    for (const auto& [stage, duration] : apps::kStages)
      measure[std::string (stage) + "_ms"] = time.durations.*duration;
  }
  return object;
}

Json
toObject (const PeakMemory& peak)
{
  return {{"points", peak.points},
          {"cloud_bytes", numberOrNull (peak.cloud_bytes)},
          {"extra_bytes", numberOrNull (peak.extra_bytes)}};
}

Json
toObject (const CloudFigures& figures, const SharedFigures& shared)
{
  return {{"name", figures.name},
          {"points", figures.points},
          {"times", toObject (figures.times)},
          {"peak_memory", toObject (figures.peak)},
          {"rows", toArray (rowsOf (figures, shared))}};
}

} // namespace

std::string
jsonOf (const Benchmark& benchmark)
{
  Json json{{"program", "pcl_ops_benchmark"}, {"version", PCL_OPS_VERSION}};
  json["machine"] = {{"cpu", benchmark.machine.cpu},
                     {"cores", benchmark.machine.cores},
                     {"compiler", benchmark.machine.compiler},
                     {"pcl", benchmark.machine.pcl_version}};
  json["runs"] = benchmark.parameters.runs;
  json["peer_runs"] = benchmark.parameters.peer_runs;
  json["seed"] = benchmark.parameters.seed;
  json["arithmetic_speedup"] = numberOrNull (benchmark.shared.arithmetic_speedup);
  json["peak_memory"] = toObject (benchmark.shared.peak);
  json["clouds"] = Json::array();
  std::vector<std::vector<TargetRow>> rows;
  for (const CloudFigures& figures : benchmark.clouds) {
    json["clouds"].push_back (toObject (figures, benchmark.shared));
    rows.push_back (rowsOf (figures, benchmark.shared));
  }
  json["rows"] = toArray (mediansOf (rows));
  return json.dump (2) + "\n";
}

} // namespace pcl_ops::benchmark
