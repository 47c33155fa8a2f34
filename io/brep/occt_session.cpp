#include "io/brep/occt_session.h"

#include "core/message/message.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>

#include <new>

namespace knead {

namespace {

std::mutex& occtMutex()
{
    static std::mutex mutex;
    return mutex;
}

} // namespace

OcctSession::OcctSession()
    : m_lock(occtMutex())
{
    ::Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
}

void guardOcct(const std::string& path, const std::function<void()>& work)
{
    try {
        work();
    } catch (const Standard_OutOfMemory&) {
        failReading(
            path, Message("Import", "the file asks for more memory than there is; it is damaged or far too detailed."));
    } catch (const Standard_Failure& failure) {
        failReading(path, Message("Import", "the CAD reader gave up (%1); the file is damaged, export it again.")
                              .with(failure.DynamicType()->Name()));
    } catch (const std::bad_alloc&) {
        failReading(
            path, Message("Import", "the file asks for more memory than there is; it is damaged or far too detailed."));
    }
}

} // namespace knead
