// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/hostile_text.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/sample_results.h"
#include "ui/plot/values/plot_content.h"
#include "ui/plot/widget/plot_export.h"
#include "ui/plot/widget/plot_widget.h"
#include "ui/shell/findings/findings_panel.h"
#include "ui/shell/findings/problem_panel.h"
#include "ui/stages/frame/value_table.h"
#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QBuffer>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QTabBar>
#include <QTableWidget>
#include <QToolTip>
#include <QXmlStreamReader>
#include <QtTest>

#include <sys/inotify.h>
#include <unistd.h>

using namespace dyncal;
using namespace dyncal::test;

namespace {

/// A file that the hostile texts name, and whether anybody opened it.
class Bait
{
public:
    explicit Bait(const QString &path)
        : m_watch(::inotify_init1(IN_NONBLOCK))
    {
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write("bait") != 4)
            qFatal("no bait");
        file.close();
        if (::inotify_add_watch(m_watch, QFile::encodeName(path).constData(), IN_OPEN) < 0)
            qFatal("no watch");
    }
    ~Bait() { ::close(m_watch); }
    Bait(const Bait &) = delete;
    Bait &operator=(const Bait &) = delete;

    bool wasOpened() const
    {
        char event[4096];
        return ::read(m_watch, event, sizeof event) > 0;
    }

private:
    int m_watch;
};

/// The formula results with this text wherever the method passes one on.
PipelineOutcome hostilePipeline(const std::string &text,
    const std::shared_ptr<const CaptureSet> &captures, const Recipe &recipe, ResultCache &cache,
    StageId until, const JobControl &control)
{
    PipelineOutcome outcome = samplePipeline(captures, recipe, cache, until, control);
    CalibrationResults &results = outcome.results;
    auto shock = std::make_shared<ShockConditionsSet>(*results.shock);
    for (const char *id : {"CAP-004", "CAP-013", "SHK-007"})
        shock->findings.push_back({.id = id,
            .severity = Severity::Caution,
            .shot = 1,
            .channel = text,
            .message
            = {"The channel %1 of %2 has the unit %3, not %4.", {text, text, text, text}}});
    for (ShockConditions &shot : shock->shots) {
        MeasuredPressure pressure;
        pressure.channel = pressure.region = text;
        shot.measured.push_back(pressure);
        Sighting sighting;
        sighting.channel = text;
        shot.sightings.push_back(sighting);
    }
    results.shock = shock;
    results.expected = std::make_shared<ExpectedShock>(ExpectedShock{*shock, {}});
    auto window = std::make_shared<WindowResult>(*results.window);
    for (WindowedResponse &response : window->responses)
        response.unit = text;
    results.window = window;
    auto response = std::make_shared<ResponseResult>(*results.response);
    response->unit = response->sensitivityUnit = text;
    for (ShotSensitivity &shot : response->shots)
        shot.unit = text;
    results.response = response;
    return outcome;
}

/// Three shots with this text in every field.
CaptureSet hostileCaptures(const std::string &text)
{
    CaptureSet set = sampleCaptures();
    set.inputs.front() = {"/data/" + text, text, text, text};
    for (Shot &shot : set.shots) {
        shot.label = shot.excludeReason = text;
        shot.notes[text] = text;
        for (Channel &channel : shot.channels) {
            channel.name = text + (channel.role == ChannelRole::Dut ? "" : " 2");
            channel.unit = channel.quantity = channel.sensorId = text;
        }
    }
    set.tube[text] = text;
    set.sensors[text][text] = text;
    set.instruments[text][text] = text;
    set.findings.push_back({.id = "CAP-002",
        .severity = Severity::Caution,
        .channel = text,
        .message = {"%1", {text}}});
    return set;
}

