// Writes the example parts and those of the gallery: knead_make_examples RESOURCES

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
        std::cerr << "usage: knead_make_examples RESOURCES\n";
        return 2;
    }
    try {
        Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
        const std::string examples = std::string(argv[1]) + "/examples";
        const std::string gallery = std::string(argv[1]) + "/gallery";
        writeExample(examples, "bar", makeBar());
        writeExample(examples, "bracket", makeBracket());
        writeExample(examples + "/cantilever", "cantilever", makeCantilever());
        writeExample(examples, "grip", makeGrip());
        writeExample(examples, "handle", makeHandle());
        writeExample(examples, "lump", makeLump());
        writeExample(examples, "paper-bar", makePaperBar());
        writeExample(examples, "plate", makePlate());
        writeExample(examples, "tube", makeTube());
        writeExample(examples + "/warped-bracket", "bracket", makePrintedBracket());
        writeExample(gallery, "bowl", makeBowl());
        writeExample(gallery, "cake", makeCake());
        writeExample(gallery, "cushion", makeCushion());
        writeExample(gallery, "jug", makeJug());
        writeExample(gallery, "rod", makeRod());
        writeExample(gallery, "stamp", makeStamp());
        writeExample(gallery, "vase", makeVase());
        return 0;
    } catch (const Standard_Failure& failure) {
        std::cerr << "knead_make_examples: " << failure.GetMessageString() << '\n';
    } catch (const std::exception& error) {
        std::cerr << "knead_make_examples: " << error.what() << '\n';
    }
    return 1;
}
