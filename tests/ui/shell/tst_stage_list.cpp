// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/shell/stage_list.h"

#include <QRegularExpression>
#include <QtTest>

#include <algorithm>
#include <vector>

using namespace dyncal;

namespace {

constexpr QSize kSize(220, 400); // words fit, sentences do not

void addRows(StageList &list)
{
    list.resize(kSize);
    list.show();
    for (const char *title : {"Captures", "Reference step", "Response window"})
        list.addStage(title);
}

std::vector<QSize> sizesOf(const StageList &list)
{
    std::vector<QSize> sizes;
    for (int row = 0; row < list.count(); ++row)
        sizes.push_back(list.item(row)->sizeHint());
    return sizes;
}

} // namespace

/// Rows follow their words; only the row that changed is measured anew.
class TestStageList : public QObject
{
    Q_OBJECT

private slots:
    void rows_afterManyChanges_areAsMeasuredAtOnce();
    void widestWord_ofAnyRow_fits();
};

void TestStageList::rows_afterManyChanges_areAsMeasuredAtOnce()
{
    const std::vector<PageStanding> last{{.status = StageStatus::DoneWithCautions, .cautions = 3},
        {.status = StageStatus::Blocked, .blockedBy = Page::Captures},
        {.status = StageStatus::Done}};
    StageList changed;
    addRows(changed);
    for (const StageStatus status :
        {StageStatus::Computing, StageStatus::Stale, StageStatus::Blocked, StageStatus::Computing})
        for (int row = changed.count() - 1; row >= 0; --row)
            changed.setStanding(row, {.status = status});
    StageList fresh;
    addRows(fresh);
    for (int row = 0; row < fresh.count(); ++row) {
        changed.setStanding(row, last[static_cast<std::size_t>(row)]);
        fresh.setStanding(row, last[static_cast<std::size_t>(row)]);
    }
    QCOMPARE(sizesOf(changed), sizesOf(fresh));
    QCOMPARE(changed.minimumWidth(), fresh.minimumWidth());

    QFont larger = changed.font();
    larger.setPointSizeF(1.5 * larger.pointSizeF()); // measures all rows
    const std::vector<QSize> before = sizesOf(changed);
    changed.setFont(larger);
    QVERIFY(sizesOf(changed) != before);
    changed.setFont(fresh.font());
    QCOMPARE(sizesOf(changed), sizesOf(fresh));
    QCOMPARE(changed.minimumWidth(), fresh.minimumWidth());
}

void TestStageList::widestWord_ofAnyRow_fits()
{
    StageList list;
    addRows(list);
    list.setStanding(1, {.status = StageStatus::Blocked, .blockedBy = Page::Uncertainty});
    const auto widest = [&] {
        int pixels = 0;
        for (int row = 0; row < list.count(); ++row)
            for (const QString &word :
                list.item(row)->text().split(QRegularExpression("\\s"), Qt::SkipEmptyParts))
                pixels = std::max(pixels, list.fontMetrics().horizontalAdvance(word));
        return pixels;
    };
    const int wide = list.minimumWidth();
    QVERIFY(wide >= widest() + list.iconSize().width());
    list.setStanding(2, {.status = StageStatus::Done}); // another row does not forget it
    QCOMPARE(list.minimumWidth(), wide);
    list.setStanding(1, {.status = StageStatus::Done});
    QVERIFY(list.minimumWidth() <= wide);
    QVERIFY(list.minimumWidth() >= widest() + list.iconSize().width());
}

DYNCAL_TEST(TestStageList)
#include "tst_stage_list.moc"
