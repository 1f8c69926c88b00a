// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/pdf_marks.h"

#include "tests/support/test_program.h"

#include <QXmlStreamReader>
#include <QtTest>

using namespace dyncal;

namespace {

/// Name and text of every property of Dyncal's, by an XML parser.
std::vector<std::pair<std::string, std::string>> readMarks(const QByteArray &metadata)
{
    std::vector<std::pair<std::string, std::string>> marks;
    QXmlStreamReader xml(metadata);
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::StartElement
            && xml.namespaceUri() == QLatin1String("https://dyncal.example.org/ns/1.0/")) {
            const std::string name = xml.name().toString().toStdString();
            marks.emplace_back(name, xml.readElementText().toStdString());
        }
    return xml.hasError() ? std::vector<std::pair<std::string, std::string>>() : marks;
}

} // namespace

/// The metadata of an issued certificate.
class TestPdfMarks : public QObject
{
    Q_OBJECT

private slots:
    void marks_areXmlThatComesBack()
    {
        const std::vector<std::pair<std::string, std::string>> marks{
            {"number", "17"}, {"amends", ""}, {"head", "<&\"'>\u00e5"}};
        QVERIFY(readMarks(metadataOf(marks)) == marks);
    }

    /// As readable text, by which dyncal verify finds them.
    void marks_standAsText()
    {
        QVERIFY(metadataOf({{"number", "17"}}).contains("<dyncal:number>17</dyncal:number>"));
    }
};

DYNCAL_TEST(TestPdfMarks)
#include "tst_pdf_marks.moc"
