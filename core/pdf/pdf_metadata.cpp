// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pdf/pdf_metadata.h"

#include "core/base/text_encoding.h"

#include <pugixml.hpp>

#include <algorithm>
#include <cstring>
#include <sstream>

namespace dyncal {
namespace {

constexpr std::string_view kIsoForm = "0000-00-00T00:00:00Z";
constexpr std::string_view kPdfForm = "D:00000000000000Z";
constexpr const char *kEpoch = "1970-01-01T00:00:00Z";
constexpr const char *kMarks = "dyncal:";

/// Whether a text has a form in which '0' stands for any digit.
bool hasForm(const std::string &text, std::string_view form)
{
    return std::ranges::equal(text, form, [](char has, char wanted) {
        return wanted == '0' ? has >= '0' && has <= '9' : has == wanted;
    });
}

std::string isoDate(const std::string &utc)
{
    return hasForm(utc, kIsoForm) ? utc : kEpoch;
}

void add(pugi::xml_node parent, const char *name, const std::string &text)
{
    parent.append_child(name).text().set(text.c_str());
}

/// A property with a container of items: rdf:Alt, rdf:Seq, rdf:Bag.
pugi::xml_node addList(pugi::xml_node parent, const char *name, const char *container)
{
    return parent.append_child(name).append_child(container);
}

pugi::xml_node addResource(pugi::xml_node list)
{
    pugi::xml_node item = list.append_child("rdf:li");
    item.append_attribute("rdf:parseType") = "Resource";
    return item;
}

void addTitle(pugi::xml_node description, const PdfMetadata &metadata)
{
    const pugi::xml_node list = addList(description, "dc:title", "rdf:Alt");
    for (const char *language : {"x-default", metadata.language.c_str()}) {
        add(list, "rdf:li", metadata.title);
        list.last_child().append_attribute("xml:lang") = language;
    }
}

void addLanguages(pugi::xml_node description, const PdfMetadata &metadata)
{
    const pugi::xml_node list = addList(description, "dc:language", "rdf:Bag");
    for (const std::string &language : {metadata.language, metadata.secondLanguage})
        if (!language.empty())
            add(list, "rdf:li", language);
}

/// Every property of a namespace of one's own is described in the file itself.
void addSchema(pugi::xml_node description, const PdfMetadata &metadata)
{
    const pugi::xml_node schema
        = addResource(addList(description, "pdfaExtension:schemas", "rdf:Bag"));
    add(schema, "pdfaSchema:schema", "What an issued certificate is bound to");
    add(schema, "pdfaSchema:namespaceURI", "https://dyncal.example.org/ns/1.0/");
    add(schema, "pdfaSchema:prefix", "dyncal");
    const pugi::xml_node list = addList(schema, "pdfaSchema:property", "rdf:Seq");
    for (const auto &[name, value] : metadata.marks) {
        const pugi::xml_node property = addResource(list);
        add(property, "pdfaProperty:name", name);
        add(property, "pdfaProperty:valueType", "Text");
        add(property, "pdfaProperty:category", "external");
        add(property, "pdfaProperty:description", "Mark of an issued certificate: " + name);
    }
}

void addNamespaces(pugi::xml_node description, bool withMarks)
{
    const auto declare = [&](const char *prefix, const char *uri) {
        description.append_attribute(("xmlns:" + std::string(prefix)).c_str()) = uri;
    };
    declare("dc", "http://purl.org/dc/elements/1.1/");
    declare("xmp", "http://ns.adobe.com/xap/1.0/");
    declare("pdf", "http://ns.adobe.com/pdf/1.3/");
    declare("pdfaid", "http://www.aiim.org/pdfa/ns/id/");
    if (!withMarks)
        return;
    declare("pdfaExtension", "http://www.aiim.org/pdfa/ns/extension/");
    declare("pdfaSchema", "http://www.aiim.org/pdfa/ns/schema#");
    declare("pdfaProperty", "http://www.aiim.org/pdfa/ns/property#");
    declare("dyncal", "https://dyncal.example.org/ns/1.0/");
}

void addProperties(pugi::xml_node description, const PdfMetadata &metadata)
{
    const std::string when = isoDate(metadata.createdUtc);
    add(description, "pdfaid:part", "3");
    add(description, "pdfaid:conformance", "B");
    add(description, "dc:format", "application/pdf");
    addTitle(description, metadata);
    if (!metadata.author.empty())
        add(addList(description, "dc:creator", "rdf:Seq"), "rdf:li", metadata.author);
    addLanguages(description, metadata);
    add(description, "xmp:CreatorTool", metadata.creator);
    for (const char *date : {"xmp:CreateDate", "xmp:ModifyDate", "xmp:MetadataDate"})
        add(description, date, when);
    add(description, "pdf:Producer", metadata.producer);
    if (!metadata.marks.empty())
        addSchema(description, metadata);
    for (const auto &[name, value] : metadata.marks)
        add(description, (kMarks + name).c_str(), value);
}

std::string textOf(pugi::xml_node node, const char *path)
{
    return node.select_node(path).node().text().get();
}

/// All of what is told in one rdf:Description or in several.
void readProperties(pugi::xml_node description, ReadXmp &read)
{
    const auto keep = [&](std::string &value, const char *path) {
        if (value.empty())
            value = textOf(description, path);
    };
    read.claims += static_cast<int>(description.select_nodes("pdfaid:part").size())
        + static_cast<int>(description.select_nodes("@pdfaid:part").size());
    keep(read.part, "pdfaid:part");
    keep(read.conformance, "pdfaid:conformance");
    keep(read.title, "dc:title/rdf:Alt/rdf:li[@xml:lang='x-default']");
    keep(read.author, "dc:creator/rdf:Seq/rdf:li");
    keep(read.creator, "xmp:CreatorTool");
    keep(read.producer, "pdf:Producer");
    keep(read.created, "xmp:CreateDate");
    keep(read.modified, "xmp:ModifyDate");
    for (const pugi::xpath_node &item : description.select_nodes("dc:language/rdf:Bag/rdf:li"))
        read.languages.emplace_back(item.node().text().get());
    for (const pugi::xml_node &mark : description.children())
        if (std::strncmp(mark.name(), kMarks, std::strlen(kMarks)) == 0)
            read.marks.emplace_back(mark.name() + std::strlen(kMarks), mark.text().get());
    if (description.child("pdfaExtension:schemas"))
        read.describesMarks = true;
}

} // namespace

std::string pdfDate(const std::string &utc)
{
    std::string digits;
    for (const char c : isoDate(utc))
        if (c >= '0' && c <= '9')
            digits += c;
    return "D:" + digits + "Z";
}

std::string utcOfPdfDate(const std::string &date)
{
    if (!hasForm(date, kPdfForm))
        return {};
    std::string utc(kIsoForm);
    std::size_t next = 2; // behind "D:"
    for (char &c : utc)
        if (c == '0')
            c = date[next++];
    return utc;
}

std::string xmpOf(const PdfMetadata &metadata)
{
    pugi::xml_document document;
    pugi::xml_node packet = document.append_child("x:xmpmeta");
    packet.append_attribute("xmlns:x") = "adobe:ns:meta/";
    pugi::xml_node rdf = packet.append_child("rdf:RDF");
    rdf.append_attribute("xmlns:rdf") = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";
    pugi::xml_node description = rdf.append_child("rdf:Description");
    description.append_attribute("rdf:about") = "";
    addNamespaces(description, !metadata.marks.empty());
    addProperties(description, metadata);
    std::ostringstream text;
    text << "<?xpacket begin=\"" << kUtf8Mark << "\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n";
    document.save(text, " ", pugi::format_indent | pugi::format_no_declaration);
    text << "<?xpacket end=\"r\"?>\n";
    return text.str();
}

std::optional<ReadXmp> readXmp(const std::string &xmp)
{
    pugi::xml_document document;
    if (!document.load_buffer(xmp.data(), xmp.size()))
        return std::nullopt;
    ReadXmp read;
    for (const pugi::xpath_node &one : document.select_nodes("x:xmpmeta/rdf:RDF/rdf:Description"))
        readProperties(one.node(), read);
    return read;
}

} // namespace dyncal
