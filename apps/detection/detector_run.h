// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "advice.h"
#include "methods.h"
#include <cli/errors.h>

#include <optional>
#include <sstream>
#include <string>

namespace pcl_ops::apps {

/** \brief Stores an option that was given. */
template <typename Option, typename Parameter>
void
override (const std::optional<Option>& option, Parameter& parameter)
{
  if (option)
    parameter = *option;
}

/** \brief The help of an option, with the value of each preset. */
template <typename Value>
std::string
withPresets (const std::string& help, const Value& usual, const Value& paper)
{
  std::ostringstream text;
  text << help << " (" << usual;
  if (usual != paper)
    text << "; paper " << paper;
  text << ")";
  return text.str();
}

/** \brief Stores the options all methods share. */
void
overrideCommon (const DetectorOptions& options, PlaneDetectorParameters& parameters);

/** \brief The parameters of the preset, with the shared options that were given. */
template <typename Parameters>
Parameters
presetOf (const DetectorOptions& options)
{
  Parameters parameters =
      options.preset == "paper" ? Parameters::paper() : Parameters();
  overrideCommon (options, parameters);
  return parameters;
}

/** \brief The parameters under the names of their options: the preset, those of the
 * method, those all methods share. */
nlohmann::ordered_json
describe (const std::string& preset,
          const nlohmann::ordered_json& own,
          const PlaneDetectorParameters& parameters);

/** \brief The call all detectors share.
 * \param[in] parameters all parameters
 * \param[in] described the same for the report
 * \param[in] cloud where to look for planes
 * \throws WorkError if the detector could not do its work */
template <typename Detector>
Detected
detectBy (const typename Detector::Parameters& parameters,
          nlohmann::ordered_json described,
          const XyzCloud::ConstPtr& cloud)
{
  const std::string problem = problemOf (parameters);
  if (!problem.empty())
    throw UsageError (Detector::className(), problem + "; see --help");
  Detector detector;
  detector.setParameters (parameters);
  detector.setInputCloud (cloud);
  Detected detected;
  if (!detector.segment (detected.planes))
    throw WorkError (Detector::className(),
                     "gave up, most likely for lack of memory; try a smaller cloud");
  detected.timing = detector.getStageDurations();
  detected.parameters = std::move (described);
  detected.up = parameters.up_axis;
  if (isHardlyCovered (*cloud, detected.planes))
    detected.advice = adviceFor (parameters, *cloud);
  return detected;
}

} // namespace pcl_ops::apps
