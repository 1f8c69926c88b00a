// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/issued/file_signatures.h"

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
    } else if (!dcc.signer.empty() && dcc.signer != check.signer) {
        check.remarks.push_back({DYNCAL_TEXT("core", "%1 is signed by “%2”, %3 by “%4”."),
            {kIssuedDcc, dcc.signer, kIssuedPdf, check.signer}});
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
}

} // namespace

Result<SignatureCheck> checkFileSignature(const std::string &path, const TrustSettings &trust)
{
    const std::string ending = fs::path(path).extension().string();
    if (ending != ".pdf" && ending != ".xml")
        return SignatureCheck{};
    const Result<std::string> bytes = bytesOf(path);
    if (!bytes)
        return tl::unexpected<Error>(bytes.error());
    return ending == ".pdf" ? checkPdfSignature(*bytes, trust) : checkXmlSignature(*bytes, trust);
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
