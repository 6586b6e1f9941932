// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_targets.h"

#include <boost/io/ios_state.hpp>

#include <Eigen/Geometry>

#include "apps/support/text.h"
#include "python/parameter_names.h"
#include "scene.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <detection/methods.h>
#include <io/cloud_file.h>
#include <io/las_file.h>
#include <io/output_file.h>
#include <io/shifted_cloud.h>

#include <cmath>
#include <cstring>
#include <deque>
#include <iostream>
#include <limits>
#include <new>
#include <numeric>
#include <set>
#include <sstream>

namespace pcl_ops::fuzz {

namespace {

// So few that an input takes milliseconds. A cloud gets shapes until it has max_points.
constexpr std::size_t max_points = 1200;
constexpr std::size_t max_points_of_a_shape = 400;

using Planes = std::vector<PlaneSegment>;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** \brief Reads numbers from bytes one after the other, and zeros after the last byte,
 * so that any bytes are a valid input. */
class ByteReader {
public:
  explicit ByteReader (const Bytes& bytes) : bytes_ (bytes) {}

  bool
  isAtEnd () const
  {
    return next_ >= bytes_.size();
  }

  template <typename Number>
  Number
  take ()
  {
    std::uint8_t raw[sizeof (Number)] = {};
    for (std::uint8_t& byte : raw)
      byte = isAtEnd() ? std::uint8_t (0) : bytes_[next_++];
    Number number;
    std::memcpy (&number, raw, sizeof (Number));
    return number;
  }

  /** \brief 0 .. bound - 1 */
  std::size_t
  below (std::size_t bound)
  {
    return take<std::uint16_t>() % bound;
  }

private:
  const Bytes& bytes_;
  std::size_t next_ = 0;
};

/** \brief The values that \ref vary may give a numeric parameter, by its name. */
const std::map<std::string, std::vector<double>>&
otherValues ()
{
  static const auto values = [] {
    // Columns of parameters.tsv, from 0. The last columns of a row may be missing.
    constexpr std::size_t name_column = 1;
    constexpr std::size_t values_column = 7;
    std::map<std::string, std::vector<double>> values_of_name;
    for (std::vector<std::string> row : tableIn (PCL_OPS_PARAMETERS)) {
      row.resize (values_column + 1);
      if (!row[values_column].empty())
        values_of_name[row[name_column]] = numbersIn (row[values_column]);
    }
    return values_of_name;
  }();
  return values;
}

/** Sets parameters by one byte each. A byte below 128 keeps the value of a parameter;
 * 128 and above chooses a word, a flag, or one of \ref otherValues (for a direction,
 * its x). Three parameters take no byte and stay as they are. */
template <typename Parameters>
void
vary (ByteReader& bytes, Parameters& parameters)
{
  python::visit_parameters (parameters, [&] (const std::string& name, auto& value) {
    using Value = std::decay_t<decltype (value)>;
    // Inputs of the corpus have no bytes for these: such bytes would shift all others.
    if (name == "threads" || name == "sampling" || name == "min_points")
      return;
    const auto chosen = bytes.take<std::uint8_t>();
    if (chosen < 128)
      return;
    const auto chosenOf = [&] (const auto& all) { return all[chosen % all.size()]; };
    if constexpr (std::is_enum_v<Value>)
      value = chosenOf (std::get<python::Words<Value>> (python::words)).second;
    else if constexpr (std::is_same_v<Value, bool>)
      value = chosen % 2 == 1;
    else if constexpr (std::is_same_v<Value, Eigen::Vector3f>)
      value.x() = chosenOf (otherValues().at (name));
    else
      value = static_cast<Value> (chosenOf (otherValues().at (name)));
  });
}

/** Some points of a kind: their number, position, size and rotation, and a generator
 * with a seed of its own for all else. */
struct Shape {
  enum Kind {
    Plane,
    NoisyPlane,
    Line,
    Ball,
    Dust,
    EqualPoints,
    Lattice,
    AnyBits,
    FarPoint,
    NotFinite,
    LogUniform,
    PointsAgain,
    kinds
  };

