// Balance without inertia: found on the simulation's thread, while a task shows how far it is and can be cancelled.
#include "ui/document/document.h"

#include "ui/language/said.h"
#include "ui/tasks/task_runner.h"

#include <atomic>
#include <chrono>
#include <future>
#include <utility>

namespace knead {

/// What the simulation's thread tells and asks, so that others may see how far it is, and stop it.
class Document::Balancing final : public TaskControl {
public:
    void report(double fraction, std::string_view /*stage*/) override { m_fraction = fraction; }
    bool isCancelled() const override { return m_isCancelled; }

    void cancel() { m_isCancelled = true; }
    double fraction() const { return m_fraction; }

private:
    std::atomic<double> m_fraction = 0;
    std::atomic<bool> m_isCancelled = false;
};

namespace {

using Found = std::optional<StaticReport>; ///< none: it was cancelled, or the simulation is gone

constexpr std::chrono::milliseconds lookInterval{20};

} // namespace

void Document::findBalance()
{
    if (!m_simulation || m_tasks == nullptr || later([this] { findBalance(); }))
        return;
    if (m_tasks->isRunning()) {
        emit notice(
            said(Message("Document", "%1 is still going on: wait for it, or cancel it with Esc, then find the balance.")
                     .with(m_tasks->title().toStdString())));
        return;
    }
    standStill();
    m_balancing = std::make_shared<Balancing>();
    auto promise = std::make_shared<std::promise<Found>>();
    auto found = std::make_shared<std::future<Found>>(promise->get_future());
    m_simulation->settle(m_balancing,
                         [promise = std::move(promise)](Found report) { promise->set_value(std::move(report)); });
    noteEdit();
    m_gesture = {.isAny = true, .name = Message("Document", "Find balance")};
    finishGesture();
    const auto wait = [balancing = m_balancing, found](TaskControl& control) -> Found {
        while (found->wait_for(lookInterval) != std::future_status::ready) {
            control.report(balancing->fraction(), {});
            if (control.isCancelled())
                balancing->cancel();
        }
        control.throwIfCancelled();
        try {
            return found->get();
        } catch (const std::future_error&) { // the simulation is gone
            return {};
        }
    };
    m_tasks->run<Found>(tr("Finding the balance"), wait, [this](const Found& report) {
        if (report)
            tellBalance(*report);
    });
}

void Document::cancelBalancing()
{
    if (const auto balancing = std::exchange(m_balancing, nullptr))
        balancing->cancel();
}

void Document::tellBalance(const StaticReport& report)
{
    if (!report.converged)
        emit notBalanced(said(report.message));
    else if (report.residual == 0)
        emit balanced(tr("In balance: no force acts on the part."));
    else
        emit balanced(said(Message("Document", "In balance: the forces that are left are %1 of those that act.")
                               .with(numberMessage(report.residual, 'g', 2))));
}

} // namespace knead
