// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/pipeline_request.h"

#include <QThread>

#include <atomic>

/// A pipeline whose runs wait until a gate is opened or they are stopped, and count.
struct GatedRuns
{
    struct Gate
    {
        std::atomic<bool> open = false;
        std::atomic<bool> fails = false;
        std::atomic<int> begun = 0;
        std::atomic<int> stopped = 0;
    };
    std::shared_ptr<Gate> gate = std::make_shared<Gate>();

    /// Its keys say which stages the run has.
    dyncal::PipelineOutcome operator()(const std::shared_ptr<const dyncal::CaptureSet> &,
        const dyncal::Recipe &recipe, dyncal::ResultCache &, dyncal::StageId last,
        const dyncal::JobControl &control) const
    {
        ++gate->begun;
        while (!gate->open && !control.stopRequested())
            QThread::msleep(1);
        dyncal::PipelineOutcome outcome;
        if (control.stopRequested()) {
            ++gate->stopped;
            outcome.error = dyncal::Error{dyncal::ErrorKind::Cancelled, {}, {}, 0};
            return outcome;
        }
        if (gate->fails) {
            outcome.error = dyncal::Error{dyncal::ErrorKind::DataBlocked, {"No.", {}}, {}, 0};
            return outcome;
        }
        auto model = std::make_shared<dyncal::SensorModel>();
        model->order = recipe.realization.order.value.value_or(0);
        outcome.results.model = model;
        for (int stage = 0; stage <= static_cast<int>(last); ++stage)
            outcome.results.keys[static_cast<std::size_t>(stage)] = std::to_string(stage);
        return outcome;
    }

    /// Of an order; nothing is asked of the first singular values.
    dyncal::PipelineRequest request(dyncal::Index order = 2) const
    {
        dyncal::Recipe recipe;
        recipe.realization.order = order;
        return {*this, std::make_shared<dyncal::ResultCache>(),
            std::make_shared<const dyncal::CaptureSet>(), recipe, {}, true, false};
    }
};
