// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/built_in_templates.h"
#include "core/project/certificate_template.h"
#include "core/project/recipe.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/certificate/certificate_page.h"

#include <QCalendarWidget>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

using namespace dyncal;
using test::PageBench;
using test::waitComputed;

namespace {

using Bench = PageBench<test::DatedPage<CertificatePage>>;

std::string fieldOf(const Bench &bench, const std::string &key)
{
    const auto &fields = bench.recipe().certificate.fields;
    const auto found = fields.find(key);
    return found == fields.end() ? std::string("(none)") : found->second;
}

void clear(Bench &bench, const QString &name)
{
    auto *edit = bench.control<QLineEdit>(name);
    edit->selectAll();
    QTest::keyClick(edit, Qt::Key_Delete);
    QTest::keyClick(edit, Qt::Key_Return);
}

} // namespace

/// What is filled in for the certificate, and what the page says of the rest.
class TestCertificatePage : public QObject
{
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void everyField_typedIsInTheRecipe_andUndone();
    void blanks_areTakenOff_andNothingIsNoEntry();
    void foreignText_isKeptToTheLetter();
    void remarks_typed_areOneStep_andUndoneAtOnce();
    void requiredFields_countDownToNone();
    void status_isNotDone_whileAFieldIsEmpty();
    void dateThatIsNone_isSaidBesideItsField();
    void language_isOfTheDocument_notOfTheWindow();
    void languages_twoSideBySide();
    void date_isChosenInACalendar_andUndone();
    void template_builtIn_isChosenAndUndone();
    void template_file_isTakenOrRefused();
    void template_unknown_isShownAndSaid();
    void swedish_labelsAndCounts();
    void findings_areCounted();
};

void TestCertificatePage::everyField_typedIsInTheRecipe_andUndone()
{
    Bench bench;
    int typed = 0;
    for (QLineEdit *edit : bench.page.findChildren<QLineEdit *>()) {
        if (!edit->objectName().startsWith("field_"))
            continue;
        const QString text = "value of " + edit->objectName();
        bench.type(edit->objectName(), text);
        QCOMPARE(fieldOf(bench, edit->objectName().mid(6).toStdString()), text.toStdString());
        ++typed;
    }
    QVERIFY(typed >= 16);
    QCOMPARE(bench.session.undoStack().count(), typed);
    while (bench.session.undoStack().canUndo())
        bench.session.undoStack().undo();
    QVERIFY(bench.recipe().certificate.fields.empty());
    for (const QLineEdit *edit : bench.page.findChildren<QLineEdit *>())
        QVERIFY2(edit->text().isEmpty(), qPrintable(edit->objectName()));
    QVERIFY(!bench.session.isComputing()); // no number depends on a name
}

void TestCertificatePage::blanks_areTakenOff_andNothingIsNoEntry()
{
    Bench bench;
    bench.type("field_customer", "  Testbolaget AB ");
    QCOMPARE(fieldOf(bench, "customer"), std::string("Testbolaget AB"));
    QCOMPARE(bench.control<QLineEdit>("field_customer")->text(), QString("Testbolaget AB"));
    clear(bench, "field_customer");
    QVERIFY(!bench.recipe().certificate.fields.contains("customer"));
    bench.type("field_customer", "    ");
    QVERIFY(!bench.recipe().certificate.fields.contains("customer"));
    QCOMPARE(bench.session.undoStack().count(), 2); // typed, emptied; blanks are no step
}

void TestCertificatePage::foreignText_isKeptToTheLetter()
{
    Bench bench;
    const QString name = QString::fromUtf8("Å&B <b>\"Öst\"</b> \\ %1 ½");
    bench.control<QLineEdit>("field_customer")->setText(name);
    QTest::keyClick(bench.control<QLineEdit>("field_customer"), Qt::Key_Return);
    QCOMPARE(fieldOf(bench, "customer"), name.toStdString());
    const Result<Recipe> again = parseRecipe(recipeJson(bench.recipe()));
    QVERIFY(again);
    QCOMPARE(again->certificate.fields.at("customer"), name.toStdString());
    QVERIFY(!bench.control<QLabel>("missingFields")->text().contains("<b>"));
}

void TestCertificatePage::remarks_typed_areOneStep_andUndoneAtOnce()
{
    Bench bench;
    auto *remarks = bench.control<QPlainTextEdit>("field_remarks");
    QTest::keyClicks(remarks, "as found");
    QTest::keyClick(remarks, Qt::Key_Return);
    QTest::keyClicks(remarks, "as left");
    QCOMPARE(fieldOf(bench, "remarks"), std::string("as found\nas left"));
    QCOMPARE(bench.session.undoStack().count(), 1);
    bench.session.undoStack().undo();
    QVERIFY(remarks->toPlainText().isEmpty());
    bench.session.undoStack().redo();
    QCOMPARE(remarks->toPlainText(), QString("as found\nas left"));
}

