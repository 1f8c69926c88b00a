// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pdf/pdf_archive.h"

#include "core/signing/pdf_outline.h"

#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEFStreamObjectHelper.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <qpdf/QPDFFileSpecObjectHelper.hh>
#include <qpdf/QPDFWriter.hh>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace dyncal {
namespace {

using Object = QPDFObjectHandle;

Object dictionary()
{
    return Object::newDictionary();
}

/// Text as the PDF keeps it: by letters where Latin will do, else as UTF-16.
Object text(const std::string &utf8)
{
    return Object::newUnicodeString(utf8);
}

void checkAttachments(const std::vector<PdfAttachment> &attachments)
{
    std::set<std::string> names;
    for (const PdfAttachment &one : attachments) {
        if (one.name.empty() || one.name.find('/') != std::string::npos
            || !names.insert(one.name).second)
            throw std::invalid_argument("an attachment needs a name of its own");
        if (std::ranges::find(kPdfRelationships, one.relationship) == kPdfRelationships.end())
            throw std::invalid_argument("an attachment has no relationship to the document");
    }
}

/// The same as the XMP says (ISO 19005-3, 6.6.2.2 asks for no contradiction).
void setInformation(QPDF &pdf, const PdfMetadata &metadata)
{
    Object information = dictionary();
    const auto set = [&](const char *key, const std::string &value) {
        if (!value.empty())
            information.replaceKey(key, text(value));
    };
    set("/Title", metadata.title);
    set("/Author", metadata.author);
    set("/Creator", metadata.creator);
    set("/Producer", metadata.producer);
    for (const char *date : {"/CreationDate", "/ModDate"})
        information.replaceKey(date, Object::newString(pdfDate(metadata.createdUtc)));
    pdf.getTrailer().replaceKey("/Info", pdf.makeIndirectObject(information));
}

void setMetadata(QPDF &pdf, const PdfMetadata &metadata)
{
    Object stream = Object::newStream(&pdf, xmpOf(metadata));
    stream.getDict().replaceKey("/Type", Object::newName("/Metadata"));
    stream.getDict().replaceKey("/Subtype", Object::newName("/XML"));
    pdf.getRoot().replaceKey("/Metadata", stream);
}

void setOutputIntent(QPDF &pdf, const std::string &profile)
{
    constexpr int kRgb = 3;
    Object stream = Object::newStream(&pdf, profile);
    stream.getDict().replaceKey("/N", Object::newInteger(kRgb));
    Object intent = dictionary();
    intent.replaceKey("/Type", Object::newName("/OutputIntent"));
    intent.replaceKey("/S", Object::newName("/GTS_PDFA1"));
    for (const char *key : {"/OutputConditionIdentifier", "/Info"})
        intent.replaceKey(key, Object::newString("sRGB IEC61966-2.1"));
    intent.replaceKey("/RegistryName", Object::newString("http://www.color.org"));
    intent.replaceKey("/DestOutputProfile", stream);
    pdf.getRoot().replaceKey("/OutputIntents", Object::newArray({pdf.makeIndirectObject(intent)}));
}

void setReading(QPDF &pdf, const PdfMetadata &metadata)
{
    Object preferences = dictionary();
    preferences.replaceKey("/DisplayDocTitle", Object::newBool(true));
    pdf.getRoot().replaceKey("/ViewerPreferences", preferences);
    pdf.getRoot().replaceKey("/Lang", text(metadata.language));
}

Object bookmarkObject(const std::vector<Object> &pages, const PdfBookmark &bookmark, Object parent)
{
    Object item = dictionary();
    item.replaceKey("/Title", text(bookmark.title));
    item.replaceKey("/Parent", parent);
    item.replaceKey("/Dest",
        Object::newArray(
            {pages.at(static_cast<std::size_t>(bookmark.page)), Object::newName("/XYZ"),
                Object::newNull(), Object::newReal(bookmark.height_pt, 2), Object::newNull()}));
    return item;
}

void setBookmarks(QPDF &pdf, const std::vector<PdfBookmark> &bookmarks)
{
    if (bookmarks.empty())
        return;
    const std::vector<Object> &pages = pdf.getAllPages();
    Object outline = pdf.makeIndirectObject(dictionary());
    std::vector<Object> items;
    for (const PdfBookmark &bookmark : bookmarks)
        items.push_back(pdf.makeIndirectObject(bookmarkObject(pages, bookmark, outline)));
    for (std::size_t i = 1; i < items.size(); ++i) {
        items[i].replaceKey("/Prev", items[i - 1]);
        items[i - 1].replaceKey("/Next", items[i]);
    }
    outline.replaceKey("/Type", Object::newName("/Outlines"));
    outline.replaceKey("/First", items.front());
    outline.replaceKey("/Last", items.back());
    outline.replaceKey("/Count", Object::newInteger(static_cast<long long>(items.size())));
    pdf.getRoot().replaceKey("/Outlines", outline);
}

Object fileObject(QPDF &pdf, const PdfAttachment &attachment, const std::string &date)
{
    auto stream = QPDFEFStreamObjectHelper::createEFStream(pdf, attachment.bytes);
    stream.setSubtype(attachment.mime).setModDate(date);
    auto file = QPDFFileSpecObjectHelper::createFileSpec(pdf, attachment.name, stream);
    file.setDescription(attachment.description);
    Object object = file.getObjectHandle();
    object.replaceKey("/AFRelationship", Object::newName("/" + attachment.relationship));
    return object;
}

void attach(QPDF &pdf, const PdfArchive &archive)
{
    if (archive.attachments.empty())
        return;
    Object associated = Object::newArray();
    QPDFEmbeddedFileDocumentHelper files(pdf);
    const std::string date = pdfDate(archive.metadata.createdUtc);
    for (const PdfAttachment &attachment : archive.attachments) {
        const Object file = fileObject(pdf, attachment, date);
        files.replaceEmbeddedFile(attachment.name, QPDFFileSpecObjectHelper(file));
        associated.appendItem(file);
    }
    pdf.getRoot().replaceKey("/AF", associated);
}

/// As a named destination (ISO 32000-1, 12.3.2.3), in a tree of one leaf.
void setSignaturePlace(QPDF &pdf, const PdfPlace &place)
{
    std::vector<Object> destination{
        pdf.getAllPages().at(static_cast<std::size_t>(place.page)), Object::newName("/FitR")};
    for (const double part : {place.left_pt, place.bottom_pt, place.right_pt, place.top_pt})
        destination.push_back(Object::newReal(part, 2));
    Object tree = dictionary();
    tree.replaceKey("/Names",
        Object::newArray({Object::newString(kSignaturePlace), Object::newArray(destination)}));
    Object names = pdf.getRoot().getKey("/Names");
    if (!names.isDictionary())
        names = pdf.getRoot().replaceKeyAndGetNew("/Names", dictionary());
    names.replaceKey("/Dests", pdf.makeIndirectObject(tree));
}

/// Qt gives the subset's name to the descriptor only; ISO 32000-1, 9.8.1 wants it to be the font's.
void nameFonts(QPDF &pdf)
{
    for (Object font : pdf.getAllObjects()) {
        if (!font.isDictionary() || !font.getKey("/DescendantFonts").isArray())
            continue;
        Object descendant = font.getKey("/DescendantFonts").getArrayItem(0);
        Object name = descendant.getKey("/FontDescriptor").getKey("/FontName");
        if (!name.isName())
            continue;
        font.replaceKey("/BaseFont", name);
        descendant.replaceKey("/BaseFont", name);
    }
}

std::string written(QPDF &pdf)
{
    pdf.getTrailer().removeKey("/ID"); // made anew, of the content
    QPDFWriter writer(pdf);
    writer.setOutputMemory();
    writer.setMinimumPDFVersion("1.7");
    writer.setObjectStreamMode(qpdf_o_disable);
    writer.setNewlineBeforeEndstream(true); // ISO 19005-3, 6.1.7.1
    writer.setDeterministicID(true);
    writer.write();
    const auto buffer = writer.getBufferSharedPointer();
    return {reinterpret_cast<const char *>(buffer->getBuffer()), buffer->getSize()};
}

} // namespace

Result<std::string> withArchiveStructure(const std::string &bytes, const PdfArchive &archive)
try {
    checkAttachments(archive.attachments);
    QPDF pdf;
    pdf.setSuppressWarnings(true);
    pdf.setAttemptRecovery(false);
    pdf.processMemoryFile("the document as drawn", bytes.data(), bytes.size());
    nameFonts(pdf);
    setInformation(pdf, archive.metadata);
    setMetadata(pdf, archive.metadata);
    setOutputIntent(pdf, archive.colorProfile);
    setReading(pdf, archive.metadata);
    setBookmarks(pdf, archive.bookmarks);
    attach(pdf, archive);
    if (archive.signature)
        setSignaturePlace(pdf, *archive.signature);
    return written(pdf);
} catch (const std::exception &problem) {
    return fail(ErrorKind::Internal,
        {DYNCAL_TEXT("core",
             "The document was drawn, but what an archive asks of a PDF could not be added to it (%1); please report this."),
            {problem.what()}});
}

} // namespace dyncal
