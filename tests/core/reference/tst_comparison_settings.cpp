// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Two settings are alike only where they give the same numbers: whether results are computed anew.

#include "core/reference/comparison_settings.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <functional>

using namespace dyncal;

namespace {

using Change = std::function<void(ComparisonSettings &)>;

std::shared_ptr<const ReferenceSource> fileWith(const char *hash)
{
    return std::make_shared<const ReferenceSource>(ReferenceSource{hash, "content"});
}

} // namespace

class TestComparisonSettings : public QObject
{
    Q_OBJECT

private slots:
    void anyKey_makesThemDiffer_data()
    {
        QTest::addColumn<Change>("change");
        const auto row
            = [](const char *name, const Change &change) { QTest::newRow(name) << change; };
        using S = ComparisonSettings;
        row("enabled", [](S &s) { s.enabled = true; });
        row("channel", [](S &s) { s.channel = "Ref"; });
        row("source", [](S &s) { s.source = "ref.csv"; });
        row("sha256", [](S &s) { s.sha256 = "ab"; });
        row("quantity_id", [](S &s) { s.quantityId = "a"; });
        row("certificate", [](S &s) { s.certificate = "R-1"; });
        row("due", [](S &s) { s.due = "2027-01-31"; });
        row("model", [](S &s) { s.model = ReferenceModel(); });
        row("unit", [](S &s) { s.unit = "A/Pa"; });
        row("delay_s", [](S &s) { s.delay_s = 1e-9; });
        row("u_delay_s", [](S &s) { s.u_delay_s = 0.0; });
        row("correlation_with_step", [](S &s) { s.correlationWithStep = 0.5; });
        row("content of the file", [](S &s) { s.loaded = fileWith("2"); });
        row("no file", [](S &s) { s.loaded.reset(); });
    }
    void anyKey_makesThemDiffer()
    {
        QFETCH(Change, change);
        ComparisonSettings one;
        one.loaded = fileWith("1");
        ComparisonSettings other = one;
        QVERIFY(one == other);
        change(other);
        QVERIFY(!(one == other));
    }

    void sameContent_isTheSame()
    {
        ComparisonSettings one, other;
        one.loaded = fileWith("1");
        other.loaded = fileWith("1"); // read once more
        QVERIFY(one == other);
    }
};

DYNCAL_TEST(TestComparisonSettings)
#include "tst_comparison_settings.moc"
