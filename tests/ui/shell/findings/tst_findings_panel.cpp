// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/sample_results.h"
#include "ui/shell/findings/finding_places.h"
#include "ui/shell/findings/findings_panel.h"
#include "ui/stages/frame/stage_page.h"

#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QTableWidget>
#include <QtTest>

using namespace dyncal;

namespace {

Finding finding(const char *id, Severity severity, Index shot = 0)
{
    return {.id = id,
        .severity = severity,
        .shot = shot,
        .message = {"Shot %1: something is so.", {std::to_string(shot)}}};
}

struct Bench : test::WindowBench
{
    FindingsPanel *panel;

    Bench()
        : WindowBench(test::samplePipeline)
    {
        window->show();
        window->session().reset({std::make_shared<const CaptureSet>(test::sampleCaptures()), {}});
        QTRY_VERIFY(!window->session().isComputing());
        panel = find<FindingsPanel>("findingsPanel");
    }

    void show(const Findings &findings) const
    {
        panel->setFindings(
            findings, window->session().recipe().acknowledge, *window->session().state().captures);
    }
    void click(const QString &name) const
    {
        auto *button = find<QPushButton>(name);
        panel->scrollToBottom();
        QTest::mouseClick(button, Qt::LeftButton);
        QCoreApplication::processEvents();
    }
    QStringList rows() const
    {
        QStringList texts;
        for (int row = 0; row < panel->count(); ++row)
            if (!panel->itemWidget(panel->item(row)))
                texts << panel->item(row)->text();
        return texts;
    }
    QWidget *control(const FindingPlace &place) const
    {
        const QString name = QString::fromLatin1(place.control);
        StagePage *page = window->pages()[static_cast<std::size_t>(place.page)];
        for (QWidget *root :
            {static_cast<QWidget *>(page), static_cast<QWidget *>(page->inspector())})
            for (QWidget *widget : root->findChildren<QWidget *>())
                if (name.endsWith('*') ? widget->objectName().startsWith(name.chopped(1))
                                       : widget->objectName() == name)
                    return widget;
        return nullptr;
    }
};

/// Ids of the catalogue that block or are a caution, each with whether it can block.
std::vector<std::pair<std::string, Severity>> catalogue()
{
    std::vector<std::pair<std::string, Severity>> ids;
    QFile file(qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/docs/findings.md");
    if (!file.open(QIODevice::ReadOnly))
        qFatal("no docs/findings.md");
    const QRegularExpression row("^\\| ([A-Z]{3}-\\d{3}) \\| ([a-z, ]*) \\|");
    while (!file.atEnd()) {
        const auto match = row.match(QString::fromUtf8(file.readLine()));
        const QStringList words = match.captured(2).split(", ");
        if (words.contains("block"))
            ids.emplace_back(match.captured(1).toStdString(), Severity::Block);
        else if (words.contains("caution"))
            ids.emplace_back(match.captured(1).toStdString(), Severity::Caution);
    }
    return ids;
}

} // namespace

/// What is found, as the panel lists it, and what a click on it does.
class TestFindingsPanel : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<Bench> m_bench; ///< of the catalogue, whose rows are many

private slots:
    void initTestCase() { m_bench = std::make_unique<Bench>(); }
    void cleanupTestCase() { m_bench.reset(); }
    void catalogue_everyId_isLedToItsPlace_data();
    void catalogue_everyId_isLedToItsPlace();
    void catalogue_isReadWhole();
    void group_isOneRow_andOpens();
    void gravest_comeFirst_notesAreFolded();
    void number_isDrawnWithItsUnit_andCopiedPlain();
    void notes_stayOpen_overRunsAndRestarts();
    void reason_forAGroup_isAskedOnce();
    void shot_isSelectedInTheTable();
    void buttons_areNeverCut();
    void pageNeverShown_isScrolledToTheField();
};

