// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tile_planes.h"

#include "run_files.h"
#include <io/output_file.h>
#include <pcl_ops/detect_planes.h>

#include <limits>
#include <new>

namespace pcl_ops::apps {

namespace {

template <typename File, typename SomePiece>
void
transfer (File& file, SomePiece& piece)
{
  file (&piece.own.unit, 1);
  file (piece.own.sums.data(), piece.own.sums.size());
  file (piece.all.origin.data(), 3);
  file (&piece.all.count, 1);
  file (piece.all.sum.data(), 3);
  file (piece.all.products.data(), piece.all.products.size());
  file (piece.normal.data(), 3);
  file (piece.edges);
  file (piece.inputs);
}

std::vector<PlaneSegment>
detectIn (const Plan& plan,
          const std::optional<CloudNoise>& noise,
          const TilePoints& points)
{
  OrientedPointSamplingParameters parameters;
  // Noise of zero points means that there were too few to measure it.
  if (noise && noise->points > 0.0)
    parameters.noise_of_whole = noise;
  if (plan.is_on_voxels)
    parameters.surfels.voxel_size = plan.grid.edge;
  const std::vector<Eigen::Vector3f>& all = points.points;
  if (all.size() > std::size_t (std::numeric_limits<pcl::index_t>::max()))
    throw std::bad_alloc();
  return detectPlanes ({all.data(), 0, sizeof (all[0]), all.size()}, parameters);
}

/** \brief The inputs of a plane's own points, which are its first inliers. */
std::vector<std::uint32_t>
inputsOf (const PlaneSegment& plane, const TilePoints& points)
{
  std::vector<std::uint32_t> inputs;
  std::uint64_t next = 0;
  auto first = plane.inliers.begin();
  for (const auto& [input, count] : points.own_of_input) {
    next += count;
    const auto end = std::lower_bound (first, plane.inliers.end(), pcl::index_t (next));
    if (first != end)
      inputs.push_back (input);
    first = end;
  }
  return inputs;
}

/** \param[in] own how many inliers are the tile's own points; they come first
 * \param[in] number position of the piece in the tile
 * \param[in,out] border_voxels gets the cells of the piece that other tiles see, too */
Piece
pieceOf (const PlaneSegment& plane,
         const TilePoints& points,
         const TileGrid& grid,
         std::size_t own,
         std::uint32_t number,
         std::vector<BorderVoxel>& border_voxels)
{
  const CellKey frame = grid.frameOf (points.tile);
  const Eigen::Vector3d corner = grid.cornerOf (frame);
  const double unit = outlineUnit (grid.edge);
  Piece piece;
  piece.own.unit = latticeFor (grid.edge);
  piece.all = plane.moments;
  piece.all.origin += corner;
  piece.normal = plane.normal;
  piece.inputs = inputsOf (plane, points);
  std::vector<OutlinePoint> outline (plane.inliers.size());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t index = plane.inliers[i];
    const Eigen::Vector3d local = points.points[index].cast<double>();
    outline[i].is_own = i < own;
    if (outline[i].is_own)
      piece.own.add (corner + local);
    CellKey cell = grid.cellOf (local);
    BorderVoxel voxel{{}, number};
    for (int axis = 0; axis < 3; ++axis) {
      outline[i].place[axis] = std::llround ((corner[axis] + local[axis]) / unit);
      voxel.cell[axis] = cell[axis] += frame[axis];
    }
    if (!grid.isInside (points.tile, cell))
      border_voxels.push_back (voxel);
  }
  piece.edges = outlineEdges (outline, plane.normal, grid.edge / unit);
  return piece;
}

} // namespace

void
saveTilePlanes (const std::string& file, const TilePlanes& planes)
{
  writeFile (file, [&] (std::ostream& stream) {
    BinaryWriter write (stream, file);
    const std::uint64_t pieces = planes.pieces.size();
    write (&pieces, 1);
    for (const Piece& piece : planes.pieces)
      transfer (write, piece);
    write (planes.border_voxels);
    write.finish();
  });
}

TilePlanes
loadTilePlanes (const std::string& file)
{
  BinaryReader read (file);
  TilePlanes planes;
  std::uint64_t pieces = 0;
  for (read (&pieces, 1); planes.pieces.size() < pieces;)
    transfer (read, planes.pieces.emplace_back());
  read (planes.border_voxels);
  read.finish();
  return planes;
}

TileDetection
detectInTile (const Plan& plan,
              const std::optional<CloudNoise>& noise,
              const TilePoints& points)
{
  std::uint64_t own_points = 0;
  for (const auto& [input, count] : points.own_of_input)
    own_points += count;
  TileDetection found{{}, std::vector<std::uint32_t> (own_points, 0)};
  auto& [pieces, border_voxels] = found.planes;
  for (const PlaneSegment& plane : detectIn (plan, noise, points)) {
    const auto begin = plane.inliers.begin();
    const auto end =
        std::lower_bound (begin, plane.inliers.end(), pcl::index_t (own_points));
    if (begin == end)
      continue;
    pieces.push_back (
        pieceOf (plane, points, plan.grid, end - begin, pieces.size(), border_voxels));
    for (auto index = begin; index != end; ++index)
      found.labels[*index] = pieces.size();
  }
  std::sort (border_voxels.begin(), border_voxels.end());
  const auto are_equal = [] (const BorderVoxel& a, const BorderVoxel& b) {
    return !(a < b);
  };
  border_voxels.erase (
      std::unique (border_voxels.begin(), border_voxels.end(), are_equal),
      border_voxels.end());
  return found;
}

} // namespace pcl_ops::apps
