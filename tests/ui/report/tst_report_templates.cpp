// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/built_in_templates.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"
#include "ui/report/document_words.h"
#include "ui/report/report_drawing.h"
#include "ui/report/report_figures.h"
#include "ui/report/report_logo.h"

#include <QBuffer>
#include <QPainter>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

using namespace dyncal;

namespace {

constexpr const char *kCreated = "2026-11-21T03:04:05Z";
constexpr const char *kSvg
    = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 10"><rect width="20" height="10" fill="#204080"/></svg>)";

Recipe recipeIn(const std::vector<std::string> &languages)
{
    Recipe recipe;
    recipe.certificate.fields = example::certificateFields();
    recipe.certificate.languages = languages;
    return recipe;
}

std::string pdfOf(const ChosenTemplate &chosen, const Recipe &recipe = recipeIn({"en"}))
{
    ReportDrawing drawing(
        example::calibration(), recipe, kCreated, ReportParts::Certificate, chosen);
    drawing.draw(std::chrono::hours(24));
    const auto drawn = drawing.take();
    return drawn ? drawn->front().bytes : std::string();
}

/// What a tool of poppler says of the document.
QString said(const std::string &pdf, const QString &tool, const QStringList &arguments)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("c.pdf");
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return {};
    file.write(pdf.data(), static_cast<qint64>(pdf.size()));
    file.close();
    QStringList all = arguments;
    std::replace(all.begin(), all.end(), QString("FILE"), path);
    QProcess process;
    process.start(tool, all);
    return process.waitForFinished(60000) ? QString::fromUtf8(process.readAllStandardOutput())
                                          : QString();
}

QString textOf(const std::string &pdf)
{
    return said(pdf, "pdftotext", {"-layout", "FILE", "-"});
}

QString firstPage(const std::string &pdf)
{
    return said(pdf, "pdftotext", {"-layout", "-l", "1", "FILE", "-"});
}

ChosenTemplate withLogo(const std::string &bytes, const char *name)
{
    ChosenTemplate chosen;
    chosen.layout.logo = name;
    chosen.logo = bytes;
    return chosen;
}

std::string pngOf(const QColor &color)
{
    QImage image(40, 20, QImage::Format_ARGB32);
    image.fill(color);
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return buffer.data().toStdString();
}

} // namespace

