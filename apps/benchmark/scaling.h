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
  /** \brief Its name. */
  std::string cloud;
};

/** \brief A scene with a known number of planes: square boards, each turned another
 * way, too far apart for two to be taken for one. */
simulation::Scene
makeBoards (unsigned number);

/** \brief OPS, default and paper preset, where one thing grows at a time; but for the
 * sampling rate also 3D-KHT and what no method is faster than, a copy of the cloud and
 * the construction of KdTreeFLANN.
 * \param[in] clouds for threads; the first for the sampling rate, and with its number
 * of points for the simulated boards of the planes
 * \param[in] growing clouds of growing size */
std::vector<ScalingRow>
measureScaling (const std::vector<evaluation::CloudSource>& clouds,
                const std::vector<evaluation::CloudSource>& growing,
                const MeasureParameters& parameters,
                const Notify& notify);

/** \brief The CSV of these rows. */
std::string
csvOf (const std::vector<ScalingRow>& rows);

} // namespace pcl_ops::benchmark