Recipe hostileRecipe(const std::string &text)
{
    Recipe recipe;
    recipe.import.exclude = {{3, text}};
    recipe.import.unit = text;
    recipe.import.sampleRateReason = text;
    recipe.window.excludeStretches = {{1, 1e-5, 2e-5, text}};
    recipe.realization.nuisanceModes = {{{6.8e3}, 1, false, text, text}};
    recipe.realization.candidates = {2};
    recipe.realization.candidateNotes = {{2, text}};
    recipe.realization.adoptedReason = text;
    recipe.acknowledge = {{"CAP-002", 0, text}};
    recipe.shock.arrivalSensors = {{text, 0.3, 1e-3, {}, 0.0, {}, 0.0, {}}};
    for (const char *field : {"laboratory", "customer", "remarks", "number", "operator"})
        recipe.certificate.fields[field] = text;
    return recipe;
}

bool isFit(const QString &text)
{
    return isFitToShow(text.toStdString(), LineBreaks::Keep) && text.isValidUtf16();
}

/// Every text that a person can see or hear of this widget.
QStringList textsOf(const QWidget *widget)
{
    QStringList texts{widget->toolTip(), widget->windowTitle(), widget->accessibleName(),
        widget->accessibleDescription(), widget->statusTip(), widget->whatsThis()};
    for (const QAction *action : widget->actions())
        texts << action->text() << action->toolTip();
    if (const auto *label = qobject_cast<const QLabel *>(widget))
        texts << label->text();
    if (const auto *button = qobject_cast<const QAbstractButton *>(widget))
        texts << button->text();
    if (const auto *box = qobject_cast<const QGroupBox *>(widget))
        texts << box->title();
    if (const auto *edit = qobject_cast<const QLineEdit *>(widget))
        texts << edit->placeholderText();
    if (const auto *choice = qobject_cast<const QComboBox *>(widget))
        for (int i = 0; i < choice->count(); ++i)
            texts << choice->itemText(i);
    if (const auto *tabs = qobject_cast<const QTabBar *>(widget))
        for (int i = 0; i < tabs->count(); ++i)
            texts << tabs->tabText(i);
    return texts;
}

void addModel(QStringList &texts, const QAbstractItemModel *model, const QModelIndex &parent = {})
{
    for (int row = 0; row < model->rowCount(parent); ++row)
        for (int column = 0; column < model->columnCount(parent); ++column) {
            const QModelIndex index = model->index(row, column, parent);
            for (const int role : {int(Qt::DisplayRole), int(Qt::ToolTipRole)})
                texts << index.data(role).toString();
            if (column == 0)
                addModel(texts, model, index);
        }
    for (const auto direction : {Qt::Horizontal, Qt::Vertical})
        for (int i = 0; i < 20 && !parent.isValid(); ++i)
            texts << model->headerData(i, direction).toString();
}

/// Complains of the first text that is not fit, and of labels that would guess.
void checkWidgets(const QWidget *top)
{
    for (QWidget *widget : top->findChildren<QWidget *>()) {
        widget->ensurePolished();
        QStringList texts = textsOf(widget);
        if (const auto *view = qobject_cast<const QAbstractItemView *>(widget);
            view && view->model())
            addModel(texts, view->model());
        for (const QString &text : texts)
            QVERIFY2(isFit(text), qPrintable(widget->objectName() + ": " + text.left(200)));
        if (const auto *label = qobject_cast<const QLabel *>(widget))
            QVERIFY2(label->textFormat() == Qt::PlainText,
                qPrintable(label->objectName() + ": " + label->text().left(200)));
    }
}

QString shownIn(const QWidget *top)
{
    QStringList texts;
    for (QWidget *widget : top->findChildren<QWidget *>()) {
        texts << textsOf(widget);
        if (const auto *view = qobject_cast<const QAbstractItemView *>(widget);
            view && view->model())
            addModel(texts, view->model());
    }
    return texts.join('\n');
}

/// The text is the shots' label, so that a run knows it from what it is given.
PipelineOutcome pipelineOfCaptures(const std::shared_ptr<const CaptureSet> &captures,
    const Recipe &recipe, ResultCache &cache, StageId until, const JobControl &control)
{
    return hostilePipeline(captures->shots.front().label, captures, recipe, cache, until, control);
}

