// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/xml_scope.h"

#include "core/xml/xml_limits.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace dyncal {
namespace {

using std::string_view;

/// A start tag: where it ends (behind its '>'), and what it has.
struct StartTag
{
    std::size_t end = 0;
    std::size_t names = 0; ///< attributes and namespaces
    std::size_t spaces = 0; ///< namespaces
    bool isEmpty = false; ///< "<a/>"
};

StartTag startTagAt(string_view xml, std::size_t begin)
{
    StartTag tag;
    char quote = 0;
    std::size_t place = begin;
    for (; place < xml.size() && (quote != 0 || xml[place] != '>'); ++place) {
        const char c = xml[place];
        if (quote != 0) {
            quote = c == quote ? '\0' : quote;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '=') {
            ++tag.names;
        } else if (xml.compare(place, 5, "xmlns") == 0) {
            ++tag.spaces;
        }
    }
    tag.isEmpty = place > begin && xml[place - 1] == '/';
    tag.end = std::min(place + 1, xml.size());
    return tag;
}

/// Behind what is no tag of an element and begins here; 0 where it is one.
std::size_t behindOther(string_view xml, std::size_t begin)
{
    constexpr std::array<std::pair<string_view, string_view>, 3> kOthers{
        {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}}};
    for (const auto &[first, last] : kOthers)
        if (xml.substr(begin).starts_with(first)) {
            const std::size_t end = xml.find(last, begin + first.size());
            return end == xml.npos ? xml.size() : end + last.size();
        }
    return 0;
}

} // namespace

bool keepsXmlLimits(string_view xml)
{
    std::size_t elements = 0;
    std::vector<std::size_t> inScope{0}; // namespaces at each level, with those around
    std::size_t place = xml.find('<');
    while (place < xml.size()) {
        if (const std::size_t behind = behindOther(xml, place); behind > 0) {
            place = xml.find('<', behind);
            continue;
        }
        const StartTag tag = startTagAt(xml, place);
        if (xml.substr(place).starts_with("</")) {
            if (inScope.size() > 1)
                inScope.pop_back();
        } else {
            const std::size_t spaces = inScope.back() + tag.spaces;
            if (++elements > kMostXmlElements || tag.names > kMostXmlNames || spaces > kMostXmlNames
                || inScope.size() > std::size_t(kDeepestXml))
                return false;
            if (!tag.isEmpty)
                inScope.push_back(spaces);
        }
        place = xml.find('<', tag.end);
    }
    return true;
}

} // namespace dyncal
