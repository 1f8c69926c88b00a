// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Certificates in each language: whole, with the language's numbers, and two of them side by side.

#include "core/certificate/certificate.h"
#include "core/project/built_in_templates.h"
#include "core/project/document_languages.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"
#include "ui/report/report_drawing.h"
#include "ui/report/report_figures.h"
#include "ui/report/report_language.h"

#include <QFile>
#include <QProcess>
#include <QSet>
#include <QXmlStreamReader>
#include <QtTest>

using namespace dyncal;

namespace {

constexpr const char *kCreated = "2026-11-21T03:04:05Z";

Recipe recipeIn(const std::vector<std::string> &languages)
{
    Recipe recipe;
    recipe.certificate.fields = example::certificateFields();
    recipe.certificate.languages = languages;
    return recipe;
}

/// The example, with a sentence of the program where it has one of its own.
CalibrationResults calibration()
{
    CalibrationResults results = example::calibration();
    auto decomposition = std::make_shared<DecompositionResult>(*results.decomposition);
    decomposition->suggestion.reason
        = {"Order %1 has the smallest BIC on the pre-whitened response among orders 1 to %2.",
            {"2", "20"}};
    results.decomposition = decomposition;
    return results;
}

std::string pdfOf(const std::vector<std::string> &languages, const char *name = "accredited")
{
    ReportDrawing drawing(calibration(), recipeIn(languages), kCreated, ReportParts::Certificate,
        *chooseTemplate(name));
    drawing.draw(std::chrono::hours(24));
    const auto drawn = drawing.take();
    return drawn ? drawn->front().bytes : std::string();
}

QString textOf(const std::string &pdf)
{
    QProcess reader;
    reader.start("pdftotext", {"-layout", "-", "-"});
    reader.write(pdf.data(), static_cast<qint64>(pdf.size()));
    reader.closeWriteChannel();
    return reader.waitForFinished(60000) ? QString::fromUtf8(reader.readAllStandardOutput())
                                         : QString();
}

/// Numbers with a fraction, as core writes them, in alphabetical order. Those of sentences stand in
/// another order in another language.
QStringList fractionsIn(QString text)
{
    text.remove(QRegularExpression("(?<=\\d) (?=\\d{1,3}(?!\\d))")); // groups of digits
    static const QRegularExpression number("(?<![\\w.,])\\d+[.,]\\d+(?![\\w]|[.,]\\d)");
    QStringList found;
    for (auto match = number.globalMatch(text); match.hasNext();)
        found << match.next().captured().replace(',', '.');
    found.sort();
    return found;
}

void take(const Message &message, std::vector<Message> &all)
{
    all.push_back(message);
    for (const Message &more : message.below)
        take(more, all);
}

/// Every sentence and word of a certificate.
std::vector<Message> messagesOf(const CertificateData &data)
{
    std::vector<Message> all;
    take(data.title, all);
    for (const CertificateSection &section : data.sections) {
        take(section.title, all);
        for (const auto *list : {&section.paragraphs, &section.notes})
            for (const Message &message : *list)
                take(message, all);
        for (const CertificateField &field : section.fields) {
            take(field.label, all);
            take(field.value, all);
        }
        for (const CertificateTable &table : section.tables) {
            take(table.caption, all);
            for (const CertificateColumn &column : table.columns)
                take(column.heading, all);
            for (const auto &row : table.rows)
                for (const Message &cell : row)
                    take(cell, all);
        }
        for (const CertificateFigure &figure : section.figures)
            take(figure.caption, all);
    }
    return all;
}

bool hasWords(const char *text)
{
    QString words = QString::fromUtf8(text);
    words.remove(QRegularExpression("%[LV]?\\d"));
    return words.contains(QRegularExpression("[A-Za-z]"));
}

struct Translated
{
    QString context, source, translation;
    bool isFinished = true;
};

std::vector<Translated> entriesOf(const QString &language)
{
    QFile file(
        qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/translations/dyncal_" + language + ".ts");
    std::vector<Translated> entries;
    if (!file.open(QIODevice::ReadOnly))
        return entries;
    QXmlStreamReader xml(&file);
    Translated now;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == QLatin1String("name"))
            now.context = xml.readElementText();
        else if (xml.name() == QLatin1String("source"))
            now.source = xml.readElementText();
        else if (xml.name() == QLatin1String("translation")) {
            now.isFinished = !xml.attributes().hasAttribute("type");
            now.translation = xml.readElementText(QXmlStreamReader::IncludeChildElements);
            entries.push_back(now);
        }
    }
    return entries;
}

