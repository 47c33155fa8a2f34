#include "app/command_line.h"

int main(int argc, char** argv)
{
    return knead::runProgram(argc, argv);
}