void TestFindingsPanel::catalogue_isReadWhole()
{
    const auto ids = catalogue();
    QVERIFY2(ids.size() > 60, qPrintable(QString::number(ids.size())));
    QVERIFY(std::ranges::find(ids, std::string("CAP-009"), &std::pair<std::string, Severity>::first)
        != ids.end());
}

void TestFindingsPanel::catalogue_everyId_isLedToItsPlace_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<int>("severity");
    for (const auto &[id, severity] : catalogue())
        QTest::newRow(id.c_str()) << QString::fromStdString(id) << static_cast<int>(severity);
}

/// One click on "Show" of the real panel: the page is on show, and its control has the focus.
void TestFindingsPanel::catalogue_everyId_isLedToItsPlace()
{
    QFETCH(QString, id);
    QFETCH(int, severity);
    const Bench &bench = *m_bench;
    const auto place = placeOfFinding(id.toStdString());
    QVERIFY(place && *place->control != '\0');
    bench.window->showPage(place->page == Page::Order ? 0 : 6); // another one
    bench.show({finding(id.toLatin1(), static_cast<Severity>(severity), 1)});
    bench.click("show_" + id + "_1");
    const StagePage *page = bench.window->pages()[static_cast<std::size_t>(place->page)];
    QVERIFY2(page->isVisible(), place->control);
    const QWidget *control = bench.control(*place);
    QVERIFY2(control, place->control);
    QVERIFY2(control->isVisible(), place->control);
    const QWidget *focused = bench.window->focusWidget();
    QVERIFY2(focused && (focused == control || control->isAncestorOf(focused)),
        qPrintable(QString("%1 has the focus instead of %2")
                       .arg(focused ? focused->objectName() : "nothing", place->control)));
}

/// A page is laid out anew when it is first shown: what was in view before is below its edge then.
void TestFindingsPanel::pageNeverShown_isScrolledToTheField()
{
    for (const char *id : {"MOD-019", "SHK-019", "MIN-006"}) {
        const Bench bench;
        bench.window->resize(1280, 720);
        bench.show({finding(id, Severity::Caution, 1)});
        bench.click(QString("show_%1_1").arg(id));
        QTest::qWait(50);
        const QWidget *focused = bench.window->focusWidget();
        QVERIFY(focused);
        const QRect seen = focused->visibleRegion().boundingRect();
        QVERIFY2(seen.height() == focused->height(),
            qPrintable(QString("%1: %2 of %3 pixels")
                           .arg(focused->objectName())
                           .arg(seen.height())
                           .arg(focused->height())));
    }
}

void TestFindingsPanel::group_isOneRow_andOpens()
{
    const Bench bench;
    bench.show(
        {finding("WIN-001", Severity::Caution, 2), finding("WIN-001", Severity::Caution, 3)});
    QCOMPARE(bench.rows().size(), 1);
    QVERIFY2(bench.rows()[0].startsWith("▲ Caution WIN-001, shots 2 and 3: "),
        qPrintable(bench.rows()[0]));
    bench.click("each_WIN-001_1");
    if (const QString folder = qEnvironmentVariable("DYNCAL_SHOTS"); !folder.isEmpty()) {
        QTest::qWait(200);
        bench.window->grab().save(folder + "/findings.png");
    }
    QCOMPARE(bench.rows().size(), 3);
    QVERIFY(bench.rows()[2].trimmed().startsWith("▲ Caution WIN-001: Shot 3: "));
    bench.click("each_WIN-001_1");
    QCOMPARE(bench.rows().size(), 1);
}

void TestFindingsPanel::number_isDrawnWithItsUnit_andCopiedPlain()
{
    const Bench bench;
    Finding odd = finding("WIN-001", Severity::Caution, 2);
    odd.message.text = "Shot %1: 12.5 kHz is odd.";
    bench.show({odd});
    const auto *delegate = qobject_cast<QStyledItemDelegate *>(bench.panel->itemDelegate());
    QVERIFY(delegate && bench.rows()[0].contains("12.5 kHz"));
    QVERIFY(delegate->displayText(bench.rows()[0], QLocale())
                .contains(QString("12.5%1kHz").arg(QChar(QChar::Nbsp))));
    QTest::keyClick(bench.panel, Qt::Key_C, Qt::ControlModifier);
    QVERIFY(QGuiApplication::clipboard()->text().contains("12.5 kHz"));
}