void TestCertificatePage::requiredFields_countDownToNone()
{
    Bench bench;
    auto *missing = bench.control<QLabel>("missingFields");
    const auto required = [&] { return missing->text().section(' ', 1, 1).toInt(); };
    int before = required();
    QVERIFY(before > 3);
    for (QLineEdit *edit : bench.page.findChildren<QLineEdit *>()) {
        if (!edit->objectName().startsWith("field_"))
            continue;
        bench.type(edit->objectName(), "2026-01-31");
        QVERIFY2(required() == before || required() == before - 1, qPrintable(missing->text()));
        before = required();
    }
    QVERIFY2(missing->text().startsWith("●"), qPrintable(missing->text()));
    clear(bench, "field_customer");
    QVERIFY2(missing->text().startsWith("■ 1 "), qPrintable(missing->text()));
}

void TestCertificatePage::status_isNotDone_whileAFieldIsEmpty()
{
    Bench bench;
    bench.page.show();
    const auto *status = bench.control<QLabel>("pageStatus");
    const auto required
        = [&] { return bench.control<QLabel>("missingFields")->text().section(' ', 1, 1).toInt(); };
    QVERIFY(required() > 3);
    const auto says = [&](const QString &words) { return status->text().startsWith(words); };
    QVERIFY2(says(QString("□ not complete: %1 field").arg(required())), qPrintable(status->text()));
    for (QLineEdit *edit : bench.page.findChildren<QLineEdit *>())
        if (edit->objectName().startsWith("field_"))
            bench.type(edit->objectName(), "2026-01-31");
    QVERIFY2(says("▲ 1 caution"), qPrintable(status->text())); // SHK-003
    Recipe recipe = bench.recipe();
    recipe.acknowledge.push_back({"SHK-003", 0, "measured twice"});
    bench.session.apply(recipe, "Give a reason");
    QCOMPARE(status->text(), QString("● done"));
    clear(bench, "field_customer");
    QVERIFY2(says("□ not complete: 1 field"), qPrintable(status->text()));
}

void TestCertificatePage::dateThatIsNone_isSaidBesideItsField()
{
    Bench bench;
    bench.page.show();
    const auto *note = bench.control<QLabel>("note_date_issued");
    for (QLineEdit *edit : bench.page.findChildren<QLineEdit *>())
        if (edit->objectName().startsWith("field_"))
            bench.type(edit->objectName(), "2026-01-31");
    QVERIFY(!note->isVisible());
    for (const char *none : {"banana", "2026-02-30"}) {
        bench.type("field_date_issued", none);
        QVERIFY2(note->isVisible(), none);
        QVERIFY(bench.control<QLabel>("pageStatus")->text().startsWith("□ not complete: 1 date"));
        QVERIFY(bench.control<QLabel>("missingFields")->text().contains("Date of issue"));
    }
    bench.type("field_date_issued", "2026-02-28");
    QVERIFY(!note->isVisible());
}

void TestCertificatePage::language_isOfTheDocument_notOfTheWindow()
{
    Bench bench;
    QCOMPARE(bench.control<QComboBox>("certificateLanguage")->currentIndex(), 0);
    bench.choose("certificateLanguage", 1);
    QCOMPARE(bench.recipe().certificate.languages, std::vector<std::string>{"sv"});
    QVERIFY(bench.control<QLabel>("missingFields")->text().contains("Place of calibration"));
    bench.session.undoStack().undo();
    QCOMPARE(bench.control<QComboBox>("certificateLanguage")->currentIndex(), 0);
}

void TestCertificatePage::languages_twoSideBySide()
{
    Bench bench;
    auto *choice = bench.control<QComboBox>("certificateLanguage");
    QCOMPARE(choice->count(), 9); // three alone, and each beside each other one
    const auto chosen = [&](const char *words) {
        bench.choose("certificateLanguage", choice->findText(words));
        return bench.recipe().certificate.languages;
    };
    using Languages = std::vector<std::string>;
    QCOMPARE(chosen("Svenska / English"), (Languages{"sv", "en"}));
    QCOMPARE(chosen("English / Svenska"), (Languages{"en", "sv"}));
    QCOMPARE(chosen("English / Deutsch"), (Languages{"en", "de"}));
    QCOMPARE(chosen("Svenska / Deutsch"), (Languages{"sv", "de"}));
    QCOMPARE(chosen("Deutsch"), Languages{"de"});
    QCOMPARE(choice->currentText(), QString("Deutsch"));
}

