// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc/xml_element.h"

#include <QStringList>

#include <pugixml.hpp>

#include <cmath>
#include <vector>

namespace dyncal::testing {

/// What was written, read again by another program's parser; parts are named by XPath.
class ReadXml
{
public:
    explicit ReadXml(const std::string &xml)
        : m_isWellFormed(m_document.load_buffer(xml.data(), xml.size(), pugi::parse_full))
    {
    }
    explicit ReadXml(const XmlElement &element)
        : ReadXml(xmlText(element))
    {
    }

    bool isWellFormed() const { return m_isWellFormed; }
    pugi::xml_node root() const { return m_document.document_element(); }
    int count(const std::string &path) const
    {
        return static_cast<int>(m_document.select_nodes(path.c_str()).size());
    }
    /// Texts of elements, values of attributes.
    QStringList texts(const std::string &path) const
    {
        QStringList list;
        for (const pugi::xpath_node &one : m_document.select_nodes(path.c_str()))
            list << QString::fromUtf8(
                one.attribute() ? one.attribute().value() : one.node().child_value());
        return list;
    }
    /// Of the only one; says otherwise how many there are.
    QString text(const std::string &path) const
    {
        const QStringList list = texts(path);
        return list.size() == 1 ? list.front() : QString("(%1 of them)").arg(list.size());
    }
    /// The words of a list.
    QStringList list(const std::string &path) const
    {
        return text(path).split(' ', Qt::KeepEmptyParts);
    }
    /// The numbers of a list; "NaN" is one.
    std::vector<double> numbers(const std::string &path) const
    {
        std::vector<double> numbers;
        for (const QString &word : list(path)) {
            bool isNumber = false;
            const double number = word.toDouble(&isNumber);
            numbers.push_back(isNumber ? number : std::nan(""));
        }
        return numbers;
    }
    /// The names of the root's children, in their order.
    QStringList parts() const
    {
        QStringList names;
        for (const pugi::xml_node &child : root().children())
            names << QString::fromUtf8(child.name());
        return names;
    }

private:
    pugi::xml_document m_document;
    bool m_isWellFormed;
};

/// "//dcc:quantity[that refType]", followed by the rest of the path.
inline std::string quantityPath(const std::string &refType, const std::string &rest = {})
{
    return "//dcc:quantity[@refType='" + refType + "']" + rest;
}

} // namespace dyncal::testing
