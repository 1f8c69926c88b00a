// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/pdf_signature.h"

#include "core/base/content_hash.h"
#include "core/signing/cms_signature.h"
#include "core/signing/pdf_signature_field.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>

namespace dyncal {
namespace {

using std::string_view;

constexpr string_view kRange = "/ByteRange";
/// What a PDF with a signature has, also when the names of its keys were damaged.
constexpr std::array<string_view, 5> kTraces{
    kRange, "/Adobe.PPKLite", "ETSI.CAdES.detached", "adbe.pkcs7.", "/FT/Sig"};

std::span<const std::byte> bytesOf(string_view text)
{
    return std::as_bytes(std::span(text));
}

std::string hexOf(string_view bytes)
{
    constexpr string_view kDigits = "0123456789abcdef";
    std::string hex;
    for (const char c : bytes) {
        const auto value = static_cast<unsigned char>(c);
        hex += kDigits[value / kDigits.size()];
        hex += kDigits[value % kDigits.size()];
    }
    return hex;
}

std::string fromHex(string_view digits)
{
    std::string bytes;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
        unsigned value = 0;
        std::from_chars(digits.data() + i, digits.data() + i + 2, value, 16);
        bytes += static_cast<char>(value);
    }
    return bytes;
}

/// Bytes of the DER value that begins here, by its own length; 0 where it is none.
std::size_t derSize(string_view der)
{
    constexpr unsigned char kSequence = 0x30, kLong = 0x80;
    if (der.size() < 2 || static_cast<unsigned char>(der[0]) != kSequence)
        return 0;
    const auto length = static_cast<unsigned char>(der[1]);
    const std::size_t more = length < kLong ? 0 : length - kLong;
    if (more > 4 || der.size() < 2 + more)
        return 0;
    std::size_t size = more == 0 ? length : 0;
    for (std::size_t i = 0; i < more; ++i)
        size = size * 256 + static_cast<unsigned char>(der[2 + i]);
    return 2 + more + size <= der.size() ? 2 + more + size : 0;
}

/// The last signature of a file: what it covers, and its dictionary.
struct FoundSignature : PdfSignaturePlace
{
    string_view dictionary;
};

/// Four numbers in brackets: from the beginning to the hole, and from behind the hole on.
std::optional<FoundSignature> rangeAt(string_view text)
{
    std::array<std::size_t, 4> numbers{};
    string_view rest = text.substr(kRange.size());
    const auto skip
        = [&] { rest.remove_prefix(std::min(rest.find_first_not_of(" \r\n\t"), rest.size())); };
    skip();
    if (!rest.starts_with('['))
        return std::nullopt;
    rest.remove_prefix(1);
    for (std::size_t &number : numbers) {
        skip();
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
        if (error != std::errc())
            return std::nullopt;
        rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    }
    skip();
    const bool isSound = rest.starts_with(']') && numbers[0] == 0 && numbers[1] < numbers[2]
        && numbers[3] <= SIZE_MAX - numbers[2];
    return isSound
        ? std::optional(FoundSignature{{numbers[1], numbers[2], numbers[2] + numbers[3]}, {}})
        : std::nullopt;
}

std::optional<FoundSignature> lastSignature(string_view pdf)
{
    const std::size_t place = pdf.rfind(kRange);
    if (place == pdf.npos)
        return std::nullopt;
    std::optional<FoundSignature> found = rangeAt(pdf.substr(place));
    if (!found)
        return std::nullopt;
    const std::size_t object = pdf.rfind(" obj", place), end = pdf.find("endobj", place);
    const std::size_t begin = object == pdf.npos ? place : object;
    found->dictionary = pdf.substr(begin, std::min(end, pdf.size()) - begin);
    return found;
}

bool isTrace(string_view pdf)
{
    return std::ranges::any_of(
        kTraces, [&](string_view trace) { return pdf.find(trace) != pdf.npos; });
}

/// CMS in the hole; empty where it holds anything else.
std::string cmsIn(string_view pdf, const FoundSignature &found)
{
    if (found.holeEnd > pdf.size() || found.holeEnd - found.holeBegin < 4)
        return {};
    const string_view hole = pdf.substr(found.holeBegin, found.holeEnd - found.holeBegin);
    const string_view digits = hole.substr(1, hole.size() - 2);
    if (!hole.starts_with('<') || !hole.ends_with('>')
        || digits.find_first_not_of("0123456789abcdefABCDEF") != digits.npos)
        return {};
    std::string bytes = fromHex(digits);
    const std::size_t size = derSize(bytes);
    if (size == 0 || digits.find_first_not_of('0', 2 * size) != digits.npos)
        return {};
    bytes.resize(size);
    return bytes;
}

/// "2026-01-31T04:23:11Z" of /M of the dictionary, where it is in UTC; else empty.
std::string statedMoment(string_view dictionary)
{
    constexpr string_view kDate = "D:00000000000000Z";
    const std::size_t key = std::min(dictionary.find("/M("), dictionary.find("/M ("));
    const std::size_t open = key == dictionary.npos ? key : dictionary.find('(', key);
    if (open == dictionary.npos || dictionary.size() < open + 1 + kDate.size())
        return {};
    const std::string date(dictionary.substr(open + 1, kDate.size()));
    for (std::size_t i = 0; i < kDate.size(); ++i)
        if (kDate[i] == '0' ? date[i] < '0' || date[i] > '9' : date[i] != kDate[i])
            return {};
    return date.substr(2, 4) + '-' + date.substr(6, 2) + '-' + date.substr(8, 2) + 'T'
        + date.substr(10, 2) + ':' + date.substr(12, 2) + ':' + date.substr(14, 2) + 'Z';
}

SignatureCheck changed(Message difference)
{
    return {.status = SignatureCheck::Status::Changed, .difference = std::move(difference)};
}

/// Beside the last signature: an update may have brought one that covers what another changed.
bool hasEarlierRange(string_view pdf)
{
    return pdf.find(kRange) != pdf.rfind(kRange);
}

Message notCovered(const FoundSignature &found, std::size_t size)
{
    if (found.end < size)
        return {
            DYNCAL_TEXT("core",
                "The signature of the PDF ends at byte %1, and the file has %2: something was added behind it."),
            {std::to_string(found.end), std::to_string(size)}};
    return {DYNCAL_TEXT("core",
                "The signature of the PDF covers %1 bytes, and the file has %2: it was cut off."),
        {std::to_string(found.end), std::to_string(size)}};
}

} // namespace

