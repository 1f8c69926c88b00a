// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/capture/import_settings.h"

#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// One readable format. Only this registry knows the readers in capture/formats.
struct CaptureFormat
{
    std::string id; ///< "dyncal-capture", "lvm", "text": recipe import.format
    std::string title; ///< "HDF5 capture", for messages and file dialogs
    std::vector<std::string> extensions; ///< without dot, lower case
    /// How sure this reader is that the file is its own, from the first bytes (up to 64 KiB)
    /// and the name: 0 not mine .. 100 certain.
    int (*recognise)(const std::string &path, std::string_view head);
    /// Reads the file; samples may stay in it and their hash (Channel::sha256) empty. Findings go
    /// into the set, failure is an Error with kind FileUnreadable.
    Result<CaptureSet> (*read)(
        const std::string &path, const ImportSettings &settings, const JobControl &control);
};

/// All formats, in the order in which messages list them.
const std::vector<CaptureFormat> &captureFormats();

/// "HDF5 capture (.h5), LabVIEW measurement (.lvm), ..." for messages.
std::string readableFormatsText();

/// Fails (Usage) if settings.format is neither "auto" nor the id of a format.
Result<void> checkFormatName(const ImportSettings &settings);

/// The format that recognises the file, or the one that settings.format names. Fails with CAP-001
/// (names what the file looks like and the list of formats) or CAP-018.
Result<const CaptureFormat *> formatOf(const std::string &path, const ImportSettings &settings);

} // namespace dyncal
