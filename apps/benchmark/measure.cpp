// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "measure.h"

#include <limits>

namespace pcl_ops::benchmark {

BestTimes
measureInTurns (const std::vector<Measure>& measures, const Notify& notify)
{
  BestTimes best (measures.size());
  std::vector<double> spent (measures.size(), 0.0);
  bool is_done = false;
  for (std::size_t turn = 0; !is_done; ++turn) {
    is_done = true;
    for (std::size_t i = 0; i < measures.size(); ++i) {
      if (turn >= measures[i].runs || spent[i] > patience)
        continue;
      is_done = false;
      notify (measures[i].name);
      const StageDurations durations = measures[i].run();
      spent[i] += durations.detection;
      if (turn == 0 || durations.detection < best[i].durations.detection)
        best[i] = {measures[i].name, durations, 0};
      best[i].runs = turn + 1;
    }
  }
  return best;
}

double
bestOf (const BestTimes& times, const std::string& name)
{
  for (const BestTime& time : times)
    if (time.name == name)
      return time.durations.detection;
  return std::numeric_limits<double>::quiet_NaN();
}

} // namespace pcl_ops::benchmark
