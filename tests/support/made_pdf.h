// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pdf/pdf_archive.h"

#include <cstdio>
#include <string>
#include <vector>

namespace dyncal::testing {

/// A PDF of these objects (the first is the catalog), written by hand: header, objects, table.
inline std::string pdfOfObjects(const std::vector<std::string> &objects)
{
    std::string pdf = "%PDF-1.4\n";
    std::string table = "xref\n0 " + std::to_string(objects.size() + 1) + "\n0000000000 65535 f \n";
    for (std::size_t i = 0; i < objects.size(); ++i) {
        char entry[21];
        std::snprintf(entry, sizeof entry, "%010zu 00000 n \n", pdf.size());
        table += entry;
        pdf += std::to_string(i + 1) + " 0 obj\n" + objects[i] + "\nendobj\n";
    }
    const std::string begin = std::to_string(pdf.size());
    return pdf + table + "trailer\n<< /Size " + std::to_string(objects.size() + 1)
        + " /Root 1 0 R >>\nstartxref\n" + begin + "\n%%EOF\n";
}

inline std::string streamObject(const std::string &bytes, const std::string &keys = {})
{
    return "<< /Length " + std::to_string(bytes.size()) + " " + keys + " >>\nstream\n" + bytes
        + "\nendstream";
}

/// Two pages, each with a line of its own, and a font that is embedded (as far as keys say).
/// `catalog`: further keys of the catalog.
inline std::string madePages(const std::string &catalog = {})
{
    const std::string page
        = "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 595 842] /Resources << /Font << /F1 7 0 R >> >>";
    return pdfOfObjects({"<< /Type /Catalog /Pages 2 0 R " + catalog + ">>",
        "<< /Type /Pages /Kids [3 0 R 4 0 R] /Count 2 >>", page + " /Contents 5 0 R >>",
        page + " /Contents 6 0 R >>", streamObject("BT /F1 12 Tf 72 700 Td <0001> Tj ET"),
        streamObject("BT /F1 12 Tf 72 600 Td <0002> Tj ET"),
        "<< /Type /Font /Subtype /Type0 /BaseFont /Made /Encoding /Identity-H /DescendantFonts [8 0 R] >>",
        "<< /Type /Font /Subtype /CIDFontType2 /BaseFont /Made /FontDescriptor 9 0 R"
        " /CIDSystemInfo << /Registry (Adobe) /Ordering (Identity) /Supplement 0 >> >>",
        "<< /Type /FontDescriptor /FontName /ABCDEF+Made /Flags 4 /FontBBox [0 0 1 1] /ItalicAngle 0"
        " /Ascent 1 /Descent 0 /CapHeight 1 /StemV 1 /FontFile2 10 0 R >>",
        streamObject("no real font")});
}

/// What looks like an ICC profile of sRGB: its head.
inline std::string madeProfile()
{
    std::string profile(200, '\0');
    profile.replace(12, 4, "mntr").replace(16, 4, "RGB ").replace(36, 4, "acsp");
    return profile;
}

inline PdfArchive madeArchive(const std::string &results = "{\"a\": 1}\n")
{
    PdfArchive archive;
    archive.metadata = {"Bevis över 17", "Lab <&> Å", "Dyncal", "Qt 6", "sv", "en",
        "2026-01-31T12:00:00Z", {{"number", "17"}, {"amends", ""}, {"head", "<&\"'>\u00e5"}}};
    archive.colorProfile = madeProfile();
    archive.bookmarks = {{"Resultat", 0, 700.25}, {"Ωmega", 1, 600.0}};
    archive.attachments = {{"results.json", "application/json", "Data", "all results", results},
        {"recipe.json", "application/json", "Supplement", "every decision", "{}"}};
    return archive;
}

} // namespace dyncal::testing
