// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/xml/parsed_xml.h"

#include "core/base/ascii_text.h"
#include "core/base/text_encoding.h"
#include "core/xml/well_formed.h"

#include <pugixml.hpp>

#include <algorithm>
#include <optional>

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

/// Text may be interrupted by comments, which may leave blanks alone between two of them.
std::string textOf(const pugi::xml_node &node)
{
    std::string text;
    for (const pugi::xml_node &part : node)
        if (part.type() == pugi::node_pcdata || part.type() == pugi::node_cdata)
            text += part.value();
    return text.find_first_not_of(kBlanks) == text.npos ? std::string() : text;
}

/// The tree as values. Names of namespaces that are not known are told apart from those that are.
class ElementReading
{
public:
    ElementReading(const LineCount &lines, KnownSpace isKnown)
        : m_lines(lines)
        , m_isKnown(isKnown)
    {
    }
    ParsedElement elementOf(const pugi::xml_node &node)
    {
        const std::size_t outside = m_spaces.size();
        for (const pugi::xml_attribute &one : node.attributes())
            declare(one);
        ParsedElement element{nameOf(node), textOf(node), m_lines.lineOf(node.offset_debug())};
        for (const pugi::xml_attribute &one : node.attributes())
            element.attributes.emplace_back(withoutPrefix(one.name()), one.value());
        for (const pugi::xml_node &below : node)
            if (below.type() == pugi::node_element)
                element.children.push_back(elementOf(below)); // no deeper than kDeepestXml
        m_spaces.resize(outside);
        return element;
    }

private:
    struct Space
    {
        std::string_view prefix, address;
    };

    void declare(const pugi::xml_attribute &attribute)
    {
        constexpr std::string_view kBegin = "xmlns:";
        const std::string_view name = attribute.name();
        if (name == "xmlns")
            m_spaces.push_back({"", attribute.value()});
        else if (name.starts_with(kBegin))
            m_spaces.push_back({name.substr(kBegin.size()), attribute.value()});
    }
    /// Of a prefix that nobody declares the prefix with its colon.
    std::string_view spaceOf(std::string_view name) const
    {
        const std::size_t colon = name.find(':');
        const std::string_view prefix = colon == name.npos ? "" : name.substr(0, colon);
        for (auto one = m_spaces.rbegin(); one != m_spaces.rend(); ++one)
            if (one->prefix == prefix)
                return one->address;
        return prefix.empty() ? prefix : name.substr(0, colon + 1);
    }
    std::string nameOf(const pugi::xml_node &node) const
    {
        const std::string_view space = m_isKnown ? spaceOf(node.name()) : std::string_view();
        std::string name(withoutPrefix(node.name()));
        return space.empty() || m_isKnown(space) ? name : '{' + std::string(space) + '}' + name;
    }

    const LineCount &m_lines;
    KnownSpace m_isKnown;
    std::vector<Space> m_spaces;
};

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

tl::unexpected<Error> malformed(Index line, std::string what)
{
    return unreadable(
        {DYNCAL_TEXT("core",
             "Line %1 of the XML file is malformed (%2); restore the file as its laboratory sent it."),
            {std::to_string(line), std::move(what)}});
}

/// What is dear to judge, or harms others, goes before them.
Result<void> checkForm(pugi::xml_document &document, const std::string &text)
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
    // Blanks before the declaration, which XML forbids, do no harm.
    const std::string_view whole = text;
    const std::size_t begin = std::min(whole.find('<'), whole.size());
    std::optional<XmlFault> fault = faultOfXml(whole.substr(begin));
    if (!fault)
        return {};
    const Index before = std::ranges::count(whole.substr(0, begin), '\n');
    return malformed(before + fault->line, std::move(fault->what));
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

Result<ParsedElement> readXml(std::string_view bytes, KnownSpace isKnown)
{
    if (const Result<void> size = checkSize(bytes); !size)
        return tl::unexpected<Error>(size.error());
    const Result<std::string> text = utf8Of(bytes);
    if (!text)
        return tl::unexpected<Error>(text.error());
    const LineCount lines(*text);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text->data(), text->size(),
        pugi::parse_default | pugi::parse_doctype | pugi::parse_ws_pcdata, pugi::encoding_utf8);
    if (!parsed)
        return malformed(lines.lineOf(parsed.offset), parsed.description());
    if (const Result<void> form = checkForm(document, *text); !form)
        return tl::unexpected<Error>(form.error());
    return ElementReading(lines, isKnown).elementOf(document.document_element());
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
