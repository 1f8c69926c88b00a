// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/order/order_page.h"

#include "core/base/constants.h"
#include "core/realization/hankel/hankel_gap.h"
#include "ui/plot/curves/model_curves.h"
#include "ui/plot/curves/order_curves.h"
#include "ui/plot/curves/realization_curves.h"
#include "ui/session/order_candidates.h"
#include "ui/stages/candidates/candidate_cards.h"
#include "ui/stages/candidates/candidate_rows.h"
#include "ui/stages/candidates/candidate_table.h"
#include "ui/stages/frame/folding_splitter.h"
#include "ui/stages/order/first_triplets_bar.h"
#include "ui/stages/order/order_inspector.h"

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
constexpr std::size_t kMostCandidates = 8;
constexpr int kTableHeight = 150;
constexpr double kBesideCut = 0.05; ///< of the orders shown, behind a cut at their end

QSplitter *column(std::initializer_list<QWidget *> widgets)
{
    auto *splitter = new QSplitter(Qt::Vertical);
    for (QWidget *widget : widgets)
        splitter->addWidget(widget);
    return splitter;
}

} // namespace

OrderPage::OrderPage(Session &session)
    : StagePage(session,
        {"orderPage", tr("Order"),
            tr("Drag the cut, click a value or use the arrow keys. Everything follows.")},
        Page::Order)
{
    setFocusPolicy(Qt::StrongFocus);
    buildPlots();
    connectPlots();
    m_controls = new OrderInspector(
        *inspector(),
        [this](const QString &label, const std::function<void(Recipe &)> &edit) {
            change(label, edit);
        },
        this);
    connect(m_controls, &OrderInspector::orderChosen, this,
        [this](double order) { setOrder(order, {}); });
    connect(m_controls, &OrderInspector::adopted, this, &OrderPage::adopt);
    connect(&this->session().candidates(), &OrderCandidates::changed, this, [this] {
        if (isVisible())
            showModel();
    });
}

void OrderPage::buildPlots()
{
    m_values = makePlot("singularValuePlot", tr("Singular values"));
    m_strip = makePlot(
        "stabilisationPlot", tr("Stabilisation of poles over the order"), StageId::Evidence);
    m_evidence = makePlot("orderEvidencePlot", tr("FIT and criteria over the order"));
    m_fit = makePlot("orderFitPlot", tr("Data and model"), StageId::Model);
    m_bode = makePlot("orderBodePlot", tr("Frequency response of the model"), StageId::Response);
    m_poles = makePlot("orderPolePlot", tr("Poles and zeros"), StageId::Model);
    auto *split = new FoldingSplitter(this);
    split->addWidget(column({m_values, m_evidence, m_poles}));
    split->addWidget(column({m_strip, m_fit, m_bode}));
    split->setSizes({1000, 1250});
    content()->addWidget(new FirstTripletsBar(session(), this));
    content()->addWidget(split, 1);
    content()->addWidget(buildCandidates());
    shareCursors(CursorAxis::Frequency, {m_strip, m_bode});
    shareCursors(CursorAxis::ResponseTime, {m_fit});
}

QWidget *OrderPage::buildCandidates()
{
    auto *area = new QWidget(this);
    m_cards = new CandidateCards(area);
    m_table = new CandidateTable(area);
    m_table->setFixedHeight(kTableHeight);
    m_table->hide();
    const auto button = [area](const QString &name, const QString &text, const QString &hint) {
        auto *made = new QPushButton(text, area);
        made->setObjectName(name);
        made->setToolTip(hint);
        return made;
    };
    m_pin = button("pinOrder", tr("Pin"), tr("Pin or unpin the order on show (Space)"));
    m_defaults = button("pinDefaults", tr("Propose"),
        tr("Pin the suggested order, the one that keeps its pairs, and a high one"));
    m_compare = button("compareOrders", tr("Table"), tr("Compare the pinned orders in a table"));
    m_compare->setCheckable(true);
    m_difference = new QCheckBox(tr("Difference to adopted"), area);
    m_difference->setObjectName("differenceToAdopted");
    m_difference->hide();
    auto *buttons = new QVBoxLayout;
    for (QWidget *control : std::initializer_list<QWidget *>{m_pin, m_defaults, m_compare})
        buttons->addWidget(control);
    buttons->addStretch(1);
    auto *row = new QHBoxLayout;
    row->addLayout(buttons);
    row->addWidget(m_cards, 1);
    auto *layout = new QVBoxLayout(area);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(row);
    layout->addWidget(m_difference);
    layout->addWidget(m_table);
    connect(m_pin, &QPushButton::clicked, this, [this] { togglePin(shownOrder()); });
    connect(m_defaults, &QPushButton::clicked, this, &OrderPage::pinDefaults);
    connect(m_compare, &QPushButton::toggled, m_table, &QWidget::setVisible);
    connect(m_compare, &QPushButton::toggled, m_difference, &QWidget::setVisible);
    connect(m_compare, &QPushButton::toggled, m_cards, &QWidget::setHidden);
    connect(m_compare, &QPushButton::toggled, this, &OrderPage::showCandidates);
    connect(m_difference, &QCheckBox::toggled, this, &OrderPage::showCandidates);
    connect(m_cards, &CandidateCards::unpinned, this, &OrderPage::togglePin);
    connect(m_cards, &CandidateCards::remarked, this, &OrderPage::setRemark);
    connect(m_cards, &CandidateCards::chosen, this,
        [this](Index order) { setOrder(static_cast<double>(order), {}); });
    connect(m_table, &CandidateTable::chosen, this,
        [this](Index order) { setOrder(static_cast<double>(order), {}); });
    connect(m_cards, &CandidateCards::overlayToggled, &session().candidates(),
        &OrderCandidates::setDrawn);
    return area;
}

