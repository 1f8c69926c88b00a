<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en">
<context>
    <name>BatchWords</name>
    <message numerus="yes">
        <source>%n sensor(s)</source>
        <translation>
            <numerusform>%n sensor</numerusform>
            <numerusform>%n sensors</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FindingGroup</name>
    <message numerus="yes">
        <source>%n time(s)</source>
        <translation>
            <numerusform>%n time</numerusform>
            <numerusform>%n times</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>NextSteps</name>
    <message numerus="yes">
        <source>reasons for %n caution(s)</source>
        <translation>
            <numerusform>reasons for %n caution</numerusform>
            <numerusform>reasons for %n cautions</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StatusText</name>
    <message numerus="yes">
        <source>%n field(s) are empty</source>
        <translation>
            <numerusform>%n field is empty</numerusform>
            <numerusform>%n fields are empty</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n date(s) are none</source>
        <translation>
            <numerusform>%n date is none</numerusform>
            <numerusform>%n dates are none</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n caution(s) without a reason</source>
        <translation>
            <numerusform>%n caution without a reason</numerusform>
            <numerusform>%n cautions without a reason</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dyncal::CaptureImport</name>
    <message numerus="yes">
        <source>%n shot(s) read</source>
        <translation>
            <numerusform>%n shot read</numerusform>
            <numerusform>%n shots read</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dyncal::CertificatePage</name>
    <message numerus="yes">
        <source>%n finding(s) that block</source>
        <translation>
            <numerusform>%n finding that blocks</numerusform>
            <numerusform>%n findings that block</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n caution(s).</source>
        <translation>
            <numerusform>%n caution.</numerusform>
            <numerusform>%n cautions.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>■ %n required field(s) to be filled in: %1.</source>
        <translation>
            <numerusform>■ %n required field to be filled in: %1.</numerusform>
            <numerusform>■ %n required fields to be filled in: %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dyncal::FindingsPanel</name>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n note</numerusform>
            <numerusform>%n notes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dyncal::ImportDialog</name>
    <message numerus="yes">
        <source>Import %n file(s)</source>
        <translation>
            <numerusform>Import %n file</numerusform>
            <numerusform>Import %n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dyncal::NextBar</name>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n more</numerusform>
            <numerusform>%n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dyncal::PlotExportActions</name>
    <message numerus="yes">
        <source>Stopped, because the settings changed: %n plot(s) written to %1</source>
        <translation>
            <numerusform>Stopped, because the settings changed: %n plot written to %1</numerusform>
            <numerusform>Stopped, because the settings changed: %n plots written to %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n plot(s) written to %1</source>
        <translation>
            <numerusform>%n plot written to %1</numerusform>
            <numerusform>%n plots written to %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dyncal::ProblemPanel</name>
    <message numerus="yes">
        <source>%n file(s) could not be read. All others are open.</source>
        <translation>
            <numerusform>%n file could not be read. All others are open.</numerusform>
            <numerusform>%n files could not be read. All others are open.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dyncal::SourceNotice</name>
    <message numerus="yes">
        <source>%n more file(s) likewise.</source>
        <translation>
            <numerusform>%n more file likewise.</numerusform>
            <numerusform>%n more files likewise.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dyncal::VerifyTab</name>
    <message numerus="yes">
        <source>■ %n changed, missing or unreadable</source>
        <translation>
            <numerusform>■ %n changed, missing or unreadable</numerusform>
            <numerusform>■ %n changed, missing or unreadable</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>▲ %n unchanged, but not signed, or by a signer that is not known or expired</source>
        <translation>
            <numerusform>▲ %n unchanged, but not signed, or by a signer that is not known or expired</numerusform>
            <numerusform>▲ %n unchanged, but not signed, or by a signer that is not known or expired</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>● %n valid</source>
        <translation>
            <numerusform>● %n valid</numerusform>
            <numerusform>● %n valid</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dyncal::WorkRecovery</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 and %n more</numerusform>
            <numerusform>%1 and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more after this one.</source>
        <translation>
            <numerusform>%n more after this one.</numerusform>
            <numerusform>%n more after this one.</numerusform>
        </translation>
    </message>
</context>
</TS>
