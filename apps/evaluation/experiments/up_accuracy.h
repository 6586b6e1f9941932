// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/data/cloud_source.h>
#include <evaluation/report/text_table.h>
#include <numbers/random.h>
#include <pcl_ops/up_axis.h>

#include <string>
#include <vector>

namespace pcl_ops::evaluation {

/** \brief The likeliest up axis of a cloud, and how far off it is. */
struct UpGuess {
  double confidence = 0.0;
  /** \brief Angle to the truth [degree]. */
  double error = 0.0;
};

/** \brief Turns a cloud at random, finds its planes by the default preset and from them
 * its up axis, however unsure.
 * \param[in] cloud with its true up axis and the sensor's origin
 * \param[in,out] random draws the rotation, evenly among all
 * \return nothing where no direction can be up at all */
std::optional<UpGuess>
guessUp (const EvaluationCloud& cloud, apps::Random& random);

/** \brief The guesses on a data set. */
struct UpGuesses {
  std::string data_set;
  /** \brief Turned clouds, with those that have no guess. */
  std::size_t tries = 0;
  std::vector<UpGuess> guesses;
};

/** \brief How often there is an answer, and its error.
 * \param[in] least_confidence guesses below it are no answers */
TextTable
errorTable (const std::vector<UpGuesses>& data_sets, double least_confidence);

/** \brief How often guesses of a confidence are right, for all data sets together. */
TextTable
reliabilityTable (const std::vector<UpGuesses>& data_sets);

} // namespace pcl_ops::evaluation
