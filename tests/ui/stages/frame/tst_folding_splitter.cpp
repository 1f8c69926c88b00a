// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/stages/frame/folding_splitter.h"

#include <QScrollArea>
#include <QtTest>

using namespace dyncal;

/// Two parts of a page, in a window that gets narrower and wider.
class TestFoldingSplitter : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_splitter = std::make_unique<FoldingSplitter>();
        for (int i = 0; i < 2; ++i) {
            auto *part = new QWidget;
            part->setMinimumSize(100, 120);
            m_splitter->addWidget(part);
        }
        m_splitter->resize(3000, 600);
        m_splitter->show();
    }

    void narrow_foldsAndWide_unfolds()
    {
        QVERIFY(!m_splitter->isFolded());
        m_splitter->resize(210, 600);
        QVERIFY(m_splitter->isFolded());
        QCOMPARE(m_splitter->widget(0)->width(), 210);
        QVERIFY(m_splitter->minimumSizeHint().height() >= 240);
        m_splitter->resize(3000, 600);
        QVERIFY(!m_splitter->isFolded());
        QCOMPARE(m_splitter->widget(0)->height(), 600);
    }

    void largerLetters_fold()
    {
        m_splitter->resize(60 * m_splitter->fontMetrics().averageCharWidth(), 600);
        QVERIFY(!m_splitter->isFolded());
        QFont font = m_splitter->font();
        font.setPointSizeF(2.0 * font.pointSizeF());
        m_splitter->setFont(font);
        QVERIFY(m_splitter->isFolded());
    }

    void shares_areKeptForTheReturn()
    {
        m_splitter->setSizes({1000, 1995});
        const QList<int> before = m_splitter->sizes();
        m_splitter->resize(210, 600);
        m_splitter->setSizes({150, 445});
        const QList<int> folded = m_splitter->sizes();
        m_splitter->resize(3000, 600);
        QCOMPARE(m_splitter->sizes(), before);
        m_splitter->resize(210, 600);
        QCOMPARE(m_splitter->sizes(), folded);
    }

    /// So a page is scrolled up and down only.
    void least_isTheWidestPart()
    {
        m_splitter->widget(1)->setMinimumWidth(300);
        QVERIFY(m_splitter->minimumSizeHint().width() < 400);
        QVERIFY(m_splitter->minimumSizeHint().width() >= 300);
        QScrollArea page;
        page.setWidgetResizable(true);
        page.setWidget(m_splitter.release());
        page.resize(400, 300);
        page.show();
        QTRY_COMPARE(page.widget()->width(), page.viewport()->width());
    }

private:
    std::unique_ptr<FoldingSplitter> m_splitter;
};

DYNCAL_TEST(TestFoldingSplitter)
#include "tst_folding_splitter.moc"
