<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>ImportFeature</name>
    <message numerus="yes">
        <source>Opening %1 and %n more</source>
        <translation>
            <numerusform>Opening %1 and %n more</numerusform>
            <numerusform>Opening %1 and %n more</numerusform>
        </translation>
    </message>
</context>
</TS>
