// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/pdf_increment.h"

#include "core/signing/pdf_outline.h"

#include <array>
#include <cstdio>
#include <map>

namespace dyncal {
namespace {

/// "D:20260131042311Z" of "2026-01-31T04:23:11Z" (ISO 32000-1, 7.9.4).
std::string pdfDate(const std::string &utc)
{
    std::string digits;
    for (const char c : utc)
        if (c >= '0' && c <= '9')
            digits += c;
    return "D:" + digits + 'Z';
}

/// The numbers have ten places each, so that they can be filled in when they are known.
std::string byteRange(std::size_t begin, std::size_t end, std::size_t size)
{
    std::array<char, 64> text{};
    std::snprintf(
        text.data(), text.size(), "/ByteRange[0 %-10zu %-10zu %-10zu]", begin, end, size - end);
    return text.data();
}

std::string signatureDictionary(const PdfSignatureWords &words)
{
    return "<</Type/Sig/Filter/Adobe.PPKLite/SubFilter/ETSI.CAdES.detached/M(" + pdfDate(words.utc)
        + ")/Name" + pdfTextString(words.signer) + byteRange(0, 0, 0) + "/Contents<"
        + std::string(2 * kCmsRoom, '0') + ">>>";
}

std::string reference(int object)
{
    return std::to_string(object) + " 0 R";
}

/// Objects behind the last one of the PDF.
struct NewObjects
{
    int field, signature, appearance;
};

std::string fieldDictionary(const PdfOutline &outline, const NewObjects &made)
{
    // 132: printed and locked; a rectangle of no size is not seen (12.7.4.5).
    const std::string seen = outline.isSeen()
        ? "/Rect" + outline.rectangle + "/AP<</N " + reference(made.appearance) + ">>"
        : "/Rect[0 0 0 0]";
    return "<</Type/Annot/Subtype/Widget/FT/Sig/T(Signature1)/F 132" + seen + "/P "
        + outline.pageReference + "/V " + reference(made.signature) + ">>";
}

/// Draws nothing: who signs, and when, is printed below it.
std::string emptyAppearance(const PdfOutline &outline)
{
    return "<</Type/XObject/Subtype/Form/BBox" + outline.rectangle
        + "/Resources<<>>/Length 0>>stream\n\nendstream";
}

/// Objects as they are appended: "begin" is where each stands in the file.
class Update
{
public:
    explicit Update(const std::string &pdf)
        : m_bytes(pdf)
    {
        if (!m_bytes.ends_with('\n'))
            m_bytes += '\n';
    }

    void add(int object, int generation, const std::string &content)
    {
        m_places[object] = {m_bytes.size(), generation};
        m_bytes += std::to_string(object) + ' ' + std::to_string(generation) + " obj\n" + content
            + "\nendobj\n";
    }

    std::string end(const PdfOutline &outline, int size)
    {
        const std::size_t table = m_bytes.size();
        m_bytes += "xref\n";
        for (const auto &[object, place] : m_places) { // a subsection each
            std::array<char, 64> entry{};
            std::snprintf(entry.data(), entry.size(), "%d 1\n%010zu %05d n \n", object, place.first,
                place.second);
            m_bytes += entry.data();
        }
        m_bytes += "trailer\n<</Size " + std::to_string(size) + "/Root " + outline.rootReference
            + outline.trailerRest + "/Prev " + std::to_string(outline.table) + ">>\nstartxref\n"
            + std::to_string(table) + "\n%%EOF\n";
        return std::move(m_bytes);
    }

private:
    std::string m_bytes;
    std::map<int, std::pair<std::size_t, int>> m_places;
};

} // namespace

Result<UnsignedIncrement> withSignatureField(const std::string &pdf, const PdfSignatureWords &words)
{
    const Result<PdfOutline> outline = outlineOf(pdf, [](int size) {
        return PdfAdditions{reference(size), reference(size)};
    });
    if (!outline)
        return tl::unexpected<Error>(outline.error());
    const int first = outline->size;
    const NewObjects made{first, first + 1, first + 2};
    Update update(pdf);
    update.add(outline->root, outline->rootGeneration, outline->rootContent);
    update.add(outline->page, outline->pageGeneration, outline->pageContent);
    update.add(made.field, 0, fieldDictionary(*outline, made));
    update.add(made.signature, 0, signatureDictionary(words));
    if (outline->isSeen())
        update.add(made.appearance, 0, emptyAppearance(*outline));
    UnsignedIncrement increment{
        update.end(*outline, outline->isSeen() ? made.appearance + 1 : made.appearance)};
    const std::string open = "/Contents<" + std::string(64, '0'), range = "/ByteRange[0 0 ";
    increment.holeBegin = increment.bytes.find(open, pdf.size()) + std::string("/Contents").size();
    increment.holeEnd = increment.holeBegin + 2 * kCmsRoom + 2;
    const std::string filled
        = byteRange(increment.holeBegin, increment.holeEnd, increment.bytes.size());
    increment.bytes.replace(increment.bytes.find(range, pdf.size()), filled.size(), filled);
    return increment;
}

} // namespace dyncal
