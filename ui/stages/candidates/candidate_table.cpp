// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/candidates/candidate_table.h"

#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QHeaderView>

#include <cmath>
#include <limits>

namespace dyncal {

namespace {

constexpr int kValueRole = Qt::UserRole;

/// Sorts by value, not by text; cells without a value come last.
class ValueItem : public QTableWidgetItem
{
public:
    ValueItem(const QString &text, std::optional<double> value)
        : QTableWidgetItem(text)
    {
        setData(kValueRole, value.value_or(std::numeric_limits<double>::infinity()));
        setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    bool operator<(const QTableWidgetItem &other) const override
    {
        const double mine = data(kValueRole).toDouble();
        const double theirs = other.data(kValueRole).toDouble();
        if (std::isinf(mine) != std::isinf(theirs)) // a descending sort asks the other way round
            return std::isinf(theirs) == isAscending();
        return mine < theirs;
    }

private:
    bool isAscending() const
    {
        const QTableWidget *table = tableWidget();
        return !table || table->horizontalHeader()->sortIndicatorOrder() == Qt::AscendingOrder;
    }
};

struct Cell
{
    QString text;
    std::optional<double> value;
};

QString shown(double value, const QString &unit, int digits)
{
    if (unit == QLatin1String("Hz"))
        return shownQuantity(value, unit, digits);
    return unit.isEmpty() ? shownNumber(value, digits)
                          : shownNumber(value, digits) + QLatin1Char(' ') + unit;
}

QString signedText(double value, const QString &text)
{
    return value >= 0.0 ? QStringLiteral("+") + text : text;
}

/// A value, or its difference to that of the reference.
Cell cell(std::optional<double> value, const std::optional<double> *reference, const QString &unit,
    int digits)
{
    if (!value)
        return {QStringLiteral("–"), {}};
    if (!reference || !*reference)
        return {shown(*value, unit, digits), value};
    const double difference = *value - **reference;
    return {signedText(difference, shown(difference, unit, 3)), difference};
}

std::vector<Cell> cellsOf(const CandidateRow &row, const CandidateRow *reference)
{
    const auto of
        = [&](std::optional<double> CandidateRow::*member, const QString &unit, int digits) {
              return cell(row.*member, reference ? &(reference->*member) : nullptr, unit, digits);
          };
    const auto count = [](int value) { return Cell{QString::number(value), double(value)}; };
    Cell fit = of(&CandidateRow::fit_percent, "%", 4);
    if (row.diverges)
        fit = {QObject::tr("diverges"), {}};
    const auto result
        = [&](std::optional<double> CandidateRow::*member, double u, const QString &unit) {
              Cell made = of(member, unit, 3);
              if (!reference && row.*member)
                  made.text = shownResult(*(row.*member), u, unit).value;
              return made;
          };
    return {count(static_cast<int>(row.order)), fit, of(&CandidateRow::attainable_percent, "%", 4),
        result(&CandidateRow::f0_Hz, row.u_f0_Hz, "Hz"),
        result(&CandidateRow::zeta, row.u_zeta, {}), count(row.unstable), count(row.nyquist),
        {probabilityShown(row.whiteness_p), row.whiteness_p}, of(&CandidateRow::bic, {}, 6)};
}

} // namespace

CandidateTable::CandidateTable(QWidget *parent)
    : ValueTable("candidateTable", tr("Comparison of the pinned orders"), parent)
{
    setSelectionBehavior(SelectRows);
    setColumnCount(10);
    setHorizontalHeaderLabels({tr("Order"), tr("FIT"), tr("Attainable"), tr("f₀"), tr("ζ"),
        tr("Unstable"), tr("Nyquist"), tr("White, p"), tr("BIC"), tr("Note")});
    setSortingEnabled(true);
    sortByColumn(0, Qt::AscendingOrder);
    connect(this, &QTableWidget::itemActivated, this, [this](const QTableWidgetItem *item) {
        emit chosen(static_cast<Index>(this->item(item->row(), 0)->text().toInt()));
    });
}

void CandidateTable::setRows(const std::vector<CandidateRow> &rows, const CandidateRow *reference)
{
    setSortingEnabled(false);
    setRowCount(static_cast<int>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const CandidateRow &row = rows[i];
        const bool isReference = reference && reference->order == row.order;
        const std::vector<Cell> cells = cellsOf(row, isReference ? nullptr : reference);
        const int at = static_cast<int>(i);
        for (std::size_t k = 0; k < cells.size(); ++k)
            setItem(at, static_cast<int>(k), new ValueItem(cells[k].text, cells[k].value));
        QString note = row.note;
        if (row.isAdopted)
            note = note.isEmpty() ? tr("adopted") : tr("adopted, ") + note;
        if (!row.remark.isEmpty())
            note += (note.isEmpty() ? QString() : QStringLiteral("; ")) + shownText(row.remark);
        setItem(at, columnCount() - 1, new QTableWidgetItem(note));
    }
    setSortingEnabled(true);
}

} // namespace dyncal
