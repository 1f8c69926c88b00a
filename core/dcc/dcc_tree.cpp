// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_tree.h"

#include <map>
#include <utility>

namespace dyncal {

struct DccTree::Document
{
    ParsedElement root;
    DccNode::Places places = {};

    /// Adds the element and all below it, no deeper than kDeepestXml.
    void add(const ParsedElement &element, std::size_t parent)
    {
        const std::size_t at = places.size();
        places.push_back({&element, parent});
        std::map<std::string_view, std::vector<std::size_t>> ofNames;
        for (const ParsedElement &child : element.children) {
            ofNames[child.name].push_back(places.size());
            add(child, at);
        }
        places[at].behind = places.size();
        for (const auto &[name, alike] : ofNames)
            for (std::size_t i = 0; alike.size() > 1 && i < alike.size(); ++i)
                places[alike[i]].number = i + 1;
    }
};

std::string DccNode::attribute(std::string_view name) const
{
    return element().attribute(name);
}

std::vector<DccNode> DccNode::children() const
{
    std::vector<DccNode> list;
    list.reserve(element().children.size());
    for (std::size_t at = m_at + 1; at < place().behind; at = (*m_places)[at].behind)
        list.push_back({m_places, at});
    return list;
}

std::string DccNode::childText(std::string_view name) const
{
    const ParsedElement *child = element().child(name);
    return child ? child->text : std::string();
}

DccNode DccNode::parent() const
{
    return {m_places, place().parent};
}

std::string DccNode::parentName() const
{
    return m_at == 0 ? std::string() : parent().name();
}

std::string DccNode::path() const
{
    if (m_at == 0)
        return {};
    const std::string above = parent().path(); // no deeper than kDeepestXml
    std::string path = above.empty() ? name() : above + "/" + name();
    if (const std::size_t number = place().number; number > 0)
        path.append("[").append(std::to_string(number)).append("]");
    return path;
}

bool DccNode::isSignature() const
{
    return name() == "Signature" || (m_at != 0 && parent().isSignature());
}

Result<DccTree> DccTree::read(std::string_view xml)
{
    Result<ParsedElement> root = readXml(xml);
    if (!root)
        return tl::unexpected<Error>(root.error());
    if (root->name != "digitalCalibrationCertificate")
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "The file is no digital calibration certificate: its first element is another; give a DCC of version 3."),
                {}});
    DccTree tree;
    tree.m_document = std::make_shared<Document>(Document{std::move(*root)});
    tree.m_document->add(tree.m_document->root, 0);
    return tree;
}

DccNode DccTree::root() const
{
    return {&m_document->places, 0};
}

std::vector<DccNode> DccTree::all() const
{
    std::vector<DccNode> list;
    list.reserve(m_document->places.size());
    for (std::size_t at = 0; at < m_document->places.size(); ++at)
        list.push_back({&m_document->places, at});
    return list;
}

std::vector<DccNode> DccTree::all(std::string_view name) const
{
    std::vector<DccNode> list;
    for (const DccNode &node : all())
        if (node.element().name == name)
            list.push_back(node);
    return list;
}

} // namespace dyncal
