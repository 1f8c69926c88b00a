// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

#include <complex>

namespace dyncal {

/// e^(-2 pi j r n). Whole turns are taken off the exact product, so that far samples are turned
/// as precisely as near ones. |r n| below 2^52.
std::complex<double> turned(double turnsPerSample, double samples);

/// sum over n of y_n e^(-2 pi j r n) for each r of `turns`: the discrete Fourier transform at
/// frequencies of any choice, r = f / sample rate, finite, of either sign, for |r| N below 2^52.
/// The sum itself, no interpolation between bins: from sums written out in long double it differs
/// by less than 1e-15 times the sum of |y_n|. 0 for an empty record. The result does not depend on
/// the number of threads.
///
/// Pairs of samples at equal distances from the middle of a block of 512 are added and subtracted
/// once; all frequencies then take cosines of the sums and sines of the differences, and the blocks
/// are turned into place from anchors whose angles are exact. docs/method/dft-covariance.md.
Eigen::VectorXcd spectralSums(
    const Eigen::Ref<const Eigen::VectorXd> &y, const Eigen::Ref<const Eigen::VectorXd> &turns);

} // namespace dyncal
