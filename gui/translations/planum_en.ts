<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>planum::gui::Inquiry</name>
    <message numerus="yes">
        <source>%n patch(es) outside all outlines left out</source>
        <translation>
            <numerusform>%n patch outside all outlines left out</numerusform>
            <numerusform>%n patches outside all outlines left out</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) removed, %1 MB</source>
        <translation>
            <numerusform>%n file removed, %1 MB</numerusform>
            <numerusform>%n files removed, %1 MB</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>planum::gui::PatchModel</name>
    <message numerus="yes">
        <source>%n patch(es) changed and have no outline: click into one.</source>
        <translation>
            <numerusform>%n patch changed and has no outline: click into it.</numerusform>
            <numerusform>%n patches changed and have no outline: click into one.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>planum::gui::ProblemListModel</name>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n warning</numerusform>
            <numerusform>%n warnings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n remark(s)</source>
        <translation>
            <numerusform>%n remark</numerusform>
            <numerusform>%n remarks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>planum::gui::ProblemPanel</name>
    <message numerus="yes">
        <source>; %n change(s) since</source>
        <translation>
            <numerusform>; %n change since</numerusform>
            <numerusform>; %n changes since</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>planum::gui::SpaceView</name>
    <message numerus="yes">
        <source>%n frame(s) written</source>
        <translation>
            <numerusform>%n frame written</numerusform>
            <numerusform>%n frames written</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>planum::gui::SuggestionListModel</name>
    <message numerus="yes">
        <source>%n relation(s) proposed</source>
        <translation>
            <numerusform>%n relation proposed</numerusform>
            <numerusform>%n relations proposed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n question(s)</source>
        <translation>
            <numerusform>%n question</numerusform>
            <numerusform>%n questions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 and %n more</numerusform>
            <numerusform>%1 and %n more</numerusform>
        </translation>
    </message>
</context>
</TS>
