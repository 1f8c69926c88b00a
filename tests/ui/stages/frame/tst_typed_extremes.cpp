// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/captures_page.h"
#include "ui/stages/certificate/certificate_page.h"
#include "ui/stages/components_page.h"
#include "ui/stages/frame/optional_edit.h"
#include "ui/stages/frame/prompts.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/model_input_page.h"
#include "ui/stages/order/order_page.h"
#include "ui/stages/shock/shock_page.h"
#include "ui/stages/spectrum/spectrum_page.h"
#include "ui/stages/window/window_page.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QtTest>

using namespace dyncal;
using test::waitComputed;

namespace {

/// The results do not matter here, so the recipe is not looked at.
PipelineOutcome unmovedPipeline(const std::shared_ptr<const CaptureSet> &captures, const Recipe &,
    ResultCache &cache, StageId last, const JobControl &control)
{
    return test::samplePipeline(captures, Recipe(), cache, last, control);
}

/// Why the recipe could not be read from its own project again; empty where it can.
QString unreadable(const Recipe &recipe)
{
    const Result<Recipe> again = parseRecipe(recipeJson(recipe));
    if (!again)
        return QString::fromStdString(english(again.error().message));
    return *again == recipe ? QString() : QString("the recipe read back is another");
}

std::unique_ptr<StagePage> makePage(const QString &name, Session &session, Prompts &prompts)
{
    if (name == "captures")
        return std::make_unique<CapturesPage>(session, prompts);
    if (name == "window")
        return std::make_unique<WindowPage>(session);
    if (name == "spectrum")
        return std::make_unique<SpectrumPage>(session);
    if (name == "components")
        return std::make_unique<ComponentsPage>(session);
    if (name == "input")
        return std::make_unique<ModelInputPage>(session);
    if (name == "order")
        return std::make_unique<OrderPage>(session);
    if (name == "certificate")
        return std::make_unique<test::DatedPage<CertificatePage>>(session);
    return std::make_unique<ShockPage>(session);
}

/// Everything that stands beside the plots of one page.
struct Bench
{
    Session session{unmovedPipeline};
    Prompts prompts;
    std::unique_ptr<StagePage> page;
    std::unique_ptr<InspectorForm> inspector;

    explicit Bench(const QString &name)
    {
        prompts.setScripted();
        page = makePage(name, session, prompts);
        inspector.reset(page->inspector());
        test::open(session, std::make_shared<const CaptureSet>(test::sampleCaptures()));
        page->show();
        inspector->show();
    }
    /// What is automatic is by hand then.
    void untickAutomatics()
    {
        for (QCheckBox *box : inspector->findChildren<QCheckBox *>())
            if (box->objectName().endsWith("Auto") && box->isChecked() && box->isEnabled())
                box->click();
        waitComputed(session);
    }
};

} // namespace

/// Whatever is typed into the numbers of a page: what the recipe then holds can be saved and read
/// again, and undo gives back what was there.
class TestTypedExtremes : public QObject
{
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void numbers_atTheirLimits_canBeSaved_data() { pages(); }
    void numbers_atTheirLimits_canBeSaved();
    void optionalNumbers_withNonsense_canBeSaved_data() { pages(); }
    void optionalNumbers_withNonsense_canBeSaved();
    void recipe_isTheSame_afterUndoOfAll_data() { pages(); }
    void recipe_isTheSame_afterUndoOfAll();
    void untouchedFields_leftWithEnter_changeNothing_data() { pages(); }
    void untouchedFields_leftWithEnter_changeNothing();

private:
    static void pages()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"captures", "window", "spectrum", "components", "input", "order",
                 "certificate", "shock"})
            QTest::newRow(name) << QString(name);
    }
};

void TestTypedExtremes::numbers_atTheirLimits_canBeSaved()
{
    QFETCH(QString, name);
    Bench bench(name);
    bench.untickAutomatics();
    for (QuantityEdit *edit : bench.inspector->findChildren<QuantityEdit *>()) {
        if (edit->isReadOnly() || !edit->isEnabled())
            continue;
        for (const double value : {edit->minimum(), edit->maximum(), 0.0, -2.0}) {
            const double before = edit->value();
            edit->setValue(value);
            const QString fault = unreadable(bench.session.recipe());
            QVERIFY2(fault.isEmpty(),
                qPrintable(QString("%1 = %2: %3").arg(edit->objectName()).arg(value).arg(fault)));
            edit->setValue(before);
        }
    }
    waitComputed(bench.session);
}

void TestTypedExtremes::optionalNumbers_withNonsense_canBeSaved()
{
    QFETCH(QString, name);
    Bench bench(name);
    for (OptionalEdit *edit : bench.inspector->findChildren<OptionalEdit *>()) {
        auto *text = edit->findChild<QLineEdit *>();
        if (!text->isEnabled())
            continue;
        for (const char *typed : {"1e300", "-1e300", "0", "-1", "1e-300", "nan", "inf", "1,5,5",
                 "0x10", "12 kPa", "--", "1e999"}) {
            text->selectAll();
            QTest::keyClicks(text, typed);
            QTest::keyClick(text, Qt::Key_Return);
            const QString fault = unreadable(bench.session.recipe());
            QVERIFY2(fault.isEmpty(),
                qPrintable(QString("%1 '%2': %3").arg(edit->objectName(), typed, fault)));
        }
    }
    waitComputed(bench.session);
}

void TestTypedExtremes::recipe_isTheSame_afterUndoOfAll()
{
    QFETCH(QString, name);
    Bench bench(name);
    const Recipe before = bench.session.recipe();
    bench.untickAutomatics();
    for (QuantityEdit *edit : bench.inspector->findChildren<QuantityEdit *>())
        if (!edit->isReadOnly() && edit->isEnabled())
            edit->stepUp();
    for (QComboBox *box : bench.inspector->findChildren<QComboBox *>()) {
        if (box->count() < 2 || !box->isEnabled())
            continue;
        box->setCurrentIndex(1);
        emit box->activated(1);
    }
    waitComputed(bench.session);
    const Recipe after = bench.session.recipe();
    while (bench.session.undoStack().canUndo())
        bench.session.undoStack().undo();
    waitComputed(bench.session);
    QVERIFY(bench.session.recipe() == before);
    while (bench.session.undoStack().canRedo())
        bench.session.undoStack().redo();
    waitComputed(bench.session);
    QVERIFY(bench.session.recipe() == after);
    QCOMPARE(unreadable(after), QString());
}

void TestTypedExtremes::untouchedFields_leftWithEnter_changeNothing()
{
    QFETCH(QString, name);
    const test::InSwedish swedish; // a decimal comma must read back, too
    Bench bench(name);
    bench.untickAutomatics();
    const int steps = bench.session.undoStack().count();
    for (QuantityEdit *edit : bench.inspector->findChildren<QuantityEdit *>())
        QTest::keyClick(edit, Qt::Key_Return);
    for (QLineEdit *edit : bench.inspector->findChildren<QLineEdit *>()) {
        if (edit->objectName() == "adoptReason") // there Enter adopts
            continue;
        QTest::keyClick(edit, Qt::Key_Return);
    }
    QCOMPARE(bench.session.undoStack().count(), steps);
    waitComputed(bench.session);
}

DYNCAL_TEST(TestTypedExtremes)
#include "tst_typed_extremes.moc"
