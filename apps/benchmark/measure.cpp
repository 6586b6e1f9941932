// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "measure.h"

#include <algorithm>
#include <limits>

namespace pcl_ops::benchmark {

BestTimes
measureInTurns (const std::vector<Measure>& measures,
                const Notify& notify,
                const Finish& finish)
{
  BestTimes best (measures.size());
  std::vector<double> spent (measures.size(), 0.0);
  const auto is_finished = [&] (std::size_t i) {
    return best[i].runs >= measures[i].runs || spent[i] > patience;
  };
  bool is_done = false;
  for (std::size_t turn = 0; !is_done; ++turn) {
    is_done = true;
    for (std::size_t i = 0; i < measures.size(); ++i) {
      if (is_finished (i))
        continue;
      is_done = false;
      notify (measures[i].name, measures[i].expected);
      const StageDurations durations = measures[i].run();
      spent[i] += durations.detection;
      if (turn == 0 || durations.detection < best[i].durations.detection)
        best[i] = {measures[i].name, durations, 0};
      best[i].runs = turn + 1;
      if (is_finished (i))
        finish (best[i]);
    }
  }
  return best;
}

double
bestOf (const BestTimes& times, const std::string& name)
{
  const auto found =
      std::find_if (times.begin(), times.end(), [&] (const BestTime& time) {
        return time.name == name;
      });
  return found == times.end() ? std::numeric_limits<double>::quiet_NaN()
                              : found->durations.detection;
}

} // namespace pcl_ops::benchmark
