#include "corpus/shapes.h"

#include "support/hard_shapes.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Writer.hxx>

#include <stdexcept>

namespace knead::corpus {

int writeShapes(const std::string& folder)
{
    ::Message::DefaultMessenger()->RemovePrinters(
        Message_Printer::get_type_descriptor()); // what OpenCASCADE tells of each file
    int count = 0;
    for (const hard_shapes::HardShape& shape : hard_shapes::all()) {
        const std::string number = std::to_string(1000 + count++).substr(1);
        const std::string path = folder + "/g" + number + ".step";
        STEPControl_Writer writer;
        if (writer.Transfer(shape.make(), STEPControl_AsIs) != IFSelect_RetDone ||
            writer.Write(path.c_str()) != IFSelect_RetDone)
            throw std::runtime_error("\"" + shape.name + "\" cannot be written");
    }
    return count;
}

} // namespace knead::corpus
