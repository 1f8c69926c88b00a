// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/replace_state.h"

#include "ui/text/shown_text.h"

namespace dyncal {

ReplaceState::ReplaceState(Show show, ProjectState before, ProjectState after, const QString &label,
    QString mergeKey, int epoch)
    : QUndoCommand(withoutMnemonic(label)) // it becomes a part of the menu's text
    , m_show(std::move(show))
    , m_before(std::move(before))
    , m_after(std::move(after))
    , m_mergeKey(std::move(mergeKey))
    , m_epoch(epoch)
{
}

bool ReplaceState::mergeWith(const QUndoCommand *other)
{
    const auto *next = static_cast<const ReplaceState *>(other);
    if (m_mergeKey.isEmpty() || next->m_mergeKey != m_mergeKey || next->m_epoch != m_epoch)
        return false;
    m_after = next->m_after;
    setText(next->text());
    setObsolete(m_after == m_before);
    return true;
}

} // namespace dyncal
