// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "tests/ui/support/page_bench.h"
#include "ui/report/report_logo.h"
#include "ui/stages/certificate/certificate_page.h"
#include "ui/stages/certificate/page_stack.h"
#include "ui/stages/certificate/preview_panel.h"

#include <QScrollArea>
#include <QScrollBar>
#include <QtTest>

using namespace dyncal;

namespace {

using Bench = test::PageBench<test::DatedPage<CertificatePage>>;

PreviewPanel &previewOf(Bench &bench)
{
    return *bench.control<PreviewPanel>("certificatePreview");
}

QString noteOf(Bench &bench)
{
    return bench.control<QLabel>("previewNote")->text();
}

void waitShown(Bench &bench)
{
    QTRY_VERIFY_WITH_TIMEOUT(previewOf(bench).isCurrent(), 30000);
}

/// What an export would write, drawn here, apart from the page.
std::string exported(const Bench &bench)
{
    const auto chosen = drawableTemplate(bench.recipe().certificate.templateName);
    ReportDrawing drawing(bench.session.results(), bench.recipe(), "2026-05-04T12:00:00Z",
        ReportParts::Certificate, *chosen);
    while (!drawing.isDone())
        drawing.draw(std::chrono::seconds(1));
    return drawing.take()->front().bytes;
}

void turnWheel(QScrollArea &area, int angle, Qt::KeyboardModifiers keys)
{
    const QPointF at(20, 20);
    QWheelEvent event(at, area.viewport()->mapToGlobal(at), {}, {0, angle}, Qt::NoButton, keys,
        Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(area.viewport(), &event);
}

} // namespace

/// The certificate beside its form: the very document, a moment after each change.
class TestPreviewPanel : public QObject
{
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void document_isTheOneThatAnExportWrites();
    void change_isPaleAtOnce_andShownAMomentLater();
    void undone_isTheDocumentBefore();
    void languages_andTemplate_areFollowed();
    void template_thatIsNone_isSaid();
    void blocked_saysWhatAnExportWouldSay();
    void hidden_drawsNothing_andCatchesUp();
    void pages_areAsWideAsThereIsRoom_orAsChosen();
    void wheelWithControl_changesTheSize();
    void note_followsThePageInView();
    void swedish_note();
};

void TestPreviewPanel::document_isTheOneThatAnExportWrites()
{
    Bench bench;
    waitShown(bench);
    QVERIFY(previewOf(bench).pdf() == exported(bench));
    QVERIFY(bench.control<PageStack>("previewPages")->pageCount() >= 3);
}

void TestPreviewPanel::change_isPaleAtOnce_andShownAMomentLater()
{
    Bench bench;
    waitShown(bench);
    const std::string before = previewOf(bench).pdf();
    bench.type("field_customer", "Testbolaget AB");
    QVERIFY(bench.control<PageStack>("previewPages")->isPale());
    QVERIFY(!previewOf(bench).isCurrent());
    waitShown(bench);
    QVERIFY(previewOf(bench).pdf() != before);
    QVERIFY(previewOf(bench).pdf() == exported(bench));
}

void TestPreviewPanel::undone_isTheDocumentBefore()
{
    Bench bench;
    waitShown(bench);
    const std::string before = previewOf(bench).pdf();
    bench.type("field_customer", "Testbolaget AB");
    waitShown(bench);
    bench.session.undoStack().undo();
    waitShown(bench);
    QVERIFY(previewOf(bench).pdf() == before);
}

void TestPreviewPanel::languages_andTemplate_areFollowed()
{
    Bench bench;
    waitShown(bench);
    const std::size_t pages = bench.control<PageStack>("previewPages")->pageCount();
    bench.choose("certificateLanguage", 1);
    waitShown(bench);
    QVERIFY(previewOf(bench).pdf() == exported(bench));
    bench.choose("certificateTemplate", 2); // short
    waitShown(bench);
    QVERIFY(previewOf(bench).pdf() == exported(bench));
    QVERIFY(bench.control<PageStack>("previewPages")->pageCount() < pages);
}

void TestPreviewPanel::template_thatIsNone_isSaid()
{
    Bench bench;
    waitShown(bench);
    Recipe recipe = bench.recipe();
    recipe.certificate.templateName = "/nowhere/of-the-laboratory.json";
    bench.session.apply(recipe, "a template that is gone");
    QTRY_VERIFY(noteOf(bench).contains("of-the-laboratory.json"));
    QVERIFY(!previewOf(bench).isCurrent());
    QVERIFY(bench.control<PageStack>("previewPages")->isPale()); // the pages before stay
}

void TestPreviewPanel::blocked_saysWhatAnExportWouldSay()
{
    Session session([](const std::shared_ptr<const CaptureSet> &, const Recipe &, ResultCache &,
                        StageId, const JobControl &) {
        PipelineOutcome outcome;
        outcome.error = Error{ErrorKind::DataBlocked, {"The record is clipped.", {}}, {}, 0};
        return outcome;
    });
    PreviewPanel panel(session, [] { return Result<std::string>("2026-05-04T12:00:00Z"); });
    panel.show();
    session.reset({std::make_shared<const CaptureSet>(test::sampleCaptures()), {}});
    test::waitComputed(session);
    panel.follow();
    const auto *note = panel.findChild<QLabel *>("previewNote");
    QTRY_VERIFY2(note->text().contains("clipped"), qPrintable(note->text()));
    QVERIFY(panel.pdf().empty());
}

void TestPreviewPanel::hidden_drawsNothing_andCatchesUp()
{
    Bench bench;
    waitShown(bench);
    const std::string before = previewOf(bench).pdf();
    bench.page.hide();
    Recipe recipe = bench.recipe();
    recipe.certificate.fields["customer"] = "Testbolaget AB";
    bench.session.apply(recipe, "while hidden");
    QTest::qWait(800); // more than a change waits
    QVERIFY(previewOf(bench).pdf() == before);
    bench.page.show();
    waitShown(bench);
    QVERIFY(previewOf(bench).pdf() == exported(bench));
}

void TestPreviewPanel::pages_areAsWideAsThereIsRoom_orAsChosen()
{
    Bench bench;
    waitShown(bench);
    auto *stack = bench.control<PageStack>("previewPages");
    const auto *area = bench.control<QScrollArea>("previewScroll");
    QVERIFY(std::abs(stack->pages().front().width() - area->viewport()->width()) <= 1);
    bench.page.resize(1300, 800);
    QTRY_VERIFY(std::abs(stack->pages().front().width() - area->viewport()->width()) <= 1);
    bench.choose("previewZoom", 3); // 150 %
    const double wanted = 1.5 * 210.0 / 25.4 * stack->logicalDpiX();
    QTRY_VERIFY(std::abs(stack->pages().front().width() - wanted) <= 2.0);
    QVERIFY(std::abs(stack->width() - wanted) <= 1.0);
}

void TestPreviewPanel::wheelWithControl_changesTheSize()
{
    Bench bench;
    waitShown(bench);
    auto *area = bench.control<QScrollArea>("previewScroll");
    auto *zoom = bench.control<QComboBox>("previewZoom");
    turnWheel(*area, 120, Qt::ControlModifier);
    QCOMPARE(zoom->currentIndex(), 1);
    turnWheel(*area, -120, Qt::ControlModifier);
    turnWheel(*area, -120, Qt::ControlModifier);
    QCOMPARE(zoom->currentIndex(), 0);
    waitShown(bench);
    turnWheel(*area, -120, Qt::NoModifier); // scrolls
    QCOMPARE(zoom->currentIndex(), 0);
    QVERIFY(area->verticalScrollBar()->value() > 0);
}

void TestPreviewPanel::note_followsThePageInView()
{
    Bench bench;
    waitShown(bench);
    const auto count = bench.control<PageStack>("previewPages")->pageCount();
    QVERIFY2(
        noteOf(bench).startsWith(QString("Page 1 of %1").arg(count)), qPrintable(noteOf(bench)));
    auto *bar = bench.control<QScrollArea>("previewScroll")->verticalScrollBar();
    bar->setValue(bar->maximum());
    QVERIFY2(
        noteOf(bench).startsWith(QString("Page %1 of %1").arg(count)), qPrintable(noteOf(bench)));
}

void TestPreviewPanel::swedish_note()
{
    const test::InSwedish swedish;
    Bench bench;
    waitShown(bench);
    QVERIFY2(noteOf(bench).startsWith("Sida 1 av "), qPrintable(noteOf(bench)));
}

DYNCAL_TEST(TestPreviewPanel)
#include "tst_preview_panel.moc"
