// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/atomic_file.h"
#include "tests/support/example_results.h"
#include "tests/support/file_bytes.h"
#include "tests/support/test_program.h"
#include "ui/report/report_drawing.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

using dyncal::CalibrationResults;
using dyncal::DrawnFile;
using dyncal::Recipe;
using dyncal::ReportDrawing;
using dyncal::ReportParts;
using dyncal::Result;
using dyncal::testing::bytesOf;

namespace {

/// All files at once.
Result<std::vector<DrawnFile>> drawReport(
    const CalibrationResults &results, const Recipe &recipe, const std::string &createdUtc)
{
    ReportDrawing drawing(results, recipe, createdUtc, ReportParts::CertificateAndPlots);
    drawing.draw(std::chrono::hours(24));
    return drawing.take();
}

constexpr const char *kCreated = "2026-11-21T03:04:05Z";

Recipe exampleRecipe()
{
    Recipe recipe;
    recipe.certificate.fields = dyncal::example::certificateFields();
    return recipe;
}

/// Draws and writes; the names of the files, the certificate first.
Result<std::vector<std::string>> writeReport(const CalibrationResults &results,
    const Recipe &recipe, const std::string &createdUtc, const std::string &folder)
{
    const auto drawn = drawReport(results, recipe, createdUtc);
    if (!drawn)
        return tl::unexpected(drawn.error());
    std::vector<std::string> names;
    for (const DrawnFile &file : *drawn) {
        const QString path = QString::fromStdString(folder + '/' + file.name);
        if (!QFileInfo(path).dir().mkpath(".")
            || !dyncal::writeFileAtomically(path.toStdString(), file.bytes))
            return dyncal::fail(dyncal::ErrorKind::Internal, {"not written", {}});
        names.push_back(file.name);
    }
    return names;
}

/// Output of a tool, or empty where the tool is not installed or fails.
QByteArray outputOf(const QString &tool, const QStringList &arguments)
{
    QProcess process;
    process.start(tool, arguments);
    return process.waitForFinished(60000) && process.exitStatus() == QProcess::NormalExit
            && process.exitCode() == 0
        ? process.readAllStandardOutput()
        : QByteArray();
}

/// Counts what would make every window lay itself out anew.
class LanguageCount : public QObject
{
public:
    int changes = 0;

protected:
    bool eventFilter(QObject *, QEvent *event) override
    {
        changes += event->type() == QEvent::LanguageChange ? 1 : 0;
        return false;
    }
};

bool has(const char *tool)
{
    return !QStandardPaths::findExecutable(tool).isEmpty();
}

} // namespace

class TestReport : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void write_completeResults_givesCertificateAndPlots();
    void write_twice_givesSameBytes();
    void write_otherDate_changesOnlyDates();
    void write_underOtherLocale_givesSameBytes();
    void write_windowInSwedish_givesSameEnglishBytes();
    void write_swedishRecipe_givesSwedishText();
    void pdf_numbers_areReadable();
    void pdf_structure_isValid();
    void pdf_fonts_areEmbedded();
    void pdf_pages_areVectorsAndOpaque();
    void pdf_pages_carryNumberAndDraftMark();
    void write_noResults_stillGivesCertificate();
    void write_manyPolesAndFindings_repeatsTableHeads();
    void draw_inSteps_givesTheSameBytesAndTellsHowFar();
    void draw_certificateOnly_givesTheSameCertificateAndNothingElse();
    void draw_betweenSteps_leavesLanguageAndNumbersOfTheWindow();

private:
    QString certificate() const { return m_folder.filePath("certificate.pdf"); }

    QTemporaryDir m_folder;
    std::vector<std::string> m_files;
};

void TestReport::initTestCase()
{
    const auto files = writeReport(
        dyncal::example::calibration(), exampleRecipe(), kCreated, m_folder.path().toStdString());
    QVERIFY(files.has_value());
    QCOMPARE(files->front(), std::string("certificate.pdf"));
    m_files = *files;
}

