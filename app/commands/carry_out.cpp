#include "app/commands/carry_out.h"

#include "app/complaint.h"
#include "app/exit_status.h"

#include <exception>

namespace knead {

int carryOut(const std::function<int(TerminalControl& control, int& failure)>& work)
{
    int failure = exit_status::wrongUse;
    TerminalControl control;
    try {
        return work(control, failure);
    } catch (const Cancelled&) {
        control.clear();
        return complain("interrupted; no file was left half-written.", exit_status::interrupted);
    } catch (const std::exception& error) {
        control.clear();
        return complain(error.what(), failure);
    }
}

} // namespace knead
