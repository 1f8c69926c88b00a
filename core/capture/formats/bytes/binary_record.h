// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/capture/capture_set.h"

#include <string>

namespace dyncal {

/// What the readers of binary recordings share: how a rate is taken from an interval, how shots
/// are named, and the sentences for files that are not what they should be.

/// The sampling interval an instrument meant. Many headers hold it in single precision (sometimes
/// widened to double); then it is the shortest decimal number that rounds to that single, so that
/// 1e-8 s does not become 9.9999999392e-9 s.
double intendedInterval(double stored);

/// 1/interval; 0 with a finding (CAP-016, caution) if the interval is no positive number.
double sampleRateOf(double interval_s, const std::string &path, const std::string &channel,
    Index shot, Findings &findings);

/// Labels the shots of a file by its name, with the number of the segment if there are several.
void labelShots(CaptureSet &set, const std::string &path);

/// A name that no channel of `shot` has yet: `name`, or "name (2)", ...
std::string freeChannelName(const Shot &shot, const std::string &name);

/// Part of a file that is no sampled signal (digital lines, a histogram, a text, ...): CAP-026.
Finding leftOut(const std::string &path, const std::string &name, const std::string &kind);

/// "%1 ends within its header": CAP-018.
tl::unexpected<Error> endsInHeader(const std::string &path);

/// The file has fewer bytes of samples than its header says: CAP-018.
tl::unexpected<Error> endsInSamples(
    const std::string &path, const std::string &channel, Index found, Index declared);

/// A header field that no whole file has: CAP-018.
tl::unexpected<Error> impossibleField(
    const std::string &path, const std::string &field, const std::string &value);

/// A recording of a known kind (`kind` names it) that is not read because no sample file has shown
/// what its bytes mean: CAP-001.
tl::unexpected<Error> unsupportedKind(const std::string &path, const std::string &kind);

/// Nothing in the file is a sampled signal: CAP-001.
tl::unexpected<Error> noSignal(const std::string &path);

} // namespace dyncal
