// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads a text table once and prints wall and processor time in seconds, and a sum to compare.
// Built and called by text_reader_peer.py.

#include "core/capture/formats/text/delimited_text.h"

#include <chrono>
#include <cstdio>
#include <ctime>

int main(int argc, char **argv)
{
    if (argc != 2)
        return 2;
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t processor = std::clock();
    const auto set = dyncal::readDelimitedText(argv[1], {}, {});
    const double used_s = static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    if (!set)
        return 1;
    double sum = 0.0;
    for (const dyncal::Channel &channel : set->shots[0].channels) {
        for (dyncal::Index i = 0; i < channel.samples.size(); ++i)
            sum += channel.samples.at(i);
    }
    std::printf("%.6f %.6f %.17g\n", wall.count(), used_s, sum);
    return 0;
}
