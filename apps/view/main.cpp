// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/point_tests.h>

#include "display.h"
#include "options.h"
#include "point_colors.h"
#include "window.h"
#include <cli/errors.h>
#include <cli/memory.h>
#include <cli/program.h>
#include <io/cloud_damage.h>
#include <io/cloud_fields.h>
#include <io/cloud_file.h>

#include <algorithm>
#include <string>

namespace pcl_ops::apps {

namespace {

ViewedCloud
loadViewed (const std::string& file, const Eigen::Vector3f& up)
{
  const FileCloud cloud = loadCloud (file);
  const ShiftedCloud shifted = shiftedCloudOf (cloud);
  const auto& points = *shifted.cloud;
  const std::string damage = damageOf (shifted);
  if (!damage.empty())
    warn (file + ": " + damage);
  if (std::none_of (points.begin(), points.end(), [] (const pcl::PointXYZ& point) {
        return pcl::isXYZFinite (point);
      }))
    throw WorkError (file,
                     "has no point with finite coordinates, so there is nothing to "
                     "show; give another cloud");
  return {shifted.cloud, shifted.shift, inputColors (cloud, points, up)};
}

int
view (int argc, const char* const* argv)
{
  ViewOptions options;
  if (!readOptions (argc, argv, options))
    return ExitCode::done;
  inMemory (options.input, "give a smaller cloud", [&] {
    const ViewedCloud cloud = loadViewed (
        options.input, options.detector.up.value_or (Eigen::Vector3f::UnitZ()));
    checkDisplay (options.screenshot.empty());
    showCloud (options, cloud);
  });
  return ExitCode::done;
}

} // namespace

} // namespace pcl_ops::apps

int
main (int argc, char** argv)
{
  using namespace pcl_ops::apps;
  return runProgram ("pcl_ops_view", [&] { return view (argc, argv); });
}
