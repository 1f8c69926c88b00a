// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/pdf_outline.h"

#define POINTERHOLDER_TRANSITION 4 // qpdf asks for a choice; this one has no PointerHolder
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFNameTreeObjectHelper.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QUtil.hh>

#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace dyncal {
namespace {

/// Where the last cross-reference table begins, by the file's end; 0 where it is none of the
/// classic kind.
std::size_t lastTable(const std::string &pdf)
{
    constexpr std::string_view kStart = "startxref";
    const std::size_t start = pdf.rfind(kStart);
    if (start == pdf.npos)
        return 0;
    const std::size_t place = std::strtoull(pdf.c_str() + start + kStart.size(), nullptr, 10);
    return place < start && pdf.compare(place, 4, "xref") == 0 ? place : 0;
}

QPDFObjectHandle listWith(QPDF &pdf, QPDFObjectHandle list, const std::string &reference)
{
    std::string text = "[";
    if (list.isArray())
        for (const QPDFObjectHandle &one : list.getArrayAsVector())
            text += const_cast<QPDFObjectHandle &>(one).unparse() + ' ';
    return QPDFObjectHandle::parse(&pdf, text + reference + ']');
}

bool hasSignature(QPDFObjectHandle form)
{
    const int flags = form.isDictionary() && form.getKey("/SigFlags").isInteger()
        ? form.getKey("/SigFlags").getIntValueAsInt()
        : 0;
    return (flags & 1) != 0;
}

/// The form (12.7.2) with one field more, which is a signature.
QPDFObjectHandle formWith(QPDF &pdf, QPDFObjectHandle form, const std::string &field)
{
    QPDFObjectHandle copy
        = form.isDictionary() ? form.shallowCopy() : QPDFObjectHandle::newDictionary();
    copy.replaceKey("/Fields", listWith(pdf, copy.getKey("/Fields"), field));
    copy.replaceKey("/SigFlags", QPDFObjectHandle::newInteger(3));
    return copy;
}

std::string trailerRest(QPDFObjectHandle trailer)
{
    std::string rest;
    for (const char *key : {"/Info", "/ID"})
        if (trailer.hasKey(key))
            rest += key + (' ' + trailer.getKey(key).unparse());
    return rest;
}

/// The first free number (7.5.5). Where /Size does not say it, a new object would take the place of
/// one that is there; catalog and page must be objects of the file, because they are replaced.
int checkedSize(QPDF &pdf, int last, const QPDFObjectHandle &root, const QPDFObjectHandle &page)
{
    constexpr int kMostObjects = 8388607; // annex C.2
    const int size = pdf.getTrailer().getKey("/Size").getIntValueAsInt();
    const auto isThere = [&](int object) { return object > 0 && object <= last; };
    if (last >= size || size > kMostObjects || !isThere(root.getObjectID())
        || !isThere(page.getObjectID()) || !QPDFObjectHandle(page).isDictionary())
        throw std::out_of_range("/Size");
    return size;
}

/// The destination kSignaturePlace (12.3.2.3), if it is one of a page with a rectangle; else null.
QPDFObjectHandle placeIn(QPDF &pdf)
{
    QPDFObjectHandle names = pdf.getRoot().getKey("/Names");
    QPDFObjectHandle tree = names.isDictionary() ? names.getKey("/Dests") : names;
    if (!tree.isDictionary())
        return QPDFObjectHandle::newNull();
    QPDFObjectHandle place = QPDFObjectHandle::newNull();
    QPDFNameTreeObjectHelper(tree, pdf, false).findObject(kSignaturePlace, place);
    constexpr int kParts = 6; // page /FitR left bottom right top
    bool isPlace = place.isArray() && place.getArrayNItems() == kParts
        && place.getArrayItem(0).isPageObject() && place.getArrayItem(1).isName()
        && place.getArrayItem(1).getName() == "/FitR";
    for (int i = 2; isPlace && i < kParts; ++i)
        isPlace = place.getArrayItem(i).isNumber();
    return isPlace ? place : QPDFObjectHandle::newNull();
}

/// "[57 90 538 140]".
std::string rectangleOf(QPDFObjectHandle place)
{
    std::string text;
    for (int i = 2; i < place.getArrayNItems(); ++i)
        text += (text.empty() ? "[" : " ") + place.getArrayItem(i).unparse();
    return text + ']';
}

PdfOutline outlineIn(QPDF &pdf, const std::function<PdfAdditions(int)> &added)
{
    PdfOutline outline;
    const int last = static_cast<int>(pdf.getObjectCount()); // before a page in a list gets one
    QPDFObjectHandle root = pdf.getRoot(), page = pdf.getAllPages().at(0);
    if (QPDFObjectHandle place = placeIn(pdf); place.isArray()) {
        page = place.getArrayItem(0);
        outline.rectangle = rectangleOf(place);
    }
    outline.size = checkedSize(pdf, last, root, page);
    const PdfAdditions additions = added(outline.size);
    outline.root = root.getObjectID();
    outline.rootGeneration = root.getGeneration();
    outline.page = page.getObjectID();
    outline.pageGeneration = page.getGeneration();
    outline.rootReference = root.unparse();
    outline.pageReference = page.unparse();
    outline.trailerRest = trailerRest(pdf.getTrailer());
    root.replaceKey("/AcroForm", formWith(pdf, root.getKey("/AcroForm"), additions.field));
    page.replaceKey("/Annots", listWith(pdf, page.getKey("/Annots"), additions.annotation));
    outline.rootContent = root.unparseResolved();
    outline.pageContent = page.unparseResolved();
    return outline;
}

} // namespace

Result<PdfOutline> outlineOf(
    const std::string &bytes, const std::function<PdfAdditions(int)> &added)
{
    const std::size_t table = lastTable(bytes);
    if (table == 0)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "The PDF cannot be signed: it does not end with a cross-reference table of the classic kind; sign it as Dyncal wrote it."),
                {}});
    try {
        QPDF pdf;
        pdf.setSuppressWarnings(true);
        pdf.setAttemptRecovery(false);
        pdf.processMemoryFile("certificate", bytes.data(), bytes.size());
        if (pdf.isEncrypted())
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "The PDF cannot be signed: it is encrypted; sign it as Dyncal wrote it."),
                    {}});
        if (hasSignature(pdf.getRoot().getKey("/AcroForm")))
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "The PDF cannot be signed: it has a signature already; sign it as Dyncal wrote it."),
                    {}});
        PdfOutline outline = outlineIn(pdf, added);
        outline.table = table;
        return outline;
    } catch (const std::exception &) { // qpdf's own, and of a missing page
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT(
                 "core", "The PDF cannot be signed: it is damaged; sign it as Dyncal wrote it."),
                {}});
    }
}

std::string pdfTextString(const std::string &utf8)
{
    // qpdf would write Latin letters as they are, and a name must never look like a key of the PDF.
    return QPDFObjectHandle::newString(QUtil::utf8_to_utf16(utf8)).unparseBinary();
}

} // namespace dyncal
