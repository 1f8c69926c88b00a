// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/project_state.h"

#include <QUndoCommand>

#include <functional>

namespace dyncal {

/// The only undo command: the whole state before and after (cheap, recordings are shared).
class ReplaceState : public QUndoCommand
{
public:
    using Show = std::function<void(const ProjectState &)>;

    /// Neighbours with the same non-empty `mergeKey` in the same `epoch` become one step.
    ReplaceState(Show show, ProjectState before, ProjectState after, const QString &label,
        QString mergeKey, int epoch);

    void undo() override { m_show(m_before); }
    void redo() override { m_show(m_after); }
    int id() const override { return 1; }
    bool mergeWith(const QUndoCommand *other) override;

private:
    Show m_show;
    ProjectState m_before;
    ProjectState m_after;
    QString m_mergeKey;
    int m_epoch;
};

} // namespace dyncal
