// Writes the example parts: knead_make_examples FOLDER

#include "example_parts.h"
#include "step_file.h"

#include <BRepCheck_Analyzer.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Standard_Failure.hxx>

#include <iostream>
#include <stdexcept>

namespace {

void writeExample(const std::string& folder, const std::string& name, const std::vector<ExampleBody>& bodies)
{
    for (const ExampleBody& body : bodies)
        if (!BRepCheck_Analyzer(body.shape).IsValid())
            throw std::runtime_error(name + ": " + body.name + " is not a valid solid.");
    writeStepFile(folder + "/" + name + ".step", name, bodies);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::cerr << "usage: knead_make_examples FOLDER\n";
        return 2;
    }
    try {
        Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
        writeExample(argv[1], "bar", makeBar());
        writeExample(argv[1], "bracket", makeBracket());
        writeExample(argv[1], "grip", makeGrip());
        writeExample(argv[1], "handle", makeHandle());
        writeExample(argv[1], "lump", makeLump());
        writeExample(argv[1], "paper-bar", makePaperBar());
        writeExample(argv[1], "plate", makePlate());
        return 0;
    } catch (const Standard_Failure& failure) {
        std::cerr << "knead_make_examples: " << failure.GetMessageString() << '\n';
    } catch (const std::exception& error) {
        std::cerr << "knead_make_examples: " << error.what() << '\n';
    }
    return 1;
}