  explicit Shape (ByteReader& bytes)
  : kind (static_cast<Kind> (bytes.below (kinds)))
  , count (1 + bytes.below (max_points_of_a_shape))
  , generator (bytes.take<std::uint16_t>())
  {
    for (int axis = 0; axis < 3; ++axis)
      center[axis] = 0.05 * bytes.take<std::int8_t>();
    size = 0.02 * (1 + bytes.take<std::uint8_t>());
    const double tilt = bytes.take<std::uint8_t>() * pi / 128.0;
    const double turn = bytes.take<std::uint8_t>() * pi / 128.0;
    frame = Eigen::AngleAxisd (turn, Eigen::Vector3d::UnitZ()) *
            Eigen::AngleAxisd (tilt, Eigen::Vector3d::UnitX());
  }

  /** Draws a number from -size to size. */
  double
  draw ()
  {
    return size * (2.0 * drawUnit (generator) - 1.0);
  }

  Eigen::Vector3d
  pointInItsFrame (std::size_t i)
  {
    switch (kind) {
    case Plane:
      return {draw(), draw(), 0.0};
    case NoisyPlane:
      return {draw(), draw(), 0.01 * draw()};
    case Line:
      return {draw(), 0.0, 0.0};
    case Ball:
      return size * Eigen::Vector3d (draw(), draw(), draw()).normalized();
    case Dust:
      return {draw(), draw(), draw()};
    case Lattice:
      return 0.1 * size * Eigen::Vector3d (i % 10, i / 10 % 10, i / 100);
    case LogUniform:
      return std::pow (10.0, 6.0 * draw()) * Eigen::Vector3d (draw(), draw(), draw());
    default:
      return Eigen::Vector3d::Zero();
    }
  }

