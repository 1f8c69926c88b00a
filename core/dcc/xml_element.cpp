// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/xml_element.h"

#include "core/base/foreign_text.h"

#include <pugixml.hpp>

namespace dyncal {
namespace {

void write(const XmlElement &element, pugi::xml_node node)
{
    node.set_name(element.name.c_str());
    for (const auto &[name, value] : element.attributes)
        node.append_attribute(name.c_str()).set_value(xmlCharacters(value).c_str());
    if (!element.text.empty())
        node.append_child(pugi::node_pcdata).set_value(xmlCharacters(element.text).c_str());
    for (const XmlElement &child : element.children)
        write(child, node.append_child(pugi::node_element));
}

struct StringWriter : pugi::xml_writer
{
    std::string text;

    void write(const void *data, std::size_t size) override
    {
        text.append(static_cast<const char *>(data), size);
    }
};

} // namespace

XmlElement &XmlElement::add(XmlElement child)
{
    children.push_back(std::move(child));
    return children.back();
}

std::string xmlCharacters(std::string_view text)
{
    return presentable(text, LineBreaks::Keep);
}

std::string inOneLine(std::string_view text)
{
    constexpr std::string_view kBlanks = " \t\r\n";
    std::string line;
    bool isApart = false;
    for (const char c : xmlCharacters(text)) {
        if (kBlanks.find(c) != std::string_view::npos) {
            isApart = !line.empty();
            continue;
        }
        line.append(isApart ? " " : "").push_back(c);
        isApart = false;
    }
    return line;
}

std::string xmlText(const XmlElement &root)
{
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    write(root, document.append_child(pugi::node_element));
    StringWriter writer;
    document.save(writer, " ", pugi::format_default, pugi::encoding_utf8);
    return writer.text;
}

} // namespace dyncal
