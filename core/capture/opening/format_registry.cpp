// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/opening/format_registry.h"

#include "core/capture/file_kind.h"
#include "core/capture/file_samples.h"
#include "core/capture/formats/foreign/foreign_hdf5.h"
#include "core/capture/formats/foreign/mat73.h"
#include "core/capture/formats/hdf5/hdf5_capture_reader.h"
#include "core/capture/formats/instruments/lecroy_trc.h"
#include "core/capture/formats/instruments/rigol_wfm.h"
#include "core/capture/formats/instruments/rohde_bin.h"
#include "core/capture/formats/instruments/scope_bin.h"
#include "core/capture/formats/instruments/wav.h"
#include "core/capture/formats/lvm/lvm.h"
#include "core/capture/formats/matlab/mat.h"
#include "core/capture/formats/tdms/tdms.h"
#include "core/capture/formats/text/delimited_text.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <system_error>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

Result<std::string> headOf(const std::string &path)
{
    constexpr std::size_t kHeadBytes = 64 * 1024;
    std::error_code error;
    if (path.empty())
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core", "An empty name was given where a file is needed; name a file."),
                {}},
            "CAP-018");
    if (!fs::exists(path, error))
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core", "%1 does not exist; check the name and the folder."), {path}},
            "CAP-018");
    if (!fs::is_regular_file(path, error))
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT(
                 "core", "%1 is a folder or a device, not a file; name a file. Readable are: %2."),
                {path, readableFormatsText()}},
            "CAP-001");
    const auto file = SampleFile::open(path);
    if (!file)
        return tl::unexpected(file.error());
    std::string head(
        static_cast<std::size_t>(std::min<std::uint64_t>(kHeadBytes, (*file)->size())), '\0');
    if (!(*file)->read(0, head.size(), std::as_writable_bytes(std::span(head)).data()))
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 cannot be opened; check that you may read it and that no other program holds it."),
                {path}},
            "CAP-018");
    return head;
}

Result<const CaptureFormat *> formatNamed(const std::string &id)
{
    std::string known = "auto";
    for (const CaptureFormat &format : captureFormats()) {
        if (format.id == id)
            return &format;
        known += ", " + format.id;
    }
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core", "There is no import format \"%1\"; choose one of %2."), {id, known}});
}

} // namespace

const std::vector<CaptureFormat> &captureFormats()
{
    static const std::vector<CaptureFormat> formats{
        {"dyncal-capture", "HDF5 capture", {"h5", "hdf5"}, &recogniseHdf5Capture, &readHdf5Capture},
        {"hdf5", "other HDF5", {"h5", "hdf5", "hdf", "nxs"}, &recogniseForeignHdf5,
            &readForeignHdf5},
        {"mat73", "MATLAB 7.3", {"mat"}, &recogniseMat73, &readMat73},
        {"lvm", "LabVIEW measurement", {"lvm"}, &recogniseLvm, &readLvm},
        {"tdms", "NI TDMS", {"tdms"}, &recogniseTdms, &readTdms},
        {"keysight-bin", "Keysight/Agilent waveform", {"bin"}, &recogniseKeysightBin,
            &readKeysightBin},
        {"rigol-bin", "Rigol waveform", {"bin"}, &recogniseRigolBin, &readRigolBin},
        {"rigol-wfm", "Rigol waveform memory", {"wfm"}, &recogniseRigolWfm, &readRigolWfm},
        {"rohde-bin", "Rohde & Schwarz waveform", {"bin"}, &recogniseRohdeBin, &readRohdeBin},
        {"lecroy-trc", "LeCroy waveform", {"trc"}, &recogniseLecroyTrc, &readLecroyTrc},
        {"mat", "MATLAB 4 to 7.2", {"mat"}, &recogniseMat, &readMat},
        {"wav", "WAV", {"wav", "rf64", "bw64"}, &recogniseWav, &readWav},
        {"text", "text table", {"csv", "tsv", "txt", "dat"}, &recogniseDelimitedText,
            &readDelimitedText},
    };
    return formats;
}

std::string readableFormatsText()
{
    std::string text;
    for (const CaptureFormat &format : captureFormats()) {
        text += std::string(text.empty() ? "" : ", ") + format.title + " (";
        for (std::size_t i = 0; i < format.extensions.size(); ++i)
            text += std::string(i == 0 ? "." : ", .") + format.extensions[i];
        text += ")";
    }
    return text;
}

Result<void> checkFormatName(const ImportSettings &settings)
{
    if (settings.format == "auto")
        return {};
    return formatNamed(settings.format).map([](const CaptureFormat *) {});
}

Result<const CaptureFormat *> formatOf(const std::string &path, const ImportSettings &settings)
{
    const Result<std::string> head = headOf(path);
    if (!head)
        return tl::unexpected(head.error());
    if (settings.format != "auto")
        return formatNamed(settings.format);
    const CaptureFormat *best = nullptr;
    int bestScore = 0;
    for (const CaptureFormat &format : captureFormats()) {
        const int score = format.recognise(path, *head);
        if (score > bestScore) {
            bestScore = score;
            best = &format;
        }
    }
    constexpr int kCertain = 100;
    if (best == nullptr || (bestScore < kCertain && isForeignFile(*head)))
        return unknownFile(path, *head, readableFormatsText());
    return best;
}

} // namespace dyncal
