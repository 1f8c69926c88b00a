// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/allocated_memory.h"
#include "tests/support/test_program.h"
#include "ui/text/line_length_rule.h"

#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QtTest>

using namespace dyncal;

class TestLineLengthRule : public QObject
{
    Q_OBJECT

private slots:
    void init() { QApplication::clipboard()->setText(QString(1'000'000, 'x')); }
    void cleanup() { QApplication::clipboard()->clear(); }
    void shownLine_takesSoMuch();
    void ownLimit_andLongerText_stay();
    void tablePastedOften_isNotKept();
};

void TestLineLengthRule::shownLine_takesSoMuch()
{
    const LineLengthRule rule;
    QLineEdit line("before ");
    line.show();
    line.setCursorPosition(7);
    line.paste();
    QCOMPARE(line.text().size(), kMostLettersOfLine);
    QVERIFY(line.text().startsWith("before xxx"));
}

void TestLineLengthRule::ownLimit_andLongerText_stay()
{
    const LineLengthRule rule;
    QLineEdit own;
    own.setMaxLength(10'000);
    own.show();
    own.paste();
    QCOMPARE(own.text().size(), 10'000);
    const QString kept(kMostLettersOfLine + 1, 'y');
    QLineEdit longer(kept);
    longer.show();
    QCOMPARE(longer.text(), kept);
}

/// What the rule is for: the undo of a line keeps every letter that was pasted into it and
/// replaced.
void TestLineLengthRule::tablePastedOften_isNotKept()
{
    const LineLengthRule rule;
    const double before = testing::allocated_MiB();
    std::vector<std::unique_ptr<QLineEdit>> lines;
    for (int i = 0; i < 40; ++i) {
        lines.push_back(std::make_unique<QLineEdit>());
        lines.back()->show();
        lines.back()->paste();
        lines.back()->selectAll();
        lines.back()->paste();
    }
    const double kept = testing::allocated_MiB() - before;
    QVERIFY2(kept < 20.0, qPrintable(QString("%1 MiB").arg(kept))); // above 60 without the rule
}

DYNCAL_TEST(TestLineLengthRule)
#include "tst_line_length_rule.moc"
