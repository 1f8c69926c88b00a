// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// S(f) of a step's record at listed frequencies with the covariance of Re and Im, once; prints wall
// and processor time in seconds, then Re, Im, var Re, cov, var Im of every frequency. Built and
// called by gum_covariance.py: gum_covariance FILE SAMPLES FREQUENCIES, FILE holds doubles: the
// record, the variance of each sample, the frequencies over the sample rate.

#include "core/base/index.h"
#include "core/model_analysis/step_covariance.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>

namespace {

Eigen::VectorXd read(std::ifstream &file, dyncal::Index count)
{
    Eigen::VectorXd values(count);
    file.read(reinterpret_cast<char *>(values.data()),
        static_cast<std::streamsize>(sizeof(double)) * count);
    return values;
}

} // namespace

int main(int argc, char **argv)
{
    using namespace dyncal;
    if (argc != 4)
        return 2;
    std::ifstream file(argv[1], std::ios::binary);
    const Index samples = std::atoi(argv[2]);
    const Eigen::VectorXd y = read(file, samples);
    const Eigen::VectorXd variance = read(file, samples);
    const Eigen::VectorXd turns = read(file, std::atoi(argv[3]));

    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t processor = std::clock();
    const TransformEnd end = transformEnds(y, 0).back();
    const auto lines = stepTransformsWithCovariance(y, variance, 1.0, end, 0.0, turns);
    const double used_s = static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;

    std::printf("%.6f %.6f", wall.count(), used_s);
    for (const UncertainComplex &line : lines)
        std::printf(" %.17g %.17g %.17g %.17g %.17g", line.value.real(), line.value.imag(),
            line.covariance(0, 0), line.covariance(0, 1), line.covariance(1, 1));
    std::printf("\n");
    return 0;
}
