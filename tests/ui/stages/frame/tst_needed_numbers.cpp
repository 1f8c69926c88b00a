// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers that are needed together, typed one by one; and changes that a file would not be read
// with.

#include "tests/support/test_program.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/frame/checked_change.h"
#include "ui/stages/frame/needed_numbers.h"
#include "ui/stages/frame/refusal_note.h"

#include <QLabel>
#include <QLineEdit>
#include <QtTest>

using namespace dyncal;

class TestNeededNumbers : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<QWidget> m_window;
    InspectorForm *m_form = nullptr;
    std::unique_ptr<NeededNumbers> m_numbers;
    std::vector<std::vector<double>> m_completed;

    QLineEdit *field(const char *name) const
    {
        return m_form->findChild<QLineEdit *>(QString(name) + "Value");
    }
    QLabel *note() const { return m_form->findChild<QLabel *>("note"); }
    void type(const char *name, const QString &text) const
    {
        field(name)->selectAll();
        QTest::keyClick(field(name), Qt::Key_Delete);
        QTest::keyClicks(field(name), text);
        QTest::keyClick(field(name), Qt::Key_Return);
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init()
    {
        m_window = std::make_unique<QWidget>();
        m_form = new InspectorForm(m_window.get());
        m_numbers = std::make_unique<NeededNumbers>(*m_form, nullptr);
        m_numbers->add("Length", "length", new OptionalEdit({"m", 1.0}, 0.0, 10.0));
        m_numbers->add("Width", "width", new OptionalEdit({"m", 1.0}, 0.0, 10.0));
        m_numbers->addNote("note");
        m_completed.clear();
        connect(m_numbers.get(), &NeededNumbers::completed, this,
            [this](const std::vector<double> &values) { m_completed.push_back(values); });
        m_window->show();
    }

    void firstOnes_wait_andTheNoteSaysForWhat()
    {
        QVERIFY(note()->text().isEmpty());
        type("width", "2");
        QVERIFY(m_completed.empty());
        QVERIFY2(note()->text().contains("Length") && !note()->text().contains("Width"),
            qPrintable(note()->text()));
        QCOMPARE(m_numbers->typed(), std::size_t(1));
        type("length", "3");
        QCOMPARE(m_completed, (std::vector<std::vector<double>>{{3.0, 2.0}}));
    }

    void lastOne_isTakenBack_unlessItIsShownAgain()
    {
        type("width", "2");
        type("length", "3");
        QCOMPARE(field("length")->text(), QString()); // nobody took it
        m_numbers->show(std::vector{3.0, 2.0});
        QCOMPARE(field("length")->text(), QString("3"));
        QVERIFY(note()->text().isEmpty());
    }

    void known_oneChanges_noneIsLeftOut()
    {
        m_numbers->show(std::vector{3.0, 2.0});
        type("length", "");
        QVERIFY(!refusalOnShow(field("length")).isEmpty());
        QCOMPARE(field("length")->text(), QString("3"));
        QVERIFY(m_completed.empty());
        type("length", "4");
        QCOMPARE(m_completed.back(), (std::vector{4.0, 2.0}));
    }

    void undone_allAreGone_whatWasTypedBeforeStays()
    {
        type("width", "2");
        m_numbers->show(std::nullopt);
        QCOMPARE(field("width")->text(), QString("2"));
        m_numbers->show(std::vector{3.0, 2.0});
        m_numbers->show(std::nullopt);
        QCOMPARE(field("width")->text(), QString());
        QCOMPARE(m_numbers->typed(), std::size_t(0));
    }

    void forbiddenChange_isSaid_andNotMade()
    {
        Session session(test::formulaPipeline());
        test::open(session, std::make_shared<const CaptureSet>(test::sampleCaptures()));
        QWidget *at = field("length");
        QVERIFY(!changeIfAllowed(session, at, "claim", [](Recipe &r) {
            r.certificate.decision = DecisionSettings{DecisionRule::Simple, 5.0, 2e3, 1e3};
        }));
        QVERIFY2(
            refusalOnShow(at).contains("frequency of the claim"), qPrintable(refusalOnShow(at)));
        QCOMPARE(session.undoStack().count(), 0);
        QVERIFY(changeIfAllowed(session, at, "claim", [](Recipe &r) {
            r.certificate.decision = DecisionSettings{DecisionRule::Simple, 5.0, 1e3, 2e3};
        }));
        QVERIFY(session.recipe().certificate.decision.has_value());
        QVERIFY(refusalOnShow(at).isEmpty());
    }
};

DYNCAL_TEST(TestNeededNumbers)
#include "tst_needed_numbers.moc"