/// One window for all texts, one after the other: a job's texts must not outlive it either.
struct Bench : WindowBench
{
    Bench()
        : WindowBench(pipelineOfCaptures)
    {
        window->resize(1400, 900);
        window->show();
    }
    explicit Bench(const std::string &text)
        : Bench()
    {
        open(text);
    }

    void open(const std::string &text) const
    {
        window->session().reset(
            {std::make_shared<const CaptureSet>(hostileCaptures(text)), hostileRecipe(text)});
        QTRY_VERIFY(!window->session().isComputing());
    }
};

QLabel *tipLabel()
{
    for (QWidget *widget : QApplication::topLevelWidgets())
        if (widget->inherits("QTipLabel"))
            return qobject_cast<QLabel *>(widget);
    return nullptr;
}

} // namespace

class TestHostileWindow : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    std::unique_ptr<Bench> m_bench; ///< of the tests that open all texts
    QString bait() const { return m_folder.filePath("bait.png"); }
    std::vector<std::string> texts() const { return hostileTexts(bait().toStdString()); }

    void addRows(std::size_t step = 1) const
    {
        QTest::addColumn<QByteArray>("text");
        const auto all = texts();
        for (std::size_t i = 0; i < all.size(); i += step)
            QTest::addRow("%d", int(i)) << QByteArray::fromStdString(all[i]);
    }

