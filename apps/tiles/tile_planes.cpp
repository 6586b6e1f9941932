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

/** \brief Writes a piece to a file if File is BinaryWriter and Piece is const
 * TilePiece; reads it if File is BinaryReader and Piece is TilePiece. */
template <typename File, typename Piece>
void
transfer (File& file, Piece& piece)
{
  file (&piece.own_moments.unit, 1);
  file (piece.own_moments.sums.data(), piece.own_moments.sums.size());
  file (piece.seen_moments.origin.data(), 3);
  file (&piece.seen_moments.count, 1);
  file (piece.seen_moments.sum.data(), 3);
  file (piece.seen_moments.products.data(), piece.seen_moments.products.size());
  file (piece.normal.data(), 3);
  file (piece.edges);
  file (piece.inputs);
}

/** \brief Returns the planes of the points that a tile sees, in the frame of the tile.
 */
std::vector<PlaneSegment>
planesOf (const Plan& plan,
          const std::optional<CloudNoise>& noise,
          const TilePoints& points)
{
  OrientedPointSamplingParameters parameters;
  // CloudNoise::points is 0 if the survey had too few points to measure its noise.
  if (noise && noise->points > 0.0)
    parameters.noise_of_whole = noise;
  if (plan.is_on_voxels)
    parameters.surfels.voxel_size = plan.grid.edge;
  const std::vector<Eigen::Vector3f>& seen = points.points;
  if (seen.size() > std::size_t (std::numeric_limits<pcl::index_t>::max()))
    throw std::bad_alloc();
  constexpr std::size_t x_offset = 0; // [bytes]
  const CloudView view (seen.data(), x_offset, sizeof (seen[0]), seen.size());
  return detectPlanes (view, parameters);
}

/** \brief Returns the inputs of a plane's own points. Inliers are ascending indices, so
 * own points come first, input by input. */
std::vector<std::uint32_t>
inputsOf (const PlaneSegment& plane, const TilePoints& points)
{
  std::vector<std::uint32_t> inputs;
  std::uint64_t end_of_input = 0; // index after the last point of the input
  auto begin = plane.inliers.begin();
  for (const OwnPoints& own : points.own_of_inputs) {
    end_of_input += own.count;
    const auto end =
        std::lower_bound (begin, plane.inliers.end(), pcl::index_t (end_of_input));
    if (begin != end)
      inputs.push_back (own.input);
    begin = end; // inliers of the next input
  }
  return inputs;
}

/** \brief Makes a piece of a plane that was found in a tile.
 * \param[in] own_inliers how many inliers are the tile's own points; they come first
 * \param[in] position that the piece will have in TilePlanes::pieces
 * \param[in,out] border_voxels gets, for each point of the piece in a cell that other
 * tiles see, too, that cell */
TilePiece
pieceOf (const PlaneSegment& plane,
         const TilePoints& points,
         const TileGrid& grid,
         std::size_t own_inliers,
         std::uint32_t position,
         std::vector<BorderVoxel>& border_voxels)
{
  const CellKey origin_cell = grid.frameOf (points.tile);
  const Eigen::Vector3d origin = grid.cornerOf (origin_cell);
  const double unit = outlineUnit (grid.edge);
  TilePiece piece;
  piece.own_moments.unit = momentsUnit (grid.edge);
  piece.seen_moments = plane.moments;
  piece.seen_moments.origin += origin;
  piece.normal = plane.normal;
  piece.inputs = inputsOf (plane, points);
  std::vector<OutlinePoint> outline (plane.inliers.size());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t index = plane.inliers[i];
    const Eigen::Vector3d local = points.points[index].cast<double>();
    outline[i].is_own = i < own_inliers;
    if (outline[i].is_own)
      piece.own_moments.add (origin + local);
    // The number of a cell counted from the origin of the tile's frame, plus that of
    // the cell with this origin.
    CellKey cell = grid.cellOf (local);
    BorderVoxel voxel{{}, position};
    for (int axis = 0; axis < 3; ++axis) {
      outline[i].position[axis] = std::llround ((origin[axis] + local[axis]) / unit);
      cell[axis] += origin_cell[axis];
      voxel.cell[axis] = cell[axis];
    }
    if (!grid.isSeenOnlyBy (points.tile, cell))
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
    for (const TilePiece& piece : planes.pieces)
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
  for (const OwnPoints& own : points.own_of_inputs)
    own_points += own.count;
  TileDetection found{{}, std::vector<std::uint32_t> (own_points, 0)};
  auto& [pieces, border_voxels] = found.planes;
  for (const PlaneSegment& plane : planesOf (plan, noise, points)) {
    const auto begin = plane.inliers.begin();
    const auto end_of_own =
        std::lower_bound (begin, plane.inliers.end(), pcl::index_t (own_points));
    const std::size_t own_inliers = end_of_own - begin;
    if (own_inliers == 0)
      continue;
    const auto position = static_cast<std::uint32_t> (pieces.size());
    pieces.push_back (
        pieceOf (plane, points, plan.grid, own_inliers, position, border_voxels));
    for (auto index = begin; index != end_of_own; ++index)
      found.piece_numbers[*index] = position + 1;
  }
  std::sort (border_voxels.begin(), border_voxels.end());
  const auto are_equal = [] (const BorderVoxel& a, const BorderVoxel& b) {
    return !(a < b); // as they are sorted, b < a is false, too
  };
  border_voxels.erase (
      std::unique (border_voxels.begin(), border_voxels.end(), are_equal),
      border_voxels.end());
  return found;
}

} // namespace pcl_ops::apps
