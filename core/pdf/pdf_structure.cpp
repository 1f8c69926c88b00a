// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pdf/pdf_structure.h"

#include "core/pdf/pdf_streams.h"

#include <qpdf/QPDF.hh>

#include <algorithm>
#include <array>
#include <deque>

namespace dyncal {
namespace {

using Object = QPDFObjectHandle;

constexpr std::size_t kMostObjects = 100000; // some two seconds and 200 MB
constexpr std::size_t kMostFiles = 1000;
constexpr std::size_t kMostBookmarks = 10000;

/// Actions that ISO 19005-3, 6.5.1 forbids.
constexpr std::array<std::string_view, 11> kForbiddenActions{"/Launch", "/Sound", "/Movie",
    "/ResetForm", "/ImportData", "/Hide", "/SetOCGState", "/Rendition", "/Trans", "/GoTo3DView",
    "/JavaScript"};

std::string textOf(Object object)
{
    return object.isString() ? object.getUTF8Value() : std::string();
}

std::string nameOf(Object object)
{
    return object.isName() ? object.getName().substr(1) : std::string();
}

Object keyOf(Object object, const char *key)
{
    return object.isDictionary() ? object.getKey(key)
        : object.isStream()      ? object.getDict().getKey(key)
                                 : Object::newNull();
}

bool isName(Object object, const char *name)
{
    return object.isName() && object.getName() == name;
}

// ---- the first lines ----

void readHeader(const std::string &pdf, PdfStructure &read)
{
    const std::size_t end = std::min(pdf.find_first_of("\r\n"), pdf.size());
    read.header = pdf.substr(0, std::min<std::size_t>(end, 20));
    const std::size_t mark = pdf.find('%', end);
    constexpr std::size_t kMarkBytes = 4;
    read.isMarkedBinary = mark <= end + 2 && mark + kMarkBytes < pdf.size()
        && std::all_of(pdf.begin() + static_cast<std::ptrdiff_t>(mark) + 1,
            pdf.begin() + static_cast<std::ptrdiff_t>(mark + 1 + kMarkBytes),
            [](char c) { return static_cast<unsigned char>(c) > 127; });
}

// ---- every object ----

/// What one dictionary says that an archive may not hold.
void readForbidden(Object dictionary, std::set<std::string> &forbidden)
{
    for (const char *key : {"/JS", "/AA", "/XFA", "/Alternates", "/OPI", "/Ref", "/TR", "/HTP"})
        if (dictionary.hasKey(key))
            forbidden.insert(key);
    const std::string action = dictionary.hasKey("/S") ? nameOf(dictionary.getKey("/S")) : "";
    if (std::ranges::find(kForbiddenActions, "/" + action) != kForbiddenActions.end())
        forbidden.insert("/" + action);
    Object interpolate = dictionary.getKey("/Interpolate");
    if (interpolate.isBool() && interpolate.getBoolValue())
        forbidden.insert("/Interpolate");
    if (isName(dictionary.getKey("/Subtype"), "/PS"))
        forbidden.insert("/PS");
}

void readFilters(Object dictionary, std::set<std::string> &forbidden)
{
    Object filter = dictionary.getKey("/Filter");
    for (Object one : filter.isArray() ? filter.getArrayAsVector() : std::vector<Object>{filter})
        if (isName(one, "/LZWDecode") || isName(one, "/Crypt"))
            forbidden.insert(one.getName());
    for (const char *key : {"/F", "/FFilter", "/FDecodeParms"})
        if (dictionary.hasKey(key))
            forbidden.insert(std::string("stream with ") + key);
}

void readFont(Object font, std::set<std::string> &notEmbedded)
{
    const std::string kind = nameOf(font.getKey("/Subtype"));
    if (kind == "Type3") // drawn by its own content
        return;
    bool isEmbedded = false;
    if (kind == "Type0") {
        Object descendants = font.getKey("/DescendantFonts");
        isEmbedded = descendants.isArray() && descendants.getArrayNItems() == 1
            && isName(keyOf(descendants.getArrayItem(0), "/Type"), "/Font");
    } else {
        for (const char *key : {"/FontFile", "/FontFile2", "/FontFile3"})
            isEmbedded = isEmbedded || keyOf(font.getKey("/FontDescriptor"), key).isStream();
    }
    if (!isEmbedded)
        notEmbedded.insert(nameOf(font.getKey("/BaseFont")));
}

/// Looks at an object and at all inside it, but not at those it refers to: they come by themselves.
void readObject(Object object, PdfStructure &read)
{
    std::deque<Object> open{object};
    while (!open.empty()) {
        Object one = open.front();
        open.pop_front();
        if (one.isArray())
            for (Object item : one.getArrayAsVector())
                if (!item.isIndirect())
                    open.push_back(item);
        if (one.isStream()) {
            one = one.getDict();
            readFilters(one, read.forbidden);
        }
        if (!one.isDictionary())
            continue;
        readForbidden(one, read.forbidden);
        if (isName(one.getKey("/Type"), "/Font"))
            readFont(one, read.fontsNotEmbedded);
        for (auto &[key, value] : one.getDictAsMap())
            if (!value.isIndirect())
                open.push_back(value);
    }
}

// ---- the catalog ----

void readInformation(Object information, PdfStructure &read)
{
    if (information.isDictionary())
        for (auto [key, value] : information.getDictAsMap())
            if (value.isString())
                read.information[key] = value.getUTF8Value();
}

void readIntents(Object catalog, UnpackingBudget &budget, PdfStructure &read)
{
    Object intents = keyOf(catalog, "/OutputIntents");
    if (!intents.isArray())
        return;
    for (const Object &intent : intents.getArrayAsVector()) {
        if (!isName(keyOf(intent, "/S"), "/GTS_PDFA1") || read.outputIntents.size() == kMostFiles)
            continue;
        Object profile = keyOf(intent, "/DestOutputProfile");
        read.outputIntents.push_back(budget.unpack(profile).value_or(std::string()));
    }
}

void readBookmarks(Object catalog, PdfStructure &read)
{
    Object item = keyOf(keyOf(catalog, "/Outlines"), "/First");
    for (; item.isDictionary() && read.bookmarks.size() < kMostBookmarks;
         item = item.getKey("/Next"))
        read.bookmarks.push_back(textOf(item.getKey("/Title")));
}

PdfFile readFile(Object specification, UnpackingBudget &budget)
{
    PdfFile file;
    file.attachment.name = textOf(specification.getKey("/UF"));
    file.plainName = textOf(specification.getKey("/F"));
    file.attachment.description = textOf(specification.getKey("/Desc"));
    file.attachment.relationship = nameOf(specification.getKey("/AFRelationship"));
    Object stream = keyOf(specification.getKey("/EF"), "/F");
    file.attachment.mime = nameOf(keyOf(stream, "/Subtype"));
    Object parameters = keyOf(stream, "/Params");
    file.modified = textOf(keyOf(parameters, "/ModDate"));
    if (Object size = keyOf(parameters, "/Size"); size.isInteger())
        file.statedSize = size.getIntValue();
    if (Object sum = keyOf(parameters, "/CheckSum"); sum.isString())
        file.statedChecksum = sum.getStringValue();
    if (std::optional<std::string> bytes = budget.unpack(stream)) {
        file.isUnpacked = true;
        file.checksum = md5Of(*bytes);
        file.attachment.bytes = std::move(*bytes);
    }
    return file;
}

/// File specifications of the tree of embedded files, at most kMostFiles.
std::vector<Object> namedFiles(Object catalog)
{
    std::vector<Object> found;
    std::set<QPDFObjGen> seen;
    std::deque<Object> open{keyOf(keyOf(catalog, "/Names"), "/EmbeddedFiles")};
    while (!open.empty() && found.size() < kMostFiles) {
        Object node = open.front();
        open.pop_front();
        if (node.isIndirect() && !seen.insert(node.getObjGen()).second)
            continue;
        Object names = keyOf(node, "/Names"), kids = keyOf(node, "/Kids");
        if (names.isArray())
            for (int i = 1; i < names.getArrayNItems() && found.size() < kMostFiles; i += 2)
                found.push_back(names.getArrayItem(i));
        if (kids.isArray())
            for (Object kid : kids.getArrayAsVector())
                if (kid.isIndirect()) // so that a loop is seen
                    open.push_back(kid);
    }
    return found;
}

std::vector<Object> associatedFiles(Object catalog)
{
    Object list = keyOf(catalog, "/AF");
    std::vector<Object> files = list.isArray() ? list.getArrayAsVector() : std::vector<Object>();
    files.resize(std::min(files.size(), kMostFiles));
    return files;
}

bool isSame(Object one, Object other)
{
    return one.isIndirect() && one.getObjGen() == other.getObjGen();
}

void readFiles(Object catalog, UnpackingBudget &budget, PdfStructure &read)
{
    const std::vector<Object> associated = associatedFiles(catalog), named = namedFiles(catalog);
    const auto isIn = [](const std::vector<Object> &list, const Object &file) {
        return std::ranges::any_of(list, [&](const Object &one) { return isSame(file, one); });
    };
    std::vector<Object> all = associated;
    for (const Object &file : named)
        if (!isIn(associated, file))
            all.push_back(file);
    for (Object one : all) {
        if (!one.isDictionary())
            continue;
        read.files.push_back(readFile(one, budget));
        read.files.back().isAssociated = isIn(associated, one);
        read.files.back().isNamed = isIn(named, one);
    }
}

void readCatalog(QPDF &pdf, UnpackingBudget &budget, PdfStructure &read)
{
    Object catalog = pdf.getRoot();
    Object identifier = pdf.getTrailer().getKey("/ID");
    read.hasIdentifier = identifier.isArray() && identifier.getArrayNItems() == 2
        && identifier.getArrayItem(0).isString() && identifier.getArrayItem(1).isString();
    read.language = textOf(catalog.getKey("/Lang"));
    Object shown = keyOf(catalog.getKey("/ViewerPreferences"), "/DisplayDocTitle");
    read.showsTitle = shown.isBool() && shown.getBoolValue();
    readInformation(pdf.getTrailer().getKey("/Info"), read);
    Object metadata = catalog.getKey("/Metadata");
    read.xmp = budget.unpack(metadata).value_or(std::string());
    read.isXmpPlain = keyOf(metadata, "/Filter").isNull();
    readIntents(catalog, budget, read);
    readBookmarks(catalog, read);
    readFiles(catalog, budget, read);
}

tl::unexpected<Error> unreadable(const std::string &why)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "The PDF cannot be read (%1): it is damaged, encrypted or written in another form than certificates are; take an unchanged copy of it."),
            {why}});
}

} // namespace