void TestReport::write_completeResults_givesCertificateAndPlots()
{
    QCOMPARE(m_files.size(), std::size_t(21));
    for (const std::string &file : m_files)
        QVERIFY2(
            bytesOf(m_folder.filePath(QString::fromStdString(file))).size() > 2000, file.c_str());
    QVERIFY(QFile::exists(m_folder.filePath("plots/12-singular-values.svg")));
    QVERIFY(bytesOf(certificate()).startsWith("%PDF-1."));
}

void TestReport::write_twice_givesSameBytes()
{
    QTemporaryDir other;
    QVERIFY(writeReport(
        dyncal::example::calibration(), exampleRecipe(), kCreated, other.path().toStdString()));
    for (const std::string &file : m_files)
        QVERIFY2(bytesOf(m_folder.filePath(QString::fromStdString(file)))
                == bytesOf(other.filePath(QString::fromStdString(file))),
            file.c_str());
}

void TestReport::write_otherDate_changesOnlyDates()
{
    QTemporaryDir other;
    QVERIFY(writeReport(dyncal::example::calibration(), exampleRecipe(), "2027-01-02T00:00:00Z",
        other.path().toStdString()));
    const QByteArray pdf = bytesOf(other.filePath("certificate.pdf"));
    QVERIFY(pdf.contains("D:20270102000000Z"));
    QVERIFY(bytesOf(certificate()).contains("D:20261121030405Z"));
    QCOMPARE(bytesOf(m_folder.filePath("plots/12-singular-values.svg")),
        bytesOf(other.filePath("plots/12-singular-values.svg")));
}

void TestReport::write_underOtherLocale_givesSameBytes()
{
    QTemporaryDir other;
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::Swedish));
    const auto files = writeReport(
        dyncal::example::calibration(), exampleRecipe(), kCreated, other.path().toStdString());
    QCOMPARE(QLocale().language(), QLocale::Swedish); // put back
    QLocale::setDefault(before);
    QVERIFY(files.has_value());
    for (const std::string &file : m_files)
        QVERIFY2(bytesOf(m_folder.filePath(QString::fromStdString(file)))
                == bytesOf(other.filePath(QString::fromStdString(file))),
            file.c_str());
}

void TestReport::write_windowInSwedish_givesSameEnglishBytes()
{
    QTranslator window;
    QVERIFY(window.load("dyncal_sv", ":/i18n"));
    QCoreApplication::installTranslator(&window);
    QTemporaryDir other;
    const auto files = writeReport(
        dyncal::example::calibration(), exampleRecipe(), kCreated, other.path().toStdString());
    QCOMPARE(QCoreApplication::translate("core", "Shots"), QString("Skott")); // put back
    QCoreApplication::removeTranslator(&window);
    QVERIFY(files.has_value());
    for (const std::string &file : m_files)
        QVERIFY2(bytesOf(m_folder.filePath(QString::fromStdString(file)))
                == bytesOf(other.filePath(QString::fromStdString(file))),
            file.c_str());
}

void TestReport::write_swedishRecipe_givesSwedishText()
{
    if (!has("pdftotext"))
        QSKIP("pdftotext is not installed");
    QTemporaryDir other;
    dyncal::Recipe recipe = exampleRecipe();
    recipe.certificate.languages = {"sv"};
    QVERIFY(
        writeReport(dyncal::example::calibration(), recipe, kCreated, other.path().toStdString()));
    const QString text = QString::fromUtf8(
        outputOf("pdftotext", {"-raw", other.filePath("certificate.pdf"), "-"}));
    for (const char *words : {"Bevis över dynamisk kalibrering", "sida 1 av", "2,330 00 MHz"})
        QVERIFY2(text.contains(QString::fromUtf8(words)), words);
    for (const char *words : {"Certificate", "to be filled in", "page 1", "Damping"})
        QVERIFY2(!text.contains(QString::fromUtf8(words)), words);
    QCOMPARE(QCoreApplication::translate("core", "Shots"), QString("Shots")); // put back
}

