// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/xml/parsed_xml.h"

#include "core/base/ascii_text.h"
#include "core/base/text_encoding.h"

#include <pugixml.hpp>

#include <algorithm>

namespace dyncal {
namespace {

tl::unexpected<Error> unreadable(Message message)
{
    return fail(ErrorKind::FileUnreadable, std::move(message));
}

std::string_view withoutPrefix(std::string_view name)
{
    const std::size_t colon = name.find(':');
    return colon == name.npos ? name : name.substr(colon + 1);
}

/// The XML declaration in lower case, or as much of it as there is.
std::string declarationOf(std::string_view bytes)
{
    const std::size_t end = bytes.substr(0, 200).find("?>");
    return end == bytes.npos ? std::string() : lowerCase(std::string(bytes.substr(0, end)));
}

/// The bytes as UTF-8.
Result<std::string> utf8Of(std::string_view bytes)
{
    if (const ByteOrder order = byteOrderOf(bytes); order != ByteOrder::None)
        return fromUtf16(bytes, order == ByteOrder::BigEndian);
    const std::string declaration = declarationOf(bytes);
    const auto declares
        = [&](const char *name) { return declaration.find(name) != std::string::npos; };
    if (declares("iso-8859-1") || declares("windows-1252"))
        return utf8Text(bytes);
    if (isUtf8(bytes))
        return std::string(bytes);
    return unreadable(
        {DYNCAL_TEXT("core",
             "The XML file is not in UTF-8, nor does it say that it is in UTF-16 or ISO-8859-1, so its text is unknown; save it as UTF-8."),
            {}});
}

/// Line of each byte, by the ends of the lines before it.
class LineCount
{
public:
    explicit LineCount(std::string_view text)
    {
        for (std::size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1))
            m_ends.push_back(at);
    }
    Index lineOf(std::ptrdiff_t offset) const
    {
        const auto before = std::ranges::lower_bound(m_ends, static_cast<std::size_t>(offset));
        return 1 + (before - m_ends.begin());
    }

private:
    std::vector<std::size_t> m_ends;
};

constexpr std::string_view kBlanks = " \t\r\n";

/// Text may be interrupted by comments.
std::string textOf(const pugi::xml_node &node)
{
    std::string text;
    for (const pugi::xml_node &part : node)
        if (part.type() == pugi::node_pcdata || part.type() == pugi::node_cdata)
            text += part.value();
    return text.find_first_not_of(kBlanks) == text.npos ? std::string() : text;
}

ParsedElement elementOf(const pugi::xml_node &node, const LineCount &lines)
{
    ParsedElement element{
        std::string(withoutPrefix(node.name())), textOf(node), lines.lineOf(node.offset_debug())};
    for (const pugi::xml_attribute &one : node.attributes())
        element.attributes.emplace_back(withoutPrefix(one.name()), one.value());
    for (const pugi::xml_node &below : node)
        if (below.type() == pugi::node_element)
            element.children.push_back(elementOf(below, lines)); // no deeper than kDeepestXml
    return element;
}

/// A file may be nested deeper than a stack is, so this does not call itself.
bool isDeeperThanAllowed(pugi::xml_document &document)
{
    struct Depth : pugi::xml_tree_walker
    {
        bool for_each(pugi::xml_node &node) override
        {
            return node.type() != pugi::node_element || depth() < kDeepestXml;
        }
    } walker;
    return !document.traverse(walker);
}

Result<void> checkSize(std::string_view bytes)
{
    constexpr std::size_t kTagsOfElement = 2;
    const auto tags = static_cast<std::size_t>(std::ranges::count(bytes, '<'));
    if (bytes.size() <= kMostXmlBytes && tags <= kTagsOfElement * kMostXmlElements)
        return {};
    return unreadable(
        {DYNCAL_TEXT("core",
             "The XML file has %1 bytes and %2 tags, more than the %3 bytes and %4 tags that a certificate may have; take out what is embedded in it."),
            {std::to_string(bytes.size()), std::to_string(tags), std::to_string(kMostXmlBytes),
                std::to_string(kTagsOfElement * kMostXmlElements)}});
}

tl::unexpected<Error> malformed(const pugi::xml_parse_result &parsed, const LineCount &lines)
{
    return unreadable(
        {DYNCAL_TEXT("core",
             "Line %1 of the XML file is malformed (%2); restore the file as its laboratory sent it."),
            {std::to_string(lines.lineOf(parsed.offset)), parsed.description()}});
}

Result<ParsedElement> rootOf(pugi::xml_document &document, const LineCount &lines)
{
    if (document.find_child([](const auto &node) { return node.type() == pugi::node_doctype; }))
        return unreadable(
            {DYNCAL_TEXT("core",
                 "The XML file has a document type (DOCTYPE), which may make it grow or fetch other files, and which no certificate needs; it is not read."),
                {}});
    if (isDeeperThanAllowed(document))
        return unreadable(
            {DYNCAL_TEXT("core",
                 "The elements of the XML file are nested deeper than %1 levels, which no certificate needs; it is not read."),
                {std::to_string(kDeepestXml)}});
    const auto isElement = [](const auto &node) { return node.type() == pugi::node_element; };
    if (std::ranges::count_if(document.begin(), document.end(), isElement) != 1)
        return unreadable(
            {DYNCAL_TEXT("core",
                 "The XML file has several elements that hold everything, where one is needed; restore the file as its laboratory sent it."),
                {}});
    return elementOf(document.document_element(), lines);
}

} // namespace

std::string ParsedElement::trimmedText() const
{
    const std::size_t first = text.find_first_not_of(kBlanks);
    return first == text.npos ? std::string()
                              : text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string ParsedElement::attribute(std::string_view named) const
{
    const auto found = std::ranges::find(
        attributes, named, [](const auto &one) { return std::string_view(one.first); });
    return found == attributes.end() ? std::string() : found->second;
}

const ParsedElement *ParsedElement::child(std::string_view named) const
{
    const auto found = std::ranges::find(children, named, &ParsedElement::name);
    return found == children.end() ? nullptr : &*found;
}

std::vector<const ParsedElement *> ParsedElement::all(std::string_view named) const
{
    std::vector<const ParsedElement *> found;
    for (const ParsedElement &one : children)
        if (one.name == named)
            found.push_back(&one);
    return found;
}

const ParsedElement *ParsedElement::at(const std::vector<std::string_view> &path) const
{
    const ParsedElement *reached = this;
    for (const std::string_view step : path)
        reached = reached ? reached->child(step) : nullptr;
    return reached;
}

std::string ParsedElement::textAt(const std::vector<std::string_view> &path) const
{
    const ParsedElement *reached = at(path);
    return reached ? reached->trimmedText() : std::string();
}

Result<ParsedElement> readXml(std::string_view bytes)
{
    if (const Result<void> size = checkSize(bytes); !size)
        return tl::unexpected<Error>(size.error());
    Result<std::string> text = utf8Of(bytes);
    if (!text)
        return tl::unexpected<Error>(text.error());
    const LineCount lines(*text);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer_inplace(
        text->data(), text->size(), pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
    return parsed ? rootOf(document, lines) : malformed(parsed, lines);
}

std::vector<std::string> wordsIn(std::string_view text)
{
    std::vector<std::string> words;
    for (std::size_t at = text.find_first_not_of(kBlanks); at != text.npos;) {
        const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
        words.emplace_back(text.substr(at, end - at));
        at = text.find_first_not_of(kBlanks, end);
    }
    return words;
}

} // namespace dyncal