void TestFindingsPanel::gravest_comeFirst_notesAreFolded()
{
    const Bench bench;
    Findings findings(12, finding("CAP-005", Severity::Info));
    findings.push_back(finding("WIN-004", Severity::Caution, 1));
    findings.push_back(finding("CAP-008", Severity::Block, 1));
    bench.show(findings);
    const QStringList rows = bench.rows();
    QCOMPARE(rows.size(), 3);
    QVERIFY(rows[0].contains("CAP-008") && rows[1].contains("WIN-004"));
    QCOMPARE(rows[2], QString("▸ 12 notes"));
    QListWidgetItem *notes = bench.panel->item(bench.panel->count() - 1);
    bench.panel->scrollToItem(notes);
    QTest::mouseClick(
        bench.panel->viewport(), Qt::LeftButton, {}, bench.panel->visualItemRect(notes).center());
    QTRY_COMPARE(bench.rows().size(), 4); // twelve that say the same are one row
    QVERIFY(bench.rows()[3].contains("CAP-005"));
    QCOMPARE(bench.rows()[2], QString("▾ 12 notes"));
}

void TestFindingsPanel::notes_stayOpen_overRunsAndRestarts()
{
    Bench bench;
    const Findings notes{finding("CAP-005", Severity::Info)};
    bench.show(notes);
    emit bench.panel->itemActivated(bench.panel->item(0)); // Enter
    QTRY_COMPARE(bench.rows().size(), 2);
    bench.show({});
    bench.show(notes);
    QCOMPARE(bench.rows().size(), 2);
    QVERIFY(bench.preferences.notesOpen());
    bench.language.install("sv"); // the panel is made anew
    QCoreApplication::processEvents();
    bench.panel = bench.find<FindingsPanel>("findingsPanel");
    bench.show(notes);
    QCOMPARE(bench.rows().size(), 2);
    bench.language.install("en");
    QCoreApplication::processEvents();
}

void TestFindingsPanel::reason_forAGroup_isAskedOnce()
{
    Bench bench;
    bench.show(
        {finding("WIN-001", Severity::Caution, 2), finding("WIN-001", Severity::Caution, 3)});
    bench.prompts.setNextSentence("the plateau is longer than computed");
    bench.click("reason_WIN-001_1");
    const auto &given = bench.window->session().recipe().acknowledge;
    QCOMPARE(given.size(), std::size_t(2));
    QCOMPARE(given[1].shot, Index(3));
    QCOMPARE(given[0].reason, given[1].reason);
    QCOMPARE(bench.window->session().undoStack().count(), 1);
}

void TestFindingsPanel::shot_isSelectedInTheTable()
{
    const Bench bench;
    bench.show({finding("CAP-007", Severity::Block, 3)});
    bench.click("show_CAP-007_1");
    QCOMPARE(bench.find<QTableWidget>("shotTable")->currentRow(), 2);
}

void TestFindingsPanel::buttons_areNeverCut()
{
    const Bench bench;
    bench.show({finding("CAP-006", Severity::Caution, 1), finding("CAP-006", Severity::Caution, 2),
        finding("CAP-006", Severity::Caution, 3)});
    QCoreApplication::processEvents();
    for (const QPushButton *button : bench.panel->findChildren<QPushButton *>()) {
        QVERIFY(button->width() >= button->sizeHint().width());
        QVERIFY2(button->geometry().bottom() < button->parentWidget()->height(),
            qPrintable(button->text()));
    }
}

DYNCAL_TEST(TestFindingsPanel)
#include "tst_findings_panel.moc"
