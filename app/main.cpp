#include "app/cad_process.h"
#include "app/command_line.h"

int main(int argc, char** argv)
{
    return knead::isReadingProcess(argc, argv) ? knead::readForParent(argc, argv) : knead::runProgram(argc, argv);
}
