#include "io/brep/occt_session.h"

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
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
}

void guardOcct(const std::string& path, const std::function<void()>& work)
{
    try {
        work();
    } catch (const Standard_OutOfMemory&) {
        failReading(path, "the file asks for more memory than there is; it is damaged or far too detailed.");
    } catch (const Standard_Failure& failure) {
        failReading(path, "the CAD reader gave up (" + std::string(failure.DynamicType()->Name()) +
                              "); the file is damaged, export it again.");
    } catch (const std::bad_alloc&) {
        failReading(path, "the file asks for more memory than there is; it is damaged or far too detailed.");
    }
}

} // namespace knead
