// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstdio>
#include <map>
#include <string>
#include <utility>

namespace dyncal::testing {

/// A PDF put together object by object, with as many cross-reference tables as are wanted.
class MadePdf
{
public:
    std::string bytes = "%PDF-1.7\n%\xe2\xe3\xcf\xd3\n";

    MadePdf &object(int number, const std::string &content, int generation = 0)
    {
        m_places[number] = {bytes.size(), generation};
        bytes += std::to_string(number) + ' ' + std::to_string(generation) + " obj\n" + content
            + "\nendobj\n";
        return *this;
    }

    /// A table of the objects since the last one, a subsection each; of the first all that are
    /// free, too.
    MadePdf &table(const std::string &trailer)
    {
        const std::size_t begin = bytes.size();
        bytes += m_last == 0 ? "xref\n0 1\n0000000000 65535 f \n" : "xref\n";
        for (const auto &[number, place] : m_places) {
            char entry[64];
            std::snprintf(
                entry, sizeof entry, "%d 1\n%010zu %05d n \n", number, place.first, place.second);
            bytes += entry;
        }
        const std::string previous = m_last == 0 ? "" : "/Prev " + std::to_string(m_last);
        bytes += "trailer\n<<" + trailer + previous + ">>\nstartxref\n" + std::to_string(begin)
            + "\n%%EOF\n";
        m_last = begin;
        m_places.clear();
        return *this;
    }

    /// One page without content; `catalog`, `page` and `trailer` are further entries.
    static MadePdf small(const std::string &catalog = "", const std::string &page = "",
        const std::string &trailer = "")
    {
        return MadePdf()
            .object(1, "<</Type/Catalog/Pages 2 0 R" + catalog + ">>")
            .object(2, "<</Type/Pages/Kids[3 0 R]/Count 1>>")
            .object(3, "<</Type/Page/Parent 2 0 R/MediaBox[0 0 300 300]" + page + ">>")
            .table("/Size 4/Root 1 0 R" + trailer);
    }

private:
    std::map<int, std::pair<std::size_t, int>> m_places;
    std::size_t m_last = 0;
};

} // namespace dyncal::testing
