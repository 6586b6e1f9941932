// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation.h"

#include "detectors.h"
#include "interpreter.h"
#include "point_array.h"
#include <evaluation/metrics/metrics.h>

#include <limits>

namespace pcl_ops::python {

namespace {

/** \brief Labels as the metrics have them, 0 for none. */
evaluation::PlaneLabels
planeLabels (const char* name, const py::array& given)
{
  constexpr std::int64_t most = std::numeric_limits<std::uint32_t>::max() - 2;
  const auto labels = py::array_t<std::int64_t, py::array::forcecast> (given);
  const auto numbers = labels.unchecked<1>();
  evaluation::PlaneLabels planes;
  planes.reserve (static_cast<std::size_t> (numbers.shape (0)));
  for (py::ssize_t i = 0; i < numbers.shape (0); ++i) {
    if (numbers (i) > most)
      throw py::value_error (std::string (name) + ": the label " +
                             std::to_string (numbers (i)) + " is too large");
    planes.push_back (numbers (i) < 0 ? 0
                                      : static_cast<std::uint32_t> (numbers (i) + 1));
  }
  return planes;
}

apps::XyzCloud
cloudOf (const CloudView& view)
{
  apps::XyzCloud cloud;
  cloud.points.reserve (view.size);
  for (std::size_t i = 0; i < view.size; ++i)
    cloud.points.emplace_back (view[i][0], view[i][1], view[i][2]);
  cloud.width = static_cast<std::uint32_t> (view.size);
  cloud.height = 1;
  return cloud;
}

} // namespace

py::dict
evaluate (const py::array& truth,
          const py::array& result,
          const py::array& points,
          const py::dict& orientation)
{
  const PlaneDetectorParameters named_by = orientationParameters (orientation);
  evaluation::ClassParameters classes;
  classes.up = named_by.up_axis.cast<double>().stableNormalized();
  classes.tolerance = named_by.angle_tolerance;
  const evaluation::PlaneLabels true_labels = planeLabels ("truth", truth);
  const evaluation::PlaneLabels found_labels = planeLabels ("result", result);
  const PointArray array (points);
  evaluation::Metrics metrics;
  whileOthersRun ([&] {
    metrics = evaluation::compareLabels (
        cloudOf (array.view()), true_labels, found_labels, classes);
  });
  py::dict named;
  for (const auto& [name, value] : evaluation::namedMetrics (metrics))
    named[py::str (name)] = value;
  named[evaluation::off_planes_name] = metrics.points_off_planes_called_planes;
  named["points"] = metrics.points;
  named["truth_planes"] = metrics.truth_planes;
  named["result_planes"] = metrics.result_planes;
  return named;
}

} // namespace pcl_ops::python
