// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_schema.h"

#include <libxml/parser.h>
#include <libxml/parserInternals.h>
#include <libxml/xmlschemas.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <mutex>
#include <string_view>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFindings = 50;

template <auto Free>
struct Freed
{
    template <typename T>
    void operator()(T *owned) const
    {
        Free(owned);
    }
};
using XmlDocument = std::unique_ptr<xmlDoc, Freed<xmlFreeDoc>>;
using SchemaParser = std::unique_ptr<xmlSchemaParserCtxt, Freed<xmlSchemaFreeParserCtxt>>;
using Schema = std::unique_ptr<xmlSchema, Freed<xmlSchemaFree>>;
using Validator = std::unique_ptr<xmlSchemaValidCtxt, Freed<xmlSchemaFreeValidCtxt>>;

std::string g_folder; // where the loader below looks; guarded by loading()

std::mutex &loading()
{
    static std::mutex one;
    return one;
}

/// "https://www.ptb.de/si/x.xsd" is FOLDER/ptb.de/si/x.xsd; what leaves the folder is nothing.
std::string placeOf(std::string_view address)
{
    if (address.starts_with(g_folder))
        return std::string(address);
    for (const std::string_view begin : {"https://", "http://"})
        if (address.starts_with(begin))
            address.remove_prefix(begin.size());
    if (address.starts_with("www."))
        address.remove_prefix(std::string_view("www.").size());
    const fs::path inside = fs::path(address).lexically_normal();
    if (inside.is_absolute() || inside.empty() || *inside.begin() == "..")
        return {};
    return (fs::path(g_folder) / inside).string();
}

/// Opens files of the folder only.
xmlParserInputPtr loadFromFolder(const char *address, const char *, xmlParserCtxtPtr context)
{
    const std::string place = placeOf(address ? address : "");
    std::error_code unknown;
    if (place.empty() || !fs::is_regular_file(place, unknown))
        return nullptr;
    return xmlNewInputFromFile(context, place.c_str());
}

void ignore(void *, xmlErrorPtr) { }

/// The program's own loader is back when this goes; meanwhile nothing is printed.
struct FolderLoader
{
    std::lock_guard<std::mutex> lock{loading()};
    xmlExternalEntityLoader before = xmlGetExternalEntityLoader();

    explicit FolderLoader(const std::string &folder)
    {
        g_folder = folder;
        xmlSetExternalEntityLoader(loadFromFolder);
        xmlSetStructuredErrorFunc(nullptr, ignore);
    }
    ~FolderLoader()
    {
        xmlSetStructuredErrorFunc(nullptr, nullptr);
        xmlSetExternalEntityLoader(before);
    }
    FolderLoader(const FolderLoader &) = delete;
    FolderLoader &operator=(const FolderLoader &) = delete;
};

/// A sentence of the validator with its line.
void collect(void *list, xmlErrorPtr error)
{
    auto &findings = *static_cast<std::vector<DccFinding> *>(list);
    if (findings.size() >= kMostFindings || !error)
        return;
    std::string said = error->message ? error->message : "";
    said.erase(std::find_if(said.rbegin(), said.rend(), [](char c) { return c != '\n'; }).base(),
        said.end());
    std::erase(said, '\n');
    for (const std::string_view prefix : {"{https://ptb.de/dcc}", "{https://ptb.de/si}"})
        for (std::size_t at; (at = said.find(prefix)) != said.npos;)
            said.erase(at, prefix.size());
    findings.push_back({"schema", "line " + std::to_string(error->line), said,
        {DYNCAL_TEXT("core", "The document is valid by the XML schema of its version."), {}}});
}

tl::unexpected<Error> noSchema(const std::string &file)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "There is no XML schema of this version at %V1, or it is none; give a folder that has PTB's schemas by their addresses."),
            {file}});
}

XmlDocument parsed(const std::string &xml)
{
    if (xml.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        return nullptr;
    constexpr int kQuiet = XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING;
    return XmlDocument(
        xmlReadMemory(xml.data(), static_cast<int>(xml.size()), "dcc.xml", nullptr, kQuiet));
}

bool isVersion(const std::string &version)
{
    return !version.empty() && version.find_first_not_of("0123456789.") == version.npos;
}

} // namespace

Result<std::vector<DccFinding>> schemaFindings(
    const std::string &xml, const std::string &version, const std::string &folder)
{
    const std::string root = fs::absolute(folder).lexically_normal().string();
    const std::string file = (fs::path(root) / "ptb.de/dcc" / ("v" + version) / "dcc.xsd").string();
    std::error_code unknown;
    if (!isVersion(version) || !fs::is_regular_file(file, unknown))
        return noSchema(file);
    const FolderLoader loader(root);
    const XmlDocument document = parsed(xml);
    if (!document)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT(
                 "core", "The file is no well-formed XML; give a digital calibration certificate."),
                {}});
    const SchemaParser parser(xmlSchemaNewParserCtxt(file.c_str()));
    if (parser)
        xmlSchemaSetParserStructuredErrors(parser.get(), ignore, nullptr);
    const Schema schema(parser ? xmlSchemaParse(parser.get()) : nullptr);
    const Validator validator(schema ? xmlSchemaNewValidCtxt(schema.get()) : nullptr);
    if (!validator)
        return noSchema(file);
    std::vector<DccFinding> findings;
    xmlSchemaSetValidStructuredErrors(validator.get(), collect, &findings);
    xmlSchemaValidateDoc(validator.get(), document.get());
    return findings;
}

} // namespace dyncal
