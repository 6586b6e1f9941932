// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/plane_splitting.h"

#include <Eigen/Eigenvalues>

#include "base/parallel.h"
#include "geometry/principal_axes.h"
#include "leaves/surrounding_noise.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl_ops::internal {

namespace {

/** \brief Leaves of one plane. */
struct Piece {
  Indices leaves;
  Moments moments;
  double noise = 0.0; // of the surroundings of its leaves [m]; 0: not known

  double
  thickness () const
  {
    const double variance = principalAxes (moments.covariance()).values[0];
    return noise > 0.0 ? std::sqrt (std::max (0.0, variance)) / noise : 0.0;
  }
};

/** \brief Divides one plane. */
class PlaneSplit {
public:
  PlaneSplit (const LeafCloud& cloud, const LeafPlanes& planes, double points_around)
  : cloud_ (cloud), planes_ (planes), points_around_ (points_around)
  {}

  /** \return thin pieces of a plane; nothing where it is thin */
  std::optional<std::vector<Piece>>
  piecesOf (const Indices& leaves)
  {
    Piece whole = pieceOf (leaves, 0.0);
    if (whole.thickness() <= max_thickness_of_plane)
      return std::nullopt;
    return joinWhileThin (halveWhileThick (std::move (whole)));
  }

private:
  /** \brief Two pieces that touch. */
  struct Pair {
    std::size_t first, second; // first < second
    double thickness;          // of their union

    static bool
    makesThinner (const Pair& a, const Pair& b)
    {
      return a.thickness < b.thickness;
    }
    bool
    isBetween (const Pair& other) const
    {
      return first == other.first && second == other.second;
    }
    static bool
    precedes (const Pair& a, const Pair& b)
    {
      return std::make_pair (a.first, a.second) < std::make_pair (b.first, b.second);
    }
  };

  /** \param[in] noise where the leaves are too few to tell */
  Piece
  pieceOf (Indices leaves, double noise) const
  {
    Piece piece;
    for (const std::uint32_t leaf : leaves)
      piece.moments.addAligned (cloud_.moments[leaf]);
    piece.noise =
        surroundingNoise (cloud_, planes_.plane_of_leaf, leaves, points_around_)
            .value_or (noise);
    piece.leaves = std::move (leaves);
    return piece;
  }

  /** \brief Halves a plane, and what is thick of it again. Pieces of few leaves, which
   * some plane always fits, are left out. */
  std::vector<Piece>
  halveWhileThick (Piece whole) const
  {
    constexpr std::size_t min_leaves = 8;
    std::vector<Piece> thick{std::move (whole)};
    std::vector<Piece> thin;
    while (!thick.empty()) {
      const Piece piece = std::move (thick.back());
      thick.pop_back();
      for (Indices& half : halvesOf (piece)) {
        if (half.size() < min_leaves)
          continue;
        Piece part = pieceOf (std::move (half), piece.noise);
        const bool is_thin = part.thickness() <= max_thickness_of_plane;
        (is_thin ? thin : thick).push_back (std::move (part));
      }
    }
    return thin;
  }

  /** \brief Joins pieces that touch, the thinnest union first. */
  std::vector<Piece>
  joinWhileThin (std::vector<Piece> pieces)
  {
    std::vector<Pair> pairs = pairsThatTouch (pieces);
    while (!pairs.empty()) {
      const auto best =
          std::min_element (pairs.begin(), pairs.end(), Pair::makesThinner);
      if (best->thickness > max_thickness_of_plane)
        break;
      const auto [into, from] = std::make_pair (best->first, best->second);
      pieces[into] = unionOf (pieces[into], pieces[from]);
      pieces[from] = Piece();
      renew (pieces, into, from, pairs);
    }
    return pieces;
  }

  // Across the longest axis.
  std::array<Indices, 2>
  halvesOf (const Piece& piece) const
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes (
        piece.moments.covariance());
    const Eigen::Vector3d longest = axes.eigenvectors().col (2);
    const double middle = longest.dot (piece.moments.centroid());
    std::array<Indices, 2> halves;
    for (const std::uint32_t leaf : piece.leaves) {
      const bool is_beyond = longest.dot (cloud_.moments[leaf].centroid()) > middle;
      halves[is_beyond ? 1 : 0].push_back (leaf);
    }
    return halves;
  }

  static double
  noiseOfUnion (const Piece& a, const Piece& b)
  {
    return (a.moments.count * a.noise + b.moments.count * b.noise) /
           (a.moments.count + b.moments.count);
  }

  static Piece
  unionOf (const Piece& a, const Piece& b)
  {
    Piece both = a;
    both.leaves.insert (both.leaves.end(), b.leaves.begin(), b.leaves.end());
    both.moments.addAligned (b.moments);
    both.noise = noiseOfUnion (a, b);
    return both;
  }

