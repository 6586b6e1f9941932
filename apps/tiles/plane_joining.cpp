// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_joining.h"

#include <pcl_ops/plane_merging.h>

#include <map>
#include <numeric>

namespace pcl_ops::apps {

namespace {

struct Pair {
  std::size_t first, second;
  std::uint32_t votes;
};

class PieceGroups {
public:
  explicit PieceGroups (const std::vector<Piece>& pieces) : root_ (pieces.size())
  {
    std::iota (root_.begin(), root_.end(), std::size_t (0));
    for (const Piece& piece : pieces)
      seen_.push_back (piece.all);
  }

  /** \brief The first piece of the group of a piece (union-find). */
  std::size_t
  rootOf (std::size_t piece)
  {
    while (root_[piece] != piece)
      piece = root_[piece] = root_[root_[piece]];
    return piece;
  }

  /** \brief Joins the groups of two pieces if \ref mergePlanes merges them. */
  void
  join (std::size_t a, std::size_t b)
  {
    const auto [first, second] = std::minmax ({rootOf (a), rootOf (b)});
    if (first == second)
      return;
    // As Sampling::Surfels merges within a tile: the noise alone decides.
    MergingParameters by_noise;
    by_noise.distance_threshold = 0.0;
    by_noise.noise_factor = 1.5;
    const MergedPlanes merged = mergePlanes ({seen_[first], seen_[second]}, by_noise);
    if (merged.moments.size() != 1 || merged.merged_into[0] != merged.merged_into[1])
      return;
    root_[second] = first;
    seen_[first] = merged.moments[0];
  }

private:
  std::vector<std::size_t> root_;
  /** \brief For each root: moments of all points of its pieces, with those in halos. */
  std::vector<Moments> seen_;
};

/** \brief Adds the pairs of pieces of two tiles that share cells, with their number.
 * \param[in] first_of_a, first_of_b positions of the tiles' first pieces */
void
countVotes (const std::vector<BorderVoxel>& a,
            const std::vector<BorderVoxel>& b,
            std::size_t first_of_a,
            std::size_t first_of_b,
            std::vector<Pair>& pairs)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> votes;
  auto in_b = b.begin();
  for (const BorderVoxel& voxel : a) {
    while (in_b != b.end() && in_b->cell < voxel.cell)
      ++in_b;
    for (auto other = in_b; other != b.end() && other->cell == voxel.cell; ++other)
      ++votes[{voxel.piece, other->piece}];
  }
  constexpr std::uint32_t min_votes = 3;
  for (const auto& [pieces, count] : votes)
    if (count >= min_votes)
      pairs.push_back ({first_of_a + pieces.first, first_of_b + pieces.second, count});
}

/** \brief Pairs of pieces of all neighboring tiles, by falling number of votes. */
std::vector<Pair>
pairsOf (const std::vector<TileKey>& tiles,
         const std::vector<std::size_t>& first_piece,
         const std::function<TilePlanes (const TileKey&)>& load)
{
  constexpr std::array<TileKey, 4> steps = {{{0, 1}, {1, -1}, {1, 0}, {1, 1}}};
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    std::optional<TilePlanes> own;
    for (const TileKey& step : steps) {
      const TileKey next{tiles[i][0] + step[0], tiles[i][1] + step[1]};
      const auto found = std::lower_bound (tiles.begin(), tiles.end(), next);
      if (found == tiles.end() || *found != next)
        continue;
      if (!own)
        own = load (tiles[i]);
      const std::size_t other = found - tiles.begin();
      countVotes (own->border_voxels,
                  load (next).border_voxels,
                  first_piece[i],
                  first_piece[other],
                  pairs);
    }
  }
  std::stable_sort (pairs.begin(), pairs.end(), [] (const Pair& a, const Pair& b) {
    return a.votes > b.votes;
  });
  return pairs;
}

/** \brief Adds a piece to its plane, without its edges then; called by tile. */
void
addPiece (Piece& piece, const TileKey& tile, JoinedPlane& plane)
{
  if (plane.tiles.empty()) {
    plane.moments.unit = piece.own.unit;
    plane.normal = piece.normal;
    plane.fit = fitPlane (piece.all).value_or (PlaneFit());
  }
  plane.moments.sums += piece.own.sums;
  const bool is_same_side = plane.normal.dot (piece.normal) >= 0.0;
  for (const OutlineEdge& edge : piece.edges)
    plane.edges.push_back (is_same_side ? edge : OutlineEdge{edge.to, edge.from});
  piece.edges = {}; // frees much memory
  if (plane.tiles.empty() || plane.tiles.back() != tile)
    plane.tiles.push_back (tile);
  for (const std::uint32_t input : piece.inputs)
    if (std::find (plane.inputs.begin(), plane.inputs.end(), input) ==
        plane.inputs.end())
      plane.inputs.push_back (input);
}

/** \brief The number of each piece's plane, from 1 on by falling number of points;
 * planes of equal size are in the order of their first pieces. */
std::vector<std::uint32_t>
numbersOf (const std::vector<Piece>& pieces, PieceGroups& groups)
{
  std::vector<ExactMoments::Whole> points (pieces.size());
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::size_t root = groups.rootOf (i);
    points[root] += pieces[i].own.count();
    if (root == i)
      roots.push_back (i);
  }
  std::stable_sort (roots.begin(), roots.end(), [&] (std::size_t a, std::size_t b) {
    return points[a] > points[b];
  });
  std::vector<std::uint32_t> numbers (pieces.size());
  for (std::size_t k = 0; k < roots.size(); ++k)
    numbers[roots[k]] = k + 1;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    numbers[i] = numbers[groups.rootOf (i)];
  return numbers;
}

} // namespace

JoinedPlanes
joinPlanes (const std::vector<TileKey>& tiles,
            const std::function<TilePlanes (const TileKey&)>& load)
{
  std::vector<Piece> pieces;
  std::vector<std::size_t> first_piece;
  for (const TileKey& tile : tiles) {
    first_piece.push_back (pieces.size());
    for (Piece& piece : load (tile).pieces)
      pieces.push_back (std::move (piece));
  }
  PieceGroups groups (pieces);
  for (const Pair& pair : pairsOf (tiles, first_piece, load))
    groups.join (pair.first, pair.second);

  const std::vector<std::uint32_t> numbers = numbersOf (pieces, groups);
  first_piece.push_back (pieces.size());
  JoinedPlanes joined{{}, std::vector<std::vector<std::uint32_t>> (tiles.size())};
  if (!numbers.empty())
    joined.planes.resize (*std::max_element (numbers.begin(), numbers.end()));
  for (std::size_t t = 0; t < tiles.size(); ++t)
    for (std::size_t i = first_piece[t]; i < first_piece[t + 1]; ++i) {
      addPiece (pieces[i], tiles[t], joined.planes[numbers[i] - 1]);
      joined.numbers[t].push_back (numbers[i]);
    }
  for (JoinedPlane& plane : joined.planes)
    plane.fit = fitPlane (plane.moments.toMoments()).value_or (plane.fit);
  return joined;
}

} // namespace pcl_ops::apps
