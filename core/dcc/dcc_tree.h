// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// An element of a DCC that is read. Names are without the prefix of their namespace, which every
/// writer chooses for itself. Valid as long as its tree.
class DccNode
{
public:
    std::string name() const;
    std::string text() const; ///< as it stands
    std::string attribute(const char *name) const; ///< "" without it
    bool hasChild(std::string_view name) const;
    std::vector<DccNode> children() const;
    std::string childText(std::string_view name) const; ///< of the first; "" without it
    DccNode parent() const;
    std::string parentName() const { return parent().name(); }
    /// "measurementResults/measurementResult/results/result[2]": which of several, from 1.
    std::string path() const;
    /// Whether it belongs to an XML signature, whose ids are its own.
    bool isSignature() const;

private:
    friend class DccTree;
    const void *m_node = nullptr; ///< pugixml's; null below the root's parent
};

/// A DCC as a tree, read without fetching or expanding anything.
class DccTree
{
public:
    /// Fails (FileUnreadable) where it is no well-formed XML, not a digitalCalibrationCertificate,
    /// has a document type or entities of its own, is larger than 64 MiB, or is nested deeper than
    /// 100 elements.
    static Result<DccTree> read(const std::string &xml);

    DccNode root() const;
    std::vector<DccNode> all() const; ///< every element, in the order of the document
    std::vector<DccNode> all(std::string_view name) const;

private:
    DccTree() = default;

    struct Document;
    std::shared_ptr<Document> m_document;
};

/// The words of a text between blanks.
std::vector<std::string> wordsIn(std::string_view text);

} // namespace dyncal
