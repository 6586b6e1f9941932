// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "peers.h"

namespace pcl_ops::evaluation {

void
addCgalPeers (std::vector<Configuration>&)
{}

} // namespace pcl_ops::evaluation