void TestCertificatePage::date_isChosenInACalendar_andUndone()
{
    Bench bench;
    bench.control<QToolButton>("calendar_date_issued")->click();
    auto *calendar = bench.page.findChild<QCalendarWidget *>();
    QVERIFY(calendar);
    emit calendar->clicked(QDate(2026, 1, 31));
    QCOMPARE(fieldOf(bench, "date_issued"), std::string("2026-01-31"));
    QCOMPARE(bench.session.undoStack().count(), 1);
    bench.session.undoStack().undo();
    QCOMPARE(fieldOf(bench, "date_issued"), std::string("(none)"));
    QCOMPARE(bench.control<QLineEdit>("field_date_issued")->text(), QString());
}

void TestCertificatePage::template_builtIn_isChosenAndUndone()
{
    Bench bench;
    const auto *choice = bench.control<QComboBox>("certificateTemplate");
    std::vector<std::string> names; // every one that there is, in its order
    for (int i = 0; i < choice->count(); ++i)
        names.push_back(choice->itemData(i).toString().toStdString());
    std::vector<std::string> known;
    for (const BuiltInTemplate &one : builtInTemplates())
        known.push_back(one.name);
    QCOMPARE(names, known);
    QCOMPARE(choice->currentData().toString(), QString("accredited"));
    bench.choose("certificateTemplate", 2);
    QCOMPARE(bench.recipe().certificate.templateName, std::string("short"));
    const auto *note = bench.control<QLabel>("templateNote");
    QCOMPARE(note->text(), QString("Without shots, model and figures."));
    QVERIFY(!bench.session.isComputing()); // no number depends on it
    bench.session.undoStack().undo();
    QCOMPARE(choice->currentData().toString(), QString("accredited"));
}

void TestCertificatePage::template_file_isTakenOrRefused()
{
    Bench bench;
    const QTemporaryDir folder;
    const QString path = folder.filePath("lab & co.json");
    const auto put = [&](const std::string &json) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(json.data(), static_cast<qint64>(json.size()));
    };
    QSignalSpy asked(&bench.page, &CertificatePage::templateFileRequested);
    bench.press("templateBrowse");
    QCOMPARE(asked.count(), 1);
    put("{}");
    bench.page.takeTemplate(path);
    QCOMPARE(bench.recipe().certificate.templateName, std::string("accredited"));
    CertificateTemplate layout;
    layout.languages = std::vector<std::string>{"sv"};
    put(templateJson(layout));
    bench.page.takeTemplate(path);
    QCOMPARE(bench.recipe().certificate.templateName, path.toStdString());
    const auto *choice = bench.control<QComboBox>("certificateTemplate");
    QCOMPARE(choice->currentText(), QString("lab && co.json"));
    QCOMPARE(choice->count(), 5);
    QVERIFY(!bench.isEnabled("certificateLanguage")); // the template says it
    QCOMPARE(bench.control<QComboBox>("certificateLanguage")->currentIndex(), 1);
    bench.choose("certificateTemplate", 0);
    QCOMPARE(choice->count(), 4);
    QVERIFY(bench.isEnabled("certificateLanguage"));
}

void TestCertificatePage::template_unknown_isShownAndSaid()
{
    Bench bench;
    Recipe recipe = bench.recipe();
    recipe.certificate.templateName = "fancy";
    bench.session.apply(recipe, "Open an old job");
    QCOMPARE(bench.control<QComboBox>("certificateTemplate")->currentText(), QString("fancy"));
    const QString note = bench.control<QLabel>("templateNote")->text();
    QVERIFY2(note.startsWith("■") && note.contains("accredited, full, short"), qPrintable(note));
}

void TestCertificatePage::swedish_labelsAndCounts()
{
    const test::InSwedish swedish;
    Bench bench;
    auto *missing = bench.control<QLabel>("missingFields");
    QVERIFY2(missing->text().contains("obligatoriska fält"), qPrintable(missing->text()));
    // A document's words in the window's language, not in English.
    QVERIFY(!missing->text().contains("Place of calibration"));
    QCOMPARE(bench.control<QComboBox>("certificateLanguage")->currentIndex(), 0);
    QVERIFY(!bench.control<QLineEdit>("field_place")->accessibleName().contains("Place"));
    bench.type("field_place", "Lund");
    QCOMPARE(fieldOf(bench, "place"), std::string("Lund")); // keys are not translated
}

void TestCertificatePage::findings_areCounted()
{
    Bench bench; // one caution: SHK-003
    auto *count = bench.control<QLabel>("cautionCount");
    int cautions = 0;
    for (const Finding &finding : bench.session.findings())
        cautions += finding.severity == Severity::Caution;
    QVERIFY(cautions >= 1);
    QVERIFY2(
        count->text().contains(QString("%1 caution").arg(cautions)), qPrintable(count->text()));
    QVERIFY2(count->text().startsWith("▲"), qPrintable(count->text()));
}

DYNCAL_TEST(TestCertificatePage)
#include "tst_certificate_page.moc"
