// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

#include <optional>

namespace dyncal {

/// A piece of a record at rest that moves more than the others.
struct Unrest
{
    Index begin = 0; ///< first sample of the piece
    double size = 0.0; ///< standard deviation in it, of means over some samples
    double usual = 0.0; ///< median of that over all pieces
};

/// The piece that stands out most among some forty of `before`, what a record holds before its
/// start; the last eighth of a piece, in which a response may begin softly, is left out. Looked at
/// are means of 1, 4, 16 ... samples, at least eight a piece, about the piece's own median, by the
/// size that four fifths of them stay within: a lone spike is no unrest. It must be half as large
/// again as seven tenths of the pieces are at most, eight robust standard deviations of the pieces
/// (twelve, of fewer than 64 means) above that, and with the median taken off as a variance more
/// than `least`. Empty with fewer than eight pieces of 32 samples. All finite.
/// docs/method/window.md.
std::optional<Unrest> unrestBefore(const Eigen::Ref<const Eigen::VectorXd> &before, double least);

} // namespace dyncal
