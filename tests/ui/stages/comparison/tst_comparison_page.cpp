// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The page of a comparison, operated by its controls over a simulated reference transducer; the
// numbers on it against those of results.json.

#include "core/results/results_json.h"
#include "tests/support/made_dcc.h"
#include "tests/support/reference_capture.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/comparison/comparison_page.h"
#include "ui/stages/frame/prompts.h"
#include "ui/stages/frame/refusal_note.h"
#include "ui/stages/frame/value_table.h"
#include "ui/text/quantity_format.h"
#include "ui/text/typed_quantity.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include <nlohmann/json.hpp>

using namespace dyncal;
using Json = nlohmann::json;

namespace {

using Bench = test::PageBench<test::ScriptedPage<ComparisonPage>>;

/// The truth of the simulated reference as a table, times `factor`.
std::string tableOfTruth(double factor = 1.0)
{
    const auto truth = ReferenceSensitivity::fromModel(testing::referenceTruth()).value();
    std::string text = "frequency_hz,magnitude,u_magnitude\n";
    for (double f_Hz = 100.0; f_Hz < 4e6; f_Hz *= 1.2) {
        const ReferencePoint point = *truth.at(f_Hz);
        text += QString("%1,%2,%3\n")
                    .arg(f_Hz, 0, 'g', 17)
                    .arg(factor * point.magnitude, 0, 'g', 17)
                    .arg(0.003 * point.magnitude, 0, 'g', 17)
                    .toStdString();
    }
    return text;
}

/// A certificate in XML with the lists "low" and "high", for a sensitivity near the truth.
std::string certificateOfTwo()
{
    const QString S = QString::number(testing::referenceTruth().sensitivity, 'g', 12);
    const std::string f = testing::dccQuantity("100 1000 1000000", "\\hertz");
    const std::string low = testing::dccQuantity(
        (S + " " + S + " " + S).toStdString(), "\\volt\\pascal\\tothe{-1}", "1e-12");
    const std::string high = testing::dccQuantity("1 1 1", "\\volt\\pascal\\tothe{-1}", "0.01");
    return testing::dccOf(testing::dccList(f + low, "low") + testing::dccList(f + high, "high"));
}

} // namespace

