// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_joining.h"

#include <io/output_file.h>
#include <pcl_ops/plane_merging.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

namespace pcl_ops::apps {

namespace {

struct Pair {
  std::size_t first, second;
  std::uint32_t votes;
};

/** \brief As Sampling::Surfels merges within a tile: the noise alone decides. */
MergingParameters
mergingByNoise ()
{
  constexpr double noise_factor_of_surfels = 1.5;
  MergingParameters merging;
  merging.distance_threshold = 0.0;
  merging.noise_factor = noise_factor_of_surfels;
  return merging;
}

class PieceGroups {
public:
  explicit PieceGroups (const std::vector<Piece>& pieces) : root_ (pieces.size())
  {
    std::iota (root_.begin(), root_.end(), std::size_t (0));
    seen_.reserve (pieces.size());
    for (const Piece& piece : pieces)
      seen_.push_back (piece.all);
  }

  std::size_t
  rootOf (std::size_t piece)
  {
    while (root_[piece] != piece)
      piece = root_[piece] = root_[root_[piece]];
    return piece;
  }

  /** \brief Makes one of two groups that the merging of the library makes one of. */
  void
  join (std::size_t a, std::size_t b)
  {
    a = rootOf (a);
    b = rootOf (b);
    if (a == b)
      return;
    const MergedPlanes merged = mergePlanes ({seen_[a], seen_[b]}, mergingByNoise());
    if (merged.moments.size() != 1 || merged.merged_into[0] != merged.merged_into[1])
      return;
    root_[std::max (a, b)] = std::min (a, b);
    seen_[std::min (a, b)] = merged.moments[0];
  }

private:
  std::vector<std::size_t> root_;
  /** \brief Of each root all its pieces were seen on, in halos, too. */
  std::vector<Moments> seen_;
};

/** \brief Counts the cells that pieces of two tiles share.
 * \param[in] first_of_a, first_of_b positions of the tiles' first pieces */
void
countVotes (const std::vector<Claim>& a,
            const std::vector<Claim>& b,
            std::size_t first_of_a,
            std::size_t first_of_b,
            std::vector<Pair>& pairs)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> votes;
  auto in_b = b.begin();
  for (const Claim& claim : a) {
    while (in_b != b.end() && in_b->cell < claim.cell)
      ++in_b;
    for (auto other = in_b; other != b.end() && other->cell == claim.cell; ++other)
      ++votes[{claim.piece, other->piece}];
  }
  constexpr std::uint32_t fewest_votes = 3;
  for (const auto& [pieces, count] : votes)
    if (count >= fewest_votes)
      pairs.push_back ({first_of_a + pieces.first, first_of_b + pieces.second, count});
}

/** \brief Pairs of all neighboring tiles, those with most votes first. */
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
      const auto other = static_cast<std::size_t> (found - tiles.begin());
      countVotes (
          own->claims, load (next).claims, first_piece[i], first_piece[other], pairs);
    }
  }
  std::stable_sort (pairs.begin(), pairs.end(), [] (const Pair& a, const Pair& b) {
    return a.votes > b.votes;
  });
  return pairs;
}

template <typename Item>
void
appendNew (const std::vector<Item>& items, std::vector<Item>& all)
{
  for (const Item& item : items)
    if (std::find (all.begin(), all.end(), item) == all.end())
      all.push_back (item);
}

/** \brief A plane of a piece, and what it shares with others of its group is added. */
void
addPiece (Piece& piece, const TileKey& tile, JoinedPlane& plane)
{
  if (plane.tiles.empty()) {
    plane.moments = piece.own;
    plane.normal = piece.normal;
  }
  else
    plane.moments += piece.own;
  const bool is_same_side = plane.normal.dot (piece.normal) >= 0.0;
  for (const OutlineEdge& edge : piece.edges)
    plane.edges.push_back (is_same_side ? edge : OutlineEdge{edge.to, edge.from});
  piece.edges = {}; // there are many
  appendNew ({tile}, plane.tiles);
  appendNew (piece.inputs, plane.inputs);
}

/** \brief The positions of planes by falling size, of equal ones the first one first.
 */
std::vector<std::size_t>
bySize (const std::vector<JoinedPlane>& planes)
{
  std::vector<std::size_t> order (planes.size());
  std::iota (order.begin(), order.end(), std::size_t (0));
  std::stable_sort (order.begin(), order.end(), [&] (std::size_t a, std::size_t b) {
    return planes[a].moments.count > planes[b].moments.count;
  });
  return order;
}

} // namespace

JoinedPlanes
joinPlanes (const std::vector<TileKey>& tiles,
            const std::function<TilePlanes (const TileKey&)>& load)
{
  std::vector<Piece> pieces;
  std::vector<std::size_t> first_piece;
  std::vector<TileKey> tile_of;
  for (const TileKey& tile : tiles) {
    first_piece.push_back (pieces.size());
    for (Piece& piece : load (tile).pieces)
      pieces.push_back (std::move (piece));
    tile_of.resize (pieces.size(), tile);
  }
  PieceGroups groups (pieces);
  for (const Pair& pair : pairsOf (tiles, first_piece, load))
    groups.join (pair.first, pair.second);

  std::vector<JoinedPlane> planes;
  std::vector<std::size_t> plane_of (pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::size_t root = groups.rootOf (i);
    plane_of[i] = root == i ? planes.size() : plane_of[root];
    if (root == i)
      planes.emplace_back();
    addPiece (pieces[i], tile_of[i], planes[plane_of[i]]);
    if (const auto fit = fitPlane (pieces[root].all); root == i && fit)
      planes[plane_of[i]].fit = *fit;
  }
  JoinedPlanes joined;
  std::vector<std::uint32_t> number (planes.size());
  for (const std::size_t p : bySize (planes)) {
    if (const auto fit = fitPlane (planes[p].moments.toMoments()))
      planes[p].fit = *fit;
    joined.planes.push_back (std::move (planes[p]));
    number[p] = static_cast<std::uint32_t> (joined.planes.size());
  }
  for (const TileKey& tile : tiles)
    joined.numbers[tile];
  for (std::size_t i = 0; i < pieces.size(); ++i)
    joined.numbers[tile_of[i]].push_back (number[plane_of[i]]);
  return joined;
}

void
savePlaneNumbers (const std::string& file, const PlaneNumbers& numbers)
{
  writeFile (file, [&] (std::ostream& stream) {
    put (stream, std::uint64_t (numbers.size()));
    for (const auto& [tile, numbers_of_tile] : numbers) {
      put (stream, tile);
      putAll (stream, numbers_of_tile);
    }
  });
}

PlaneNumbers
loadPlaneNumbers (const std::string& file)
{
  std::ifstream stream = openBinary (file);
  PlaneNumbers numbers;
  const auto tiles = get<std::uint64_t> (stream);
  for (std::uint64_t i = 0; i < tiles && stream; ++i) {
    const auto tile = get<TileKey> (stream);
    numbers[tile] = getAll<std::uint32_t> (stream);
  }
  checkWasRead (stream, file);
  return numbers;
}

} // namespace pcl_ops::apps