void OrderPage::connectPlots()
{
    connect(m_values, &PlotWidget::lineMoved, this,
        [this](const QString &, double order, bool finished) {
            setOrder(order, kDragKey);
            if (finished)
                session().endMerge();
        });
    for (PlotWidget *plot : {m_values, m_strip, m_evidence, m_fit, m_bode, m_poles})
        plot->installEventFilter(this);
    for (PlotWidget *plot : {m_values, m_evidence})
        connect(plot, &PlotWidget::pointPicked, this,
            [this](double order, double) { setOrder(order, {}); });
    connect(m_strip, &PlotWidget::pointPicked, this,
        [this](double, double order) { setOrder(order, {}); });
}

Index OrderPage::shownOrder() const
{
    return chosenOrder(session());
}

Index OrderPage::modelOrder() const
{
    return results().model ? results().model->order : 0;
}

Index OrderPage::largestOrder() const
{
    if (!results().decomposition)
        return 1;
    const HankelDecomposition &hankel = results().decomposition->hankel;
    return session().showsFirstTriplets() ? wholeSetSize(hankel, recipe().realization)
                                          : hankel.singularValues.size();
}

void OrderPage::setOrder(double order, const QString &mergeKey)
{
    const Index chosen
        = std::clamp<Index>(std::lround(order), 1, std::max<Index>(largestOrder(), 1));
    change(
        tr("Order %1").arg(chosen),
        [&](Recipe &r) {
            if (r.realization.order.value != chosen)
                r.realization.adoptedReason.clear(); // the reason was for another order
            r.realization.order = chosen;
        },
        mergeKey);
}

void OrderPage::adopt(const QString &reason)
{
    change(tr("Adopt order %1").arg(modelOrder()), [&](Recipe &r) {
        r.realization.order = modelOrder();
        r.realization.adoptedReason = reason.toStdString();
    });
}

void OrderPage::togglePin(Index order)
{
    std::vector<Index> orders = recipe().realization.candidates;
    if (std::erase(orders, order) > 0) {
        setCandidates(orders, tr("Unpin order %1").arg(order));
    } else if (orders.size() < kMostCandidates) {
        orders.push_back(order);
        setCandidates(orders, tr("Pin order %1").arg(order));
    }
}

void OrderPage::setRemark(Index order, const QString &remark)
{
    change(tr("Note on order %1").arg(order), [&](Recipe &r) {
        std::vector<OrderNote> &notes = r.realization.candidateNotes;
        std::erase_if(notes, [order](const OrderNote &note) { return note.order == order; });
        if (!remark.isEmpty())
            notes.push_back({order, remark.toStdString()});
        std::ranges::sort(notes, {}, &OrderNote::order);
    });
}

void OrderPage::pinDefaults()
{
    if (!results().decomposition)
        return;
    std::vector<Index> orders = defaultCandidates(results(), recipe());
    if (orders.size() > kMostCandidates)
        orders.resize(kMostCandidates);
    setCandidates(orders, tr("Pin the proposed orders"));
}

void OrderPage::setCandidates(std::vector<Index> orders, const QString &label)
{
    std::ranges::sort(orders);
    change(label, [&](Recipe &r) {
        r.realization.candidates = orders;
        std::erase_if(r.realization.candidateNotes, [&](const OrderNote &note) {
            return std::ranges::find(orders, note.order) == orders.end();
        });
    });
}

/// Goes from the order on show to the next one that cuts no oscillating pair in two.
void OrderPage::stepToWholePairs(Index by)
{
    if (!results().decomposition)
        return;
    const HankelDecomposition &hankel = results().decomposition->hankel;
    Index order = shownOrder() + by;
    while (order >= 1 && order < largestOrder() && splitsPair(hankel, order))
        order += by;
    setOrder(static_cast<double>(order), kKeysKey);
}

