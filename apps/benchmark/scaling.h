// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measures.h"
#include <evaluation/data/data_sets.h>
#include <simulation/scene.h>

namespace pcl_ops::benchmark {

/** \brief A time on the way of something that grows. */
struct ScalingRow {
  /** \brief What grows: points, threads, sampling_rate (in per cent) or planes. */
  std::string series;
  double x = 0.0;
  std::size_t points = 0;
  BestTime time;
};

/** \brief A scene with a known number of planes: square boards, each turned another
 * way, too far apart for two to be taken for one. */
simulation::Scene
makeBoards (unsigned number);

/** \brief OPS, default and paper preset, where one thing grows at a time; over points
 * and planes 3D-KHT and the construction of KdTreeFLANN too.
 * \param[in] cloud for threads and sampling rate; its number of points serves for the
 * simulated boards of the planes too
 * \param[in] growing clouds of growing size */
std::vector<ScalingRow>
measureScaling (const XyzCloud::ConstPtr& cloud,
                const std::vector<evaluation::CloudSource>& growing,
                const MeasureParameters& parameters,
                const Notify& notify);

/** \brief The CSV of these rows. */
std::string
csvOf (const std::vector<ScalingRow>& rows);

} // namespace pcl_ops::benchmark
