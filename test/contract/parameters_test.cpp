// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/support/text.h"
#include "python/parameter_names.h"
#include "scene.h"

#include <iomanip>
#include <map>
#include <set>
#include <sstream>

namespace {

using namespace pcl_ops::python;
using OpsParameters = pcl_ops::OrientedPointSamplingParameters;
using FspfParameters = pcl_ops::FastSamplingPlaneFilteringParameters;
using KhtParameters = pcl_ops::KernelHoughTransformParameters;

/** \brief A row of parameters.tsv. */
struct Row {
  std::string name, value, value_in_paper;
  /** \brief A part of the message of validate about a wrong value. */
  std::string words;
  /** \brief Values that validate refuses, and values that it takes. */
  std::vector<double> wrong, right;
};

/** \brief Rows of parameters.tsv whose first column is one of \p owners. */
std::vector<Row>
rowsOf (const std::set<std::string>& owners)
{
  std::vector<Row> rows;
  for (std::vector<std::string> columns : tableIn (PCL_OPS_PARAMETERS)) {
    columns.resize (7);
    if (owners.count (columns[0]) > 0)
      rows.push_back ({columns[1],
                       columns[2],
                       columns[3],
                       columns[4],
                       numbersIn (columns[5]),
                       numbersIn (columns[6])});
  }
  return rows;
}

/** \brief Sets a parameter to a value. The value is the larger end of an interval (two
 * numbers), the tolerance of a size (three), or the length of a direction. */
template <typename T>
void
setTo (double value, T& member)
{
  if constexpr (std::is_assignable_v<T&, double>)
    member = static_cast<T> (value);
  else if constexpr (std::is_base_of_v<Eigen::MatrixBase<T>, T>)
    member *= value;
  else if constexpr (std::is_same_v<T, std::optional<Eigen::Vector3d>>)
    member = {0.0, 0.0, value};
  else if constexpr (std::is_same_v<T, std::optional<std::array<double, 2>>>)
    member = {0.1, value};
  else if constexpr (std::is_same_v<T, std::optional<std::array<double, 3>>>)
    member = {1.0, 2.0, value};
}

/** \brief The message of validate after one parameter is set to a value. */
template <typename Parameters>
std::string
problemWith (Parameters parameters, const std::string& changed, double value)
{
  visit_parameters (parameters, [&] (const std::string& name, auto& member) {
    if (name == changed)
      setTo (value, member);
  });
  return validate (parameters);
}

/** \brief Fails unless each parameter takes its right values and refuses its wrong
 * ones.
 * \param[in] good parameters that are valid */
template <typename Parameters>
void
expectRanges (const std::vector<Row>& rows, const Parameters& good)
{
  EXPECT_EQ (validate (good), "");
  for (const Row& row : rows) {
    SCOPED_TRACE (row.name);
    for (const double wrong : row.wrong) {
      const std::string problem = problemWith (good, row.name, wrong);
      EXPECT_TRUE (!problem.empty() && problem.find (row.words) != std::string::npos)
          << "'" << problem << "' should speak of " << row.words << " at " << wrong;
    }
    for (const double right : row.right)
      EXPECT_EQ (problemWith (good, row.name, right), "") << " at " << right;
  }
}

/** \brief Prints a value as parameters.tsv has it: an angle in degrees, an enumerator
 * as its word, an optional without a value as "none". */
template <typename T>
void
print (const std::string& name, const T& value, std::ostream& out)
{
  if constexpr (std::is_enum_v<T>)
    for (const auto& [word, meaning] : std::get<Words<T>> (words))
      out << (meaning == value ? word : "");
  else if constexpr (std::is_arithmetic_v<T>)
    out << (name.find ("angle") < name.size() ? value * 180.0 / pi : value);
  else if constexpr (std::is_same_v<T, Eigen::Vector3f>)
    out << value.transpose();
  else if (value)
    print (name, *value, out);
  else
    out << "none";
}

/** \brief The value of each parameter as text, by name. */
using Values = std::map<std::string, std::string>;

template <typename Parameters>
Values
valuesOf (Parameters parameters)
{
  Values values;
  visit_parameters (parameters, [&] (const std::string& name, const auto& value) {
    std::ostringstream text;
    text << std::setprecision (12);
    print (name, value, text);
    values[name] = text.str();
  });
  return values;
}

/** \brief Fails unless the table has each parameter of a detector, with its default and
 * its value in the paper, and validate takes the table's right values and no wrong one.
 * \param[in] name of the detector in the first column of the table */
template <typename Parameters>
void
expectDetector (const std::string& name)
{
  SCOPED_TRACE (name);
  const std::vector<Row> rows = rowsOf ({name, "all"});
  Values defaults, of_paper;
  for (const Row& row : rows)
    if (!row.value.empty()) {
      defaults[row.name] = row.value;
      of_paper[row.name] = row.value_in_paper.empty() ? row.value : row.value_in_paper;
    }
  EXPECT_EQ (valuesOf (Parameters()), defaults);
  EXPECT_EQ (valuesOf (Parameters::paper()), of_paper);
  for (const Parameters& good : {Parameters(), Parameters::paper()})
    expectRanges (rows, good);
}

} // namespace