  Kind kind;
  std::size_t count;
  RandomGenerator generator;
  Eigen::Vector3d center;   // [m]
  double size;              // half the edge of most shapes, 0.02 to 5.12 [m]
  Eigen::Quaterniond frame; // rotation from the frame of the shape
};

void
addShape (ByteReader& bytes, Cloud& cloud)
{
  Shape shape (bytes);
  if (shape.kind == Shape::FarPoint)
    // Up to 6.4 * 10^38 for the largest size, 5.12 m: above the largest number of
    // single precision, 3.4 * 10^38.
    cloud.push_back (
        toPoint (std::pow (10.0, 38.0 * shape.size / 5.12) * shape.center));
  else if (shape.kind == Shape::NotFinite)
    cloud.push_back ({std::numeric_limits<float>::quiet_NaN(),
                      std::numeric_limits<float>::infinity(),
                      static_cast<float> (shape.size)});
  else if (shape.kind == Shape::AnyBits)
    for (std::size_t i = 0; i < shape.count && !bytes.isAtEnd(); ++i) {
      const float x = bytes.take<float>(), y = bytes.take<float>();
      cloud.push_back ({x, y, bytes.take<float>()});
    }
  else if (shape.kind == Shape::PointsAgain)
    for (std::size_t i = 0, size = cloud.size(); i < std::min (size, shape.count); ++i)
      cloud.push_back (cloud[i]);
  else
    for (std::size_t i = 0; i < shape.count; ++i)
      cloud.push_back (
          toPoint (shape.center + shape.frame * shape.pointInItsFrame (i)));
}

/** Returns no indices for kinds 0 to 11; else those of every third point (12), of all
 * points (13), as many drawn at random (14), or those of 14 and one more that may be
 * out of range (15). */
pcl::IndicesPtr
indicesFrom (ByteReader& bytes, std::size_t points)
{
  const std::size_t kind = bytes.below (16);
  RandomGenerator generator (bytes.take<std::uint16_t>());
  if (kind < 12)
    return nullptr;
  auto indices = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < points; ++i)
    if (kind != 12 || i % 3 == 0)
      indices->push_back (kind < 14 ? i : drawBelow (generator, points));
  if (kind == 15)
    indices->push_back (generator());
  return indices;
}

/** \brief Makes a cloud of shapes from bytes, then scales and shifts it. If bytes were
 * the points themselves, hardly any points would lie on a plane.
 * \return the cloud, and indices into it, which may be null; they may be out of range,
 * repeated and unsorted */
std::pair<Cloud::Ptr, pcl::IndicesPtr>
cloudFrom (ByteReader& bytes)
{
  // Two of three clouds are not scaled, the others by 10^-45 to 10^42. Three of four
  // are not shifted, the others by 1 to 10^11 m.
  const auto scale_byte = bytes.take<std::uint8_t>();
  const double scale = scale_byte < 168 ? 1.0 : std::pow (10.0, scale_byte - 168 - 45);
  const double shift = bytes.take<std::uint8_t>() < 192
                           ? 0.0
                           : std::pow (10.0, bytes.take<std::uint8_t>() % 12);
  // The four bytes of the indices come before those of the shapes, which take all the
  // rest. They are read at the end, as indices depend on the number of points.
  ByteReader bytes_of_indices = bytes;
  bytes.take<std::uint32_t>();
  const auto cloud = pcl::make_shared<Cloud>();
  while (!bytes.isAtEnd() && cloud->size() < max_points)
    addShape (bytes, *cloud);
  for (pcl::PointXYZ& point : *cloud)
    point.getVector3fMap() =
        (scale * point.getVector3fMap().cast<double>().array() + shift)
            .matrix()
            .cast<float>();
  return {cloud, indicesFrom (bytes_of_indices, cloud->size())};
}

/** Checks that planes have points, unit normals and finite centroids, and come in
 * descending order of size. Inliers must be ascending indices of finite points. No two
 * planes may share a point. */
void
promiseOrderedPlanes (const Planes& planes, const Cloud& cloud)
{
  std::vector<bool> is_taken (cloud.size(), false);
  std::size_t previous_size = cloud.size();
  for (const PlaneSegment& plane : planes) {
    promise (std::abs (plane.normal.norm() - 1.0) < 1e-6, "normals have length 1");
    promise (plane.centroid.allFinite(), "centroids are finite");
    promise (!plane.inliers.empty(), "a plane has points");
    promise (plane.inliers.size() <= previous_size, "planes come by falling size");
    previous_size = plane.inliers.size();
    pcl::index_t previous_index = -1;
    for (const pcl::index_t index : plane.inliers) {
      promise (index > previous_index, "the indices of a plane ascend");
      previous_index = index;
      promise (static_cast<std::size_t> (index) < cloud.size(),
               "the indices of a plane are in the cloud");
      promise (!is_taken[index], "planes share no point");
      is_taken[index] = true;
      promise (cloud[index].getVector3fMap().allFinite(),
               "the points of a plane are finite");
    }
  }
}

/** Checks that two calls found the same planes. */
void
promiseEqual (const Planes& one, const Planes& other)
{
  promise (one.size() == other.size(), "a second call finds as many planes");
  for (std::size_t p = 0; p < one.size(); ++p) {
    promise (one[p].inliers == other[p].inliers, "a second call finds the same points");
    promise (one[p].normal == other[p].normal && one[p].centroid == other[p].centroid,
             "a second call finds the same planes");
  }
}

/** Checks that only given points are on planes. */
void
promiseGivenPoints (const Planes& planes, const pcl::Indices& given)
{
  const std::set<pcl::index_t> allowed (given.begin(), given.end());
  for (const PlaneSegment& plane : planes)
    for (const pcl::index_t index : plane.inliers)
      promise (allowed.count (index) == 1, "only points it was given are on planes");
}

/** \brief Varies parameters, makes a cloud, and checks the planes that one thread
 * finds. Three threads must find the same. */
template <typename Detector>
void
detect (const Bytes& bytes, typename Detector::Parameters parameters)
{
  ByteReader reader (bytes);
  vary (reader, parameters);
  const auto [cloud, indices] = cloudFrom (reader);
  Detector detector;
  detector.setInputCloud (cloud);
  if (indices)
    detector.setIndices (indices);
  parameters.threads = 1;
  detector.setParameters (parameters);
  Planes planes, again;
  const bool worked = detector.segment (planes);
  promise (worked || planes.empty(), "a call that fails gives no planes");
  promise (!worked || validate (parameters).empty(), "wrong parameters are refused");
  promiseOrderedPlanes (planes, *cloud);
  if (indices)
    promiseGivenPoints (planes, *indices);
  detector.setNumberOfThreads (3);
  promise (detector.segment (again) == worked, "a second call does as the first");
  promiseEqual (planes, again);
}

/** \brief Returns the temporary file for all inputs with an extension. It is made once
 * and filled anew for each input, as making a file takes longer than reading it. */
const apps::TemporaryFile&
fileOfInputs (const std::string& extension)
{
  static std::map<std::string, apps::TemporaryFile> files;
  return files.try_emplace (extension, extension, "fuzz").first->second;
}

/** \brief Loads bytes as a file with an extension. Calls use (cloud) if they are a
 * valid file of a cloud. */
template <typename Use>
void
load (const Bytes& bytes, const std::string& extension, Use&& use)
{
  const apps::TemporaryFile& file = fileOfInputs (extension);
  file.fill ([&bytes] (std::ostream& stream) {
    stream.write (reinterpret_cast<const char*> (bytes.data()), bytes.size());
  });
  try {
    const apps::FileCloud cloud = apps::loadCloud (file.name());
    promise (cloud.size() > 0, "a cloud that was loaded has points");
    promise (cloud.points.data.size() == cloud.size() * cloud.points.point_step,
             "a cloud has as many bytes as its size says");
    promise (apps::shiftedCloudOf (cloud).cloud->size() == cloud.size(),
             "every point has coordinates");
    use (cloud);
  }
  catch (const apps::ProgramError& error) {
    promise (std::string (error.what()).find ('\n') == std::string::npos,
             "an error is one line");
  }
  catch (const std::bad_alloc&) {
    // A program reports missing memory in one line.
  }
}

/** \brief Checks that a cloud that is saved as .pcd and loaded has the same data. */
void
promiseSaved (const apps::FileCloud& cloud)
{
  // Not passed as a literal: newer compilers would warn that the reference from
  // fileOfInputs dangles once the temporary string is gone.
  const std::string extension = ".pcd";
  const apps::TemporaryFile& copy = fileOfInputs (extension);
  apps::saveCloud (copy.name(), cloud);
  promise (apps::loadCloud (copy.name()).points.data == cloud.points.data,
           "a saved cloud is loaded with the same data");
}

void
loadText (const Bytes& bytes)
{
  load (bytes, ".xyz", [] (const apps::FileCloud& cloud) {
    for (const pcl::PCLPointField& field : cloud.points.fields)
      promise (field.datatype == pcl::PCLPointField::FLOAT64,
               "a column keeps the digits it has");
    promiseSaved (cloud);
  });
}

void
loadPtx (const Bytes& bytes)
{
  load (bytes, ".ptx", [] (const apps::FileCloud& cloud) {
    for (const apps::Scan& scan : cloud.scans)
      promise (scan.first <= cloud.size() && scan.position.allFinite(),
               "a scan has a place and begins within the cloud");
    promiseSaved (cloud);
  });
}

void
loadLas (const Bytes& bytes)
{
  load (bytes, ".las", [] (const apps::FileCloud& cloud) {
    if (!cloud.las->validate ({apps::label_field}).empty())
      return;
    std::vector<std::uint32_t> labels (cloud.size());
    std::iota (labels.begin(), labels.end(), 1U);
    const apps::TemporaryFile file (".las", "fuzz");
    apps::saveLabeledLas (file.name(), *cloud.las, labels);
    const apps::FileCloud labeled = apps::loadCloud (file.name());
    apps::FileCloud expected = cloud;
    apps::setField (expected, "label", pcl::PCLPointField::UINT32, labels.data());
    promise (labeled.points.data == expected.points.data,
             "labels and points are read as they were written");
  });
}

/** Reads each line of the bytes as one command line argument, and detects planes with
 * these options in a floor and a wall that meet. */
void
detectWithOptions (const Bytes& bytes)
{
  std::istringstream text (std::string (bytes.begin(), bytes.end()));
  std::deque<std::string> arguments;
  std::vector<const char*> argv{"pcl_ops_segment"};
  for (std::string argument; std::getline (text, argument);)
    argv.push_back (arguments.emplace_back (argument).c_str());
  apps::CommandLine line ("pcl_ops_segment", "Finds planes", "0");
  std::string method = apps::allMethods().front().name;
  apps::DetectorOptions options;
  apps::declareMethodOptions (line, method, options);
  if (!line.parse (argv.size(), argv.data()))
    return;
  const apps::Method& chosen = apps::methodCalled (method);
  apps::checkMethodOptions (line, chosen);
  static const apps::XyzCloud::ConstPtr corner = Scene (1)
                                                     .floor (1_m, 1_m)
                                                     .wall ({0, 0}, {1, 0}, 1_m)
                                                     .spacing (5_cm)
                                                     .build()
                                                     .cloud;
  const apps::Detected found = chosen.detect (options, corner);
  promise (apps::labelsOf (found.planes, corner->size()).size() == corner->size(),
           "every point has a label");
}

void
readOptions (const Bytes& bytes)
{
  // Discards the output of --help.
  const std::ostringstream nothing;
  const boost::io::ios_rdbuf_saver saver (std::cout, nothing.rdbuf());
  try {
    detectWithOptions (bytes);
  }
  catch (const apps::ProgramError& error) {
    promise (*error.what() != '\0', "an error says what is wrong");
  }
}

} // namespace

