// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a control says of itself when the pointer rests on it.

#include "tests/support/file_bytes.h"
#include "tests/support/test_program.h"
#include "tests/ui/shell/window_bench.h"
#include "ui/shell/tips/control_tips.h"
#include "ui/shell/tips/tip_texts.h"

#include <QDirIterator>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTest>

#include <set>

using namespace dyncal;

namespace {

/// All sources of the window but those of the tips themselves.
QByteArray sourcesOfTheWindow()
{
    QByteArray text;
    QDirIterator sources(qEnvironmentVariable("DYNCAL_SOURCE_DIR", ".") + "/ui", {"*.cpp", "*.h"},
        QDir::Files, QDirIterator::Subdirectories);
    while (sources.hasNext())
        if (const QString path = sources.next(); !path.contains("/shell/tips/"))
            text += testing::bytesOf(path);
    return text;
}

/// Names of the window's controls, and those that its sources write out: of dialogs, and of lists
/// that come with the recordings.
bool isNameOfAControl(const QByteArray &name, const QByteArray &sources, const QWidget &window)
{
    const QRegularExpression begin('^' + QString(name));
    return sources.contains('"' + name) || !window.findChildren<QWidget *>(begin).isEmpty();
}

/// Shown once, as in a window.
template <typename Widget>
QString tipOfShown(Widget &widget)
{
    widget.ensurePolished();
    return widget.toolTip();
}

} // namespace

class TestControlTips : public QObject
{
    Q_OBJECT

private slots:
    void name_findsItsSentence_itsOwnBeforeThatOfItsKind()
    {
        QCOMPARE(tipFor("dutScale"), QString("Factor on the sensor's values"));
        QCOMPARE(tipFor("roleOf_Driven side"), tipFor("roleOf_DUT"));
        QVERIFY(!tipFor("roleOf_DUT").isEmpty());
        QCOMPARE(tipFor("levelOfShot3"), QString("Name of the shot's pressure level"));
        QCOMPARE(tipFor("dutScaleOfAnother"), QString());
        QCOMPARE(tipFor({}), QString());
    }

    /// The parts of what is made of several controls.
    void parts_sayWhatTheWholeSays()
    {
        for (const char *list : {"known", "correlation", "capability", "stated"})
            for (const char *part : {"List", "Add", "Replace", "Remove"})
                QVERIFY2(!tipFor(QString(list) + part).isEmpty(), part);
        QVERIFY(tipFor("knownAdd") != tipFor("knownRemove"));
        QCOMPARE(tipFor("dutScaleValue"), tipFor("dutScale"));
        QVERIFY(tipFor("whateverAuto").contains("the program decides"));
    }

    void table_namesEachOnce_andOnlyWhatTheWindowHas()
    {
        const QByteArray sources = sourcesOfTheWindow();
        QVERIFY(sources.size() > 100'000);
        const test::WindowBench bench([](auto &&...) { return PipelineOutcome(); });
        std::set<QByteArray> names;
        for (const auto &[name, sentence] : tipTexts()) {
            QVERIFY2(names.insert(name).second, name);
            QVERIFY2(isNameOfAControl(name, sources, *bench.window), name);
            const QString words(sentence);
            QVERIFY2(words.size() > 5 && words.front().isUpper() && !words.endsWith('.'), sentence);
        }
    }

    void shown_aControlGetsItsTip_withTheKeysOfAButton()
    {
        const ControlTips tips(nullptr);
        QLineEdit named;
        named.setObjectName("dutScale");
        QCOMPARE(tipOfShown(named), tipFor("dutScale"));

        QPushButton keyed("&Press");
        keyed.setShortcut(QKeySequence("Ctrl+K"));
        QCOMPARE(tipOfShown(keyed), QString("Press (Ctrl+K)"));

        QPushButton spoken;
        spoken.setAccessibleName("Of a reader");
        QCOMPARE(tipOfShown(spoken), QString("Of a reader"));

        QLabel label("No control");
        label.setObjectName("dutScale");
        QCOMPARE(tipOfShown(label), QString());
    }

    void ownTip_stays_andOneTakenAwayGivesWay()
    {
        const ControlTips tips(nullptr);
        QPushButton button("Press");
        button.setObjectName("dutScale");
        button.setToolTip("Why it cannot be pressed");
        QCOMPARE(tipOfShown(button), QString("Why it cannot be pressed"));
        button.setToolTip({});
        QCOMPARE(button.toolTip(), tipFor("dutScale"));
    }

    void lineOfASpinBox_speaksForTheWhole()
    {
        const ControlTips tips(nullptr);
        QDoubleSpinBox box;
        box.setObjectName("dutScale");
        QCOMPARE(tipOfShown(box), tipFor("dutScale"));
        QCOMPARE(tipOfShown(*box.findChild<QLineEdit *>()), tipFor("dutScale"));
    }

    void withoutIt_nothingIsGiven()
    {
        QPushButton button("Press");
        QCOMPARE(tipOfShown(button), QString());
    }
};

DYNCAL_TEST(TestControlTips)
#include "tst_control_tips.moc"
