// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/order_page.h"

#include "ui/plot/model_curves.h"
#include "ui/plot/realization_curves.h"
#include "ui/stages/model_text.h"
#include "ui/stages/quantity_edit.h"
#include "ui/stages/value_table.h"
#include "ui/text/core_text.h"
#include "ui/text/quantity_format.h"

#include <QCheckBox>
#include <QKeyEvent>
#include <QPushButton>
#include <QSplitter>

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

const QString kCut = QStringLiteral("order");
const QString kDragKey = QStringLiteral("order-drag");
const QString kKeysKey = QStringLiteral("order-keys");
constexpr Index kLargeStep = 10;

} // namespace

OrderPage::OrderPage(Session &session)
    : StagePage(session,
        {"orderPage", tr("Order"),
            tr("Drag the cut, click a value or use the arrow keys. Everything follows.")},
        {StageId::Decomposition, StageId::Model})
{
    setFocusPolicy(Qt::StrongFocus);
    buildPlots();
    buildInspector();
}

void OrderPage::buildPlots()
{
    m_values = makePlot("singularValuePlot", tr("Singular values"));
    m_bic = makePlot("bicPlot", tr("Information criterion over the order"));
    m_fit = makePlot("orderFitPlot", tr("Data and model"));
    m_bode = makePlot("orderBodePlot", tr("Frequency response of the model"));
    m_poles = makePlot("orderPolePlot", tr("Poles and zeros"));
    m_table = new ValueTable("orderPoleTable", tr("Poles"), this);

    auto *left = new QSplitter(Qt::Vertical);
    left->addWidget(m_values);
    left->addWidget(m_bic);
    left->setStretchFactor(0, 5);
    left->setStretchFactor(1, 2);
    auto *lower = new QSplitter(Qt::Horizontal);
    lower->addWidget(m_poles);
    lower->addWidget(m_table);
    auto *right = new QSplitter(Qt::Vertical);
    right->addWidget(m_fit);
    right->addWidget(m_bode);
    right->addWidget(lower);
    auto *split = new QSplitter(Qt::Horizontal, this);
    split->addWidget(left);
    split->addWidget(right);
    split->setSizes({880, 1120});
    lower->setSizes({840, 1160});
    content()->addWidget(split);

    connect(m_values, &PlotWidget::lineMoved, this,
        [this](const QString &, double order, bool finished) {
            m_dragging = !finished;
            setOrder(order, kDragKey);
            if (finished)
                session().endMerge();
        });
    for (PlotWidget *plot : {m_values, m_bic, m_fit, m_bode, m_poles})
        plot->installEventFilter(this);
    for (PlotWidget *plot : {m_values, m_bic})
        connect(plot, &PlotWidget::pointPicked, this,
            [this](double order, double) { setOrder(order, {}); });
}

void OrderPage::buildInspector()
{
    InspectorForm *form = inspector();
    form->addSection(tr("Order"));
    m_order = form->add(tr("Order"), "order", new AutoEdit({}, 1, 1000, 0));
    connect(m_order, &AutoEdit::edited, this, [this](const Auto<double> &order) {
        if (order.value)
            setOrder(*order.value, {});
        else
            change(tr("Order: automatic"), [](Recipe &r) { r.realization.order = {}; });
    });
    m_suggestion = form->addNote("orderSuggestion");
    m_useSuggestion = new QPushButton(tr("Use suggestion"));
    m_useSuggestion->setObjectName("useSuggestion");
    form->addWide(m_useSuggestion);
    connect(m_useSuggestion, &QPushButton::clicked, this, [this] {
        if (results().decomposition)
            setOrder(static_cast<double>(results().decomposition->suggestion.order), {});
    });

    form->addSection(tr("This order"));
    m_score = form->addReadout(tr("FIT"), "fitReadout");
    m_gap = form->addReadout(tr("Gap"), "gapReadout");
    m_resonance = form->addReadout(tr("Resonance"), "resonanceReadout");
    m_outside = form->addReadout(tr("Poles"), "polesReadout");

    form->addSection(tr("Decomposition"));
    m_largest = form->add(tr("Orders offered"), "maxOrder", new QuantityEdit({}, 1, 1000, 0));
    connect(m_largest, &QuantityEdit::edited, this, [this](double orders) {
        change(tr("Change the orders offered"),
            [&](Recipe &r) { r.realization.maxOrder = std::lround(orders); });
    });
    m_rows = form->add(tr("Hankel rows"), "hankelRows", new AutoEdit({}, 2, 100000, 0));
    connect(m_rows, &AutoEdit::edited, this, [this](const Auto<double> &rows) {
        change(tr("Change the Hankel rows"), [&](Recipe &r) {
            r.realization.rows = rows.value ? Auto<Index>(std::lround(*rows.value)) : Auto<Index>();
        });
    });
    m_refine = new QCheckBox(tr("Refine the poles (least squares)"));
    m_refine->setObjectName("refinePoles");
    form->addWide(m_refine);
    connect(m_refine, &QCheckBox::clicked, this, [this](bool on) {
        change(tr("Refine the poles"), [&](Recipe &r) { r.realization.refine = on; });
    });
}

Index OrderPage::shownOrder() const
{
    if (recipe().realization.order.value)
        return *recipe().realization.order.value;
    if (results().model)
        return results().model->order;
    return results().decomposition ? results().decomposition->suggestion.order : 1;
}

