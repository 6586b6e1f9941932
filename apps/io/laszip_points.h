// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "las_header.h"

#include <iosfwd>
#include <string>

namespace pcl_ops::apps {

enum class PointsAs { Plain, Compressed };

/** \brief \throws WorkError that says so */
[[noreturn]] void
failDamagedPoints (const std::string& file);

/** \brief The variable length record that goes with compressed points.
 * \throws WorkError if LASzip cannot compress such points */
std::string
laszipVlr (const std::string& file, const LasHeader& header);

/** \brief Writes the points of a file, compressed or not, in either way, from where the
 * stream is.
 * \throws WorkError if they are damaged, and Interrupted */
void
convertPoints (const std::string& file,
               const LasHeader& header,
               PointsAs form,
               std::ostream& stream);

} // namespace pcl_ops::apps