bool OrderPage::takeKey(const QKeyEvent &event)
{
    const Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeypadModifier;
    if (modifiers == Qt::ShiftModifier
        && (event.key() == Qt::Key_Left || event.key() == Qt::Key_Right)) {
        stepToWholePairs(event.key() == Qt::Key_Left ? -1 : 1);
        return true;
    }
    if (modifiers)
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
        m_controls->useSuggestion();
        return true;
    case Qt::Key_End:
        setOrder(static_cast<double>(largestOrder()), {});
        return true;
    case Qt::Key_O:
        m_controls->typeOrder();
        return true;
    case Qt::Key_Space:
        togglePin(shownOrder());
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        m_controls->adopt();
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
    if (const auto adopted = adoptedOrder(session()))
        m_adopted = adopted;
    m_controls->showRecipe(recipe(), results(), shownOrder());
    if (!m_values->isHandleDragged() && results().decomposition) {
        m_values->setLine(kCut, tr("order"), static_cast<double>(shownOrder()), true);
        showCut();
    }
    RealizationSettings settings = recipe().realization;
    settings.order = {}; // what depends on it comes with the results
    if (settings == m_shownSettings)
        return;
    m_shownSettings = settings;
    showModel(); // pins, adoption
}

/// An order that is chosen beyond the first view: its cut must be seen, and be dragged on. A view
/// that the operator chose stays.
void OrderPage::showCut()
{
    const Interval shown = m_values->xRange();
    const double cut = static_cast<double>(shownOrder()) + 0.5;
    const bool isFirstView = shown.end == m_values->content().xMax || shown.end == m_endForCut;
    if (cut <= shown.end || !isFirstView)
        return;
    m_endForCut = cut + kBesideCut * cut;
    m_values->setXRange({shown.begin, *m_endForCut});
}

void OrderPage::showResults()
{
    showEvidence();
    showModel();
}

void OrderPage::showEvidence()
{
    const auto &decomposition = results().decomposition;
    const auto &input = results().input;
    const auto &evidence = results().evidence;
    PlotContent values = decomposition && input
        ? singularValueCurves(decomposition->hankel, decomposition->suggestion, input->treatment)
        : nothingYet();
    if (decomposition && session().showsFirstTriplets())
        values.title = tr("Singular values: the first %1 of %2")
                           .arg(decomposition->hankel.singularValues.size())
                           .arg(largestOrder());
    m_values->setContent(values);
    if (!decomposition)
        m_values->removeLine(kCut);
    const bool known = evidence && results().spectrum && session().isShowable(StageId::Evidence);
    m_strip->setContent(
        known ? stabilisationCurves(*evidence, *results().spectrum, modelOrder()) : nothingYet());
    m_evidence->setContent(decomposition
            ? evidenceCurves(known ? evidence.get() : nullptr, decomposition->suggestion,
                results().model ? results().model->fitAttainable_percent : kUnknown, modelOrder())
            : nothingYet());
}

void OrderPage::showModel()
{
    const auto &model = results().model;
    const auto &input = results().input;
    const auto &window = results().window;
    const auto response = session().responseOnShow();
    const std::vector<OverlaidModel> candidates = overlaidModels(session());
    PlotContent fit = nothingYet();
    if (model && input && window) {
        fit = simulationCurves(*input, *model, *window);
        overlaySimulations(fit, *input, candidates);
    }
    m_fit->setContent(fit);
    PlotContent bode = response ? bodeMagnitudeCurves(*response) : nothingYet();
    if (response)
        overlayMagnitudes(bode, candidates);
    m_bode->setContent(bode);
    PlotContent poles = model ? poleZeroCurves(*model) : nothingYet();
    if (model)
        overlayPoles(poles, candidates);
    m_poles->setContent(poles);
    const bool isCurrent
        = model && model->order == shownOrder() && session().isOfThisRun(StageId::Model);
    CalibrationResults shown = results();
    if (!session().isShowable(StageId::Evidence))
        shown.evidence = nullptr;
    m_controls->showResults(shown, isCurrent, isCurrent && adoptedOrder(session()) == modelOrder());
    showCandidates();
}

void OrderPage::showCandidates()
{
    const std::vector<CandidateRow> rows = candidateRows(session());
    m_cards->setRows(rows);
    const bool isPinned = std::ranges::find(recipe().realization.candidates, shownOrder())
        != recipe().realization.candidates.end();
    m_pin->setText(isPinned ? tr("Unpin") : tr("Pin"));
    m_pin->setEnabled(isPinned || rows.size() < kMostCandidates);
    // A high order is among those proposed: it may be beyond the first singular values.
    m_defaults->setEnabled(results().decomposition && !session().showsFirstTriplets());
    m_compare->setEnabled(!rows.empty() || m_compare->isChecked());
    std::optional<CandidateRow> reference;
    m_difference->setEnabled(m_adopted.has_value());
    if (m_adopted && m_difference->isChecked())
        reference = candidateRow(*m_adopted, session().candidates().find(*m_adopted), results());
    if (m_compare->isChecked())
        m_table->setRows(rows, reference && reference->isKnown ? &*reference : nullptr);
}

} // namespace dyncal
