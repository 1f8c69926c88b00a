// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/file_kind.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

using std::string_view_literals::operator""sv;

struct KnownKind
{
    std::string_view signature; ///< first bytes of such a file
    const char *sentence;
};

constexpr const char *kMatlab = DYNCAL_TEXT("core",
    "%1 is a MATLAB file, which this version does not read; write the samples as CSV or HDF5 capture. Readable are: %2.");

constexpr std::array kKinds{
    KnownKind{"%PDF"sv,
        DYNCAL_TEXT("core", "%1 is not a recording: it is a PDF document. Readable are: %2.")},
    KnownKind{"PK\x03\x04"sv,
        DYNCAL_TEXT("core",
            "%1 is not a recording: it is a ZIP archive or an office document; unpack it, or save the sheet as CSV. Readable are: %2.")},
    KnownKind{"\xD0\xCF\x11\xE0"sv,
        DYNCAL_TEXT("core",
            "%1 is not a recording: it is an old office document; save the sheet as CSV. Readable are: %2.")},
    KnownKind{"\x89PNG"sv,
        DYNCAL_TEXT("core", "%1 is not a recording: it is a PNG picture. Readable are: %2.")},
    KnownKind{"\xFF\xD8\xFF"sv,
        DYNCAL_TEXT("core", "%1 is not a recording: it is a JPEG picture. Readable are: %2.")},
    KnownKind{"GIF8"sv,
        DYNCAL_TEXT("core", "%1 is not a recording: it is a GIF picture. Readable are: %2.")},
    KnownKind{"\x1F\x8B"sv,
        DYNCAL_TEXT("core", "%1 is a compressed file (gzip); unpack it first. Readable are: %2.")},
    KnownKind{"7z\xBC\xAF"sv,
        DYNCAL_TEXT("core", "%1 is a 7-Zip archive; unpack it first. Readable are: %2.")},
    KnownKind{"MATLAB 5.0 MAT-file"sv,
        DYNCAL_TEXT("core",
            "%1 begins like a MATLAB file, but its header is cut or damaged; copy it again. Readable are: %2.")},
    KnownKind{"MATLAB 7.3 MAT-file"sv, kMatlab},
    KnownKind{"RIFF"sv,
        DYNCAL_TEXT("core",
            "%1 is a RIFF file but no WAV (a video, a sound font, a picture) or a cut one. Readable are: %2.")},
    KnownKind{"\x7F"
              "ELF"sv,
        DYNCAL_TEXT("core", "%1 is not a recording: it is a program. Readable are: %2.")},
};

constexpr const char *kEmpty
    = DYNCAL_TEXT("core", "%1 is empty; copy it again or record anew. Readable are: %2.");
constexpr const char *kText = DYNCAL_TEXT(
    "core", "%1 is not a recording: it is a text without rows of numbers. Readable are: %2.");
constexpr const char *kBinary = DYNCAL_TEXT("core",
    "%1 is not a recording that can be read: it is a binary file of unknown kind. Readable are: %2.");

const KnownKind *knownKind(std::string_view head)
{
    const auto known = std::find_if(kKinds.begin(), kKinds.end(),
        [&](const KnownKind &kind) { return head.starts_with(kind.signature); });
    return known != kKinds.end() ? &*known : nullptr;
}

const char *sentenceFor(std::string_view head)
{
    if (head.empty())
        return kEmpty;
    if (const KnownKind *known = knownKind(head))
        return known->sentence;
    return isPlainText(head) ? kText : kBinary;
}

} // namespace

bool isForeignFile(std::string_view head)
{
    return knownKind(head) != nullptr;
}

bool isPlainText(std::string_view text)
{
    return std::none_of(text.begin(), text.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f';
    });
}

tl::unexpected<Error> unknownFile(
    const std::string &path, std::string_view head, const std::string &readable)
{
    return fail(ErrorKind::FileUnreadable, {sentenceFor(head), {path, readable}}, "CAP-001");
}

} // namespace dyncal
