// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/reference/certified_source.h"

#include "core/base/number_text.h"
#include "core/reference/reference_csv.h"

#include <utility>

namespace dyncal {
namespace {

Result<void> checkFile(const CertifiedSource &source)
{
    if (!source.loaded)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "The file '%1' of %2.source could not be read; it is looked for from the folder of the recipe, or of the profile that names it. Put it there, or give its whole path."),
                {source.path, source.section}});
    if (source.sha256.empty() || source.sha256 == source.loaded->sha256)
        return {};
    return fail(ErrorKind::DataBlocked,
        {DYNCAL_TEXT("core",
             "The file '%1' has the hash %2, but %3.sha256 demands %4: it was changed, or it is another file. Restore it, or state the new hash."),
            {source.path, source.loaded->sha256, source.section, source.sha256}});
}

/// A certificate in XML begins with "<", a table with a name.
bool isXml(const std::string &content)
{
    constexpr const char *kBlankAndMark = " \t\r\n\xEF\xBB\xBF";
    const std::size_t first = content.find_first_not_of(kBlankAndMark);
    return first != content.npos && content[first] == '<';
}

Result<CertifiedReference> readContent(const CertifiedSource &source)
{
    const std::string &content = source.loaded->content;
    if (isXml(content))
        return readReferenceDcc(content, source.quantityId, source.unit);
    return readReferenceCsv(content).map([](ReferenceSensitivity sensitivity) {
        return CertifiedReference{std::move(sensitivity), {}};
    });
}

Result<CertifiedReference> withKnownU(CertifiedReference certified, const CertifiedSource &source)
{
    const std::optional<double> without_Hz
        = source.isRatio ? std::nullopt : certified.sensitivity.withoutU_Hz();
    if (!without_Hz)
        return certified;
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "An uncertainty at %1 Hz is 0, which counts as unknown; that of each magnitude and of each phase must be stated, above 0."),
            {numberText(*without_Hz, 6)}});
}

/// Both kinds of files have the same form, so only here it is known what they are of.
Error named(Error error, const CertifiedSource &source)
{
    error.message = {DYNCAL_TEXT("core", "The file '%1' of %2.source cannot be used. %M1"),
        {source.path, source.section}, {error.message}};
    return error;
}

} // namespace

Result<CertifiedReference> readCertifiedSource(const CertifiedSource &source)
{
    if (const Result<void> file = checkFile(source); !file)
        return tl::unexpected(file.error());
    const auto checked = [&source](CertifiedReference certified) {
        return withKnownU(std::move(certified), source);
    };
    return readContent(source).and_then(checked).map_error(
        [&source](Error error) { return named(std::move(error), source); });
}

} // namespace dyncal
