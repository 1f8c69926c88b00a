// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/pdf_marks.h"

#include "ui/text/shown_text.h"

namespace dyncal {

QByteArray metadataOf(const std::vector<std::pair<std::string, std::string>> &marks)
{
    QByteArray properties;
    for (const auto &[name, value] : marks) {
        const QByteArray tag = "dyncal:" + rawText(name).toUtf8();
        properties
            += "   <" + tag + ">" + rawText(value).toHtmlEscaped().toUtf8() + "</" + tag + ">\n";
    }
    return "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
           "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
           " <rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
           "  <rdf:Description rdf:about=\"\" xmlns:dyncal=\"https://dyncal.example.org/ns/1.0/\">\n"
        + properties + "  </rdf:Description>\n </rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"r\"?>\n";
}

} // namespace dyncal
