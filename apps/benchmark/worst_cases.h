// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_measures.h"
#include "peak_memory.h"
#include "worst_clouds.h"
#include <evaluation/data/cloud_source.h>

#include <iosfwd>

namespace pcl_ops::benchmark {

/** \brief The detectors that have bounds to keep, by their names in the evaluation. */
constexpr const char* bounded_detectors =
    "ops,ops-3-30,fspf,fspf-0.07-0.14,kht,kht-80-800";

/** \brief What a cloud may cost, as a multiple of a room of as many points. @{ */
constexpr double time_bound = 20.0;
constexpr double memory_bound = 10.0;
/** @} */

/** \brief What a detector needs. */
struct Cost {
  /** \brief [us] */
  double time_per_point = std::numeric_limits<double>::quiet_NaN();
  /** \brief At its peak, without the cloud itself; NaN where the system does not tell.
   */
  double bytes = std::numeric_limits<double>::quiet_NaN();
};

/** \brief A detector on a cloud and on a room of as many points. */
struct WorstCase {
  std::string cloud;
  std::string detector;
  Cost cost;
  Cost of_room;

  double
  timeRatio () const
  {
    return cost.time_per_point / of_room.time_per_point;
  }

  double
  memoryRatio () const
  {
    return cost.bytes / of_room.bytes;
  }
};

/** \brief Measures a detector on a cloud and a room, in turns.
 * \param[in] room_bytes its peak memory on the room, which is not measured again */
WorstCase
measureWorstCase (const evaluation::Configuration& detector,
                  const std::string& name,
                  const evaluation::XyzCloud::ConstPtr& cloud,
                  const evaluation::XyzCloud::ConstPtr& room,
                  double room_bytes,
                  const MeasureParameters& parameters);

/** \brief Measures and prints, row by row, what all detectors cost on all worst clouds,
 * and at the end the largest ratios.
 * \param[in] rooms of the numbers of points wanted */
void
printWorstCases (const std::vector<evaluation::CloudSource>& rooms,
                 const MeasureParameters& parameters,
                 const Notify& notify,
                 std::ostream& stream);

} // namespace pcl_ops::benchmark