/// Certificates by templates, on paper.
class TestReportTemplates : public QObject
{
    Q_OBJECT

private slots:
    void accredited_isTheSameDocument()
    {
        const std::string plain = pdfOf({});
        QVERIFY(!plain.empty());
        QVERIFY(pdfOf(*chooseTemplate("accredited")) == plain);
    }
    void everyTemplate_hasItsKeyResultsOnPageOne_andSaysWhatItMust()
    {
        for (const BuiltInTemplate &known : builtInTemplates())
            for (const char *language : {"en", "sv"}) {
                const std::string pdf = pdfOf(*chooseTemplate(known.name), recipeIn({language}));
                const bool isSwedish = language == std::string("sv");
                const QString first = firstPage(pdf);
                const QString text = textOf(pdf);
                QVERIFY2(first.contains(isSwedish ? "Huvudresultat" : "Key results"),
                    known.name.c_str());
                QVERIFY2(first.contains("Damping ratio") != isSwedish, known.name.c_str());
                QCOMPARE(text.contains("shall not be reproduced except in full"), !isSwedish);
                QVERIFY2(text.contains("SN-0042"), known.name.c_str());
            }
    }
    void shortOne_hasNeitherShotsNorFigures()
    {
        const QString usual = textOf(pdfOf({}));
        const QString little = textOf(pdfOf(*chooseTemplate("short")));
        for (const char *words :
            {"Measured responses, shot by shot", "Model of the sensor", "Figure 1."}) {
            QVERIFY2(usual.contains(words), words);
            QVERIFY2(!little.contains(words), words);
        }
        QVERIFY(little.contains("Frequency response"));
        const auto figures = [](const char *name) {
            return textOf(pdfOf(*chooseTemplate(name))).count(QRegularExpression("Figure \\d+\\."));
        };
        QVERIFY(figures("full") > figures("accredited"));
        QVERIFY(figures("research") > figures("full"));
    }
    /// Every figure that a template may name is one that can be drawn, and the other way round.
    void figures_areThoseThatAreDrawn()
    {
        std::vector<std::string> drawn;
        for (const FigureMaker &make : figureMakers(example::calibration()))
            if (const auto figure = make())
                drawn.push_back(figure->id);
        for (const std::string &id : drawn)
            QVERIFY2(
                std::ranges::find(templateFigures(), id) != templateFigures().end(), id.c_str());
    }
    void logo_isOnTheFirstPage_andReproducible()
    {
        for (const auto &chosen : {withLogo(kSvg, "a.svg"), withLogo(pngOf(Qt::red), "a.png"),
                 withLogo(pngOf(QColor(0, 0, 255, 60)), "b.png")}) {
            const std::string pdf = pdfOf(chosen);
            QVERIFY(pdf != pdfOf({}));
            QVERIFY(pdf == pdfOf(chosen));
            const QString first = firstPage(pdf); // the key results are still on it
            QVERIFY(first.contains("SN-0042") && first.contains("Damping ratio"));
            const bool isImage = said(pdf, "pdfimages", {"-list", "FILE"}).contains("image");
            QCOMPARE(isImage, !chosen.layout.logo.ends_with(".svg"));
            // No transparency: every page switches masks off ("/SMask /None"), and no image has
            // one.
            const QByteArray bytes = QByteArray::fromStdString(pdf);
            QCOMPARE(bytes.count("/SMask"), bytes.count("/SMask /None"));
        }
    }
    void logo_thatCannotBeDrawn_isSaid()
    {
        const std::string png = pngOf(Qt::red);
        QVERIFY(ReportLogo({png, false}).isDrawable());
        QVERIFY(!ReportLogo({png.substr(0, 30), false}).isDrawable());
        QVERIFY(ReportLogo({kSvg, true}).isDrawable());
        QVERIFY(!ReportLogo({"<svg", true}).isDrawable());
        const QTemporaryDir folder;
        const auto put = [&](const char *name, const std::string &bytes) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(bytes.data(), static_cast<qint64>(bytes.size()));
        };
        put("lab.json", templateJson(withLogo({}, "logo.png").layout));
        put("logo.png", png);
        const std::string path = folder.filePath("lab.json").toStdString();
        QVERIFY(drawableTemplate(path));
        put("logo.png", png.substr(0, 30));
        const auto refused = drawableTemplate(path);
        QVERIFY(!refused && refused.error().kind == ErrorKind::Usage);
        QVERIFY(english(refused.error().message).find("logo.png") != std::string::npos);
    }
    void logo_isScaledIntoItsArea()
    {
        QImage page(200, 100, QImage::Format_RGB32);
        page.fill(Qt::white);
        QPainter painter(&page);
        ReportLogo({kSvg, true}).draw(painter, QRectF(0, 0, 200, 50)); // 100 x 50 at the right
        painter.end();
        QCOMPARE(page.pixelColor(150, 25), QColor("#204080"));
        QCOMPARE(page.pixelColor(50, 25), QColor(Qt::white));
        QCOMPARE(page.pixelColor(150, 60), QColor(Qt::white));
    }
    void twoLanguages_standSideBySide()
    {
        const QString both = textOf(pdfOf({}, recipeIn({"en", "sv"})));
        QVERIFY2(both.contains("Customer / Kund"), qPrintable(both.left(3000)));
        for (const char *words : {"Damping ratio", "Relativ dämpning",
                 "shall not be reproduced except in full", "Kalibrerat objekt"})
            QVERIFY2(both.contains(QString::fromUtf8(words)), words);
        QVERIFY(textOf(pdfOf({}, recipeIn({"sv", "en"}))).contains("Kund / Customer"));
        const QString swedish = textOf(pdfOf({}, recipeIn({"sv"})));
        QVERIFY(!swedish.contains("Damping ratio") && !swedish.contains(" / Customer"));
        // Numbers and names stand once.
        QCOMPARE(both.count("SN-0042"), textOf(pdfOf({})).count("SN-0042"));
        QCOMPARE(both.count("2.33000 MHz"), textOf(pdfOf({})).count("2.33000 MHz"));
        QVERIFY(!both.contains("2,330"));
    }
    void words_labelsBeside_sentencesBelow_sameOnce()
    {
        const DocumentWords words("sv");
        QCOMPARE(words({"%1", {"2.33 MHz"}}), QString("2.33 MHz"));
        QCOMPARE(words.inTable({"%1", {"2.33 MHz"}}), QString("2.33 MHz"));
        const Message label{"Damping ratio", {}};
        QCOMPARE(words(label), QString::fromUtf8("Damping ratio / Relativ dämpning"));
        QCOMPARE(words.inTable(label), QString::fromUtf8("Damping ratio\nRelativ dämpning"));
        const QString sentence = words({"The results relate only to the item calibrated.", {}});
        QVERIFY2(sentence.startsWith("The results") && sentence.count('\n') == 1
                && !sentence.contains(" / "),
            qPrintable(sentence));
        QCOMPARE(DocumentWords()(label), QString("Damping ratio"));
        QCOMPARE(DocumentWords().inTable(label), QString("Damping ratio"));
    }
};

DYNCAL_TEST(TestReportTemplates)
#include "tst_report_templates.moc"
