// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/publication.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;

namespace {

Finding finding(const char *id, Severity severity)
{
    return {.id = id, .severity = severity, .shot = 2, .message = {"Shot 2 is odd.", {}}};
}

/// The example's results with one more finding of a stage.
PipelineOutcome exampleWith(const Finding &added)
{
    PipelineOutcome outcome{example::calibration(), {}, {}};
    auto response = std::make_shared<ResponseResult>(*outcome.results.response);
    response->findings.push_back(added);
    outcome.results.response = response;
    return outcome;
}

} // namespace

/// What may leave the program besides results.json.
class TestPublication : public QObject
{
    Q_OBJECT

private slots:
    void goodRun_mayBePublished()
    {
        QVERIFY(mayPublish({example::calibration(), {}, {}}));
        QVERIFY(mayPublish(exampleWith(finding("WIN-001", Severity::Caution))));
    }

    void blockingFinding_isTheObstacle()
    {
        const auto obstacle = publicationObstacle(exampleWith(finding("CAP-015", Severity::Block)));
        QVERIFY(obstacle.has_value());
        QCOMPARE(obstacle->kind, ErrorKind::DataBlocked);
        QCOMPARE(obstacle->findingId, std::string("CAP-015"));
        QCOMPARE(obstacle->shot, Index(2));
        QCOMPARE(english(obstacle->message), std::string("Shot 2 is odd."));
    }

    void stoppedRun_isNotPublished()
    {
        PipelineOutcome outcome{example::calibration(), {}, {}};
        outcome.error = Error{ErrorKind::Cancelled, {}, {}, 0};
        QVERIFY(!mayPublish(outcome));
        outcome.error = Error{ErrorKind::DataBlocked, {"No step.", {}}, "CAP-009", 1};
        QCOMPARE(publicationObstacle(outcome)->findingId, std::string("CAP-009"));
    }
};

DYNCAL_TEST(TestPublication)
#include "tst_publication.moc"
