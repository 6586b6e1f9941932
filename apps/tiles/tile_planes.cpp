// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tile_planes.h"

#include <cli/errors.h>
#include <io/output_file.h>
#include <pcl_ops/detect_planes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

namespace pcl_ops::apps {

namespace {

/** \brief Calls visit (numbers, how many) for all of a piece but its lists, in the
 * order of the file. */
template <typename SomePiece, typename Visit>
void
visitNumbers (SomePiece& piece, Visit&& visit)
{
  visit (&piece.own, 1);
  visit (piece.all.origin.data(), 3);
  visit (&piece.all.count, 1);
  visit (piece.all.sum.data(), 3);
  visit (piece.all.products.data(), piece.all.products.size());
  visit (piece.normal.data(), 3);
}

Eigen::Vector3d
pointOf (const TilePoints& points, std::size_t i)
{
  return Eigen::Vector3f (points.coordinates.data() + 3 * i).cast<double>();
}

std::vector<PlaneSegment>
detectIn (const TileGrid& grid, const TilePoints& points)
{
  OrientedPointSamplingParameters parameters;
  parameters.surfels.voxel_size = grid.cell();
  CloudView view;
  view.first = points.coordinates.data();
  view.stride = 3;
  view.size = points.size();
  if (view.size > std::size_t (std::numeric_limits<pcl::index_t>::max()))
    throw std::bad_alloc();
  return detectPlanes (view, parameters);
}

/** \brief A plane that was found in a tile and its halo. */
struct SeenPlane {
  const TilePoints& points;
  const PlaneSegment& plane;
  /** \brief How many of the inliers, the first, are the tile's own. */
  std::size_t own;
  /** \brief Zero of the tile's frame. */
  Eigen::Vector3d corner;
  double cell;

