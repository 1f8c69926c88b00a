// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/pdf_signature_field.h"

#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QUtil.hh>

#include <array>
#include <deque>
#include <exception>
#include <set>
#include <vector>

namespace dyncal {
namespace {

using Object = QPDFObjectHandle;

/// As many as are read of anybody's PDF (core/pdf).
constexpr std::size_t kMostObjects = 100000;

Message notTheFields()
{
    return {
        DYNCAL_TEXT("core",
            "The signature that covers the PDF is not that of the one signature field in its form: the PDF was changed after it was signed, or signed in another way than a certificate is."),
        {}};
}

bool isName(Object object, const char *name)
{
    return object.isName() && object.getName() == name;
}

bool isSignatureField(Object object)
{
    return isName(object.getKey("/FT"), "/Sig");
}

bool isSignature(Object object)
{
    return object.hasKey("/ByteRange") || isName(object.getKey("/Type"), "/Sig")
        || isName(object.getKey("/Type"), "/DocTimeStamp");
}

/// The signature fields in the form, at any depth.
std::vector<Object> fieldsOfForm(QPDF &pdf)
{
    std::vector<Object> found;
    std::set<QPDFObjGen> seen;
    Object form = pdf.getRoot().getKey("/AcroForm");
    std::deque<Object> open{form.isDictionary() ? form.getKey("/Fields") : form};
    while (!open.empty()) {
        Object one = open.front();
        open.pop_front();
        if (one.isIndirect() && !seen.insert(one.getObjGen()).second)
            continue;
        if (one.isArray())
            for (const Object &item : one.getArrayAsVector())
                open.push_back(item);
        if (!one.isDictionary())
            continue;
        if (isSignatureField(one))
            found.push_back(one);
        open.push_back(one.getKey("/Kids"));
    }
    return found;
}

/// Objects of the file that are signatures, or fields of signatures.
struct SignatureObjects
{
    std::vector<Object> signatures, fields;
};

SignatureObjects objectsOf(QPDF &pdf)
{
    SignatureObjects found;
    for (Object object : pdf.getAllObjects()) {
        if (!object.isDictionary())
            continue;
        if (isSignature(object))
            found.signatures.push_back(object);
        if (isSignatureField(object))
            found.fields.push_back(object);
    }
    return found;
}

bool isSame(const Object &one, const Object &other)
{
    return one.isIndirect() && one.getObjGen() == other.getObjGen();
}

bool hasRange(Object signature, const PdfSignaturePlace &place)
{
    const std::array<std::size_t, 4> wanted{
        0, place.holeBegin, place.holeEnd, place.end - place.holeEnd};
    Object range = signature.getKey("/ByteRange");
    if (!range.isArray() || range.getArrayNItems() != static_cast<int>(wanted.size()))
        return false;
    for (int i = 0; i < static_cast<int>(wanted.size()); ++i) {
        Object number = range.getArrayItem(i);
        if (!number.isInteger()
            || number.getIntValue() != static_cast<long long>(wanted[static_cast<std::size_t>(i)]))
            return false;
    }
    return true;
}

/// The hole is where these contents stand, and not another string of hexadecimal digits.
bool hasContents(Object signature, std::string_view pdf, const PdfSignaturePlace &place)
{
    Object contents = signature.getKey("/Contents");
    const std::string digits(pdf.substr(place.holeBegin + 1, place.holeEnd - place.holeBegin - 2));
    return contents.isString() && !contents.isIndirect()
        && contents.getParsedOffset() == static_cast<qpdf_offset_t>(place.holeBegin)
        && contents.getStringValue() == QUtil::hex_decode(digits);
}

std::optional<Message> faultIn(QPDF &pdf, std::string_view bytes, const PdfSignaturePlace &place)
{
    const std::vector<Object> shown = fieldsOfForm(pdf);
    const SignatureObjects all = objectsOf(pdf);
    if (shown.size() > 1 || all.signatures.size() > 1 || all.fields.size() > 1)
        return severalSignatures();
    if (shown.empty() || all.signatures.empty() || all.fields.empty())
        return notTheFields();
    Object value = Object(shown.front()).getKey("/V");
    const bool isShown = isSame(shown.front(), all.fields.front())
        && isSame(value, all.signatures.front()) && hasRange(value, place)
        && hasContents(value, bytes, place);
    return isShown ? std::nullopt : std::optional(notTheFields());
}

} // namespace

Message severalSignatures()
{
    return {
        DYNCAL_TEXT("core",
            "The PDF has more than one signature or signature field, and a certificate has one: something was added to it after it was signed."),
        {}};
}

std::optional<Message> faultOfField(std::string_view bytes, const PdfSignaturePlace &place)
try {
    QPDF pdf;
    pdf.setSuppressWarnings(true);
    pdf.setAttemptRecovery(false);
    pdf.setIgnoreXRefStreams(true);
    pdf.processMemoryFile("certificate", bytes.data(), bytes.size());
    if (pdf.isEncrypted() || pdf.getXRefTable().size() > kMostObjects)
        return notTheFields();
    return faultIn(pdf, bytes, place);
} catch (const std::exception &) {
    return Message{
        DYNCAL_TEXT("core",
            "The PDF around its signature cannot be read: it is damaged, or written in another form than certificates are."),
        {}};
}

} // namespace dyncal