void TestReport::pdf_numbers_areReadable()
{
    if (!has("pdftotext"))
        QSKIP("pdftotext is not installed");
    const QString text = QString::fromUtf8(outputOf("pdftotext", {"-raw", certificate(), "-"}));
    for (const char *words : {"D-2026-0117", "Borås", "12.5 µV/Pa", "2.33000 MHz", "0.00082 MHz",
             "0.02000", "0.00035", "434 kPa", "optic3.h5",
             "9f3a5b7c1d2e4f60718293a4b5c6d7e8f90123456789abcdef0123456789abcd",
             "The results relate only to the item calibrated", "Figure 7.", "SN-0042"})
        QVERIFY2(text.contains(QString::fromUtf8(words)), words);
}

void TestReport::pdf_structure_isValid()
{
    if (!has("qpdf"))
        QSKIP("qpdf is not installed");
    QVERIFY(outputOf("qpdf", {"--check", certificate()}).contains("No syntax"));
}

void TestReport::pdf_fonts_areEmbedded()
{
    if (!has("pdffonts"))
        QSKIP("pdffonts is not installed");
    const QList<QByteArray> lines = outputOf("pdffonts", {certificate()}).trimmed().split('\n');
    QVERIFY(lines.size() > 2);
    for (const QByteArray &line : lines.mid(2)) {
        QVERIFY2(line.contains("DejaVu"), line.constData());
        QVERIFY2(line.contains(" yes "), line.constData());
    }
}

void TestReport::pdf_pages_areVectorsAndOpaque()
{
    if (!has("qpdf"))
        QSKIP("qpdf is not installed");
    const QByteArray plain
        = outputOf("qpdf", {"--qdf", "--object-streams=disable", certificate(), "-"});
    QVERIFY(plain.size() > 1000);
    QVERIFY2(!plain.contains("/Subtype /Image"), "a figure became a picture");
    // Every graphics state must be fully opaque.
    for (const char *key : {"/ca ", "/CA "})
        for (qsizetype at = plain.indexOf(key); at >= 0; at = plain.indexOf(key, at + 1))
            QCOMPARE(plain.mid(at + 4, 1), QByteArray("1"));
    QVERIFY2(bytesOf(certificate()).size() < 1000000, "figures must be drawn from envelopes");
}

void TestReport::pdf_pages_carryNumberAndDraftMark()
{
    if (!has("pdftotext"))
        QSKIP("pdftotext is not installed");
    const QList<QByteArray> pages = outputOf("pdftotext", {"-raw", certificate(), "-"}).split('\f');
    const auto count = pages.size() - 1; // a form feed ends every page
    QVERIFY(count >= 4);
    for (qsizetype i = 0; i < count; ++i) {
        const QString page = QString::fromUtf8(pages[i]).simplified();
        QVERIFY(page.contains(QString("page %1 of %2").arg(i + 1).arg(count)));
        QVERIFY(page.contains("D-2026-0117"));
        QVERIFY(page.contains("Draft, not valid as a certificate"));
        QVERIFY(page.contains("D R A F T") || page.contains("DRAFT"));
    }
}

void TestReport::write_noResults_stillGivesCertificate()
{
    QTemporaryDir folder;
    const auto files
        = writeReport(CalibrationResults{}, Recipe{}, kCreated, folder.path().toStdString());
    QVERIFY(files.has_value());
    QCOMPARE(files->size(), std::size_t(1));
    if (!has("pdftotext"))
        QSKIP("pdftotext is not installed");
    const QByteArray text
        = outputOf("pdftotext", {"-raw", folder.filePath("certificate.pdf"), "-"}).simplified();
    QVERIFY(text.contains("not determined (no model)"));
    QVERIFY(text.contains("no number yet"));
    QVERIFY(text.contains("To be filled in before issue: Certificate number"));
}

