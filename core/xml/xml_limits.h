// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>

namespace dyncal {

// What an XML file may ask of this program, whoever reads it. A certificate with plots and files
// inside has some MiB, ten thousand elements and twenty levels; what goes beyond is no certificate
// but an attack or an accident.

/// As many as a PDF that a certificate is inside of.
inline constexpr std::size_t kMostXmlBytes = std::size_t(64) << 20U;
/// An element takes some 300 bytes of memory, however short it is. Counted by their tags, of which
/// each has two (an empty one may have one).
inline constexpr std::size_t kMostXmlElements = 500000;
/// Attributes and namespaces of an element, and namespaces of all elements around it together. A
/// certificate has ten.
inline constexpr std::size_t kMostXmlNames = 200;
/// What goes through a tree may then call itself.
inline constexpr int kDeepestXml = 100;

} // namespace dyncal
