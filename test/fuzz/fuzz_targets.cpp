// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_targets.h"

#include <algorithm>

namespace pcl_ops::fuzz {

const std::vector<FuzzTarget>&
allTargets ()
{
  static const std::vector<FuzzTarget> targets = {{"pcd", loadPcd},
                                                  {"ply", loadPly},
                                                  {"las", loadLas},
                                                  {"ascii", loadText},
                                                  {"options", readOptions},
                                                  {"ops", detectByOps},
                                                  {"ops_paper", detectByPublishedOps},
                                                  {"fspf", detectByFspf},
                                                  {"kht", detectByKht},
                                                  {"kht_paper", detectByPublishedKht}};
  return targets;
}

const FuzzTarget&
targetCalled (const std::string& name)
{
  const auto& targets = allTargets();
  const auto found =
      std::find_if (targets.begin(), targets.end(), [&] (const FuzzTarget& target) {
        return target.name == name;
      });
  if (found == targets.end())
    throw std::out_of_range ("no fuzz target is called " + name);
  return *found;
}

} // namespace pcl_ops::fuzz
