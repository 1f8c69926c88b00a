// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/ui/support/quick_pipeline.h"
#include "tests/ui/support/sample_results.h"
#include "ui/stages/frame/prompts.h"
#include "ui/stages/frame/stage_page.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QtTest>

#include <memory>

namespace dyncal::test {

// Outside the template below: GCC 12 does not survive the lambdas of these in it.
inline Session::Pipeline realPipeline()
{
    return quickPipeline();
}
inline Session::Pipeline formulaPipeline()
{
    return samplePipeline;
}
inline void waitComputed(const Session &session)
{
    QTRY_VERIFY_WITH_TIMEOUT(!session.isComputing(), 60000);
}
inline void open(Session &session, const std::shared_ptr<const CaptureSet> &set)
{
    session.setFocus(StageId::Shock);
    session.reset({set, {}});
    waitComputed(session);
    QVERIFY(!session.error());
}

/// A page that asks something is given answers put in beforehand instead of dialogs.
inline Prompts &scripted()
{
    static Prompts prompts;
    prompts.setScripted();
    return prompts;
}
template <typename Page>
class ScriptedPage : public Page
{
public:
    explicit ScriptedPage(Session &session)
        : Page(session, scripted())
    {
    }
};

/// A page that states when something was made has the same moment in every test.
template <typename Page>
class DatedPage : public Page
{
public:
    explicit DatedPage(Session &session)
        : Page(session, [] { return Result<std::string>("2026-05-04T12:00:00Z"); })
    {
    }
};

/// One page, its inspector beside it, as a hand and an eye have it: controls by their names.
template <typename Page>
struct PageBench
{
    Session session;
    Page page;
    std::unique_ptr<InspectorForm> inspector;

    /// Over formula results.
    PageBench()
        : PageBench(formulaPipeline(), std::make_shared<const CaptureSet>(sampleCaptures()))
    {
    }
    /// Over the real pipeline.
    explicit PageBench(const std::shared_ptr<const CaptureSet> &set)
        : PageBench(realPipeline(), set)
    {
    }

    template <typename T>
    T *control(const QString &name)
    {
        T *found = inspector->findChild<T *>(name);
        if (!found)
            found = page.template findChild<T *>(name);
        if (!found)
            qFatal("no %s", qPrintable(name));
        return found;
    }
    bool isEnabled(const QString &name) { return control<QWidget>(name)->isEnabled(); }
    /// A button, and what it sets off.
    void press(const QString &name)
    {
        QTest::mouseClick(control<QPushButton>(name), Qt::LeftButton);
        waitComputed(session);
    }
    int steps() { return session.undoStack().count(); } ///< that can be undone
    void choose(const QString &name, int choice)
    {
        auto *box = control<QComboBox>(name);
        box->setCurrentIndex(choice);
        emit box->activated(choice);
    }
    void type(const QString &name, const QString &text)
    {
        auto *edit = control<QLineEdit>(name);
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    const Recipe &recipe() const { return session.recipe(); }

private:
    PageBench(Session::Pipeline pipeline, const std::shared_ptr<const CaptureSet> &set)
        : session(std::move(pipeline))
        , page(session)
        , inspector(page.inspector())
    {
        open(session, set);
        page.resize(1000, 800);
        page.show();
        inspector->show();
    }
};

} // namespace dyncal::test