Index OrderPage::largestOrder() const
{
    return results().decomposition ? results().decomposition->hankel.singularValues.size() : 1;
}

void OrderPage::setOrder(double order, const QString &mergeKey)
{
    const Index chosen
        = std::clamp<Index>(std::lround(order), 1, std::max<Index>(largestOrder(), 1));
    change(
        tr("Order %1").arg(chosen), [&](Recipe &r) { r.realization.order = chosen; }, mergeKey);
}

bool OrderPage::takeKey(const QKeyEvent &event)
{
    if (event.modifiers() & ~Qt::KeypadModifier)
        return false;
    const auto step = [this](Index by) {
        setOrder(static_cast<double>(shownOrder() + by), kKeysKey);
        return true;
    };
    switch (event.key()) {
    case Qt::Key_Left:
        return step(-1);
    case Qt::Key_Right:
        return step(1);
    case Qt::Key_PageDown:
        return step(-kLargeStep);
    case Qt::Key_PageUp:
        return step(kLargeStep);
    case Qt::Key_Home:
        m_useSuggestion->click();
        return true;
    default:
        return false;
    }
}

void OrderPage::keyPressEvent(QKeyEvent *event)
{
    if (!takeKey(*event))
        StagePage::keyPressEvent(event);
}

bool OrderPage::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyPress && takeKey(*static_cast<QKeyEvent *>(event)))
        return true;
    return StagePage::eventFilter(watched, event);
}

void OrderPage::showRecipe()
{
    const RealizationSettings &settings = recipe().realization;
    const auto asDouble = [](const Auto<Index> &setting) {
        return setting.value ? Auto<double>(static_cast<double>(*setting.value)) : Auto<double>();
    };
    m_order->set(asDouble(settings.order), static_cast<double>(shownOrder()));
    m_largest->setSi(static_cast<double>(settings.maxOrder));
    std::optional<double> rows;
    if (results().decomposition)
        rows = static_cast<double>(results().decomposition->hankel.rows);
    m_rows->set(asDouble(settings.rows), rows);
    m_refine->setChecked(settings.refine);
    if (!m_dragging && results().decomposition)
        m_values->setLine(kCut, tr("order"), static_cast<double>(shownOrder()), true);
}

/// Of the model on show: the whole response once there is one, until then the model's own curve.
std::shared_ptr<const ResponseResult> OrderPage::shownResponse() const
{
    const CalibrationResults &r = results();
    if (session().isOfThisRun(StageId::Response) || !r.response)
        return r.response;
    if (!r.model || !r.input || !r.window || !r.shock || !session().isOfThisRun(StageId::Shock))
        return nullptr;
    return std::make_shared<const ResponseResult>(
        computeModelResponse(r.window->responses, *r.input, *r.model, *r.shock, recipe().response,
            r.response->fLow_Hz, r.response->fHigh_Hz));
}

void OrderPage::showResults()
{
    const auto &decomposition = results().decomposition;
    const auto &input = results().input;
    m_values->setContent(decomposition && input ? singularValueCurves(
                             decomposition->hankel, decomposition->suggestion, input->treatment)
                                                : nothingYet());
    m_bic->setContent(decomposition ? bicCurves(decomposition->suggestion) : nothingYet());
    m_bic->setVisible(decomposition && decomposition->suggestion.bic.size() > 0);
    if (!decomposition)
        m_values->removeLine(kCut);
    const auto &model = results().model;
    const auto &window = results().window;
    const auto response = shownResponse();
    m_fit->setContent(
        model && input && window ? simulationCurves(*input, *model, *window) : nothingYet());
    m_bode->setContent(response ? bodeMagnitudeCurves(*response) : nothingYet());
    m_poles->setContent(model ? poleZeroCurves(*model) : nothingYet());
    m_table->setValues(poleHeaders(PoleColumns::Few), poleRows(model.get(), PoleColumns::Few));
    showReadouts();
}

void OrderPage::showReadouts()
{
    const auto &decomposition = results().decomposition;
    m_useSuggestion->setEnabled(decomposition && decomposition->suggestion.order > 0);
    m_suggestion->setText(decomposition ? tr("Suggested: order %1. %2")
                                              .arg(decomposition->suggestion.order)
                                              .arg(translated(decomposition->suggestion.reason))
                                        : tr("No suggestion yet."));
    const auto &model = results().model;
    m_score->setText(model ? fitText(*model) : "–");
    const Pole *pole = model ? mainPole(*model) : nullptr;
    m_resonance->setText(pole ? tr("%1, damping %2")
                                    .arg(shownQuantity(pole->frequency_Hz, "Hz", 5),
                                        shownNumber(pole->dampingRatio, 4))
                              : "–");
    const auto countOf = [&](PoleClass poleClass) {
        return model ? std::ranges::count(model->poles, poleClass, &Pole::poleClass) : 0;
    };
    m_outside->setText(tr("%1 unstable, %2 at Nyquist")
                           .arg(countOf(PoleClass::Unstable))
                           .arg(countOf(PoleClass::Nyquist)));
    const Index order = shownOrder();
    QString gap = "–";
    if (decomposition && order >= 1 && order < largestOrder()) {
        const auto &values = decomposition->hankel.singularValues;
        gap = tr("factor %1 to the next").arg(shownNumber(values[order - 1] / values[order], 3));
    }
    m_gap->setText(gap);
}

} // namespace dyncal
