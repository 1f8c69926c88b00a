// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Decomposes the Hankel matrix of records once and prints wall and processor time in seconds, the
// peak of the memory in MB, how many triplets converged, and the singular values. Built and called
// by decomposition_peer.py: decomposition_peer FILE RECORDS TRIPLETS, FILE holds doubles, one
// record behind the other. One record: square and unprojected; several: stacked and projected.

#include "core/realization/hankel/hankel_triplets.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <vector>

#include <sys/resource.h>

namespace {

std::vector<Eigen::VectorXd> readRecords(const char *path, dyncal::Index count)
{
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const auto length = static_cast<dyncal::Index>(file.tellg())
        / static_cast<dyncal::Index>(sizeof(double)) / count;
    file.seekg(0);
    std::vector<Eigen::VectorXd> records(static_cast<std::size_t>(count), Eigen::VectorXd(length));
    for (Eigen::VectorXd &record : records) {
        file.read(reinterpret_cast<char *>(record.data()),
            static_cast<std::streamsize>(sizeof(double)) * length);
    }
    return records;
}

} // namespace

int main(int argc, char **argv)
{
    using namespace dyncal;
    if (argc != 4)
        return 2;
    const std::vector<Eigen::VectorXd> records = readRecords(argv[1], std::atoi(argv[2]));
    const Index count = std::atoi(argv[3]);

    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t processor = std::clock();
    std::vector<HankelOperator> blocks;
    const bool stacked = records.size() > 1;
    for (const Eigen::VectorXd &y : records) {
        const Index rows = y.size() / 2 - 1;
        blocks.emplace_back(y, rows, stacked ? y.size() - rows + 1 : rows, stacked);
    }
    const auto triplets
        = HankelTriplets(blocks).leading(count, HankelTriplets::Right::NotWanted, {});
    const double used_s = static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;

    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    std::printf("%.6f %.6f %.0f %td", wall.count(), used_s,
        static_cast<double>(usage.ru_maxrss) / 1024.0, triplets->converged);
    for (const double value : triplets->singularValues)
        std::printf(" %.17g", value);
    std::printf("\n");
    return 0;
}