Result<std::string> signedPdf(
    const std::string &pdf, const PdfSignatureWords &words, const CmsOfHash &cmsOf)
{
    Result<UnsignedIncrement> update = withSignatureField(pdf, words);
    if (!update)
        return tl::unexpected<Error>(update.error());
    if (hasEarlierRange(update->bytes))
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "The PDF cannot be signed: a text in it has %1, by which signatures are found; take it out of the certificate's texts."),
                {std::string(kRange)}});
    const string_view all = update->bytes;
    Sha256 hash;
    hash.add(bytesOf(all.substr(0, update->holeBegin)));
    hash.add(bytesOf(all.substr(update->holeEnd)));
    const Result<std::string> cms = cmsOf(hash.hex());
    if (!cms)
        return cms;
    if (cms->size() > kCmsRoom)
        return fail(ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "The signature has %1 bytes with its certificates and time stamp, and the PDF has room for %2; leave certificates out that are not needed."),
                {std::to_string(cms->size()), std::to_string(kCmsRoom)}});
    const std::string digits = hexOf(*cms);
    update->bytes.replace(update->holeBegin + 1, digits.size(), digits);
    return std::move(update->bytes);
}

SignatureCheck checkPdfSignature(string_view pdf, const TrustSettings &trust)
{
    const std::optional<FoundSignature> found = lastSignature(pdf);
    if (!found && !isTrace(pdf))
        return {};
    if (!found)
        return changed({DYNCAL_TEXT("core", "The signature of the PDF is damaged."), {}});
    if (found->end != pdf.size())
        return changed(notCovered(*found, pdf.size()));
    if (hasEarlierRange(pdf))
        return changed(severalSignatures());
    const std::string cms = cmsIn(pdf, *found);
    if (cms.empty())
        return changed(
            {DYNCAL_TEXT("core", "The signature of the PDF, in bytes %1 to %2, is damaged."),
                {std::to_string(found->holeBegin), std::to_string(found->holeEnd)}});
    SignatureCheck check
        = checkCms(cms, {pdf.substr(0, found->holeBegin), pdf.substr(found->holeEnd)},
            statedMoment(found->dictionary), trust);
    if (check.difference)
        check.difference->below.push_back(
            {DYNCAL_TEXT("core", "Signed are the bytes 0 to %1 and %2 to %3 of the PDF."),
                {std::to_string(found->holeBegin), std::to_string(found->holeEnd),
                    std::to_string(found->end)}});
    else if (std::optional<Message> fault = faultOfField(pdf, *found))
        return changed(std::move(*fault));
    return check;
}

string_view unsignedRevision(string_view pdf)
{
    constexpr string_view kEnd = "%%EOF\n";
    const std::size_t signature = pdf.rfind(kRange);
    const std::size_t end = signature == pdf.npos ? signature : pdf.rfind(kEnd, signature);
    return end == pdf.npos ? pdf : pdf.substr(0, end + kEnd.size());
}

} // namespace dyncal
