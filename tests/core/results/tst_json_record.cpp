// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Nothing is null without a reason, nothing is NaN, and every number reads back to the bit.

#include "core/base/json_text.h"
#include "core/results/json_record.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

using namespace dyncal;
using Json = nlohmann::json;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

} // namespace

class TestJsonRecord : public QObject
{
    Q_OBJECT

private slots:
    void number_orItsReason()
    {
        for (const std::optional<double> &gone :
            std::vector<std::optional<double>>{std::nullopt, kNan, -kNan, kInf, -kInf}) {
            JsonRecord record;
            record.number("f_hz", gone, "Not found.");
            QCOMPARE(record.take(), (Json{{"f_hz", nullptr}, {"f_hz_reason", "Not found."}}));
        }
        JsonRecord record;
        record.number("zero", 0.0, "Not found.");
        record.number("small", 5e-324, "Not found.");
        QCOMPARE(record.take(), (Json{{"zero", 0.0}, {"small", 5e-324}}));
    }

    void text_orItsReason()
    {
        JsonRecord record;
        record.text("a", "", "None given.");
        record.text("b", " ", "None given."); // somebody's blank is a text
        QCOMPARE(record.take(), (Json{{"a", nullptr}, {"a_reason", "None given."}, {"b", " "}}));
    }

    void list_keepsThePlacesOfWhatIsThere()
    {
        JsonRecord record;
        record.numbers("whole", Eigen::Vector2d(1.0, -2.0), "No.");
        record.numbers("none", Eigen::VectorXd(), "No values.");
        record.numbers("holes", Eigen::Vector4d(kNan, 1.0, kInf, 2.0), "Diverges.");
        const Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(3, 3);
        record.numbers("column", matrix.col(1), "No.");
        QCOMPARE(record.take(),
            (Json{{"whole", {1.0, -2.0}}, {"none", nullptr}, {"none_reason", "No values."},
                {"holes", {nullptr, 1.0, nullptr, 2.0}}, {"holes_reason", "Diverges."},
                {"column", {0.0, 1.0, 0.0}}}));
    }

    void matrix_isAListOfItsRows()
    {
        Eigen::MatrixXd matrix(2, 3);
        matrix << 1.0, 2.0, kNan, -kInf, 5.0, 6.0;
        QCOMPARE(rowsOf(matrix), (Json{{1.0, 2.0, nullptr}, {nullptr, 5.0, 6.0}}));
        QCOMPARE(rowsOf(Eigen::MatrixXd(0, 3)), Json::array());
        QCOMPARE(rowsOf(Eigen::MatrixXd(2, 0)), (Json{Json::array(), Json::array()}));
    }

    void emptyRecord_isAnObject() { QCOMPARE(jsonText(JsonRecord().take()), std::string("{}\n")); }

    void anyDouble_readsBackToTheBit()
    {
        std::mt19937_64 random(11);
        Eigen::VectorXd values(5000);
        for (double &value : values) {
            do
                value = std::bit_cast<double>(random());
            while (!std::isfinite(value));
        }
        values.head(4) << -0.0, 5e-324, 1.7976931348623157e308, 9007199254740993.0;
        JsonRecord record;
        record.numbers("x", values, "No.");
        const Json read = Json::parse(jsonText(record.take()));
        for (Index i = 0; i < values.size(); ++i) {
            const double again = read["x"][static_cast<std::size_t>(i)].get<double>();
            QCOMPARE(std::bit_cast<std::uint64_t>(again), std::bit_cast<std::uint64_t>(values[i]));
        }
    }
};

DYNCAL_TEST(TestJsonRecord)
#include "tst_json_record.moc"
