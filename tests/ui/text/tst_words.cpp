// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "ui/text/core_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/level_text.h"
#include "ui/text/plain_text_rule.h"
#include "ui/text/shown_text.h"

#include <QLabel>
#include <QSet>
#include <QtTest>

using namespace dyncal;

namespace {

Finding finding(const char *text, std::vector<std::string> arguments, Index shot)
{
    Finding made;
    made.id = "WIN-001";
    made.severity = Severity::Caution;
    made.shot = shot;
    made.message = {text, std::move(arguments)};
    return made;
}

} // namespace

/// Words and foreign text on their way to the screen.
class TestWords : public QObject
{
    Q_OBJECT

private slots:
    void finding_namesItsShotOnce();
    void finding_argumentsAreNotPlaces();
    void finding_hostileArgument_staysOneLine();
    void message_below_isALineOfItsOwn();
    void words_areAllDifferent_inBothLanguages();
    void swedish_sentencesAreTranslated();
    void mnemonic_isShownAsItIs();
    void title_keepsTheMarkOfUnsavedChanges();
    void cell_pasted_isNoFormula();
    void labels_showTagsAsText_whileTheRuleLives();
};

void TestWords::finding_namesItsShotOnce()
{
    QCOMPARE(findingLine(finding("Shot %1: the window is short.", {"2"}, 2)),
        QString("▲ Caution WIN-001: Shot 2: the window is short."));
    QCOMPARE(findingLine(finding("The window is short.", {}, 2)),
        QString("▲ Caution WIN-001, shot 2: The window is short."));
    QCOMPARE(findingLine(finding("The window is short.", {}, 0)),
        QString("▲ Caution WIN-001: The window is short."));
    Finding plain = finding("No.", {}, 0);
    plain.id.clear();
    plain.severity = Severity::Block;
    QCOMPARE(findingLine(plain), QString("■ Blocked: No."));
}

void TestWords::finding_argumentsAreNotPlaces()
{
    // A channel may be called "%2": it is a name, not a place for the next argument.
    const QString line = findingLine(finding("Channel %1 and file %2.", {"%2", "a%1b"}, 0));
    QVERIFY2(line.endsWith("Channel %2 and file a%1b."), qPrintable(line));
}

void TestWords::finding_hostileArgument_staysOneLine()
{
    const QString line
        = findingLine(finding("Channel %1 is empty.", {"a\nb\r\x1b[31m\u202Etxt"}, 0));
    QVERIFY(!line.contains('\n') && !line.contains('\r'));
    QVERIFY(!line.contains(QChar(0x1b)) && !line.contains(QChar(0x202e)));
    QVERIFY(line.endsWith("is empty."));
}

void TestWords::message_below_isALineOfItsOwn()
{
    Message message{"First.", {}};
    message.below = {{"Second %1.", {"one"}}, {"Third.", {}}};
    QCOMPARE(translated(message), QString("First.\nSecond one.\nThird."));
}

void TestWords::words_areAllDifferent_inBothLanguages()
{
    const auto check = [] {
        QSet<QString> levels;
        for (const ShotLevel level :
            {ShotLevel::None, ShotLevel::Low, ShotLevel::Medium, ShotLevel::High})
            levels << levelText(level);
        QCOMPARE(levels.size(), 4);
        QSet<QString> roles;
        for (const ChannelRole role : {ChannelRole::Dut, ChannelRole::DrivenSide,
                 ChannelRole::Driver, ChannelRole::Trigger, ChannelRole::Other})
            roles << roleText(role);
        QCOMPARE(roles.size(), 5);
        QSet<QString> severities;
        QSet<QString> glyphs;
        for (const Severity severity : {Severity::Info, Severity::Caution, Severity::Block}) {
            severities << severityWord(severity);
            glyphs << severityGlyph(severity);
        }
        QCOMPARE(severities.size(), 3);
        QCOMPARE(glyphs.size(), 3); // never colour alone
    };
    check();
    const test::InSwedish swedish;
    check();
    QCOMPARE(levelText(ShotLevel::Low), QString("Låg"));
}

void TestWords::swedish_sentencesAreTranslated()
{
    const char *english
        = "Shot %1 has %2 samples in its window, too few to be reduced %3 times to the rate of the other shots; set window.end_s or exclude a shot.";
    const test::InSwedish swedish;
    const QString line = findingLine(finding(english, {"2", "40", "5"}, 2));
    QVERIFY2(line.startsWith("▲ Varning WIN-001: Skott 2 har 40 sampel"), qPrintable(line));
    QVERIFY2(line.contains("“fönstrets slut”"), qPrintable(line)); // the field, not its key
    QVERIFY(findingLine(finding("The window is odd.", {}, 3)).contains(", skott 3: "));
}

void TestWords::mnemonic_isShownAsItIs()
{
    QLabel label;
    label.setText(withoutMnemonic("R&D & more"));
    QCOMPARE(label.text(), QString("R&&D && more"));
    QCOMPARE(withoutMnemonic(""), QString());
}

void TestWords::title_keepsTheMarkOfUnsavedChanges()
{
    QWidget window;
    window.setWindowTitle(asTitle("a[*]b.dyncal") + "[*]");
    window.setWindowModified(true);
    // Qt takes a doubled mark for the text and the last one for the state.
    QCOMPARE(asTitle("a[*]b"), QString("a[*][*]b"));
    QCOMPARE(window.windowTitle().count("[*]"), 3);
}

void TestWords::cell_pasted_isNoFormula()
{
    for (const char *text : {"=1+1", "+cmd", "@SUM(A1)", "=HYPERLINK(\"x\")"}) {
        const QString cell = pasted(text);
        QVERIFY2(!QString("=+@").contains(cell.front()), qPrintable(cell));
        QVERIFY(cell.contains(QString(text).mid(1)));
    }
    QCOMPARE(pasted("-1.5"), QString("-1.5")); // a number stays one
    QCOMPARE(pasted("2.33 MHz"), QString("2.33 MHz"));
    QVERIFY(!pasted("a\tb").contains('\t')); // it would be two cells
    QVERIFY(!pasted("a\nb").contains('\n'));
}

void TestWords::labels_showTagsAsText_whileTheRuleLives()
{
    const QString html = "<img src='file:///etc/passwd'> <b>x</b>";
    QObject owner;
    auto *rule = new PlainTextRule(&owner);
    QLabel label(html);
    QLabel own;
    own.setTextFormat(Qt::RichText); // the program's own text may say so
    label.show();
    own.show();
    QCOMPARE(label.textFormat(), Qt::PlainText);
    QCOMPARE(own.textFormat(), Qt::RichText);
    delete rule;
    QLabel later(html);
    later.show();
    QCOMPARE(later.textFormat(), Qt::AutoText);
}

DYNCAL_TEST(TestWords)
#include "tst_words.moc"
