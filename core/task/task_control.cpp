#include "core/task/task_control.h"

namespace knead {

namespace {

class NoControl final : public TaskControl {
public:
    void report(double, std::string_view) override {}
    bool isCancelled() const override { return false; }
};

} // namespace

void TaskControl::throwIfCancelled() const
{
    if (isCancelled())
        throw Cancelled();
}

TaskControl& TaskControl::none()
{
    static NoControl control;
    return control;
}

} // namespace knead