  Eigen::Vector3d
  place (pcl::index_t index) const
  {
    return corner + pointOf (points, static_cast<std::size_t> (index));
  }
};

/** \brief The tile's share of the outline. */
std::vector<OutlineEdge>
edgesOf (const SeenPlane& seen)
{
  const double unit = outlineUnit (seen.cell);
  std::vector<OutlinePoint> places;
  places.reserve (seen.plane.inliers.size());
  for (const pcl::index_t index : seen.plane.inliers) {
    const Eigen::Vector3d place = seen.place (index) / unit;
    places.push_back (
        {{std::llround (place.x()), std::llround (place.y()), std::llround (place.z())},
         places.size() < seen.own});
  }
  return outlineEdges (places, seen.plane.normal, seen.cell / unit);
}

/** \brief The inputs that own points are from. */
std::vector<std::uint32_t>
inputsOf (const SeenPlane& seen)
{
  std::vector<std::uint32_t> inputs;
  const auto begin = seen.plane.inliers.begin();
  const auto end = begin + static_cast<std::ptrdiff_t> (seen.own);
  std::uint64_t next = 0;
  for (const auto& [input, count] : seen.points.own_of_input) {
    const auto first = std::lower_bound (begin, end, static_cast<pcl::index_t> (next));
    next += count;
    if (first != end && static_cast<std::uint64_t> (*first) < next)
      inputs.push_back (input);
  }
  return inputs;
}

Piece
pieceOf (const SeenPlane& seen)
{
  Piece piece{
      {}, seen.plane.moments, seen.plane.normal, edgesOf (seen), inputsOf (seen)};
  piece.all.origin += seen.corner;
  piece.own.unit = latticeFor (seen.cell);
  for (std::size_t i = 0; i < seen.own; ++i)
    piece.own.add (seen.place (seen.plane.inliers[i]));
  return piece;
}

/** \brief Adds the cells of a plane that other tiles look at, too. */
void
addClaims (const TileGrid& grid,
           const SeenPlane& seen,
           std::uint32_t piece,
           std::vector<Claim>& claims)
{
  const TilePoints& points = seen.points;
  const CellKey frame = grid.frameOf (points.tile);
  const auto first = static_cast<std::ptrdiff_t> (claims.size());
  for (const pcl::index_t index : seen.plane.inliers) {
    CellKey cell = grid.cellOf (pointOf (points, static_cast<std::size_t> (index)));
    Claim claim{{}, piece};
    for (std::size_t axis = 0; axis < 3; ++axis)
      claim.cell[axis] = static_cast<std::int32_t> (cell[axis] += frame[axis]);
    if (!grid.isInside (points.tile, cell))
      claims.push_back (claim);
  }
  std::sort (claims.begin() + first, claims.end());
  claims.erase (std::unique (claims.begin() + first, claims.end()), claims.end());
}

std::vector<LabelsOfInput>
splitByInput (const TilePoints& points, const std::vector<std::uint32_t>& labels)
{
  std::vector<LabelsOfInput> split;
  auto first = labels.begin();
  for (const auto& [input, count] : points.own_of_input) {
    const auto last = first + static_cast<std::ptrdiff_t> (count);
    split.push_back ({input, std::vector<std::uint32_t> (first, last)});
    first = last;
  }
  return split;
}

} // namespace

void
saveTilePlanes (const std::string& file, const TilePlanes& planes)
{
  writeFile (file, [&] (std::ostream& stream) {
    put (stream, std::uint64_t (planes.pieces.size()));
    for (const Piece& piece : planes.pieces) {
      visitNumbers (piece, [&] (const auto* numbers, std::size_t count) {
        putBytes (stream, numbers, count);
      });
      putAll (stream, piece.edges);
      putAll (stream, piece.inputs);
    }
    putAll (stream, planes.claims);
  });
}

TilePlanes
loadTilePlanes (const std::string& file)
{
  std::ifstream stream = openBinary (file);
  TilePlanes planes;
  planes.pieces.resize (getCount (stream, sizeof (ExactMoments)));
  for (Piece& piece : planes.pieces) {
    visitNumbers (piece, [&] (auto* numbers, std::size_t count) {
      getBytes (stream, numbers, count);
    });
    piece.edges = getAll<OutlineEdge> (stream);
    piece.inputs = getAll<std::uint32_t> (stream);
  }
  planes.claims = getAll<Claim> (stream);
  checkWasRead (stream, file);
  return planes;
}

void
saveTileLabels (const std::string& file, const std::vector<LabelsOfInput>& labels)
{
  writeFile (file, [&] (std::ostream& stream) {
    put (stream, std::uint64_t (labels.size()));
    for (const LabelsOfInput& some : labels) {
      put (stream, std::uint64_t (some.input));
      put (stream, std::uint64_t (some.labels.size()));
    }
    for (const LabelsOfInput& some : labels)
      putBytes (stream, some.labels.data(), some.labels.size());
  });
}

LabelReader::LabelReader (const std::string& file, std::uint32_t input) : file_ (file)
{
  std::ifstream stream = openBinary (file_);
  const auto inputs = get<std::uint64_t> (stream);
  place_ = (1 + 2 * inputs) * sizeof (std::uint64_t);
  for (std::uint64_t i = 0; i < inputs && stream; ++i) {
    const auto number = get<std::uint64_t> (stream),
               count = get<std::uint64_t> (stream);
    if (number == input)
      left_ = count;
    if (number < input)
      place_ += count * sizeof (std::uint32_t);
  }
  checkWasRead (stream, file_);
}

std::uint32_t
LabelReader::next()
{
  if (used_ == some_.size())
    refill();
  return some_[used_++];
}

void
LabelReader::refill()
{
  constexpr std::uint64_t most = 4096;
  if (left_ == 0)
    throw WorkError (file_, "has too few labels; remove its folder and run it again");
  some_.resize (std::min (most, left_));
  used_ = 0;
  std::ifstream stream = openBinary (file_);
  stream.seekg (static_cast<std::streamoff> (place_));
  getBytes (stream, some_.data(), some_.size());
  checkWasRead (stream, file_);
  place_ += some_.size() * sizeof (std::uint32_t);
  left_ -= some_.size();
}

std::size_t
TilePoints::own() const
{
  std::size_t sum = 0;
  for (const auto& [input, count] : own_of_input)
    sum += count;
  return sum;
}

TileDetection
detectInTile (const TileGrid& grid, const TilePoints& points)
{
  const Eigen::Vector3d corner = grid.cornerOf (grid.frameOf (points.tile));
  const auto own_end = static_cast<pcl::index_t> (points.own());
  TileDetection found;
  std::vector<std::uint32_t> labels (points.own(), 0);
  for (const PlaneSegment& plane : detectIn (grid, points)) {
    const auto end =
        std::lower_bound (plane.inliers.begin(), plane.inliers.end(), own_end);
    const auto own = static_cast<std::size_t> (end - plane.inliers.begin());
    if (own == 0)
      continue;
    const SeenPlane seen{points, plane, own, corner, grid.cell()};
    addClaims (grid,
               seen,
               static_cast<std::uint32_t> (found.planes.pieces.size()),
               found.planes.claims);
    found.planes.pieces.push_back (pieceOf (seen));
    for (std::size_t i = 0; i < own; ++i)
      labels[static_cast<std::size_t> (plane.inliers[i])] =
          static_cast<std::uint32_t> (found.planes.pieces.size());
  }
  std::sort (found.planes.claims.begin(), found.planes.claims.end());
  found.labels = splitByInput (points, labels);
  return found;
}

} // namespace pcl_ops::apps
