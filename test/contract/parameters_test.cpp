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
  /** \brief Name, default, and value in the paper; an empty value in the paper is the
   * default. */
  std::string name, default_value, value_in_paper;
  /** \brief A part of the message of validate about a refused value. */
  std::string part_of_message;
  /** \brief Values that validate refuses, and values that it takes. */
  std::vector<double> refused, taken;
};

/** \brief Rows of parameters.tsv whose first column is one of \p owners. */
std::vector<Row>
rowsOf (const std::set<std::string>& owners)
{
  std::vector<Row> rows;
  for (std::vector<std::string> columns : tableIn (PCL_OPS_PARAMETERS)) {
    columns.resize (7); // the last one, 8, is for the fuzz targets
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

/** \brief Sets a parameter to a number. The number is the larger end of an interval (an
 * array of two), the tolerance of a size (an array of three), or the length of a
 * direction. */
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

/** \brief The message of validate after the parameter with the name \p changed is set
 * to a value; empty if it takes the value. */
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

/** \brief Fails unless validate takes and refuses the values of each row.
 * \param[in] valid parameters, of which one at a time is changed */
template <typename Parameters>
void
expectTakenAndRefused (const std::vector<Row>& rows, const Parameters& valid)
{
  EXPECT_FALSE (rows.empty());
  EXPECT_EQ (validate (valid), "");
  for (const Row& row : rows) {
    SCOPED_TRACE (row.name);
    for (const double refused : row.refused) {
      const std::string problem = problemWith (valid, row.name, refused);
      const bool has_part = problem.find (row.part_of_message) != std::string::npos;
      EXPECT_TRUE (!problem.empty() && has_part)
          << "'" << problem << "' should speak of " << row.part_of_message << " at "
          << refused;
    }
    for (const double taken : row.taken)
      EXPECT_EQ (problemWith (valid, row.name, taken), "") << " at " << taken;
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
using ValueOfName = std::map<std::string, std::string>;

template <typename Parameters>
ValueOfName
valuesOf (Parameters parameters)
{
  ValueOfName values;
  visit_parameters (parameters, [&] (const std::string& name, const auto& value) {
    std::ostringstream text;
    text << std::setprecision (12);
    print (name, value, text);
    values[name] = text.str();
  });
  return values;
}

/** \brief Fails unless the table has each parameter of a detector, with its default and
 * its value in the paper, and validate takes and refuses the values that the table
 * says.
 * \param[in] detector its name in the first column of the table */
template <typename Parameters>
void
expectParametersOfTable (const std::string& detector)
{
  SCOPED_TRACE (detector);
  const std::vector<Row> rows = rowsOf ({detector, "all"});
  ValueOfName defaults, of_paper;
  for (const Row& row : rows)
    if (!row.default_value.empty()) {
      defaults[row.name] = row.default_value;
      of_paper[row.name] =
          row.value_in_paper.empty() ? row.default_value : row.value_in_paper;
    }
  EXPECT_EQ (valuesOf (Parameters()), defaults);
  EXPECT_EQ (valuesOf (Parameters::paper()), of_paper);
  for (const Parameters& valid : {Parameters(), Parameters::paper()})
    expectTakenAndRefused (rows, valid);
}

} // namespace

TEST (Parameters, AreThoseOfTheTable)
{
  expectParametersOfTable<OpsParameters> ("ops");
  expectParametersOfTable<FspfParameters> ("fspf");
  expectParametersOfTable<KhtParameters> ("kht");
  pcl_ops::PlaneFilter filter;
  filter.min_area = filter.min_width = 1.0; // the largest must not be below them
  expectTakenAndRefused (rowsOf ({"filter"}), filter);
  expectTakenAndRefused (rowsOf ({"matching"}), pcl_ops::PlaneMatchingParameters());
  expectTakenAndRefused (rowsOf ({"edges"}), pcl_ops::PlaneEdgeParameters());
  expectTakenAndRefused (rowsOf ({"up_axis"}), pcl_ops::UpAxisParameters());
  for (const Row& row : rowsOf ({"up_axis"}))
    EXPECT_EQ (valuesOf (pcl_ops::UpAxisParameters()).at (row.name), row.default_value);
}

TEST (Parameters, NeedADistanceThresholdButForTheDefaultOfOps)
{
  const auto problemWithoutThreshold = [] (auto parameters) {
    parameters.distance_threshold.reset();
    return validate (parameters);
  };
  const std::string message = "the distance threshold must be a length above 0";
  EXPECT_EQ (problemWithoutThreshold (OpsParameters()), "");
  EXPECT_EQ (problemWithoutThreshold (OpsParameters::paper()), message);
  EXPECT_EQ (problemWithoutThreshold (FspfParameters()), message);
  EXPECT_EQ (problemWithoutThreshold (KhtParameters()), message);
}

TEST (Parameters,
      RefuseANoiseOfTheWholeCloudWithNoPointsOrANumberThatIsNegativeOrNotFinite)
{
  pcl_ops::CloudNoise valid;
  valid.points = 1000.0;
  valid.growth = {1.5, 1.0};
  valid.common_errors = 2.0;
  valid.usual = 0.01;
  valid.usual_of_octave = {{3, 0.02}};
  const auto is_refused = [] (const pcl_ops::CloudNoise& noise) {
    OpsParameters parameters;
    parameters.noise_of_whole = noise;
    return validate (parameters).find ("measureNoise") != std::string::npos;
  };
  EXPECT_FALSE (is_refused (valid));
  EXPECT_TRUE (is_refused ({}));
  for (const double wrong :
       {-1.0, std::nan (""), std::numeric_limits<double>::infinity()}) {
    std::vector<pcl_ops::CloudNoise> noises (5, valid);
    noises[0].points = wrong;
    noises[1].growth[0] = wrong;
    noises[2].common_errors = wrong;
    noises[3].usual = wrong;
    noises[4].usual_of_octave[3] = wrong;
    for (const pcl_ops::CloudNoise& noise : noises)
      EXPECT_TRUE (is_refused (noise)) << wrong;
  }
}

TEST (MeasureNoise, GivesTheNoiseOfACloudAndRefusesWrongParameters)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  EXPECT_EQ (pcl_ops::measureNoise (cloud, {}).points, 0.0) << "without points";
  // A floor of points 1 cm apart, whose heights are 0 or 2 mm in an irregular pattern:
  // their standard deviation is 1 mm.
  for (int i = 0; i < 100; ++i)
    for (int k = 0; k < 100; ++k)
      cloud.push_back ({0.01f * i, 0.01f * k, 2e-3f * ((3 * i + 5 * k) % 7 % 2)});
  constexpr std::size_t points_of_whole = 20'000;
  const pcl_ops::CloudNoise noise = pcl_ops::measureNoise (cloud, {}, points_of_whole);
  EXPECT_EQ (noise.points, points_of_whole);
  EXPECT_NEAR (noise.usual, 1_mm, 3e-4);
  pcl::PointCloud<pcl::PointXYZ> half_of_nan = cloud;
  half_of_nan.resize (2 * cloud.size(), {NAN, NAN, NAN});
  EXPECT_EQ (pcl_ops::measureNoise (half_of_nan, {}, 2 * points_of_whole).points,
             points_of_whole);
  OpsParameters wrong;
  wrong.k = 0;
  EXPECT_THROW (pcl_ops::measureNoise (cloud, wrong), std::invalid_argument);
}
