// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/xml/parsed_xml.h"

#include <compare>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// An element of a DCC that is read, which knows where it stands. Names are without the prefix of
/// their namespace, which every writer chooses for itself. Valid as long as its tree.
class DccNode
{
public:
    std::string name() const { return element().name; }
    std::string text() const { return element().text; } ///< as it stands
    std::string attribute(std::string_view name) const; ///< "" without it
    std::vector<DccNode> children() const;
    std::string childText(std::string_view name) const; ///< of the first; "" without it
    DccNode parent() const; ///< of the root itself: the root
    std::string parentName() const; ///< "" of the root
    /// "measurementResults/measurementResult/results/result[2]": which of several, from 1. In time
    /// linear in its depth.
    std::string path() const;
    /// Whether it belongs to an XML signature, whose ids are its own.
    bool isSignature() const;

    /// Those of one tree, in the order of the document.
    auto operator<=>(const DccNode &) const = default;

private:
    friend class DccTree;

    /// An element with its place.
    struct Place
    {
        const ParsedElement *element;
        std::size_t parent; ///< the root's is itself
        std::size_t behind = 0; ///< the next that is not below it
        std::size_t number = 0; ///< among its parent's children of that name, from 1; 0: the only
    };
    using Places = std::vector<Place>; ///< in the order of the document

    DccNode(const Places *places, std::size_t at)
        : m_places(places)
        , m_at(at)
    {
    }
    const Place &place() const { return (*m_places)[m_at]; }
    const ParsedElement &element() const { return *place().element; }

    const Places *m_places;
    std::size_t m_at;
};

/// A DCC as a tree, read without fetching or expanding anything.
class DccTree
{
public:
    /// Fails (FileUnreadable) as readXml(), and where it is no digitalCalibrationCertificate.
    static Result<DccTree> read(std::string_view xml);

    DccNode root() const;
    std::vector<DccNode> all() const; ///< every element, in the order of the document
    std::vector<DccNode> all(std::string_view name) const;

private:
    DccTree() = default;

    struct Document;
    std::shared_ptr<Document> m_document;
};

} // namespace dyncal
