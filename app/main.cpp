#include "app/cad_process.h"
#include "app/command_line.h"

int main(int argc, char** argv)
{
    return knead::isCadProcess(argc, argv) ? knead::workForParent(argc, argv) : knead::runProgram(argc, argv);
}
