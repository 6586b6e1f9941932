// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "advice.h"
#include "methods.h"
#include "number_option.h"
#include "shared_options.h"
#include <cli/errors.h>

#include <functional>
#include <new>
#include <string>
#include <utility>

namespace pcl_ops::apps {

/** \brief What the command line needs to know of a detector. */
template <typename Detector>
struct MethodTable {
  using Parameters = typename Detector::Parameters;

  std::string name;
  std::string title;
  OptionTable<Parameters> options = {};
  /** \brief Settings no option changes, before and behind those of options. */
  std::function<Settings (const Parameters&)> first_settings = {}, last_settings = {};
  /** \brief Sets what follows from options that were given; may refuse them. */
  std::function<void (const GivenNumbers&, Parameters&)> relate = {};
  /** \brief May refuse parameters for so many points. */
  std::function<void (const Parameters&, std::size_t points)> check_points = {};
};

/** \brief The preset with the options that were given.
 * \throws UsageError if they contradict each other */
template <typename Detector>
typename Detector::Parameters
parametersOf (const MethodTable<Detector>& table, const DetectorOptions& options)
{
  using Parameters = typename Detector::Parameters;
  Parameters parameters =
      options.preset == "paper" ? Parameters::paper() : Parameters();
  applyShared (options, parameters);
  apply (table.options, options.own, parameters);
  if (table.relate)
    table.relate (options.own, parameters);
  const std::string problem = problemOf (parameters);
  if (!problem.empty())
    throw UsageError (Detector::className(), problem + "; see --help");
  return parameters;
}

/** \brief All parameters for a report, under the names of their options. */
template <typename Detector>
Settings
settingsOf (const MethodTable<Detector>& table,
            const std::string& preset,
            const typename Detector::Parameters& parameters)
{
  Settings settings{{"preset", preset}};
  const auto append = [&] (const Settings& more) {
    settings.insert (settings.end(), more.begin(), more.end());
  };
  if (table.first_settings)
    append (table.first_settings (parameters));
  append (settingsOf (table.options, parameters));
  if (table.last_settings)
    append (table.last_settings (parameters));
  append (sharedSettings (parameters));
  return settings;
}

/** \brief The planes of a cloud.
 * \throws UsageError as \ref parametersOf, std::bad_alloc */
template <typename Detector>
Detected
detectBy (const MethodTable<Detector>& table,
          const DetectorOptions& options,
          const XyzCloud::ConstPtr& cloud)
{
  const auto parameters = parametersOf (table, options);
  if (table.check_points)
    table.check_points (parameters, cloud->size());
  Detector detector;
  detector.setParameters (parameters);
  detector.setInputCloud (cloud);
  Detected detected;
  // Cloud and parameters are valid: nothing but the memory is left to fail.
  if (!detector.segment (detected.planes))
    throw std::bad_alloc();
  detected.timing = detector.getStageDurations();
  detected.settings = settingsOf (table, options.preset, parameters);
  detected.up = parameters.up_axis;
  if (isHardlyCovered (*cloud, detected.planes))
    detected.advice = adviceFor (parameters, *cloud);
  return detected;
}

template <typename Detector>
Method
methodOf (const MethodTable<Detector>& table)
{
  return {table.name,
          table.title,
          [table] (CommandLine& line, GivenNumbers& given) {
            declare (table.options, line, given);
          },
          [table] (const DetectorOptions& options, const XyzCloud::ConstPtr& cloud) {
            return detectBy (table, options, cloud);
          }};
}

} // namespace pcl_ops::apps
