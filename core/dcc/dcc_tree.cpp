// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_tree.h"

#include <pugixml.hpp>

#include <algorithm>

namespace dyncal {
namespace {

constexpr std::size_t kMostBytes = std::size_t(64) << 20U;
constexpr int kDeepest = 100;

std::string_view localName(const pugi::xml_node &node)
{
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    return colon == name.npos ? name : name.substr(colon + 1);
}

pugi::xml_node nodeOf(const void *node)
{
    return pugi::xml_node(
        const_cast<pugi::xml_node_struct *>(static_cast<const pugi::xml_node_struct *>(node)));
}

/// Which of its parent's children of that name, from 1; 0: the only one.
int numberOf(const pugi::xml_node &node)
{
    int before = 0, all = 0;
    for (const pugi::xml_node &other : node.parent().children()) {
        if (localName(other) != localName(node))
            continue;
        ++all;
        before += other == node ? all : 0;
    }
    return all > 1 ? before : 0;
}

struct Elements : pugi::xml_tree_walker
{
    std::vector<pugi::xml_node> found;
    int deepest = 0;

    bool for_each(pugi::xml_node &node) override
    {
        if (node.type() != pugi::node_element)
            return true;
        deepest = std::max(deepest, depth() + 1); // the first has a depth of 0
        found.push_back(node);
        return deepest <= kDeepest;
    }
};

/// The second on the level of the first, of which XML has one; null without it.
pugi::xml_node secondRoot(const pugi::xml_document &xml)
{
    pugi::xml_node at = xml.document_element().next_sibling();
    while (at && at.type() != pugi::node_element)
        at = at.next_sibling();
    return at;
}

bool hasDocumentType(const pugi::xml_document &xml)
{
    return std::ranges::any_of(xml.children(),
        [](const pugi::xml_node &node) { return node.type() == pugi::node_doctype; });
}

tl::unexpected<Error> notReadable(const char *sentence, std::vector<std::string> arguments = {})
{
    return fail(ErrorKind::FileUnreadable, {sentence, std::move(arguments)});
}

tl::unexpected<Error> documentType()
{
    return notReadable(DYNCAL_TEXT("core",
        "The file has a document type or entities of its own, which a digital calibration certificate does not need and which are never read; ask for one without."));
}

tl::unexpected<Error> notWellFormed(const char *why, std::ptrdiff_t at_byte)
{
    return notReadable(
        DYNCAL_TEXT("core",
            "The file is no well-formed XML (%1, at byte %2); give a digital calibration certificate."),
        {why, std::to_string(at_byte)});
}

} // namespace

struct DccTree::Document
{
    pugi::xml_document xml;
    Elements elements;
};

std::string DccNode::name() const
{
    return std::string(localName(nodeOf(m_node)));
}

std::string DccNode::text() const
{
    std::string text; // a comment parts it
    for (const pugi::xml_node &child : nodeOf(m_node).children())
        if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
            text += child.value();
    return text;
}

std::string DccNode::attribute(const char *name) const
{
    return nodeOf(m_node).attribute(name).value();
}

std::vector<DccNode> DccNode::children() const
{
    std::vector<DccNode> list;
    for (const pugi::xml_node &child : nodeOf(m_node).children())
        if (child.type() == pugi::node_element)
            list.emplace_back().m_node = child.internal_object();
    return list;
}

bool DccNode::hasChild(std::string_view name) const
{
    return std::ranges::any_of(
        children(), [&](const DccNode &child) { return child.name() == name; });
}

std::string DccNode::childText(std::string_view name) const
{
    for (const DccNode &child : children())
        if (child.name() == name)
            return child.text();
    return {};
}

DccNode DccNode::parent() const
{
    DccNode above;
    above.m_node = nodeOf(m_node).parent().internal_object();
    return above;
}

std::string DccNode::path() const
{
    std::string path;
    for (pugi::xml_node at = nodeOf(m_node); at.parent().parent(); at = at.parent()) {
        std::string step(localName(at));
        if (const int number = numberOf(at); number > 0)
            step.append("[").append(std::to_string(number)).append("]");
        path = path.empty() ? step : step + "/" + path;
    }
    return path;
}

bool DccNode::isSignature() const
{
    for (pugi::xml_node at = nodeOf(m_node); at; at = at.parent())
        if (localName(at) == "Signature")
            return true;
    return false;
}

Result<DccTree> DccTree::read(const std::string &xml)
{
    if (xml.size() > kMostBytes)
        return notReadable(DYNCAL_TEXT("core",
            "The file is larger than 64 MiB, which no digital calibration certificate is; give another file."));
    if (xml.find("<!DOCTYPE") != xml.npos || xml.find("<!ENTITY") != xml.npos)
        return documentType();
    DccTree tree;
    tree.m_document = std::make_shared<Document>();
    const pugi::xml_parse_result parsed = tree.m_document->xml.load_buffer(
        xml.data(), xml.size(), pugi::parse_default | pugi::parse_doctype);
    if (!parsed)
        return notWellFormed(parsed.description(), parsed.offset);
    if (hasDocumentType(tree.m_document->xml)) // in UTF-16 not found above
        return documentType();
    if (const pugi::xml_node second = secondRoot(tree.m_document->xml))
        return notWellFormed("More than one document element", second.offset_debug());
    if (localName(tree.m_document->xml.document_element()) != "digitalCalibrationCertificate")
        return notReadable(DYNCAL_TEXT("core",
            "The file is no digital calibration certificate: its first element is another; give a DCC of version 3."));
    tree.m_document->xml.traverse(tree.m_document->elements);
    if (tree.m_document->elements.deepest > kDeepest)
        return notReadable(DYNCAL_TEXT("core",
            "The file is nested deeper than 100 elements, which no digital calibration certificate is; give another file."));
    return tree;
}

DccNode DccTree::root() const
{
    DccNode node;
    node.m_node = m_document->xml.document_element().internal_object();
    return node;
}

std::vector<DccNode> DccTree::all() const
{
    std::vector<DccNode> list;
    for (const pugi::xml_node &node : m_document->elements.found)
        list.emplace_back().m_node = node.internal_object();
    return list;
}

std::vector<DccNode> DccTree::all(std::string_view name) const
{
    std::vector<DccNode> list;
    for (const pugi::xml_node &node : m_document->elements.found)
        if (localName(node) == name)
            list.emplace_back().m_node = node.internal_object();
    return list;
}

std::vector<std::string> wordsIn(std::string_view text)
{
    constexpr std::string_view kBlanks = " \t\r\n";
    std::vector<std::string> words;
    for (std::size_t at = text.find_first_not_of(kBlanks); at != text.npos;) {
        const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
        words.emplace_back(text.substr(at, end - at));
        at = text.find_first_not_of(kBlanks, end);
    }
    return words;
}

} // namespace dyncal
