// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <detection/methods.h>

#include <string>

namespace pcl_ops::apps {

/** \brief Keeps some planes and forgets the others, whose points then count as on no
 * plane; ids follow the size of those kept. Where none is left, the advice says why.
 * \param[in] only an orientation or "largest"; empty for all planes */
void
keepOnly (const std::string& only, Detected& detected);

} // namespace pcl_ops::apps
