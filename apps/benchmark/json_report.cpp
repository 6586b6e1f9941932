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
toArray (const std::vector<Ratio>& ratios)
{
  Json array = Json::array();
  for (const Ratio& ratio : ratios)
    array.push_back ({{"id", ratio.id},
                      {"name", ratio.text},
                      {"unit", ratio.unit.empty() ? Json() : Json (ratio.unit)},
                      {"value", numberOrNull (ratio.value)}});
  return array;
}

Json
toObject (const BestTimes& times)
{
  Json object = Json::object();
  for (const BestTime& time : times) {
    Json& measure = object[time.name];
    measure["runs"] = time.runs;
    for (const auto& [stage, duration] : apps::detection_stages)
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
          {"rows", toArray (ratiosOf (figures, shared))}};
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
  std::vector<std::vector<Ratio>> ratios;
  for (const CloudFigures& figures : benchmark.clouds) {
    json["clouds"].push_back (toObject (figures, benchmark.shared));
    ratios.push_back (ratiosOf (figures, benchmark.shared));
  }
  json["rows"] = toArray (mediansOf (ratios));
  return json.dump (2) + "\n";
}

} // namespace pcl_ops::benchmark