void TestReport::write_manyPolesAndFindings_repeatsTableHeads()
{
    CalibrationResults results = dyncal::example::calibration();
    auto model = std::make_shared<dyncal::SensorModel>(*results.model);
    for (int i = 1; i <= 120; ++i) {
        dyncal::Pole pole = model->poles.front();
        pole.frequency_Hz = 1e4 * i;
        pole.poleClass = dyncal::PoleClass::Other;
        model->poles.push_back(pole);
    }
    results.model = model;
    auto assessment = std::make_shared<dyncal::ModelAssessment>(*results.assessment);
    assessment->poles = model->poles;
    results.assessment = assessment;
    QTemporaryDir folder;
    QVERIFY(writeReport(results, exampleRecipe(), kCreated, folder.path().toStdString()));
    if (!has("pdftotext"))
        QSKIP("pdftotext is not installed");
    const QList<QByteArray> pages
        = outputOf("pdftotext", {"-raw", folder.filePath("certificate.pdf"), "-"}).split('\f');
    int headed = 0;
    for (const QByteArray &page : pages)
        if (page.contains("Damping") && page.contains("other"))
            ++headed;
    QVERIFY(headed >= 3);
}

void TestReport::draw_inSteps_givesTheSameBytesAndTellsHowFar()
{
    ReportDrawing drawing(dyncal::example::calibration(), exampleRecipe(), kCreated,
        ReportParts::CertificateAndPlots);
    double fraction = drawing.fraction();
    int steps = 0;
    for (; !drawing.isDone(); ++steps) {
        drawing.draw(std::chrono::milliseconds(0)); // one step
        QVERIFY(drawing.fraction() >= 0.0 && drawing.fraction() <= 1.0);
        fraction = drawing.fraction();
    }
    QVERIFY(steps > 60); // figures, blocks of the certificate and plots, one by one
    QVERIFY(fraction > 0.95);
    const Result<std::vector<DrawnFile>> drawn = drawing.take();
    QVERIFY(drawn.has_value());
    QCOMPARE(drawn->size(), m_files.size());
    for (std::size_t i = 0; i < m_files.size(); ++i) {
        QCOMPARE((*drawn)[i].name, m_files[i]);
        QVERIFY2(QByteArray::fromStdString((*drawn)[i].bytes)
                == bytesOf(m_folder.filePath(QString::fromStdString(m_files[i]))),
            m_files[i].c_str());
    }
}

void TestReport::draw_certificateOnly_givesTheSameCertificateAndNothingElse()
{
    ReportDrawing drawing(
        dyncal::example::calibration(), exampleRecipe(), kCreated, ReportParts::Certificate);
    drawing.draw(std::chrono::hours(1));
    QVERIFY(drawing.isDone());
    const Result<std::vector<DrawnFile>> drawn = drawing.take();
    QVERIFY(drawn.has_value());
    QCOMPARE(drawn->size(), std::size_t(1));
    QVERIFY(QByteArray::fromStdString(drawn->front().bytes) == bytesOf(certificate()));
}

void TestReport::draw_betweenSteps_leavesLanguageAndNumbersOfTheWindow()
{
    QTranslator window;
    QVERIFY(window.load("dyncal_sv", ":/i18n"));
    QCoreApplication::installTranslator(&window);
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::Swedish));
    LanguageCount count;
    QCoreApplication::instance()->installEventFilter(&count);
    ReportDrawing drawing(
        dyncal::example::calibration(), exampleRecipe(), kCreated, ReportParts::Certificate);
    const QString swedish = QCoreApplication::translate("Report", "DRAFT");
    while (!drawing.isDone()) {
        drawing.draw(std::chrono::milliseconds(0));
        QCOMPARE(QCoreApplication::translate("Report", "DRAFT"), swedish);
        QCOMPARE(QLocale().language(), QLocale::Swedish);
    }
    QCOMPARE(count.changes, 0); // windows would lay themselves out anew at each step
    QCoreApplication::instance()->removeEventFilter(&count);
    QLocale::setDefault(before);
    QCoreApplication::removeTranslator(&window);
    const Result<std::vector<DrawnFile>> drawn = drawing.take();
    QVERIFY(drawn.has_value());
    QVERIFY(QByteArray::fromStdString(drawn->front().bytes) == bytesOf(certificate()));
}

DYNCAL_TEST(TestReport)
#include "tst_report.moc"
