// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_targets.h"

namespace pcl_ops::fuzz {

const std::map<std::string, void (*) (const Bytes&)>&
allTargets ()
{
  static const std::map<std::string, void (*) (const Bytes&)> targets = {
      {"pcd", loadPcd},
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

} // namespace pcl_ops::fuzz
