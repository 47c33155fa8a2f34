#pragma once

#include "core/task/task_control.h"

#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressScope.hxx>

namespace knead {

/// Hands OpenCASCADE's progress on, and the wish to stop back.
class OcctProgress final : public Message_ProgressIndicator {
public:
    OcctProgress(TaskControl& control, const char* stage)
        : m_control(control)
        , m_stage(stage)
    {
    }

    Standard_Boolean UserBreak() override { return m_control.isCancelled(); }
    void Show(const Message_ProgressScope&, const Standard_Boolean) override
    {
        m_control.report(GetPosition(), m_stage);
    }

private:
    TaskControl& m_control;
    const char* m_stage;
};

} // namespace knead
