// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"
#include "phases.h"
#include "ranks.h"

#include <iosfwd>
#include <string>

namespace pcl_ops::apps {

/** \brief Does what the command line asks for, together with all other ranks: plan,
 * cells, detection, joining, labels. Parts that are done already, by files that are
 * there, are not done again. \param[out] out a line on what was found, of rank 0
 * \param[out] messages the progress of rank 0, with a bar if it \p is_terminal
 * \throws UsageError, WorkError, Interrupted */
void
runTiles (const TilesOptions& options,
          const Ranks& ranks,
          std::ostream& out,
          std::ostream& messages,
          bool is_terminal);

} // namespace pcl_ops::apps