  static double
  thicknessOfUnion (const Piece& a, const Piece& b)
  {
    Piece both{{}, a.moments, 0.0};
    both.moments.addAligned (b.moments);
    both.noise = noiseOfUnion (a, b);
    return both.thickness();
  }

  // The pieces after one that its leaves touch, once for each contact of leaves.
  void
  addPairsOf (const std::vector<Piece>& pieces,
              std::size_t piece,
              std::vector<Pair>& pairs) const
  {
    for (const std::uint32_t leaf : pieces[piece].leaves)
      for (const std::uint32_t k : cloud_.neighbors[leaf])
        if (piece_of_leaf_[k] > static_cast<std::int32_t> (piece))
          pairs.push_back ({piece, static_cast<std::size_t> (piece_of_leaf_[k]), 0.0});
  }

  std::vector<Pair>
  pairsThatTouch (const std::vector<Piece>& pieces)
  {
    piece_of_leaf_.assign (cloud_.size(), no_plane);
    for (std::size_t p = 0; p < pieces.size(); ++p)
      for (const std::uint32_t leaf : pieces[p].leaves)
        piece_of_leaf_[leaf] = static_cast<std::int32_t> (p);
    std::vector<Pair> pairs;
    for (std::size_t p = 0; p < pieces.size(); ++p)
      addPairsOf (pieces, p, pairs);
    removeRepeated (pairs);
    for (Pair& pair : pairs)
      pair.thickness = thicknessOfUnion (pieces[pair.first], pieces[pair.second]);
    return pairs;
  }

  static void
  removeRepeated (std::vector<Pair>& pairs)
  {
    std::sort (pairs.begin(), pairs.end(), Pair::precedes);
    pairs.erase (
        std::unique (pairs.begin(),
                     pairs.end(),
                     [] (const Pair& a, const Pair& b) { return a.isBetween (b); }),
        pairs.end());
  }

  // After one piece went into another.
  static void
  renew (const std::vector<Piece>& pieces,
         std::size_t into,
         std::size_t from,
         std::vector<Pair>& pairs)
  {
    for (Pair& pair : pairs) {
      std::size_t first = pair.first == from ? into : pair.first;
      std::size_t second = pair.second == from ? into : pair.second;
      if (first > second)
        std::swap (first, second);
      const bool is_new = first == into || second == into;
      pair.first = first;
      pair.second = second;
      if (is_new && first != second)
        pair.thickness = thicknessOfUnion (pieces[first], pieces[second]);
    }
    pairs.erase (
        std::remove_if (pairs.begin(),
                        pairs.end(),
                        [] (const Pair& pair) { return pair.first == pair.second; }),
        pairs.end());
    removeRepeated (pairs);
  }

  const LeafCloud& cloud_;
  const LeafPlanes& planes_;
  double points_around_;
  Labels piece_of_leaf_ = {}; // of the plane that is divided
};

// Gives pieces numbers: the first keeps that of the plane.
void
replacePlane (std::size_t plane,
              const Indices& leaves,
              const std::vector<Piece>& pieces,
              LeafPlanes& planes,
              std::vector<char>& changed)
{
  for (const std::uint32_t leaf : leaves)
    planes.plane_of_leaf[leaf] = no_plane;
  changed[plane] = 1;
  std::size_t number = plane;
  for (const Piece& piece : pieces) {
    if (piece.leaves.empty())
      continue;
    for (const std::uint32_t leaf : piece.leaves)
      planes.plane_of_leaf[leaf] = static_cast<std::int32_t> (number);
    number = planes.planes.size();
    planes.planes.push_back (planes.planes[plane]);
    changed.push_back (1);
  }
}

} // namespace

std::vector<char>
splitThickPlanes (const LeafCloud& cloud,
                  double points_around,
                  unsigned threads,
                  LeafPlanes& planes)
{
  std::vector<Indices> leaves (planes.planes.size());
  for (std::uint32_t i = 0; i < cloud.size(); ++i)
    if (planes.plane_of_leaf[i] != no_plane)
      leaves[planes.plane_of_leaf[i]].push_back (i);
  std::vector<std::optional<std::vector<Piece>>> pieces_of_plane (leaves.size());
  parallelFor (threads, leaves.size(), 1, [&] (std::size_t p, std::size_t) {
    if (!leaves[p].empty())
      pieces_of_plane[p] =
          PlaneSplit (cloud, planes, points_around).piecesOf (leaves[p]);
  });
  std::vector<char> changed (leaves.size(), 0);
  for (std::size_t p = 0; p < leaves.size(); ++p)
    if (pieces_of_plane[p])
      replacePlane (p, leaves[p], *pieces_of_plane[p], planes, changed);
  return changed;
}

} // namespace pcl_ops::internal
