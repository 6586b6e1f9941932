// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "filter.h"

#include <pcl_ops/orientation.h>

#include <algorithm>

namespace pcl_ops::apps {

void
keepOnly (const std::string& only, Detected& detected)
{
  if (only.empty())
    return;
  detected.settings.emplace_back ("only", only);
  std::vector<PlaneSegment>& planes = detected.planes;
  const std::size_t found = planes.size();
  if (only == "largest")
    planes.resize (std::min<std::size_t> (found, 1));
  else
    planes.erase (std::remove_if (planes.begin(),
                                  planes.end(),
                                  [&] (const PlaneSegment& plane) {
                                    return toString (plane.orientation) != only;
                                  }),
                  planes.end());
  if (planes.empty() && found > 0)
    detected.advice = "none of the " + std::to_string (found) + " planes found is " +
                      only + ": leave out --only, or mend --up or --angle-tolerance";
}

} // namespace pcl_ops::apps