QStringList placesIn(const QString &text)
{
    static const QRegularExpression place("%[LV]?\\d");
    QSet<QString> found;
    for (auto match = place.globalMatch(text); match.hasNext();)
        found << match.next().captured();
    QStringList sorted = found.values();
    sorted.sort();
    return sorted;
}

} // namespace

class TestReportLanguages : public QObject
{
    Q_OBJECT

private slots:
    void german_hasEverySentenceOfACertificate()
    {
        QTranslator german;
        QVERIFY(german.load("dyncal_de", ":/i18n"));
        for (const BuiltInTemplate &known : builtInTemplates())
            for (const Recipe &recipe : {recipeIn({"de"}), Recipe()})
                for (const CalibrationResults &results : {calibration(), CalibrationResults{}})
                    for (const Message &message : messagesOf(makeCertificate(
                             results, recipe, kCreated, *chooseTemplate(known.name))))
                        if (hasWords(message.text))
                            QVERIFY2(
                                !german.translate("core", message.text).isEmpty(), message.text);
    }
    /// Words of the English sentences; what German shares with English is not among them.
    void german_leavesNoEnglishWord()
    {
        static const QRegularExpression english(
            "\\b(the|of|and|with|from|not|response|sensor|shot|shots|damping|frequency|records?|"
            "sensitivity|magnitude|uncertainty|certificate|page|figure|order|model|noise|time)\\b",
            QRegularExpression::CaseInsensitiveOption);
        for (const BuiltInTemplate &known : builtInTemplates()) {
            QString text = textOf(pdfOf({"de"}, known.name.c_str()));
            QVERIFY2(text.contains("Hauptergebnisse"), known.name.c_str());
            for (const auto &[key, typed] : example::certificateFields())
                for (const QString &word : QString::fromStdString(typed).split(' '))
                    text.remove(word);
            const auto found = english.match(text);
            const auto where = std::max<qsizetype>(0, found.capturedStart() - 60);
            QVERIFY2(!found.hasMatch(), qPrintable(text.mid(where, 120)));
        }
    }
    void translations_areFinished_withThePlacesOfTheirSource_andDecimalCommas()
    {
        static const QRegularExpression point("(?<![\\d.])\\d\\.\\d+ (%|u|s|ms|Hz|kPa)");
        for (const QString &language : {QString("sv"), QString("de")}) {
            const std::vector<Translated> entries = entriesOf(language);
            QVERIFY(entries.size() > 900);
            for (const Translated &entry : entries) {
                QVERIFY2(entry.isFinished, qPrintable(entry.source));
                if (entry.source.contains("%n"))
                    continue;
                QVERIFY2(placesIn(entry.source) == placesIn(entry.translation),
                    qPrintable(language + ": " + entry.source));
                QVERIFY2(language == "sv" || !entry.translation.contains(point),
                    qPrintable(entry.translation));
            }
        }
    }
    /// Every number of the English one, digit by digit, stands in the others, and none with a
    /// point.
    void numbers_areThoseOfTheEnglishOne_withTheirMark()
    {
        const QString english = textOf(pdfOf({"en"}));
        QVERIFY(english.contains("2.33000 MHz"));
        for (const char *language : {"sv", "de"}) {
            const QString text = textOf(pdfOf({language}));
            QVERIFY2(text.contains(QString::fromUtf8("2,330 00 MHz")), language);
            QCOMPARE(fractionsIn(text).size(), fractionsIn(english).size());
            QCOMPARE(fractionsIn(text), fractionsIn(english));
            for (const char *typed : {"SN-0042", "D-2026-0117"})
                QVERIFY2(text.contains(typed), typed);
        }
    }
    void axes_haveTheMarkToo()
    {
        for (const char *language : {"sv", "de"}) {
            ReportDrawing drawing(
                calibration(), recipeIn({language}), kCreated, ReportParts::CertificateAndPlots);
            drawing.draw(std::chrono::hours(24));
            const auto drawn = drawing.take();
            QVERIFY(drawn.has_value());
            int commas = 0;
            for (std::size_t i = 2; i < drawn->size(); ++i) { // behind certificate and DCC
                static const QRegularExpression tick(">-?\\d+([.,])\\d+</text>");
                const QString svg = QString::fromStdString((*drawn)[i].bytes);
                for (auto match = tick.globalMatch(svg); match.hasNext(); ++commas)
                    QVERIFY2(match.next().captured(1) == ",", (*drawn)[i].name.c_str());
            }
            QVERIFY(commas > 20);
        }
    }
    /// A logarithmic axis has its prefix where it has its unit, and bare numbers at its ticks.
    void decades_areNumbersInTheUnitOfTheirAxis()
    {
        ReportDrawing drawing(
            calibration(), recipeIn({"en"}), kCreated, ReportParts::CertificateAndPlots);
        drawing.draw(std::chrono::hours(24));
        const auto drawn = drawing.take();
        QVERIFY(drawn.has_value());
        int titles = 0;
        for (std::size_t i = 2; i < drawn->size(); ++i) { // behind certificate and DCC
            const QString svg = QString::fromStdString((*drawn)[i].bytes);
            static const QRegularExpression prefixed(">\\d+.[kMGm\u00b5]</text>");
            QVERIFY2(!svg.contains(prefixed), (*drawn)[i].name.c_str());
            titles += svg.contains("Frequency / kHz") ? 1 : 0;
        }
        QVERIFY(titles >= 2);
    }
    void captions_areInBothLanguages()
    {
        const QString both = textOf(pdfOf({"en", "sv"})).simplified();
        QVERIFY(both.contains("in the z-plane; poles: 2, zeros: "));
        QVERIFY(both.contains("i z-planet; poler: 2, nollställen: "));
    }
    void german_besideEnglish_numbersOnce()
    {
        const QString both = textOf(pdfOf({"en", "de"}));
        for (const char *words : {"Customer / Auftraggeber", "Undamped natural frequency",
                 "Ungedämpfte Eigenfrequenz", "shall not be reproduced except in full",
                 "schriftliche Genehmigung des Laboratoriums"})
            QVERIFY2(both.contains(QString::fromUtf8(words)), words);
        QCOMPARE(both.count("2.33000 MHz"), textOf(pdfOf({"en"})).count("2.33000 MHz"));
        QVERIFY(!both.contains("2,330"));
        const QString other = textOf(pdfOf({"de", "en"}));
        QVERIFY(other.contains("Auftraggeber / Customer"));
        QVERIFY(other.contains(QString::fromUtf8("2,330 00 MHz")));
        QVERIFY(!other.contains("2.33000"));
    }
    void everyLanguage_isOneThatCanBeDrawn_theSameEachTime()
    {
        for (const std::string &language : documentLanguageCodes()) {
            const std::string pdf = pdfOf({language});
            QVERIFY(!pdf.empty() && pdf == pdfOf({language}));
            QCOMPARE(QLocale().decimalPoint(), QString(".")); // put back
        }
    }
};

DYNCAL_TEST(TestReportLanguages)
#include "tst_report_languages.moc"
