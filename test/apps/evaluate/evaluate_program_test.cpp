// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <numbers/random.h>
#include <support/answers.h>

#include <array>

namespace {

namespace fs = std::filesystem;

/** pcl_ops_evaluate, the files of inputs and some clouds. */
class EvaluateProgram : public AnswersFolder {
protected:
  EvaluateProgram() : AnswersFolder (PCL_OPS_EVALUATE_PROGRAM)
  {
    fs::copy (PCL_OPS_INPUTS, folder_.path(), fs::copy_options::recursive);
    writeNoisyClouds();
  }

private:
  /** A plane of 40 x 40 points, 2 cm apart, with 1 cm of noise that is the same for 4 x
   * 4 of them, seen from above in 40 clouds, in every second by a sensor that is turned
   * by 90 degrees. */
  void
  writeNoisyClouds () const
  {
    fs::create_directory (folder_ / "noisy");
    pcl_ops::apps::Random random (1);
    std::string poses;
    for (int cloud = 100; cloud < 140; ++cloud) {
      const bool is_turned = cloud % 2 == 1;
      std::array<double, 100> errors{};
      for (double& error : errors)
        error = 0.01 * random.gaussian();
      std::ostringstream text ("x,y,z,label\n", std::ios::ate);
      for (int i = 0; i < 1600; ++i) {
        const int column = i % 40, row = i / 40;
        const double x = 0.02 * column, y = 0.02 * row;
        text << (is_turned ? y : x) << ',' << (is_turned ? -x : y) << ','
             << errors[column / 4 + row / 4 * 10] - 1.0 << ",1\n";
      }
      folder_.write ("noisy/" + std::to_string (cloud) + ".xyz", text.str());
      poses += is_turned ? "0 0 0 1 0 0 0.70710678 0.70710678\n" : "0 0 0 1 0 0 0 1\n";
    }
    folder_.write ("poses.txt", poses);
  }
};

INSTANTIATE_TEST_SUITE_P (All,
                          EvaluateProgram,
                          testing::ValuesIn (answersIn (PCL_OPS_ANSWERS)),
                          nameOfAnswers);

TEST_P (EvaluateProgram, IsAsTheTableSays) { expectAnswers(); }

} // namespace
