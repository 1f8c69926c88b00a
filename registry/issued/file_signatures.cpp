// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/issued/file_signatures.h"

#include "core/base/ascii_text.h"
#include "core/signing/pdf_signature.h"
#include "core/signing/xml_verifying.h"
#include "registry/issued/issued_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace dyncal {
namespace {

namespace fs = std::filesystem;
using Status = SignatureCheck::Status;

constexpr std::uintmax_t kMostBytes = 256U * 1024U * 1024U;
constexpr std::size_t kBeginBytes = 1024; ///< in which a file says what it is
constexpr const char *kIssuedDcc = "dcc.xml";

Result<std::string> bytesOf(const std::string &path)
{
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    std::ifstream in(path, std::ios::binary);
    if (error || size > kMostBytes || !in)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "The signature of %1 cannot be looked at: the file cannot be read, or has more than %2 bytes."),
                {path, std::to_string(kMostBytes)}});
    return std::string(std::istreambuf_iterator<char>(in), {});
}

/// Both are signed in one go by one certificate; of others one came from elsewhere.
void holdSignersTogether(const SignatureCheck &dcc, SignatureCheck &check)
{
    if (dcc.certificate == check.certificate)
        return;
    check.status = Status::Changed;
    check.difference = Message{
        DYNCAL_TEXT("core",
            "%1 is signed by “%2”, %3 by “%4”, with another certificate: they were not issued together."),
        {kIssuedDcc, dcc.signer, kIssuedPdf, check.signer}};
}

/// The DCC's part, put into what is known of the PDF.
void addDcc(const SignatureCheck &dcc, SignatureCheck &check)
{
    if (dcc.status == Status::Unsigned) {
        if (check.status != Status::Unsigned)
            check.remarks.push_back(
                {DYNCAL_TEXT("core", "%1 has no signature of its own."), {kIssuedDcc}});
        return;
    }
    if (check.status == Status::Unsigned) {
        check.remarks.push_back(
            {DYNCAL_TEXT("core", "Only %1 is signed, %2 is not."), {kIssuedDcc, kIssuedPdf}});
    }
    for (const Message &remark : dcc.remarks)
        if (std::ranges::find(check.remarks, remark) == check.remarks.end())
            check.remarks.push_back(remark);
    if (dcc.status == Status::Changed) {
        check.status = Status::Changed;
        check.difference = Message{DYNCAL_TEXT("core", "The signature of %1 does not hold."),
            {kIssuedDcc}, {*dcc.difference}};
    } else if (check.status == Status::Valid) {
        check.status = dcc.status;
    }
    if (!check.certificate.empty() && !dcc.certificate.empty())
        holdSignersTogether(dcc, check);
}

/// By the first bytes, whatever the name says.
SignedKind kindByContent(const std::string &path)
{
    std::string begin(kBeginBytes, '\0');
    std::ifstream in(path, std::ios::binary);
    in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
    if (begin.find("%PDF-") != begin.npos) // readers look for it so far in
        return SignedKind::Pdf;
    const std::string_view mark = "\xEF\xBB\xBF";
    const std::size_t first
        = begin.find_first_not_of(" \t\r\n", begin.starts_with(mark) ? mark.size() : 0);
    const bool isXml = first != begin.npos && begin[first] == '<'
        && begin.find("digitalCalibrationCertificate") != begin.npos;
    return isXml ? SignedKind::Xml : SignedKind::None;
}

} // namespace

SignedKind signedKindOf(const std::string &path)
{
    if (const SignedKind kind = kindByContent(path); kind != SignedKind::None)
        return kind;
    const std::string ending = lowerCase(fs::path(path).extension().string());
    return ending == ".pdf" ? SignedKind::Pdf
        : ending == ".xml"  ? SignedKind::Xml
                            : SignedKind::None;
}

Result<SignatureCheck> checkFileSignature(const std::string &path, const TrustSettings &trust)
{
    const SignedKind kind = signedKindOf(path);
    if (kind == SignedKind::None)
        return SignatureCheck{};
    const Result<std::string> bytes = bytesOf(path);
    if (!bytes)
        return tl::unexpected<Error>(bytes.error());
    return kind == SignedKind::Pdf ? checkPdfSignature(*bytes, trust)
                                   : checkXmlSignature(*bytes, trust);
}

SignatureCheck checkFolderSignatures(const std::string &folder, const TrustSettings &trust)
{
    const auto checked = [&](const char *name, const TrustSettings &settings) {
        return checkFileSignature((fs::path(folder) / name).string(), settings);
    };
    SignatureCheck check = checked(kIssuedPdf, trust).value_or(SignatureCheck{});
    TrustSettings then = trust; // the PDF carries the DCC: its time stamp is of both signatures
    if (check.status == Status::Valid && !check.stampedUtc.empty())
        then.utc = check.stampedUtc;
    if (const Result<SignatureCheck> dcc = checked(kIssuedDcc, then); dcc && !check.difference)
        addDcc(*dcc, check);
    return check;
}

} // namespace dyncal
