// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"

#include <string>

namespace dyncal {

/// The input with its size and time of change as they are now; to be taken before it is read.
InputFile stampedInput(const std::string &path, const std::string &format);

/// Whether the file still has the size and time of change that were stamped. True for an input
/// without a stamp: there is nothing to compare with.
bool isUnchanged(const InputFile &input);

/// Fills in every hash that is still empty: Channel::sha256 of all samples and InputFile::sha256 of
/// all files, block by block. An opened set may be shown; only a sealed one may be calibrated from.
/// Fails with CAP-015 if a file is no longer the one that was opened, and with CAP-018 if samples
/// cannot be read or differ from what their file states of them (Channel::statedSha256). Inputs
/// with the same bytes become a finding (CAP-011), and so do unexpected ones (reportUnexpected).
/// Files are hashed on a thread of their own, beside the samples. Sealing a sealed set changes
/// nothing.
Result<CaptureSet> sealCaptures(CaptureSet set, const JobControl &control = {});

/// Fails with CAP-015, naming the file, if samples that stay in it can no longer be vouched for: it
/// was changed, moved or removed, or a part could not be read. To be asked when everything is
/// computed and before anything made of the samples is kept: what cannot be read looks like gaps.
Result<void> checkStillWhole(const CaptureSet &set);

/// Finding CAP-015, which blocks, for every input whose hash is known and not the expected one.
void reportUnexpected(CaptureSet &set);

} // namespace dyncal