std::size_t unpackedLimit(std::size_t fileBytes)
{
    constexpr std::size_t kAlways = std::size_t(64) << 20U, kFactor = 20;
    return kAlways + kFactor * fileBytes;
}

Result<PdfStructure> readPdfStructure(const std::string &bytes)
try {
    if (bytes.size() > kLargestPdf)
        return unreadable("more than 64 MiB");
    PdfStructure read;
    readHeader(bytes, read);
    QPDF pdf;
    pdf.setSuppressWarnings(true);
    pdf.setAttemptRecovery(false);
    pdf.setIgnoreXRefStreams(true);
    pdf.processMemoryFile("PDF", bytes.data(), bytes.size());
    if (pdf.isEncrypted())
        return unreadable("encrypted");
    if (pdf.getXRefTable().size() > kMostObjects)
        return unreadable("more than 100000 objects");
    UnpackingBudget budget(unpackedLimit(bytes.size()));
    readCatalog(pdf, budget, read);
    for (const Object &object : pdf.getAllObjects())
        readObject(object, read);
    return read;
} catch (const std::exception &problem) {
    return unreadable(problem.what());
}

Result<std::vector<PdfAttachment>> attachmentsOf(const std::string &pdf)
{
    const Result<PdfStructure> read = readPdfStructure(pdf);
    if (!read)
        return tl::unexpected<Error>(read.error());
    std::vector<PdfAttachment> attachments;
    for (const PdfFile &file : read->files) {
        if (!file.isUnpacked)
            return unreadable(file.attachment.name);
        attachments.push_back(file.attachment);
    }
    return attachments;
}

} // namespace dyncal