class TestComparisonPage : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    std::shared_ptr<const CaptureSet> m_set;
    std::unique_ptr<Bench> m_bench;

    QString file(const char *name, const std::string &content) const
    {
        QFile written(m_folder.filePath(name));
        if (!written.open(QIODevice::WriteOnly))
            qFatal("cannot write %s", name);
        written.write(QByteArray::fromStdString(content));
        return written.fileName();
    }
    void press(const char *name) const
    {
        QTest::mouseClick(m_bench->control<QPushButton>(name), Qt::LeftButton);
    }
    void chooseFile(const char *button, const QString &path) const
    {
        test::scripted().setNextFile(path);
        press(button);
        test::waitComputed(m_bench->session);
    }
    void tick(bool on) const
    {
        auto *box = m_bench->control<QCheckBox>("comparisonEnabled");
        if (box->isChecked() != on)
            QTest::mouseClick(box, Qt::LeftButton);
        test::waitComputed(m_bench->session);
    }
    void typeModel(double factor = 1.0) const
    {
        const ReferenceModel truth = testing::referenceTruth();
        const auto typed = [](double value) { return QString::number(value, 'g', 12); };
        m_bench->type("referenceSensitivityValue", typed(factor * truth.sensitivity));
        m_bench->type("referenceSensitivityUValue", typed(truth.u_sensitivity));
        m_bench->type("referenceF0Value", typed(truth.f0_Hz) + " Hz");
        m_bench->type("referenceF0UValue", typed(truth.u_f0_Hz) + " Hz");
        m_bench->type("referenceZetaValue", typed(truth.zeta));
        m_bench->type("referenceZetaUValue", typed(truth.u_zeta));
    }
    QString label(const char *name) const { return m_bench->control<QLabel>(name)->text(); }
    const ComparisonSettings &settings() const { return m_bench->recipe().comparison; }
    void clear(const char *name) const
    {
        auto *edit = m_bench->control<QLineEdit>(name);
        edit->selectAll();
        QTest::keyClick(edit, Qt::Key_Delete);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    int steps() const { return m_bench->session.undoStack().count(); }
    QString refusal(const char *name) const
    {
        return refusalOnShow(m_bench->control<QWidget>(name));
    }
    Json writtenResults() const
    {
        const Session &session = m_bench->session;
        PipelineOutcome outcome;
        outcome.results = session.results();
        return Json::parse(resultsJson(outcome, session.recipe(), "now"));
    }
    bool isModelTrue() const
    {
        const ReferenceModel truth = testing::referenceTruth();
        const auto isSame = [](double a, double b) { return std::abs(a / b - 1.0) < 1e-9; };
        const auto &m = settings().model;
        return m && isSame(m->sensitivity, truth.sensitivity)
            && isSame(m->u_sensitivity, truth.u_sensitivity) && isSame(m->f0_Hz, truth.f0_Hz)
            && isSame(m->u_f0_Hz, truth.u_f0_Hz) && isSame(m->zeta, truth.zeta)
            && isSame(m->u_zeta, truth.u_zeta);
    }
    QString cell(int row, int column) const
    {
        return m_bench->control<ValueTable>("comparisonTable")->item(row, column)->text();
    }

private slots:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        m_set = testing::referenceCapture(1e7);
    }
    void init()
    {
        m_bench = std::make_unique<Bench>(m_set);
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->session.results().comparison, 60000);
    }
    void cleanup() { m_bench.reset(); }

    void switchingOn_needsAReference();
    void model_isUsedOnceComplete();
    void page_saysWhatResultsSay();
    void table_isRead_wrongOneIsRefused();
    void wrongCertificate_isToldWithWhatToDo();
    void certificateOfTwoLists_isAskedWhich();
    void againstTransducer_onlyWithComparison();
    void placeAndUnit_areOneStepEach();
    void numbersOfTheCertificates_areTyped();
    void wrongTyping_changesNothing();
    void chain_isChosen_orRefused();
    void failedRun_isSaidHere();
    void swedish_hasNoEnglishNumbers();
};

void TestComparisonPage::switchingOn_needsAReference()
{
    QVERIFY(label("comparisonVerdict").startsWith("Nothing is compared."));
    QCOMPARE(m_bench->page.status(), StageStatus::Done);
    const Recipe before = m_bench->recipe();
    tick(true);
    QVERIFY2(refusal("comparisonEnabled").startsWith("First say what"),
        qPrintable(refusal("comparisonEnabled")));
    QVERIFY(!m_bench->control<QCheckBox>("comparisonEnabled")->isChecked());
    QVERIFY(m_bench->recipe() == before);
    // Named a channel that no shot has.
    typeModel();
    Recipe other = m_bench->recipe();
    other.comparison.channel = "elsewhere";
    m_bench->session.apply(other, "channel");
    tick(true);
    QVERIFY2(refusal("comparisonEnabled").startsWith("Shot 1 has no channel"),
        qPrintable(refusal("comparisonEnabled")));
    QVERIFY(!settings().enabled);
}

void TestComparisonPage::model_isUsedOnceComplete()
{
    m_bench->type("referenceZetaValue", "0.2");
    m_bench->type("referenceF0Value", "1 MHz");
    QVERIFY(!settings().model);
    QVERIFY(label("referenceModelNote").contains("u of f₀"));
    QCOMPARE(steps(), 0);
    typeModel();
    QCOMPARE(steps(), 1);
    QVERIFY(isModelTrue());
    QVERIFY(label("referenceModelNote").isEmpty());
    clear("referenceZetaValue"); // one of six cannot be missing
    QVERIFY(refusal("referenceZeta").contains("needed"));
    QVERIFY(isModelTrue());
    tick(true);
    QVERIFY(settings().enabled);
    press("referenceModelRemove");
    QVERIFY(!settings().model && !settings().enabled);
    m_bench->session.undoStack().undo();
    QVERIFY(settings().model && settings().enabled);
}