const Targets&
allTargets ()
{
  using Ops = OrientedPointSampling<pcl::PointXYZ>;
  using Fspf = FastSamplingPlaneFiltering<pcl::PointXYZ>;
  using Kht = KernelHoughTransform<pcl::PointXYZ>;
  static const Targets targets = {
      {"pcd", [] (const Bytes& bytes) { load (bytes, ".pcd", [] (auto&) {}); }},
      {"ply", [] (const Bytes& bytes) { load (bytes, ".ply", [] (auto&) {}); }},
      {"las", loadLas},
      {"ascii", loadText},
      {"ptx", loadPtx},
      {"kitti", [] (const Bytes& bytes) { load (bytes, ".bin", promiseSaved); }},
      {"npy", [] (const Bytes& bytes) { load (bytes, ".npy", promiseSaved); }},
      {"off", [] (const Bytes& bytes) { load (bytes, ".off", promiseSaved); }},
      {"obj", [] (const Bytes& bytes) { load (bytes, ".obj", promiseSaved); }},
      {"options", readOptions},
      {"ops", [] (const Bytes& bytes) { detect<Ops> (bytes, {}); }},
      // The corpus keeps an earlier name of this sampling.
      {"ops_leaves",
       [] (const Bytes& bytes) {
         Ops::Parameters parameters;
         parameters.sampling = Sampling::Neighborhoods;
         detect<Ops> (bytes, parameters);
       }},
      {"ops_paper",
       [] (const Bytes& bytes) { detect<Ops> (bytes, Ops::Parameters::paper()); }},
      {"fspf", [] (const Bytes& bytes) { detect<Fspf> (bytes, {}); }},
      {"kht", [] (const Bytes& bytes) { detect<Kht> (bytes, {}); }},
      {"kht_paper",
       [] (const Bytes& bytes) { detect<Kht> (bytes, Kht::Parameters::paper()); }}};
  return targets;
}

} // namespace pcl_ops::fuzz
