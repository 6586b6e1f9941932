// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measures.h"
#include <evaluation/data/data_sets.h>
#include <simulation/scene.h>

namespace pcl_ops::benchmark {

/** \brief A scene with a known number of planes: square boards, each turned another
 * way, too far apart for two to be taken for one. */
simulation::Scene
makeBoards (unsigned number);

/** \brief Times of OPS, default and paper preset, where one thing grows at a time:
 * points, threads, sampling_rate (in per cent) or planes; but for the sampling rate
 * also of 3D-KHT and \ref leastMeasures.
 * \param[in] clouds for threads; the first for the sampling rate, and with its number
 * of points for the simulated boards of the planes
 * \param[in] growing clouds of growing size
 * \return CSV */
std::string
measureScaling (const evaluation::DataSet& clouds,
                const evaluation::DataSet& growing,
                const MeasureParameters& parameters,
                const Notify& notify);

} // namespace pcl_ops::benchmark