void TestComparisonPage::page_saysWhatResultsSay()
{
    typeModel();
    tick(true);
    QTRY_VERIFY(m_bench->session.results().comparison->againstStep);
    QVERIFY2(label("comparisonVerdict").contains("agree:"), qPrintable(label("comparisonVerdict")));
    const Json section = writtenResults().at("comparison");
    const auto &f = section.at("frequency_hz");
    const auto *table = m_bench->control<ValueTable>("comparisonTable");
    QCOMPARE(table->rowCount(), static_cast<int>(f.size()) + 1);
    QCOMPARE(cell(0, 6), shownFigures(section.at("e_n_mean").get<double>(), 2));
    const Json step = writtenResults().at("response");
    for (std::size_t i = 0; i < f.size(); ++i) {
        const int row = static_cast<int>(i) + 1;
        QCOMPARE(cell(row, 0), shownQuantity(f[i].get<double>(), "Hz", 4));
        if (!section.at("e_n_step")[i].is_null())
            QCOMPARE(cell(row, 6), shownFigures(section.at("e_n_step")[i].get<double>(), 2));
        if (section.at("magnitude")[i].is_null())
            continue;
        const double value = section.at("magnitude")[i].get<double>();
        const double U = statedFactor(section.at("k_magnitude")[i].get<double>())
            * section.at("u_magnitude")[i].get<double>();
        const auto shown = [&](int column) {
            return typedQuantity(cell(row, column), {QStringLiteral("V/Pa"), 1.0})
                .value.value_or(0.0);
        };
        QVERIFY2(std::abs(shown(1) / value - 1.0) < 0.05 * U / value, qPrintable(cell(row, 1)));
        QVERIFY2(std::abs(shown(2) / U - 1.0) < 0.05, qPrintable(cell(row, 2)));
    }
    const auto curves = m_bench->page.plots().front()->content().curves;
    const auto found = std::ranges::find(curves, QString("Reference transducer"), &PlotCurve::name);
    QVERIFY(found != curves.end());
    QCOMPARE(found->y.front(), section.at("magnitude")[0].get<double>());
    QVERIFY(label("comparisonAdvice").isEmpty());
}

void TestComparisonPage::table_isRead_wrongOneIsRefused()
{
    const int before = steps();
    chooseFile("referenceBrowse", file("notes.csv", "dear reader,\nnothing here\n"));
    QVERIFY(!refusal("referenceBrowse").isEmpty());
    QCOMPARE(steps(), before);
    QVERIFY(settings().source.empty());
    chooseFile("referenceBrowse", m_folder.filePath("gone.csv"));
    QVERIFY(refusal("referenceBrowse").contains("could not be read"));
    chooseFile("referenceBrowse", {}); // cancelled
    QCOMPARE(steps(), before);
    chooseFile("referenceBrowse", file("ref.csv", tableOfTruth()));
    QCOMPARE(steps(), before + 1);
    QVERIFY(settings().loaded && settings().sha256 == settings().loaded->sha256);
    QCOMPARE(label("referenceFile"), QString("ref.csv"));
    QVERIFY2(label("referenceStated").startsWith("Table, from 100 Hz to "),
        qPrintable(label("referenceStated")));
    QVERIFY(!m_bench->control<QComboBox>("referenceList")->isEnabled());
    tick(true);
    QTRY_VERIFY(m_bench->session.results().comparison->againstStep);
    QVERIFY(std::abs(m_bench->session.results().comparison->againstStep->meanE_n()) < 1.0);
    // A model takes the file's place, and a file the model's.
    typeModel();
    QVERIFY(settings().model && settings().source.empty() && settings().enabled);
    chooseFile("referenceBrowse", m_folder.filePath("ref.csv"));
    QVERIFY(!settings().model && !settings().source.empty());
    press("referenceRemove");
    QVERIFY(settings().source.empty() && settings().sha256.empty() && !settings().enabled);
    QCOMPARE(label("referenceFile"), QString("none"));
}

void TestComparisonPage::wrongCertificate_isToldWithWhatToDo()
{
    chooseFile("referenceBrowse", file("wrong.csv", tableOfTruth(1.06)));
    tick(true);
    QTRY_VERIFY2(
        label("comparisonVerdict").contains("contradict"), qPrintable(label("comparisonVerdict")));
    QVERIFY(label("comparisonAdvice").contains("its certificate"));
    QCOMPARE(m_bench->page.status(), StageStatus::DoneWithCautions); // CMP-001 counts here
}