private slots:
    void initTestCase() { m_bench = std::make_unique<Bench>(); }
    void cleanupTestCase() { m_bench.reset(); }

    void everyPage_showsTextAsText_data() { addRows(std::size_t(trials::count(3, 1))); }
    void everyPage_showsTextAsText()
    {
        QFETCH(QByteArray, text);
        const Bait watched(bait());
        const Bench &bench = *m_bench;
        bench.open(text.toStdString());
        bench.window->files().openPaths({m_folder.filePath("no <b>file</b>&such")});
        QTRY_VERIFY(!bench.window->files().isBusy());
        for (std::size_t row = 0; row < bench.window->pages().size(); ++row) {
            bench.window->showPage(static_cast<int>(row));
            QCoreApplication::processEvents();
            checkWidgets(bench.window.get());
            if (QTest::currentTestFailed())
                return;
            bench.window->grab();
        }
        bench.window->showPage(0);
        QVERIFY(shownIn(bench.window.get()).contains(shownText(text.toStdString())));
        QVERIFY(!watched.wasOpened());
    }

    void tooltip_ofCellsAndLabels_isPlain()
    {
        const Bait watched(bait());
        Bench bench("x");
        for (const std::string &text : texts()) {
            QToolTip::showText({10, 10}, shownText(text), bench.window.get());
            QVERIFY(tipLabel());
            QCOMPARE(tipLabel()->textFormat(), Qt::PlainText);
            tipLabel()->grab();
            QToolTip::showText({10, 10}, QString::fromStdString(text) + ' ', bench.window.get());
            QCOMPARE(tipLabel()->textFormat(), Qt::PlainText);
            tipLabel()->grab();
        }
        QToolTip::hideText();
        QVERIFY(!watched.wasOpened());
    }

    void messageBox_isPlain()
    {
        const Bait watched(bait());
        Bench bench("x");
        for (const std::string &text : texts()) {
            QMessageBox box(QMessageBox::Warning, "Dyncal", QString::fromStdString(text),
                QMessageBox::Ok, bench.window.get());
            box.show();
            for (QLabel *label : box.findChildren<QLabel *>())
                QCOMPARE(label->textFormat(), Qt::PlainText);
            box.grab();
        }
        QVERIFY(!watched.wasOpened());
    }

    void mnemonics_areNotMadeOfNames()
    {
        const Bench bench("&File && &Edit");
        auto *form = bench.window->findChild<QComboBox *>("roleOf_&File && &Edit");
        QVERIFY(form);
        const auto *layout = qobject_cast<QFormLayout *>(form->parentWidget()->layout());
        const auto *label = qobject_cast<QLabel *>(layout->labelForField(form));
        QCOMPARE(label->text(), QString("&&File &&&& &&Edit"));
        for (const QPushButton *button :
            bench.find<FindingsPanel>("findingsPanel")->findChildren<QPushButton *>())
            QVERIFY2(
                !QString(button->text()).remove("&&").contains('&'), qPrintable(button->text()));
    }

    void placeholders_inArguments_stay()
    {
        QCOMPARE(translated({"Shot %1: %2", {"%2", "b"}}), QString("Shot %2: b"));
    }

    void title_holdsNoMarkOfTheName()
    {
        QMainWindow window;
        window.setWindowModified(true);
        window.setWindowTitle(asTitle("a[*]b") + "[*]");
        QCOMPARE(asTitle("a[*]b"), QString("a[*][*]b"));
    }

    void clipboard_ofTables_isText()
    {
        for (const std::string &text : texts()) {
            ValueTable table("table", "table");
            table.setValues({"a", "b"}, {{QString::fromStdString(text), "-1.5e-3"}});
            table.selectAll();
            QTest::keySequence(&table, QKeySequence::Copy);
            const QString copied = QGuiApplication::clipboard()->text();
            QCOMPARE(copied.count('\t'), 1);
            QCOMPARE(copied.count('\n'), 0);
            QVERIFY(copied.endsWith("\t-1.5e-3"));
            QVERIFY(isFitToShow(copied.section('\t', 0, 0).toStdString()));
            QVERIFY2(!QString("=@").contains(copied.front()), text.c_str());
        }
    }

    void clipboard_ofFindingsAndProblems_isText()
    {
        const Bench &bench = *m_bench;
        for (const std::string &text : texts()) {
            bench.open(text);
            auto *findings = bench.find<FindingsPanel>("findingsPanel");
            findings->clearSelection();
            QTest::keySequence(findings, QKeySequence::Copy);
            const QStringList lines = QGuiApplication::clipboard()->text().split('\n');
            QCOMPARE(lines.size(), 4); // three hostile ones, and one of the sample
            for (const QString &line : lines)
                QVERIFY2(isFitToShow(line.toStdString()), qPrintable(line));
            ProblemPanel problems;
            problems.update(
                {}, {{"/a/" + text, {ErrorKind::FileUnreadable, {"%1", {text}}, "CAP-001"}}});
            problems.findChild<QPushButton *>("copyProblems")->click();
            const QString copied = QGuiApplication::clipboard()->text();
            QCOMPARE(copied.count('\t'), 2);
            QVERIFY2(
                isFitToShow(copied.simplified().remove('\t').toStdString()), qPrintable(copied));
            QCOMPARE(copied.count('\n'), 0);
        }
    }

    /// The text's own markup is no element of the picture, and its table has no formula.
    void plots_svgAndCsv_holdText()
    {
        for (const std::string &text : texts()) {
            PlotContent content;
            content.title = content.summary = shownText(text);
            content.xAxis = {shownText(text), shownText(text)};
            content.yAxis = {shownText(text), shownText(text)};
            content.curves.push_back({shownText(text), CurveRole::Measured, CurveStyle::Line,
                {0.0, 1.0}, {-1.0, 2.0}, true});
            QBuffer svg;
            svg.open(QIODevice::WriteOnly);
            QVERIFY(writePicture({std::make_shared<const PlotContent>(content), {}, {}, {}},
                {400, 300}, "svg", svg));
            QXmlStreamReader xml(svg.data());
            while (!xml.atEnd()) {
                xml.readNext();
                if (xml.isStartElement())
                    for (const char *foreign : {"script", "img", "b", "a", "table", "h1", "style"})
                        QVERIFY2(xml.name() != QLatin1String(foreign), text.c_str());
            }
            QVERIFY2(!xml.hasError(), text.c_str());
            const QString table = contentTable(content, TableFormat::Csv);
            QVERIFY(isFitToShow(table.toStdString(), LineBreaks::Keep));
            QCOMPARE(table.count('\n'), 3);
            QVERIFY(table.contains("\n0,-1\n1,2\n"));
        }
    }
};

DYNCAL_TEST(TestHostileWindow)
#include "tst_hostile_window.moc"
