// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper_figures.h"

#include <algorithm>

namespace pcl_ops::evaluation {

namespace {

const std::vector<PaperFigures> all_figures{
    // Table I
    {"fspf-0.03-0.03", 0.6134, 0.0974, 0.1895, 0.2997},
    {"fspf-0.05-0.05", 0.6807, 0.1102, 0.2103, 0.3003},
    {"fspf-0.07-0.07", 0.6968, 0.2106, 0.1937, 0.4043},
    {"fspf-0.1-0.1", 0.7114, 0.2479, 0.2145, 0.4642},
    {"fspf-0.3-0.3", 0.7312, 2.6423, 0.3293, 2.9716},
    {"fspf-0.03-0.06", 0.6901, 0.1139, 0.2415, 0.3554},
    {"fspf-0.05-0.1", 0.7111, 0.1973, 0.2487, 0.4460},
    {"fspf-0.07-0.14", 0.7250, 0.3441, 0.2785, 0.6226, 0.7472, 386.92, 29.44},
    {"fspf-0.1-0.2", 0.7361, 0.7277, 0.3180, 1.0457},
    {"fspf-0.3-0.6", 0.6626, 2.7624, 0.4960, 3.2584},
    // Table II
    {"kht-30-300", 0.6708, NAN, NAN, 0.0837},
    {"kht-40-400", 0.6786, NAN, NAN, 0.1448},
    {"kht-60-600", 0.6953, NAN, NAN, 0.3674},
    {"kht-80-800", 0.7101, NAN, NAN, 0.7941, 0.6226},
    // Table III
    {"ops-0.3-10", 0.7152, 0.0244, NAN, 0.0359},
    {"ops-0.3-20", 0.7218, 0.0347, NAN, 0.0460},
    {"ops-0.3-30", 0.7229, 0.0458, NAN, 0.0565},
    {"ops-0.5-10", 0.7711, 0.0452, NAN, 0.0625},
    {"ops-0.5-20", 0.7748, 0.0644, NAN, 0.0803},
    {"ops-0.5-30", 0.7759, 0.0833, NAN, 0.0987},
    {"ops-0.7-10", 0.8004, 0.0656, NAN, 0.0853},
    {"ops-0.7-20", 0.8028, 0.0906, NAN, 0.1093},
    {"ops-0.7-30", 0.8034, 0.1184, NAN, 0.1363},
    {"ops-1-10", 0.8255, 0.1008, NAN, 0.1233},
    {"ops-1-20", 0.8266, 0.1375, NAN, 0.1587},
    {"ops-1-30", 0.8271, 0.1759, NAN, 0.1967},
    {"ops-3-10", 0.8691, 0.4092, NAN, 0.4377},
    {"ops-3-20", 0.8723, 0.5096, NAN, 0.5366},
    {"ops-3-30", 0.8739, 0.6188, NAN, 0.6455, 0.8299, 34.62, 27.59},
    // Strategy 1, section IV-B
    {"ops-s1-3-10", 0.7425},
    {"ops-s1-3-20", 0.7504},
    {"ops-s1-3-30", 0.7589},
};

} // namespace

PaperFigures
paperFiguresOf (const std::string& configuration)
{
  const auto found = std::find_if (
      all_figures.begin(), all_figures.end(), [&] (const PaperFigures& figures) {
        return figures.configuration == configuration;
      });
  return found == all_figures.end() ? PaperFigures{configuration} : *found;
}

} // namespace pcl_ops::evaluation