void TestComparisonPage::certificateOfTwoLists_isAskedWhich()
{
    chooseFile("referenceBrowse", file("two.xml", certificateOfTwo()));
    auto *list = m_bench->control<QComboBox>("referenceList");
    QCOMPARE(list->count(), 3);
    QCOMPARE(list->currentText(), QString("to be chosen"));
    QVERIFY2(label("referenceStated").contains("2 lists"), qPrintable(label("referenceStated")));
    m_bench->choose("referenceList", list->findText("low"));
    QCOMPARE(settings().quantityId, std::string("low"));
    QVERIFY2(label("referenceStated").startsWith("Certificate K-17, from 100 Hz to 1 MHz"),
        qPrintable(label("referenceStated")));
    tick(true);
    QTRY_VERIFY(m_bench->session.results().comparison->byTransducer);
    QCOMPARE(m_bench->session.results().comparison->certificate, std::string("K-17"));
}

void TestComparisonPage::againstTransducer_onlyWithComparison()
{
    m_bench->choose("responseReference", 1);
    QVERIFY(refusal("responseReference").contains("switched on"));
    QCOMPARE(m_bench->control<QComboBox>("responseReference")->currentIndex(), 0);
    QCOMPARE(steps(), 0);
    typeModel();
    tick(true);
    m_bench->choose("responseReference", 1);
    test::waitComputed(m_bench->session);
    QTRY_VERIFY(m_bench->session.results().response->isByTransducer);
    QTRY_VERIFY(m_bench->session.results().comparison->againstStep);
    QVERIFY(cell(1, 3) != "–"); // the step's is there still
    m_bench->type("referenceZetaUValue", "0.003"); // still against it
    QVERIFY(m_bench->recipe().response.isByTransducer());
    tick(false);
    QVERIFY(!settings().enabled);
    QCOMPARE(m_bench->recipe().response.reference, std::string("computed-step"));
    QVERIFY(!m_bench->session.error());
    for (int choice : {2, 3}) {
        m_bench->choose("responseReference", choice);
        QCOMPARE(m_bench->control<QComboBox>("responseReference")->currentIndex(), choice);
    }
    QCOMPARE(m_bench->recipe().response.reference, std::string("unit-step"));
}

void TestComparisonPage::placeAndUnit_areOneStepEach()
{
    m_bench->type("referenceDelayValue", "1.5");
    m_bench->type("referenceDelayUValue", "20 ns");
    m_bench->type("referenceCorrelationValue", "0.3");
    QVERIFY(std::abs(settings().delay_s - 1.5e-6) < 1e-18);
    QVERIFY(std::abs(*settings().u_delay_s - 2e-8) < 1e-20);
    QCOMPARE(settings().correlationWithStep, 0.3);
    QCOMPARE(steps(), 3);
    clear("referenceDelayUValue");
    QVERIFY(!settings().u_delay_s);
    auto *channel = m_bench->control<QComboBox>("referenceChannel");
    const int at = channel->findText("Reference");
    QVERIFY(at > 0);
    m_bench->choose("referenceChannel", at);
    QCOMPARE(settings().channel, std::string("Reference"));
    QCOMPARE(steps(), 5);
    m_bench->session.undoStack().undo();
    QCOMPARE(channel->currentIndex(), 0);
}

void TestComparisonPage::numbersOfTheCertificates_areTyped()
{
    m_bench->type("referenceCertificate", " R-17 ");
    QCOMPARE(settings().certificate, std::string("R-17"));
    m_bench->type("chainCertificate", "C-3");
    QCOMPARE(m_bench->session.recipe().chain.certificate, std::string("C-3"));
    m_bench->session.undoStack().undo();
    QCOMPARE(m_bench->control<QLineEdit>("chainCertificate")->text(), QString());
    QCOMPARE(m_bench->control<QLineEdit>("referenceCertificate")->text(), QString("R-17"));
}

