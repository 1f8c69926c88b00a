// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/pipeline.h"
#include "tests/support/test_program.h"
#include "tests/ui/shell/window_bench.h"

#include <QAction>
#include <QMenuBar>
#include <QToolBar>
#include <QtTest>

using namespace dyncal;

/// All that has words is made anew in another language, and what was there before goes.
class TestLanguageSwitch : public QObject
{
    Q_OBJECT

private slots:
    void changedOften_keepsNothing();
    void toolBars_haveTheSame();

private:
    static void use(const test::WindowBench &bench, const char *code)
    {
        auto *action = bench.find<QAction>(QString("languageAction_") + code);
        action->trigger();
        for (int page = 0; page < std::ssize(bench.window->pages()); ++page) {
            bench.window->showPage(page);
            QCoreApplication::processEvents();
        }
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QCoreApplication::processEvents();
    }
    static QMap<QString, int> objectsOf(const test::WindowBench &bench)
    {
        QMap<QString, int> counts;
        for (const QObject *object : bench.window->findChildren<QObject *>())
            ++counts[object->metaObject()->className()];
        return counts;
    }
};

void TestLanguageSwitch::changedOften_keepsNothing()
{
    test::WindowBench bench(runPipeline);
    bench.window->show();
    for (const char *code : {"sv", "en"}) // until every page was shown in both
        use(bench, code);
    const QMap<QString, int> before = objectsOf(bench);
    for (int round = 0; round < 3; ++round)
        for (const char *code : {"sv", "en"})
            use(bench, code);
    QMap<QString, int> after = objectsOf(bench);
    for (auto i = before.begin(); i != before.end(); ++i)
        after[i.key()] -= i.value();
    for (auto i = after.begin(); i != after.end(); ++i)
        QVERIFY2(i.value() <= 0, qPrintable(QString("%1 more %2").arg(i.value()).arg(i.key())));
}

/// Commands and the lines between them, as before.
void TestLanguageSwitch::toolBars_haveTheSame()
{
    test::WindowBench bench(runPipeline);
    bench.window->show();
    const auto shown = [&](const QString &bar) {
        QStringList names;
        for (const QAction *action : bench.find<QToolBar>(bar)->actions())
            names << (action->isSeparator() ? "|" : action->objectName());
        return names;
    };
    const QStringList commands = shown("toolBar"), next = shown("nextLine");
    QVERIFY(commands.size() > 9 && commands.contains("|"));
    use(bench, "sv");
    use(bench, "en");
    QCOMPARE(shown("toolBar"), commands);
    QCOMPARE(shown("nextLine"), next);
    QVERIFY(bench.find<QWidget>("nextLine")->findChild<QWidget *>("nextBar"));
}

DYNCAL_TEST(TestLanguageSwitch)
#include "tst_language_switch.moc"