TEST (Parameters, AreThoseOfTheTable)
{
  expectDetector<OpsParameters> ("ops");
  expectDetector<FspfParameters> ("fspf");
  expectDetector<KhtParameters> ("kht");
  pcl_ops::PlaneFilter filter;
  filter.min_area = filter.min_width = 1.0;
  expectRanges (rowsOf ({"filter"}), filter);
  expectRanges (rowsOf ({"matching"}), pcl_ops::PlaneMatchingParameters());
  expectRanges (rowsOf ({"edges"}), pcl_ops::PlaneEdgeParameters());
  expectRanges (rowsOf ({"up_axis"}), pcl_ops::UpAxisParameters());
  for (const Row& row : rowsOf ({"up_axis"}))
    EXPECT_EQ (valuesOf (pcl_ops::UpAxisParameters()).at (row.name), row.value);
}

TEST (Parameters, NeedADistanceThresholdButForSurfels)
{
  const auto problem = [] (auto parameters) {
    parameters.distance_threshold.reset();
    return validate (parameters);
  };
  const std::string message = "the distance threshold must be a length above 0";
  EXPECT_EQ (problem (OpsParameters()), "");
  EXPECT_EQ (problem (OpsParameters::paper()), message);
  EXPECT_EQ (problem (FspfParameters()), message);
  EXPECT_EQ (problem (KhtParameters()), message);
}

TEST (Parameters, RefuseANoiseOfTheWholeThatNoCloudHas)
{
  pcl_ops::CloudNoise right;
  right.points = 1000.0;
  right.growth = {1.5, 1.0};
  right.common_errors = 2.0;
  right.usual = 0.01;
  right.usual_of_octave = {{3, 0.02}};
  const auto is_refused = [] (const pcl_ops::CloudNoise& noise) {
    OpsParameters parameters;
    parameters.noise_of_whole = noise;
    return validate (parameters).find ("measureNoise") != std::string::npos;
  };
  EXPECT_FALSE (is_refused (right));
  EXPECT_TRUE (is_refused ({}));
  for (const double wrong :
       {-1.0, std::nan (""), std::numeric_limits<double>::infinity()}) {
    std::vector<pcl_ops::CloudNoise> noises (5, right);
    noises[0].points = wrong;
    noises[1].growth[0] = wrong;
    noises[2].common_errors = wrong;
    noises[3].usual = wrong;
    noises[4].usual_of_octave[3] = wrong;
    for (const pcl_ops::CloudNoise& noise : noises)
      EXPECT_TRUE (is_refused (noise)) << wrong;
  }
}

TEST (MeasureNoise, IsThatOfACloudAndOfNoneWithoutPoints)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  EXPECT_EQ (pcl_ops::measureNoise (cloud, {}).points, 0.0);
  // A floor of points 1 cm apart, whose heights are 0 or 2 mm in an irregular pattern.
  for (int i = 0; i < 100; ++i)
    for (int k = 0; k < 100; ++k)
      cloud.push_back ({0.01f * i, 0.01f * k, 2e-3f * ((3 * i + 5 * k) % 7 % 2)});
  constexpr std::size_t points_of_whole = 20'000;
  const pcl_ops::CloudNoise noise = pcl_ops::measureNoise (cloud, {}, points_of_whole);
  EXPECT_EQ (noise.points, points_of_whole);
  EXPECT_NEAR (noise.usual, 1e-3, 3e-4);
  OpsParameters wrong;
  wrong.k = 0;
  EXPECT_THROW (pcl_ops::measureNoise (cloud, wrong), std::invalid_argument);
}