void TestComparisonPage::wrongTyping_changesNothing()
{
    m_bench->type("referenceUnit", "bar/V");
    QVERIFY2(refusal("referenceUnit").contains("V/Pa"), qPrintable(refusal("referenceUnit")));
    QCOMPARE(m_bench->control<QLineEdit>("referenceUnit")->text(), QString("V/Pa"));
    clear("referenceUnit");
    QVERIFY(!refusal("referenceUnit").isEmpty());
    m_bench->type("referenceCorrelationValue", "1.2");
    QVERIFY(refusal("referenceCorrelation").contains("-1 to 1"));
    m_bench->type("referenceDelayUValue", "-1");
    QVERIFY(!refusal("referenceDelayU").isEmpty());
    m_bench->type("referenceSensitivityValue", "0");
    QVERIFY(!refusal("referenceSensitivity").isEmpty());
    m_bench->type("referenceF0Value", "high");
    QVERIFY(!refusal("referenceF0").isEmpty());
    QCOMPARE(steps(), 0);
    QVERIFY(settings() == ComparisonSettings());
}

void TestComparisonPage::chain_isChosen_orRefused()
{
    chooseFile("chainBrowse",
        file("gain.csv", "frequency_hz,magnitude,u_magnitude\n1,10,0.01\n1e7,10,0.01\n"));
    QVERIFY2(refusal("chainBrowse").contains("begins with"), qPrintable(refusal("chainBrowse")));
    QVERIFY(m_bench->recipe().chain.source.empty());
    const double before = m_bench->session.results().response->magnitude[3];
    chooseFile("chainBrowse",
        file("chain.csv",
            "frequency_hz,magnitude,u_magnitude,phase_rad,u_phase_rad\n1,1,0.001,0,0\n"
            "10,0.5,0.001,0,0\n1e7,0.5,0.001,0,0\n"));
    QVERIFY(label("chainStated").startsWith("Table, from 1 Hz to 10 MHz; at 1 Hz: 1"));
    QTRY_VERIFY(m_bench->session.results().reference->chain);
    QTRY_VERIFY(std::abs(m_bench->session.results().response->magnitude[3] / before - 2.0) < 1e-3);
    press("chainRemove");
    QVERIFY(m_bench->recipe().chain.source.empty() && m_bench->recipe().chain.sha256.empty());
    m_bench->session.undoStack().undo();
    QVERIFY(m_bench->recipe().chain.loaded);
}

/// What a recipe brings along that cannot be: said on this page, nothing is blanked.
void TestComparisonPage::failedRun_isSaidHere()
{
    typeModel();
    tick(true);
    QTRY_VERIFY(m_bench->session.results().comparison->againstStep);
    const int rows = m_bench->control<ValueTable>("comparisonTable")->rowCount();
    Recipe recipe = m_bench->recipe();
    recipe.comparison.unit = "V/bar";
    m_bench->session.apply(recipe, "unit");
    test::waitComputed(m_bench->session);
    QTRY_COMPARE(m_bench->page.status(), StageStatus::Blocked);
    QVERIFY2(label("pageProblem").contains("V/bar"), qPrintable(label("pageProblem")));
    QCOMPARE(m_bench->page.standing().blockedBy, std::nullopt); // it is this page's own
    QCOMPARE(m_bench->control<ValueTable>("comparisonTable")->rowCount(), rows);
    QVERIFY(!m_bench->page.plots().front()->content().curves.empty());
}

void TestComparisonPage::swedish_hasNoEnglishNumbers()
{
    m_bench.reset();
    const test::InSwedish swedish;
    init();
    Recipe recipe;
    recipe.comparison = testing::referenceComparison();
    m_bench->session.apply(recipe, "comparison");
    test::waitComputed(m_bench->session);
    QTRY_VERIFY(m_bench->control<ValueTable>("comparisonTable")->rowCount() > 5);
    const QRegularExpression point("\\d\\.\\d");
    for (int row = 0; row < m_bench->control<ValueTable>("comparisonTable")->rowCount(); ++row)
        for (int column = 0; column < 7; ++column)
            QVERIFY2(!cell(row, column).contains(point), qPrintable(cell(row, column)));
    QVERIFY2(!label("comparisonVerdict").contains(point), qPrintable(label("comparisonVerdict")));
    QVERIFY2(label("comparisonVerdict").contains("referensgivare"),
        qPrintable(label("comparisonVerdict")));
    m_bench.reset(); // before its language goes
}

DYNCAL_TEST(TestComparisonPage)
#include "tst_comparison_page.moc"
