// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scene.h"
#include <pcl_ops/oriented_point_sampling.h>

#include <functional>

namespace {

using Parameters = pcl_ops::OrientedPointSamplingParameters;
using Change = std::function<void (Parameters&)>;

/** \brief What problemOf says after a change to the paper's parameters. */
std::string
problemAfter (const Change& change)
{
  Parameters parameters = Parameters::paper();
  change (parameters);
  return problemOf (parameters);
}

struct OutOfRange {
  std::string words;
  Change change;
};

const std::vector<OutOfRange> out_of_range{
    {"sampling rate", [] (Parameters& p) { p.sampling_rate = 0.0; }},
    {"sampling rate", [] (Parameters& p) { p.sampling_rate = 1.01; }},
    {"k must be 2", [] (Parameters& p) { p.normals.k = 1; }},
    {"k must be 2", [] (Parameters& p) { p.normals.k = -5; }},
    {"probability", [] (Parameters& p) { p.probability = 0.0; }},
    {"probability", [] (Parameters& p) { p.probability = 1.0; }},
    {"distance threshold", [] (Parameters& p) { p.distance_threshold = 0.0; }},
    {"angle tolerance", [] (Parameters& p) { p.angle_tolerance = 91_deg; }},
    {"merging angle", [] (Parameters& p) { p.merging.angle_threshold = 91_deg; }},
    {"merging noise", [] (Parameters& p) { p.merging.noise_factor = -1.0; }},
    {"up axis", [] (Parameters& p) { p.up_axis.setZero(); }},
    {"up axis", [] (Parameters& p) { p.up_axis.y() = std::nanf (""); }},
    {"up axis", [] (Parameters& p) { p.up_axis.y() = HUGE_VALF; }}};

struct Number {
  std::string words;
  std::function<double&(Parameters&)> of;
};

const std::vector<Number> numbers{
    {"sampling rate", [] (Parameters& p) -> double& { return p.sampling_rate; }},
    {"sigma", [] (Parameters& p) -> double& { return p.normals.sigma; }},
    {"probability", [] (Parameters& p) -> double& { return p.probability; }},
    {"distance threshold",
     [] (Parameters& p) -> double& { return p.distance_threshold; }},
    {"angle tolerance", [] (Parameters& p) -> double& { return p.angle_tolerance; }},
    {"merging angle",
     [] (Parameters& p) -> double& { return p.merging.angle_threshold; }},
    {"merging distance",
     [] (Parameters& p) -> double& { return p.merging.distance_threshold; }},
    {"merging noise",
     [] (Parameters& p) -> double& { return p.merging.noise_factor; }}};

} // namespace

TEST (ProblemOf, GoodParametersIsEmpty)
{
  EXPECT_EQ (problemOf (Parameters()), "");
  EXPECT_EQ (problemOf (Parameters::paper()), "");
}

TEST (ProblemOf, ParametersOutOfRangeNamesThem)
{
  for (const OutOfRange& parameter : out_of_range) {
    const std::string problem = problemAfter (parameter.change);
    EXPECT_NE (problem.find (parameter.words), std::string::npos)
        << "'" << problem << "' should speak of " << parameter.words;
  }
}

TEST (ProblemOf, NegativeInfiniteAndNanNumbersNamesThem)
{
  for (const Number& number : numbers)
    for (const double bad : {-1.0, HUGE_VAL, std::nan ("")}) {
      const std::string problem =
          problemAfter ([&] (Parameters& p) { number.of (p) = bad; });
      EXPECT_NE (problem.find (number.words), std::string::npos)
          << "'" << problem << "' should speak of " << number.words << " " << bad;
    }
}

TEST (ProblemOf, AnUpAxisOfAnyLengthIsEmpty)
{
  for (const float length : {1e-30f, 1e30f})
    EXPECT_EQ (problemAfter ([length] (Parameters& p) { p.up_axis *= length; }), "");
}
