// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/xml/well_formed.h"

#include <libxml/parser.h>
#include <libxml/xmlerror.h>

#include <memory>

namespace dyncal {
namespace {

struct FreedContext
{
    void operator()(xmlParserCtxt *context) const { xmlFreeParserCtxt(context); }
};

std::string firstLine(const char *text)
{
    const std::string whole = text ? text : "";
    return whole.substr(0, whole.find('\n'));
}

} // namespace

std::optional<XmlFault> faultOfXml(std::string_view utf8)
{
    const std::unique_ptr<xmlParserCtxt, FreedContext> context(xmlNewParserCtxt());
    if (!context)
        return XmlFault{1, "no memory"};
    *context->sax = {}; // nobody listens, so nothing is built
    context->sax->initialized = XML_SAX2_MAGIC;
    // HUGE: a text may be as long as kMostXmlBytes.
    constexpr int kOptions = XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING
        | XML_PARSE_IGNORE_ENC | XML_PARSE_HUGE;
    xmlFreeDoc(xmlCtxtReadMemory(
        context.get(), utf8.data(), static_cast<int>(utf8.size()), nullptr, "UTF-8", kOptions));
    if (context->wellFormed)
        return std::nullopt;
    const xmlError *error = xmlCtxtGetLastError(context.get());
    return error ? XmlFault{error->line, firstLine(error->message)} : XmlFault{1, ""};
}

} // namespace dyncal
