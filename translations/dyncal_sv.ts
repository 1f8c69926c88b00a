<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="sv">
<context>
    <name>BatchWords</name>
    <message>
        <source>%1, shot %2</source>
        <translation>%1, skott %2</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>misslyckad</translation>
    </message>
    <message>
        <source>blocked</source>
        <translation>blockerad</translation>
    </message>
    <message>
        <source>cautions</source>
        <translation>varningar</translation>
    </message>
    <message>
        <source>running</source>
        <translation>beräknas</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>saknas</translation>
    </message>
    <message>
        <source>done</source>
        <translation>klar</translation>
    </message>
    <message numerus="yes">
        <source>%n sensor(s)</source>
        <translation>
            <numerusform>%n givare</numerusform>
            <numerusform>%n givare</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (and %2 more)</source>
        <translation>%1 (och %2 till)</translation>
    </message>
    <message>
        <source> (k = %1)</source>
        <translation> (k = %1)</translation>
    </message>
</context>
<context>
    <name>BudgetSentences</name>
    <message>
        <source>%1, u ≤ %2</source>
        <translation>%1, u ≤ %2</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inte känt</translation>
    </message>
    <message>
        <source>%1 = %2; its uncertainty is not complete: %3.</source>
        <translation>%1 = %2; osäkerheten är inte fullständig: %3.</translation>
    </message>
    <message>
        <source>%1 = %2, U = %3 (k = %4)</source>
        <translation>%1 = %2, U = %3 (k = %4)</translation>
    </message>
    <message>
        <source>%1, %2 of it</source>
        <translation>%1, %2 av värdet</translation>
    </message>
    <message>
        <source>No relative U can be asked of this value.</source>
        <translation>För detta värde kan inget relativt U önskas.</translation>
    </message>
    <message>
        <source>U of %1 is reached.</source>
        <translation>U på %1 är uppnått.</translation>
    </message>
    <message>
        <source>For U of %1 no input alone is enough.</source>
        <translation>För U på %1 räcker ingen ingång ensam.</translation>
    </message>
    <message>
        <source>For U of %1 one of these is enough: %2.</source>
        <translation>För U på %1 räcker en av dessa: %2.</translation>
    </message>
    <message>
        <source>Known exactly, these together are: %1.</source>
        <translation>Exakt kända räcker dessa tillsammans: %1.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>U by the number of shots: %1; never below %2.</source>
        <translation>U efter antal skott: %1; aldrig under %2.</translation>
    </message>
    <message>
        <source>More shots do not make it smaller: U is %1, never below %2.</source>
        <translation>Fler skott gör den inte mindre: U är %1, aldrig under %2.</translation>
    </message>
    <message>
        <source>U of %1 is less than the laboratory&apos;s least uncertainty (CMC); no input changes that.</source>
        <translation>U på %1 är mindre än laboratoriets minsta osäkerhet (CMC); ingen storhet ändrar det.</translation>
    </message>
</context>
<context>
    <name>BudgetTable</name>
    <message>
        <source>%1 per %2</source>
        <translation>%1 per %2</translation>
    </message>
    <message>
        <source>not enough alone</source>
        <translation>räcker inte ensam</translation>
    </message>
    <message>
        <source>%1 (what if)</source>
        <translation>%1 (prövas)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Ingång</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Värde</translation>
    </message>
    <message>
        <source>u</source>
        <translation>u</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Andel</translation>
    </message>
    <message>
        <source>Contribution</source>
        <translation>Bidrag</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Fördelning</translation>
    </message>
    <message>
        <source>Degrees of
freedom</source>
        <translation>Frihets-
grader</translation>
    </message>
    <message>
        <source>Sensitivity
coefficient</source>
        <translation>Känslighets-
koefficient</translation>
    </message>
    <message>
        <source>u for the
wanted U</source>
        <translation>u för
önskat U</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Storhet</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>U, what if</source>
        <translation>U, prövat</translation>
    </message>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>Largest input</source>
        <translation>Största ingång</translation>
    </message>
    <message>
        <source>Shots</source>
        <translation>Skott</translation>
    </message>
    <message>
        <source>U, relative</source>
        <translation>U, relativt</translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation>Monte Carlo</translation>
    </message>
</context>
<context>
    <name>BudgetWords</name>
    <message>
        <source>Natural frequency f₀</source>
        <translation>Egenfrekvens f₀</translation>
    </message>
    <message>
        <source>Damping ratio ζ</source>
        <translation>Dämpningsförhållande ζ</translation>
    </message>
    <message>
        <source>Quality factor Q</source>
        <translation>Godhetstal Q</translation>
    </message>
    <message>
        <source>Frequency of the resonance</source>
        <translation>Resonansens frekvens</translation>
    </message>
    <message>
        <source>Height of the resonance</source>
        <translation>Resonansens höjd</translation>
    </message>
    <message>
        <source>Flat ±5 % to</source>
        <translation>Plan ±5 % till</translation>
    </message>
    <message>
        <source>Flat ±10 % to</source>
        <translation>Plan ±10 % till</translation>
    </message>
    <message>
        <source>−3 dB at</source>
        <translation>−3 dB vid</translation>
    </message>
    <message>
        <source>Rise time 10–90 %</source>
        <translation>Stigtid 10–90 %</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Översväng</translation>
    </message>
    <message>
        <source>Settling time ±5 %</source>
        <translation>Insvängningstid ±5 %</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Känslighet</translation>
    </message>
    <message>
        <source>Sensitivity, level %1</source>
        <translation>Känslighet, nivå %1</translation>
    </message>
    <message>
        <source>Magnitude of S(f)</source>
        <translation>Belopp av S(f)</translation>
    </message>
    <message>
        <source>Phase of S(f)</source>
        <translation>Fas av S(f)</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 vid %2</translation>
    </message>
    <message>
        <source>%1, shot %2</source>
        <translation>%1, skott %2</translation>
    </message>
</context>
<context>
    <name>CandidateText</name>
    <message>
        <source>suggested</source>
        <translation>föreslagen</translation>
    </message>
    <message>
        <source>splits a pair</source>
        <translation>delar ett par</translation>
    </message>
    <message>
        <source>diverges</source>
        <translation>divergerar</translation>
    </message>
    <message>
        <source>computing...</source>
        <translation>beräknas...</translation>
    </message>
    <message>
        <source>FIT %1 of %2 %</source>
        <translation>FIT %1 av %2 %</translation>
    </message>
    <message>
        <source>no resonance</source>
        <translation>ingen resonans</translation>
    </message>
    <message>
        <source>unstable %1, Nyquist %2, p %3</source>
        <translation>instabila %1, Nyquist %2, p %3</translation>
    </message>
    <message>
        <source>lowest order with FIT ≥ 98 % of attainable and no Nyquist pole</source>
        <translation>lägsta ordning med FIT ≥ 98 % av det uppnåeliga och utan pol vid Nyquist</translation>
    </message>
    <message>
        <source>FIT %1 % of attainable %2 %</source>
        <translation>FIT %1 % av uppnåeliga %2 %</translation>
    </message>
    <message>
        <source>order suggested by the information criterion; </source>
        <translation>ordning föreslagen av informationskriteriet; </translation>
    </message>
</context>
<context>
    <name>CapabilityWords</name>
    <message>
        <source>, from %1 to %2</source>
        <translation>, från %1 till %2</translation>
    </message>
    <message>
        <source>, from %1</source>
        <translation>, från %1</translation>
    </message>
    <message>
        <source>%1: U ≥ %2%3</source>
        <translation>%1: U ≥ %2%3</translation>
    </message>
</context>
<context>
    <name>CaptureText</name>
    <message>
        <source>Low</source>
        <translation>Låg</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Medel</translation>
    </message>
    <message>
        <source>High</source>
        <translation>Hög</translation>
    </message>
    <message>
        <source>DUT</source>
        <translation>DUT</translation>
    </message>
    <message>
        <source>Driven side</source>
        <translation>Lågtrycksdelens sida</translation>
    </message>
    <message>
        <source>Driver</source>
        <translation>Högtrycksdel</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigg</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Annan</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referens</translation>
    </message>
</context>
<context>
    <name>ChannelRoles</name>
    <message>
        <source>%1 is %2</source>
        <translation>%1 är %2</translation>
    </message>
    <message>
        <source>In shot %1: %2.</source>
        <translation>I skott %1: %2.</translation>
    </message>
</context>
<context>
    <name>CheckRows</name>
    <message>
        <source>all</source>
        <translation>alla</translation>
    </message>
    <message>
        <source>agree</source>
        <translation>stämmer överens</translation>
    </message>
    <message>
        <source>contradict each other</source>
        <translation>motsäger varandra</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Storhet</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Skott</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Plats</translation>
    </message>
    <message>
        <source>Two ways</source>
        <translation>Två vägar</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Första</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Andra</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Skillnad</translation>
    </message>
    <message>
        <source>in u</source>
        <translation>i u</translation>
    </message>
    <message>
        <source>Smallest fault seen</source>
        <translation>Minsta synliga fel</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Utfall</translation>
    </message>
    <message>
        <source>Comparisons made: %1; contradicting: %2; not possible: %3.</source>
        <translation>Gjorda jämförelser: %1; motsägande: %2; inte möjliga: %3.</translation>
    </message>
    <message>
        <source>not made</source>
        <translation>ej gjord</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>ComparisonWords</name>
    <message>
        <source>At none of %1 frequencies alone is Eₙ beyond ±1.</source>
        <translation>Vid ingen av %1 frekvenser är Eₙ för sig utanför ±1.</translation>
    </message>
    <message>
        <source>At %1 of %2 frequencies, between %3 and %4, Eₙ alone is beyond ±1.</source>
        <translation>Vid %1 av %2 frekvenser, mellan %3 och %4, är Eₙ för sig utanför ±1.</translation>
    </message>
    <message>
        <source>Step and reference transducer contradict each other: on the mean S(f) differs by %1, U of the difference %2 (k = 2), Eₙ = %3.</source>
        <translation>Steg och referensgivare motsäger varandra: i medeltal skiljer sig S(f) med %1, skillnadens U är %2 (k = 2), Eₙ = %3.</translation>
    </message>
    <message>
        <source>Step and reference transducer agree: on the mean S(f) differs by %1, U of the difference %2 (k = 2), Eₙ = %3.</source>
        <translation>Steg och referensgivare stämmer överens: i medeltal skiljer sig S(f) med %1, skillnadens U är %2 (k = 2), Eₙ = %3.</translation>
    </message>
    <message>
        <source>On the page Checks other ways contradict each other, too: begin there.</source>
        <translation>På sidan Kontroller motsäger även andra vägar varandra: börja där.</translation>
    </message>
    <message>
        <source>On the page Checks nothing contradicts the step: begin with the transducer.</source>
        <translation>På sidan Kontroller motsäger inget steget: börja med referensgivaren.</translation>
    </message>
    <message>
        <source>Look at the reference transducer: number and date of its certificate, its unit, the gain of its chain, its mounting. A factor such as 1.5, 6.9 or 1000 is a gain or a unit. Then at the step: gas and humidity, T1, distances and delays of the arrival sensors (page Reference step). %1 Correct what is wrong; a caution that stays needs a reason before the certificate can be issued.</source>
        <translation>Granska referensgivaren: certifikatets nummer och datum, dess enhet, mätkedjans förstärkning, monteringen. En faktor som 1,5, 6,9 eller 1000 är en förstärkning eller en enhet. Sedan steget: gas och fuktighet, T1, ankomstgivarnas avstånd och fördröjningar (sidan Referenssteg). %1 Rätta det som är fel; en varning som står kvar behöver en motivering innan kalibreringsbeviset kan utfärdas.</translation>
    </message>
    <message>
        <source>The mean agrees, single frequencies do not: look there at the certificate&apos;s rows, at a resonance or the mounting of one of the two, at the delay between them, and at disturbances in either record. State S(f) only where both agree, or say why they differ.</source>
        <translation>Medelvärdet stämmer, enstaka frekvenser gör det inte: granska där certifikatets rader, en resonans eller monteringen hos någon av de två, fördröjningen mellan dem och störningar i endera registreringen. Ange S(f) bara där båda stämmer överens, eller säg varför de skiljer sig.</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>medel</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frekvens</translation>
    </message>
    <message>
        <source>Against the
transducer</source>
        <translation>Mot
referensgivaren</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>Against
the step</source>
        <translation>Mot
steget</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Skillnad</translation>
    </message>
    <message>
        <source>Eₙ</source>
        <translation>Eₙ</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabell</translation>
    </message>
    <message>
        <source>Certificate %1</source>
        <translation>Certifikat %1</translation>
    </message>
    <message>
        <source>%1, from %2 to %3; at %2: %4 (k = 1).</source>
        <translation>%1, från %2 till %3; vid %2: %4 (k = 1).</translation>
    </message>
    <message>
        <source>S(f) against the reference transducer stands alone: the pressure step, or one of the two, has no complete uncertainty to compare by.</source>
        <translation>S(f) mot referensgivaren står ensamt: trycksteget, eller ett av de två, har ingen fullständig osäkerhet att jämföra med.</translation>
    </message>
    <message>
        <source>Nothing is compared. Where a transducer of known sensitivity was recorded beside the sensor, say what it is, then switch the comparison on. Where another certificate states this sensor&apos;s sensitivity, type its value.</source>
        <translation>Inget jämförs. Om en referensgivare med känd känslighet spelades in bredvid givaren, ange vilken och slå sedan på jämförelsen. Om ett annat bevis anger givarens känslighet, skriv in dess värde.</translation>
    </message>
</context>
<context>
    <name>ControlTips</name>
    <message>
        <source>Open further recordings beside these</source>
        <translation>Öppna fler registreringar utöver dessa</translation>
    </message>
    <message>
        <source>How the file of the selected shot is read: channels, units, rate</source>
        <translation>Hur filen till det valda skottet läses: kanaler, enheter, samplingsfrekvens</translation>
    </message>
    <message>
        <source>Take the selected shot out of the job; the file stays as it is</source>
        <translation>Ta bort det valda skottet ur arbetet; filen förblir som den är</translation>
    </message>
    <message>
        <source>Name of the shot&apos;s pressure level</source>
        <translation>Namn på skottets trycknivå</translation>
    </message>
    <message>
        <source>What this channel recorded, in all shots</source>
        <translation>Vad den här kanalen registrerade, i alla skott</translation>
    </message>
    <message>
        <source>Unit of the sensor&apos;s record, where the file&apos;s is wrong or missing</source>
        <translation>Enhet för givarens registrering, där filens är fel eller saknas</translation>
    </message>
    <message>
        <source>Factor on the sensor&apos;s values</source>
        <translation>Faktor på givarens värden</translation>
    </message>
    <message>
        <source>The sensor&apos;s voltage falls when the pressure rises</source>
        <translation>Givarens spänning sjunker när trycket stiger</translation>
    </message>
    <message>
        <source>Whether the sensor reads pressure from vacuum or from the air around it</source>
        <translation>Om givaren visar tryck från vakuum eller från luften omkring</translation>
    </message>
    <message>
        <source>Samples per second, where the file is wrong; a reason is asked for</source>
        <translation>Sampel per sekund, där filen har fel; en motivering efterfrågas</translation>
    </message>
    <message>
        <source>The shot that plots, tables and arrivals are of</source>
        <translation>Skottet som diagram, tabeller och ankomster gäller</translation>
    </message>
    <message>
        <source>Compute the pressure step from shock velocity and gas state</source>
        <translation>Beräkna trycksteget ur stötvågens hastighet och gasens tillstånd</translation>
    </message>
    <message>
        <source>The pressure step, where a reference sensor measured it</source>
        <translation>Trycksteget, där en referensgivare mätte det</translation>
    </message>
    <message>
        <source>Shock velocity, where it is known otherwise than from arrivals</source>
        <translation>Stötvågens hastighet, där den är känd på annat sätt än ur ankomster</translation>
    </message>
    <message>
        <source>Absolute pressure in the driven section before the shot</source>
        <translation>Absolut tryck i den drivna sektionen före skottet</translation>
    </message>
    <message>
        <source>Temperature in the driven section before the shot</source>
        <translation>Temperatur i den drivna sektionen före skottet</translation>
    </message>
    <message>
        <source>Temperature in the driver section before the shot</source>
        <translation>Temperatur i den drivande sektionen före skottet</translation>
    </message>
    <message>
        <source>Gas that the shock runs through</source>
        <translation>Gas som stötvågen löper genom</translation>
    </message>
    <message>
        <source>Gas behind the diaphragm</source>
        <translation>Gas bakom membranet</translation>
    </message>
    <message>
        <source>Ratio of the heat capacities of the gas</source>
        <translation>Kvot mellan gasens värmekapaciteter</translation>
    </message>
    <message>
        <source>Molar mass of the gas</source>
        <translation>Gasens molmassa</translation>
    </message>
    <message>
        <source>Take the heat capacity at the temperature behind the shock</source>
        <translation>Ta värmekapaciteten vid temperaturen bakom stötvågen</translation>
    </message>
    <message>
        <source>Relative humidity of the air in the driven section</source>
        <translation>Relativ luftfuktighet i den drivna sektionen</translation>
    </message>
    <message>
        <source>Share of carbon dioxide in the air</source>
        <translation>Andel koldioxid i luften</translation>
    </message>
    <message>
        <source>Length from diaphragm to end wall: gives the end of the plateau</source>
        <translation>Längd från membran till ändvägg: ger platåns slut</translation>
    </message>
    <message>
        <source>Length of the section behind the diaphragm</source>
        <translation>Längd på sektionen bakom membranet</translation>
    </message>
    <message>
        <source>Inner diameter of the driven section</source>
        <translation>Den drivna sektionens innerdiameter</translation>
    </message>
    <message>
        <source>How long before its computed end the plateau is no longer used</source>
        <translation>Hur långt före sitt beräknade slut platån inte längre används</translation>
    </message>
    <message>
        <source>The sensor that the fields below are of</source>
        <translation>Givaren som fälten nedan gäller</translation>
    </message>
    <message>
        <source>Channel that shows when the shock passes</source>
        <translation>Kanal som visar när stötvågen passerar</translation>
    </message>
    <message>
        <source>Distance of the sensor from the end wall</source>
        <translation>Givarens avstånd från ändväggen</translation>
    </message>
    <message>
        <source>Standard uncertainty of the distance</source>
        <translation>Avståndets standardosäkerhet</translation>
    </message>
    <message>
        <source>When the shock passes, on the record&apos;s own axis</source>
        <translation>När stötvågen passerar, på registreringens egen axel</translation>
    </message>
    <message>
        <source>By how much the sensor&apos;s signal is late</source>
        <translation>Hur mycket givarens signal är sen</translation>
    </message>
    <message>
        <source>A further sensor that the shock passes</source>
        <translation>Ytterligare en givare som stötvågen passerar</translation>
    </message>
    <message>
        <source>No longer use this sensor&apos;s arrival</source>
        <translation>Använd inte längre denna givares ankomst</translation>
    </message>
    <message>
        <source>Where the response begins, on the record&apos;s own axis</source>
        <translation>Var svaret börjar, på registreringens egen axel</translation>
    </message>
    <message>
        <source>Take the level before the step off the response</source>
        <translation>Dra av nivån före steget från svaret</translation>
    </message>
    <message>
        <source>Stretch before the step that gives level 0 and the noise</source>
        <translation>Sträcka före steget som ger nivå 0 och bruset</translation>
    </message>
    <message>
        <source>Where the response ends, after the start</source>
        <translation>Var svaret slutar, räknat från starten</translation>
    </message>
    <message>
        <source>End every shot where its own computed plateau ends</source>
        <translation>Låt varje skott sluta där dess egen beräknade platå slutar</translation>
    </message>
    <message>
        <source>Stretch after the ringing that gives the step&apos;s height</source>
        <translation>Sträcka efter svängningen som ger stegets höjd</translation>
    </message>
    <message>
        <source>Divide each response by its step, so that shots can be compared</source>
        <translation>Dividera varje svar med sitt steg, så att skotten kan jämföras</translation>
    </message>
    <message>
        <source>Begin of the stretch left out, after the start</source>
        <translation>Den utelämnade sträckans början, räknat från starten</translation>
    </message>
    <message>
        <source>End of the stretch left out, after the start</source>
        <translation>Den utelämnade sträckans slut, räknat från starten</translation>
    </message>
    <message>
        <source>Shots in which the stretch is left out</source>
        <translation>Skott där sträckan utelämnas</translation>
    </message>
    <message>
        <source>Why it is left out; the certificate prints it</source>
        <translation>Varför den utelämnas; kalibreringsbeviset skriver ut det</translation>
    </message>
    <message>
        <source>Use the selected stretch again</source>
        <translation>Använd den valda sträckan igen</translation>
    </message>
    <message>
        <source>How the power spectrum is estimated</source>
        <translation>Hur effektspektrum skattas</translation>
    </message>
    <message>
        <source>Weight of the samples towards the ends of the window</source>
        <translation>Samplens vikt mot fönstrets ändar</translation>
    </message>
    <message>
        <source>What is taken off before the spectrum: nothing, a mean, a line</source>
        <translation>Vad som dras av före spektrum: inget, ett medelvärde, en linje</translation>
    </message>
    <message>
        <source>Whether the program looks for the resonance or you give it</source>
        <translation>Om programmet söker resonansen eller du anger den</translation>
    </message>
    <message>
        <source>Frequency of the resonance that you give</source>
        <translation>Frekvens för den resonans som du anger</translation>
    </message>
    <message>
        <source>Frequencies between which a resonance is looked for</source>
        <translation>Frekvenser mellan vilka en resonans söks</translation>
    </message>
    <message>
        <source>Oscillations that the gas of the tube can have</source>
        <translation>Svängningar som gasen i röret kan ha</translation>
    </message>
    <message>
        <source>Frequency of an oscillation that is not the sensor&apos;s</source>
        <translation>Frekvens för en svängning som inte är givarens</translation>
    </message>
    <message>
        <source>Shot in which this frequency was read</source>
        <translation>Skott där denna frekvens lästes av</translation>
    </message>
    <message>
        <source>Whether it moves with the sound speed of the gas from shot to shot</source>
        <translation>Om den följer gasens ljudhastighet från skott till skott</translation>
    </message>
    <message>
        <source>Why it is not the sensor&apos;s; the certificate prints it</source>
        <translation>Varför den inte är givarens; kalibreringsbeviset skriver ut det</translation>
    </message>
    <message>
        <source>Fit it in each shot and leave it out of the model</source>
        <translation>Anpassa den i varje skott och lämna den utanför modellen</translation>
    </message>
    <message>
        <source>Let the model describe the selected oscillation again</source>
        <translation>Låt modellen beskriva den valda svängningen igen</translation>
    </message>
    <message>
        <source>How many components make up what the shots share</source>
        <translation>Hur många komponenter som utgör det gemensamma i skotten</translation>
    </message>
    <message>
        <source>Take the mean of every shot off before the components</source>
        <translation>Dra av varje skotts medelvärde före komponenterna</translation>
    </message>
    <message>
        <source>Confidence of the band that white noise stays in</source>
        <translation>Konfidens för bandet som vitt brus håller sig inom</translation>
    </message>
    <message>
        <source>How far the residual is compared with itself</source>
        <translation>Hur långt residualen jämförs med sig själv</translation>
    </message>
    <message>
        <source>What the model takes the response for</source>
        <translation>Vad modellen uppfattar svaret som</translation>
    </message>
    <message>
        <source>Whether shots are fitted together or averaged first</source>
        <translation>Om skotten anpassas tillsammans eller först medelvärdesbildas</translation>
    </message>
    <message>
        <source>Rate that the response is resampled to for the model</source>
        <translation>Frekvens som svaret samplas om till för modellen</translation>
    </message>
    <message>
        <source>How many samples the model is made from</source>
        <translation>Hur många sampel modellen görs av</translation>
    </message>
    <message>
        <source>How long after the start the model input begins</source>
        <translation>Hur långt efter starten modellens indata börjar</translation>
    </message>
    <message>
        <source>Number of states of the model</source>
        <translation>Modellens antal tillstånd</translation>
    </message>
    <message>
        <source>Take the order that the program suggests (Home)</source>
        <translation>Ta den ordning som programmet föreslår (Home)</translation>
    </message>
    <message>
        <source>Why this order; the certificate prints it</source>
        <translation>Varför denna ordning; kalibreringsbeviset skriver ut det</translation>
    </message>
    <message>
        <source>Keep this order and the reason for it (Enter)</source>
        <translation>Behåll denna ordning och skälet till den (Enter)</translation>
    </message>
    <message>
        <source>By how much a frequency may move from one order to the next</source>
        <translation>Hur mycket en frekvens får flytta sig från en ordning till nästa</translation>
    </message>
    <message>
        <source>By how much a damping may move from one order to the next</source>
        <translation>Hur mycket en dämpning får flytta sig från en ordning till nästa</translation>
    </message>
    <message>
        <source>Largest order that can be chosen</source>
        <translation>Högsta ordning som kan väljas</translation>
    </message>
    <message>
        <source>Rows of the Hankel matrix that is decomposed</source>
        <translation>Rader i den Hankelmatris som delas upp</translation>
    </message>
    <message>
        <source>Fit the poles to the samples after the decomposition</source>
        <translation>Anpassa polerna till samplen efter uppdelningen</translation>
    </message>
    <message>
        <source>Show the candidates&apos; numbers as differences from the adopted order</source>
        <translation>Visa kandidaternas tal som skillnader mot den antagna ordningen</translation>
    </message>
    <message>
        <source>No longer compare this order (Space)</source>
        <translation>Jämför inte längre denna ordning (mellanslag)</translation>
    </message>
    <message>
        <source>Draw this order over the others in the plots</source>
        <translation>Rita denna ordning över de andra i diagrammen</translation>
    </message>
    <message>
        <source>A note on this order, kept in the project</source>
        <translation>En anteckning om denna ordning, sparas i projektet</translation>
    </message>
    <message>
        <source>Go on with the first singular values alone</source>
        <translation>Fortsätt med enbart de första singulärvärdena</translation>
    </message>
    <message>
        <source>Compute all singular values now</source>
        <translation>Beräkna alla singulärvärden nu</translation>
    </message>
    <message>
        <source>Draw the pinned orders beside the model</source>
        <translation>Rita de fästa ordningarna bredvid modellen</translation>
    </message>
    <message>
        <source>Draw the second-order sensor that describes it best</source>
        <translation>Rita den andra ordningens givare som beskriver den bäst</translation>
    </message>
    <message>
        <source>Language of the document, not of the window</source>
        <translation>Dokumentets språk, inte fönstrets</translation>
    </message>
    <message>
        <source>Write the certificate as a PDF (Ctrl+P)</source>
        <translation>Skriv kalibreringsbeviset som PDF (Ctrl+P)</translation>
    </message>
    <message>
        <source>A day as 2026-01-31; printed on the certificate</source>
        <translation>En dag som 2026-01-31; skrivs ut på kalibreringsbeviset</translation>
    </message>
    <message>
        <source>Who approves the certificate; may be left empty</source>
        <translation>Vem som godkänner kalibreringsbeviset; får vara tomt</translation>
    </message>
    <message>
        <source>Printed on the certificate; may be left empty</source>
        <translation>Skrivs ut på kalibreringsbeviset; får vara tomt</translation>
    </message>
    <message>
        <source>Printed on the certificate; taken from the recordings where they say it</source>
        <translation>Skrivs ut på kalibreringsbeviset; tas ur registreringarna där de anger det</translation>
    </message>
    <message>
        <source>Printed on the certificate; it cannot be issued without</source>
        <translation>Skrivs ut på kalibreringsbeviset; det kan inte utfärdas utan</translation>
    </message>
    <message>
        <source>Choose the recordings of one sensor (Ctrl+Shift+O)</source>
        <translation>Välj registreringarna av en givare (Ctrl+Shift+O)</translation>
    </message>
    <message>
        <source>Three simulated shots, ready to look at</source>
        <translation>Tre simulerade skott, färdiga att titta på</translation>
    </message>
    <message>
        <source>Go on with a job saved before (Ctrl+O)</source>
        <translation>Fortsätt med ett tidigare sparat arbete (Ctrl+O)</translation>
    </message>
    <message>
        <source>Stop the work under way; what is on show stays</source>
        <translation>Stoppa det pågående arbetet; det som visas står kvar</translation>
    </message>
    <message>
        <source>Read the files of this list again</source>
        <translation>Läs filerna i listan igen</translation>
    </message>
    <message>
        <source>Put the list on the clipboard</source>
        <translation>Lägg listan på urklipp</translation>
    </message>
    <message>
        <source>Close the list; nothing is changed</source>
        <translation>Stäng listan; ingenting ändras</translation>
    </message>
    <message>
        <source>Ticked, the program decides, and the field shows what it took</source>
        <translation>Ikryssad bestämmer programmet, och fältet visar vad det tog</translation>
    </message>
    <message>
        <source>Whether an end that is typed or dragged holds for all shots, or for the shot alone whose values are shown</source>
        <translation>Om ett slut som skrivs in eller dras gäller för alla skott, eller bara för det skott vars värden visas</translation>
    </message>
    <message>
        <source>The value whose budget is shown</source>
        <translation>Värdet vars budget visas</translation>
    </message>
    <message>
        <source>The frequency of S(f) whose budget is shown</source>
        <translation>Frekvensen för S(f) vars budget visas</translation>
    </message>
    <message>
        <source>The input whose u is tried</source>
        <translation>Ingången vars u prövas</translation>
    </message>
    <message>
        <source>Another standard uncertainty of this input; empty: as it is</source>
        <translation>En annan standardosäkerhet för denna ingång; tomt: som det är</translation>
    </message>
    <message>
        <source>Expanded uncertainty that is wanted, of the value</source>
        <translation>Önskad utvidgad osäkerhet, i förhållande till värdet</translation>
    </message>
    <message>
        <source>Coverage factor of the wanted U</source>
        <translation>Täckningsfaktor för det önskade U</translation>
    </message>
    <message>
        <source>Compute S(f) against the reference transducer too, and compare it with that against the step</source>
        <translation>Beräkna även S(f) mot referensgivaren och jämför med det mot steget</translation>
    </message>
    <message>
        <source>What the stated S(f) is divided by; the comparison is made in either case</source>
        <translation>Vad det angivna S(f) är dividerat med; jämförelsen görs i båda fallen</translation>
    </message>
    <message>
        <source>Channel that recorded the reference transducer</source>
        <translation>Kanal som registrerade referensgivaren</translation>
    </message>
    <message>
        <source>Unit of the sensitivity in its file or model: that of its channel over Pa</source>
        <translation>Känslighetens enhet i fil eller modell: kanalens enhet per Pa</translation>
    </message>
    <message>
        <source>A table (CSV) or a digital calibration certificate (XML) with its sensitivity over frequency</source>
        <translation>En tabell (CSV) eller ett digitalt kalibreringsbevis (XML) med dess känslighet över frekvens</translation>
    </message>
    <message>
        <source>No longer use this file; the comparison is switched off</source>
        <translation>Använd inte längre filen; jämförelsen slås av</translation>
    </message>
    <message>
        <source>Which list of the certificate is meant, by its id</source>
        <translation>Vilken lista i certifikatet som avses, med dess id</translation>
    </message>
    <message>
        <source>Sensitivity at low frequency</source>
        <translation>Känslighet vid låg frekvens</translation>
    </message>
    <message>
        <source>Standard uncertainty of the sensitivity, in its unit</source>
        <translation>Känslighetens standardosäkerhet, i dess enhet</translation>
    </message>
    <message>
        <source>Natural frequency of the reference transducer</source>
        <translation>Referensgivarens egenfrekvens</translation>
    </message>
    <message>
        <source>Standard uncertainty of its natural frequency</source>
        <translation>Egenfrekvensens standardosäkerhet</translation>
    </message>
    <message>
        <source>Damping ratio of the reference transducer</source>
        <translation>Referensgivarens dämpningsförhållande</translation>
    </message>
    <message>
        <source>Standard uncertainty of its damping ratio</source>
        <translation>Dämpningsförhållandets standardosäkerhet</translation>
    </message>
    <message>
        <source>Drop these values; the comparison is switched off</source>
        <translation>Ta bort värdena; jämförelsen slås av</translation>
    </message>
    <message>
        <source>By how much later the step reaches it than the sensor</source>
        <translation>Hur mycket senare än givaren den nås av steget</translation>
    </message>
    <message>
        <source>Standard uncertainty of the delay; empty: anything within ±0.5 µs</source>
        <translation>Fördröjningens standardosäkerhet; tomt: vad som helst inom ±0,5 µs</translation>
    </message>
    <message>
        <source>Of its sensitivity and the computed step, from -1 to 1; empty: none</source>
        <translation>Mellan dess känslighet och det beräknade steget, från -1 till 1; tomt: ingen</translation>
    </message>
    <message>
        <source>A table (CSV) or a certificate (XML) with the response of amplifier and converter, relative to the gain at low frequency</source>
        <translation>En tabell (CSV) eller ett certifikat (XML) med förstärkarens och omvandlarens svar, relativt förstärkningen vid låg frekvens</translation>
    </message>
    <message>
        <source>No longer divide the chain&apos;s response out of S(f)</source>
        <translation>Räkna inte längre bort kedjans svar ur S(f)</translation>
    </message>
    <message>
        <source>Entries of the recipe; the selected one stands in the fields below</source>
        <translation>Receptets poster; den valda står i fälten nedan</translation>
    </message>
    <message>
        <source>What the laboratory is accredited for: no smaller U of it is stated</source>
        <translation>Vad laboratoriet är ackrediterat för: inget mindre U anges för det</translation>
    </message>
    <message>
        <source>Whether the least U is relative to the value or in its unit</source>
        <translation>Om det minsta U är relativt värdet eller i dess enhet</translation>
    </message>
    <message>
        <source>The smallest expanded uncertainty that the laboratory states, at 95 %</source>
        <translation>Den minsta utvidgade osäkerhet som laboratoriet anger, vid 95 %</translation>
    </message>
    <message>
        <source>Lowest frequency of the entry; empty: from 0 on</source>
        <translation>Postens lägsta frekvens; tomt: från 0</translation>
    </message>
    <message>
        <source>Highest frequency of the entry; empty: without end</source>
        <translation>Postens högsta frekvens; tomt: utan slut</translation>
    </message>
    <message>
        <source>Put what stands in the fields into the recipe, as a further entry</source>
        <translation>Lägg till det som står i fälten som ytterligare en post i receptet</translation>
    </message>
    <message>
        <source>Put what stands in the fields in the place of the selected entry</source>
        <translation>Sätt det som står i fälten i stället för den valda posten</translation>
    </message>
    <message>
        <source>Take the selected entry out of the recipe</source>
        <translation>Ta bort den valda posten ur receptet</translation>
    </message>
    <message>
        <source>How deviation and uncertainty decide whether the sensor conforms</source>
        <translation>Hur avvikelse och osäkerhet avgör om givaren uppfyller kravet</translation>
    </message>
    <message>
        <source>Limit of the deviation from the sensitivity at low frequency</source>
        <translation>Gräns för avvikelsen från känsligheten vid låg frekvens</translation>
    </message>
    <message>
        <source>Lowest frequency of the claim</source>
        <translation>Påståendets lägsta frekvens</translation>
    </message>
    <message>
        <source>Highest frequency of the claim</source>
        <translation>Påståendets högsta frekvens</translation>
    </message>
    <message>
        <source>Largest probability of being outside the limit, at any frequency</source>
        <translation>Största sannolikhet att ligga utanför gränsen, vid någon frekvens</translation>
    </message>
    <message>
        <source>What the certificate calls the other calibration</source>
        <translation>Vad beviset kallar den andra kalibreringen</translation>
    </message>
    <message>
        <source>Number of its certificate; may be left out</source>
        <translation>Bevisets nummer; kan utelämnas</translation>
    </message>
    <message>
        <source>At which the value holds; empty: static</source>
        <translation>Vid vilken värdet gäller; tomt: statiskt</translation>
    </message>
    <message>
        <source>Such as V/Pa or mV/bar; it is converted to the unit of S(f)</source>
        <translation>Till exempel V/Pa eller mV/bar; räknas om till enheten för S(f)</translation>
    </message>
    <message>
        <source>The sensitivity that it states, in this unit</source>
        <translation>Känsligheten som den anger, i denna enhet</translation>
    </message>
    <message>
        <source>Its expanded uncertainty, in the unit of the value, at k = 2</source>
        <translation>Dess utvidgade osäkerhet, i värdets enhet, vid k = 2</translation>
    </message>
    <message>
        <source>An input of the budget whose error goes along with another&apos;s; the budget must state its u</source>
        <translation>En storhet i budgeten vars fel följer en annans; budgeten måste ange dess u</translation>
    </message>
    <message>
        <source>The other input, as where one instrument or one certificate is behind both</source>
        <translation>Den andra storheten, som när ett instrument eller ett bevis ligger bakom båda</translation>
    </message>
    <message>
        <source>The part of their variance that both have in common, -1 to 1; negative where they err the opposite way</source>
        <translation>Den del av variansen som båda har gemensam, -1 till 1; negativ där felen går åt motsatt håll</translation>
    </message>
    <message>
        <source>Which sections, figures and key results the certificate has, in which order</source>
        <translation>Vilka avsnitt, figurer och huvudresultat beviset har, och i vilken ordning</translation>
    </message>
    <message>
        <source>A template of your own (.json), with the logo beside it</source>
        <translation>En egen mall (.json), med logotypen bredvid</translation>
    </message>
    <message>
        <source>How long the pressure rises at the sensor: a tilt of 1° over 5.5 mm makes 190 ns; empty where it is sharp</source>
        <translation>Hur länge trycket stiger vid givaren: en lutning på 1° över 5,5 mm ger 190 ns; tomt där det stiger skarpt</translation>
    </message>
    <message>
        <source>Standard uncertainty of the front&apos;s duration</source>
        <translation>Standardosäkerhet för frontens varaktighet</translation>
    </message>
    <message>
        <source>Number of the transducer&apos;s certificate, where its file states none: without one no certificate is issued</source>
        <translation>Numret på givarens bevis, där dess fil inte anger något: utan ett sådant utfärdas inget bevis</translation>
    </message>
    <message>
        <source>Number of the chain&apos;s certificate, where its file states none: without one no certificate is issued</source>
        <translation>Numret på mätkedjans bevis, där dess fil inte anger något: utan ett sådant utfärdas inget bevis</translation>
    </message>
</context>
<context>
    <name>Corrections</name>
    <message>
        <source>Exclude shot %1</source>
        <translation>Uteslut skott %1</translation>
    </message>
    <message>
        <source>Why is this shot not used? The certificate prints the reason.</source>
        <translation>Varför används inte detta skott? Skälet skrivs ut i kalibreringsbeviset.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the DUT</source>
        <translation>”%1” är DUT</translation>
    </message>
    <message>
        <source>Choose %1 as the DUT</source>
        <translation>Välj %1 som DUT</translation>
    </message>
    <message>
        <source>Swap in all shots</source>
        <translation>Byt plats i alla skott</translation>
    </message>
    <message>
        <source>Swap DUT and driven side</source>
        <translation>Byt plats på DUT och drivna sidan</translation>
    </message>
    <message>
        <source>The unit is %1</source>
        <translation>Enheten är %1</translation>
    </message>
    <message>
        <source>Change the DUT&apos;s unit</source>
        <translation>Ändra DUT:s enhet</translation>
    </message>
    <message>
        <source>Invert polarity</source>
        <translation>Vänd polariteten</translation>
    </message>
    <message>
        <source>Change the DUT&apos;s polarity</source>
        <translation>Ändra DUT:s polaritet</translation>
    </message>
    <message>
        <source>Interpolate gaps of up to %1 samples</source>
        <translation>Interpolera luckor på högst %1 sampel</translation>
    </message>
    <message>
        <source>Interpolate invalid samples</source>
        <translation>Interpolera ogiltiga sampel</translation>
    </message>
    <message>
        <source>Swap in %1</source>
        <translation>Byt plats i %1</translation>
    </message>
    <message>
        <source>Import settings...</source>
        <translation>Importinställningar...</translation>
    </message>
    <message>
        <source>Swap in shot %1</source>
        <translation>Byt plats i skott %1</translation>
    </message>
</context>
<context>
    <name>DrawnWords</name>
    <message>
        <source>validated</source>
        <translation>validerad</translation>
    </message>
    <message>
        <source>Monte Carlo: none of this value yet.</source>
        <translation>Monte Carlo: ännu ingen av detta värde.</translation>
    </message>
    <message>
        <source>Monte Carlo, %1 trials: in %2 of them the value does not exist.</source>
        <translation>Monte Carlo, %1 försök: i %2 av dem finns inte värdet.</translation>
    </message>
    <message>
        <source>Monte Carlo, %1 trials: from %2 to %3, U = %4.</source>
        <translation>Monte Carlo, %1 försök: från %2 till %3, U = %4.</translation>
    </message>
    <message>
        <source>It validates the law of propagation (U = %1).</source>
        <translation>Den validerar fortplantningslagen (U = %1).</translation>
    </message>
    <message>
        <source>It does not validate the law of propagation (U = %1).</source>
        <translation>Den validerar inte fortplantningslagen (U = %1).</translation>
    </message>
</context>
<context>
    <name>FindingAnswers</name>
    <message>
        <source>Reason for %1</source>
        <translation>Skäl för %1</translation>
    </message>
    <message>
        <source>Why is the result used all the same? The certificate prints the reason.</source>
        <translation>Varför används resultatet ändå? Skälet skrivs ut i kalibreringsbeviset.</translation>
    </message>
    <message>
        <source>Give a reason for %1</source>
        <translation>Ange ett skäl för %1</translation>
    </message>
</context>
<context>
    <name>FindingGroup</name>
    <message>
        <source>shots %1</source>
        <translation>skott %1</translation>
    </message>
    <message numerus="yes">
        <source>%n time(s)</source>
        <translation>
            <numerusform>%n gång</numerusform>
            <numerusform>%n gånger</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 till %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 och %2</translation>
    </message>
</context>
<context>
    <name>FindingText</name>
    <message>
        <source>Info</source>
        <translation>Upplysning</translation>
    </message>
    <message>
        <source>Caution</source>
        <translation>Varning</translation>
    </message>
    <message>
        <source>Blocked</source>
        <translation>Blockerat</translation>
    </message>
    <message>
        <source>, shot %1</source>
        <translation>, skott %1</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>zoom the x axis at the pointer</source>
        <translation>zooma x-axeln vid pekaren</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+mushjul</translation>
    </message>
    <message>
        <source>zoom the y axis</source>
        <translation>zooma y-axeln</translation>
    </message>
    <message>
        <source>move the plot</source>
        <translation>flytta diagrammet</translation>
    </message>
    <message>
        <source>Right drag</source>
        <translation>Dra med höger knapp</translation>
    </message>
    <message>
        <source>zoom a box</source>
        <translation>zooma till en ruta</translation>
    </message>
    <message>
        <source>Double click, F</source>
        <translation>Dubbelklick, F</translation>
    </message>
    <message>
        <source>show everything</source>
        <translation>visa allt</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>grid on or off</source>
        <translation>rutnät på eller av</translation>
    </message>
    <message>
        <source>1, 2</source>
        <translation>1, 2</translation>
    </message>
    <message>
        <source>Left, Right (Order)</source>
        <translation>Vänster, höger (Modellordning)</translation>
    </message>
    <message>
        <source>order minus or plus one</source>
        <translation>ordningen minus eller plus ett</translation>
    </message>
    <message>
        <source>Page Up, Page Down (Order)</source>
        <translation>Page Up, Page Down (Modellordning)</translation>
    </message>
    <message>
        <source>order plus or minus ten</source>
        <translation>ordningen plus eller minus tio</translation>
    </message>
    <message>
        <source>Home (Order)</source>
        <translation>Home (Modellordning)</translation>
    </message>
    <message>
        <source>take the suggested order</source>
        <translation>använd den föreslagna ordningen</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Tangentbord och mus</translation>
    </message>
    <message>
        <source>About Dyncal</source>
        <translation>Om Dyncal</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Dyncal %1&lt;/h3&gt;&lt;p&gt;Dynamic calibration of pressure sensors.&lt;/p&gt;&lt;p&gt;Build %2&lt;/p&gt;&lt;p&gt;Copyright 2026 The Dyncal authors. Free software under the GNU General Public License, version 3 or later. It comes with no warranty.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Dyncal %1&lt;/h3&gt;&lt;p&gt;Dynamisk kalibrering av tryckgivare.&lt;/p&gt;&lt;p&gt;Bygge %2&lt;/p&gt;&lt;p&gt;Copyright 2026 Dyncals upphovspersoner. Fri programvara enligt GNU General Public License, version 3 eller senare. Programmet levereras utan någon garanti.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Shift+drag (Window)</source>
        <translation>Skift+dra (Fönster)</translation>
    </message>
    <message>
        <source>mark a stretch to be left out of the fit</source>
        <translation>markera en sträcka som ska utelämnas ur anpassningen</translation>
    </message>
    <message>
        <source>Wheel, +, -</source>
        <translation>Hjul, +, -</translation>
    </message>
    <message>
        <source>Shift+wheel, left drag, arrows</source>
        <translation>Skift+hjul, vänsterdra, pilar</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Backsteg</translation>
    </message>
    <message>
        <source>the view before; with Shift the one after</source>
        <translation>föregående vy; med Skift nästa</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tabb</translation>
    </message>
    <message>
        <source>to the next handle; Left and Right move it</source>
        <translation>till nästa handtag; Vänster och Höger flyttar det</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>ends a drag as if it had not been, then takes cursors away</source>
        <translation>avslutar en dragning som om den inte skett, tar sedan bort markörer</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Överallt</translation>
    </message>
    <message>
        <source>In plots</source>
        <translation>I diagram</translation>
    </message>
    <message>
        <source>put cursor A or B at the pointer; the mouse drags it</source>
        <translation>sätt markör A eller B vid pekaren; musen drar den</translation>
    </message>
    <message>
        <source>Ctrl+Left, Ctrl+Right</source>
        <translation>Ctrl+Vänster, Ctrl+Höger</translation>
    </message>
    <message>
        <source>move the cursor placed last by one sample; with Shift by ten</source>
        <translation>flytta den senast satta markören ett sampel; med Skift tio</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>go to a place that is typed</source>
        <translation>gå till en plats som skrivs in</translation>
    </message>
</context>
<context>
    <name>HistoryRows</name>
    <message>
        <source>Natural frequency</source>
        <translation>Egenfrekvens</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>Dämpningsgrad</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Känslighet</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Belopp</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Fas</translation>
    </message>
    <message>
        <source>● inside</source>
        <translation>● innanför</translation>
    </message>
    <message>
        <source>▲ beyond the warning limits</source>
        <translation>▲ utanför varningsgränserna</translation>
    </message>
    <message>
        <source>■ beyond the action limits</source>
        <translation>■ utanför åtgärdsgränserna</translation>
    </message>
    <message>
        <source>blocked: it states nothing</source>
        <translation>spärrat: det anger ingenting</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>inte angivet</translation>
    </message>
    <message>
        <source>without complete U</source>
        <translation>utan fullständigt U</translation>
    </message>
    <message>
        <source>other versions of the method than before</source>
        <translation>andra versioner av metoden än förut</translation>
    </message>
    <message>
        <source>results.json is not as the run wrote it</source>
        <translation>results.json är inte som körningen skrev den</translation>
    </message>
    <message>
        <source>A drift is stated from %1 calibrations with complete U on.</source>
        <translation>En drift anges från och med %1 kalibreringar med fullständigt U.</translation>
    </message>
    <message>
        <source>Drift in a year: %1 (k = %2, %3 calibrations).</source>
        <translation>Drift på ett år: %1 (k = %2, %3 kalibreringar).</translation>
    </message>
    <message>
        <source>Left out, withdrawn or replaced: %1</source>
        <translation>Utelämnat, återkallat eller ersatt: %1</translation>
    </message>
    <message>
        <source>Left out, a newer result of the same recordings counts: %1</source>
        <translation>Utelämnat, ett nyare resultat av samma registreringar gäller: %1</translation>
    </message>
    <message>
        <source>Left out, without serial number: %1</source>
        <translation>Utelämnat, utan serienummer: %1</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 vid %2</translation>
    </message>
    <message>
        <source>Control limits are drawn from %1 calibrations on.</source>
        <translation>Styrgränser ritas från och med %1 kalibreringar.</translation>
    </message>
    <message>
        <source>differs from the one before by more than U</source>
        <translation>skiljer sig från den föregående med mer än U</translation>
    </message>
</context>
<context>
    <name>ImportVerdict</name>
    <message>
        <source>The header says %1, the time column %2. Which one is right?</source>
        <translation>Huvudet anger %1, tidskolumnen %2. Vilken stämmer?</translation>
    </message>
    <message>
        <source>Cells that are no numbers are marked; change separator, decimal mark or header rows.</source>
        <translation>Celler som inte är tal är markerade; ändra skiljetecken, decimaltecken eller huvudrader.</translation>
    </message>
    <message>
        <source>The numbers can be read in two ways: choose the decimal mark; the table shows the effect.</source>
        <translation>Talen kan läsas på två sätt: välj decimaltecken; tabellen visar verkan.</translation>
    </message>
    <message>
        <source>The file does not say its sample rate: type it.</source>
        <translation>Filen anger inte sin samplingsfrekvens: skriv in den.</translation>
    </message>
    <message>
        <source>The rate typed differs from that of the file: say why the file is wrong. The results record it.</source>
        <translation>Den inskrivna frekvensen avviker från filens: ange varför filen har fel. Det följer med resultaten.</translation>
    </message>
    <message>
        <source>Choose which channel is the sensor under test (DUT).</source>
        <translation>Välj vilken kanal som är givaren under provning (DUT).</translation>
    </message>
    <message>
        <source>Only one channel can be the sensor under test (DUT).</source>
        <translation>Bara en kanal kan vara givaren under provning (DUT).</translation>
    </message>
    <message>
        <source>Give the profile a name that a file can have.</source>
        <translation>Ge profilen ett namn som en fil kan ha.</translation>
    </message>
    <message>
        <source>Reading the file...</source>
        <translation>Läser filen...</translation>
    </message>
    <message>
        <source>The file can be imported.</source>
        <translation>Filen kan importeras.</translation>
    </message>
    <message>
        <source>The table has no column of samples.</source>
        <translation>Tabellen har ingen kolumn med sampel.</translation>
    </message>
    <message>
        <source>Choose which channel is the sensor under test (DUT), or tick that each column is a shot of it.</source>
        <translation>Välj vilken kanal som är givaren under provning (DUT), eller kryssa för att varje kolumn är ett skott med den.</translation>
    </message>
</context>
<context>
    <name>KeyResults</name>
    <message>
        <source>Pressure step of shot %1, the largest; in brackets the standard uncertainty u of its last digits (k = 1).</source>
        <translation>Trycksteg för skott %1, det största; inom parentes de sista siffrornas standardosäkerhet u (k = 1).</translation>
    </message>
    <message>
        <source>Pressure step: not determined yet.</source>
        <translation>Trycksteg: ännu inte bestämt.</translation>
    </message>
    <message>
        <source>Undamped natural frequency of the sensor; in brackets the standard uncertainty u of its last digits (k = 1).</source>
        <translation>Givarens odämpade egenfrekvens; inom parentes de sista siffrornas standardosäkerhet u (k = 1).</translation>
    </message>
    <message>
        <source>Damping ratio of the sensor; in brackets the standard uncertainty u of its last digits (k = 1).</source>
        <translation>Givarens dämpningsgrad; inom parentes de sista siffrornas standardosäkerhet u (k = 1).</translation>
    </message>
    <message>
        <source>Sensitivity: the level at the onset of the step over the pressure step, mean of the shots; in brackets the standard uncertainty u of its last digits (k = 1), where that of the step is known.</source>
        <translation>Känslighet: nivån vid stegets början genom trycksteget, medelvärde över skotten; inom parentes de sista siffrornas standardosäkerhet u (k = 1), där stegets är känd.</translation>
    </message>
</context>
<context>
    <name>KnownWords</name>
    <message>
        <source>static</source>
        <translation>statiskt</translation>
    </message>
    <message>
        <source>not compared: %1</source>
        <translation>inte jämfört: %1</translation>
    </message>
    <message>
        <source>agrees, joined</source>
        <translation>stämmer, förenat</translation>
    </message>
    <message>
        <source>differs, not joined</source>
        <translation>avviker, inte förenat</translation>
    </message>
    <message>
        <source>%1, %2: %3 (k = 2)</source>
        <translation>%1, %2: %3 (k = 2)</translation>
    </message>
    <message>
        <source>Of %1 values of other calibrations %2 agree with this one within U.</source>
        <translation>Av %1 värden från andra kalibreringar stämmer %2 med denna inom U.</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrering</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frekvens</translation>
    </message>
    <message>
        <source>Its value ± U</source>
        <translation>Dess värde ± U</translation>
    </message>
    <message>
        <source>Here ± U</source>
        <translation>Här ± U</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Skillnad</translation>
    </message>
    <message>
        <source>Eₙ</source>
        <translation>Eₙ</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Utfall</translation>
    </message>
</context>
<context>
    <name>ModelTables</name>
    <message>
        <source>Shot %1</source>
        <translation>Skott %1</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>Medelvärde</translation>
    </message>
    <message>
        <source>%1 (shots %2)</source>
        <translation>%1 (skott %2)</translation>
    </message>
    <message>
        <source>Fitted to</source>
        <translation>Anpassat till</translation>
    </message>
    <message>
        <source>f₀ ± u</source>
        <translation>f₀ ± u</translation>
    </message>
    <message>
        <source>ζ ± u</source>
        <translation>ζ ± u</translation>
    </message>
    <message>
        <source>Plateau ± u</source>
        <translation>Platå ± u</translation>
    </message>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mod</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Skott</translation>
    </message>
    <message>
        <source>f ± u</source>
        <translation>f ± u</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitud</translation>
    </message>
    <message>
        <source>FIT %1 %</source>
        <translation>FIT %1 %</translation>
    </message>
    <message>
        <source>plateau %1</source>
        <translation>platå %1</translation>
    </message>
    <message>
        <source>Sensor, modes left in</source>
        <translation>Givaren, moderna kvar</translation>
    </message>
    <message>
        <source>Sensor, modes taken out</source>
        <translation>Givaren, moderna borttagna</translation>
    </message>
    <message>
        <source>2nd order</source>
        <translation>2:a ordningen</translation>
    </message>
    <message>
        <source>Value ± u</source>
        <translation>Värde ± u</translation>
    </message>
    <message>
        <source>f₀</source>
        <translation>f₀</translation>
    </message>
    <message>
        <source>ζ</source>
        <translation>ζ</translation>
    </message>
    <message>
        <source>FIT</source>
        <translation>FIT</translation>
    </message>
    <message>
        <source>Plateau, %1</source>
        <translation>Platå, %1</translation>
    </message>
    <message>
        <source>The shots share their poles (p %1).</source>
        <translation>Skotten har gemensamma poler (p %1).</translation>
    </message>
    <message>
        <source>The shots do not share the pole at %1 (p %2); the uncertainty is their scatter.</source>
        <translation>Skotten har inte polen vid %1 gemensam (p %2); osäkerheten är deras spridning.</translation>
    </message>
    <message>
        <source>2nd order (the model)</source>
        <translation>2:a ordningen (modellen)</translation>
    </message>
</context>
<context>
    <name>ModelText</name>
    <message>
        <source>sensor</source>
        <translation>givare</translation>
    </message>
    <message>
        <source>step</source>
        <translation>steg</translation>
    </message>
    <message>
        <source>Nyquist</source>
        <translation>Nyquist</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instabil</translation>
    </message>
    <message>
        <source>other</source>
        <translation>övrig</translation>
    </message>
    <message>
        <source>diverges</source>
        <translation>divergerar</translation>
    </message>
    <message>
        <source>&lt; 0 % of attainable %1 %</source>
        <translation>&lt; 0 % av uppnåeliga %1 %</translation>
    </message>
    <message>
        <source>%1 % of attainable %2 %</source>
        <translation>%1 % av uppnåeliga %2 %</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frekvens</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klass</translation>
    </message>
    <message>
        <source>u(f)</source>
        <translation>u(f)</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>Relativ dämpning</translation>
    </message>
    <message>
        <source>u(ζ)</source>
        <translation>u(ζ)</translation>
    </message>
    <message>
        <source>Flags</source>
        <translation>Flaggor</translation>
    </message>
    <message>
        <source> (pair)</source>
        <translation> (par)</translation>
    </message>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitud</translation>
    </message>
    <message>
        <source>the step itself</source>
        <translation>själva steget</translation>
    </message>
    <message>
        <source>from sampling</source>
        <translation>av samplingen</translation>
    </message>
    <message>
        <source>grows</source>
        <translation>växer</translation>
    </message>
    <message>
        <source>below the noise</source>
        <translation>under bruset</translation>
    </message>
    <message>
        <source>differs between the shots</source>
        <translation>skiljer mellan skotten</translation>
    </message>
    <message>
        <source>tube mode?</source>
        <translation>rörmod?</translation>
    </message>
    <message>
        <source>nearly cancelled by a zero</source>
        <translation>nästan upphävd av ett nollställe</translation>
    </message>
    <message>
        <source>as slow as a drift</source>
        <translation>långsam som en drift</translation>
    </message>
    <message>
        <source>white</source>
        <translation>vit</translation>
    </message>
    <message>
        <source>%1, of the residual</source>
        <translation>%1, av residualen</translation>
    </message>
    <message>
        <source>%1 % of attainable %2 %: at the noise limit</source>
        <translation>%1 % av uppnåeliga %2 %: vid brusgränsen</translation>
    </message>
    <message>
        <source>u(amplitude)</source>
        <translation>u(amplitud)</translation>
    </message>
</context>
<context>
    <name>NextSteps</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>reasons for %n caution(s)</source>
        <translation>
            <numerusform>motivering för %n varning</numerusform>
            <numerusform>motiveringar för %n varningar</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Plots</name>
    <message>
        <source>Explained by the first components</source>
        <translation>Förklarad andel, de första komponenterna</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Komponenter</translation>
    </message>
    <message>
        <source>Explained, cumulative</source>
        <translation>Förklarad andel, kumulativ</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>One shot only: there are no components to compare.</source>
        <translation>Endast ett skott: det finns inga komponenter att jämföra.</translation>
    </message>
    <message>
        <source>The first component explains %1 %.</source>
        <translation>Den första komponenten förklarar %1 %.</translation>
    </message>
    <message>
        <source>Reconstructed; components kept: %1</source>
        <translation>Rekonstruerade svar; behållna komponenter: %1</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Residualer</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Residual</translation>
    </message>
    <message>
        <source>What the components leave of each shot.</source>
        <translation>Det som komponenterna lämnar kvar av varje skott.</translation>
    </message>
    <message>
        <source>Lag</source>
        <translation>Tidsförskjutning</translation>
    </message>
    <message>
        <source>Autocovariance, normalised</source>
        <translation>Autokovarians, normerad</translation>
    </message>
    <message>
        <source>Autocovariance of the residuals with the bounds of white noise.</source>
        <translation>Residualernas autokovarians med gränserna för vitt brus.</translation>
    </message>
    <message>
        <source>Power spectrum of the residuals</source>
        <translation>Residualernas effektspektrum</translation>
    </message>
    <message>
        <source>Power spectral density</source>
        <translation>Effektspektraltäthet</translation>
    </message>
    <message>
        <source>Power spectra of the residuals; the strongest maximum of each shot is marked.</source>
        <translation>Residualernas effektspektra; det starkaste maximumet i varje skott är markerat.</translation>
    </message>
    <message>
        <source>Average of the reconstructions</source>
        <translation>Medelvärde av rekonstruktionerna</translation>
    </message>
    <message>
        <source>low</source>
        <translation>låg</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>medel</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hög</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>Medelvärde</translation>
    </message>
    <message>
        <source>Shot %1</source>
        <translation>Skott %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frekvens</translation>
    </message>
    <message>
        <source>Response, remapped</source>
        <translation>Svar, omskalat</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Svar</translation>
    </message>
    <message>
        <source>Model of order %1</source>
        <translation>Modell av ordning %1</translation>
    </message>
    <message>
        <source>Poles of the sensor</source>
        <translation>Givarens poler</translation>
    </message>
    <message>
        <source>Pole of the step</source>
        <translation>Stegets pol</translation>
    </message>
    <message>
        <source>Unstable poles</source>
        <translation>Instabila poler</translation>
    </message>
    <message>
        <source>Poles at the Nyquist frequency</source>
        <translation>Poler vid Nyquistfrekvensen</translation>
    </message>
    <message>
        <source>Other poles</source>
        <translation>Övriga poler</translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation>undre gräns</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>övre gräns</translation>
    </message>
    <message>
        <source>± 2u</source>
        <translation>± 2u</translation>
    </message>
    <message>
        <source>Non-parametric</source>
        <translation>Icke-parametrisk</translation>
    </message>
    <message>
        <source>Data and model of order %1: diverges</source>
        <translation>Data och modell av ordning %1: divergerar</translation>
    </message>
    <message>
        <source>Data and model of order %1</source>
        <translation>Data och modell av ordning %1</translation>
    </message>
    <message>
        <source>Data and model of order %1; the fit is %2 %.</source>
        <translation>Data och modell av ordning %1; anpassningen är %2 %.</translation>
    </message>
    <message>
        <source>Data minus model</source>
        <translation>Data minus modell</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fel</translation>
    </message>
    <message>
        <source>Poles and zeros, order %1</source>
        <translation>Poler och nollställen, ordning %1</translation>
    </message>
    <message>
        <source>Real part</source>
        <translation>Realdel</translation>
    </message>
    <message>
        <source>Imaginary part</source>
        <translation>Imaginärdel</translation>
    </message>
    <message>
        <source>Zeros</source>
        <translation>Nollställen</translation>
    </message>
    <message>
        <source>poles: %1, zeros: %2</source>
        <translation>poler: %1, nollställen: %2</translation>
    </message>
    <message>
        <source>further out than shown: %1</source>
        <translation>utanför det visade området: %1</translation>
    </message>
    <message>
        <source>Frequency response, magnitude</source>
        <translation>Frekvenssvar, belopp</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Belopp</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Magnitude of the frequency response; usable from %1 to %2.</source>
        <translation>Frekvenssvarets belopp; användbart från %1 till %2.</translation>
    </message>
    <message>
        <source>Frequency response, phase</source>
        <translation>Frekvenssvar, fas</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Fas</translation>
    </message>
    <message>
        <source>Phase of the frequency response, output over input, lag negative.</source>
        <translation>Frekvenssvarets fas, utsignal relativt insignal, eftersläpning negativ.</translation>
    </message>
    <message>
        <source>Step response of the model</source>
        <translation>Modellens stegsvar</translation>
    </message>
    <message>
        <source>Step response of the model: diverges</source>
        <translation>Modellens stegsvar: divergerar</translation>
    </message>
    <message>
        <source>Suggested: %1</source>
        <translation>Föreslagen: %1</translation>
    </message>
    <message>
        <source>Model input</source>
        <translation>Modellindata</translation>
    </message>
    <message>
        <source>Full rate</source>
        <translation>Full samplingsfrekvens</translation>
    </message>
    <message>
        <source>Model input; samples in each series: %1.</source>
        <translation>Modellindata; antal sampel i varje serie: %1.</translation>
    </message>
    <message>
        <source>Singular values</source>
        <translation>Singulärvärden</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordning</translation>
    </message>
    <message>
        <source>Singular value</source>
        <translation>Singulärvärde</translation>
    </message>
    <message>
        <source>Belongs to the step</source>
        <translation>Hör till steget</translation>
    </message>
    <message>
        <source>Singular values: %1; suggested order: %2.</source>
        <translation>Singulärvärden: %1; föreslagen ordning: %2.</translation>
    </message>
    <message>
        <source>Bayesian information criterion</source>
        <translation>Bayesianskt informationskriterium</translation>
    </message>
    <message>
        <source>BIC</source>
        <translation>BIC</translation>
    </message>
    <message>
        <source>BIC of orders 1 to %1; the smallest is best.</source>
        <translation>BIC för ordning 1 till %1; det minsta är bäst.</translation>
    </message>
    <message>
        <source>The BIC could not be formed for these data.</source>
        <translation>BIC kunde inte beräknas för dessa data.</translation>
    </message>
    <message>
        <source>Sensor under test</source>
        <translation>Givare under provning</translation>
    </message>
    <message>
        <source>Side wall, driven section</source>
        <translation>Sidovägg, lågtrycksdelen</translation>
    </message>
    <message>
        <source>Driver section</source>
        <translation>Högtrycksdelen</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigg</translation>
    </message>
    <message>
        <source>Other channel</source>
        <translation>Annan kanal</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>%1; recordings: %2.</source>
        <translation>%1; registreringar: %2.</translation>
    </message>
    <message>
        <source>Responses, aligned at the start</source>
        <translation>Svar, inpassade efter starten</translation>
    </message>
    <message>
        <source>Responses aligned at the start; shots: %1.</source>
        <translation>Svar inpassade efter starten; skott: %1.</translation>
    </message>
    <message>
        <source>Start of the responses</source>
        <translation>Svarens start</translation>
    </message>
    <message>
        <source>The first moments of the responses; shots: %1.</source>
        <translation>Svarens första ögonblick; skott: %1.</translation>
    </message>
    <message>
        <source>Power spectrum</source>
        <translation>Effektspektrum</translation>
    </message>
    <message>
        <source>Power spectrum; no resonance found.</source>
        <translation>Effektspektrum; ingen resonans hittad.</translation>
    </message>
    <message>
        <source>Power spectrum; main resonance at %1.</source>
        <translation>Effektspektrum; huvudresonans vid %1.</translation>
    </message>
    <message>
        <source>Autocovariance; dotted: white noise</source>
        <translation>Autokovarians; prickat: vitt brus</translation>
    </message>
    <message>
        <source>All values</source>
        <translation>Alla värden</translation>
    </message>
    <message>
        <source>Order %1</source>
        <translation>Ordning %1</translation>
    </message>
    <message>
        <source>Residual autocorrelation; dotted: white noise</source>
        <translation>Residualens autokorrelation; prickat: vitt brus</translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation>Autokorrelation</translation>
    </message>
    <message>
        <source>Autocorrelation of data minus model with the bounds of white noise.</source>
        <translation>Autokorrelation för data minus modell med gränserna för vitt brus.</translation>
    </message>
    <message>
        <source>2nd-order sensor</source>
        <translation>Givare av 2:a ordningen</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Ny</translation>
    </message>
    <message>
        <source>Unstable</source>
        <translation>Instabil</translation>
    </message>
    <message>
        <source>order %1</source>
        <translation>ordning %1</translation>
    </message>
    <message>
        <source>Stabilisation: poles of all orders</source>
        <translation>Stabilisering: poler för alla ordningar</translation>
    </message>
    <message>
        <source>No order has an oscillating pole.</source>
        <translation>Ingen ordning har en svängande pol.</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>FIT and criteria over the order</source>
        <translation>FIT och kriterier över ordningen</translation>
    </message>
    <message>
        <source>FIT</source>
        <translation>FIT</translation>
    </message>
    <message>
        <source>attainable %1 %</source>
        <translation>uppnåeligt %1 %</translation>
    </message>
    <message>
        <source>shock</source>
        <translation>stötvåg</translation>
    </message>
    <message>
        <source>reflected</source>
        <translation>reflekterad</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>kontaktyta</translation>
    </message>
    <message>
        <source>its echo</source>
        <translation>dess eko</translation>
    </message>
    <message>
        <source>expansion head</source>
        <translation>expansionens front</translation>
    </message>
    <message>
        <source>expansion tail</source>
        <translation>expansionens slut</translation>
    </message>
    <message>
        <source>plateau</source>
        <translation>platå</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>sedd</translation>
    </message>
    <message>
        <source>end wall</source>
        <translation>ändvägg</translation>
    </message>
    <message>
        <source>mix</source>
        <comment>tube mode</comment>
        <translation>bland.</translation>
    </message>
    <message>
        <source>Waves in the tube, shot %1</source>
        <translation>Vågor i röret, skott %1</translation>
    </message>
    <message>
        <source>Distance from the diaphragm</source>
        <translation>Avstånd från membranet</translation>
    </message>
    <message>
        <source>No diagram: the tube&apos;s lengths or the velocity are unknown.</source>
        <translation>Inget diagram: rörets längder eller hastigheten är okända.</translation>
    </message>
    <message>
        <source>diaphragm</source>
        <translation>membran</translation>
    </message>
    <message>
        <source>Waves in the tube; the plateau at the end wall lasts %1.</source>
        <translation>Vågor i röret; platån vid ändväggen varar %1.</translation>
    </message>
    <message>
        <source>Arrival at %1, shot %2</source>
        <translation>Ankomst vid %1, skott %2</translation>
    </message>
    <message>
        <source>before</source>
        <translation>före</translation>
    </message>
    <message>
        <source>50 %</source>
        <translation>50 %</translation>
    </message>
    <message>
        <source>behind the shock</source>
        <translation>bakom stötvågen</translation>
    </message>
    <message>
        <source>driver gas (computed)</source>
        <translation>drivgas (beräknad)</translation>
    </message>
    <message>
        <source>plateau ends (computed)</source>
        <translation>platån slutar (beräknat)</translation>
    </message>
    <message>
        <source> – tube modes computed</source>
        <translation> – beräknade rörmoder</translation>
    </message>
    <message>
        <source>f stable</source>
        <translation>f stabil</translation>
    </message>
    <message>
        <source>f, ζ stable</source>
        <translation>f, ζ stabila</translation>
    </message>
    <message>
        <source>Poles of orders 1 to %1: %2, of which stable: %3. f stable: the frequency was there at the order before; f, ζ stable: the damping ratio, too; new: neither; behind them the mean spectrum.</source>
        <translation>Poler för ordning 1 till %1: %2, varav stabila: %3. f stabil: frekvensen fanns vid ordningen före; f, ζ stabila: även dämpkvoten; ny: ingetdera; bakom dem medelspektrumet.</translation>
    </message>
    <message>
        <source>Left-out error</source>
        <translation>Fel för utelämnat</translation>
    </message>
    <message>
        <source>FIT, error of each shot by the poles of the others, and information criterion (BIC) of every order; order %1 is chosen.</source>
        <translation>FIT, felet för varje skott med de andras poler samt informationskriterium (BIC) för varje ordning; ordning %1 är vald.</translation>
    </message>
    <message>
        <source>Noise: median to 95 %</source>
        <translation>Brus: median till 95 %</translation>
    </message>
    <message>
        <source>Response in %1</source>
        <translation>Svar i %1</translation>
    </message>
    <message>
        <source>Left by the first components</source>
        <translation>Kvar efter de första komponenterna</translation>
    </message>
    <message>
        <source>Not explained</source>
        <translation>Ej förklarat</translation>
    </message>
    <message>
        <source>5 %</source>
        <translation>5 %</translation>
    </message>
    <message>
        <source>The first component leaves %1 %.</source>
        <translation>Den första komponenten lämnar %1 %.</translation>
    </message>
    <message>
        <source>Non-parametric values withheld: %1 of %2; results and findings say why.</source>
        <translation>Icke-parametriska värden som inte anges: %1 av %2; resultat och anmärkningar säger varför.</translation>
    </message>
    <message>
        <source>Magnitude of the frequency response; its expanded uncertainty is not known.</source>
        <translation>Frekvenssvarets belopp; dess utvidgade osäkerhet är inte känd.</translation>
    </message>
    <message>
        <source>Magnitude of the frequency response; U is %1 to %2 of it.</source>
        <translation>Frekvenssvarets belopp; U är %1 till %2 av det.</translation>
    </message>
    <message>
        <source>Frequency response with its expanded uncertainty U</source>
        <translation>Frekvenssvaret med dess utvidgade osäkerhet U</translation>
    </message>
    <message>
        <source>± U</source>
        <translation>± U</translation>
    </message>
    <message>
        <source>U, relative</source>
        <translation>U, relativt</translation>
    </message>
    <message>
        <source>U, what if</source>
        <translation>U, prövat</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>budget</source>
        <translation>budget</translation>
    </message>
    <message>
        <source>Reference transducer</source>
        <translation>Referensgivare</translation>
    </message>
    <message>
        <source>Magnitude against the reference transducer; the pressure step is not known well enough to compare.</source>
        <translation>Belopp mot referensgivaren; trycksteget är inte tillräckligt känt för att jämföra.</translation>
    </message>
    <message>
        <source>Magnitude against the reference transducer and against the pressure step; these differ by %1 on the mean.</source>
        <translation>Belopp mot referensgivaren och mot trycksteget; de skiljer sig med %1 i medeltal.</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>gräns</translation>
    </message>
    <message>
        <source>Magnitude against reference transducer and pressure step</source>
        <translation>Belopp mot referensgivare och trycksteg</translation>
    </message>
    <message>
        <source>Pressure step</source>
        <translation>Trycksteg</translation>
    </message>
    <message>
        <source>%1, ± U</source>
        <translation>%1, ± U</translation>
    </message>
    <message>
        <source>Step less transducer, over the U of the difference</source>
        <translation>Steg minus referensgivare, genom skillnadens U</translation>
    </message>
    <message>
        <source>Eₙ</source>
        <translation>Eₙ</translation>
    </message>
    <message>
        <source>Eₙ over frequency; beyond ±1 at %1 of %2 frequencies.</source>
        <translation>Eₙ över frekvens; utanför ±1 vid %1 av %2 frekvenser.</translation>
    </message>
    <message>
        <source>Both magnitudes less their mean</source>
        <translation>Båda beloppen minus deras medelvärde</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Avvikelse</translation>
    </message>
    <message>
        <source>This calibration</source>
        <translation>Denna kalibrering</translation>
    </message>
    <message>
        <source>Other calibrations</source>
        <translation>Andra kalibreringar</translation>
    </message>
    <message>
        <source>static</source>
        <translation>statiskt</translation>
    </message>
    <message>
        <source>S(f) beside %1 values of other calibrations; %2 agree within U.</source>
        <translation>S(f) bredvid %1 värden från andra kalibreringar; %2 stämmer inom U.</translation>
    </message>
    <message>
        <source>Magnitude and values of other calibrations</source>
        <translation>Belopp och värden från andra kalibreringar</translation>
    </message>
    <message>
        <source>Less the sensitivity at the onset</source>
        <translation>Minus känsligheten vid stegets början</translation>
    </message>
    <message>
        <source>Pressure behind the recording</source>
        <translation>Trycket bakom registreringen</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Tryck</translation>
    </message>
    <message>
        <source>%1, upper end of 95 %</source>
        <translation>%1, övre gräns för 95 %</translation>
    </message>
    <message>
        <source>%1, lower end of 95 %</source>
        <translation>%1, undre gräns för 95 %</translation>
    </message>
    <message>
        <source>Pressure up to %1 with its band of 95 %; recordings: %2.</source>
        <translation>Tryck upp till %1 med sitt band för 95 %; registreringar: %2.</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>medelvärde</translation>
    </message>
    <message>
        <source>warning limit</source>
        <translation>varningsgräns</translation>
    </message>
    <message>
        <source>action limit</source>
        <translation>åtgärdsgräns</translation>
    </message>
    <message>
        <source>Year</source>
        <translation>År</translation>
    </message>
    <message>
        <source>Calibrations</source>
        <translation>Kalibreringar</translation>
    </message>
    <message>
        <source>Conspicuous</source>
        <translation>Avvikande</translation>
    </message>
    <message>
        <source>%1 of a sensor over time, with U; %2 of %3 calibrations are conspicuous.</source>
        <translation>%1 hos en givare över tid, med U; %2 av %3 kalibreringar avviker.</translation>
    </message>
    <message>
        <source>final value</source>
        <translation>slutvärde</translation>
    </message>
    <message>
        <source>final value + overshoot</source>
        <translation>slutvärde + översväng</translation>
    </message>
    <message>
        <source>Model, from its own onset</source>
        <translation>Modell, från sin egen start</translation>
    </message>
</context>
<context>
    <name>Prompts</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Osparade ändringar</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved. Save them?</source>
        <translation>%1 har ändringar som inte är sparade. Ska de sparas?</translation>
    </message>
    <message>
        <source>Dyncal</source>
        <translation>Dyncal</translation>
    </message>
    <message>
        <source>Project changed</source>
        <translation>Projektet har ändrats</translation>
    </message>
    <message>
        <source>%1 was changed by another window or program since it was opened or saved here. Replacing it loses those changes.</source>
        <translation>%1 har ändrats av ett annat fönster eller program sedan den öppnades eller sparades här. Om den ersätts går de ändringarna förlorade.</translation>
    </message>
    <message>
        <source>%1 was removed or moved since it was opened or saved here.</source>
        <translation>%1 har tagits bort eller flyttats sedan den öppnades eller sparades här.</translation>
    </message>
    <message>
        <source>Save under another name...</source>
        <translation>Spara under ett annat namn...</translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation>Ersätt den</translation>
    </message>
    <message>
        <source>Save it there again</source>
        <translation>Spara den där igen</translation>
    </message>
    <message>
        <source>Recordings missing</source>
        <translation>Registreringar saknas</translation>
    </message>
    <message>
        <source>Locate...</source>
        <translation>Leta upp...</translation>
    </message>
    <message>
        <source>View kept results</source>
        <translation>Visa sparade resultat</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>diverges</source>
        <translation>divergerar</translation>
    </message>
    <message>
        <source>waits for all singular values</source>
        <translation>väntar på alla singulärvärden</translation>
    </message>
</context>
<context>
    <name>RecipeLabel</name>
    <message>
        <source>kind of file</source>
        <translation>filens slag</translation>
    </message>
    <message>
        <source>import settings</source>
        <translation>importinställningar</translation>
    </message>
    <message>
        <source>file format</source>
        <translation>filformat</translation>
    </message>
    <message>
        <source>columns of the text file</source>
        <translation>textfilens kolumner</translation>
    </message>
    <message>
        <source>column of the times</source>
        <translation>tidernas kolumn</translation>
    </message>
    <message>
        <source>column of the DUT</source>
        <translation>DUT:s kolumn</translation>
    </message>
    <message>
        <source>column of the driven-side sensor</source>
        <translation>sidogivarens kolumn</translation>
    </message>
    <message>
        <source>column of the driver pressure</source>
        <translation>drivtryckets kolumn</translation>
    </message>
    <message>
        <source>column of the trigger</source>
        <translation>triggerns kolumn</translation>
    </message>
    <message>
        <source>column of another channel</source>
        <translation>en annan kanals kolumn</translation>
    </message>
    <message>
        <source>channel roles</source>
        <translation>kanalroller</translation>
    </message>
    <message>
        <source>role of the channel</source>
        <translation>kanalens roll</translation>
    </message>
    <message>
        <source>unit of the channel</source>
        <translation>kanalens enhet</translation>
    </message>
    <message>
        <source>factor on the channel</source>
        <translation>kanalens faktor</translation>
    </message>
    <message>
        <source>gain of the channel</source>
        <translation>kanalens förstärkning</translation>
    </message>
    <message>
        <source>sensitivity of the channel</source>
        <translation>kanalens känslighet</translation>
    </message>
    <message>
        <source>inverted polarity of the channel</source>
        <translation>kanalens inverterade polaritet</translation>
    </message>
    <message>
        <source>gauge or absolute pressure of the channel</source>
        <translation>kanalens över- eller absoluttryck</translation>
    </message>
    <message>
        <source>decimal mark</source>
        <translation>decimaltecken</translation>
    </message>
    <message>
        <source>separator</source>
        <translation>avskiljare</translation>
    </message>
    <message>
        <source>sample rate</source>
        <translation>samplingsfrekvens</translation>
    </message>
    <message>
        <source>why the rate in the file is wrong</source>
        <translation>varför filens samplingsfrekvens är fel</translation>
    </message>
    <message>
        <source>unit of the DUT</source>
        <translation>DUT:s enhet</translation>
    </message>
    <message>
        <source>factor on the DUT</source>
        <translation>DUT:s faktor</translation>
    </message>
    <message>
        <source>inverted polarity</source>
        <translation>inverterad polaritet</translation>
    </message>
    <message>
        <source>gauge or absolute pressure</source>
        <translation>över- eller absoluttryck</translation>
    </message>
    <message>
        <source>rows before the data</source>
        <translation>rader före data</translation>
    </message>
    <message>
        <source>longest gap to be filled</source>
        <translation>längsta lucka som fylls</translation>
    </message>
    <message>
        <source>memory that a file may take</source>
        <translation>minne som en fil får ta</translation>
    </message>
    <message>
        <source>files joined as channels</source>
        <translation>filer förenade som kanaler</translation>
    </message>
    <message>
        <source>levels of the shots</source>
        <translation>skottens nivåer</translation>
    </message>
    <message>
        <source>excluded shots</source>
        <translation>uteslutna skott</translation>
    </message>
    <message>
        <source>excluded shot</source>
        <translation>uteslutet skott</translation>
    </message>
    <message>
        <source>reason for the exclusion</source>
        <translation>skäl för uteslutningen</translation>
    </message>
    <message>
        <source>import settings of single files</source>
        <translation>importinställningar för enskilda filer</translation>
    </message>
    <message>
        <source>limits of findings</source>
        <translation>gränser för iakttagelser</translation>
    </message>
    <message>
        <source>equal samples that count as saturation</source>
        <translation>lika sampel som räknas som mättnad</translation>
    </message>
    <message>
        <source>scatter below which a channel is flat</source>
        <translation>spridning under vilken en kanal är platt</translation>
    </message>
    <message>
        <source>codes that a step should use</source>
        <translation>koder som ett steg bör använda</translation>
    </message>
    <message>
        <source>noise by which a step must stand out</source>
        <translation>brus som ett steg måste överstiga</translation>
    </message>
    <message>
        <source>difference allowed between two sample rates</source>
        <translation>tillåten skillnad mellan två samplingsfrekvenser</translation>
    </message>
    <message>
        <source>factor allowed between read and computed step</source>
        <translation>tillåten faktor mellan avläst och beräknat steg</translation>
    </message>
    <message>
        <source>reference step</source>
        <translation>referenssteg</translation>
    </message>
    <message>
        <source>compute the step from the shock</source>
        <translation>beräkna steget ur stötvågen</translation>
    </message>
    <message>
        <source>p1, absolute</source>
        <translation>p1, absolut</translation>
    </message>
    <message>
        <source>T1</source>
        <translation>T1</translation>
    </message>
    <message>
        <source>T4 (driver)</source>
        <translation>T4 (drivgas)</translation>
    </message>
    <message>
        <source>driven gas</source>
        <translation>gas i lågtrycksdelen</translation>
    </message>
    <message>
        <source>γ of the driven gas</source>
        <translation>γ för gasen i lågtrycksdelen</translation>
    </message>
    <message>
        <source>molar mass of the driven gas</source>
        <translation>molmassa för gasen i lågtrycksdelen</translation>
    </message>
    <message>
        <source>substance of the driven gas</source>
        <translation>ämnet i lågtrycksdelen</translation>
    </message>
    <message>
        <source>heat capacity of the driven gas</source>
        <translation>värmekapacitet för gasen i lågtrycksdelen</translation>
    </message>
    <message>
        <source>driver gas</source>
        <translation>drivgas</translation>
    </message>
    <message>
        <source>γ of the driver gas</source>
        <translation>drivgasens γ</translation>
    </message>
    <message>
        <source>molar mass of the driver gas</source>
        <translation>drivgasens molmassa</translation>
    </message>
    <message>
        <source>substance of the driver gas</source>
        <translation>drivgasens ämne</translation>
    </message>
    <message>
        <source>heat capacity of the driver gas</source>
        <translation>drivgasens värmekapacitet</translation>
    </message>
    <message>
        <source>relative humidity</source>
        <translation>relativ fuktighet</translation>
    </message>
    <message>
        <source>velocity of the shock</source>
        <translation>stötvågens hastighet</translation>
    </message>
    <message>
        <source>pressure step</source>
        <translation>trycksteg</translation>
    </message>
    <message>
        <source>arrival sensors</source>
        <translation>ankomstgivare</translation>
    </message>
    <message>
        <source>channel of the arrival sensor</source>
        <translation>ankomstgivarens kanal</translation>
    </message>
    <message>
        <source>distance to end wall</source>
        <translation>avstånd till ändvägg</translation>
    </message>
    <message>
        <source>u (distance)</source>
        <translation>u (avstånd)</translation>
    </message>
    <message>
        <source>arrival</source>
        <translation>ankomst</translation>
    </message>
    <message>
        <source>u (arrival)</source>
        <translation>u (ankomst)</translation>
    </message>
    <message>
        <source>delay of the sensor</source>
        <translation>givarens fördröjning</translation>
    </message>
    <message>
        <source>u (delay)</source>
        <translation>u (fördröjning)</translation>
    </message>
    <message>
        <source>driver section</source>
        <translation>högtrycksdel</translation>
    </message>
    <message>
        <source>driven section</source>
        <translation>lågtrycksdel</translation>
    </message>
    <message>
        <source>inner diameter</source>
        <translation>innerdiameter</translation>
    </message>
    <message>
        <source>place of the DUT</source>
        <translation>DUT:s plats</translation>
    </message>
    <message>
        <source>duration of the front</source>
        <translation>frontens varaktighet</translation>
    </message>
    <message>
        <source>u (duration of the front)</source>
        <translation>u (frontens varaktighet)</translation>
    </message>
    <message>
        <source>what the state follows from</source>
        <translation>vad tillståndet följer av</translation>
    </message>
    <message>
        <source>p2, absolute</source>
        <translation>p2, absolut</translation>
    </message>
    <message>
        <source>driver pressure, absolute</source>
        <translation>drivtryck, absolut</translation>
    </message>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>counters</source>
        <translation>räknare</translation>
    </message>
    <message>
        <source>far place of the counter</source>
        <translation>räknarens bortre plats</translation>
    </message>
    <message>
        <source>near place of the counter</source>
        <translation>räknarens närmare plats</translation>
    </message>
    <message>
        <source>time of the counter</source>
        <translation>räknarens tid</translation>
    </message>
    <message>
        <source>u (length of the counter)</source>
        <translation>u (räknarens längd)</translation>
    </message>
    <message>
        <source>u (time of the counter)</source>
        <translation>u (räknarens tid)</translation>
    </message>
    <message>
        <source>change of the velocity along the tube</source>
        <translation>hastighetens ändring längs röret</translation>
    </message>
    <message>
        <source>use the arrival at the DUT</source>
        <translation>använd ankomsten till DUT</translation>
    </message>
    <message>
        <source>distance of the DUT to the end wall</source>
        <translation>DUT:s avstånd till ändväggen</translation>
    </message>
    <message>
        <source>diameter of the DUT</source>
        <translation>DUT:s diameter</translation>
    </message>
    <message>
        <source>length of the tube</source>
        <translation>rörets längd</translation>
    </message>
    <message>
        <source>sound speed of the wall</source>
        <translation>väggens ljudhastighet</translation>
    </message>
    <message>
        <source>guard before the plateau&apos;s end</source>
        <translation>marginal före platåns slut</translation>
    </message>
    <message>
        <source>window</source>
        <translation>fönster</translation>
    </message>
    <message>
        <source>start</source>
        <translation>start</translation>
    </message>
    <message>
        <source>baseline</source>
        <translation>baslinje</translation>
    </message>
    <message>
        <source>end of the window</source>
        <translation>fönstrets slut</translation>
    </message>
    <message>
        <source>settle band</source>
        <translation>slutnivåns band</translation>
    </message>
    <message>
        <source>stretches left out of the fit</source>
        <translation>sträckor utelämnade ur anpassningen</translation>
    </message>
    <message>
        <source>shot of the stretch</source>
        <translation>sträckans skott</translation>
    </message>
    <message>
        <source>begin of the stretch</source>
        <translation>sträckans början</translation>
    </message>
    <message>
        <source>end of the stretch</source>
        <translation>sträckans slut</translation>
    </message>
    <message>
        <source>reason for leaving the stretch out</source>
        <translation>skäl att utelämna sträckan</translation>
    </message>
    <message>
        <source>remap to 0..1</source>
        <translation>skala om till 0..1</translation>
    </message>
    <message>
        <source>spectrum</source>
        <translation>spektrum</translation>
    </message>
    <message>
        <source>window function</source>
        <translation>fönsterfunktion</translation>
    </message>
    <message>
        <source>estimator</source>
        <translation>estimator</translation>
    </message>
    <message>
        <source>segment length</source>
        <translation>segmentlängd</translation>
    </message>
    <message>
        <source>trend taken off</source>
        <translation>borttagen trend</translation>
    </message>
    <message>
        <source>band of the search</source>
        <translation>sökningens band</translation>
    </message>
    <message>
        <source>resonance</source>
        <translation>resonans</translation>
    </message>
    <message>
        <source>principal components</source>
        <translation>principalkomponenter</translation>
    </message>
    <message>
        <source>components kept</source>
        <translation>behållna komponenter</translation>
    </message>
    <message>
        <source>subtract the mean</source>
        <translation>dra bort medelvärdet</translation>
    </message>
    <message>
        <source>lags</source>
        <translation>tidsförskjutningar</translation>
    </message>
    <message>
        <source>confidence of the bound</source>
        <translation>gränsens konfidensgrad</translation>
    </message>
    <message>
        <source>model input</source>
        <translation>modellens indata</translation>
    </message>
    <message>
        <source>rate of the model input</source>
        <translation>modellindatas samplingsfrekvens</translation>
    </message>
    <message>
        <source>samples of the model input</source>
        <translation>modellindatas sampel</translation>
    </message>
    <message>
        <source>offset of the model input</source>
        <translation>modellindatas förskjutning</translation>
    </message>
    <message>
        <source>how shots are combined</source>
        <translation>hur skott sammanförs</translation>
    </message>
    <message>
        <source>what the response is taken for</source>
        <translation>vad svaret tas för</translation>
    </message>
    <message>
        <source>realisation</source>
        <translation>realisering</translation>
    </message>
    <message>
        <source>order</source>
        <translation>ordning</translation>
    </message>
    <message>
        <source>orders offered</source>
        <translation>ordningar att välja bland</translation>
    </message>
    <message>
        <source>Hankel rows</source>
        <translation>Hankelrader</translation>
    </message>
    <message>
        <source>refine the poles</source>
        <translation>förfina polerna</translation>
    </message>
    <message>
        <source>nuisance modes</source>
        <translation>störmoder</translation>
    </message>
    <message>
        <source>frequency of the nuisance mode</source>
        <translation>störmodens frekvens</translation>
    </message>
    <message>
        <source>shot of the nuisance mode</source>
        <translation>störmodens skott</translation>
    </message>
    <message>
        <source>kind of the nuisance mode</source>
        <translation>störmodens slag</translation>
    </message>
    <message>
        <source>label of the nuisance mode</source>
        <translation>störmodens benämning</translation>
    </message>
    <message>
        <source>reason for the nuisance mode</source>
        <translation>skäl för störmoden</translation>
    </message>
    <message>
        <source>stable frequency</source>
        <translation>stabil frekvens</translation>
    </message>
    <message>
        <source>stable damping</source>
        <translation>stabil dämpning</translation>
    </message>
    <message>
        <source>pinned orders</source>
        <translation>fästa ordningar</translation>
    </message>
    <message>
        <source>notes on pinned orders</source>
        <translation>anteckningar om fästa ordningar</translation>
    </message>
    <message>
        <source>order of the note</source>
        <translation>anteckningens ordning</translation>
    </message>
    <message>
        <source>note</source>
        <translation>anteckning</translation>
    </message>
    <message>
        <source>reason for the order</source>
        <translation>skäl för ordningen</translation>
    </message>
    <message>
        <source>response</source>
        <translation>svar</translation>
    </message>
    <message>
        <source>frequencies of the response</source>
        <translation>svarets frekvenser</translation>
    </message>
    <message>
        <source>reference of the response</source>
        <translation>svarets referens</translation>
    </message>
    <message>
        <source>uncertainty</source>
        <translation>osäkerhet</translation>
    </message>
    <message>
        <source>uncertainty budget</source>
        <translation>osäkerhetsbudget</translation>
    </message>
    <message>
        <source>quantity of the budget</source>
        <translation>budgetens storhet</translation>
    </message>
    <message>
        <source>u of the budget</source>
        <translation>budgetens u</translation>
    </message>
    <message>
        <source>distribution of the budget</source>
        <translation>budgetens fördelning</translation>
    </message>
    <message>
        <source>degrees of freedom of the budget</source>
        <translation>budgetens frihetsgrader</translation>
    </message>
    <message>
        <source>Monte Carlo trials</source>
        <translation>Monte Carlo-försök</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>frö</translation>
    </message>
    <message>
        <source>coverage probability</source>
        <translation>täckningssannolikhet</translation>
    </message>
    <message>
        <source>acknowledged findings</source>
        <translation>kvitterade iakttagelser</translation>
    </message>
    <message>
        <source>acknowledged finding</source>
        <translation>kvitterad iakttagelse</translation>
    </message>
    <message>
        <source>shot of the acknowledged finding</source>
        <translation>den kvitterade iakttagelsens skott</translation>
    </message>
    <message>
        <source>reason of the acknowledgement</source>
        <translation>kvitteringens skäl</translation>
    </message>
    <message>
        <source>certificate</source>
        <translation>bevis</translation>
    </message>
    <message>
        <source>template of the certificate</source>
        <translation>certifikatets mall</translation>
    </message>
    <message>
        <source>languages of the certificate</source>
        <translation>certifikatets språk</translation>
    </message>
    <message>
        <source>fields of the certificate</source>
        <translation>certifikatets fält</translation>
    </message>
    <message>
        <source>shot with roles of its own</source>
        <translation>skott med egna roller</translation>
    </message>
    <message>
        <source>channel roles of one shot</source>
        <translation>kanalroller i ett skott</translation>
    </message>
    <message>
        <source>what the columns are</source>
        <translation>vad kolumnerna är</translation>
    </message>
    <message>
        <source>settings of single shots</source>
        <translation>inställningar för enskilda skott</translation>
    </message>
    <message>
        <source>range of the attenuation along the tube</source>
        <translation>område för dämpningen längs röret</translation>
    </message>
    <message>
        <source>largest Mach number of the tube</source>
        <translation>rörets största machtal</translation>
    </message>
    <message>
        <source>largest driver pressure of the tube</source>
        <translation>rörets största drivtryck</translation>
    </message>
    <message>
        <source>sensitivity of the reference</source>
        <translation>referensens känslighet</translation>
    </message>
    <message>
        <source>u of the reference&apos;s sensitivity</source>
        <translation>u för referensens känslighet</translation>
    </message>
    <message>
        <source>resonance of the reference</source>
        <translation>referensens resonans</translation>
    </message>
    <message>
        <source>u of the reference&apos;s resonance</source>
        <translation>u för referensens resonans</translation>
    </message>
    <message>
        <source>damping of the reference</source>
        <translation>referensens dämpning</translation>
    </message>
    <message>
        <source>u of the reference&apos;s damping</source>
        <translation>u för referensens dämpning</translation>
    </message>
    <message>
        <source>comparison with a reference transducer</source>
        <translation>jämförelse med en referensgivare</translation>
    </message>
    <message>
        <source>channel of the reference</source>
        <translation>referensens kanal</translation>
    </message>
    <message>
        <source>file of the reference</source>
        <translation>referensens fil</translation>
    </message>
    <message>
        <source>hash of the reference&apos;s file</source>
        <translation>kontrollsumma för referensens fil</translation>
    </message>
    <message>
        <source>list in the reference&apos;s certificate</source>
        <translation>lista i referensens certifikat</translation>
    </message>
    <message>
        <source>model of the reference</source>
        <translation>modell av referensen</translation>
    </message>
    <message>
        <source>unit of the reference&apos;s sensitivity</source>
        <translation>enhet för referensens känslighet</translation>
    </message>
    <message>
        <source>delay of the reference</source>
        <translation>referensens fördröjning</translation>
    </message>
    <message>
        <source>u of the reference&apos;s delay</source>
        <translation>u för referensens fördröjning</translation>
    </message>
    <message>
        <source>correlation of reference and step</source>
        <translation>korrelation mellan referens och steg</translation>
    </message>
    <message>
        <source>comparison</source>
        <translation>jämförelse</translation>
    </message>
    <message>
        <source>decision rule</source>
        <translation>beslutsregel</translation>
    </message>
    <message>
        <source>limit of the claim</source>
        <translation>påståendets gräns</translation>
    </message>
    <message>
        <source>lowest frequency of the claim</source>
        <translation>påståendets lägsta frekvens</translation>
    </message>
    <message>
        <source>highest frequency of the claim</source>
        <translation>påståendets högsta frekvens</translation>
    </message>
    <message>
        <source>largest risk of the claim</source>
        <translation>påståendets största risk</translation>
    </message>
    <message>
        <source>decision on conformity</source>
        <translation>beslut om överensstämmelse</translation>
    </message>
    <message>
        <source>profile of the laboratory</source>
        <translation>laboratoriets profil</translation>
    </message>
    <message>
        <source>name of the profile</source>
        <translation>profilens namn</translation>
    </message>
    <message>
        <source>version of the profile</source>
        <translation>profilens version</translation>
    </message>
    <message>
        <source>hash of the profile&apos;s file</source>
        <translation>kontrollsumma för profilens fil</translation>
    </message>
    <message>
        <source>what the profile held</source>
        <translation>vad profilen innehöll</translation>
    </message>
    <message>
        <source>file of the chain&apos;s response</source>
        <translation>fil med kedjans svar</translation>
    </message>
    <message>
        <source>hash of the chain&apos;s file</source>
        <translation>kontrollsumma för kedjans fil</translation>
    </message>
    <message>
        <source>list in the chain&apos;s certificate</source>
        <translation>lista i kedjans certifikat</translation>
    </message>
    <message>
        <source>amplifier and converter</source>
        <translation>förstärkare och omvandlare</translation>
    </message>
    <message>
        <source>certificate of the reference</source>
        <translation>referensens certifikat</translation>
    </message>
    <message>
        <source>due date of the reference</source>
        <translation>referensens slutdatum</translation>
    </message>
    <message>
        <source>quantity of the CMC</source>
        <translation>CMC:ns storhet</translation>
    </message>
    <message>
        <source>CMC</source>
        <translation>CMC</translation>
    </message>
    <message>
        <source>CMC is relative</source>
        <translation>CMC är relativ</translation>
    </message>
    <message>
        <source>CMC from</source>
        <translation>CMC från</translation>
    </message>
    <message>
        <source>CMC to</source>
        <translation>CMC till</translation>
    </message>
    <message>
        <source>least uncertainty of the laboratory (CMC)</source>
        <translation>laboratoriets minsta osäkerhet (CMC)</translation>
    </message>
    <message>
        <source>correlated quantity</source>
        <translation>korrelerad storhet</translation>
    </message>
    <message>
        <source>quantity it is correlated with</source>
        <translation>storhet den är korrelerad med</translation>
    </message>
    <message>
        <source>correlation coefficient</source>
        <translation>korrelationskoefficient</translation>
    </message>
    <message>
        <source>correlations in the budget</source>
        <translation>korrelationer i budgeten</translation>
    </message>
    <message>
        <source>name of a known value</source>
        <translation>namn på ett känt värde</translation>
    </message>
    <message>
        <source>frequency of a known value</source>
        <translation>frekvens för ett känt värde</translation>
    </message>
    <message>
        <source>known value</source>
        <translation>känt värde</translation>
    </message>
    <message>
        <source>u of a known value</source>
        <translation>u för ett känt värde</translation>
    </message>
    <message>
        <source>unit of a known value</source>
        <translation>enhet för ett känt värde</translation>
    </message>
    <message>
        <source>degrees of freedom of a known value</source>
        <translation>frihetsgrader för ett känt värde</translation>
    </message>
    <message>
        <source>certificate of a known value</source>
        <translation>bevis för ett känt värde</translation>
    </message>
    <message>
        <source>values of other calibrations</source>
        <translation>värden från andra kalibreringar</translation>
    </message>
    <message>
        <source>certificate of the chain</source>
        <translation>mätkedjans bevis</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>To be filled in before issue: %1.</source>
        <translation>Ska fyllas i före utfärdandet: %1.</translation>
    </message>
    <message>
        <source>Figure %1. %2.</source>
        <translation>Figur %1. %2.</translation>
    </message>
    <message>
        <source>End of the certificate</source>
        <translation>Slut på kalibreringsbeviset</translation>
    </message>
    <message>
        <source>no number yet</source>
        <translation>ännu inget nummer</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>Nr %1</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>sida %1 av %2</translation>
    </message>
    <message>
        <source>Draft, not valid as a certificate</source>
        <translation>Utkast, gäller inte som kalibreringsbevis</translation>
    </message>
    <message>
        <source>Computed %1</source>
        <translation>Beräknat %1</translation>
    </message>
    <message>
        <source>DRAFT</source>
        <translation>UTKAST</translation>
    </message>
    <message>
        <source>End of the report</source>
        <translation>Slut på rapporten</translation>
    </message>
    <message>
        <source>Issued, not signed</source>
        <translation>Utfärdat, inte signerat</translation>
    </message>
    <message>
        <source>Issued, with an electronic signature</source>
        <translation>Utfärdat, elektroniskt signerat</translation>
    </message>
</context>
<context>
    <name>ShockBudget</name>
    <message>
        <source>Distance, %1</source>
        <translation>Avstånd, %1</translation>
    </message>
    <message>
        <source>Arrival, %1</source>
        <translation>Ankomst, %1</translation>
    </message>
    <message>
        <source>Delay, %1</source>
        <translation>Fördröjning, %1</translation>
    </message>
    <message>
        <source>Time, %1</source>
        <translation>Tid, %1</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Hastighet</translation>
    </message>
    <message>
        <source>Scatter of the velocity</source>
        <translation>Hastighetens spridning</translation>
    </message>
    <message>
        <source>p1</source>
        <translation>p1</translation>
    </message>
    <message>
        <source>T1</source>
        <translation>T1</translation>
    </message>
    <message>
        <source>Relative humidity</source>
        <translation>Relativ fuktighet</translation>
    </message>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>γ</source>
        <translation>γ</translation>
    </message>
    <message>
        <source>Molar mass in kg/mol</source>
        <translation>Molmassa i kg/mol</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>rectangular</source>
        <translation>rektangulär</translation>
    </message>
    <message>
        <source>triangular</source>
        <translation>triangulär</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Storhet</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Värde</translation>
    </message>
    <message>
        <source>u</source>
        <translation>u</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Fördelning</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Frihetsgrader</translation>
    </message>
    <message>
        <source>To the step</source>
        <translation>Till steget</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Andel</translation>
    </message>
    <message>
        <source>Common to all shots</source>
        <translation>Gemensam för alla skott</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nej</translation>
    </message>
    <message>
        <source>u-shaped</source>
        <translation>U-formad</translation>
    </message>
    <message>
        <source>Attenuation along the tube</source>
        <translation>Dämpning längs röret</translation>
    </message>
    <message>
        <source>Typed pressure step</source>
        <translation>Inmatat trycksteg</translation>
    </message>
    <message>
        <source>Noise of the level</source>
        <translation>Nivåns brus</translation>
    </message>
    <message>
        <source>Scatter of the shots</source>
        <translation>Skottens spridning</translation>
    </message>
    <message>
        <source>Mounting of the sensor</source>
        <translation>Givarens montering</translation>
    </message>
    <message>
        <source>Sample clock</source>
        <translation>Samplingsklocka</translation>
    </message>
    <message>
        <source>Noise of the recordings</source>
        <translation>Registreringarnas brus</translation>
    </message>
    <message>
        <source>End of the recordings</source>
        <translation>Registreringarnas slut</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Sampling</translation>
    </message>
    <message>
        <source>Drift that was divided out</source>
        <translation>Drift som dividerats bort</translation>
    </message>
    <message>
        <source>Duration of the front</source>
        <translation>Frontens varaktighet</translation>
    </message>
    <message>
        <source>Weak oscillation, perhaps the mount&apos;s</source>
        <translation>Svag svängning, kanske monteringens</translation>
    </message>
    <message>
        <source>Front of unknown duration</source>
        <translation>Front med okänd varaktighet</translation>
    </message>
    <message>
        <source>Onset of the step</source>
        <translation>Stegets början</translation>
    </message>
    <message>
        <source>Gain of the chain</source>
        <translation>Mätkedjans förstärkning</translation>
    </message>
    <message>
        <source>Linearity of the chain</source>
        <translation>Mätkedjans linjäritet</translation>
    </message>
    <message>
        <source>Certificate of the reference</source>
        <translation>Referensens certifikat</translation>
    </message>
    <message>
        <source>Gain of the reference&apos;s chain</source>
        <translation>Förstärkning i referensens kedja</translation>
    </message>
    <message>
        <source>Noise of the reference&apos;s level</source>
        <translation>Brus i referensens nivå</translation>
    </message>
    <message>
        <source>Delay of the reference</source>
        <translation>Referensens fördröjning</translation>
    </message>
    <message>
        <source>Response of the chain</source>
        <translation>Kedjans svar</translation>
    </message>
    <message>
        <source>Least uncertainty of the laboratory (CMC)</source>
        <translation>Laboratoriets minsta osäkerhet (CMC)</translation>
    </message>
    <message>
        <source>all places</source>
        <translation>alla ställen</translation>
    </message>
</context>
<context>
    <name>ShockTables</name>
    <message>
        <source>Shot %1</source>
        <translation>Skott %1</translation>
    </message>
    <message>
        <source>not determined</source>
        <translation>inte bestämt</translation>
    </message>
    <message>
        <source>%1 (typed)</source>
        <translation>%1 (angiven)</translation>
    </message>
    <message>
        <source>%1 %/m</source>
        <translation>%1 %/m</translation>
    </message>
    <message>
        <source>%1 (not applied)</source>
        <translation>%1 (används inte)</translation>
    </message>
    <message>
        <source>p1</source>
        <translation>p1</translation>
    </message>
    <message>
        <source>p2</source>
        <translation>p2</translation>
    </message>
    <message>
        <source>p5</source>
        <translation>p5</translation>
    </message>
    <message>
        <source>p4 (eq. 3.10)</source>
        <translation>p4 (ekv. 3.10)</translation>
    </message>
    <message>
        <source>T1</source>
        <translation>T1</translation>
    </message>
    <message>
        <source>T2</source>
        <translation>T2</translation>
    </message>
    <message>
        <source>T5</source>
        <translation>T5</translation>
    </message>
    <message>
        <source>T4</source>
        <translation>T4</translation>
    </message>
    <message>
        <source>Density ρ5</source>
        <translation>Densitet ρ5</translation>
    </message>
    <message>
        <source>Sound speed a1</source>
        <translation>Ljudhastighet a1</translation>
    </message>
    <message>
        <source>Sound speed a5</source>
        <translation>Ljudhastighet a5</translation>
    </message>
    <message>
        <source>Gas velocity u2</source>
        <translation>Gashastighet u2</translation>
    </message>
    <message>
        <source>Reflected shock</source>
        <translation>Reflekterad stötvåg</translation>
    </message>
    <message>
        <source>follows the gas: a mode of the tube</source>
        <translation>följer gasen: en rörmod</translation>
    </message>
    <message>
        <source>stays: not a mode of the gas</source>
        <translation>ligger still: ingen mod i gasen</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>ej avgjort</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Storhet</translation>
    </message>
    <message>
        <source>Pressure step</source>
        <translation>Trycksteg</translation>
    </message>
    <message>
        <source>Velocity W</source>
        <translation>Hastighet W</translation>
    </message>
    <message>
        <source>Mach number</source>
        <translation>Machtal</translation>
    </message>
    <message>
        <source>W along the tube</source>
        <translation>W längs röret</translation>
    </message>
    <message>
        <source>Plateau lasts</source>
        <translation>Platåns längd</translation>
    </message>
    <message>
        <source>Lowest frequency</source>
        <translation>Lägsta frekvens</translation>
    </message>
    <message>
        <source>Arrival at the side</source>
        <translation>Ankomst vid sidan</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Skott</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Tryck</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Measured, absolute</source>
        <translation>Uppmätt, absolut</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Förväntat</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Avvikelse</translation>
    </message>
    <message>
        <source>Reads</source>
        <translation>Visar</translation>
    </message>
    <message>
        <source>gauge</source>
        <translation>övertryck</translation>
    </message>
    <message>
        <source>absolute</source>
        <translation>absolut</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Läge</translation>
    </message>
    <message>
        <source>To the end wall</source>
        <translation>Till ändväggen</translation>
    </message>
    <message>
        <source>u (place)</source>
        <translation>u (läge)</translation>
    </message>
    <message>
        <source>Arrival</source>
        <translation>Ankomst</translation>
    </message>
    <message>
        <source>u (arrival)</source>
        <translation>u (ankomst)</translation>
    </message>
    <message>
        <source>u (delay)</source>
        <translation>u (fördröjning)</translation>
    </message>
    <message>
        <source>Seen – fitted</source>
        <translation>Sedd – anpassad</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Värde</translation>
    </message>
    <message>
        <source>u (propagation)</source>
        <translation>u (fortplantning)</translation>
    </message>
    <message>
        <source>Relative</source>
        <translation>Relativt</translation>
    </message>
    <message>
        <source>u (Monte Carlo)</source>
        <translation>u (Monte Carlo)</translation>
    </message>
    <message>
        <source>Interval (Monte Carlo)</source>
        <translation>Intervall (Monte Carlo)</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 till %2</translation>
    </message>
    <message>
        <source>Peak</source>
        <translation>Topp</translation>
    </message>
    <message>
        <source>Slope of ln f on ln a5</source>
        <translation>Lutning för ln f mot ln a5</translation>
    </message>
    <message>
        <source>u (slope)</source>
        <translation>u (lutning)</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Slutsats</translation>
    </message>
    <message>
        <source>Nearest tube mode (computed)</source>
        <translation>Närmaste rörmod (beräknad)</translation>
    </message>
</context>
<context>
    <name>StatusText</name>
    <message>
        <source>not started</source>
        <translation>ej påbörjat</translation>
    </message>
    <message>
        <source>blocked</source>
        <translation>blockerat</translation>
    </message>
    <message>
        <source>computing</source>
        <translation>beräknar</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>inaktuellt</translation>
    </message>
    <message>
        <source>done</source>
        <translation>klart</translation>
    </message>
    <message>
        <source>cautions</source>
        <translation>varningar</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) are empty</source>
        <translation>
            <numerusform>%n fält är tomt</numerusform>
            <numerusform>%n fält är tomma</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n date(s) are none</source>
        <translation>
            <numerusform>%n datum är inget datum</numerusform>
            <numerusform>%n datum är inga datum</numerusform>
        </translation>
    </message>
    <message>
        <source>not complete: %1</source>
        <translation>inte komplett: %1</translation>
    </message>
    <message>
        <source>not complete</source>
        <translation>inte komplett</translation>
    </message>
    <message>
        <source>blocked by %1</source>
        <translation>blockerat av %1</translation>
    </message>
    <message numerus="yes">
        <source>%n caution(s) without a reason</source>
        <translation>
            <numerusform>%n varning utan motivering</numerusform>
            <numerusform>%n varningar utan motivering</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TraceText</name>
    <message>
        <source>no step</source>
        <translation>inget steg</translation>
    </message>
    <message>
        <source>step %1, %2 times the noise</source>
        <translation>steg %1, %2 gånger bruset</translation>
    </message>
    <message>
        <source>step %1, no noise</source>
        <translation>steg %1, inget brus</translation>
    </message>
</context>
<context>
    <name>TypedQuantityText</name>
    <message>
        <source>“%1”: this is a number without a unit.</source>
        <translation>”%1”: detta är ett tal utan enhet.</translation>
    </message>
    <message>
        <source>The unit “%1” is not understood here. Understood are %2.</source>
        <translation>Enheten ”%1” kan inte tolkas här. Det som tolkas är %2.</translation>
    </message>
    <message>
        <source>“%1” cannot be read as a number.</source>
        <translation>”%1” kan inte läsas som ett tal.</translation>
    </message>
    <message>
        <source>“%1” can be read as %2 or as %3. Write one of these.</source>
        <translation>”%1” kan läsas som %2 eller som %3. Skriv ett av dem.</translation>
    </message>
</context>
<context>
    <name>WindowEnds</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Each shot ends with its own plateau.</source>
        <translation>Varje skott slutar med sin egen platå.</translation>
    </message>
    <message>
        <source>Set for each shot; that of shot %1 is automatic.</source>
        <translation>Ställs in för varje skott; det för skott %1 är automatiskt.</translation>
    </message>
    <message>
        <source>Set for each shot; this is the end of shot %1 alone.</source>
        <translation>Ställs in för varje skott; detta är slutet för skott %1 ensamt.</translation>
    </message>
    <message>
        <source>Automatic: each shot has an end of its own.</source>
        <translation>Automatiskt: varje skott har sitt eget slut.</translation>
    </message>
    <message>
        <source>One end, common to all shots.</source>
        <translation>Ett slut, gemensamt för alla skott.</translation>
    </message>
    <message>
        <source>The plateau is over before it in: %1.</source>
        <translation>Platån är slut före den i: %1.</translation>
    </message>
    <message>
        <source>The record of shot %1 ends here.</source>
        <translation>Registreringen av skott %1 slutar här.</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Wrong usage: %1; see dyncal --help.</source>
        <translation>Felaktig användning: %1; se dyncal --help.</translation>
    </message>
    <message>
        <source>Internal error (%1); please report it with the files that show it.</source>
        <translation>Internt fel (%1); rapportera det tillsammans med de filer som visar det.</translation>
    </message>
    <message>
        <source>The answer could not be written to the standard output.</source>
        <translation>Svaret kunde inte skrivas till standard ut.</translation>
    </message>
    <message>
        <source>--order is &quot;%1&quot;; it needs &quot;auto&quot; or a whole number from 1.</source>
        <translation>--order är &quot;%1&quot;; det ska vara &quot;auto&quot; eller ett heltal från 1.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made: %2.</source>
        <translation>Mappen %1 kan inte skapas: %2.</translation>
    </message>
    <message>
        <source>--shots holds &quot;%1&quot;; it needs low, medium or high, separated by commas.</source>
        <translation>--shots innehåller &quot;%1&quot;; det ska vara low, medium eller high, åtskilda av kommatecken.</translation>
    </message>
    <message>
        <source>The clock cannot be read.</source>
        <translation>Klockan kan inte avläsas.</translation>
    </message>
    <message>
        <source>SOURCE_DATE_EPOCH is &quot;%1&quot;; it needs a whole number of seconds since 1970.</source>
        <translation>SOURCE_DATE_EPOCH är &quot;%1&quot;; det ska vara ett helt antal sekunder sedan 1970.</translation>
    </message>
    <message>
        <source>%1 is neither a subcommand nor a file; the nearest subcommand is %2.</source>
        <translation>%1 är varken ett underkommando eller en fil; närmaste underkommando är %2.</translation>
    </message>
    <message>
        <source>The file %1 does not exist.</source>
        <translation>Filen %1 finns inte.</translation>
    </message>
    <message>
        <source>The workbench needs a display and there is none; the subcommands work without, see dyncal --help.</source>
        <translation>Arbetsbänken behöver en bildskärm och det finns ingen; underkommandona fungerar utan, se dyncal --help.</translation>
    </message>
    <message>
        <source>%1 cannot be written: something that is no regular file has this name; choose another.</source>
        <translation>%1 kan inte skrivas: något som inte är en vanlig fil har detta namn; välj ett annat.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos; of shot %2 is flat: all %3 samples are %4. Check cable and role.</source>
        <translation>Kanal &apos;%1&apos; i skott %2 är konstant: alla %3 sampel är %4. Kontrollera kabel och roll.</translation>
    </message>
    <message>
        <source>Shot %1, %2 is saturated for %3 at %4, from %5 on. Inside the response window that blocks the shot; use a wider range.</source>
        <translation>Skott %1, %2 är mättat under %3 vid %4, från och med %5. Inom svarsfönstret blockerar det skottet; använd ett större mätområde.</translation>
    </message>
    <message>
        <source>One shot: PCA is skipped and repeatability cannot be evaluated.</source>
        <translation>Ett skott: PCA hoppas över och repeterbarheten kan inte utvärderas.</translation>
    </message>
    <message>
        <source>Shots have different sample rates (%1). For PCA they are brought to %2; the model input resamples each from its own rate.</source>
        <translation>Skotten har olika samplingsfrekvens (%1). För PCA omvandlas de till %2; modellindata samplas om från vart och ett skotts egen frekvens.</translation>
    </message>
    <message>
        <source>Shots have different lengths (%1); what all of them have is used.</source>
        <translation>Skotten har olika längd (%1); den del som alla har används.</translation>
    </message>
    <message>
        <source>Shot %1 has no DUT channel. Choose which channel is the sensor under test (import.channels in the recipe).</source>
        <translation>Skott %1 har ingen DUT-kanal. Välj vilken kanal som är givaren under provning (import.channels i receptet).</translation>
    </message>
    <message>
        <source>%1 is not a recording: it is a PDF document. Readable are: %2.</source>
        <translation>%1 är ingen registrering: det är ett PDF-dokument. Läsbara format: %2.</translation>
    </message>
    <message>
        <source>%1 is not a recording: it is a ZIP archive or an office document; unpack it, or save the sheet as CSV. Readable are: %2.</source>
        <translation>%1 är ingen registrering: det är ett ZIP-arkiv eller ett kontorsdokument; packa upp det eller spara kalkylbladet som CSV. Läsbara format: %2.</translation>
    </message>
    <message>
        <source>%1 is not a recording: it is an old office document; save the sheet as CSV. Readable are: %2.</source>
        <translation>%1 är ingen registrering: det är ett kontorsdokument i äldre format; spara kalkylbladet som CSV. Läsbara format: %2.</translation>
    </message>
    <message>
        <source>%1 is not a recording: it is a PNG picture. Readable are: %2.</source>
        <translation>%1 är ingen registrering: det är en PNG-bild. Läsbara format: %2.</translation>
    </message>
    <message>
        <source>%1 is not a recording: it is a JPEG picture. Readable are: %2.</source>
        <translation>%1 är ingen registrering: det är en JPEG-bild. Läsbara format: %2.</translation>
    </message>
    <message>
        <source>%1 is not a recording: it is a GIF picture. Readable are: %2.</source>
        <translation>%1 är ingen registrering: det är en GIF-bild. Läsbara format: %2.</translation>
    </message>
    <message>
        <source>%1 is a compressed file (gzip); unpack it first. Readable are: %2.</source>
        <translation>%1 är en komprimerad fil (gzip); packa upp den först. Läsbara format: %2.</translation>
    </message>
    <message>
        <source>%1 is a 7-Zip archive; unpack it first. Readable are: %2.</source>
        <translation>%1 är ett 7-Zip-arkiv; packa upp det först. Läsbara format: %2.</translation>
    </message>
    <message>
        <source>%1 is a MATLAB file, which this version does not read; write the samples as CSV or HDF5 capture. Readable are: %2.</source>
        <translation>%1 är en MATLAB-fil, som denna version inte läser; skriv samplen som CSV eller HDF5-registrering. Läsbara format: %2.</translation>
    </message>
    <message>
        <source>%1 is not a recording: it is a program. Readable are: %2.</source>
        <translation>%1 är ingen registrering: det är ett program. Läsbara format: %2.</translation>
    </message>
    <message>
        <source>%1 is empty; copy it again or record anew. Readable are: %2.</source>
        <translation>%1 är tom; kopiera den igen eller gör om registreringen. Läsbara format: %2.</translation>
    </message>
    <message>
        <source>%1 is not a recording: it is a text without rows of numbers. Readable are: %2.</source>
        <translation>%1 är ingen registrering: det är en text utan rader med tal. Läsbara format: %2.</translation>
    </message>
    <message>
        <source>%1 is not a recording that can be read: it is a binary file of unknown kind. Readable are: %2.</source>
        <translation>%1 är ingen läsbar registrering: det är en binärfil av okänt slag. Läsbara format: %2.</translation>
    </message>
    <message>
        <source>An empty name was given where a file is needed; name a file.</source>
        <translation>Ett tomt namn angavs där en fil behövs; ange en fil.</translation>
    </message>
    <message>
        <source>%1 does not exist; check the name and the folder.</source>
        <translation>%1 finns inte; kontrollera namnet och mappen.</translation>
    </message>
    <message>
        <source>%1 is a folder or a device, not a file; name a file. Readable are: %2.</source>
        <translation>%1 är en mapp eller en enhet, inte en fil; ange en fil. Läsbara format: %2.</translation>
    </message>
    <message>
        <source>%1 cannot be opened; check that you may read it and that no other program holds it.</source>
        <translation>%1 kan inte öppnas; kontrollera att du har läsbehörighet och att inget annat program håller filen.</translation>
    </message>
    <message>
        <source>There is no import format &quot;%1&quot;; choose one of %2.</source>
        <translation>Det finns inget importformat &quot;%1&quot;; välj ett av %2.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be listed; check that you may read it.</source>
        <translation>Mappen %1 kan inte listas; kontrollera att du har läsbehörighet.</translation>
    </message>
    <message>
        <source>A file of the folder was left out. %M1</source>
        <translation>En fil i mappen utelämnades. %M1</translation>
    </message>
    <message>
        <source>%1 and %2 hold identical data; a shot counted twice makes the scatter look smaller than it is. Take one of them out.</source>
        <translation>%1 och %2 innehåller identiska data; ett skott som räknas två gånger får spridningen att se mindre ut än den är. Ta bort ett av dem.</translation>
    </message>
    <message>
        <source>%1 is an HDF5 file but no capture: its root lacks the attribute format = &quot;dyncal-capture&quot;. Export the recording as LVM or CSV, or write it in the capture layout.</source>
        <translation>%1 är en HDF5-fil men ingen registrering: dess rot saknar attributet format = &quot;dyncal-capture&quot;. Exportera registreringen som LVM eller CSV, eller skriv den i registreringsformatet.</translation>
    </message>
    <message>
        <source>%1 has capture layout version %2; this program reads version 1. Use a newer version of the program.</source>
        <translation>%1 har version %2 av registreringsformatet; detta program läser version 1. Använd en nyare version av programmet.</translation>
    </message>
    <message>
        <source>%1 was written by a newer version (capture layout 1.%2); what this version does not know was left out.</source>
        <translation>%1 skrevs av en nyare version (registreringsformat 1.%2); det som denna version inte känner till utelämnades.</translation>
    </message>
    <message>
        <source>%1 holds no shots; a capture has at least one group in /shots.</source>
        <translation>%1 innehåller inga skott; en registrering har minst en grupp i /shots.</translation>
    </message>
    <message>
        <source>%1: shot %2 cannot be opened; the file is damaged, or its shots lie in other files.</source>
        <translation>%1: skott %2 kan inte öppnas; filen är skadad eller så ligger dess skott i andra filer.</translation>
    </message>
    <message>
        <source>%1: shot %2 has no channels of its own; a shot holds its samples in its group channels.</source>
        <translation>%1: skott %2 har inga egna kanaler; ett skott har sina sampel i sin grupp channels.</translation>
    </message>
    <message>
        <source>%1: channel %2 is no dataset of samples.</source>
        <translation>%1: kanal %2 är ingen datamängd med sampel.</translation>
    </message>
    <message>
        <source>%1: scale, offset or poly of channel %2 is not a number; without it the counts have no unit.</source>
        <translation>%1: scale, offset eller poly för kanal %2 är inte ett tal; utan det saknar avläsningarna enhet.</translation>
    </message>
    <message>
        <source>%1: the samples of channel %2 are stored in a type for which the SHA-256 in the file was not checked.</source>
        <translation>%1: samplen i kanal %2 är lagrade i en typ för vilken SHA-256 i filen inte kontrollerades.</translation>
    </message>
    <message>
        <source>%1 cannot be opened as HDF5: it is incomplete, damaged or in use by another program; copy it again or close the other program.</source>
        <translation>%1 kan inte öppnas som HDF5: filen är ofullständig, skadad eller används av ett annat program; kopiera den igen eller stäng det andra programmet.</translation>
    </message>
    <message>
        <source>Reading %1 was cancelled.</source>
        <translation>Läsningen av %1 avbröts.</translation>
    </message>
    <message>
        <source>%1 was not read because the system could not start a helper process; close other programs.</source>
        <translation>%1 lästes inte eftersom systemet inte kunde starta en hjälpprocess; stäng andra program.</translation>
    </message>
    <message>
        <source>%1 was not read because the system or another program ended the helper process that reads it, most likely for want of memory; close other programs and try again.</source>
        <translation>%1 lästes inte eftersom systemet eller ett annat program avslutade hjälpprocessen som läser den, troligen för att minnet inte räckte; stäng andra program och försök igen.</translation>
    </message>
    <message>
        <source>%1 is damaged so badly that the HDF5 library fails on it; take another copy.</source>
        <translation>%1 är så svårt skadad att HDF5-biblioteket inte klarar den; ta en annan kopia.</translation>
    </message>
    <message>
        <source>Writing %1 was cancelled; nothing was left behind.</source>
        <translation>Skrivningen av %1 avbröts; inget lämnades kvar.</translation>
    </message>
    <message>
        <source>%1 could not be written completely and was not created; check the space on the disk and the free memory.</source>
        <translation>%1 kunde inte skrivas i sin helhet och skapades inte; kontrollera diskutrymmet och det lediga minnet.</translation>
    </message>
    <message>
        <source>%1: channel %2 is no list of numbers; a channel is a one-dimensional dataset of integers or floating point numbers.</source>
        <translation>%1: kanal %2 är ingen lista med tal; en kanal är en endimensionell datamängd av heltal eller flyttal.</translation>
    </message>
    <message>
        <source>%1: channel %2 claims more samples than the file holds; the copy is incomplete or damaged, copy it again.</source>
        <translation>%1: kanal %2 uppger fler sampel än filen innehåller; kopian är ofullständig eller skadad, kopiera den igen.</translation>
    </message>
    <message>
        <source>%1: channel %2 is compressed with HDF5 filter %3, which is not installed here; save the file with deflate or without compression.</source>
        <translation>%1: kanal %2 är komprimerad med HDF5-filter %3, som inte är installerat här; spara filen med deflate eller utan komprimering.</translation>
    </message>
    <message>
        <source>%1: channel %2 is compressed in chunks of more than 64 MiB; save the file with smaller chunks or without compression.</source>
        <translation>%1: kanal %2 är komprimerad i block på mer än 64 MiB; spara filen med mindre block eller utan komprimering.</translation>
    </message>
    <message>
        <source>Shot %1, channel &apos;%2&apos;: the file states no sample rate and has no time column; give import.sample_rate_hz in the recipe.</source>
        <translation>Skott %1, kanal &apos;%2&apos;: filen anger ingen samplingsfrekvens och har ingen tidskolumn; ange import.sample_rate_hz i receptet.</translation>
    </message>
    <message>
        <source>Shot %1, %2: %3 invalid samples were interpolated.</source>
        <translation>Skott %1, %2: %3 ogiltiga sampel interpolerades.</translation>
    </message>
    <message>
        <source>Recipe import.levels has %1 entries for %2 shots; give one for each shot.</source>
        <translation>Receptets import.levels har %1 poster för %2 skott; ange en för varje skott.</translation>
    </message>
    <message>
        <source>Recipe import.exclude names shot %1; the shots are 1 to %2.</source>
        <translation>Receptets import.exclude anger skott %1; skotten är 1 till %2.</translation>
    </message>
    <message>
        <source>All %1 shots are excluded; include at least one to calibrate.</source>
        <translation>Alla %1 skott är uteslutna; ta med minst ett för att kalibrera.</translation>
    </message>
    <message>
        <source>Certificate of dynamic calibration</source>
        <translation>Bevis över dynamisk kalibrering</translation>
    </message>
    <message>
        <source>low</source>
        <translation>låg</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>medel</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hög</translation>
    </message>
    <message>
        <source>to be filled in</source>
        <translation>ska fyllas i</translation>
    </message>
    <message>
        <source>Laboratory and customer</source>
        <translation>Laboratorium och kund</translation>
    </message>
    <message>
        <source>Certificate number</source>
        <translation>Kalibreringsbevisets nummer</translation>
    </message>
    <message>
        <source>Laboratory</source>
        <translation>Laboratorium</translation>
    </message>
    <message>
        <source>Address of the laboratory</source>
        <translation>Laboratoriets adress</translation>
    </message>
    <message>
        <source>Place of calibration</source>
        <translation>Kalibreringsplats</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Kund</translation>
    </message>
    <message>
        <source>Address of the customer</source>
        <translation>Kundens adress</translation>
    </message>
    <message>
        <source>Date of receipt</source>
        <translation>Mottagningsdatum</translation>
    </message>
    <message>
        <source>Date of calibration</source>
        <translation>Kalibreringsdatum</translation>
    </message>
    <message>
        <source>Date of issue</source>
        <translation>Utfärdandedatum</translation>
    </message>
    <message>
        <source>Calibrated by</source>
        <translation>Kalibrerat av</translation>
    </message>
    <message>
        <source>Approved by</source>
        <translation>Godkänt av</translation>
    </message>
    <message>
        <source>not yet approved</source>
        <translation>ännu inte godkänt</translation>
    </message>
    <message>
        <source>Item calibrated</source>
        <translation>Kalibrerat objekt</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>Tillverkare</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Serienummer</translation>
    </message>
    <message>
        <source>Description and condition</source>
        <translation>Beskrivning och skick</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Anmärkningar</translation>
    </message>
    <message>
        <source>Shot %1 was excluded. Reason: %V2.</source>
        <translation>Skott %1 uteslöts. Skäl: %V2.</translation>
    </message>
    <message>
        <source>Findings on the quality of the data</source>
        <translation>Iakttagelser om datakvaliteten</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Iakttagelse</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Skott</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Allvarlighetsgrad</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Vad som iakttogs</translation>
    </message>
    <message>
        <source>Accepted because</source>
        <translation>Godtas eftersom</translation>
    </message>
    <message>
        <source>blocking</source>
        <translation>blockerande</translation>
    </message>
    <message>
        <source>caution</source>
        <translation>varning</translation>
    </message>
    <message>
        <source>Records and software</source>
        <translation>Registreringar och programvara</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Programvara</translation>
    </message>
    <message>
        <source>Dyncal %V1, build %V2</source>
        <translation>Dyncal %V1, bygge %V2</translation>
    </message>
    <message>
        <source>Computed</source>
        <translation>Beräknat</translation>
    </message>
    <message>
        <source>Recordings evaluated</source>
        <translation>Utvärderade registreringar</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>SHA-256 of the file</source>
        <translation>Filens SHA-256</translation>
    </message>
    <message>
        <source>Statements</source>
        <translation>Uttalanden</translation>
    </message>
    <message>
        <source>The results relate only to the item calibrated.</source>
        <translation>Resultaten avser endast det kalibrerade objektet.</translation>
    </message>
    <message>
        <source>This document shall not be reproduced except in full without the written approval of the laboratory.</source>
        <translation>Detta dokument får inte återges annat än i sin helhet utan laboratoriets skriftliga godkännande.</translation>
    </message>
    <message>
        <source>No statement of conformity is made.</source>
        <translation>Inget uttalande om överensstämmelse görs.</translation>
    </message>
    <message>
        <source>The software does not know how the measuring equipment is traceable; this draft makes no statement of metrological traceability.</source>
        <translation>Programvaran vet inte hur mätutrustningen är spårbar; detta utkast gör inget uttalande om metrologisk spårbarhet.</translation>
    </message>
    <message>
        <source>Response to a pressure step; the pole of the step is removed before the realisation, so that the model describes the sensor alone.</source>
        <translation>Svar på ett trycksteg; stegets pol avlägsnas före realiseringen, så att modellen beskriver enbart givaren.</translation>
    </message>
    <message>
        <source>Response to a pressure step, realised as if it were an impulse response; the model contains the pole of the step.</source>
        <translation>Svar på ett trycksteg, realiserat som om det vore ett impulssvar; modellen innehåller stegets pol.</translation>
    </message>
    <message>
        <source>First difference of the response to a pressure step, realised as an impulse response.</source>
        <translation>Första differensen av svaret på ett trycksteg, realiserad som ett impulssvar.</translation>
    </message>
    <message>
        <source>Free decay, realised as an impulse response.</source>
        <translation>Fri utsvängning, realiserad som ett impulssvar.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Metod</translation>
    </message>
    <message>
        <source>not determined (not recorded)</source>
        <translation>inte bestämt (inte registrerat)</translation>
    </message>
    <message>
        <source>not determined</source>
        <translation>inte bestämt</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>angivet</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>beräknat</translation>
    </message>
    <message>
        <source>The sensitivity S(f) is the complex ratio of the item&apos;s output to the change of pressure at the sensor&apos;s face in the end-wall plane of a shock tube; phase of output over input, lag negative, relative to the sensor&apos;s own onset.</source>
        <translation>Känsligheten S(f) är det komplexa förhållandet mellan objektets utsignal och tryckändringen vid givarens yta i stötrörets ändväggsplan; fas för utsignal relativt insignal, eftersläpning negativ, räknat från givarens egen start.</translation>
    </message>
    <message>
        <source>Shots combined</source>
        <translation>Sammanvägning av skotten</translation>
    </message>
    <message>
        <source>stacked, each with its own amplitude (%1 series)</source>
        <translation>staplade, vart och ett med egen amplitud (%1 serier)</translation>
    </message>
    <message>
        <source>average of the reconstructions from principal components</source>
        <translation>medelvärde av rekonstruktionerna ur principalkomponenter</translation>
    </message>
    <message>
        <source>Sample rate of the model</source>
        <translation>Modellens samplingsfrekvens</translation>
    </message>
    <message>
        <source>Samples per series</source>
        <translation>Sampel per serie</translation>
    </message>
    <message>
        <source>Start of the model input after the onset</source>
        <translation>Modellindatas start efter svarets start</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Förhållanden</translation>
    </message>
    <message>
        <source>Ambient temperature</source>
        <translation>Omgivningstemperatur</translation>
    </message>
    <message>
        <source>Ambient pressure</source>
        <translation>Omgivningstryck</translation>
    </message>
    <message>
        <source>Pressure steps</source>
        <translation>Trycksteg</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivå</translation>
    </message>
    <message>
        <source>Initial pressure</source>
        <translation>Begynnelse­tryck</translation>
    </message>
    <message>
        <source>Initial temperature</source>
        <translation>Begynnelse­temperatur</translation>
    </message>
    <message>
        <source>Shock velocity</source>
        <translation>Stöt­vågens hastig­het</translation>
    </message>
    <message>
        <source>Mach number</source>
        <translation>Mach­tal</translation>
    </message>
    <message>
        <source>Pressure step</source>
        <translation>Tryck­steg</translation>
    </message>
    <message>
        <source>Step is</source>
        <translation>Steget är</translation>
    </message>
    <message>
        <source>Plateau</source>
        <translation>Platå</translation>
    </message>
    <message>
        <source>The pressure step is not determined for every shot: neither a step nor a shock velocity with initial pressure and temperature was given. A sensitivity in the unit of pressure cannot be stated for those shots.</source>
        <translation>Trycksteget är inte bestämt för varje skott: varken ett steg eller en stötvågshastighet med begynnelsetryck och begynnelsetemperatur har angivits. För dessa skott kan ingen känslighet i tryckenhet anges.</translation>
    </message>
    <message>
        <source>not determined (no model)</source>
        <translation>inte bestämt (ingen modell)</translation>
    </message>
    <message>
        <source>not determined (outside the range of the model)</source>
        <translation>inte bestämt (utanför modellens område)</translation>
    </message>
    <message>
        <source>not determined (no pressure step)</source>
        <translation>inte bestämt (inget trycksteg)</translation>
    </message>
    <message>
        <source>not determined (the model does not oscillate)</source>
        <translation>inte bestämt (modellen svänger inte)</translation>
    </message>
    <message>
        <source>Undamped natural frequency</source>
        <translation>Odämpad egenfrekvens</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>Relativ dämpning</translation>
    </message>
    <message>
        <source>Rise time, 10 % to 90 %</source>
        <translation>Stigtid, 10 % till 90 %</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Översväng</translation>
    </message>
    <message>
        <source>Settling time, within 5 %</source>
        <translation>Insvängningstid, inom 5 %</translation>
    </message>
    <message>
        <source>Magnitude within 5 % up to</source>
        <translation>Belopp inom 5 % upp till</translation>
    </message>
    <message>
        <source>Magnitude within 10 % up to</source>
        <translation>Belopp inom 10 % upp till</translation>
    </message>
    <message>
        <source>Magnitude above -3 dB up to</source>
        <translation>Belopp över -3 dB upp till</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>givare</translation>
    </message>
    <message>
        <source>step</source>
        <translation>steg</translation>
    </message>
    <message>
        <source>Nyquist</source>
        <translation>Nyquist</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instabil</translation>
    </message>
    <message>
        <source>other</source>
        <translation>övrig</translation>
    </message>
    <message>
        <source>Poles of the model (a conjugate pair is one line)</source>
        <translation>Modellens poler (ett konjugerat par är en rad)</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klass</translation>
    </message>
    <message>
        <source>z-plane</source>
        <translation>z-planet</translation>
    </message>
    <message>
        <source>Undamped frequency</source>
        <translation>Odämpad frekvens</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitud</translation>
    </message>
    <message>
        <source>Shots</source>
        <translation>Skott</translation>
    </message>
    <message>
        <source>No shot could be evaluated; see the remarks.</source>
        <translation>Inget skott kunde utvärderas; se anmärkningarna.</translation>
    </message>
    <message>
        <source>Measured responses, shot by shot</source>
        <translation>Uppmätta svar, skott för skott</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>Samplings­frekvens</translation>
    </message>
    <message>
        <source>Output step</source>
        <translation>Utsignalens steg</translation>
    </message>
    <message>
        <source>Signal to noise</source>
        <translation>Signal till brus</translation>
    </message>
    <message>
        <source>Rise time</source>
        <translation>Stigtid</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>Insväng­ningstid</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Känslighet</translation>
    </message>
    <message>
        <source>Model of the sensor</source>
        <translation>Modell av givaren</translation>
    </message>
    <message>
        <source>No model could be determined; see the remarks.</source>
        <translation>Ingen modell kunde bestämmas; se anmärkningarna.</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordning</translation>
    </message>
    <message>
        <source>%1 (as suggested from the data)</source>
        <translation>%1 (enligt förslaget ur data)</translation>
    </message>
    <message>
        <source>%1 (chosen by the operator)</source>
        <translation>%1 (vald av operatören)</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassning</translation>
    </message>
    <message>
        <source>Fit as in the listing (lagged)</source>
        <translation>Anpassning som i programlistningen (fördröjd)</translation>
    </message>
    <message>
        <source>The model has a pole outside the unit circle: its simulation diverges.</source>
        <translation>Modellen har en pol utanför enhetscirkeln: dess simulering divergerar.</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Frekvenssvar</translation>
    </message>
    <message>
        <source>The frequency response could not be determined.</source>
        <translation>Frekvenssvaret kunde inte bestämmas.</translation>
    </message>
    <message>
        <source>Lower frequency limit</source>
        <translation>Undre frekvensgräns</translation>
    </message>
    <message>
        <source>Upper frequency limit</source>
        <translation>Övre frekvensgräns</translation>
    </message>
    <message>
        <source>Sensitivity over frequency: from the responses without a model, and from the model</source>
        <translation>Känslighet över frekvens: ur svaren utan modell och ur modellen</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frekvens</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Belopp</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Fas</translation>
    </message>
    <message>
        <source>Model, magnitude</source>
        <translation>Modell, belopp</translation>
    </message>
    <message>
        <source>Model, phase</source>
        <translation>Modell, fas</translation>
    </message>
    <message>
        <source>The first principal component explains %1 % (limit %2 %). Shot %3 carries %4 % of the remainder.</source>
        <translation>Den första principalkomponenten förklarar %1 % (gräns %2 %). Skott %3 står för %4 % av återstoden.</translation>
    </message>
    <message>
        <source>Stopped on request.</source>
        <translation>Stoppat på begäran.</translation>
    </message>
    <message>
        <source>No shot is included.</source>
        <translation>Inget skott är medtaget.</translation>
    </message>
    <message>
        <source>The settings of the principal components make no sense: components %1 and residual lags %2 must be at least 1, the confidence %3 between 0 and 1.</source>
        <translation>Inställningarna för principalkomponenterna är orimliga: antalet komponenter %1 och antalet tidsförskjutningar %2 måste vara minst 1, konfidensgraden %3 mellan 0 och 1.</translation>
    </message>
    <message>
        <source>Shot %1: the residual is not white, %2 % of the lags lie outside the confidence band.</source>
        <translation>Skott %1: residualen är inte vit, %2 % av tidsförskjutningarna ligger utanför konfidensbandet.</translation>
    </message>
    <message>
        <source>Shot %1 holds %2 % of the energy of all residuals; look at it before using the average.</source>
        <translation>Skott %1 innehåller %2 % av alla residualers energi; granska det innan medelvärdet används.</translation>
    </message>
    <message>
        <source>At %1 the response taken from the data directly differs by %2 % from the model, more than noise allows: the model misses something there.</source>
        <translation>Vid %1 skiljer sig det svar som tagits direkt ur data %2 % från modellen, mer än bruset tillåter: modellen missar något där.</translation>
    </message>
    <message>
        <source>Not enough memory for this calibration; shorten the window or the model input.</source>
        <translation>Minnet räcker inte för denna kalibrering; förkorta fönstret eller modellindata.</translation>
    </message>
    <message>
        <source>Internal error: %1. Please report it with the recipe.</source>
        <translation>Internt fel: %1. Rapportera det tillsammans med receptet.</translation>
    </message>
    <message>
        <source>Recipe key %1 is %2; it needs %3.</source>
        <translation>Receptnyckeln %1 är %2; den ska vara %3.</translation>
    </message>
    <message>
        <source>Recipe key %1 is unknown; the nearest known key is %2.</source>
        <translation>Receptnyckeln %1 är okänd; närmaste kända nyckel är %2.</translation>
    </message>
    <message>
        <source>Recipe key realization.order is %1; it needs at most realization.max_order, which is %2.</source>
        <translation>Receptnyckeln realization.order är %1; den får vara högst realization.max_order, som är %2.</translation>
    </message>
    <message>
        <source>%1 holds the key &quot;%2&quot; twice; remove one of them.</source>
        <translation>%1 innehåller nyckeln &quot;%2&quot; två gånger; ta bort en av dem.</translation>
    </message>
    <message>
        <source>%1 is not valid JSON: line %2, column %3, near %4; correct it there.</source>
        <translation>%1 är inte giltig JSON: rad %2, kolumn %3, nära %4; rätta det där.</translation>
    </message>
    <message>
        <source>%1 is nested deeper than the %2 levels that any recipe needs; check that it is the right file.</source>
        <translation>%1 är nästlad djupare än de %2 nivåer som något recept behöver; kontrollera att det är rätt fil.</translation>
    </message>
    <message>
        <source>Hankel matrix: %1 rows do not fit a model input of %2 samples; choose 2 to %3.</source>
        <translation>Hankelmatris: %1 rader passar inte modellindata med %2 sampel; välj 2 till %3.</translation>
    </message>
    <message>
        <source>Order %1 splits an oscillating pair (singular values %1 and %2 are %3 and %4). Order %2 keeps it.</source>
        <translation>Ordning %1 delar ett svängande par (singulärvärde %1 och %2 är %3 och %4). Ordning %2 behåller det.</translation>
    </message>
    <message>
        <source>The pole at z = %1 is the step itself.</source>
        <translation>Polen vid z = %1 är själva steget.</translation>
    </message>
    <message>
        <source>FIT %1 % is above the %2 % that the noise allows: order %3 also fits noise.</source>
        <translation>FIT %1 % ligger över de %2 % som bruset tillåter: ordning %3 anpassar även brus.</translation>
    </message>
    <message>
        <source>The model starts at %1 % of the step instead of 0: a fast part of the response is missing; raise the model rate or the order.</source>
        <translation>Modellen börjar vid %1 % av steget i stället för vid 0: en snabb del av svaret saknas; höj modellens samplingsfrekvens eller ordning.</translation>
    </message>
    <message>
        <source>Model input: shot %1 offers %2 samples before its window ends, %3 are asked for; lengthen the window or ask for fewer samples.</source>
        <translation>Modellindata: skott %1 har %2 sampel innan dess fönster slutar, %3 begärs; förläng fönstret eller begär färre sampel.</translation>
    </message>
    <message>
        <source>Model input: shot %1 has %2 samples before the input starts, the anti-alias filter needs %3; start later or raise the model rate.</source>
        <translation>Modellindata: skott %1 har %2 sampel före indatas början, antivikningsfiltret behöver %3; börja senare eller höj modellens samplingsfrekvens.</translation>
    </message>
    <message>
        <source>The step is treated as an impulse response (thesis method): one extra order models the step itself.</source>
        <translation>Steget behandlas som ett impulssvar (examensarbetets metod): en extra ordning modellerar själva steget.</translation>
    </message>
    <message>
        <source>Order %1 has the smallest BIC on the pre-whitened response: order %2 is %3 higher, order %4 is %5 higher.</source>
        <translation>Ordning %1 har det minsta BIC på det förvitade svaret: ordning %2 ligger %3 högre, ordning %4 ligger %5 högre.</translation>
    </message>
    <message>
        <source>Order %1 has the smallest BIC on the pre-whitened response among orders 1 to %2.</source>
        <translation>Ordning %1 har det minsta BIC på det förvitade svaret bland ordningarna 1 till %2.</translation>
    </message>
    <message>
        <source>Model input: a rate of %1 cannot represent the resonance at %2, which would appear at %3; choose more than %4.</source>
        <translation>Modellindata: samplingsfrekvensen %1 kan inte återge resonansen vid %2, som skulle uppträda vid %3; välj mer än %4.</translation>
    </message>
    <message>
        <source>%1 samples per period of the resonance; damping will be uncertain, 4 or more are better.</source>
        <translation>%1 sampel per period av resonansen; dämpningen blir osäker, 4 eller fler är bättre.</translation>
    </message>
    <message>
        <source>%1 samples per period of the resonance.</source>
        <translation>%1 sampel per period av resonansen.</translation>
    </message>
    <message>
        <source>The model input starts %1 behind the onset, inside the anti-alias filter; %2 is needed, or damping and order come out wrong.</source>
        <translation>Modellindata börjar %1 efter svarets start, inom antivikningsfiltret; %2 behövs, annars blir dämpning och ordning fel.</translation>
    </message>
    <message>
        <source>Model order %1 is not possible: the Hankel matrix of %2 rows serves orders 1 to %3; choose one of them, or a longer model input.</source>
        <translation>Modellordning %1 är inte möjlig: Hankelmatrisen med %2 rader räcker till ordning 1 till %3; välj en av dem eller längre modellindata.</translation>
    </message>
    <message>
        <source>The pressure step is not determined: the pressure p1 in the driven section is not recorded; enter p1 or the step itself.</source>
        <translation>Trycksteget är inte bestämt: trycket p1 i lågtrycksdelen är inte registrerat; ange p1 eller själva steget.</translation>
    </message>
    <message>
        <source>The pressure step is not determined: the temperature T1 in the driven section is not recorded; enter T1 or the step itself.</source>
        <translation>Trycksteget är inte bestämt: temperaturen T1 i lågtrycksdelen är inte registrerad; ange T1 eller själva steget.</translation>
    </message>
    <message>
        <source>The distance alone makes the velocity uncertain by %1 %, which gives %2 % on the pressure step (factor %3).</source>
        <translation>Enbart avståndet gör hastigheten osäker med %1 %, vilket ger %2 % på trycksteget (faktor %3).</translation>
    </message>
    <message>
        <source>The reflected shock&apos;s return from the contact surface reaches the end wall %1 after the step (computed).</source>
        <translation>Den reflekterade stötvågen, åter från kontaktytan, når ändväggen %1 efter steget (beräknat).</translation>
    </message>
    <message>
        <source>Driver pressure %1 is %2 % below the %3 that the shock implies (both absolute): usual for a finite opening time.</source>
        <translation>Drivtrycket %1 ligger %2 % under de %3 som stötvågen motsvarar (båda absoluta): vanligt vid ändlig öppningstid.</translation>
    </message>
    <message>
        <source>Driver pressure %1 is %2 % above the %3 that the shock implies (both absolute): check whether the recorded value is right.</source>
        <translation>Drivtrycket %1 ligger %2 % över de %3 som stötvågen motsvarar (båda absoluta): kontrollera om det registrerade värdet är rätt.</translation>
    </message>
    <message>
        <source>The DUT&apos;s position is &apos;%1&apos;; it must be &apos;end-wall&apos; or &apos;side-wall&apos;.</source>
        <translation>DUT:s placering är &apos;%1&apos;; den ska vara &apos;end-wall&apos; eller &apos;side-wall&apos;.</translation>
    </message>
    <message>
        <source>The typed pressure step is %1 Pa; it must be a number other than 0.</source>
        <translation>Det inmatade trycksteget är %1 Pa; det ska vara ett annat tal än 0.</translation>
    </message>
    <message>
        <source>The arrival sensor &apos;%1&apos; has a distance to the end wall of %2 m; it must be above 0.</source>
        <translation>Ankomstgivaren &apos;%1&apos; har ett avstånd till ändväggen på %2 m; det ska vara större än 0.</translation>
    </message>
    <message>
        <source>The gas has a ratio of specific heats of %1; it must be above 1 and at most %2 (air: 1.402).</source>
        <translation>Gasens kvot mellan specifika värmen är %1; den ska vara större än 1 och högst %2 (luft: 1,402).</translation>
    </message>
    <message>
        <source>The gas has a molar mass of %1 kg/mol; it must lie between %2 and %3 kg/mol (air: 0.028966), so check whether it was typed in g/mol.</source>
        <translation>Gasens molmassa är %1 kg/mol; den ska ligga mellan %2 och %3 kg/mol (luft: 0,028966), så kontrollera om den matades in i g/mol.</translation>
    </message>
    <message>
        <source>%1 = %2 K? Temperatures are in kelvin here: %2 degrees Celsius are %3 K.</source>
        <translation>%1 = %2 K? Temperaturer anges här i kelvin: %2 grader Celsius är %3 K.</translation>
    </message>
    <message>
        <source>%1 = %2 K is outside the range of %3 K to %4 K; enter the temperature of the gas in kelvin.</source>
        <translation>%1 = %2 K ligger utanför området %3 K till %4 K; ange gasens temperatur i kelvin.</translation>
    </message>
    <message>
        <source>p1 = %1 Pa: the pressure in the driven section is absolute here and must be above 0; add the ambient pressure to a gauge reading.</source>
        <translation>p1 = %1 Pa: trycket i lågtrycksdelen är absolut här och ska vara större än 0; lägg omgivningstrycket till ett övertryck.</translation>
    </message>
    <message>
        <source>Computed Mach number %1 (velocity %2 m/s); a shock needs more than 1: check sample rate, distance, arrival times and T1.</source>
        <translation>Beräknat machtal %1 (hastighet %2 m/s); en stötvåg kräver mer än 1: kontrollera samplingsfrekvens, avstånd, ankomsttider och T1.</translation>
    </message>
    <message>
        <source>No driver pressure can produce a shock of Mach %1 with this driver gas at %2 K; check the velocity, T4 and the driver gas.</source>
        <translation>Inget drivtryck kan ge en stötvåg med machtal %1 med denna drivgas vid %2 K; kontrollera hastigheten, T4 och drivgasen.</translation>
    </message>
    <message>
        <source>The pressure step is not determined: the shock velocity is unknown, because the distance from the side sensor to the end wall is not recorded; enter the distance, the velocity or the step itself.</source>
        <translation>Trycksteget är inte bestämt: stötvågens hastighet är okänd, eftersom avståndet från sidogivaren till ändväggen inte är registrerat; ange avståndet, hastigheten eller själva steget.</translation>
    </message>
    <message>
        <source>The pressure step is not determined: the shock velocity is unknown, because no channel marks the passing of the shock; enter the velocity or the step itself.</source>
        <translation>Trycksteget är inte bestämt: stötvågens hastighet är okänd, eftersom ingen kanal markerar stötvågens passage; ange hastigheten eller själva steget.</translation>
    </message>
    <message>
        <source>The pressure step is not determined: the shock velocity is unknown, because no arrival is found in the channel &apos;%1&apos;; enter the velocity or the step itself.</source>
        <translation>Trycksteget är inte bestämt: stötvågens hastighet är okänd, eftersom ingen ankomst hittas i kanalen &apos;%1&apos;; ange hastigheten eller själva steget.</translation>
    </message>
    <message>
        <source>The pressure step is not determined: the shock velocity is unknown, because the arrival at the DUT is not known; enter the velocity or the step itself.</source>
        <translation>Trycksteget är inte bestämt: stötvågens hastighet är okänd, eftersom ankomsten till DUT inte är känd; ange hastigheten eller själva steget.</translation>
    </message>
    <message>
        <source>The pressure step is not determined: the shock velocity is unknown, because a DUT in the side wall needs two arrival sensors; enter the velocity or the step itself.</source>
        <translation>Trycksteget är inte bestämt: stötvågens hastighet är okänd, eftersom en DUT i sidoväggen kräver två ankomstgivare; ange hastigheten eller själva steget.</translation>
    </message>
    <message>
        <source>No resonance found below %1.</source>
        <translation>Ingen resonans hittades under %1.</translation>
    </message>
    <message>
        <source>The resonance differs between shots: %1 to %2, a spread of %3 %.</source>
        <translation>Resonansen skiljer sig mellan skotten: %1 till %2, en spridning på %3 %.</translation>
    </message>
    <message>
        <source>A power spectrum needs at least %1 valid samples at a known rate; there are %2 samples at %3.</source>
        <translation>Ett effektspektrum kräver minst %1 giltiga sampel med känd samplingsfrekvens; det finns %2 sampel vid %3.</translation>
    </message>
    <message>
        <source>window.start lists %1 times for %2 shots; give one time or one per shot.</source>
        <translation>window.start anger %1 tider för %2 skott; ange en tid, eller en för varje skott.</translation>
    </message>
    <message>
        <source>The band %1 to %2 in the window settings must begin before it ends.</source>
        <translation>Bandet %1 till %2 i fönsterinställningarna måste börja innan det slutar.</translation>
    </message>
    <message>
        <source>A time in the window settings is not a finite number.</source>
        <translation>En tid i fönsterinställningarna är inte ett ändligt tal.</translation>
    </message>
    <message>
        <source>Shot %1 has no DUT channel; choose which channel is the sensor under test (import.channels).</source>
        <translation>Skott %1 har ingen DUT-kanal; välj vilken kanal som är givaren under provning (import.channels).</translation>
    </message>
    <message>
        <source>Shot %1: the sample rate of channel %2 is unknown; give import.sample_rate_hz.</source>
        <translation>Skott %1: samplingsfrekvensen för kanal %2 är okänd; ange import.sample_rate_hz.</translation>
    </message>
    <message>
        <source>Shot %1: window.start %2 lies outside the record, which reaches from %3 to %4.</source>
        <translation>Skott %1: window.start %2 ligger utanför registreringen, som sträcker sig från %3 till %4.</translation>
    </message>
    <message>
        <source>Shot %1: the record moves before the response, its baseline is not at rest; the shot is not used. Exclude it, or set window.start and window.baseline_s by hand.</source>
        <translation>Skott %1: registreringen rör sig före svaret, dess baslinje är inte i vila; skottet används inte. Uteslut det, eller sätt window.start och window.baseline_s för hand.</translation>
    </message>
    <message>
        <source>Shot %1: no step between baseline and settle band; it is %2, and %3 would be needed to tell it from noise. Check window.start or exclude the shot.</source>
        <translation>Skott %1: inget steg mellan baslinje och slutnivåband; det är %2, och %3 skulle behövas för att skilja det från brus. Kontrollera window.start eller uteslut skottet.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: the start cannot be detected, because the record moves or holds no numbers from sample %3 (%4) on and at least %5 quiet samples are needed before. Set window.start by hand.</source>
        <translation>Skott %1, kanal %2: starten kan inte detekteras, eftersom registreringen rör sig eller saknar tal från och med sampel %3 (%4) och minst %5 lugna sampel behövs dessförinnan. Sätt window.start för hand.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: the start cannot be detected in %3 samples, at least %4 are needed. Set window.start by hand.</source>
        <translation>Skott %1, kanal %2: starten kan inte detekteras i %3 sampel, minst %4 behövs. Sätt window.start för hand.</translation>
    </message>
    <message>
        <source>Shot %1: the window is to end with the computed plateau, but there are no shock data to compute it from; give them or a time for window.end_s.</source>
        <translation>Skott %1: fönstret ska sluta med den beräknade platån, men det finns inga stötvågsdata att beräkna den ur; ange sådana, eller en tid för window.end_s.</translation>
    </message>
    <message>
        <source>Shot %1: the settle band %2 to %3 must lie within the window, 0 to %4 behind the start; move window.settle_s or window.end_s.</source>
        <translation>Skott %1: slutnivåbandet %2 till %3 måste ligga inom fönstret, 0 till %4 efter starten; flytta window.settle_s eller window.end_s.</translation>
    </message>
    <message>
        <source>Shot %1: the baseline %2 to %3 leaves the record, which reaches from %4 to %5 relative to the start; move window.baseline_s.</source>
        <translation>Skott %1: baslinjen %2 till %3 går utanför registreringen, som sträcker sig från %4 till %5 räknat från starten; flytta window.baseline_s.</translation>
    </message>
    <message>
        <source>Shot %1: the baseline has %2 samples and needs at least %3; choose another window.baseline_s, or null to subtract nothing.</source>
        <translation>Skott %1: baslinjen har %2 sampel och behöver minst %3; välj en annan window.baseline_s, eller null för att inte dra ifrån något.</translation>
    </message>
    <message>
        <source>Shot %1: the baseline %2 to %3 overlaps the response, which begins at 0; move window.baseline_s or window.end_s.</source>
        <translation>Skott %1: baslinjen %2 till %3 överlappar svaret, som börjar vid 0; flytta window.baseline_s eller window.end_s.</translation>
    </message>
    <message>
        <source>Shot %1 ends %2 behind its start, before the window&apos;s end at %3; set window.end_s to %2 at most or exclude the shot.</source>
        <translation>Skott %1 slutar %2 efter sin start, före fönstrets slut vid %3; sätt window.end_s till högst %2 eller uteslut skottet.</translation>
    </message>
    <message>
        <source>Shot %1: the window has %2 samples and needs at least %3; set window.end_s.</source>
        <translation>Skott %1: fönstret har %2 sampel och behöver minst %3; sätt window.end_s.</translation>
    </message>
    <message>
        <source>Shot %1: %2 samples in a row at %3 are equal and the extreme of the window; the record may be saturated there.</source>
        <translation>Skott %1: %2 samplingar i rad vid %3 är lika och fönstrets extremvärde; registreringen kan vara mättad där.</translation>
    </message>
    <message>
        <source>Shot %1: the step is negative (%2); set import.polarity to -1 if the sensor is inverted.</source>
        <translation>Skott %1: steget är negativt (%2); sätt import.polarity till -1 om givaren är inverterad.</translation>
    </message>
    <message>
        <source>Shot %1: the settling level still drifts %2 % of the step per ms; the level depends by +-%3 % on where the settle band lies.</source>
        <translation>Skott %1: slutnivån driver ännu %2 % av steget per ms; nivån beror med +-%3 % på var slutnivåbandet ligger.</translation>
    </message>
    <message>
        <source>Shot %1: the step uses %2 codes of the converter; quantisation limits the result.</source>
        <translation>Skott %1: steget utnyttjar %2 kodsteg i omvandlaren; kvantiseringen begränsar resultatet.</translation>
    </message>
    <message>
        <source>Shot %1: the window ends %2 after the computed end of the plateau, %3 behind the start; move window.end_s.</source>
        <translation>Skott %1: fönstret slutar %2 efter platåns beräknade slut, %3 efter starten; flytta window.end_s.</translation>
    </message>
    <message>
        <source>Shot %1: the baseline drifts %2 % of the step per ms, +-%3 % over the band.</source>
        <translation>Skott %1: baslinjen driver %2 % av steget per ms, +-%3 % över bandet.</translation>
    </message>
    <message>
        <source>Shot %1: SNR %2 dB; even a perfect model would score a FIT of about %3 %.</source>
        <translation>Skott %1: SNR %2 dB; även en fullkomlig modell skulle få ett FIT på ungefär %3 %.</translation>
    </message>
    <message>
        <source>There is no defect &apos;%1&apos;; choose one of %2.</source>
        <translation>Det finns ingen defekt &apos;%1&apos;; välj en av %2.</translation>
    </message>
    <message>
        <source>Defect &apos;%1&apos;: what follows &apos;@&apos; must be the number of a shot, from 1.</source>
        <translation>Defekt &apos;%1&apos;: det som följer efter &apos;@&apos; ska vara numret på ett skott, från 1.</translation>
    </message>
    <message>
        <source>A defect is asked for in shot %1, but the shots to simulate are 1 to %2.</source>
        <translation>En defekt begärs i skott %1, men skotten att simulera är 1 till %2.</translation>
    </message>
    <message>
        <source>The simulated sensor &apos;%1&apos; has %2 = %3; it must lie in %4 .. %5.</source>
        <translation>Den simulerade givaren &apos;%1&apos; har %2 = %3; det ska ligga i %4 .. %5.</translation>
    </message>
    <message>
        <source>The simulated sensor &apos;%1&apos; has %2 modes; it needs 1 to %3.</source>
        <translation>Den simulerade givaren &apos;%1&apos; har %2 moder; den ska ha 1 till %3.</translation>
    </message>
    <message>
        <source>The weights of the simulated sensor &apos;%1&apos; add up to %2; they must add up to 1.</source>
        <translation>Vikterna för den simulerade givaren &apos;%1&apos; har summan %2; summan ska vara 1.</translation>
    </message>
    <message>
        <source>Two real poles of the simulated sensor &apos;%1&apos; coincide at %2 Hz; move one of them.</source>
        <translation>Två reella poler hos den simulerade givaren &apos;%1&apos; sammanfaller vid %2 Hz; flytta en av dem.</translation>
    </message>
    <message>
        <source>There is no sensor preset &apos;%1&apos;; choose one of %2.</source>
        <translation>Det finns ingen förinställd givare &apos;%1&apos;; välj en av %2.</translation>
    </message>
    <message>
        <source>The simulation is asked for %1 = %2; it must lie in %3 .. %4.</source>
        <translation>Simuleringen begärs med %1 = %2; det ska ligga i %3 .. %4.</translation>
    </message>
    <message>
        <source>The simulated sensor &apos;%1&apos; rings at %2, which a sample rate of %3 cannot show; it needs more than %4.</source>
        <translation>Den simulerade givaren &apos;%1&apos; ringer vid %2, vilket en samplingsfrekvens på %3 inte kan visa; det krävs mer än %4.</translation>
    </message>
    <message>
        <source>A shot to simulate has no level; choose low, medium or high.</source>
        <translation>Ett skott att simulera saknar nivå; välj low, medium eller high.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Avbrutet.</translation>
    </message>
    <message>
        <source>There is not enough memory for this work; close other programs or choose a shorter window.</source>
        <translation>Minnet räcker inte för detta arbete; stäng andra program eller välj ett kortare fönster.</translation>
    </message>
    <message>
        <source>The program met an unexpected condition (%1); please report it with your project file.</source>
        <translation>Programmet stötte på ett oväntat tillstånd (%1); rapportera det tillsammans med projektfilen.</translation>
    </message>
    <message>
        <source>Project %1 is a folder or a device, not a file; name a project file.</source>
        <translation>Projektet %1 är en mapp eller en enhet, inte en fil; ange en projektfil.</translation>
    </message>
    <message>
        <source>Project %1 cannot be opened (%2).</source>
        <translation>Projektet %1 kan inte öppnas (%2).</translation>
    </message>
    <message>
        <source>%1 is not a Dyncal project; recordings are opened with Open captures.</source>
        <translation>%1 är inget Dyncal-projekt; registreringar öppnas med Öppna registreringar.</translation>
    </message>
    <message>
        <source>%1 changed since it was imported. The results are of the new data and cannot be certified in this project.</source>
        <translation>%1 har ändrats sedan importen. Resultaten avser nya data och kan inte intygas i detta projekt.</translation>
    </message>
    <message>
        <source>The project could not be saved as %1 (%M1); choose another place.</source>
        <translation>Projektet kunde inte sparas som %1 (%M1); välj en annan plats.</translation>
    </message>
    <message>
        <source>%1 recordings of this project were not found: %2. Put them back where they were, or beside the project, and open it again.</source>
        <translation>%1 registreringar i detta projekt hittades inte: %2. Lägg tillbaka dem där de låg, eller bredvid projektet, och öppna det igen.</translation>
    </message>
    <message>
        <source>%1, line %2 has %3 cells, the lines before have %4; correct the line, or set separator and decimal in the recipe&apos;s import section.</source>
        <translation>%1, rad %2 har %3 celler, raderna före har %4; rätta raden, eller ange separator och decimal i receptets avsnitt import.</translation>
    </message>
    <message>
        <source>%1 ends within line %2, so it is likely an incomplete copy; that line was left out.</source>
        <translation>%1 slutar mitt i rad %2 och är därför troligen en ofullständig kopia; den raden utelämnades.</translation>
    </message>
    <message>
        <source>%1 ends without a line end; if the copy is incomplete, the last number in line %2 may lack digits.</source>
        <translation>%1 slutar utan radslut; om kopian är ofullständig kan det sista talet på rad %2 sakna siffror.</translation>
    </message>
    <message>
        <source>%1 has no column %2 for %3; it has the columns 0 to %4. Change columns in the recipe&apos;s import section.</source>
        <translation>%1 har ingen kolumn %2 för %3; filen har kolumnerna 0 till %4. Ändra columns i receptets avsnitt import.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; can be read in two ways; the comma was taken as %3. Set decimal and separator in the recipe&apos;s import section to be certain.</source>
        <translation>%1: &quot;%2&quot; kan läsas på två sätt; kommatecknet tolkades som %3. Ange decimal och separator i receptets avsnitt import för att vara säker.</translation>
    </message>
    <message>
        <source>%1 holds no rows of numbers that fit together; check separator, decimal and skip_rows in the recipe&apos;s import section.</source>
        <translation>%1 innehåller inga rader med tal som hör ihop; kontrollera separator, decimal och skip_rows i receptets avsnitt import.</translation>
    </message>
    <message>
        <source>%1 has a column of times but no column of samples.</source>
        <translation>%1 har en kolumn med tider men ingen kolumn med sampel.</translation>
    </message>
    <message>
        <source>%1 cannot be read; check that it exists and may be opened.</source>
        <translation>%1 kan inte läsas; kontrollera att filen finns och får öppnas.</translation>
    </message>
    <message>
        <source>%1, line %2, column %3: &quot;%4&quot; is no number; correct the cell, or set decimal, separator or skip_rows in the recipe&apos;s import section.</source>
        <translation>%1, rad %2, kolumn %3: &quot;%4&quot; är inget tal; rätta cellen, eller ange decimal, separator eller skip_rows i receptets avsnitt import.</translation>
    </message>
    <message>
        <source>%1: column &quot;%2&quot; holds other times than column &quot;%3&quot;, and one shot has one sample rate. Save each with its samples in a file of its own, or name the columns of one of them, time included, in the recipe&apos;s import section.</source>
        <translation>%1: kolumn ”%2” innehåller andra tider än kolumn ”%3”, och ett skott har en enda samplingsfrekvens. Spara var och en med sina sampel i en egen fil, eller namnge kolumnerna för en av dem, tiden inräknad, i receptets avsnitt import.</translation>
    </message>
    <message>
        <source>%1: the times are not uniform: line %2 follows its predecessor by %3, others by %4 (allowed is 1 %). Record anew, or name only the columns of samples and give the sample rate in the recipe&apos;s import section.</source>
        <translation>%1: tiderna är inte jämnt fördelade: rad %2 följer sin föregångare med %3, andra med %4 (1 % är tillåtet). Gör om registreringen, eller ange bara kolumnerna med sampel och ge samplingsfrekvensen i receptets avsnitt import.</translation>
    </message>
    <message>
        <source>%1: the unit &quot;%2&quot; of the column of times is unknown; write s, ms, us or ns.</source>
        <translation>%1: tidskolumnens enhet &quot;%2&quot; är okänd; skriv s, ms, us eller ns.</translation>
    </message>
    <message>
        <source>Shot %1 has %2 samples in its window, too few to be reduced %3 times to the rate of the other shots; set window.end_s or exclude a shot.</source>
        <translation>Skott %1 har %2 sampel i sitt fönster, för få för att reduceras %3 gånger till de andra skottens samplingsfrekvens; sätt window.end_s eller uteslut ett skott.</translation>
    </message>
    <message>
        <source>Shot %1: %2 % of the resonance at %3 is left in the residual; its amplitude or its time varies between the shots.</source>
        <translation>Skott %1: %2 % av resonansen vid %3 finns kvar i residualen; dess amplitud eller tidpunkt varierar mellan skotten.</translation>
    </message>
    <message>
        <source>Shot %1: the step reads %2; %3 is expected. Is the unit %4? Set import.unit.</source>
        <translation>Skott %1: steget avläses till %2; %3 förväntas. Är enheten %4? Sätt import.unit.</translation>
    </message>
    <message>
        <source>Shot %1: the step reads %2; %3 is expected. Check the unit and the scale.</source>
        <translation>Skott %1: steget avläses till %2; %3 förväntas. Kontrollera enheten och skalan.</translation>
    </message>
    <message>
        <source>The shots are recorded in different units, so their sensitivities are not averaged; give one unit for all (import.unit).</source>
        <translation>Skotten är registrerade i olika enheter, så deras känsligheter medelvärdesbildas inte; ange en enhet för alla (import.unit).</translation>
    </message>
    <message>
        <source>The power spectrum exceeds the range of numbers: the largest value is %1; check the scale of the channel.</source>
        <translation>Effektspektrumet överskrider talområdet: det största värdet är %1; kontrollera kanalens skala.</translation>
    </message>
    <message>
        <source>%1 ends before its first row of samples, so it is likely an incomplete copy; copy it again.</source>
        <translation>%1 slutar före sin första rad med sampel och är därför troligen en ofullständig kopia; kopiera den på nytt.</translation>
    </message>
    <message>
        <source>%1, line %2: the line of column names does not have the channels that the header declares; the file is damaged.</source>
        <translation>%1, rad %2: raden med kolumnnamn har inte de kanaler som filhuvudet anger; filen är skadad.</translation>
    </message>
    <message>
        <source>%1: behind segment %2 a header without rows of samples follows, so the file is likely an incomplete copy.</source>
        <translation>%1: efter segment %2 följer ett huvud utan rader med sampel, så filen är troligen en ofullständig kopia.</translation>
    </message>
    <message>
        <source>%1: Delta_X of channel %2 is %3, but its X values are not uniform or step by %4 on average; state the sample rate in the recipe&apos;s import section if it is known.</source>
        <translation>%1: Delta_X för kanal %2 är %3, men dess X-värden är inte jämnt fördelade eller har medelsteget %4; ange samplingsfrekvensen i receptets avsnitt import om den är känd.</translation>
    </message>
    <message>
        <source>%1: channel %2 has %3 samples where its header declares %4; if it has fewer, the file may be an incomplete copy.</source>
        <translation>%1: kanal %2 har %3 sampel där filhuvudet anger %4; om de är färre kan filen vara en ofullständig kopia.</translation>
    </message>
    <message>
        <source>%1 is no LabVIEW measurement file: it does not begin with &quot;LabVIEW Measurement&quot;.</source>
        <translation>%1 är ingen LabVIEW-mätfil: den börjar inte med &quot;LabVIEW Measurement&quot;.</translation>
    </message>
    <message>
        <source>Model input: shot %1 is recorded at %2, below the model rate of %3; choose at most %2.</source>
        <translation>Modellindata: skott %1 är registrerat med %2, under modellens samplingsfrekvens %3; välj högst %2.</translation>
    </message>
    <message>
        <source>%1 states a sampling interval of %2 s for channel %3, which cannot be; state the sample rate in the recipe&apos;s import section if it is known.</source>
        <translation>%1 anger ett samplingsintervall på %2 s för kanal %3, vilket inte kan stämma; ange samplingsfrekvensen i receptets importdel om den är känd.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; was left out, because it is no sampled signal (%3).</source>
        <translation>%1: ”%2” utelämnades, eftersom det inte är en samplad signal (%3).</translation>
    </message>
    <message>
        <source>%1 ends before its first sample, so it is likely an incomplete copy; copy it again.</source>
        <translation>%1 slutar före sitt första sampel och är därför troligen en ofullständig kopia; kopiera den igen.</translation>
    </message>
    <message>
        <source>%1 ends after %3 of the %4 samples of channel %2 that its header declares, so it is likely an incomplete copy; copy it again.</source>
        <translation>%1 slutar efter %3 av de %4 sampel i kanal %2 som huvudet anger och är därför troligen en ofullständig kopia; kopiera den igen.</translation>
    </message>
    <message>
        <source>%1 is damaged: its header states %2 as %3, which cannot be; copy the file again.</source>
        <translation>%1 är skadad: huvudet anger %2 som %3, vilket inte kan stämma; kopiera filen igen.</translation>
    </message>
    <message>
        <source>%1 is a recording of kind %2, which this version does not read; save it as CSV.</source>
        <translation>%1 är en registrering av slaget %2, som denna version inte läser; spara den som CSV.</translation>
    </message>
    <message>
        <source>%1: the header names %2 columns but the rows have %3 cells, so the comma seems to be both separator and decimal mark; export with another separator, or state separator and decimal in the recipe&apos;s import section.</source>
        <translation>%1: huvudet namnger %2 kolumner men raderna har %3 celler, så kommat tycks vara både skiljetecken och decimaltecken; exportera med ett annat skiljetecken, eller ange separator och decimal i receptets importdel.</translation>
    </message>
    <message>
        <source>%1: line %2 is a row of %3 numbers like the data, but other text follows it; it was taken as header. Set skip_rows in the recipe&apos;s import section to be certain.</source>
        <translation>%1: rad %2 är en rad med %3 tal som mätdata, men annan text följer efter den; den togs som huvud. Ange skip_rows i receptets importdel för att vara säker.</translation>
    </message>
    <message>
        <source>%1: line %2 has %3 cells above %4 columns, so the columns are numbered, not named.</source>
        <translation>%1: rad %2 har %3 celler över %4 kolumner, så kolumnerna är numrerade, inte namngivna.</translation>
    </message>
    <message>
        <source>%1 begins like a header of %2 samples at %3, but has %4 lines, so it is likely an incomplete copy. Copy it again, or set skip_rows in the recipe&apos;s import section.</source>
        <translation>%1 börjar som ett huvud för %2 sampel med %3 men har %4 rader, så den är troligen en ofullständig kopia. Kopiera den igen, eller ange skip_rows i receptets importdel.</translation>
    </message>
    <message>
        <source>%1: the first %2 lines were taken as header, as they count the %3 lines behind: the sample rate is %4.</source>
        <translation>%1: de första %2 raderna togs som huvud, eftersom de räknar de %3 raderna efter: samplingsfrekvensen är %4.</translation>
    </message>
    <message>
        <source>%1, line %2 follows %3 blank lines; the file is damaged, or it holds two tables.</source>
        <translation>%1, rad %2 kommer efter %3 tomma rader; filen är skadad eller innehåller två tabeller.</translation>
    </message>
    <message>
        <source>%1, line %2 is a comment within the data; take it out if the rows around it follow each other, else save them as two files.</source>
        <translation>%1, rad %2 är en kommentar bland mätdata; ta bort den om raderna omkring följer på varandra, spara dem annars som två filer.</translation>
    </message>
    <message>
        <source>%1 states no sample rate and has no column of times; give the sample rate.</source>
        <translation>%1 anger ingen samplingsfrekvens och har ingen tidskolumn; ange samplingsfrekvensen.</translation>
    </message>
    <message>
        <source>%1 is no recording over time: its first column, &quot;%2&quot;, holds frequencies. If it holds samples, say so under columns in the recipe&apos;s import section.</source>
        <translation>%1 är ingen registrering över tid: dess första kolumn, ”%2”, innehåller frekvenser. Om den innehåller sampel, ange det under columns i receptets importdel.</translation>
    </message>
    <message>
        <source>%1: line %2 of the header (&quot;%3&quot;) means %4, but line %5 (&quot;%6&quot;) means %7. Which one is right? State sample_rate_hz in the recipe&apos;s import section.</source>
        <translation>%1: rad %2 i huvudet (”%3”) betyder %4, men rad %5 (”%6”) betyder %7. Vilken stämmer? Ange sample_rate_hz i receptets importdel.</translation>
    </message>
    <message>
        <source>%1: line %2 of the header (&quot;%3&quot;) means %4, but the column of times steps at %5. Which one is right? State sample_rate_hz in the recipe&apos;s import section; to go against the times, name only the columns of samples there, too.</source>
        <translation>%1: rad %2 i huvudet (”%3”) betyder %4, men tidskolumnen stegar med %5. Vilken stämmer? Ange sample_rate_hz i receptets importdel; för att gå emot tiderna, namnge dessutom bara kolumnerna med sampel där.</translation>
    </message>
    <message>
        <source>%1: the stated sample rate is %2, but the times, which have no unit, step by %3: that fits neither in s nor in ms, us or ns. Correct the rate, or name only the columns of samples in the recipe&apos;s import section.</source>
        <translation>%1: den angivna samplingsfrekvensen är %2, men tiderna, som saknar enhet, stegar med %3: det stämmer varken i s, ms, us eller ns. Rätta frekvensen, eller namnge bara kolumnerna med sampel i receptets importdel.</translation>
    </message>
    <message>
        <source>%1: line %2 of the header (&quot;%3&quot;) means %4, but recipe and column of times agree on %5, which was taken.</source>
        <translation>%1: rad %2 i huvudet (”%3”) betyder %4, men recept och tidskolumn är överens om %5, som används.</translation>
    </message>
    <message>
        <source>%1: line %2 of the header (&quot;%3&quot;) has no unit; in Hz or s it means %4, which was taken as the sample rate.</source>
        <translation>%1: rad %2 i huvudet (”%3”) saknar enhet; i Hz eller s betyder den %4, som används som samplingsfrekvens.</translation>
    </message>
    <message>
        <source>%1: the recipe&apos;s sample rate of %2 was taken although the file&apos;s column of times steps at %3.</source>
        <translation>%1: receptets samplingsfrekvens %2 används trots att filens tidskolumn stegar med %3.</translation>
    </message>
    <message>
        <source>%1: column &quot;%2&quot; only counts the rows, so the sample rate is unknown; state sample_rate_hz in the recipe&apos;s import section.</source>
        <translation>%1: kolumn ”%2” räknar bara raderna, så samplingsfrekvensen är okänd; ange sample_rate_hz i receptets importdel.</translation>
    </message>
    <message>
        <source>%1: column &quot;%2&quot; steps by %3 without a unit, so the sample rate is unknown; state sample_rate_hz in the recipe&apos;s import section.</source>
        <translation>%1: kolumn ”%2” stegar med %3 utan enhet, så samplingsfrekvensen är okänd; ange sample_rate_hz i receptets importdel.</translation>
    </message>
    <message>
        <source>%1: column &quot;%2&quot; has no unit; its numbers were taken as seconds, which makes the sample rate %3. If that is wrong, write the unit into the title.</source>
        <translation>%1: kolumn ”%2” saknar enhet; dess tal togs som sekunder, vilket ger samplingsfrekvensen %3. Om det är fel, skriv enheten i rubriken.</translation>
    </message>
    <message>
        <source>%1: the recipe leaves the column of times out, but at line %2 it is not uniform; if samples are missing there, all behind them is shifted.</source>
        <translation>%1: receptet utelämnar tidskolumnen, men vid rad %2 är den ojämn; om sampel saknas där är allt efter dem förskjutet.</translation>
    </message>
    <message>
        <source>%1: column &quot;%2&quot; rises from row to row like times, but neither title nor unit says so; it was read as samples. If it holds times, name it time under columns in the recipe&apos;s import section.</source>
        <translation>%1: kolumn ”%2” stiger från rad till rad som tider, men varken rubrik eller enhet säger det; den lästes som sampel. Om den innehåller tider, namnge den time under columns i receptets importdel.</translation>
    </message>
    <message>
        <source>%1 was written as a stream without its length; it was read up to its end (%2 samples per channel), which nothing confirms.</source>
        <translation>%1 skrevs som en ström utan längd; den lästes till sitt slut (%2 sampel per kanal), vilket inget bekräftar.</translation>
    </message>
    <message>
        <source>%1 ends after %2 of the %3 samples per channel that it declares, or within one; it is likely an incomplete copy.</source>
        <translation>%1 slutar efter %2 av de %3 sampel per kanal som den anger, eller mitt i ett; den är troligen en ofullständig kopia.</translation>
    </message>
    <message>
        <source>%1 states %2 samples per second, but its bytes per second mean %3; state the sample rate in the recipe&apos;s import section if it is known.</source>
        <translation>%1 anger %2 sampel per sekund, men dess byte per sekund betyder %3; ange samplingsfrekvensen i receptets importdel om den är känd.</translation>
    </message>
    <message>
        <source>The profile cannot be kept as &quot;%1&quot;; choose another name.</source>
        <translation>Profilen kan inte sparas som ”%1”; välj ett annat namn.</translation>
    </message>
    <message>
        <source>Shot %1, channel &apos;%2&apos;: the samples cannot be read any more, because the file changed or is out of reach; open it again.</source>
        <translation>Skott %1, kanal &apos;%2&apos;: samplen kan inte längre läsas, eftersom filen ändrats eller inte går att nå; öppna den igen.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos; of shot %2 is flat: its standard deviation is %3 codes of the converter (%4 is the limit). Check cable and role.</source>
        <translation>Kanal &apos;%1&apos; i skott %2 är platt: dess standardavvikelse är %3 koder i omvandlaren (gränsen är %4). Kontrollera kabel och roll.</translation>
    </message>
    <message>
        <source>Shot %1, %2: %3 invalid samples from %4 on (samples %5 to %6). Inside the response window they block the shot; exclude it or set import.interpolate_invalid.</source>
        <translation>Skott %1, %2: %3 ogiltiga sampel från %4 (sampel %5 till %6). Inuti svarsfönstret blockerar de skottet; uteslut det eller ange import.interpolate_invalid.</translation>
    </message>
    <message>
        <source>Shot %1%2 and shot %3%4 hold identical data; a shot counted twice makes the scatter look smaller than it is. Exclude one of them.</source>
        <translation>Skott %1%2 och skott %3%4 innehåller identiska data; ett skott som räknas två gånger får spridningen att se mindre ut än den är. Uteslut ett av dem.</translation>
    </message>
    <message>
        <source>%1 changed since it was opened; open it again, or take an unchanged copy.</source>
        <translation>%1 har ändrats sedan den öppnades; öppna den igen, eller ta en oförändrad kopia.</translation>
    </message>
    <message>
        <source>%1 is damaged: the samples of shot %2, channel &apos;%3&apos; are not those that were recorded (their SHA-256 differs from the one in the file); take an unchanged copy.</source>
        <translation>%1 är skadad: samplen i skott %2, kanal &apos;%3&apos; är inte de som registrerades (deras SHA-256 avviker från den i filen); ta en oförändrad kopia.</translation>
    </message>
    <message>
        <source>%1: the samples of shot %2, channel &apos;%3&apos; cannot be read any more; check the drive or the network, or copy the file again.</source>
        <translation>%1: samplen i skott %2, kanal &apos;%3&apos; kan inte längre läsas; kontrollera disken eller nätverket, eller kopiera filen igen.</translation>
    </message>
    <message>
        <source>Shot %1, channel &apos;%2&apos;: the file states %3 but import.sample_rate_hz is %4. Leave the key out, or say in import.sample_rate_reason why the file is wrong.</source>
        <translation>Skott %1, kanal &apos;%2&apos;: filen anger %3 men import.sample_rate_hz är %4. Utelämna nyckeln, eller ange i import.sample_rate_reason varför filen har fel.</translation>
    </message>
    <message>
        <source>The recipe&apos;s sample rate of %1 replaces the %2 that the files state.</source>
        <translation>Receptets samplingsfrekvens %1 ersätter %2 som filerna anger.</translation>
    </message>
    <message>
        <source>The recipe&apos;s sample rate of %1 replaces the %2 that the files state; reason: %3.</source>
        <translation>Receptets samplingsfrekvens %1 ersätter %2 som filerna anger; skäl: %3.</translation>
    </message>
    <message>
        <source>Shot %1, channel &apos;%2&apos; is a pressure already (%3), so it cannot have a sensitivity; leave out the sensitivity or give its unit, e.g. V.</source>
        <translation>Skott %1, kanal &apos;%2&apos; är redan ett tryck (%3) och kan därför inte ha en känslighet; utelämna känsligheten eller ange enheten, t.ex. V.</translation>
    </message>
    <message>
        <source>A recording cannot be read any more: its file was changed or is gone; add it again.</source>
        <translation>En registrering kan inte längre läsas: filen har ändrats eller saknas; lägg till den igen.</translation>
    </message>
    <message>
        <source>%1 holds nothing that is a sampled signal; save the recorded channel itself.</source>
        <translation>%1 innehåller inget som är en samplad signal; spara själva den registrerade kanalen.</translation>
    </message>
    <message>
        <source>%1: %2 has more than 1024 attributes, which no capture has; the file is damaged.</source>
        <translation>%1: %2 har fler än 1024 attribut, vilket ingen registrering har; filen är skadad.</translation>
    </message>
    <message>
        <source>%1: channel %2 holds integers of more than 53 bits, which would be rounded; save them as 32 bit integers with scale and offset, or as floating point numbers.</source>
        <translation>%1: kanal %2 innehåller heltal på mer än 53 bitar, som skulle avrundas; spara dem som 32-bitars heltal med skala och offset, eller som flyttal.</translation>
    </message>
    <message>
        <source>%1: channel %2 would make more than 4 GiB unpacked; save the file without compression.</source>
        <translation>%1: kanal %2 skulle uppta mer än 4 GiB uppackad; spara filen utan komprimering.</translation>
    </message>
    <message>
        <source>%1 uses the comma as separator and as decimal mark, so its numbers cannot be told apart; save it again with tabs as separator.</source>
        <translation>%1 använder kommat som både skiljetecken och decimaltecken, så talen kan inte skiljas åt; spara den igen med tabb som skiljetecken.</translation>
    </message>
    <message>
        <source>%1, line %2 has %3 cells more than the header has columns; the file is damaged.</source>
        <translation>%1, rad %2 har %3 celler fler än huvudet har kolumner; filen är skadad.</translation>
    </message>
    <message>
        <source>%1: Delta_X of channel %2 is printed with so few digits that its sample rate of %3 is known to %4 % only, so it was not taken; state sample_rate_hz in the recipe&apos;s import section.</source>
        <translation>%1: Delta_X för kanal %2 är skriven med så få siffror att samplingsfrekvensen %3 bara är känd till %4 %, så den användes inte; ange sample_rate_hz i receptets importdel.</translation>
    </message>
    <message>
        <source>%1: the sample rate of channel %2, %3, is known to %4 % only, as Delta_X is printed with few digits; state sample_rate_hz in the recipe&apos;s import section if you know it better.</source>
        <translation>%1: samplingsfrekvensen för kanal %2, %3, är bara känd till %4 %, eftersom Delta_X är skriven med få siffror; ange sample_rate_hz i receptets importdel om du känner den bättre.</translation>
    </message>
    <message>
        <source>%1: the header declares %2 channels, but %3 columns have names; the last ones were not read.</source>
        <translation>%1: huvudet anger %2 kanaler, men %3 kolumner har namn; de sista lästes inte.</translation>
    </message>
    <message>
        <source>%1: %2 of %3 channels have no samples and were left out.</source>
        <translation>%1: %2 av %3 kanaler har inga sampel och utelämnades.</translation>
    </message>
    <message>
        <source>%1: channel %2 has %3 samples where its header declares %4, so blocks were appended and are read as one record. If each is a shot of its own, save with one header per segment.</source>
        <translation>%1: kanal %2 har %3 sampel där huvudet anger %4, så block har lagts till och läses som en registrering. Om varje block är ett eget skott, spara med ett huvud per segment.</translation>
    </message>
    <message>
        <source>%1: the 64-bit integers of %2 are too long to be kept exactly; save them as double.</source>
        <translation>%1: 64-bitars heltalen i %2 är för långa för att behållas exakt; spara dem som double.</translation>
    </message>
    <message>
        <source>%1 ends within its variable number %2, so it is likely an incomplete copy; copy it again.</source>
        <translation>%1 slutar mitt i sin variabel nummer %2 och är därför troligen en ofullständig kopia; kopiera den igen.</translation>
    </message>
    <message>
        <source>%1 is damaged: the header of its variable number %2 contradicts itself; copy the file again.</source>
        <translation>%1 är skadad: huvudet för variabel nummer %2 motsäger sig självt; kopiera filen igen.</translation>
    </message>
    <message>
        <source>%1 is damaged: its compressed variable number %2 does not expand to what it declares; copy the file again.</source>
        <translation>%1 är skadad: den komprimerade variabeln nummer %2 packas inte upp till vad den anger; kopiera filen igen.</translation>
    </message>
    <message>
        <source>%1: the sample rate is stated as %2, but %3 steps by %4, which fits it in no unit of time, so the rate is unknown. Which one is right? State it in the recipe&apos;s import section.</source>
        <translation>%1: samplingsfrekvensen anges som %2, men %3 stegar med %4, vilket inte stämmer i någon tidsenhet, så frekvensen är okänd. Vilken stämmer? Ange den i receptets importdel.</translation>
    </message>
    <message>
        <source>%1: %2 has no unit and was taken as seconds, which makes the sample rate %3; state the rate in the recipe&apos;s import section if it is another.</source>
        <translation>%1: %2 saknar enhet och togs som sekunder, vilket ger samplingsfrekvensen %3; ange frekvensen i receptets importdel om den är en annan.</translation>
    </message>
    <message>
        <source>%1: %2 increases uniformly by %3 and was taken as the times, but its unit is said nowhere. State the sample rate in the recipe&apos;s import section: %4 if they are seconds, %5 if milliseconds, %6 if microseconds.</source>
        <translation>%1: %2 ökar jämnt med %3 och togs som tider, men enheten anges ingenstans. Ange samplingsfrekvensen i receptets importdel: %4 om det är sekunder, %5 om millisekunder, %6 om mikrosekunder.</translation>
    </message>
    <message>
        <source>%1 describes samples that are in %2, which cannot be opened; put both files into one folder.</source>
        <translation>%1 beskriver sampel som finns i %2, som inte kan öppnas; lägg båda filerna i samma mapp.</translation>
    </message>
    <message>
        <source>%2 does not hold the samples that %1 describes; copy both files again, from the same recording.</source>
        <translation>%2 innehåller inte de sampel som %1 beskriver; kopiera båda filerna igen, från samma registrering.</translation>
    </message>
    <message>
        <source>%1 states a sampling interval of %2 s, but a record from end to end that means %3 s, so the rate is unknown; state it in the recipe&apos;s import section.</source>
        <translation>%1 anger samplingsintervallet %2 s, men en total längd som betyder %3 s, så frekvensen är okänd; ange den i receptets importdel.</translation>
    </message>
    <message>
        <source>%1 holds only the samples of a Rohde &amp; Schwarz recording; open %2, which describes them.</source>
        <translation>%1 innehåller bara samplen i en registrering från Rohde &amp; Schwarz; öppna %2, som beskriver dem.</translation>
    </message>
    <message>
        <source>Channel %1 has no samples.</source>
        <translation>Kanal %1 har inga sampel.</translation>
    </message>
    <message>
        <source>Channel %1 has values of the type %2, no samples.</source>
        <translation>Kanal %1 har värden av typen %2, inga sampel.</translation>
    </message>
    <message>
        <source>%1: channel %2 holds counts of the converter and no scale; state scale and unit, or its values mean nothing.</source>
        <translation>%1: kanal %2 innehåller omvandlarkoder och ingen skala; ange skala och enhet, annars betyder värdena inget.</translation>
    </message>
    <message>
        <source>%1: a channel was left out. %M1</source>
        <translation>%1: en kanal utelämnades. %M1</translation>
    </message>
    <message>
        <source>%1 has no channel that can be read. %M1</source>
        <translation>%1 har ingen kanal som kan läsas. %M1</translation>
    </message>
    <message>
        <source>%1 holds no data; it is likely an incomplete copy or a recording that never began.</source>
        <translation>%1 innehåller inga data; den är troligen en ofullständig kopia eller en registrering som aldrig började.</translation>
    </message>
    <message>
        <source>%1 is of the TDMS version %2, which this program does not know; it was read like version 4713.</source>
        <translation>%1 har TDMS-version %2, som programmet inte känner; den lästes som version 4713.</translation>
    </message>
    <message>
        <source>%M1 What stands before was read.</source>
        <translation>%M1 Det som står före lästes.</translation>
    </message>
    <message>
        <source>%1 was not closed by the program that wrote it, or its end is missing; all values that are there were read.</source>
        <translation>%1 stängdes inte av programmet som skrev den, eller så saknas slutet; alla värden som finns lästes.</translation>
    </message>
    <message>
        <source>%1 is incomplete: channel %2 has %3 of %4 samples. All values that are there were read; copy the file again if the original is whole.</source>
        <translation>%1 är ofullständig: kanal %2 har %3 av %4 sampel. Alla värden som finns lästes; kopiera filen igen om originalet är helt.</translation>
    </message>
    <message>
        <source>%1: channel %2 states no time between samples (wf_increment); give import.sample_rate_hz in the recipe.</source>
        <translation>%1: kanal %2 anger ingen tid mellan sampel (wf_increment); ange import.sample_rate_hz i receptet.</translation>
    </message>
    <message>
        <source>%1 is damaged: the samples of the segment at byte %2 would begin behind its end.</source>
        <translation>%1 är skadad: samplen i segmentet vid byte %2 skulle börja efter dess slut.</translation>
    </message>
    <message>
        <source>%1 is damaged: at byte %2, where a segment should begin, there is none.</source>
        <translation>%1 är skadad: vid byte %2, där ett segment borde börja, finns inget.</translation>
    </message>
    <message>
        <source>%1 is damaged: up to byte %2 it names more channels than any recording has.</source>
        <translation>%1 är skadad: fram till byte %2 namnger den fler kanaler än någon registrering har.</translation>
    </message>
    <message>
        <source>%1 is damaged: the segment at byte %2 has an object with the name %3, which is no path.</source>
        <translation>%1 är skadad: segmentet vid byte %2 har ett objekt med namnet %3, som inte är en sökväg.</translation>
    </message>
    <message>
        <source>%1 is damaged: the segment at byte %2 says that the data of %3 are as before, but there were none.</source>
        <translation>%1 är skadad: segmentet vid byte %2 säger att data för %3 är som förut, men det fanns inga.</translation>
    </message>
    <message>
        <source>%1: the samples of %3 change their type in the segment at byte %2; such a record cannot be read as one.</source>
        <translation>%1: samplen i %3 byter typ i segmentet vid byte %2; en sådan registrering kan inte läsas som en.</translation>
    </message>
    <message>
        <source>%1 is damaged: up to the segment at byte %2 it lists far more channels than it has samples.</source>
        <translation>%1 är skadad: fram till segmentet vid byte %2 räknar den upp långt fler kanaler än den har sampel.</translation>
    </message>
    <message>
        <source>%1 is only the index of a TDMS file and holds no samples; open %2, which belongs to it.</source>
        <translation>%1 är bara indexet till en TDMS-fil och innehåller inga sampel; öppna %2, som hör till.</translation>
    </message>
    <message>
        <source>%1 is no TDMS file: it does not begin with &quot;TDSm&quot;.</source>
        <translation>%1 är ingen TDMS-fil: den börjar inte med ”TDSm”.</translation>
    </message>
    <message>
        <source>%1 is damaged: the segment at byte %2 interleaves channels of different lengths, or texts.</source>
        <translation>%1 är skadad: segmentet vid byte %2 flätar samman kanaler av olika längd, eller texter.</translation>
    </message>
    <message>
        <source>%1 is damaged: the segment at byte %2 declares more samples than any file can hold.</source>
        <translation>%1 är skadad: segmentet vid byte %2 anger fler sampel än någon fil kan innehålla.</translation>
    </message>
    <message>
        <source>%1 is damaged: the segment at byte %2 mixes DAQmx raw data with other samples.</source>
        <translation>%1 är skadad: segmentet vid byte %2 blandar DAQmx-rådata med andra sampel.</translation>
    </message>
    <message>
        <source>%1 is damaged: the description of the segment at byte %2 ends before all that it declares.</source>
        <translation>%1 är skadad: beskrivningen av segmentet vid byte %2 slutar före allt den anger.</translation>
    </message>
    <message>
        <source>%1 is damaged: the segment at byte %2 declares %3 %4, more than it has room for or than any recording has.</source>
        <translation>%1 är skadad: segmentet vid byte %2 anger %3 %4, mer än det har plats för eller än någon registrering har.</translation>
    </message>
    <message>
        <source>%1: channel %3 (segment at byte %2) has samples of the type %4, which cannot be read; write them as integers or float64.</source>
        <translation>%1: kanal %3 (segment vid byte %2) har sampel av typen %4, som inte kan läsas; skriv dem som heltal eller float64.</translation>
    </message>
    <message>
        <source>%1: channel %3 (segment at byte %2) has DAQmx counts of the unknown type %4.</source>
        <translation>%1: kanal %3 (segment vid byte %2) har DAQmx-koder av den okända typen %4.</translation>
    </message>
    <message>
        <source>%1: channel %3 (segment at byte %2) has digital lines of several bytes in big-endian order, which cannot be read.</source>
        <translation>%1: kanal %3 (segment vid byte %2) har digitala linjer på flera byte i big-endian-ordning, som inte kan läsas.</translation>
    </message>
    <message>
        <source>%1 is damaged: the DAQmx counts of channel %3 (segment at byte %2) are not of the type %4 that it declares.</source>
        <translation>%1 är skadad: DAQmx-koderna i kanal %3 (segment vid byte %2) är inte av typen %4 som den anger.</translation>
    </message>
    <message>
        <source>Channel %1 claims samples that belong to other channels.</source>
        <translation>Kanal %1 gör anspråk på sampel som hör till andra kanaler.</translation>
    </message>
    <message>
        <source>Channel %1 cannot be read; the file changed meanwhile.</source>
        <translation>Kanal %1 kan inte läsas; filen ändrades under tiden.</translation>
    </message>
    <message>
        <source>Channel %1 has 64 bit integers beyond 2^53, which a floating point number does not hold exactly; write it as int32 or float64.</source>
        <translation>Kanal %1 har 64-bitars heltal över 2^53, som ett flyttal inte rymmer exakt; skriv den som int32 eller float64.</translation>
    </message>
    <message>
        <source>Channel %1 declares %2 scales, more than can be meant.</source>
        <translation>Kanal %1 anger %2 skalor, fler än som kan vara menat.</translation>
    </message>
    <message>
        <source>Channel %1: scale %2 (%3) lacks a number that it needs, or has one that makes no sense.</source>
        <translation>Kanal %1: skala %2 (%3) saknar ett tal som behövs, eller har ett som är orimligt.</translation>
    </message>
    <message>
        <source>The scales of channel %1 refer to scale %2, which is not there or needs itself.</source>
        <translation>Skalorna för kanal %1 hänvisar till skala %2, som inte finns eller behöver sig själv.</translation>
    </message>
    <message>
        <source>The scales of channel %1 do not say which of its %2 kinds of counts they are for.</source>
        <translation>Skalorna för kanal %1 anger inte vilket av dess %2 slag av koder de gäller.</translation>
    </message>
    <message>
        <source>Channel %1: scale %2 has no type and no counts of its own.</source>
        <translation>Kanal %1: skala %2 har ingen typ och inga egna koder.</translation>
    </message>
    <message>
        <source>Channel %1: scale %2 is of the kind &quot;%3&quot;, which this program does not apply; write the channel scaled.</source>
        <translation>Kanal %1: skala %2 är av slaget ”%3”, som programmet inte tillämpar; skriv kanalen skalad.</translation>
    </message>
    <message>
        <source>%1 says that its recording was not completed; check that the records are whole.</source>
        <translation>%1 anger att registreringen inte slutfördes; kontrollera att den är hel.</translation>
    </message>
    <message>
        <source>%1: %2 groups with thinned-out copies of the records were left out.</source>
        <translation>%1: %2 grupper med utglesade kopior av registreringarna utelämnades.</translation>
    </message>
    <message>
        <source>%1: each of its %2 logged intervals was taken as a shot; exclude those that are none.</source>
        <translation>%1: vart och ett av de %2 loggade intervallen togs som ett skott; uteslut dem som inte är det.</translation>
    </message>
    <message>
        <source>%1: the group &quot;%2&quot; was left out because its channels are not those of the other groups, of which each is a shot.</source>
        <translation>%1: gruppen ”%2” utelämnades eftersom dess kanaler inte är de andra gruppernas, där varje grupp är ett skott.</translation>
    </message>
    <message>
        <source>%1 has %2 bytes, which is too large for a text; export a shorter part, or as HDF5 capture.</source>
        <translation>%1 har %2 byte, vilket är för stort för en text; exportera en kortare del, eller som HDF5-registrering.</translation>
    </message>
    <message>
        <source>%1 is a LabVIEW measurement, which says itself how it is to be read; import it as lvm.</source>
        <translation>%1 är en LabVIEW-mätning, som själv anger hur den ska läsas; importera den som lvm.</translation>
    </message>
    <message>
        <source>Recipe %1 names a channel &apos;%2&apos; that no shot has; the channels are %3.</source>
        <translation>Recept %1 namnger en kanal &apos;%2&apos; som inget skott har; kanalerna är %3.</translation>
    </message>
    <message>
        <source>Recipe import.files names &apos;%1&apos;, which is none of the inputs; these are %2.</source>
        <translation>Recept import.files namnger &apos;%1&apos;, som inte är någon av infilerna; dessa är %2.</translation>
    </message>
    <message>
        <source>The profile %1 holds &quot;%2&quot;; a laboratory&apos;s profile holds the sections import and checks only, the rest belongs into the recipe.</source>
        <translation>Profilen %1 innehåller ”%2”; ett laboratoriums profil innehåller bara delarna import och checks, resten hör till receptet.</translation>
    </message>
    <message>
        <source>The gas &apos;%1&apos; has no heat capacity over temperature; choose air, n2, he, ar or co2, or a constant heat capacity.</source>
        <translation>Gasen &apos;%1&apos; har ingen värmekapacitet över temperaturen; välj air, n2, he, ar eller co2, eller en konstant värmekapacitet.</translation>
    </message>
    <message>
        <source>The gas &apos;%1&apos; is not known; it must be air, humid-air, n2, he, ar, co2 or custom.</source>
        <translation>Gasen &apos;%1&apos; är inte känd; den måste vara air, humid-air, n2, he, ar, co2 eller custom.</translation>
    </message>
    <message>
        <source>Moist air (Cramer): the %1 is %2 %5, and the formula holds from %3 to %4 %5; choose the gas &apos;air&apos; or another value.</source>
        <translation>Fuktig luft (Cramer): %1 är %2 %5, och formeln gäller från %3 till %4 %5; välj gasen &apos;air&apos; eller ett annat värde.</translation>
    </message>
    <message>
        <source>The pressure ratio p2/p1 is %1; a shock needs more than 1: check both pressures and whether they are absolute.</source>
        <translation>Tryckkvoten p2/p1 är %1; en stöt kräver mer än 1: kontrollera båda trycken och att de är absoluta.</translation>
    </message>
    <message>
        <source>The driver pressure p4 = %1 Pa does not exceed p1 = %2 Pa; both are absolute here: add the ambient pressure to a gauge reading.</source>
        <translation>Högtrycksdelens tryck p4 = %1 Pa överstiger inte p1 = %2 Pa; båda är absoluta här: lägg omgivningstrycket till ett övertryck.</translation>
    </message>
    <message>
        <source>The gas reaches %1 K, and the variable heat capacity holds from %2 K to %3 K; choose a constant one or another gas.</source>
        <translation>Gasen når %1 K, och den variabla värmekapaciteten gäller från %2 K till %3 K; välj en konstant eller en annan gas.</translation>
    </message>
    <message>
        <source>%1 is one of the inputs and is not overwritten; give the capture another name.</source>
        <translation>%1 är en av infilerna och skrivs inte över; ge registreringen ett annat namn.</translation>
    </message>
    <message>
        <source>Monte Carlo: %1 of %2 trials leave the range of the relations (%M1); the stated uncertainties are too large for the value.</source>
        <translation>Monte Carlo: %1 av %2 försök lämnar sambandens giltighetsområde (%M1); de angivna osäkerheterna är för stora för värdet.</translation>
    </message>
    <message>
        <source>Monte Carlo with %1 trials; it must be 0 (adaptive) or between %2 and %3.</source>
        <translation>Monte Carlo med %1 försök; antalet måste vara 0 (adaptivt) eller mellan %2 och %3.</translation>
    </message>
    <message>
        <source>The coverage probability is %1; it must lie between 0 and 1.</source>
        <translation>Täckningssannolikheten är %1; den måste ligga mellan 0 och 1.</translation>
    </message>
    <message>
        <source>%1 begins like a MATLAB file, but its header is cut or damaged; copy it again. Readable are: %2.</source>
        <translation>%1 börjar som en MATLAB-fil, men huvudet är avklippt eller skadat; kopiera den igen. Läsbara är: %2.</translation>
    </message>
    <message>
        <source>%1 is a RIFF file but no WAV (a video, a sound font, a picture) or a cut one. Readable are: %2.</source>
        <translation>%1 är en RIFF-fil men ingen WAV (video, ljudtyper, bild) eller en avklippt sådan. Läsbara är: %2.</translation>
    </message>
    <message>
        <source>%1: %2 states scale and offset in two ways that differ; correct the attributes.</source>
        <translation>%1: %2 anger skala och offset på två sätt som skiljer sig; rätta attributen.</translation>
    </message>
    <message>
        <source>%1: %2 marks missing samples by the value %3; such samples are read as they are, so look whether there are any.</source>
        <translation>%1: %2 markerar saknade sampel med värdet %3; sådana sampel läses som de är, så kontrollera om det finns några.</translation>
    </message>
    <message>
        <source>%1 is an HDF5 file without a dataset of samples (one-dimensional numbers, or a table of at most 64 columns).</source>
        <translation>%1 är en HDF5-fil utan dataset med sampel (endimensionella tal, eller en tabell med högst 64 kolumner).</translation>
    </message>
    <message>
        <source>%1 has none of the datasets that import.channels names; it has %2.</source>
        <translation>%1 har inget av de dataset som import.channels namnger; den har %2.</translation>
    </message>
    <message>
        <source>%1: %2 is of another length or kind than the channels and was left out; name the channels to have it.</source>
        <translation>%1: %2 har annan längd eller är av annat slag än kanalerna och utelämnades; namnge kanalerna för att få med den.</translation>
    </message>
    <message>
        <source>%1: %2 links that lead to other files or places, or cannot be opened, were not followed.</source>
        <translation>%1: %2 länkar som leder till andra filer eller platser, eller inte kan öppnas, följdes inte.</translation>
    </message>
    <message>
        <source>%1: %2 has the sample rate stated twice, as %3 and as %4; give the right one.</source>
        <translation>%1: för %2 anges samplingsfrekvensen två gånger, som %3 och som %4; ange den rätta.</translation>
    </message>
    <message>
        <source>%1: the times in %2 do not rise by equal steps, so the sample rate of %3 is unknown; state it, or resample the record.</source>
        <translation>%1: tiderna i %2 stiger inte med lika steg, så samplingsfrekvensen för %3 är okänd; ange den, eller sampla om registreringen.</translation>
    </message>
    <message>
        <source>%1: %2 states %3, but the times in %4 give %5; give the right sample rate.</source>
        <translation>%1: %2 anger %3, men tiderna i %4 ger %5; ange den rätta samplingsfrekvensen.</translation>
    </message>
    <message>
        <source>%1 has fewer than two samples.</source>
        <translation>%1 har färre än två sampel.</translation>
    </message>
    <message>
        <source>%1 has more than 1024 attributes, which were not read: its scale and unit are unknown.</source>
        <translation>%1 har fler än 1024 attribut, som inte lästes: skala och enhet är okända.</translation>
    </message>
    <message>
        <source>%1 is a table of %2 x %3 numbers; at most 64 columns become channels.</source>
        <translation>%1 är en tabell med %2 x %3 tal; högst 64 kolumner blir kanaler.</translation>
    </message>
    <message>
        <source>%1 claims %2 channels in all its segments, which is more than it can hold; the file is damaged.</source>
        <translation>%1 anger %2 kanaler i alla sina segment, mer än den kan innehålla; filen är skadad.</translation>
    </message>
    <message>
        <source>%1 is part of a structure or a cell.</source>
        <translation>%1 är del av en struktur eller cell.</translation>
    </message>
    <message>
        <source>%1 (%2) is no full matrix of real numbers.</source>
        <translation>%1 (%2) är ingen full matris av reella tal.</translation>
    </message>
    <message>
        <source>%1: %2 is no matrix of numbers (a structure, cell, text or the like) and was left out.</source>
        <translation>%1: %2 är ingen matris av tal (en struktur, cell, text eller liknande) och utelämnades.</translation>
    </message>
    <message>
        <source>%1 is damaged: the segment at byte %2 describes %3 twice.</source>
        <translation>%1 är skadad: segmentet vid byte %2 beskriver %3 två gånger.</translation>
    </message>
    <message>
        <source>%1 is damaged: DAQmx channels of the segment at byte %2 do not fit into their raw buffers.</source>
        <translation>%1 är skadad: DAQmx-kanaler i segmentet vid byte %2 får inte plats i sina råbuffertar.</translation>
    </message>
    <message>
        <source>%1: the recipe states a sample rate of %2, but the column of times steps at %3. Which one is right? Take sample_rate_hz out of the recipe, or say in sample_rate_reason why the times are wrong.</source>
        <translation>%1: receptet anger samplingsfrekvensen %2, men tidskolumnen stegar med %3. Vilken stämmer? Ta bort sample_rate_hz ur receptet, eller ange i sample_rate_reason varför tiderna är fel.</translation>
    </message>
    <message>
        <source>Shot %1: the step reaches &apos;%2&apos; %3 before &apos;%4&apos;, which the shock passes first. The two channels look swapped; exchange their roles in import.channels, for one file in import.files.</source>
        <translation>Skott %1: steget når &apos;%2&apos; %3 före &apos;%4&apos;, som stöten passerar först. De två kanalerna verkar förväxlade; byt deras roller i import.channels, för en enda fil i import.files.</translation>
    </message>
    <message>
        <source>Use %1 K</source>
        <translation>Använd %1 K</translation>
    </message>
    <message>
        <source>Velocity uncertainty %1 % gives %2 % on the pressure step (factor %3); the budget says where it comes from.</source>
        <translation>Hastighetsosäkerheten %1 % ger %2 % på trycksteget (faktor %3); budgeten visar varifrån den kommer.</translation>
    </message>
    <message>
        <source>The DUT marks the arrival at the end wall by its detected start, which its own delay makes late: a microsecond is %1 % of the velocity and %2 % of the step. Use two side sensors, or a model of each shot instead of the average.</source>
        <translation>DUT markerar ankomsten till ändväggen med sin detekterade start, som dess egen fördröjning gör sen: en mikrosekund är %1 % av hastigheten och %2 % av steget. Använd två sidogivare, eller en modell av varje skott i stället för medelvärdet.</translation>
    </message>
    <message>
        <source>The arrivals scatter about their line more than their stated uncertainties allow (chi-square %1, degrees of freedom %2): check distances, delays and arrivals, or let the velocity change along the tube.</source>
        <translation>Ankomsterna sprider sig kring sin linje mer än de angivna osäkerheterna medger (chi-kvadrat %1, frihetsgrader %2): kontrollera avstånd, fördröjningar och ankomster, eller låt hastigheten ändras längs röret.</translation>
    </message>
    <message>
        <source>p1 = %1 Pa? Pressures are in pascals here: %1 %2 are %3 Pa, about ambient.</source>
        <translation>p1 = %1 Pa? Tryck anges här i pascal: %1 %2 är %3 Pa, ungefär omgivningens.</translation>
    </message>
    <message>
        <source>Use %1 Pa</source>
        <translation>Använd %1 Pa</translation>
    </message>
    <message>
        <source>The expansion reflected at the driver&apos;s end reaches the end wall %1 after the step (computed), before the contact surface&apos;s wave: a longer driver section would help.</source>
        <translation>Expansionen som reflekteras i högtrycksdelens ände når ändväggen %1 efter steget (beräknat), före kontaktytans våg: en längre högtrycksdel skulle hjälpa.</translation>
    </message>
    <message>
        <source>The reflected shock passes the DUT %1 after the step (computed).</source>
        <translation>Den reflekterade stöten passerar DUT %1 efter steget (beräknat).</translation>
    </message>
    <message>
        <source>The uncertainty of %1 is not stated; add &apos;%2&apos; to uncertainty.budget of the recipe.</source>
        <translation>Osäkerheten för %1 är inte angiven; lägg till &apos;%2&apos; i receptets uncertainty.budget.</translation>
    </message>
    <message>
        <source>The shock reaches &apos;%1&apos; %2 after &apos;%3&apos;, which is farther down the tube: check whether the two channels are swapped (CAP-010), and their distances.</source>
        <translation>Stöten når &apos;%1&apos; %2 efter &apos;%3&apos;, som ligger längre ned i röret: kontrollera om de två kanalerna är förväxlade (CAP-010), och deras avstånd.</translation>
    </message>
    <message>
        <source>Exchange &apos;%1&apos; and &apos;%2&apos;</source>
        <translation>Byt plats på &apos;%1&apos; och &apos;%2&apos;</translation>
    </message>
    <message>
        <source>The arrivals from &apos;%1&apos; to &apos;%2&apos; give a velocity of %3 m/s; the shock must run towards the end wall: check channels, distances and arrivals.</source>
        <translation>Ankomsterna från &apos;%1&apos; till &apos;%2&apos; ger hastigheten %3 m/s; stöten måste gå mot ändväggen: kontrollera kanaler, avstånd och ankomster.</translation>
    </message>
    <message>
        <source>A velocity needs arrivals at two places at least; there are %1.</source>
        <translation>En hastighet kräver ankomster på minst två platser; det finns %1.</translation>
    </message>
    <message>
        <source>A counter reads %1 s from %2 m to %3 m before the end wall; the time must be above 0 and the first distance the larger one.</source>
        <translation>En räknare visar %1 s från %2 m till %3 m före ändväggen; tiden måste vara över 0 och det första avståndet det större.</translation>
    </message>
    <message>
        <source>There is no counter reading.</source>
        <translation>Det finns ingen räknaravläsning.</translation>
    </message>
    <message>
        <source>--orders holds &quot;%1&quot;; it needs whole numbers from 1, as in 2,3,50.</source>
        <translation>--orders innehåller &quot;%1&quot;; det krävs heltal från 1, som i 2,3,50.</translation>
    </message>
    <message>
        <source>The model of order %1 diverges, so there is nothing to export; choose another order.</source>
        <translation>Modellen av ordning %1 divergerar, så det finns inget att exportera; välj en annan ordning.</translation>
    </message>
    <message>
        <source>%1 were taken as the channels of one recording, as name, time, rate and length agree. Set channel_files to &quot;apart&quot; in the recipe&apos;s import section if they are not.</source>
        <translation>%1 togs som kanaler i en och samma registrering, eftersom namn, tid, frekvens och längd stämmer överens. Sätt channel_files till &quot;apart&quot; i receptets avsnitt import om de inte är det.</translation>
    </message>
    <message>
        <source>Dataset %1 has %2 values - not a waveform.</source>
        <translation>Dataset %1 har %2 värden - ingen vågform.</translation>
    </message>
    <message>
        <source>orders %1 to %2: frequency %3 %, damping ratio %4 % (half of the range)</source>
        <translation>ordning %1 till %2: frekvens %3 %, dämpning %4 % (halva vidden)</translation>
    </message>
    <message>
        <source>Reason for the model order</source>
        <translation>Skäl för modellordningen</translation>
    </message>
    <message>
        <source>Variation of the resonance over the orders</source>
        <translation>Resonansens variation över ordningarna</translation>
    </message>
    <message>
        <source>U of the step</source>
        <translation>U för steget</translation>
    </message>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>gas in the tube</source>
        <translation>gas i röret</translation>
    </message>
    <message>
        <source>Oscillations that are not the sensor&apos;s, left out of the model</source>
        <translation>Svängningar som inte är givarens, utelämnade ur modellen</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mod</translation>
    </message>
    <message>
        <source>Size, of the plateau</source>
        <translation>Storlek, del av platån</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Skäl</translation>
    </message>
    <message>
        <source>What leaving them out has changed, at the same order</source>
        <translation>Vad utelämnandet har ändrat, vid samma ordning</translation>
    </message>
    <message>
        <source>Oscillations</source>
        <translation>Svängningar</translation>
    </message>
    <message>
        <source>Residual, rms of the plateau</source>
        <translation>Residual, effektivvärde i delar av platån</translation>
    </message>
    <message>
        <source>Plateau gain</source>
        <translation>Platåförstärkning</translation>
    </message>
    <message>
        <source>left in</source>
        <translation>kvar</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>utelämnade</translation>
    </message>
    <message>
        <source>There is no decomposition yet that orders could be taken from.</source>
        <translation>Det finns ännu ingen uppdelning att hämta ordningar ur.</translation>
    </message>
    <message>
        <source>%1 orders were asked for; compare at most %2 at once.</source>
        <translation>%1 ordningar begärdes; jämför högst %2 åt gången.</translation>
    </message>
    <message>
        <source>Shot %1: the uncertainty of the step could not be checked by Monte Carlo (%M1); what the law of propagation gives may be wrong.</source>
        <translation>Skott %1: stegets osäkerhet kunde inte kontrolleras med Monte Carlo (%M1); vad fortplantningslagen ger kan vara fel.</translation>
    </message>
    <message>
        <source>Use order %1</source>
        <translation>Använd ordning %1</translation>
    </message>
    <message>
        <source>Poles nearly cancelled by zeros: %1 (%2). A lower order may do.</source>
        <translation>Poler som nästan tas ut av nollställen: %1 (%2). En lägre ordning kan räcka.</translation>
    </message>
    <message>
        <source>No clear gap between the singular values: none above the noise is more than %1 times the next. Compare candidates.</source>
        <translation>Inget tydligt språng mellan singulärvärdena: inget över bruset är mer än %1 gånger nästa. Jämför kandidater.</translation>
    </message>
    <message>
        <source>Shot %1: the window of %2 holds %3 periods of the mode %4; below 2 it cannot be told from the plateau and stays in the response.</source>
        <translation>Skott %1: fönstret på %2 rymmer %3 perioder av moden %4; under 2 kan den inte skiljas från platån och blir kvar i svaret.</translation>
    </message>
    <message>
        <source>Shot %1: the mode %2 lies above 0.4 of the sample rate of %3; it stays in the response.</source>
        <translation>Skott %1: moden %2 ligger över 0,4 av samplingsfrekvensen %3; den blir kvar i svaret.</translation>
    </message>
    <message>
        <source>Shot %1: no oscillation near %2 stands out of the noise; nothing is taken out there.</source>
        <translation>Skott %1: ingen svängning nära %2 höjer sig över bruset; där tas inget bort.</translation>
    </message>
    <message>
        <source>The average of the shots has no tube modes of its own, as each shot has its own sound speed: nothing is taken out. Combine the shots as &quot;stacked&quot;.</source>
        <translation>Skottens medelvärde har inga egna rörmoder, eftersom varje skott har sin egen ljudhastighet: inget tas bort. Kombinera skotten som &quot;stacked&quot;.</translation>
    </message>
    <message>
        <source>Singular values above the noise floor: %1.</source>
        <translation>Singulärvärden över brusgolvet: %1.</translation>
    </message>
    <message>
        <source>Singular value %1 is %2 times the next one; above the noise floor lie %3.</source>
        <translation>Singulärvärde %1 är %2 gånger nästa; över brusgolvet ligger %3.</translation>
    </message>
    <message>
        <source>Order %1 splits an oscillating pair; order %2 keeps it.</source>
        <translation>Ordning %1 delar ett svängande par; ordning %2 behåller det.</translation>
    </message>
    <message>
        <source>Order %1 splits no oscillating pair.</source>
        <translation>Ordning %1 delar inget svängande par.</translation>
    </message>
    <message>
        <source>Poles of the other shots describe a shot best at order %1: they leave %2 % of it.</source>
        <translation>De andra skottens poler beskriver ett skott bäst vid ordning %1: de lämnar %2 % av det.</translation>
    </message>
    <message>
        <source>Poles of the other shots leave %1 % of a shot at order %2; the least, %3 %, at order %4.</source>
        <translation>De andra skottens poler lämnar %1 % av ett skott vid ordning %2; minst, %3 %, vid ordning %4.</translation>
    </message>
    <message>
        <source>Order %1 is the lowest whose FIT (%2 %) reaches 98 % of the attainable %3 % with neither an unstable nor a Nyquist pole.</source>
        <translation>Ordning %1 är den lägsta vars FIT (%2 %) når 98 % av uppnåeliga %3 % utan någon instabil pol eller pol vid Nyquist.</translation>
    </message>
    <message>
        <source>No order up to %1 reaches 98 % of the attainable FIT of %2 % with neither an unstable nor a Nyquist pole.</source>
        <translation>Ingen ordning till och med %1 når 98 % av uppnåelig FIT på %2 % utan någon instabil pol eller pol vid Nyquist.</translation>
    </message>
    <message>
        <source>A second-order sensor (%1, damping %2) does not describe the response: FIT %3 % against %4 % of the model.</source>
        <translation>En givare av andra ordningen (%1, dämpning %2) beskriver inte svaret: FIT %3 % mot modellens %4 %.</translation>
    </message>
    <message>
        <source>The arrival sensor &apos;%1&apos; lists %2 arrivals for %3 shots; give one time or null per shot (shock.arrival_sensors[].arrival_s).</source>
        <translation>Ankomstgivaren &apos;%1&apos; anger %2 ankomster för %3 skott; ange en tid eller null per skott (shock.arrival_sensors[].arrival_s).</translation>
    </message>
    <message>
        <source>Move the end to %1</source>
        <translation>Flytta slutet till %1</translation>
    </message>
    <message>
        <source>Stretches of the records that were not fitted</source>
        <translation>Stycken av registreringarna som inte anpassades</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Från</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Till</translation>
    </message>
    <message>
        <source>Times behind the start of the response. These stretches take no part in the model, the fit and its uncertainties; in the response without a model they are filled by the model.</source>
        <translation>Tider efter svarets start. Dessa stycken ingår inte i modellen, anpassningen och dess osäkerheter; i svaret utan modell fylls de av modellen.</translation>
    </message>
    <message>
        <source>window.exclude_stretches: %1 to %2 of shot %3 must begin before it ends and touch its window, which reaches from its start to %4.</source>
        <translation>window.exclude_stretches: %1 till %2 i skott %3 måste börja innan det slutar och beröra skottets fönster, som sträcker sig från dess start till %4.</translation>
    </message>
    <message>
        <source>Shot %1: %2 to %3 behind the start is left out of the fit: %4</source>
        <translation>Skott %1: %2 till %3 efter starten utelämnas ur anpassningen: %4</translation>
    </message>
    <message>
        <source>Shot %1: only %2 of the %3 samples of the model input are free of stretches left out; at least half are needed. Mark less, or exclude the shot.</source>
        <translation>Skott %1: bara %2 av modellindatas %3 sampel är fria från utelämnade stycken; minst hälften krävs. Märk mindre, eller uteslut skottet.</translation>
    </message>
    <message>
        <source>The average of the shots is formed before the fit: the stretches to be left out are in it. Combine the shots as &quot;stacked&quot;.</source>
        <translation>Skottens medelvärde bildas före anpassningen: styckena som ska utelämnas ingår i det. Kombinera skotten som &quot;stacked&quot;.</translation>
    </message>
    <message>
        <source>%1 holds times, but no samples that belong to them (%2); if one of these is a record, name it in import.channels.</source>
        <translation>%1 innehåller tider, men inga sampel som hör till dem (%2); om något av dessa är en registrering, namnge den i import.channels.</translation>
    </message>
    <message>
        <source>Shot %1: %2 % of the resonance at %3 is left in the residual, because its arrival differs from the others&apos; by %4 of a sample; aligned, %5 % are left. The average of the shots loses some of its ringing by this, stacked shots do not.</source>
        <translation>Skott %1: %2 % av resonansen vid %3 är kvar i residualen, eftersom dess ankomst skiljer sig från de andras med %4 sampel; efter inpassning är %5 % kvar. Medelvärdet av skotten förlorar något av sin ringning på detta, staplade skott gör det inte.</translation>
    </message>
    <message>
        <source>The quantity %1 = %2 has a standard uncertainty of %3 with %4 degrees of freedom; the first two must be finite, the uncertainty 0 or above, the degrees above 0.</source>
        <translation>Storheten %1 = %2 har standardosäkerheten %3 med %4 frihetsgrader; de två första måste vara ändliga, osäkerheten minst 0 och frihetsgraderna större än 0.</translation>
    </message>
    <message>
        <source>The quantity %1 is there twice in an uncertainty budget; join the two contributions to one.</source>
        <translation>Storheten %1 finns två gånger i en osäkerhetsbudget; slå ihop de två bidragen till ett.</translation>
    </message>
    <message>
        <source>The result is not a finite number.</source>
        <translation>Resultatet är inte ett ändligt tal.</translation>
    </message>
    <message>
        <source>The shortest window, %1, resolves steps of %2, but the response is asked for from %3: below %2 it is not measured. Lengthen the window or take these frequencies out of response.frequencies_hz.</source>
        <translation>Det kortaste fönstret, %1, upplöser steg om %2, men svaret begärs från %3: under %2 mäts det inte. Förläng fönstret eller ta bort dessa frekvenser ur response.frequencies_hz.</translation>
    </message>
    <message>
        <source>Peak %1 follows the sound speed of the gas (slope %2, u %3; of a sensor 0): a tube mode, to be left out of the model.</source>
        <translation>Toppen %1 följer gasens ljudhastighet (lutning %2, u %3; för en givare 0): en rörmod, som ska lämnas utanför modellen.</translation>
    </message>
    <message>
        <source>Peak %1 follows the sound speed of the gas (slope %2, u %3; of a sensor 0): a tube mode, to be left out of the model. The nearest computed is %4.</source>
        <translation>Toppen %1 följer gasens ljudhastighet (lutning %2, u %3; för en givare 0): en rörmod, som ska lämnas utanför modellen. Den närmaste beräknade är %4.</translation>
    </message>
    <message>
        <source>The uncertainty of &apos;%1&apos; in uncertainty.budget is used for nothing; the nearest quantity that counts is &apos;%2&apos;.</source>
        <translation>Osäkerheten för &apos;%1&apos; i uncertainty.budget används inte till något; den närmaste storhet som räknas är &apos;%2&apos;.</translation>
    </message>
    <message>
        <source>The model holds poles of the tube&apos;s gas: %1 (in brackets the peak that moves with the sound speed, shot by shot). Leave that oscillation out of the model, or it is certified as the sensor&apos;s.</source>
        <translation>Modellen innehåller poler från gasen i röret: %1 (inom parentes toppen som flyttar sig med ljudhastigheten, skott för skott). Lämna den svängningen utanför modellen, annars intygas den som givarens.</translation>
    </message>
    <message>
        <source>Poles within 3 % of a computed resonance of the tube: %1. If they are not the sensor&apos;s, leave that oscillation out of the model.</source>
        <translation>Poler inom 3 % från en beräknad resonans hos röret: %1. Om de inte är givarens, lämna den svängningen utanför modellen.</translation>
    </message>
    <message>
        <source>Recipe key uncertainty.budget holds the quantity &quot;%1&quot; twice; join the two contributions to one.</source>
        <translation>Receptnyckeln uncertainty.budget innehåller storheten &quot;%1&quot; två gånger; slå ihop de två bidragen till ett.</translation>
    </message>
    <message>
        <source>The shots do not share the pole at %1 (their scatter would be chance in %2 % of cases; the limit is 1 %). Its uncertainty is the scatter between them; state one value per level.</source>
        <translation>Skotten har inte polen vid %1 gemensam (deras spridning vore en slump i %2 % av fallen; gränsen är 1 %). Dess osäkerhet är spridningen mellan dem; ange ett värde per nivå.</translation>
    </message>
    <message>
        <source>The shots do not share the pole at %1 (their scatter would be chance in %2 % of cases; the limit is 1 %); their main resonances lie at %3 to %4. Its uncertainty is the scatter between them; state one value per level.</source>
        <translation>Skotten har inte polen vid %1 gemensam (deras spridning vore en slump i %2 % av fallen; gränsen är 1 %); deras huvudresonanser ligger vid %3 till %4. Dess osäkerhet är spridningen mellan dem; ange ett värde per nivå.</translation>
    </message>
    <message>
        <source>Order %1 has states at the noise level: singular value %1 is %3, noise alone reaches %4. Order %2 is the highest above it.</source>
        <translation>Ordning %1 har tillstånd i brusnivån: singulärvärde %1 är %3, enbart brus når %4. Ordning %2 är den högsta däröver.</translation>
    </message>
    <message>
        <source>Order %1 has states at the noise level: singular value %1 is %3, noise alone reaches %4. No value is above it: the response holds nothing that could be identified.</source>
        <translation>Ordning %1 har tillstånd i brusnivån: singulärvärde %1 är %3, enbart brus når %4. Inget värde ligger däröver: svaret innehåller inget som kan identifieras.</translation>
    </message>
    <message>
        <source>The model of order %1 is unstable: poles that grow, at %2, the largest of magnitude %3 (at most 1). It is not reportable; choose another order.</source>
        <translation>Modellen av ordning %1 är instabil: växande poler vid %2, den största med beloppet %3 (högst 1). Den kan inte rapporteras; välj en annan ordning.</translation>
    </message>
    <message>
        <source>Poles at the Nyquist frequency, %1: %2. Dynamics there come from sampling, not from the sensor; a lower order or a higher model rate is without them.</source>
        <translation>Poler vid Nyquistfrekvensen, %1: %2. Dynamik där kommer av samplingen, inte av givaren; en lägre ordning eller en högre samplingsfrekvens hos modellen är utan dem.</translation>
    </message>
    <message>
        <source>The response is treated as a free decay but stays at a level: a pole at z = %1. Treat it as a step, or the step becomes a part of the sensor.</source>
        <translation>Svaret behandlas som en fri utsvängning men stannar på en nivå: en pol vid z = %1. Behandla det som ett steg, annars blir steget en del av givaren.</translation>
    </message>
    <message>
        <source>Treat as a step</source>
        <translation>Behandla som steg</translation>
    </message>
    <message>
        <source>FIT is %1 % where the noise allows %2 %: the model misses part of the response. Choose a higher order; the error shows what is missing.</source>
        <translation>FIT är %1 % där bruset medger %2 %: modellen missar en del av svaret. Välj en högre ordning; felet visar vad som saknas.</translation>
    </message>
    <message>
        <source>The spectrum&apos;s resonance at %1 is not in the model, whose nearest lies at %2 (2 % apart at most). Choose another order or model rate.</source>
        <translation>Spektrets resonans vid %1 finns inte i modellen, vars närmaste ligger vid %2 (högst 2 % ifrån). Välj en annan ordning eller samplingsfrekvens hos modellen.</translation>
    </message>
    <message>
        <source>The spectrum&apos;s resonance at %1 is not in the model, which has none. Choose a higher order.</source>
        <translation>Spektrets resonans vid %1 finns inte i modellen, som inte har någon. Välj en högre ordning.</translation>
    </message>
    <message>
        <source>Shot %1: FIT is %2 % with the model, but %3 % with the poles of the other shots alone. The shots do not share their poles: look at that shot; if nothing is wrong with it the sensor is not linear.</source>
        <translation>Skott %1: FIT är %2 % med modellen men %3 % med enbart de andra skottens poler. Skotten har inte gemensamma poler: granska det skottet; är inget fel med det är givaren inte linjär.</translation>
    </message>
    <message>
        <source>Shot %1: the mode %2 has a frequency for the shots 1 to %3 only; it stays in the response of this one.</source>
        <translation>Skott %1: moden %2 har en frekvens endast för skotten 1 till %3; den blir kvar i svaret från detta.</translation>
    </message>
    <message>
        <source>The mode %1 was read in shot %2, of which no sound speed is known: it is looked for at that frequency in every shot. Read it in another shot, or give one frequency per shot.</source>
        <translation>Moden %1 avlästes i skott %2, vars ljudhastighet inte är känd: den söks vid den frekvensen i varje skott. Läs av den i ett annat skott, eller ange en frekvens per skott.</translation>
    </message>
    <message>
        <source>The pole at %1 with damping ratio %2 is stable from order %3 to %4; the ranges are those over these orders.</source>
        <translation>Polen vid %1 med dämpningsförhållandet %2 är stabil från ordning %3 till %4; intervallen gäller över dessa ordningar.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made.</source>
        <translation>Mappen %1 kan inte skapas.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be written to.</source>
        <translation>Det går inte att skriva i mappen %1.</translation>
    </message>
    <message>
        <source>%1 does not hold the work of a stopped program.</source>
        <translation>%1 innehåller inte arbete från ett stoppat program.</translation>
    </message>
    <message>
        <source>%1 of the inputs cannot be read:</source>
        <translation>%1 av indatafilerna kan inte läsas:</translation>
    </message>
    <message>
        <source>No recording was found in the inputs; readable are: %1.</source>
        <translation>Ingen registrering hittades bland indata; läsbara format: %1.</translation>
    </message>
    <message>
        <source>Shot %1: whether there is a step cannot be told, because the record&apos;s values are not there or too large to compute with; check the channel&apos;s unit and factor, or exclude the shot.</source>
        <translation>Skott %1: om det finns ett steg går inte att avgöra, eftersom registreringens värden saknas eller är för stora att räkna med; kontrollera kanalens enhet och faktor, eller uteslut skottet.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: no step found, because the record&apos;s values are not there or too large to compute with; check the channel&apos;s unit and factor, or exclude the shot.</source>
        <translation>Skott %1, kanal %2: inget steg hittades, eftersom registreringens värden saknas eller är för stora att räkna med; kontrollera kanalens enhet och faktor, eller uteslut skottet.</translation>
    </message>
    <message>
        <source>There is not enough memory for this; close other programs or raise the memory limit.</source>
        <translation>Minnet räcker inte till detta; stäng andra program eller höj minnesgränsen.</translation>
    </message>
    <message>
        <source>There is not enough memory to draw the certificate and the plots, and nothing was written; close other programs or raise the memory limit.</source>
        <translation>Minnet räcker inte till att rita certifikatet och diagrammen, och inget skrevs; stäng andra program eller höj minnesgränsen.</translation>
    </message>
    <message>
        <source>There is not enough memory for a window; close other programs or raise the memory limit.</source>
        <translation>Minnet räcker inte till ett fönster; stäng andra program eller höj minnesgränsen.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos; of shot %2 has no samples. Check the file and the role.</source>
        <translation>Kanal &apos;%1&apos; i skott %2 har inga sampel. Kontrollera filen och rollen.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos; of shot %2 has no valid sample: none of its %3 samples is a number. Check the file and the role.</source>
        <translation>Kanal &apos;%1&apos; i skott %2 har inget giltigt sampel: inget av dess %3 sampel är ett tal. Kontrollera filen och rollen.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos; of shot %2 is flat: all its valid samples (%3) are %4. Check cable and role.</source>
        <translation>Kanal &apos;%1&apos; i skott %2 är konstant: alla dess giltiga sampel (%3) är %4. Kontrollera kabel och roll.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos; of shot %2 has a single valid sample, %4, which is no record. Check the file and the role.</source>
        <translation>Kanal &apos;%1&apos; i skott %2 har ett enda giltigt sampel, %4, vilket inte är någon registrering. Kontrollera filen och rollen.</translation>
    </message>
    <message>
        <source>Shot %1, %2 looks cut off for %3 at %4, from %5 on. More than 20 % of the response window like that blocks the shot; use a wider range.</source>
        <translation>Skott %1, %2 ser avskuret ut under %3 vid %4, från och med %5. Om mer än 20 % av svarsfönstret är så blockerar det skottet; använd ett större mätområde.</translation>
    </message>
    <message>
        <source>%1 could not be read, and there is not enough memory to tell whether the file is at fault; close other programs or raise the memory limit.</source>
        <translation>%1 kunde inte läsas, och minnet räcker inte till att avgöra om felet ligger i filen; stäng andra program eller höj minnesgränsen.</translation>
    </message>
    <message>
        <source>Shot %1, channel &apos;%2&apos;: the file gives a sample rate of %3 (an interval of %4), and recordings have %5 to %6. Correct the times or the rate in the file, or give import.sample_rate_hz and import.sample_rate_reason.</source>
        <translation>Skott %1, kanal &apos;%2&apos;: filen ger samplingsfrekvensen %3 (intervallet %4), och registreringar har %5 till %6. Rätta tiderna eller frekvensen i filen, eller ange import.sample_rate_hz och import.sample_rate_reason.</translation>
    </message>
    <message>
        <source>Shot %1, channel &apos;%2&apos;: import.sample_rate_hz is %3 (an interval of %4), and recordings have %5 to %6. Correct the key.</source>
        <translation>Skott %1, kanal &apos;%2&apos;: import.sample_rate_hz är %3 (intervallet %4), och registreringar har %5 till %6. Rätta nyckeln.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: there are no valid samples to find a start in; exclude the shot.</source>
        <translation>Skott %1, kanal %2: det finns inga giltiga sampel att söka en start i; uteslut skottet.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2 stands still at %3 for %4 % of the response window, the longest time from %5 on, although its baseline shows noise: it was cut off or stuck. The shot cannot be used: exclude it.</source>
        <translation>Skott %1, kanal %2 står stilla på %3 under %4 % av svarsfönstret, den längsta tiden från och med %5, fast baslinjen visar brus: signalen skars av eller fastnade. Skottet kan inte användas: uteslut det.</translation>
    </message>
    <message>
        <source>The memory is used up, so the work in hand was stopped; save your work, close other programs or choose a shorter window.</source>
        <translation>Minnet är slut, så det pågående arbetet stoppades; spara ditt arbete, stäng andra program eller välj ett kortare fönster.</translation>
    </message>
    <message>
        <source>%1 is damaged: it states the hashes of a capture, but its attribute format does not say that it is one; take an unchanged copy.</source>
        <translation>%1 är skadad: den anger en registrerings kontrollsummor, men dess attribut format säger inte att den är en sådan; ta en oförändrad kopia.</translation>
    </message>
    <message>
        <source>%1 changed since it was written: what it says of channel &apos;%2&apos; of shot %3 is not what was recorded. The results are of the changed capture and cannot be certified; take an unchanged copy.</source>
        <translation>%1 har ändrats sedan den skrevs: det som den säger om kanal &apos;%2&apos; i skott %3 är inte det som registrerades. Resultaten avser den ändrade registreringen och kan inte intygas; ta en oförändrad kopia.</translation>
    </message>
    <message>
        <source>%1 changed since it was written: what it says of shot %2 (%3) is not what was recorded. The results are of the changed capture and cannot be certified; take an unchanged copy.</source>
        <translation>%1 har ändrats sedan den skrevs: det som den säger om skott %2 (%3) är inte det som registrerades. Resultaten avser den ändrade registreringen och kan inte intygas; ta en oförändrad kopia.</translation>
    </message>
    <message>
        <source>%1 changed since it was written: what it says in %2 is not what was recorded. The results are of the changed capture and cannot be certified; take an unchanged copy.</source>
        <translation>%1 har ändrats sedan den skrevs: det som den säger i %2 är inte det som registrerades. Resultaten avser den ändrade registreringen och kan inte intygas; ta en oförändrad kopia.</translation>
    </message>
    <message>
        <source>%1 changed since it was written: the hashes it states of itself contradict each other, so that nothing in it can be certified; take an unchanged copy.</source>
        <translation>%1 har ändrats sedan den skrevs: kontrollsummorna som den anger om sig själv motsäger varandra, så att inget i den kan intygas; ta en oförändrad kopia.</translation>
    </message>
    <message>
        <source>%1 changed since it was written in %2 further places; take an unchanged copy.</source>
        <translation>%1 har ändrats på ytterligare %2 ställen sedan den skrevs; ta en oförändrad kopia.</translation>
    </message>
    <message>
        <source>Project %1 has no checksum (an older version wrote it), so a change of it is not noticed; save it to give it one.</source>
        <translation>Projektet %1 har ingen kontrollsumma (en äldre version skrev det), så att en ändring av det inte märks; spara det så får det en.</translation>
    </message>
    <message>
        <source>Project %1 was changed after the program saved it: %2. If that was not you, take an unchanged copy; otherwise look at what changed and save the project.</source>
        <translation>Projektet %1 har ändrats efter att programmet sparade det: %2. Om det inte var du, ta en oförändrad kopia; se annars på vad som har ändrats och spara projektet.</translation>
    </message>
    <message>
        <source>%1 exists already and captures are written once; give the capture another name, or say --replace.</source>
        <translation>%1 finns redan och registreringar skrivs en gång; ge registreringen ett annat namn, eller ange --replace.</translation>
    </message>
    <message>
        <source>%1 is in the way: this program did not write it, or an earlier version did, and it is not replaced. Choose another folder, or move it away.</source>
        <translation>%1 är i vägen: det här programmet skrev det inte, eller så gjorde en tidigare version det, och det ersätts inte. Välj en annan mapp, eller flytta undan det.</translation>
    </message>
    <message>
        <source>%1 was changed since this program wrote it and is not replaced. Choose another folder, or move it away.</source>
        <translation>%1 har ändrats sedan det här programmet skrev det och ersätts inte. Välj en annan mapp, eller flytta undan det.</translation>
    </message>
    <message>
        <source>The folder %1 holds the recording %2; results are written into a folder that holds none of their recordings. Choose another folder.</source>
        <translation>Mappen %1 innehåller registreringen %2; resultat skrivs i en mapp som inte innehåller någon av deras registreringar. Välj en annan mapp.</translation>
    </message>
    <message>
        <source>%1 was given to be read and would be replaced by what is written; give it another name or choose another folder.</source>
        <translation>%1 angavs för att läsas och skulle ersättas av det som skrivs; ge det ett annat namn eller välj en annan mapp.</translation>
    </message>
    <message>
        <source>An earlier write into %1 was interrupted and cannot be completed, because files in it were changed since; what it was writing lies in %2. Choose another folder, or move the changed files away.</source>
        <translation>En tidigare skrivning i %1 avbröts och kan inte slutföras, eftersom filer i mappen har ändrats sedan dess; det som skrevs ligger i %2. Välj en annan mapp, eller flytta undan de ändrade filerna.</translation>
    </message>
    <message>
        <source>%1 was changed by another program since it was read here, and is not replaced; choose another name, or look at what it holds now.</source>
        <translation>%1 har ändrats av ett annat program sedan det lästes här och ersätts inte; välj ett annat namn, eller se efter vad det innehåller nu.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2; make room and try again.</source>
        <translation>%1 kan inte skrivas: %2; frigör utrymme och försök igen.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2; raise the limit on the size of files or choose another place.</source>
        <translation>%1 kan inte skrivas: %2; höj gränsen för filstorlek eller välj en annan plats.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2; choose a shorter name.</source>
        <translation>%1 kan inte skrivas: %2; välj ett kortare namn.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2; check that its folder exists.</source>
        <translation>%1 kan inte skrivas: %2; kontrollera att dess mapp finns.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2; choose another place.</source>
        <translation>%1 kan inte skrivas: %2; välj en annan plats.</translation>
    </message>
    <message>
        <source>%1 exists already and is not replaced; choose another name.</source>
        <translation>%1 finns redan och ersätts inte; välj ett annat namn.</translation>
    </message>
    <message>
        <source>%1 was renamed, moved or replaced while it was being written, so nothing was written into it; write again into the folder that you mean.</source>
        <translation>%1 bytte namn, flyttades eller ersattes medan den skrevs, så inget skrevs i den; skriv igen i den mapp som du menar.</translation>
    </message>
    <message>
        <source>%1 is being written by another program at this moment; wait until it has ended or choose another name.</source>
        <translation>%1 skrivs just nu av ett annat program; vänta tills det är klart eller välj ett annat namn.</translation>
    </message>
    <message>
        <source>%1 cannot be opened because the system allows no more open files; read fewer recordings at once, or raise the limit (ulimit -n).</source>
        <translation>%1 kan inte öppnas eftersom systemet inte tillåter fler öppna filer; läs färre registreringar på en gång, eller höj gränsen (ulimit -n).</translation>
    </message>
    <message>
        <source>%1: the channels up to %2 would take %3 of memory, more than the %4 that a file of this size may; if you trust the file, raise import.max_expansion in the recipe.</source>
        <translation>%1: kanalerna till och med %2 skulle ta %3 minne, mer än de %4 som en fil av den här storleken får; om du litar på filen, höj import.max_expansion i receptet.</translation>
    </message>
    <message>
        <source>%1: its %2 columns would take %3 of memory, more than the %4 that a file of this size may; if you trust the file, raise import.max_expansion in the recipe.</source>
        <translation>%1: dess %2 kolumner skulle ta %3 minne, mer än de %4 som en fil av den här storleken får; om du litar på filen, höj import.max_expansion i receptet.</translation>
    </message>
    <message>
        <source>%1: the rows up to line %2, with the blank lines and empty cells between, would take %3 of memory, more than the %4 that a file of this size may; if you trust the file, raise import.max_expansion in the recipe.</source>
        <translation>%1: raderna till och med rad %2, med de tomma raderna och cellerna däremellan, skulle ta %3 minne, mer än de %4 som en fil av den här storleken får; om du litar på filen, höj import.max_expansion i receptet.</translation>
    </message>
    <message>
        <source>%1: the segments up to number %2 would take %3 of memory, more than the %4 that a file of this size may; if you trust the file, raise import.max_expansion in the recipe.</source>
        <translation>%1: segmenten till och med nummer %2 skulle ta %3 minne, mer än de %4 som en fil av den här storleken får; om du litar på filen, höj import.max_expansion i receptet.</translation>
    </message>
    <message>
        <source>%1: the places of its samples, which lie in %2 pieces, would take %3 of memory, more than the %4 that a file of this size may; if you trust the file, raise import.max_expansion in the recipe.</source>
        <translation>%1: platserna för dess sampel, som ligger i %2 delar, skulle ta %3 minne, mer än de %4 som en fil av den här storleken får; om du litar på filen, höj import.max_expansion i receptet.</translation>
    </message>
    <message>
        <source>%1: names and attributes of the first %2 objects in it would take %3 of memory, more than the %4 that a file of this size may; if you trust the file, raise import.max_expansion in the recipe.</source>
        <translation>%1: namn och attribut för de första %2 objekten i filen skulle ta %3 minne, mer än de %4 som en fil av den här storleken får; om du litar på filen, höj import.max_expansion i receptet.</translation>
    </message>
    <message>
        <source>%1: channel %2 would take %3 of memory, more than the %4 that a file of this size may; if you trust the file, raise import.max_expansion in the recipe.</source>
        <translation>%1: kanal %2 skulle ta %3 minne, mer än de %4 som en fil av den här storleken får; om du litar på filen, höj import.max_expansion i receptet.</translation>
    </message>
    <message>
        <source>%1: channel %2 cannot be unpacked: a compressed piece of it is damaged or larger than it declares; copy the file again.</source>
        <translation>%1: kanal %2 kan inte packas upp: en komprimerad del av den är skadad eller större än den uppger; kopiera filen igen.</translation>
    </message>
    <message>
        <source>%1: the samples of channel %2 lie in another file (%3), which is not opened; copy them into this file, for example with h5repack.</source>
        <translation>%1: samplen i kanal %2 ligger i en annan fil (%3), som inte öppnas; kopiera in dem i den här filen, till exempel med h5repack.</translation>
    </message>
    <message>
        <source>Too few files may be open at once; raise that limit (ulimit -n) to 64 and one for each recording.</source>
        <translation>För få filer får vara öppna samtidigt; höj den gränsen (ulimit -n) till 64 och en för varje registrering.</translation>
    </message>
    <message>
        <source>The name of project %1 is not valid UTF-8; rename the project.</source>
        <translation>Namnet på projektet %1 är inte giltig UTF-8; byt namn på projektet.</translation>
    </message>
    <message>
        <source>%1 lies on another file system than the folder that holds it, so the two cannot be written in one step; choose another folder, or unmount it.</source>
        <translation>%1 ligger på ett annat filsystem än mappen som innehåller den, så de två kan inte skrivas i ett steg; välj en annan mapp eller avmontera den.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2; close other programs or raise the limit on open files (ulimit -n).</source>
        <translation>%1 kan inte skrivas: %2; stäng andra program eller höj gränsen för öppna filer (ulimit -n).</translation>
    </message>
    <message>
        <source>The project holds no recipe: the key &quot;recipe&quot; is missing or no object; take another copy of the project.</source>
        <translation>Projektet saknar recept: nyckeln &quot;recipe&quot; saknas eller är inget objekt; ta en annan kopia av projektet.</translation>
    </message>
    <message>
        <source>%1 was changed, moved or removed while it was in use, or can no longer be read, so nothing was made of it; leave it where it is and start again, or take an unchanged copy.</source>
        <translation>%1 ändrades, flyttades eller togs bort medan den användes, eller kan inte längre läsas, så inget gjordes av den; låt den ligga där den är och börja om, eller ta en oförändrad kopia.</translation>
    </message>
    <message>
        <source>%1 is a project and brings its own recipe, so --recipe and --profile (%2) would change nothing; leave them out, or export from the recordings.</source>
        <translation>%1 är ett projekt och har sitt eget recept, så --recipe och --profile (%2) skulle inte ändra något; utelämna dem, eller exportera från registreringarna.</translation>
    </message>
    <message>
        <source>%1 is no recording over time: its values lie along &quot;%2&quot; (X_Dimension, X_Unit_Label), and Time in s, ms, us or ns is needed.</source>
        <translation>%1 är ingen registrering över tid: dess värden ligger längs ”%2” (X_Dimension, X_Unit_Label), och Time i s, ms, us eller ns behövs.</translation>
    </message>
    <message>
        <source>%1: %2 = %3 and %4 = %5 contradict each other (%6 and %7), so the sample rate is unknown; state it in the recipe&apos;s import section.</source>
        <translation>%1: %2 = %3 och %4 = %5 motsäger varandra (%6 och %7), så samplingsfrekvensen är okänd; ange den i receptets importdel.</translation>
    </message>
    <message>
        <source>%1: the times in %2 step by %3 and those in %4 by %5, which fits no sample rate in common, so it is unknown; state it in the recipe&apos;s import section.</source>
        <translation>%1: tiderna i %2 stegar med %3 och de i %4 med %5, vilket inte passar någon gemensam samplingsfrekvens, så den är okänd; ange den i receptets importdel.</translation>
    </message>
    <message>
        <source>Channel %1 is no recording over time: its values lie along &quot;%2&quot; (wf_xunit_string, wf_xname), and s, ms, us or ns is needed.</source>
        <translation>Kanal %1 är ingen registrering över tid: dess värden ligger längs ”%2” (wf_xunit_string, wf_xname), och s, ms, us eller ns behövs.</translation>
    </message>
    <message>
        <source>%1: the times in %2 are not uniform (allowed is 1 % of a step, and half a step in all), so the sample rate is unknown; state it in the recipe&apos;s import section if it is known.</source>
        <translation>%1: tiderna i %2 är inte jämna (tillåtet är 1 % av ett steg, och ett halvt steg totalt), så samplingsfrekvensen är okänd; ange den i receptets importdel om den är känd.</translation>
    </message>
    <message>
        <source>%1: the times drift: line %2 is %3 steps off a straight line from the first time to the last (allowed is %4), so no one sample rate is that of all samples. Record anew, or name only the columns of samples and give the sample rate in the recipe&apos;s import section.</source>
        <translation>%1: tiderna driver: rad %2 ligger %3 steg från en rät linje från första tiden till sista (tillåtet är %4), så ingen enda samplingsfrekvens gäller alla sampel. Spela in på nytt, eller namnge bara kolumnerna med sampel och ange samplingsfrekvensen i receptets importdel.</translation>
    </message>
    <message>
        <source>Shot %1, channel &apos;%2&apos;: the unit &quot;%3&quot; is not known, so it cannot be divided by a sensitivity per pascal; the units known are V, mV, uV, kV, A, C, W and 1. Give one of them as the channel&apos;s unit, with the scale that it needs.</source>
        <translation>Skott %1, kanal &apos;%2&apos;: enheten &quot;%3&quot; är okänd, så den kan inte delas med en känslighet per pascal; kända enheter är V, mV, uV, kV, A, C, W och 1. Ange en av dem som kanalens enhet, med den skala som behövs.</translation>
    </message>
    <message>
        <source>%V1 (not a date; write it as 2026-01-31)</source>
        <translation>%V1 (inget datum; skriv det som 2026-01-31)</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: no step found. The largest change is %3, and more than %4 is needed, %5 times the noise of %6: set window.start by hand or exclude the shot.</source>
        <translation>Skott %1, kanal %2: inget steg hittat. Den största ändringen är %3, och mer än %4 krävs, %5 gånger bruset på %6: ange window.start för hand eller uteslut skottet.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: no step found. The largest change is %3, and more than %4 is needed, %5 times the %6 that the record drifts in the same time: set window.start by hand or exclude the shot.</source>
        <translation>Skott %1, kanal %2: inget steg hittat. Den största ändringen är %3, och mer än %4 krävs, %5 gånger de %6 som registreringen driver under samma tid: ange window.start för hand eller uteslut skottet.</translation>
    </message>
    <message>
        <source>%1 is no longer where it was opened: it was moved or removed, or its drive is gone. Put it back and read it again, or locate it; nothing is exported before.</source>
        <translation>%1 finns inte längre där den öppnades: den har flyttats eller tagits bort, eller så är enheten borta. Lägg tillbaka den och läs om den, eller leta upp den; ingenting exporteras förrän dess.</translation>
    </message>
    <message>
        <source>%1 was changed after it was opened, so what is shown may no longer be what it holds. Read it again; nothing is exported before.</source>
        <translation>%1 har ändrats sedan den öppnades, så det som visas är kanske inte längre det som den innehåller. Läs om den; ingenting exporteras förrän dess.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: invalid samples (%3, from sample %4 to %5) at %6, inside the response window or its baseline; exclude the shot or set import.interpolate_invalid.</source>
        <translation>Skott %1, kanal %2: ogiltiga sampel (%3, från sampel %4 till %5) vid %6, inom svarsfönstret eller dess baslinje; uteslut skottet eller sätt import.interpolate_invalid.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2 is saturated for %3 (%4 samples) at %5, from %6 on, inside the response window or its baseline; the shot cannot be used: exclude it.</source>
        <translation>Skott %1, kanal %2 är mättad under %3 (%4 sampel) vid %5, från och med %6, inom svarsfönstret eller dess baslinje; skottet kan inte användas: uteslut det.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2 stands still at %3 from %4 on, although its baseline shows noise: it froze during the response, so the end of the plateau cannot be found. Exclude the shot, or set window.end_s before that time if the record up to there can be trusted.</source>
        <translation>Skott %1, kanal %2 står stilla på %3 från och med %4, fast baslinjen visar brus: signalen frös under svaret, så platåns slut kan inte hittas. Uteslut skottet, eller sätt window.end_s före den tiden om registreringen fram till dess går att lita på.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2 stands still at %3 for %4 from %5 on, soon behind the response window, although its baseline shows noise: it was cut off or stuck there; look whether the response before can be trusted.</source>
        <translation>Skott %1, kanal %2 står stilla på %3 i %4 från och med %5, strax efter svarsfönstret, fast baslinjen visar brus: signalen skars av eller fastnade där; se efter om svaret dessförinnan går att lita på.</translation>
    </message>
    <message>
        <source>The Hankel matrix was decomposed for another treatment of the response than the model&apos;s; compute the decomposition again.</source>
        <translation>Hankelmatrisen delades upp för en annan behandling av svaret än modellens; beräkna uppdelningen igen.</translation>
    </message>
    <message>
        <source>Sensitivity at the onset of the step, mean of the shots</source>
        <translation>Känslighet vid stegets början, medelvärde över skotten</translation>
    </message>
    <message>
        <source>Drift of shot %1 behind the step, from the onset to %2 after it (no part of the sensitivity)</source>
        <translation>Drift för skott %1 efter steget, från början till %2 efter den (ingår inte i känsligheten)</translation>
    </message>
    <message>
        <source>Behind the step the response drifts by %1 % until the end of the model input, with a time constant of about %2: slower than the sensor, so no part of its step (heat of the gas, an AC coupling). The sensitivity is that of the level at the onset, before the drift.</source>
        <translation>Efter steget driver svaret med %1 % fram till slutet av modellens indata, med en tidskonstant på omkring %2: långsammare än givaren och alltså ingen del av dess steg (gasens värme, en AC-koppling). Känsligheten är den för nivån vid början, före driften.</translation>
    </message>
    <message>
        <source>A part of the response with a time constant of %1 may be the sensor&apos;s own or a drift (heat of the gas, an AC coupling): it is less than ten times slower than the rest. It counts as the sensor&apos;s own; as a drift it would change the sensitivity by %2 %. Compare with a shot of another step, or with the static sensitivity.</source>
        <translation>En del av svaret med tidskonstanten %1 kan vara givarens egen eller en drift (gasens värme, en AC-koppling): den är mindre än tio gånger långsammare än resten. Den räknas som givarens egen; som drift skulle den ändra känsligheten med %2 %. Jämför med ett skott med annat steg, eller med den statiska känsligheten.</translation>
    </message>
    <message>
        <source>not determined (no level at the onset)</source>
        <translation>inte bestämd (ingen nivå vid stegets början)</translation>
    </message>
    <message>
        <source>Sensitivity at the onset of the step, low level</source>
        <translation>Känslighet vid stegets början, låg nivå</translation>
    </message>
    <message>
        <source>Sensitivity at the onset of the step, medium level</source>
        <translation>Känslighet vid stegets början, medelnivå</translation>
    </message>
    <message>
        <source>Sensitivity at the onset of the step, high level</source>
        <translation>Känslighet vid stegets början, hög nivå</translation>
    </message>
    <message>
        <source>Sensitivity at the onset of the step, mean of the shots, which do not agree</source>
        <translation>Känslighet vid stegets början, medelvärde över skotten, som inte stämmer överens</translation>
    </message>
    <message>
        <source>Change of the sensitivity with the step</source>
        <translation>Känslighetens ändring med steget</translation>
    </message>
    <message>
        <source>The sensitivities of the shots, from %1 to %2 % about their mean, differ by more than their uncertainties explain; shot %3 is the odd one. Their scatter serves as the uncertainty of the mean; look at that shot, its step and its level, or state one value per level.</source>
        <translation>Skottens känsligheter, från %1 till %2 % kring medelvärdet, skiljer sig mer än deras osäkerheter förklarar; skott %3 avviker mest. Deras spridning gäller som medelvärdets osäkerhet; granska det skottet, dess steg och dess nivå, eller ange ett värde per nivå.</translation>
    </message>
    <message>
        <source>The sensitivities of the shots, from %1 to %2 % about their mean, differ by more than 1 % each would explain (their own uncertainties are not known); shot %3 is the odd one. Look at that shot, its step and its level, or state one value per level.</source>
        <translation>Skottens känsligheter, från %1 till %2 % kring medelvärdet, skiljer sig mer än 1 % vardera skulle förklara (deras egna osäkerheter är inte kända); skott %3 avviker mest. Granska det skottet, dess steg och dess nivå, eller ange ett värde per nivå.</translation>
    </message>
    <message>
        <source>The gas constants recorded in the capture give a speed of sound of %1 in the driven gas, the gas that it names gives %2: with that the pressure step would be %3 % different. The constants are used; choose the driven gas.</source>
        <translation>Gaskonstanterna i registreringen ger ljudhastigheten %1 i den drivna gasen, gasen som den namnger ger %2: med den skulle trycksteget vara %3 % annorlunda. Konstanterna används; välj den drivna gasen.</translation>
    </message>
    <message>
        <source>The chosen driven gas has a speed of sound of %1, air of the known humidity %2: with that the pressure step would be %3 % different. The chosen gas is used; choose humid air or the recorded gas if that is what was in the tube.</source>
        <translation>Den valda drivna gasen har ljudhastigheten %1, luft med den kända fuktigheten %2: med den skulle trycksteget vara %3 % annorlunda. Den valda gasen används; välj fuktig luft eller den registrerade gasen om det var den som fanns i röret.</translation>
    </message>
    <message>
        <source>The chosen driven gas has a speed of sound of %1, the gas constants recorded in the capture give %2: with that the pressure step would be %3 % different. The chosen gas is used; check which one was in the tube.</source>
        <translation>Den valda drivna gasen har ljudhastigheten %1, gaskonstanterna i registreringen ger %2: med dem skulle trycksteget vara %3 % annorlunda. Den valda gasen används; kontrollera vilken som fanns i röret.</translation>
    </message>
    <message>
        <source>The chosen driven gas has a speed of sound of %1, the gas named in the capture %2: with that the pressure step would be %3 % different. The chosen gas is used; check which one was in the tube.</source>
        <translation>Den valda drivna gasen har ljudhastigheten %1, gasen som namnges i registreringen %2: med den skulle trycksteget vara %3 % annorlunda. Den valda gasen används; kontrollera vilken som fanns i röret.</translation>
    </message>
    <message>
        <source>%1: by import.columns_are each column is a shot of the DUT, so import.columns.dut cannot name one of them; leave it out.</source>
        <translation>%1: enligt import.columns_are är varje kolumn ett skott med DUT, så import.columns.dut kan inte ange en av dem; utelämna den.</translation>
    </message>
    <message>
        <source>Recipe import.shots names shot %1; the shots are 1 to %2.</source>
        <translation>Receptets import.shots anger skott %1; skotten är 1 till %2.</translation>
    </message>
    <message>
        <source>Recipe import.shots names shot %1 twice.</source>
        <translation>Receptets import.shots anger skott %1 två gånger.</translation>
    </message>
    <message>
        <source>agree</source>
        <translation>stämmer överens</translation>
    </message>
    <message>
        <source>%1 contradict each other</source>
        <translation>%1 motsäger varandra</translation>
    </message>
    <message>
        <source>No quantity was known in two independent ways.</source>
        <translation>Ingen storhet var känd på två oberoende vägar.</translation>
    </message>
    <message>
        <source>Independent ways to one quantity, compared within the combined uncertainty of their difference (contradiction from 3.6 u on)</source>
        <translation>Oberoende vägar till en storhet, jämförda inom skillnadens sammanlagda osäkerhet (motsägelse från 3,6 u)</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Storhet</translation>
    </message>
    <message>
        <source>One way</source>
        <translation>En väg</translation>
    </message>
    <message>
        <source>Other way</source>
        <translation>Annan väg</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Gjorda</translation>
    </message>
    <message>
        <source>Largest difference, u</source>
        <translation>Största skillnad, u</translation>
    </message>
    <message>
        <source>Fault seen in 90 %</source>
        <translation>Fel som syns i 90 %</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Utfall</translation>
    </message>
    <message>
        <source>No pressure step is determined: neither a step nor a shock velocity with initial pressure and temperature was given. No sensitivity in the unit of pressure can be stated.</source>
        <translation>Inget trycksteg är bestämt: varken ett steg eller en stötvågshastighet med begynnelsetryck och begynnelsetemperatur har angivits. Ingen känslighet i tryckenhet kan anges.</translation>
    </message>
    <message>
        <source>Normalised response over frequency: from the responses without a model, and from the model</source>
        <translation>Normerat svar över frekvens: ur svaren utan modell och ur modellen</translation>
    </message>
    <message>
        <source>Of the %1 frequencies asked for, %2 lie outside these limits and have no line.</source>
        <translation>Av de %1 begärda frekvenserna ligger %2 utanför dessa gränser och har ingen rad.</translation>
    </message>
    <message>
        <source>The magnitude is relative to the level at the onset of the step.</source>
        <translation>Beloppet är relativt nivån vid stegets början.</translation>
    </message>
    <message>
        <source>A free decay has no frequency response: what excited the item was not measured.</source>
        <translation>En fri utsvängning har inget frekvenssvar: det som exciterade objektet mättes inte.</translation>
    </message>
    <message>
        <source>The oscillations above were fitted in each shot together with the sensor. Poles and all results are those of the sensor without them; the fit counts them.</source>
        <translation>Svängningarna ovan anpassades i varje skott tillsammans med givaren. Poler och alla resultat är givarens utan dem; anpassningsgraden räknar med dem.</translation>
    </message>
    <message>
        <source>Largest deflection</source>
        <translation>Största utslag</translation>
    </message>
    <message>
        <source>Certificate of the normalised dynamic response</source>
        <translation>Bevis över det normerade dynamiska svaret</translation>
    </message>
    <message>
        <source>Certificate of natural frequency and damping</source>
        <translation>Bevis över egenfrekvens och dämpning</translation>
    </message>
    <message>
        <source>The sensitivity S(f) is the complex ratio of the item&apos;s output to the change of pressure at the sensor&apos;s face in the side wall of a shock tube; phase of output over input, lag negative, relative to the sensor&apos;s own onset.</source>
        <translation>Känsligheten S(f) är det komplexa förhållandet mellan objektets utsignal och tryckändringen vid givarens yta i stötrörets sidovägg; fas för utsignal relativt insignal, eftersläpning negativ, räknat från givarens egen start.</translation>
    </message>
    <message>
        <source>The sensitivity S(f) is the complex ratio of the item&apos;s output to the change of pressure at the sensor&apos;s face; phase of output over input, lag negative, relative to the sensor&apos;s own onset.</source>
        <translation>Känsligheten S(f) är det komplexa förhållandet mellan objektets utsignal och tryckändringen vid givarens yta; fas för utsignal relativt insignal, eftersläpning negativ, räknat från givarens egen start.</translation>
    </message>
    <message>
        <source>The normalised response N(f) is the complex ratio of the item&apos;s output to a step, relative to the level at the onset of that step; phase of output over input, lag negative, relative to the sensor&apos;s own onset.</source>
        <translation>Det normerade svaret N(f) är det komplexa förhållandet mellan objektets utsignal och ett steg, relativt nivån vid stegets början; fas för utsignal relativt insignal, eftersläpning negativ, räknat från givarens egen start.</translation>
    </message>
    <message>
        <source>The item decayed freely after an excitation that was not measured. Its undamped natural frequencies and damping ratios are determined; the ratio of its output to what excited it is not.</source>
        <translation>Objektet svängde ut fritt efter en excitation som inte mättes. Dess odämpade egenfrekvenser och relativa dämpningar är bestämda; förhållandet mellan dess utsignal och det som exciterade det är det inte.</translation>
    </message>
    <message>
        <source>The pressure step of each shot follows from the shock wave and the initial state of the gas, unless the section &quot;Conditions&quot; says that it was stated.</source>
        <translation>Varje skotts trycksteg följer av stötvågen och gasens begynnelsetillstånd, om inte avsnittet ”Förhållanden” säger att det angavs.</translation>
    </message>
    <message>
        <source>The pressure step of each shot was stated by the operator. It was not computed, and its uncertainty is not known.</source>
        <translation>Varje skotts trycksteg angavs av operatören. Det beräknades inte, och dess osäkerhet är inte känd.</translation>
    </message>
    <message>
        <source>The size of the step is not known: no sensitivity is stated, and all magnitudes are relative.</source>
        <translation>Stegets storlek är inte känd: ingen känslighet anges, och alla belopp är relativa.</translation>
    </message>
    <message>
        <source>Signal to noise is the largest deflection over the standard deviation of the noise before it. No uncertainty is known of the deflection: it has three significant digits.</source>
        <translation>Signalbrusförhållandet är största utslaget dividerat med standardavvikelsen för bruset före det. För utslaget är ingen osäkerhet känd: det har tre värdesiffror.</translation>
    </message>
    <message>
        <source>One of the two ways gives no value here.</source>
        <translation>En av de två vägarna ger inget värde här.</translation>
    </message>
    <message>
        <source>It needs two shots at least whose sensitivities are known.</source>
        <translation>Det behövs minst två skott vars känsligheter är kända.</translation>
    </message>
    <message>
        <source>It needs shots of two levels whose steps are known.</source>
        <translation>Det behövs skott på två nivåer vars steg är kända.</translation>
    </message>
    <message>
        <source>The velocity stated for this shot is %1, the arrivals give %2: they differ by %3 times their combined uncertainty. Check what was typed, the distances and the sample rate.</source>
        <translation>Hastigheten som anges för detta skott är %1, ankomsterna ger %2: de skiljer sig med %3 gånger sin sammanlagda osäkerhet. Kontrollera det som skrevs in, avstånden och samplingsfrekvensen.</translation>
    </message>
    <message>
        <source>The ratio of the reflected to the incident step at &apos;%4&apos; belongs to Mach %1, the velocity over the speed of sound is Mach %2: they differ by %3 times their combined uncertainty. The ratio needs no clock and no sensitivity; check sample rate, distances, gas and temperature.</source>
        <translation>Kvoten mellan det reflekterade och det infallande steget vid &quot;%4&quot; hör till Mach %1, hastigheten genom ljudhastigheten är Mach %2: de skiljer sig med %3 gånger sin sammanlagda osäkerhet. Kvoten behöver varken klocka eller känslighet; kontrollera samplingsfrekvens, avstånd, gas och temperatur.</translation>
    </message>
    <message>
        <source>The ratio of the velocities of the incident and the reflected shock at &apos;%4&apos; belongs to Mach %1, the velocity over the speed of sound is Mach %2: they differ by %3 times their combined uncertainty. The ratio needs no clock; check sample rate, distances, gas and temperature.</source>
        <translation>Kvoten mellan den infallande och den reflekterade stötvågens hastigheter vid &quot;%4&quot; hör till Mach %1, hastigheten genom ljudhastigheten är Mach %2: de skiljer sig med %3 gånger sin sammanlagda osäkerhet. Kvoten behöver ingen klocka; kontrollera samplingsfrekvens, avstånd, gas och temperatur.</translation>
    </message>
    <message>
        <source>The pressure behind the shock rises by %1 at &apos;%4&apos; and should by %2: they differ by %3 times their combined uncertainty. Check p1, the velocity, and unit and sensitivity of the sensor.</source>
        <translation>Trycket bakom stötvågen stiger med %1 vid &quot;%4&quot; och borde stiga med %2: de skiljer sig med %3 gånger sin sammanlagda osäkerhet. Kontrollera p1, hastigheten samt givarens enhet och känslighet.</translation>
    </message>
    <message>
        <source>The pressure behind the reflected shock is %1 above p1 at &apos;%4&apos; and should be %2: they differ by %3 times their combined uncertainty. Check p1, the velocity, and unit and sensitivity of the sensor.</source>
        <translation>Trycket bakom den reflekterade stötvågen är %1 över p1 vid &quot;%4&quot; och borde vara %2: de skiljer sig med %3 gånger sin sammanlagda osäkerhet. Kontrollera p1, hastigheten samt givarens enhet och känslighet.</translation>
    </message>
    <message>
        <source>The typed pressure step of this shot is %1, the velocity gives %2: they differ by %3 times their combined uncertainty. Check what was typed.</source>
        <translation>Det inskrivna trycksteget för detta skott är %1, hastigheten ger %2: de skiljer sig med %3 gånger sin sammanlagda osäkerhet. Kontrollera det som skrevs in.</translation>
    </message>
    <message>
        <source>The sensitivity of this shot is %1, the card of the sensor states %2: they differ by %3 times their combined uncertainty. Check scale and unit of the recording, p1 and the card.</source>
        <translation>Känsligheten för detta skott är %1, givarkortet anger %2: de skiljer sig med %3 gånger sin sammanlagda osäkerhet. Kontrollera inspelningens skala och enhet, p1 och kortet.</translation>
    </message>
    <message>
        <source>No comparison contradicts alone, but all %1 together leave a chi-square of %2, which happens by chance in %3 % of calibrations: look at the largest differences, and at the causes named.</source>
        <translation>Ingen jämförelse motsäger ensam, men alla %1 tillsammans ger chi-två %2, vilket händer av en slump i %3 % av kalibreringarna: se på de största skillnaderna och de orsaker som nämns.</translation>
    </message>
    <message>
        <source>The levels named for the shots are not in the order of their pressure steps: check which recording belongs to which shot (import.levels).</source>
        <translation>Skottens namngivna nivåer följer inte ordningen på deras trycksteg: kontrollera vilken inspelning som hör till vilket skott (import.levels).</translation>
    </message>
    <message>
        <source>No arrival sensor with a distance marks the shock.</source>
        <translation>Ingen ankomstgivare med angivet avstånd markerar stötvågen.</translation>
    </message>
    <message>
        <source>It needs three places; there are two.</source>
        <translation>Det behövs tre platser; det finns två.</translation>
    </message>
    <message>
        <source>The reflected shock is not seen to pass the sensor again.</source>
        <translation>Den reflekterade stötvågen syns inte passera givaren igen.</translation>
    </message>
    <message>
        <source>The plateau behind the reflected shock is too short at the sensor to be read.</source>
        <translation>Platån bakom den reflekterade stötvågen är för kort vid givaren för att kunna läsas av.</translation>
    </message>
    <message>
        <source>No sensor in the end wall marks the reflection.</source>
        <translation>Ingen givare i ändväggen markerar reflexionen.</translation>
    </message>
    <message>
        <source>The channel is no pressure: its unit or the sensor&apos;s sensitivity is not stated.</source>
        <translation>Kanalen är inget tryck: dess enhet eller givarens känslighet är inte angiven.</translation>
    </message>
    <message>
        <source>The driver pressure or its temperature is not recorded.</source>
        <translation>Drivtrycket eller dess temperatur är inte registrerat.</translation>
    </message>
    <message>
        <source>The velocity of the shock is not known.</source>
        <translation>Stötvågens hastighet är inte känd.</translation>
    </message>
    <message>
        <source>The sensitivity is not determined.</source>
        <translation>Känsligheten är inte bestämd.</translation>
    </message>
    <message>
        <source>The card of the sensor states no sensitivity in the unit of the calibration.</source>
        <translation>Givarkortet anger ingen känslighet i kalibreringens enhet.</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Hastighet</translation>
    </message>
    <message>
        <source>Travel time</source>
        <translation>Gångtid</translation>
    </message>
    <message>
        <source>p2 − p1</source>
        <translation>p2 − p1</translation>
    </message>
    <message>
        <source>p5 − p1</source>
        <translation>p5 − p1</translation>
    </message>
    <message>
        <source>Driver pressure</source>
        <translation>Drivtryck</translation>
    </message>
    <message>
        <source>Sensitivity, shot against shots</source>
        <translation>Känslighet, skott mot skott</translation>
    </message>
    <message>
        <source>Order of the levels</source>
        <translation>Nivåernas ordning</translation>
    </message>
    <message>
        <source>typed</source>
        <translation>inskrivet</translation>
    </message>
    <message>
        <source>counters</source>
        <translation>räknare</translation>
    </message>
    <message>
        <source>arrivals</source>
        <translation>ankomster</translation>
    </message>
    <message>
        <source>this arrival</source>
        <translation>denna ankomst</translation>
    </message>
    <message>
        <source>other arrivals</source>
        <translation>övriga ankomster</translation>
    </message>
    <message>
        <source>velocity over speed of sound</source>
        <translation>hastighet genom ljudhastighet</translation>
    </message>
    <message>
        <source>ratio of the steps</source>
        <translation>stegens kvot</translation>
    </message>
    <message>
        <source>ratio of the velocities</source>
        <translation>hastigheternas kvot</translation>
    </message>
    <message>
        <source>side sensor</source>
        <translation>sidogivare</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>registrerat</translation>
    </message>
    <message>
        <source>sensor card</source>
        <translation>givarkort</translation>
    </message>
    <message>
        <source>this calibration</source>
        <translation>denna kalibrering</translation>
    </message>
    <message>
        <source>this shot</source>
        <translation>detta skott</translation>
    </message>
    <message>
        <source>other shots</source>
        <translation>övriga skott</translation>
    </message>
    <message>
        <source>names</source>
        <translation>namn</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>steg</translation>
    </message>
    <message>
        <source>not determined (a free decay has no step)</source>
        <translation>inte bestämt (en fri utsvängning har inget steg)</translation>
    </message>
    <message>
        <source>not determined (the model diverges)</source>
        <translation>inte bestämt (modellen divergerar)</translation>
    </message>
    <message>
        <source>not determined (the level of the step is not known)</source>
        <translation>inte bestämt (stegets nivå är inte känd)</translation>
    </message>
    <message>
        <source>below %1 (two samples)</source>
        <translation>under %1 (två sampel)</translation>
    </message>
    <message>
        <source>above %1 (the window ends there)</source>
        <translation>över %1 (fönstret slutar där)</translation>
    </message>
    <message>
        <source>not determined (the window ends before the top)</source>
        <translation>inte bestämt (fönstret slutar före toppen)</translation>
    </message>
    <message>
        <source>above %1 (the band of the response ends there)</source>
        <translation>över %1 (svarets band slutar där)</translation>
    </message>
    <message>
        <source>below %1 (the band of the response begins there)</source>
        <translation>under %1 (svarets band börjar där)</translation>
    </message>
    <message>
        <source>A part of the response with a time constant of about %1 has not ended within the model input, and the model could not be refined, so that it is unknown whether it is a drift (heat of the gas, an AC coupling). The sensitivity is that of the level to which the model tends, an extrapolation. Choose another order, or let the model be refined.</source>
        <translation>En del av svaret med tidskonstanten omkring %1 har inte avslutats inom modellens indata, och modellen kunde inte förfinas, så det är okänt om den är en drift (gasens värme, en AC-koppling). Känsligheten är den för nivån som modellen går mot, en extrapolation. Välj en annan ordning, eller låt modellen förfinas.</translation>
    </message>
    <message>
        <source>The recipe lists %1 values for %2 shots; give one number or null per shot (%3).</source>
        <translation>Receptet listar %1 värden för %2 skott; ange ett tal eller null per skott (%3).</translation>
    </message>
    <message>
        <source>Such a shock needs a driver pressure of %1, more than the %2 that this tube can have had (three times the recorded one at most, and shock.largest_driver_pressure_pa): check sample rate, distances, gases and temperature.</source>
        <translation>En sådan stötvåg kräver ett drivtryck på %1, mer än de %2 som detta rör kan ha haft (högst tre gånger det registrerade, och shock.largest_driver_pressure_pa): kontrollera samplingsfrekvens, avstånd, gaser och temperatur.</translation>
    </message>
    <message>
        <source>The arrivals show a velocity that falls by %1 % per metre along the tube, outside the range of %2 to %3 % per metre that is assumed (shock.attenuation_per_m): widen the range if the tube does that, else check distances, delays and arrivals.</source>
        <translation>Ankomsterna visar en hastighet som avtar med %1 % per meter längs röret, utanför det antagna området %2 till %3 % per meter (shock.attenuation_per_m): vidga området om röret gör så, kontrollera annars avstånd, fördröjningar och ankomster.</translation>
    </message>
    <message>
        <source>The velocity is Mach %1; a shock in this tube reaches Mach %2 at most (shock.largest_mach): check sample rate, distances, gas and temperature.</source>
        <translation>Hastigheten är Mach %1; en stötvåg i detta rör når högst Mach %2 (shock.largest_mach): kontrollera samplingsfrekvens, avstånd, gas och temperatur.</translation>
    </message>
    <message>
        <source>The velocity %1 is typed once and serves all %2 shots: type one for each shot, or none where it is measured.</source>
        <translation>Hastigheten %1 är inskriven en gång och gäller alla %2 skott: skriv in en för varje skott, eller ingen där den mäts.</translation>
    </message>
    <message>
        <source>The pressure step %1 is typed once and serves all %2 shots: type one for each shot, or none where it is computed.</source>
        <translation>Trycksteget %1 är inskrivet en gång och gäller alla %2 skott: skriv in ett för varje skott, eller inget där det beräknas.</translation>
    </message>
    <message>
        <source>Move the end of shot %1 to %2</source>
        <translation>Flytta slutet för skott %1 till %2</translation>
    </message>
    <message>
        <source>window.end_s lists %1 ends for %2 shots; give one end or one per shot.</source>
        <translation>window.end_s anger %1 slut för %2 skott; ange ett slut, eller ett för varje skott.</translation>
    </message>
    <message>
        <source>Defect &apos;%1&apos;: this kind takes no number behind &apos;%2&apos;.</source>
        <translation>Defekt &apos;%1&apos;: denna sort tar inget tal efter &apos;%2&apos;.</translation>
    </message>
    <message>
        <source>Defect &apos;%1&apos;: what follows &apos;%2&apos; must be a number.</source>
        <translation>Defekt &apos;%1&apos;: det som följer efter &apos;%2&apos; ska vara ett tal.</translation>
    </message>
    <message>
        <source>Defect &apos;%1&apos; is asked for with %2; it must lie in %3 .. %4.</source>
        <translation>Defekten &apos;%1&apos; begärs med %2; värdet ska ligga i %3 .. %4.</translation>
    </message>
    <message>
        <source>Defect &apos;%1&apos; concerns the whole capture; it takes no number of a shot.</source>
        <translation>Defekten &apos;%1&apos; gäller hela registreringen; den tar inget skottnummer.</translation>
    </message>
    <message>
        <source>Defect &apos;%1&apos; needs shots of two levels; all shots are of one.</source>
        <translation>Defekten &apos;%1&apos; kräver skott på två nivåer; alla skott är på en och samma.</translation>
    </message>
    <message>
        <source>The uncertainty of the pressure step is not known.</source>
        <translation>Tryckstegets osäkerhet är inte känd.</translation>
    </message>
    <message>
        <source>No comparison contradicts alone, but all %1 together leave a chi-square of %2, which happens by chance in %3 % of calibrations, and no single fault explains it: look at the largest differences.</source>
        <translation>Ingen jämförelse är ensam motsägande, men alla %1 tillsammans ger chi-kvadrat %2, vilket av en slump händer i %3 % av kalibreringarna, och inget enskilt fel förklarar det: se på de största skillnaderna.</translation>
    </message>
    <message>
        <source>The state of the shock follows from the driver pressure.</source>
        <translation>Stötvågens tillstånd följer av drivtrycket.</translation>
    </message>
    <message>
        <source>The pressure %1 is typed once, and the state of all %2 shots follows from it: take the velocity, which is measured in each shot.</source>
        <translation>Trycket %1 är angivet en enda gång, och tillståndet i alla %2 skott följer av det: ta hastigheten, som mäts i varje skott.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos;: the recipe reads the numbers as %2, the file states %3, and no scale converts them: leave out the unit, or give the scale that belongs to it.</source>
        <translation>Kanal ”%1”: receptet läser talen som %2, filen anger %3, och ingen skala räknar om dem: utelämna enheten, eller ange den skala som hör till den.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos;: the recipe reads the numbers as %2, with a factor of %4 in place of the file&apos;s %3.</source>
        <translation>Kanal ”%1”: receptet läser talen som %2, med faktorn %4, i stället för filens %3.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos;: the recipe states a sensitivity of %2, the card of the sensor %3, which is %4 % different. The recipe&apos;s is used; correct it, or the card.</source>
        <translation>Kanal ”%1”: receptet anger känsligheten %2, givarens kort %3, vilket skiljer %4 %. Receptets används; rätta den, eller kortet.</translation>
    </message>
    <message>
        <source>Shot %1 is of the sensor %2, shot %3 of the sensor %4: a calibration is of one sensor. Take the shots of the other one out, or correct the captures.</source>
        <translation>Skott %1 gäller givaren %2, skott %3 givaren %4: en kalibrering gäller en givare. Ta bort den andras skott, eller rätta inspelningarna.</translation>
    </message>
    <message>
        <source>The card of the sensor states its sensitivity in %1, this calibration gives it in %2: one of the two units is wrong, and the values are not compared. Check import.unit and the card.</source>
        <translation>Givarens kort anger känsligheten i %1, den här kalibreringen ger den i %2: en av enheterna är fel, och värdena jämförs inte. Kontrollera import.unit och kortet.</translation>
    </message>
    <message>
        <source>Beside what other findings say, all %1 comparisons together leave a chi-square of %2, which happens by chance in %3 % of calibrations: look at the largest differences, and at the causes named.</source>
        <translation>Utöver vad andra anmärkningar säger lämnar alla %1 jämförelser tillsammans chi-kvadrat %2, vilket slumpen ger i %3 % av kalibreringarna: se på de största skillnaderna och på de orsaker som nämns.</translation>
    </message>
    <message>
        <source>With the humidity typed the driven gas has a speed of sound of %1, with the one recorded in the capture %2: with that the pressure step would be %3 % different. The typed one is used; correct it (shock.relative_humidity, 0 to 1), or leave it out.</source>
        <translation>Med den inskrivna fuktigheten har den drivna gasen ljudhastigheten %1, med den som inspelningen anger %2: med den skulle trycksteget skilja %3 %. Den inskrivna används; rätta den (shock.relative_humidity, 0 till 1), eller utelämna den.</translation>
    </message>
    <message>
        <source>One arrival time, %1, is typed for a sensor and serves all %2 shots: type one for each shot, or none where the record shows it.</source>
        <translation>En ankomsttid, %1, är inskriven för en givare och gäller alla %2 skott: skriv en för varje skott, eller ingen där inspelningen visar den.</translation>
    </message>
    <message>
        <source>Sensitivity at the onset of the step</source>
        <translation>Känslighet vid stegets början</translation>
    </message>
    <message>
        <source>The uncertainty of &apos;%1&apos; in uncertainty.budget is used for nothing: what is known of the attenuation is the range shock.attenuation_per_m.</source>
        <translation>Osäkerheten för ”%1” i uncertainty.budget används inte till något: det som är känt om dämpningen är området shock.attenuation_per_m.</translation>
    </message>
    <message>
        <source>The response taken from the data is withheld at %1 of %2 frequencies, from %3 to %4: what the end of the record cuts off may change it there by more than its noise and 2 %. Use a longer window, or only what the model says there.</source>
        <translation>Svaret taget direkt ur data anges inte vid %1 av %2 frekvenser, från %3 till %4: det som registreringens slut skär av kan ändra det där med mer än dess brus och 2 %. Använd ett längre fönster, eller bara vad modellen säger där.</translation>
    </message>
    <message>
        <source>The response taken from the data is withheld at %1 of %2 frequencies, from %3 to %4: the sampling may change it there by more than its noise and 2 %. Record at a higher rate, or use only what the model says there.</source>
        <translation>Svaret taget direkt ur data anges inte vid %1 av %2 frekvenser, från %3 till %4: samplingen kan ändra det där med mer än dess brus och 2 %. Registrera med högre samplingsfrekvens, eller använd bara vad modellen säger där.</translation>
    </message>
    <message>
        <source>The values without a model take nothing from it but the zero of time and, where there are any, the drift and what was taken out of the records. Where what sampling or the end of the records may change exceeds both the uncertainty of the noise and 2 % of the magnitude, none is stated; for the sampling it is assumed that above half the sample rate the response is nowhere stronger than just below.</source>
        <translation>Värdena utan modell tar inget från den utom tidens nollpunkt och, där de finns, driften och det som togs ut ur registreringarna. Där det som sampling eller registreringarnas slut kan ändra överstiger både brusets osäkerhet och 2 % av beloppet anges inget; för samplingen antas att svaret över halva samplingsfrekvensen ingenstans är starkare än strax under.</translation>
    </message>
    <message>
        <source>The pressure rises over %1 at the sensor, standard uncertainty %2. The values without a model are divided by what an even rise takes off, and its uncertainty is part of theirs; the model is that behind it.</source>
        <translation>Trycket stiger under %1 vid givaren, standardosäkerhet %2. Värdena utan modell är delade med vad en jämn stigning tar bort, och dess osäkerhet ingår i deras; modellen är den bakom den.</translation>
    </message>
    <message>
        <source>A copy of the step, %1 of it, follows after %2: an echo. The model and the response use the records up to %3 after the start; look for what reflects the shock.</source>
        <translation>En kopia av steget, %1 av det, följer efter %2: ett eko. Modellen och responsen använder registreringarna fram till %3 efter starten; sök efter vad som reflekterar stötvågen.</translation>
    </message>
    <message>
        <source>A copy of the step, %1 of it, follows after %2: an echo, and the end of the window that was set lies behind it. Poles, damping and response contain it; end the window before it.</source>
        <translation>En kopia av steget, %1 av det, följer efter %2: ett eko, och fönstrets inställda slut ligger bakom det. Poler, dämpning och respons innehåller det; avsluta fönstret före det.</translation>
    </message>
    <message>
        <source>Without the first %1 of the records the main resonance has %2 % of frequency and %3 % of damping more, beyond what noise allows: the pressure does not rise at once (state the duration of the front), or a faster part is missing in the model.</source>
        <translation>Utan registreringarnas första %1 har huvudresonansen %2 % högre frekvens och %3 % högre dämpning, mer än bruset tillåter: trycket stiger inte på en gång (ange frontens varaktighet), eller så saknar modellen en snabbare del.</translation>
    </message>
    <message>
        <source>A second-order sensor (damping ratio %1) describes the records better than order %2, by their BIC: of a response damped that much the realised poles tell little.</source>
        <translation>En givare av andra ordningen (dämpkvot %1) beskriver registreringarna bättre än ordning %2, enligt deras BIC: om ett så dämpat svar säger de realiserade polerna föga.</translation>
    </message>
    <message>
        <source>the model was not refined</source>
        <translation>modellen har inte förfinats</translation>
    </message>
    <message>
        <source>that of the pressure step or of a level is not known</source>
        <translation>tryckstegets eller en nivås osäkerhet är inte känd</translation>
    </message>
    <message>
        <source>The sensitivity has no complete uncertainty: that of the level at the onset is not known. Refine the model, or choose an order whose level is known.</source>
        <translation>Känsligheten har ingen fullständig osäkerhet: den för nivån vid stegets början är inte känd. Förfina modellen, eller välj en ordning vars nivå är känd.</translation>
    </message>
    <message>
        <source>The sensitivity has no complete uncertainty (%M1). State what is missing in uncertainty.budget or in the capture; without it no sensitivity is a result.</source>
        <translation>Känsligheten har ingen fullständig osäkerhet (%M1). Ange det som saknas i uncertainty.budget eller i registreringen; utan den är ingen känslighet ett resultat.</translation>
    </message>
    <message>
        <source>a part of it is not known</source>
        <translation>en del av den är inte känd</translation>
    </message>
    <message>
        <source>of the reference</source>
        <translation>referensens</translation>
    </message>
    <message>
        <source>The values without a model are ratios of the item&apos;s record to that of the reference transducer, times its sensitivity; outside the frequencies of its calibration there are none. Where what sampling or the end of the records may change exceeds both the uncertainty of the noise and 2 % of the magnitude, none is stated.</source>
        <translation>Värdena utan modell är kvoter mellan objektets och referensgivarens registrering, gånger referensgivarens känslighet; utanför frekvenserna i dess kalibrering finns inga. Där det som sampling eller registreringarnas slut kan ändra överstiger både brusets osäkerhet och 2 % av beloppet anges inget.</translation>
    </message>
    <message>
        <source>Reference transducer, channel</source>
        <translation>Referensgivare, kanal</translation>
    </message>
    <message>
        <source>Sensitivity of the reference transducer</source>
        <translation>Referensgivarens känslighet</translation>
    </message>
    <message>
        <source>second-order sensor, as stated by the laboratory: sensitivity %L1, natural frequency %L2, damping ratio %L3</source>
        <translation>givare av andra ordningen, enligt laboratoriets uppgift: känslighet %L1, egenfrekvens %L2, dämpning %L3</translation>
    </message>
    <message>
        <source>file with SHA-256 %1</source>
        <translation>fil med SHA-256 %1</translation>
    </message>
    <message>
        <source>Check by the second way: the sensitivity against the computed pressure step less that against the reference transducer is %1 %, with an expanded uncertainty of %2 % (k = 2).</source>
        <translation>Kontroll på den andra vägen: känsligheten mot det beräknade trycksteget minus den mot referensgivaren är %1 %, med en utvidgad osäkerhet av %2 % (k = 2).</translation>
    </message>
    <message>
        <source>The sensitivity S(f) is the complex ratio of the item&apos;s output to the change of pressure at the sensor&apos;s face, found by comparison with a reference transducer that the same change reached; phase of output over pressure, lag negative.</source>
        <translation>Känsligheten S(f) är den komplexa kvoten mellan objektets utsignal och tryckändringen vid givarens yta, bestämd genom jämförelse med en referensgivare som samma ändring nådde; fas hos utsignal över tryck, eftersläpning negativ.</translation>
    </message>
    <message>
        <source>The pressure step of each shot is what the reference transducer saw: the settled level of its output over its sensitivity at the lowest frequency of its calibration.</source>
        <translation>Varje skotts trycksteg är det som referensgivaren såg: den insvängda nivån hos dess utsignal över dess känslighet vid kalibreringens lägsta frekvens.</translation>
    </message>
    <message>
        <source>The response taken from the data is withheld at %1 of %2 frequencies, from %3 to %4: the reference transducer was not calibrated there, and nothing is extrapolated.</source>
        <translation>Responsen direkt ur data hålls inne vid %1 av %2 frekvenser, från %3 till %4: referensgivaren är inte kalibrerad där, och inget extrapoleras.</translation>
    </message>
    <message>
        <source>The step is that of a reference transducer, not of the shock.</source>
        <translation>Steget är en referensgivares, inte stötvågens.</translation>
    </message>
    <message>
        <source>response.reference is &quot;transducer&quot;, but comparison.enabled is false; switch the comparison on and say what the reference transducer is.</source>
        <translation>response.reference är &quot;transducer&quot;, men comparison.enabled är false; slå på jämförelsen och ange vad referensgivaren är.</translation>
    </message>
    <message>
        <source>A comparison with a reference transducer needs the response to a step; with input.treatment &quot;impulse&quot; switch comparison.enabled off.</source>
        <translation>En jämförelse med en referensgivare kräver svaret på ett steg; slå av comparison.enabled med input.treatment &quot;impulse&quot;.</translation>
    </message>
    <message>
        <source>A comparison needs the reference transducer&apos;s sensitivity from one place: give comparison.source or comparison.model, not both and not neither.</source>
        <translation>En jämförelse behöver referensgivarens känslighet från ett ställe: ange comparison.source eller comparison.model, inte båda och inte ingetdera.</translation>
    </message>
    <message>
        <source>Shot %1 has no channel of a reference transducer beside the sensor; give one the role &apos;reference&apos; (import.channels), name it in comparison.channel, or switch the comparison off.</source>
        <translation>Skott %1 har ingen kanal med en referensgivare bredvid givaren; ge en kanal rollen &apos;reference&apos; (import.channels), namnge den i comparison.channel, eller slå av jämförelsen.</translation>
    </message>
    <message>
        <source>The reference transducer&apos;s channel %1 is recorded in %2, but comparison.unit is %3; they must belong together, such as V and V/Pa.</source>
        <translation>Referensgivarens kanal %1 är registrerad i %2, men comparison.unit är %3; de måste höra ihop, som V och V/Pa.</translation>
    </message>
    <message>
        <source>a frequency above that of the row before, and above 0</source>
        <translation>en frekvens över föregående rads, och över 0</translation>
    </message>
    <message>
        <source>a magnitude above 0</source>
        <translation>ett belopp över 0</translation>
    </message>
    <message>
        <source>an uncertainty of the magnitude that is not negative</source>
        <translation>en osäkerhet för beloppet som inte är negativ</translation>
    </message>
    <message>
        <source>a phase with its uncertainty in all rows, or in none</source>
        <translation>en fas med osäkerhet på alla rader, eller på ingen</translation>
    </message>
    <message>
        <source>degrees of freedom above 0</source>
        <translation>frihetsgrader över 0</translation>
    </message>
    <message>
        <source>comparison.model needs sensitivity, f0_hz and zeta above 0, and no uncertainty below 0.</source>
        <translation>comparison.model behöver sensitivity, f0_hz och zeta över 0, och ingen osäkerhet under 0.</translation>
    </message>
    <message>
        <source>Shot %1: the record of channel %2, from %3 to %4, does not hold the baseline and the response of channel %5; record both over the same time, or shorten the window.</source>
        <translation>Skott %1: registreringen av kanal %2, från %3 till %4, innehåller inte baslinjen och responsen hos kanal %5; registrera båda över samma tid, eller förkorta fönstret.</translation>
    </message>
    <message>
        <source>The sensitivity against the computed pressure step differs by %1 % from that against the reference transducer, more than both uncertainties allow (U = %2 %, k = 2). Check the transducer&apos;s certificate, unit and chain, and gas, temperature and distances of the step.</source>
        <translation>Känsligheten mot det beräknade trycksteget skiljer sig med %1 % från den mot referensgivaren, mer än båda osäkerheterna tillåter (U = %2 %, k = 2). Kontrollera givarens certifikat, enhet och mätkedja samt stegets gas, temperatur och avstånd.</translation>
    </message>
    <message>
        <source>Quality factor</source>
        <translation>Godhetstal</translation>
    </message>
    <message>
        <source>Resonance frequency (largest magnitude)</source>
        <translation>Resonansfrekvens (största beloppet)</translation>
    </message>
    <message>
        <source>Magnitude at the resonance over the level at the onset</source>
        <translation>Belopp vid resonansen relativt nivån vid stegets början</translation>
    </message>
    <message>
        <source>Key results</source>
        <translation>Huvudresultat</translation>
    </message>
    <message>
        <source>Results in detail</source>
        <translation>Resultat i detalj</translation>
    </message>
    <message>
        <source>The shots do not agree: the sensitivity is stated for each level, and no mean of all shots.</source>
        <translation>Skotten stämmer inte överens: känsligheten anges för varje nivå, och inget medelvärde av alla skott.</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Värde</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>Not among the results, because no value with a complete uncertainty is known of them</source>
        <translation>Inte bland resultaten, eftersom inget värde med fullständig osäkerhet är känt av dem</translation>
    </message>
    <message>
        <source>What is known</source>
        <translation>Vad som är känt</translation>
    </message>
    <message>
        <source>no complete uncertainty</source>
        <translation>ingen fullständig osäkerhet</translation>
    </message>
    <message>
        <source>no complete uncertainty:</source>
        <translation>ingen fullständig osäkerhet:</translation>
    </message>
    <message>
        <source>Recipe key certificate.decision.to_hz is %1; it needs more than certificate.decision.from_hz, which is %2.</source>
        <translation>Receptnyckeln certificate.decision.to_hz är %1; den måste vara större än certificate.decision.from_hz, som är %2.</translation>
    </message>
    <message>
        <source>simple acceptance (ILAC-G8): the deviation is at most the limit; a deviation at the limit lies beyond it with a probability of up to 50 %</source>
        <translation>enkel acceptans (ILAC-G8): avvikelsen är högst lika med gränsen; en avvikelse på gränsen ligger bortom den med en sannolikhet på upp till 50 %</translation>
    </message>
    <message>
        <source>guard band w = U (ILAC-G8): the deviation is at most the limit less its expanded uncertainty U</source>
        <translation>skyddsband w = U (ILAC-G8): avvikelsen är högst lika med gränsen minus sin utvidgade osäkerhet U</translation>
    </message>
    <message>
        <source>specific risk (JCGM 106): the probability that the deviation lies beyond the limit is at most %1 % at every frequency</source>
        <translation>specifik risk (JCGM 106): sannolikheten att avvikelsen ligger bortom gränsen är högst %1 % vid varje frekvens</translation>
    </message>
    <message>
        <source>conforms</source>
        <translation>överensstämmer</translation>
    </message>
    <message>
        <source>does not conform</source>
        <translation>överensstämmer inte</translation>
    </message>
    <message>
        <source>at %1 the deviation is %2; it lies beyond the limit with a probability of %3 %</source>
        <translation>vid %1 är avvikelsen %2; den ligger bortom gränsen med en sannolikhet på %3 %</translation>
    </message>
    <message>
        <source>Statement of conformity</source>
        <translation>Uttalande om överensstämmelse</translation>
    </message>
    <message>
        <source>Claim</source>
        <translation>Krav</translation>
    </message>
    <message>
        <source>Decision rule</source>
        <translation>Beslutsregel</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultat</translation>
    </message>
    <message>
        <source>Worst frequency</source>
        <translation>Sämsta frekvensen</translation>
    </message>
    <message>
        <source>lower limit %L1</source>
        <translation>undre gräns %L1</translation>
    </message>
    <message>
        <source>edge 5 %: %L1</source>
        <translation>bandgräns 5 %: %L1</translation>
    </message>
    <message>
        <source>edge 10 %: %L1</source>
        <translation>bandgräns 10 %: %L1</translation>
    </message>
    <message>
        <source>edge -3 dB: %L1</source>
        <translation>bandgräns -3 dB: %L1</translation>
    </message>
    <message>
        <source>resonance %L1</source>
        <translation>resonans %L1</translation>
    </message>
    <message>
        <source>upper limit %L1</source>
        <translation>övre gräns %L1</translation>
    </message>
    <message>
        <source>Beside the frequencies asked for, the table always has the limits of the band and, where they are known and lie between these, the model&apos;s band edges and resonance. What stands in these lines was computed at exactly these frequencies, as in all others.</source>
        <translation>Utöver de begärda frekvenserna har tabellen alltid bandets gränser och, där de är kända och ligger mellan dessa, modellens bandgränser och resonans. Det som står på dessa rader är beräknat vid exakt dessa frekvenser, som på alla andra.</translation>
    </message>
    <message>
        <source>Magnitude at the resonance, from the records</source>
        <translation>Belopp vid resonansen, ur registreringarna</translation>
    </message>
    <message>
        <source>withheld (see the frequency response)</source>
        <translation>anges inte (se frekvenssvaret)</translation>
    </message>
    <message>
        <source>no statement: the response was measured from %1 to %2 only</source>
        <translation>inget uttalande: svaret mättes endast från %1 till %2</translation>
    </message>
    <message>
        <source>no statement: at %1 no value with a complete uncertainty is stated</source>
        <translation>inget uttalande: vid %1 anges inget värde med fullständig osäkerhet</translation>
    </message>
    <message>
        <source>no statement: between %1 and %2 the response has no value; a third of an octave is the widest step</source>
        <translation>inget uttalande: mellan %1 och %2 har svaret inget värde; en tredjedels oktav är det längsta steget</translation>
    </message>
    <message>
        <source>no statement: no response over frequency, or its level at low frequency, is known</source>
        <translation>inget uttalande: inget svar över frekvens, eller inte dess nivå vid låg frekvens, är känt</translation>
    </message>
    <message>
        <source>the magnitude of the response lies within ±%1 % of its value at low frequency, from %2 to %3</source>
        <translation>svarets belopp ligger inom ±%1 % av sitt värde vid låg frekvens, från %2 till %3</translation>
    </message>
    <message>
        <source>Judged at %1 frequencies, no two neighbours farther apart than a third of an octave. The deviation is that of the response, as measured without a model, from its value at the onset of the step: what both share, as the pressure step and the gain of the chain, cancels in it and is not part of its uncertainty.</source>
        <translation>Bedömt vid %1 frekvenser, inga två grannar längre ifrån varandra än en tredjedels oktav. Avvikelsen är den hos svaret, som det mättes utan modell, från dess värde vid stegets början: det som båda har gemensamt, som trycksteget och mätkedjans förstärkning, tar ut sig och ingår inte i dess osäkerhet.</translation>
    </message>
    <message>
        <source>Profile of the laboratory</source>
        <translation>Laboratoriets profil</translation>
    </message>
    <message>
        <source>%V1, version %V2 (SHA-256 %V3)</source>
        <translation>%V1, version %V2 (SHA-256 %V3)</translation>
    </message>
    <message>
        <source>Set otherwise than in the profile</source>
        <translation>Satt annorlunda än i profilen</translation>
    </message>
    <message>
        <source>Response of amplifier and converter</source>
        <translation>Förstärkarens och omvandlarens svar</translation>
    </message>
    <message>
        <source>divided out of S(f), file with SHA-256 %1; poles and what follows from them are of sensor and chain together</source>
        <translation>borträknat ur S(f), fil med SHA-256 %1; poler och det som följer av dem gäller givare och kedja tillsammans</translation>
    </message>
    <message>
        <source>divided out of S(f), certificate %V1, file with SHA-256 %V2; poles and what follows from them are of sensor and chain together</source>
        <translation>borträknat ur S(f), kalibreringsbevis %V1, fil med SHA-256 %V2; poler och det som följer av dem gäller givare och kedja tillsammans</translation>
    </message>
    <message>
        <source>The response taken from the data is withheld at %1 of %2 frequencies, from %3 to %4: the response of the chain (chain.source) is not stated there, and nothing is extrapolated.</source>
        <translation>Responsen direkt ur data hålls inne vid %1 av %2 frekvenser, från %3 till %4: kedjans svar (chain.source) är inte angivet där, och inget extrapoleras.</translation>
    </message>
    <message>
        <source>The profile %1 is no profile that this version reads; it needs the schema &quot;%2&quot;.</source>
        <translation>Profilen %1 är ingen profil som denna version läser; den behöver schemat &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>The profile %1 holds &quot;%2&quot;, which is of one calibration; put it into the recipe (docs/recipe.md says what a profile holds).</source>
        <translation>Profilen %1 innehåller &quot;%2&quot;, som gäller en enda kalibrering; lägg det i receptet (docs/recipe.md anger vad en profil innehåller).</translation>
    </message>
    <message>
        <source>The recipe holds the values of the profile &quot;%1&quot;, version %2, and %3 is another one; leave --profile out, or start from a recipe without the key profile.</source>
        <translation>Receptet innehåller värdena ur profilen &quot;%1&quot;, version %2, och %3 är en annan; utelämna --profile, eller utgå från ett recept utan nyckeln profile.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; has the hash %2, but %3.sha256 demands %4: it was changed, or it is another file. Restore it, or state the new hash.</source>
        <translation>Filen &apos;%1&apos; har kontrollsumman %2, men %3.sha256 kräver %4: den har ändrats, eller är en annan fil. Återställ den, eller ange den nya kontrollsumman.</translation>
    </message>
    <message>
        <source>Least U of the laboratory (CMC), below which none is stated</source>
        <translation>Laboratoriets minsta U (CMC), under vilket inget anges</translation>
    </message>
    <message>
        <source>no statement: every judged row is accepted, but between them, at %1, the model deviates by %2 %; ask for rows there (response.frequencies)</source>
        <translation>inget uttalande: varje bedömd rad godtas, men mellan dem, vid %1, avviker modellen med %2 %; begär rader där (response.frequencies)</translation>
    </message>
    <message>
        <source>The profile %1 needs &quot;%2&quot; as a text that is not empty; a certificate says by name and version which profile was used.</source>
        <translation>Profilen %1 behöver &quot;%2&quot; som en text som inte är tom; ett certifikat anger med namn och version vilken profil som användes.</translation>
    </message>
    <message>
        <source>Recipe key uncertainty.cmc holds an entry of &quot;%1&quot; from %2 to %3 Hz; the second must be the larger.</source>
        <translation>Receptnyckeln uncertainty.cmc har en post för &quot;%1&quot; från %2 till %3 Hz; det andra talet måste vara det större.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; of %2.source could not be read; it is looked for from the folder of the recipe, or of the profile that names it. Put it there, or give its whole path.</source>
        <translation>Filen &apos;%1&apos; i %2.source kunde inte läsas; den söks från mappen med receptet, eller med profilen som nämner den. Lägg den där, eller ange hela dess sökväg.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; of chain.source begins with the magnitude %2 at %3 Hz; it needs the ratio to the gain at low frequency, which begins with 1. Divide its magnitudes by that gain, which belongs into the channel&apos;s scale, or begin the table at a lower frequency.</source>
        <translation>Filen &apos;%1&apos; i chain.source börjar med beloppet %2 vid %3 Hz; den behöver kvoten mot förstärkningen vid låg frekvens, som börjar med 1. Dividera beloppen med den förstärkningen, som hör till kanalens skala, eller börja tabellen vid en lägre frekvens.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; of chain.source begins with the phase %2 rad at %3 Hz; it needs one that begins near 0. Take whole turns off, and half a turn into the polarity of the channel; or begin the table at a lower frequency.</source>
        <translation>Filen &apos;%1&apos; i chain.source börjar med fasen %2 rad vid %3 Hz; den behöver en som börjar nära 0. Ta bort hela varv, och lägg ett halvt varv i kanalens polaritet; eller börja tabellen vid en lägre frekvens.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; of chain.source has one row; it needs the frequencies of the response, for nothing is extrapolated.</source>
        <translation>Filen &apos;%1&apos; i chain.source har en rad; den behöver frekvenssvarets frekvenser, för inget extrapoleras.</translation>
    </message>
    <message>
        <source>a phase within half a turn of that of the row before: take the jumps of whole turns out</source>
        <translation>en fas inom ett halvt varv från föregående rads: ta bort hoppen på hela varv</translation>
    </message>
    <message>
        <source>%1 needs two times in seconds, the earlier first: %1 BEGIN,END.</source>
        <translation>%1 behöver två tider i sekunder, den tidigare först: %1 BEGIN,END.</translation>
    </message>
    <message>
        <source>--beyond is %1; it needs a pressure of at least 0, in Pa.</source>
        <translation>--beyond är %1; det behöver ett tryck på minst 0, i Pa.</translation>
    </message>
    <message>
        <source>%1 cannot be read as results of a calibration; give the folder or the results.json that dyncal run wrote.</source>
        <translation>%1 kan inte läsas som resultat av en kalibrering; ange mappen eller den results.json som dyncal run skrev.</translation>
    </message>
    <message>
        <source>Shot %1 has no channel of the DUT; name it (import.channels of a recipe).</source>
        <translation>Skott %1 har ingen kanal för DUT; namnge den (import.channels i ett recept).</translation>
    </message>
    <message>
        <source>%1 is no results.json of a calibration: its schema is &quot;%2&quot; instead of &quot;%3&quot;; give the folder or the results.json that dyncal run wrote.</source>
        <translation>%1 är ingen results.json från en kalibrering: dess schema är ”%2” i stället för ”%3”; ange mappen eller den results.json som dyncal run skrev.</translation>
    </message>
    <message>
        <source>The response of these results has the unit &quot;%1&quot; and not one per Pa, so it gives no pressure; calibrate with a known pressure step (response.reference).</source>
        <translation>Svaret i dessa resultat har enheten ”%1” och inte en per Pa, så det ger inget tryck; kalibrera med ett känt trycksteg (response.reference).</translation>
    </message>
    <message>
        <source>These results were made with input.treatment &quot;%1&quot;, whose model is not the sensor&apos;s response to pressure; calibrate with &quot;step-deflated&quot;.</source>
        <translation>Dessa resultat gjordes med input.treatment ”%1”, vars modell inte är givarens svar på tryck; kalibrera med ”step-deflated”.</translation>
    </message>
    <message>
        <source>The recording has samples that are no numbers in the stretch to be corrected; choose another stretch (--window).</source>
        <translation>Inspelningen har sampel som inte är tal i den sträcka som ska korrigeras; välj en annan sträcka (--window).</translation>
    </message>
    <message>
        <source>The stretch to be corrected has %1 samples, but this filter needs %2 at %3; take a longer one (--window) or a wider transition (--edge).</source>
        <translation>Sträckan som ska korrigeras har %1 sampel, men detta filter behöver %2 vid %3; ta en längre (--window) eller en bredare övergång (--edge).</translation>
    </message>
    <message>
        <source>The inverse of the response up to %1 does not die away within %2 samples at %3; ask for another band (--band, --edge).</source>
        <translation>Svarets invers upp till %1 klingar inte av inom %2 sampel vid %3; begär ett annat band (--band, --edge).</translation>
    </message>
    <message>
        <source>The delay %1 (--delay) is not possible for this band: the filter needs at least %2 and takes at most %3.</source>
        <translation>Fördröjningen %1 (--delay) är inte möjlig för detta band: filtret behöver minst %2 och tar högst %3.</translation>
    </message>
    <message>
        <source>A band up to %1 (--band) is not possible: the response was measured from %2 to %3; ask for a band that ends there.</source>
        <translation>Ett band upp till %1 (--band) är inte möjligt: svaret mättes från %2 till %3; begär ett band som slutar där.</translation>
    </message>
    <message>
        <source>The edge %1 (--edge) must lie above the end %2 of the band.</source>
        <translation>Kanten %1 (--edge) måste ligga över bandets slut %2.</translation>
    </message>
    <message>
        <source>The correction would reach to %1, but at %2 a recording holds only what lies below %3; ask for a narrower band (--band, --edge) or take a faster recording.</source>
        <translation>Korrektionen skulle nå till %1, men vid %2 innehåller en inspelning bara det som ligger under %3; begär ett smalare band (--band, --edge) eller ta en snabbare inspelning.</translation>
    </message>
    <message>
        <source>The correction would reach to %1, but the response is known up to %2 only; ask for a narrower band (--band, --edge).</source>
        <translation>Korrektionen skulle nå till %1, men svaret är känt bara upp till %2; begär ett smalare band (--band, --edge).</translation>
    </message>
    <message>
        <source>At %1 the sensor answers %2 times weaker than at the lowest frequency, and its noise would be amplified as much (at most %3 times); ask for a narrower band (--band).</source>
        <translation>Vid %1 svarar givaren %2 gånger svagare än vid den lägsta frekvensen, och bruset skulle förstärkas lika mycket (högst %3 gånger); begär ett smalare band (--band).</translation>
    </message>
    <message>
        <source>The recording has no sample rate; state it (import.sample_rate_hz of a recipe).</source>
        <translation>Inspelningen har ingen samplingsfrekvens; ange den (import.sample_rate_hz i ett recept).</translation>
    </message>
    <message>
        <source>The measured response departs from the shape of its model, most at %1 (%2 times its uncertainty), so that nothing can be said between the measured frequencies; calibrate with another order, or ask for a narrower band (--band, --edge).</source>
        <translation>Det uppmätta svaret avviker från modellens form, mest vid %1 (%2 gånger sin osäkerhet), så att ingenting kan sägas mellan de uppmätta frekvenserna; kalibrera med en annan ordning, eller begär ett smalare band (--band, --edge).</translation>
    </message>
    <message>
        <source>Shot %1: channel %2 is in &quot;%3&quot;, but the calibration is of a sensor in &quot;%4&quot;; state the unit and scale of the recording (section import of a recipe).</source>
        <translation>Skott %1: kanal %2 är i ”%3”, men kalibreringen gäller en givare i ”%4”; ange inspelningens enhet och skala (avsnittet import i ett recept).</translation>
    </message>
    <message>
        <source>Shot %1 was recorded at %2, the filter is for %3; correct recordings of different rates one after the other.</source>
        <translation>Skott %1 spelades in med %2, filtret är för %3; korrigera inspelningar med olika samplingsfrekvens en i taget.</translation>
    </message>
    <message>
        <source>Shot %1: no start of a pressure was found in channel %2, so its level and noise without pressure are not known; state a stretch without pressure (--quiet).</source>
        <translation>Skott %1: ingen tryckstart hittades i kanal %2, så dess nivå och brus utan tryck är inte kända; ange en sträcka utan tryck (--quiet).</translation>
    </message>
    <message>
        <source>Shot %1: channel %2 has %3 samples without pressure, but at least %4 are needed to know its level and noise; state a longer stretch (--quiet).</source>
        <translation>Skott %1: kanal %2 har %3 sampel utan tryck, men minst %4 behövs för att känna dess nivå och brus; ange en längre sträcka (--quiet).</translation>
    </message>
    <message>
        <source>Shot %1: channel %2 has samples without pressure that are no numbers; state another stretch (--quiet).</source>
        <translation>Skott %1: kanal %2 har sampel utan tryck som inte är tal; ange en annan sträcka (--quiet).</translation>
    </message>
    <message>
        <source>The window %1 to %2 lies where the filter would need samples beyond the ends of the recording; choose another (--window).</source>
        <translation>Fönstret %1 till %2 ligger där filtret skulle behöva sampel bortom inspelningens ändar; välj ett annat (--window).</translation>
    </message>
    <message>
        <source>Shot %1: the samples of channel %2 cannot be read any more; leave the recording alone meanwhile.</source>
        <translation>Skott %1: samplen i kanal %2 kan inte läsas längre; lämna inspelningen i fred under tiden.</translation>
    </message>
    <message>
        <source>The results are not whole: their model has not as many poles as states; repeat the calibration.</source>
        <translation>Resultaten är inte hela: deras modell har inte lika många poler som tillstånd; upprepa kalibreringen.</translation>
    </message>
    <message>
        <source>The model of these results is not stable (a pole does not decay), so nothing can be said between the measured frequencies; calibrate with another order.</source>
        <translation>Modellen i dessa resultat är inte stabil (en pol avklingar inte), så ingenting kan sägas mellan de uppmätta frekvenserna; kalibrera med en annan ordning.</translation>
    </message>
    <message>
        <source>The model of these results has a pole at half its rate, which is no sensor&apos;s; calibrate with another order.</source>
        <translation>Modellen i dessa resultat har en pol vid halva sin samplingsfrekvens, vilken inte är någon givares; kalibrera med en annan ordning.</translation>
    </message>
    <message>
        <source>The model of these results has the same pole twice; calibrate with another order.</source>
        <translation>Modellen i dessa resultat har samma pol två gånger; kalibrera med en annan ordning.</translation>
    </message>
    <message>
        <source>The results have no model that carries the response between the measured frequencies; calibrate with another order.</source>
        <translation>Resultaten har ingen modell som bär svaret mellan de uppmätta frekvenserna; kalibrera med en annan ordning.</translation>
    </message>
    <message>
        <source>The poles of these results have no uncertainty (the model was not refined), so what lies between the measured frequencies is not known; calibrate with realization.refine.</source>
        <translation>Polerna i dessa resultat har ingen osäkerhet (modellen förfinades inte), så det som ligger mellan de uppmätta frekvenserna är inte känt; kalibrera med realization.refine.</translation>
    </message>
    <message>
        <source>The results have no budget of the single frequencies (they are left out of more than 200); calibrate at fewer of them (response.frequencies_hz).</source>
        <translation>Resultaten har ingen budget för de enskilda frekvenserna (den utelämnas vid fler än 200); kalibrera vid färre (response.frequencies_hz).</translation>
    </message>
    <message>
        <source>At %1 the lines of the budget do not make the stated uncertainty: the results contradict themselves, or inputs are correlated (uncertainty.correlations), which a correction cannot take; repeat the calibration without.</source>
        <translation>Vid %1 ger budgetens rader inte den angivna osäkerheten: resultaten motsäger sig själva, eller så är storheter korrelerade (uncertainty.correlations), vilket en korrektion inte kan ta hänsyn till; upprepa kalibreringen utan.</translation>
    </message>
    <message>
        <source>The results contradict themselves: the lists of the response differ in length, or its frequencies do not ascend; repeat the calibration.</source>
        <translation>Resultaten motsäger sig själva: svarets listor är olika långa, eller dess frekvenser stiger inte; upprepa kalibreringen.</translation>
    </message>
    <message>
        <source>The results have no frequency with magnitude, phase and their complete uncertainties, so no correction follows from them; the findings of the calibration say what is missing (a known pressure step, a refined model).</source>
        <translation>Resultaten har ingen frekvens med belopp, fas och deras fullständiga osäkerheter, så ingen korrektion följer av dem; kalibreringens anmärkningar säger vad som saknas (ett känt trycksteg, en förfinad modell).</translation>
    </message>
    <message>
        <source>The file of %1 states a response from %2 to %3, the records have one from %4 to %5: nothing in common, so no S(f) can be stated. Give a file that covers the band.</source>
        <translation>Filen för %1 anger ett svar från %2 till %3, registreringarna har ett från %4 till %5: inget gemensamt, så inget S(f) kan anges. Ange en fil som täcker bandet.</translation>
    </message>
    <message>
        <source>The file of %1 has no row between %2 and %3: the response rests on a straight line there, and what that misses is in no uncertainty. Have the rows between calibrated, or give the reason why there is nothing between them.</source>
        <translation>Filen för %1 har ingen rad mellan %2 och %3: frekvenssvaret vilar där på en rät linje, och vad den missar ingår inte i någon osäkerhet. Låt kalibrera raderna däremellan, eller ange skälet till att inget finns mellan dem.</translation>
    </message>
    <message>
        <source>The correlation of &apos;%1&apos; with &apos;%2&apos; in uncertainty.correlations is used for nothing: it needs two quantities whose u stands in uncertainty.budget.</source>
        <translation>Korrelationen mellan &apos;%1&apos; och &apos;%2&apos; i uncertainty.correlations används inte till något: den behöver två storheter vars u står i uncertainty.budget.</translation>
    </message>
    <message>
        <source>Recipe key uncertainty.correlations holds &quot;%1&quot; with &quot;%2&quot; twice; leave one.</source>
        <translation>Receptnyckeln uncertainty.correlations innehåller &quot;%1&quot; med &quot;%2&quot; två gånger; behåll en.</translation>
    </message>
    <message>
        <source>The coefficients of recipe key uncertainty.correlations contradict each other (their matrix has the eigenvalue %1, it needs none below 0): what goes along with one quantity goes along with those that this one goes along with. Correct them.</source>
        <translation>Koefficienterna i receptnyckeln uncertainty.correlations motsäger varandra (deras matris har egenvärdet %1, inget får vara under 0): det som följer en storhet följer också dem som denna följer. Rätta dem.</translation>
    </message>
    <message>
        <source>The file %1 cannot be read: %2.</source>
        <translation>Filen %1 kan inte läsas: %2.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; of %2.source cannot be used. %M1</source>
        <translation>Filen &apos;%1&apos; i %2.source kan inte användas. %M1</translation>
    </message>
    <message>
        <source>The table has a column &apos;%1&apos;; it may have frequency_hz, magnitude, u_magnitude, phase_rad, u_phase_rad and dof.</source>
        <translation>Tabellen har en kolumn &apos;%1&apos;; den får ha frequency_hz, magnitude, u_magnitude, phase_rad, u_phase_rad och dof.</translation>
    </message>
    <message>
        <source>The table has no column &apos;%1&apos;; its first line must name the columns.</source>
        <translation>Tabellen saknar kolumnen &apos;%1&apos;; dess första rad måste namnge kolumnerna.</translation>
    </message>
    <message>
        <source>Line %1 of the table has &apos;%2&apos; for %3, which is no number with a decimal point.</source>
        <translation>Rad %1 i tabellen har &apos;%2&apos; för %3, vilket inte är ett tal med decimalpunkt.</translation>
    </message>
    <message>
        <source>The certificate has %1 lists over frequency; name the one that is meant by its id in quantity_id.</source>
        <translation>Certifikatet har %1 listor över frekvens; ange den avsedda genom dess id i quantity_id.</translation>
    </message>
    <message>
        <source>The certificate has no list with the id &apos;%1&apos; of quantity_id, or several.</source>
        <translation>Certifikatet har ingen lista med id &apos;%1&apos; ur quantity_id, eller flera.</translation>
    </message>
    <message>
        <source>The list of the certificate needs frequencies, magnitudes in %1 and perhaps phases, as many of each, with expanded uncertainties and their coverage factors.</source>
        <translation>Certifikatets lista behöver frekvenser, belopp i %1 och eventuellt faser, lika många av varje, med utvidgade osäkerheter och deras täckningsfaktorer.</translation>
    </message>
    <message>
        <source>The table has no rows.</source>
        <translation>Tabellen har inga rader.</translation>
    </message>
    <message>
        <source>Row %1 of the table, at %2 Hz, needs %3.</source>
        <translation>Rad %1 i tabellen, vid %2 Hz, behöver %3.</translation>
    </message>
    <message>
        <source>an oscillation below 1 % of the step decides it, which may be the mount&apos;s</source>
        <translation>en svängning under 1 % av steget avgör det, och den kan vara monteringens</translation>
    </message>
    <message>
        <source>The plan was made for other versions of the methods than this program has (first for %1); make the plan anew, then what changed is computed again.</source>
        <translation>Planen gjordes för andra versioner av metoderna än detta programs (först för %1); gör om planen, så räknas det som ändrats på nytt.</translation>
    </message>
    <message>
        <source>The process that computed it was ended by signal %1: it crashed, or the system ended it for want of memory.</source>
        <translation>Processen som räknade avslutades av signal %1: den kraschade, eller så avslutade systemet den av minnesbrist.</translation>
    </message>
    <message>
        <source>The system could start no process for a sensor; close other programs or raise the limit of processes. What was computed is kept.</source>
        <translation>Systemet kunde inte starta någon process för en givare; stäng andra program eller höj gränsen för processer. Det som räknats är kvar.</translation>
    </message>
    <message>
        <source>The results were not as they were written and are now in %1; they are computed anew.</source>
        <translation>Resultaten var inte längre som de skrevs och finns nu i %1; de räknas på nytt.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be entered; check that you may.</source>
        <translation>Mappen %1 kan inte öppnas; kontrollera att du får det.</translation>
    </message>
    <message>
        <source>Its process ended without an answer (%1); run the batch again.</source>
        <translation>Dess process slutade utan svar (%1); kör satsen igen.</translation>
    </message>
    <message>
        <source>%1 of %2 sensors are missing, the first is %3; run the batch, or merge what there is with --partial.</source>
        <translation>%1 av %2 givare saknas, den första är %3; kör satsen, eller sammanställ det som finns med --partial.</translation>
    </message>
    <message>
        <source>%1 is no sensor of a batch (schema %2 with id, source, inputs, hashes and an output below the plan); make the plan anew with dyncal batch plan.</source>
        <translation>%1 är ingen givare i en sats (schema %2 med id, source, inputs, hashvärden och en output under planen); gör om planen med dyncal batch plan.</translation>
    </message>
    <message>
        <source>%1 names &quot;%2&quot;, as an earlier line does; one of the two has to go, or make the plan anew.</source>
        <translation>%1 nämner &quot;%2&quot;, som en tidigare rad gör; ta bort en av dem eller gör om planen.</translation>
    </message>
    <message>
        <source>The plan %1 cannot be read; check the name, or make it with dyncal batch plan.</source>
        <translation>Planen %1 kan inte läsas; kontrollera namnet, eller gör den med dyncal batch plan.</translation>
    </message>
    <message>
        <source>%1 cannot be read; check that you may read it.</source>
        <translation>%1 kan inte läsas; kontrollera att du får läsa den.</translation>
    </message>
    <message>
        <source>The plan %1 would lie below %2, where the recordings are, and the results with it; give the plan a place outside.</source>
        <translation>Planen %1 skulle ligga under %2, där mätfilerna finns, och resultaten med den; ge planen en plats utanför.</translation>
    </message>
    <message>
        <source>There is no recording below %1; readable are the files that dyncal info reads, in a folder for each sensor or, with --each-file, one file for each.</source>
        <translation>Det finns ingen mätfil under %1; läsbara är de filer som dyncal info läser, i en mapp för varje givare eller, med --each-file, en fil för varje.</translation>
    </message>
    <message>
        <source>--for is &quot;%1&quot;; it needs slurm, parallel or make.</source>
        <translation>--for är &quot;%1&quot;; det behöver slurm, parallel eller make.</translation>
    </message>
    <message>
        <source>The name %1 holds a line break, which a script cannot pass on; rename it.</source>
        <translation>Namnet %1 innehåller en radbrytning, som ett skript inte kan föra vidare; byt namn.</translation>
    </message>
    <message>
        <source>--shard is &quot;%1&quot;; it needs K/N, whole numbers with K from 1 to N and N at most 1000000, for example 3/7.</source>
        <translation>--shard är &quot;%1&quot;; det behöver K/N, heltal med K från 1 till N och N högst 1000000, till exempel 3/7.</translation>
    </message>
    <message>
        <source>%1 is not as it was when the batch was planned; make the plan anew (dyncal batch plan), then only what changed is computed again.</source>
        <translation>%1 är inte som när satsen planerades; gör om planen (dyncal batch plan), så räknas bara det som ändrats på nytt.</translation>
    </message>
    <message>
        <source>The folder holds files but no recording; readable are: %1. Put recordings there, or move it out of what is planned.</source>
        <translation>Mappen innehåller filer men ingen mätfil; läsbara är: %1. Lägg mätfiler där, eller flytta den från det som planeras.</translation>
    </message>
    <message>
        <source>This is a link to a folder, which is not followed; plan the folder that it leads to.</source>
        <translation>Detta är en länk till en mapp, som inte följs; planera mappen som den leder till.</translation>
    </message>
    <message>
        <source>Recordings lie directly in the folder that is planned and belong to no sensor; put them into a folder of their own, or give --each-file.</source>
        <translation>Mätfiler ligger direkt i mappen som planeras och hör inte till någon givare; lägg dem i en egen mapp, eller ange --each-file.</translation>
    </message>
    <message>
        <source>The name is no valid UTF-8, so no plan can hold it; rename it.</source>
        <translation>Namnet är inte giltig UTF-8, så ingen plan kan innehålla det; byt namn.</translation>
    </message>
    <message>
        <source>static</source>
        <translation>statiskt</translation>
    </message>
    <message>
        <source>%V1, certificate %V2</source>
        <translation>%V1, bevis %V2</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>inte jämfört</translation>
    </message>
    <message>
        <source>agrees, joined</source>
        <translation>stämmer, förenat</translation>
    </message>
    <message>
        <source>differs, not joined</source>
        <translation>avviker, inte förenat</translation>
    </message>
    <message>
        <source>Values of other calibrations of the item, beside those of this one</source>
        <translation>Värden från andra kalibreringar av objektet, bredvid denna kalibrerings</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrering</translation>
    </message>
    <message>
        <source>Its value</source>
        <translation>Dess värde</translation>
    </message>
    <message>
        <source>This calibration</source>
        <translation>Denna kalibrering</translation>
    </message>
    <message>
        <source>En</source>
        <translation>En</translation>
    </message>
    <message>
        <source>static: %V1</source>
        <translation>statiskt: %V1</translation>
    </message>
    <message>
        <source>S(f) is not stated per pressure</source>
        <translation>S(f) anges inte per tryck</translation>
    </message>
    <message>
        <source>its unit %1 is none of %2, in which S(f) is</source>
        <translation>dess enhet %1 är ingen enhet av slaget %2, som S(f) har</translation>
    </message>
    <message>
        <source>%1 is above the band, which ends at %2</source>
        <translation>%1 ligger över bandet, som slutar vid %2</translation>
    </message>
    <message>
        <source>the sensitivity has no complete uncertainty</source>
        <translation>känsligheten har ingen fullständig osäkerhet</translation>
    </message>
    <message>
        <source>S(f) is withheld at %1</source>
        <translation>S(f) anges inte vid %1</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 vid %2</translation>
    </message>
    <message>
        <source>%M1 states %1, this calibration %2: they differ by %3 %, En = %4, more than both expanded uncertainties, and are not joined to one curve. Check unit, range, gas and mounting of either; the one that is wrong is not known.</source>
        <translation>%M1 anger %1, denna kalibrering %2: de skiljer sig med %3 %, En = %4, mer än båda utvidgade osäkerheterna, och förenas inte till en kurva. Kontrollera enhet, område, gas och montering för båda; vilken som är fel är inte känt.</translation>
    </message>
    <message>
        <source>%M1 of response.known cannot be compared with this calibration: %M2. Correct it, or leave it out.</source>
        <translation>%M1 i response.known kan inte jämföras med denna kalibrering: %M2. Rätta det, eller utelämna det.</translation>
    </message>
    <message>
        <source>The recordings of the results in %1 changed while they were read; repeat it when nothing writes to them.</source>
        <translation>Inspelningarna till resultaten i %1 ändrades medan de lästes; upprepa när inget skriver till dem.</translation>
    </message>
    <message>
        <source>%1 cannot be read, or is larger than 256 MiB; check that it is the file of a run and that you may read it.</source>
        <translation>%1 kan inte läsas eller är större än 256 MiB; kontrollera att det är en körnings fil och att du får läsa den.</translation>
    </message>
    <message>
        <source>results.json is not the file that the run wrote (written.json lists another hash); what is compared is what it says now.</source>
        <translation>results.json är inte den fil som körningen skrev (written.json anger en annan hash); det som jämförs är vad den säger nu.</translation>
    </message>
    <message>
        <source>recipe.json is not the recipe that the results were made with; the one that results.json holds is used.</source>
        <translation>recipe.json är inte det recept som resultaten gjordes med; det som finns i results.json används.</translation>
    </message>
    <message>
        <source>The recipe is from before %1 of today&apos;s keys, for which the defaults count: %2.</source>
        <translation>Receptet är äldre än %1 av dagens nycklar, för vilka standardvärdena gäller: %2.</translation>
    </message>
    <message>
        <source>The recipe that %1 holds cannot be used: %2</source>
        <translation>Receptet i %1 kan inte användas: %2</translation>
    </message>
    <message>
        <source>%1 states no SHA-256 of its recording %2, so that cannot be known again; repeat the run from the recording.</source>
        <translation>%1 anger ingen SHA-256 för sin inspelning %2, så den kan inte kännas igen; upprepa körningen från inspelningen.</translation>
    </message>
    <message>
        <source>%1 names no recordings (inputs), so there is nothing to compute it again from.</source>
        <translation>%1 nämner inga inspelningar (inputs), så det finns inget att räkna om den från.</translation>
    </message>
    <message>
        <source>%1 is no folder; give the folder that dyncal run or dyncal batch wrote, or one above it.</source>
        <translation>%1 är ingen mapp; ange mappen som dyncal run eller dyncal batch skrev, eller en ovanför.</translation>
    </message>
    <message>
        <source>There is no results.json in %1 nor below it; give the folder that dyncal run or dyncal batch wrote, or one above it.</source>
        <translation>Det finns ingen results.json i %1 eller under den; ange mappen som dyncal run eller dyncal batch skrev, eller en ovanför.</translation>
    </message>
    <message>
        <source>The recording %1 is now called %2 and cannot be read under its old name, because the folder for temporary files cannot be written to (%3); give it its old name, or set TMPDIR.</source>
        <translation>Inspelningen %1 heter nu %2 och kan inte läsas under sitt gamla namn, eftersom mappen för tillfälliga filer inte går att skriva till (%3); ge den dess gamla namn eller sätt TMPDIR.</translation>
    </message>
    <message>
        <source>%1 is no folder of recordings; give one with --recordings, or leave it out.</source>
        <translation>%1 är ingen mapp med inspelningar; ange en med --recordings eller utelämna det.</translation>
    </message>
    <message>
        <source>The recording %1 of the results in %2 was changed since: its SHA-256 is %3 and not %4; give the folder that holds it as it was with --recordings.</source>
        <translation>Inspelningen %1 till resultaten i %2 har ändrats sedan dess: dess SHA-256 är %3 och inte %4; ange med --recordings mappen där den finns som den var.</translation>
    </message>
    <message>
        <source>The recording %1 (SHA-256 %3) of the results in %2 was not found there nor beside; give the folder that holds it, under whatever name, with --recordings.</source>
        <translation>Inspelningen %1 (SHA-256 %3) till resultaten i %2 hittades varken där eller bredvid; ange med --recordings mappen där den finns, under vilket namn som helst.</translation>
    </message>
    <message>
        <source>%1 was written by a later version: its schema is &quot;%2&quot;, and this one reads &quot;%3&quot;; use that version of Dyncal.</source>
        <translation>%1 skrevs av en senare version: dess schema är &quot;%2&quot;, och denna läser &quot;%3&quot;; använd den versionen av Dyncal.</translation>
    </message>
    <message>
        <source>The run in %1 cannot be computed again: %2</source>
        <translation>Körningen i %1 kan inte räknas om: %2</translation>
    </message>
    <message>
        <source>The file %1 (SHA-256 %2) that the recipe of the results in %3 names is not there as it was, and no copy of it is in sources/; put it where the recipe says, seen from that folder.</source>
        <translation>Filen %1 (SHA-256 %2) som receptet till resultaten i %3 nämner finns inte där som den var, och ingen kopia av den finns i sources/; lägg den där receptet säger, sett från den mappen.</translation>
    </message>
    <message>
        <source>The documents were not drawn because the system or another program ended the helper process that draws them, most likely for want of memory, and nothing was written; close other programs and try again.</source>
        <translation>Dokumenten ritades inte eftersom systemet eller ett annat program avslutade hjälpprocessen som ritar dem, troligen av brist på minne, och inget skrevs; stäng andra program och försök igen.</translation>
    </message>
    <message>
        <source>The documents could not be drawn, most likely because there is not enough memory, and nothing was written; close other programs or raise the memory limit.</source>
        <translation>Dokumenten kunde inte ritas, troligen för att minnet inte räcker, och inget skrevs; stäng andra program eller höj minnesgränsen.</translation>
    </message>
    <message>
        <source>Cramer-Rao bound of five parameters in white noise</source>
        <translation>Cramér-Raos gräns för fem parametrar i vitt brus</translation>
    </message>
    <message>
        <source>FIT of order 2, %</source>
        <translation>FIT för ordning 2, %</translation>
    </message>
    <message>
        <source>what noise of that power leaves</source>
        <translation>vad brus av den effekten lämnar</translation>
    </message>
    <message>
        <source>suggested order</source>
        <translation>föreslagen ordning</translation>
    </message>
    <message>
        <source>by construction</source>
        <translation>genom konstruktion</translation>
    </message>
    <message>
        <source>u of the natural frequency, relative</source>
        <translation>egenfrekvensens u, relativt</translation>
    </message>
    <message>
        <source>u of the damping ratio</source>
        <translation>dämpningsförhållandets u</translation>
    </message>
    <message>
        <source>filter times sensor is 1 within the band</source>
        <translation>filter gånger givare är 1 inom bandet</translation>
    </message>
    <message>
        <source>JCGM 100, 7.2.6: two digits of u</source>
        <translation>JCGM 100, 7.2.6: två siffror av u</translation>
    </message>
    <message>
        <source>magnitude behind the correction, 100 kHz</source>
        <translation>belopp efter korrektionen, 100 kHz</translation>
    </message>
    <message>
        <source>phase behind the correction, rad</source>
        <translation>fas efter korrektionen, rad</translation>
    </message>
    <message>
        <source>gain of the correction at 0 Hz</source>
        <translation>korrektionens förstärkning vid 0 Hz</translation>
    </message>
    <message>
        <source>2330149 Hz as printed with u, MHz</source>
        <translation>2330149 Hz som det trycks med u, MHz</translation>
    </message>
    <message>
        <source>u = 1234 Hz as printed, MHz</source>
        <translation>u = 1234 Hz som det trycks, MHz</translation>
    </message>
    <message>
        <source>division by hand</source>
        <translation>division för hand</translation>
    </message>
    <message>
        <source>magnitude without the chain</source>
        <translation>belopp utan kedjan</translation>
    </message>
    <message>
        <source>phase without the chain, rad</source>
        <translation>fas utan kedjan, rad</translation>
    </message>
    <message>
        <source>u of the chain in the magnitude</source>
        <translation>kedjans u i beloppet</translation>
    </message>
    <message>
        <source>sensitivity between two rows of a table</source>
        <translation>känslighet mellan två rader i en tabell</translation>
    </message>
    <message>
        <source>straight line over log f</source>
        <translation>rät linje över log f</translation>
    </message>
    <message>
        <source>sensitivity by a model, at its f0</source>
        <translation>känslighet enligt en modell, vid dess f0</translation>
    </message>
    <message>
        <source>u of that sensitivity</source>
        <translation>den känslighetens u</translation>
    </message>
    <message>
        <source>decomposition by another program, f0 = 318 kHz, zeta = 0.02, 1 MHz</source>
        <translation>uppdelning med ett annat program, f0 = 318 kHz, zeta = 0.02, 1 MHz</translation>
    </message>
    <message>
        <source>exp(s/rate) of the sensor&apos;s poles</source>
        <translation>exp(s/takt) av givarens poler</translation>
    </message>
    <message>
        <source>second singular value over the first, differences</source>
        <translation>andra singulärvärdet genom det första, differenser</translation>
    </message>
    <message>
        <source>second singular value over the first, step as impulse</source>
        <translation>andra singulärvärdet genom det första, steg som impuls</translation>
    </message>
    <message>
        <source>third singular value over the first, step deflated</source>
        <translation>tredje singulärvärdet genom det första, steget borttaget</translation>
    </message>
    <message>
        <source>a sensor of order 2 has two</source>
        <translation>en givare av ordning 2 har två</translation>
    </message>
    <message>
        <source>real part of the pole</source>
        <translation>polens realdel</translation>
    </message>
    <message>
        <source>imaginary part of the pole</source>
        <translation>polens imaginärdel</translation>
    </message>
    <message>
        <source>second pole of the thesis&apos;s own way, order 2</source>
        <translation>andra polen enligt avhandlingens eget sätt, ordning 2</translation>
    </message>
    <message>
        <source>pole of a record that ends while it rings, error</source>
        <translation>pol ur en registrering som slutar medan den svänger, fel</translation>
    </message>
    <message>
        <source>step by the thesis&apos;s model of order 3, largest error</source>
        <translation>steg enligt avhandlingens modell av ordning 3, största felet</translation>
    </message>
    <message>
        <source>second-order step in closed form, zeta = 0.05</source>
        <translation>andra ordningens steg i sluten form, zeta = 0.05</translation>
    </message>
    <message>
        <source>natural frequency, Hz</source>
        <translation>egenfrekvens, Hz</translation>
    </message>
    <message>
        <source>damping ratio</source>
        <translation>dämpningsförhållande</translation>
    </message>
    <message>
        <source>onset, in samples from the first</source>
        <translation>början, i sampel från det första</translation>
    </message>
    <message>
        <source>plateau gain</source>
        <translation>platåförstärkning</translation>
    </message>
    <message>
        <source>value of one count by polynomial, gain and polarity</source>
        <translation>en räknings värde med polynom, förstärkning och polaritet</translation>
    </message>
    <message>
        <source>saturated shots found, of one</source>
        <translation>funna mättade skott, av ett</translation>
    </message>
    <message>
        <source>sample at which a step begins</source>
        <translation>sampel där ett steg börjar</translation>
    </message>
    <message>
        <source>where a ramp crosses a level, in samples</source>
        <translation>var en ramp korsar en nivå, i sampel</translation>
    </message>
    <message>
        <source>samples that a capture loses, written and read back</source>
        <translation>sampel som en registrering förlorar, skriven och läst igen</translation>
    </message>
    <message>
        <source>value in a table with decimal commas</source>
        <translation>värde i en tabell med decimalkomma</translation>
    </message>
    <message>
        <source>wrong digits of the SHA-256 of &quot;abc&quot;</source>
        <translation>felaktiga siffror i SHA-256 av &quot;abc&quot;</translation>
    </message>
    <message>
        <source>FIPS 180-4, example</source>
        <translation>FIPS 180-4, exempel</translation>
    </message>
    <message>
        <source>second order in closed form, f0 = 300 kHz, 10 MHz; aliasing below 1e-6</source>
        <translation>andra ordningen i sluten form, f0 = 300 kHz, 10 MHz; vikning under 1e-6</translation>
    </message>
    <message>
        <source>magnitude from a step over the true one, 100 kHz</source>
        <translation>belopp ur ett steg genom det sanna, 100 kHz</translation>
    </message>
    <message>
        <source>phase from a step less the true one, rad</source>
        <translation>fas ur ett steg minus den sanna, rad</translation>
    </message>
    <message>
        <source>largest relative difference from Gans and Nahman</source>
        <translation>största relativa skillnad från Gans och Nahman</translation>
    </message>
    <message>
        <source>Gans and Nahman 1982, exact</source>
        <translation>Gans och Nahman 1982, exakt</translation>
    </message>
    <message>
        <source>attenuation by a front of 1 us at 250 kHz</source>
        <translation>dämpning av en front på 1 us vid 250 kHz</translation>
    </message>
    <message>
        <source>sin x / x</source>
        <translation>sin(x) / x</translation>
    </message>
    <message>
        <source>second order in closed form</source>
        <translation>andra ordningen i sluten form</translation>
    </message>
    <message>
        <source>roots of the second-order response, zeta 0.2 and 0.7, six digits</source>
        <translation>rötter av andra ordningens svar, zeta 0.2 och 0.7, sex siffror</translation>
    </message>
    <message>
        <source>magnitude of the model at f0</source>
        <translation>modellens belopp vid f0</translation>
    </message>
    <message>
        <source>phase of the model at f0, rad</source>
        <translation>modellens fas vid f0, rad</translation>
    </message>
    <message>
        <source>rise time of the model, times f0</source>
        <translation>modellens stigtid, gånger f0</translation>
    </message>
    <message>
        <source>overshoot of the model, %</source>
        <translation>modellens översväng, %</translation>
    </message>
    <message>
        <source>settling time of the model, times f0</source>
        <translation>modellens insvängningstid, gånger f0</translation>
    </message>
    <message>
        <source>band within 5 %, over f0</source>
        <translation>band inom 5 %, genom f0</translation>
    </message>
    <message>
        <source>band within 10 %, over f0</source>
        <translation>band inom 10 %, genom f0</translation>
    </message>
    <message>
        <source>band to -3 dB, over f0</source>
        <translation>band till -3 dB, genom f0</translation>
    </message>
    <message>
        <source>Rankine-Hugoniot relations in exact fractions, M = 2, gamma = 7/5</source>
        <translation>Rankine-Hugoniots samband i exakta bråk, M = 2, gamma = 7/5</translation>
    </message>
    <message>
        <source>density ratio of the incident shock</source>
        <translation>den infallande stötvågens densitetskvot</translation>
    </message>
    <message>
        <source>pressure ratio p5/p1</source>
        <translation>tryckkvoten p5/p1</translation>
    </message>
    <message>
        <source>temperature ratio T5/T1</source>
        <translation>temperaturkvoten T5/T1</translation>
    </message>
    <message>
        <source>Mach number of the reflected shock</source>
        <translation>den reflekterade stötvågens machtal</translation>
    </message>
    <message>
        <source>driver pressure p4/p1</source>
        <translation>drivtrycket p4/p1</translation>
    </message>
    <message>
        <source>Mach number from p2/p1 = 9/2</source>
        <translation>machtal ur p2/p1 = 9/2</translation>
    </message>
    <message>
        <source>p5/p1 by the conservation laws, cp(T) constant</source>
        <translation>p5/p1 ur bevarandelagarna, cp(T) konstant</translation>
    </message>
    <message>
        <source>step over p1, velocity typed</source>
        <translation>steg genom p1, hastigheten inskriven</translation>
    </message>
    <message>
        <source>table 4.2 of the thesis, recomputed to nine digits</source>
        <translation>avhandlingens tabell 4.2, räknad om till nio siffror</translation>
    </message>
    <message>
        <source>p5 of the thesis&apos;s shot, Pa</source>
        <translation>p5 för avhandlingens skott, Pa</translation>
    </message>
    <message>
        <source>T5 of the thesis&apos;s shot, K</source>
        <translation>T5 för avhandlingens skott, K</translation>
    </message>
    <message>
        <source>p4 of the thesis&apos;s shot, Pa</source>
        <translation>p4 för avhandlingens skott, Pa</translation>
    </message>
    <message>
        <source>plateau of the thesis&apos;s tube, s</source>
        <translation>platå i avhandlingens rör, s</translation>
    </message>
    <message>
        <source>x-t diagram of 0.97 m in closed form</source>
        <translation>x-t-diagram för 0,97 m i sluten form</translation>
    </message>
    <message>
        <source>plateau of that tube with a driver of 0.2 m, s</source>
        <translation>platå i det röret med en högtrycksdel på 0,2 m, s</translation>
    </message>
    <message>
        <source>way through the fan, integrated, and an Euler solution</source>
        <translation>vägen genom solfjädern, integrerad, och en Eulerlösning</translation>
    </message>
    <message>
        <source>speed of sound of moist air, m/s</source>
        <translation>ljudhastighet i fuktig luft, m/s</translation>
    </message>
    <message>
        <source>Cramer 1993, 21 degC, 50 %, 101.1 kPa</source>
        <translation>Cramer 1993, 21 °C, 50 %, 101,1 kPa</translation>
    </message>
    <message>
        <source>distance over time</source>
        <translation>sträcka genom tid</translation>
    </message>
    <message>
        <source>velocity fitted to three sensors, m/s</source>
        <translation>hastighet anpassad till tre givare, m/s</translation>
    </message>
    <message>
        <source>velocity from the records of two sensors, m/s</source>
        <translation>hastighet ur två givares registreringar, m/s</translation>
    </message>
    <message>
        <source>second-order step in closed form, zeta = 0.7</source>
        <translation>andra ordningens steg i sluten form, zeta = 0.7</translation>
    </message>
    <message>
        <source>baseline of a record</source>
        <translation>en registrerings baslinje</translation>
    </message>
    <message>
        <source>step of a record</source>
        <translation>en registrerings steg</translation>
    </message>
    <message>
        <source>first value behind the start, error</source>
        <translation>första värdet efter starten, fel</translation>
    </message>
    <message>
        <source>rise time of a record, times f0</source>
        <translation>en registrerings stigtid, gånger f0</translation>
    </message>
    <message>
        <source>overshoot of a record, %</source>
        <translation>en registrerings översväng, %</translation>
    </message>
    <message>
        <source>Parseval: amplitude squared over 2 in one bin of 1 Hz</source>
        <translation>Parseval: amplituden i kvadrat genom 2 i en linje om 1 Hz</translation>
    </message>
    <message>
        <source>what a symmetric filter must pass</source>
        <translation>vad ett symmetriskt filter måste släppa igenom</translation>
    </message>
    <message>
        <source>density of a cosine at its bin</source>
        <translation>en cosinus täthet vid sin linje</translation>
    </message>
    <message>
        <source>second singular value of three shots</source>
        <translation>tre skotts andra singulärvärde</translation>
    </message>
    <message>
        <source>share explained by the first component, %</source>
        <translation>andel som den första komponenten förklarar, %</translation>
    </message>
    <message>
        <source>ramp at a tenth of the rate, largest error</source>
        <translation>ramp vid en tiondel av takten, största felet</translation>
    </message>
    <message>
        <source>gain of the filter at half the new rate</source>
        <translation>filtrets förstärkning vid halva den nya takten</translation>
    </message>
    <message>
        <source>half of the amplitude, -6 dB</source>
        <translation>halva amplituden, -6 dB</translation>
    </message>
    <message>
        <source>decaying exponential at a tenth of the rate, error</source>
        <translation>avklingande exponential vid en tiondel av takten, fel</translation>
    </message>
    <message>
        <source>JCGM 100, by hand</source>
        <translation>JCGM 100, för hand</translation>
    </message>
    <message>
        <source>table of Student&apos;s t, 10 degrees of freedom</source>
        <translation>tabell över Students t, 10 frihetsgrader</translation>
    </message>
    <message>
        <source>u of contributions 3 and 4</source>
        <translation>u för bidragen 3 och 4</translation>
    </message>
    <message>
        <source>effective degrees of freedom (Welch-Satterthwaite)</source>
        <translation>effektiva frihetsgrader (Welch-Satterthwaite)</translation>
    </message>
    <message>
        <source>coverage factor k for 95 %</source>
        <translation>täckningsfaktor k för 95 %</translation>
    </message>
    <message>
        <source>U of u = 2 with 10 degrees of freedom</source>
        <translation>U för u = 2 med 10 frihetsgrader</translation>
    </message>
    <message>
        <source>U where the laboratory states no less than 20</source>
        <translation>U där laboratoriet inte anger mindre än 20</translation>
    </message>
    <message>
        <source>ILAC-P14, 5.4</source>
        <translation>ILAC-P14, 5.4</translation>
    </message>
    <message>
        <source>u of contributions with r = 0.5</source>
        <translation>u för bidrag med r = 0.5</translation>
    </message>
    <message>
        <source>effective degrees of freedom with r = 0.5</source>
        <translation>effektiva frihetsgrader med r = 0.5</translation>
    </message>
    <message>
        <source>u of a product</source>
        <translation>u för en produkt</translation>
    </message>
    <message>
        <source>relative u of the thesis&apos;s step</source>
        <translation>relativt u för avhandlingens steg</translation>
    </message>
    <message>
        <source>published sensitivities, six digits</source>
        <translation>publicerade känslighetskoefficienter, sex siffror</translation>
    </message>
    <message>
        <source>relative u of a velocity over 0.8 m</source>
        <translation>relativt u för en hastighet över 0,8 m</translation>
    </message>
    <message>
        <source>u of the distance over the distance, of the time over the time</source>
        <translation>sträckans u genom sträckan, tidens u genom tiden</translation>
    </message>
    <message>
        <source>PyDynamic 2.5.1, GUM_DFT and DFT2AmpPhase</source>
        <translation>PyDynamic 2.5.1, GUM_DFT och DFT2AmpPhase</translation>
    </message>
    <message>
        <source>real part of a spectral line</source>
        <translation>en spektrallinjes realdel</translation>
    </message>
    <message>
        <source>covariance of its real and imaginary part</source>
        <translation>dess real- och imaginärdels kovarians</translation>
    </message>
    <message>
        <source>variance of its magnitude</source>
        <translation>dess belopps varians</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>för hand</translation>
    </message>
    <message>
        <source>exact moments; four standard deviations of so many draws</source>
        <translation>exakta moment; fyra standardavvikelser för så många dragningar</translation>
    </message>
    <message>
        <source>E_n of 12 and 9, u = 0.75</source>
        <translation>E_n för 12 och 9, u = 0.75</translation>
    </message>
    <message>
        <source>smallest fault that is found, u = 0.75</source>
        <translation>minsta fel som hittas, u = 0.75</translation>
    </message>
    <message>
        <source>contradictions among 3.5 u and 3.7 u</source>
        <translation>motsägelser bland 3.5 u och 3.7 u</translation>
    </message>
    <message>
        <source>mean difference of two responses, relative</source>
        <translation>två svars medelskillnad, relativt</translation>
    </message>
    <message>
        <source>u of that difference</source>
        <translation>den skillnadens u</translation>
    </message>
    <message>
        <source>mean of 20000 draws</source>
        <translation>medelvärde av 20000 dragningar</translation>
    </message>
    <message>
        <source>standard deviation of 20000 draws</source>
        <translation>standardavvikelse för 20000 dragningar</translation>
    </message>
    <message>
        <source>sensitivities within U</source>
        <translation>känsligheter inom U</translation>
    </message>
    <message>
        <source>errors of the sensitivity over u, rms</source>
        <translation>känslighetens fel genom u, effektivvärde</translation>
    </message>
    <message>
        <source>natural frequencies within U</source>
        <translation>egenfrekvenser inom U</translation>
    </message>
    <message>
        <source>errors of the natural frequency over u, rms</source>
        <translation>egenfrekvensens fel genom u, effektivvärde</translation>
    </message>
    <message>
        <source>damping ratios within U</source>
        <translation>dämpningsförhållanden inom U</translation>
    </message>
    <message>
        <source>errors of the damping ratio over u, rms</source>
        <translation>dämpningsförhållandets fel genom u, effektivvärde</translation>
    </message>
    <message>
        <source>magnitudes at 20 kHz within U</source>
        <translation>belopp vid 20 kHz inom U</translation>
    </message>
    <message>
        <source>errors of the magnitude over u, rms</source>
        <translation>beloppets fel genom u, effektivvärde</translation>
    </message>
    <message>
        <source>binomial bound at 0.1 % for a coverage of 95 %</source>
        <translation>binomialgräns vid 0,1 % för 95 % täckning</translation>
    </message>
    <message>
        <source>1 where u is right; bounds of so many draws at 0.1 %</source>
        <translation>1 där u är rätt; gränser för så många dragningar vid 0,1 %</translation>
    </message>
    <message>
        <source>All %1 checks hold: this installation computes what is known.</source>
        <translation>Alla %1 kontroller stämmer: denna installation beräknar det som är känt.</translation>
    </message>
    <message>
        <source>The coverage study is to have %1 calibrations; it takes 0 to %2.</source>
        <translation>Täckningsstudien ska ha %1 kalibreringar; den tar 0 till %2.</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Program</translation>
    </message>
    <message>
        <source>Compiler</source>
        <translation>Kompilator</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>Processor</translation>
    </message>
    <message>
        <source>System</source>
        <translation>System</translation>
    </message>
    <message>
        <source>Coverage study</source>
        <translation>Täckningsstudie</translation>
    </message>
    <message>
        <source>%1 virtual calibrations</source>
        <translation>%1 virtuella kalibreringar</translation>
    </message>
    <message>
        <source>The report shows that this installation computes known results within the tolerances stated (ISO/IEC 17025:2017, 7.11.2). It says nothing of the recordings, of the recipe or of the laboratory&apos;s references.</source>
        <translation>Rapporten visar att denna installation beräknar kända resultat inom de toleranser som anges (ISO/IEC 17025:2017, 7.11.2). Den säger inget om registreringarna, receptet eller laboratoriets referenser.</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliotek</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Step of the method</source>
        <translation>Metodens steg</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>stämmer</translation>
    </message>
    <message>
        <source>deviates</source>
        <translation>avviker</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Vad</translation>
    </message>
    <message>
        <source>Known from</source>
        <translation>Känt ur</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Väntat</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Funnet</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerans</translation>
    </message>
    <message>
        <source>Change for 1e-12</source>
        <translation>Ändring för 1e-12</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Kontroller</translation>
    </message>
    <message>
        <source>Self-test of the installation</source>
        <translation>Självtest av installationen</translation>
    </message>
    <message>
        <source>Methods and libraries</source>
        <translation>Metoder och bibliotek</translation>
    </message>
    <message>
        <source>The document cannot be drawn: the program found nothing to draw on; start it anew.</source>
        <translation>Dokumentet kan inte ritas: programmet fann inget att rita på; starta om det.</translation>
    </message>
    <message>
        <source>A check holds where found and expected differ by no more than the tolerance. The last number is how far the result moves when all data change by a part in 10^12: rounding moves it by less than a thousandth of that.</source>
        <translation>En kontroll stämmer där funnet och väntat inte skiljer sig mer än toleransen. Det sista talet är hur långt resultatet flyttar sig när alla data ändras med en del på 10^12: avrundning flyttar det mindre än en tusendel av det.</translation>
    </message>
    <message>
        <source>The blocks of trials do not fit together: one begins with trial %1, expected is %2; merge blocks of one calibration, in their order.</source>
        <translation>Blocken av försök hör inte ihop: ett börjar med försök %1, väntat var %2; slå samman block från en kalibrering, i deras ordning.</translation>
    </message>
    <message>
        <source>compared at %L1</source>
        <translation>jämfört vid %L1</translation>
    </message>
    <message>
        <source>A value of another calibration stands in the table of this one, under its name, only where both agree within their expanded uncertainties (absolute En at most 1); below the band it is compared with the sensitivity at the onset of the step. It is no result of this calibration; the line &quot;compared at&quot; of its frequency is.</source>
        <translation>Ett värde från en annan kalibrering står i tabellen för denna, under sitt namn, bara där båda stämmer inom sina utvidgade osäkerheter (absolut En högst 1); under bandet jämförs det med känsligheten vid stegets början. Det är inget resultat av denna kalibrering; raden &quot;jämfört vid&quot; för dess frekvens är det.</translation>
    </message>
    <message>
        <source>distribution of a sum of four even ones, closed form (JCGM 101, 9.2)</source>
        <translation>fördelning för en summa av fyra jämna, sluten form (JCGM 101, 9.2)</translation>
    </message>
    <message>
        <source>u of 50000 sums</source>
        <translation>u för 50000 summor</translation>
    </message>
    <message>
        <source>upper end of their 95 % interval</source>
        <translation>övre änden av deras 95 %-intervall</translation>
    </message>
    <message>
        <source>half width about 0 that holds 95 %</source>
        <translation>halv bredd kring 0 som rymmer 95 %</translation>
    </message>
    <message>
        <source>tolerance of u = 0.35, one digit</source>
        <translation>tolerans för u = 0,35, en siffra</translation>
    </message>
    <message>
        <source>JCGM 101, 7.9.2</source>
        <translation>JCGM 101, 7.9.2</translation>
    </message>
    <message>
        <source>its expanded uncertainty is not below its value</source>
        <translation>dess utvidgade osäkerhet är inte mindre än dess värde</translation>
    </message>
    <message>
        <source>the response drifts as behind an AC coupling, so below the band it is not known</source>
        <translation>svaret driver som bakom en AC-koppling, så under bandet är det inte känt</translation>
    </message>
    <message>
        <source>Shot %1: the stretch to be corrected has %2 samples of channel %3; it needs 1 to %4 (--window).</source>
        <translation>Skott %1: sträckan som ska korrigeras har %2 sampel av kanal %3; den behöver 1 till %4 (--window).</translation>
    </message>
    <message>
        <source>The first line of the table has semicolons; the columns are parted by commas, and the numbers have a decimal point and no decimal comma.</source>
        <translation>Tabellens första rad har semikolon; kolumnerna skiljs åt av kommatecken, och talen har decimalpunkt och inte decimalkomma.</translation>
    </message>
    <message>
        <source>The table names the column &apos;%1&apos; twice, so that its values are not known; leave one of the two out.</source>
        <translation>Tabellen har kolumnen &apos;%1&apos; två gånger, så att dess värden inte är kända; utelämna en av de två.</translation>
    </message>
    <message>
        <source>Line %1 of the table has %2 values for %3 columns; they are parted by commas, and the numbers have a decimal point and no decimal comma.</source>
        <translation>Rad %1 i tabellen har %2 värden för %3 kolumner; de skiljs åt av kommatecken, och talen har decimalpunkt och inte decimalkomma.</translation>
    </message>
    <message>
        <source>The coverage study is to have %1 calibrations, but with less than %2 it cannot fail: even errors of 0 would be no sign of a wrong u; take 0 (no study) or %2 to %3.</source>
        <translation>Täckningsstudien ska ha %1 kalibreringar, men med färre än %2 kan den inte misslyckas: inte ens fel på 0 skulle tyda på ett felaktigt u; välj 0 (ingen studie) eller %2 till %3.</translation>
    </message>
    <message>
        <source>A stretch of the recording needs a begin and, behind it, an end; type both or neither.</source>
        <translation>En sträcka av registreringen behöver en början och, efter den, ett slut; skriv båda eller inget av dem.</translation>
    </message>
    <message>
        <source>No calibration is chosen; choose the results.json of the sensor, or take the open project.</source>
        <translation>Ingen kalibrering är vald; välj givarens results.json, eller ta det öppna projektet.</translation>
    </message>
    <message>
        <source>No recording is chosen; choose those that are to be corrected.</source>
        <translation>Ingen registrering är vald; välj dem som ska korrigeras.</translation>
    </message>
    <message>
        <source>The results are still being computed; try again in a moment.</source>
        <translation>Resultaten beräknas fortfarande; försök igen om en stund.</translation>
    </message>
    <message>
        <source>The results are out of date because the computation was cancelled; press F9 to compute them again.</source>
        <translation>Resultaten är inaktuella eftersom beräkningen avbröts; tryck F9 för att beräkna dem igen.</translation>
    </message>
    <message>
        <source>There is no model yet: open recordings and clear what blocks the stages.</source>
        <translation>Det finns ingen modell än: öppna registreringar och åtgärda det som blockerar arbetsstegen.</translation>
    </message>
    <message>
        <source>%1 of %2 records made as the model gives them, with the noise of the shots, could not be fitted again: the values of the model may be far more uncertain than is stated. Choose a lower order, or record with less noise.</source>
        <translation>%1 av %2 registreringar som modellen ger dem, med skottens brus, kunde inte anpassas på nytt: modellens värden kan vara långt osäkrare än vad som anges. Välj en lägre ordning eller spela in med mindre brus.</translation>
    </message>
    <message>
        <source>An amendment needs both --amends NUMBER and --reason TEXT, which says what changed.</source>
        <translation>En ändring kräver både --amends NUMMER och --reason TEXT, som säger vad som har ändrats.</translation>
    </message>
    <message>
        <source>This job was issued as certificate %1, and %2 does not hold it; name the folder that does (-o), or issue an amendment by --amends %1 --reason TEXT.</source>
        <translation>Detta jobb har utfärdats som bevis %1, och %2 innehåller det inte; ange mappen som gör det (-o), eller utfärda en ändring med --amends %1 --reason TEXT.</translation>
    </message>
    <message>
        <source>The recordings were not looked for (--recordings DIR).</source>
        <translation>Registreringarna eftersöktes inte (--recordings MAPP).</translation>
    </message>
    <message>
        <source>The registry knows no certificate with this file.</source>
        <translation>Registret känner inget bevis med denna fil.</translation>
    </message>
    <message>
        <source>Replaces</source>
        <translation>Ersätter</translation>
    </message>
    <message>
        <source>certificate %V1, which is no longer valid; what changed: %V2</source>
        <translation>kalibreringsbevis %V1, som inte längre gäller; vad som har ändrats: %V2</translation>
    </message>
    <message>
        <source>Issue</source>
        <translation>Utfärdande</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>issued, not signed</source>
        <translation>utfärdat, inte signerat</translation>
    </message>
    <message>
        <source>issued as an amendment, not signed</source>
        <translation>utfärdat som ändring, inte signerat</translation>
    </message>
    <message>
        <source>Audit trail before issuing (SHA-256)</source>
        <translation>Händelselogg före utfärdandet (SHA-256)</translation>
    </message>
    <message>
        <source>SHA-256 of results.json</source>
        <translation>SHA-256 för results.json</translation>
    </message>
    <message>
        <source>dyncal verify holds this page, the files beside it and the laboratory&apos;s registry against each other.</source>
        <translation>dyncal verify jämför denna sida, filerna bredvid den och laboratoriets register med varandra.</translation>
    </message>
    <message>
        <source>%1 required fields are empty or wrong: %2; fill them in (certificate.fields of the recipe).</source>
        <translation>%1 obligatoriska fält är tomma eller fel: %2; fyll i dem (certificate.fields i receptet).</translation>
    </message>
    <message>
        <source>The certificate of a reference ended before the measurement (%1); state the certificate that held then.</source>
        <translation>En referens certifikat gick ut före mätningen (%1); ange det certifikat som gällde då.</translation>
    </message>
    <message>
        <source>%1 cautions need a reason before the certificate is issued: %2; look at each and say why it is accepted (acknowledge).</source>
        <translation>%1 varningar behöver en motivering innan beviset utfärdas: %2; granska var och en och säg varför den godtas (acknowledge).</translation>
    </message>
    <message>
        <source>The profile %1 demands a second person, and the review is by &quot;%2&quot;, the issue by &quot;%3&quot;; name another one (--reviewed-by).</source>
        <translation>Profilen %1 kräver en andra person, och granskningen är gjord av &quot;%2&quot;, utfärdandet av &quot;%3&quot;; ange någon annan (--reviewed-by).</translation>
    </message>
    <message>
        <source>No uncertainty was computed, so there is nothing to state; run the job to its end.</source>
        <translation>Ingen osäkerhet har beräknats, så det finns inget att ange; kör jobbet till slut.</translation>
    </message>
    <message>
        <source>Reported quantities lack their complete uncertainty: %1; state what the budget of each lacks (docs/method/uncertainty.md).</source>
        <translation>Redovisade storheter saknar sin fullständiga osäkerhet: %1; ange det som saknas i budgeten för var och en (docs/method/uncertainty.md).</translation>
    </message>
    <message>
        <source>The profile %1 needs &quot;issue&quot; as an object with &quot;second_name&quot; true or false.</source>
        <translation>Profilen %1 behöver &quot;issue&quot; som ett objekt med &quot;second_name&quot; true eller false.</translation>
    </message>
    <message>
        <source>Certificate %1 is %2; only one that is %3 can be used for this.</source>
        <translation>Bevis %1 är %2; bara ett som är %3 kan användas till detta.</translation>
    </message>
    <message>
        <source>Number %1 is reserved for an earlier state of this job, which was not issued; go on with it by --number %1, or give it up by dyncal registry void %1 --reason TEXT.</source>
        <translation>Nummer %1 är reserverat för ett tidigare skick av detta jobb, som inte utfärdades; fortsätt med det genom --number %1, eller ge upp det med dyncal registry void %1 --reason TEXT.</translation>
    </message>
    <message>
        <source>These recordings have certificate %1, which is never changed; issue an amendment by --amends %1 --reason TEXT.</source>
        <translation>Dessa registreringar har bevis %1, som aldrig ändras; utfärda en ändring med --amends %1 --reason TEXT.</translation>
    </message>
    <message>
        <source>A name (--by) and a reason (--reason) are needed for the audit trail.</source>
        <translation>Ett namn (--by) och en motivering (--reason) behövs för händelseloggen.</translation>
    </message>
    <message>
        <source>The registry %1 holds a row that is no certificate; see dyncal verify, and take a copy from before.</source>
        <translation>Registret %1 innehåller en rad som inte är något bevis; se dyncal verify, och ta en tidigare kopia.</translation>
    </message>
    <message>
        <source>The registry %1 has no certificate %2; see dyncal registry list.</source>
        <translation>Registret %1 har inget bevis %2; se dyncal registry list.</translation>
    </message>
    <message>
        <source>The registry %1 has lost its counter; take a copy from before.</source>
        <translation>Registret %1 har förlorat sin räknare; ta en tidigare kopia.</translation>
    </message>
    <message>
        <source>Number %1 is %2 and not reserved for these recordings; leave --number out, and the job gets its own.</source>
        <translation>Nummer %1 är %2 och inte reserverat för dessa registreringar; utelämna --number, så får jobbet ett eget.</translation>
    </message>
    <message>
        <source>Certificate %1 is being amended by number %2, which is reserved; finish that, or give it up by dyncal registry void %2 --reason TEXT.</source>
        <translation>Bevis %1 håller på att ändras av nummer %2, som är reserverat; slutför det, eller ge upp det med dyncal registry void %2 --reason TEXT.</translation>
    </message>
    <message>
        <source>The registry %1 has no entry of the audit trail about certificate %2; see dyncal verify.</source>
        <translation>Registret %1 har ingen post i händelseloggen om bevis %2; se dyncal verify.</translation>
    </message>
    <message>
        <source>The database is damaged (%1).</source>
        <translation>Databasen är skadad (%1).</translation>
    </message>
    <message>
        <source>A table is not as the program makes it (%1).</source>
        <translation>En tabell är inte sådan som programmet gör den (%1).</translation>
    </message>
    <message>
        <source>A table is missing (%1).</source>
        <translation>En tabell saknas (%1).</translation>
    </message>
    <message>
        <source>The version of the tables is not %1.</source>
        <translation>Tabellernas version är inte %1.</translation>
    </message>
    <message>
        <source>The audit trail is broken at entry %1: it was changed, or an entry before it is missing.</source>
        <translation>Händelseloggen är bruten vid post %1: den har ändrats, eller en post före den saknas.</translation>
    </message>
    <message>
        <source>Entry %1 of the audit trail does not begin where the entry before about %2 ended.</source>
        <translation>Post %1 i händelseloggen börjar inte där den förra posten om %2 slutade.</translation>
    </message>
    <message>
        <source>The row of %1 is not what the audit trail says of it.</source>
        <translation>Raden för %1 är inte vad händelseloggen säger om den.</translation>
    </message>
    <message>
        <source>The counter of the certificates is not at %1, the last number that was given.</source>
        <translation>Bevisens räknare står inte på %1, det senast givna numret.</translation>
    </message>
    <message>
        <source>The row of %1 is missing.</source>
        <translation>Raden för %1 saknas.</translation>
    </message>
    <message>
        <source>%1 cannot be read as an issued certificate: its manifest.json is missing or changed; take an unchanged copy of the folder.</source>
        <translation>%1 kan inte läsas som ett utfärdat bevis: dess manifest.json saknas eller har ändrats; ta en oförändrad kopia av mappen.</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>%1 saknas.</translation>
    </message>
    <message>
        <source>%1 is not the file that was issued (another SHA-256).</source>
        <translation>%1 är inte den fil som utfärdades (annat SHA-256).</translation>
    </message>
    <message>
        <source>%1 does not belong to the certificate: the manifest lacks it.</source>
        <translation>%1 hör inte till beviset: den saknas i manifestet.</translation>
    </message>
    <message>
        <source>The chain of audit.jsonl is broken at line %1.</source>
        <translation>Kedjan i audit.jsonl är bruten på rad %1.</translation>
    </message>
    <message>
        <source>audit.jsonl does not end with the entry that the certificate names.</source>
        <translation>audit.jsonl slutar inte med den post som beviset anger.</translation>
    </message>
    <message>
        <source>%1 and %2 do not say the same of %3.</source>
        <translation>%1 och %2 säger inte detsamma (%3).</translation>
    </message>
    <message>
        <source>%1 does not hold what belongs into it.</source>
        <translation>%1 innehåller inte det som hör dit.</translation>
    </message>
    <message>
        <source>By the registry certificate %1 was not issued: the number is %2.</source>
        <translation>Enligt registret har bevis %1 inte utfärdats: numret är %2.</translation>
    </message>
    <message>
        <source>Certificate %1 is withdrawn: %2</source>
        <translation>Bevis %1 är återkallat: %2</translation>
    </message>
    <message>
        <source>Certificate %1 is replaced by %2.</source>
        <translation>Bevis %1 är ersatt av %2.</translation>
    </message>
    <message>
        <source>No registry was given: the folder agrees with itself, and whether it is what was issued is not known.</source>
        <translation>Inget register angavs: mappen stämmer med sig själv, och om den är vad som utfärdades är inte känt.</translation>
    </message>
    <message>
        <source>%1 is there already and does not belong to this certificate; give another folder (-o), or move that one. The number %2 stays reserved.</source>
        <translation>%1 finns redan och hör inte till detta bevis; ange en annan mapp (-o), eller flytta den. Numret %2 förblir reserverat.</translation>
    </message>
    <message>
        <source>%1 is no registry; name a file, or a database as postgresql://USER@HOST:PORT/DATABASE.</source>
        <translation>%1 är inget register; ange en fil, eller en databas som postgresql://USER@HOST:PORT/DATABASE.</translation>
    </message>
    <message>
        <source>The registry %1 does not answer as it should (%2); check that it is there, is a registry and may be written to, and do it again: nothing is lost.</source>
        <translation>Registret %1 svarar inte som det ska (%2); kontrollera att det finns, är ett register och får skrivas, och gör om det: inget har gått förlorat.</translation>
    </message>
    <message>
        <source>The registry %1 lies on a network folder (%2), where two programs that write it at once would destroy it; put it on a disk of this machine, or use a PostgreSQL server for several.</source>
        <translation>Registret %1 ligger på en nätverksmapp (%2), där två program som skriver samtidigt skulle förstöra det; lägg det på en disk i denna dator, eller använd en PostgreSQL-server för flera.</translation>
    </message>
    <message>
        <source>The registry %1 needs the driver %2, which is not installed; install the package %3.</source>
        <translation>Registret %1 behöver drivrutinen %2, som inte är installerad; installera paketet %3.</translation>
    </message>
    <message>
        <source>The registry %1 has version %2 and this program knows versions up to %3; open it with the program that wrote it, or a newer one.</source>
        <translation>Registret %1 har version %2 och detta program känner versioner till och med %3; öppna det med programmet som skrev det, eller ett nyare.</translation>
    </message>
    <message>
        <source>The database %1 holds other tables than those of a registry; name another file or database.</source>
        <translation>Databasen %1 innehåller andra tabeller än ett registers; ange en annan fil eller databas.</translation>
    </message>
    <message>
        <source>The registry %1 has version %2 and version %3 is needed to read it; the next dyncal issue or dyncal registry that writes it changes it, after a backup.</source>
        <translation>Registret %1 har version %2 och version %3 behövs för att läsa det; nästa dyncal issue eller dyncal registry som skriver ändrar det, efter en säkerhetskopia.</translation>
    </message>
    <message>
        <source>Line %1 of audit.jsonl is no entry of an audit trail; take an unchanged copy.</source>
        <translation>Rad %1 i audit.jsonl är ingen post i en händelselogg; ta en oförändrad kopia.</translation>
    </message>
    <message>
        <source>Line %1 of the table of cards cannot be used: %2; correct it, nothing was changed.</source>
        <translation>Rad %1 i tabellen med kort kan inte användas: %2; rätta den, inget har ändrats.</translation>
    </message>
    <message>
        <source>The registry %1 holds a row that is no card; see dyncal verify, and take a copy from before.</source>
        <translation>Registret %1 innehåller en rad som inte är något kort; se dyncal verify, och ta en tidigare kopia.</translation>
    </message>
    <message>
        <source>%1 could not be planned, so there is nothing to open (%2); mend that and make the plan anew.</source>
        <translation>%1 kunde inte planeras, så det finns inget att öppna (%2); åtgärda det och gör om planen.</translation>
    </message>
    <message>
        <source>This job has number %1 already, which is %2; leave --number out.</source>
        <translation>Detta jobb har redan nummer %1, som är %2; utelämna --number.</translation>
    </message>
    <message>
        <source>The table %1 holds values of another kind.</source>
        <translation>Tabellen %1 innehåller värden av annat slag.</translation>
    </message>
    <message>
        <source>--number and --amends are of one certificate, and a plan is of many; issue that sensor&apos;s project by itself.</source>
        <translation>--number och --amends gäller ett bevis, och en plan gäller många; utfärda den givarens projekt för sig.</translation>
    </message>
    <message>
        <source>The results are not of the recipe and recordings as they are now; wait for them or compute again (F9), then issue.</source>
        <translation>Resultaten hör inte till receptet och inspelningarna som de är nu; vänta på dem eller beräkna om (F9) och utfärda sedan.</translation>
    </message>
    <message>
        <source>The cards are not a JSON list of names with fields; write it as dyncal registry cards --json does.</source>
        <translation>Korten är ingen JSON-lista med namn och fält; skriv den så som dyncal registry cards --json gör.</translation>
    </message>
    <message>
        <source>The card &quot;%1&quot; has no name of its own: it is empty, longer than 200 bytes or there twice; give every card a name.</source>
        <translation>Kortet ”%1” har inget eget namn: det är tomt, längre än 200 byte eller finns två gånger; ge varje kort ett namn.</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Figurer</translation>
    </message>
    <message>
        <source>Singular values of the Hankel matrix</source>
        <translation>Hankelmatrisens singulärvärden</translation>
    </message>
    <message>
        <source>Responses and model</source>
        <translation>Svar och modell</translation>
    </message>
    <message>
        <source>Responses minus model</source>
        <translation>Svar minus modell</translation>
    </message>
    <message>
        <source>Frequency response, magnitude</source>
        <translation>Frekvenssvar, belopp</translation>
    </message>
    <message>
        <source>Frequency response, phase</source>
        <translation>Frekvenssvar, fas</translation>
    </message>
    <message>
        <source>Power spectra of the responses</source>
        <translation>Svarens effektspektra</translation>
    </message>
    <message>
        <source>Magnitude against the reference transducer and against the pressure step, less the mean of both</source>
        <translation>Belopp mot referensgivaren och mot trycksteget, minus medelvärdet av båda</translation>
    </message>
    <message>
        <source>Recordings of the item calibrated</source>
        <translation>Registreringar av det kalibrerade objektet</translation>
    </message>
    <message>
        <source>Recordings of the sensors in the wall of the driven section</source>
        <translation>Registreringar av givarna i lågtrycksdelens vägg</translation>
    </message>
    <message>
        <source>Recordings of the sensor in the driver section</source>
        <translation>Registreringar av givaren i högtrycksdelen</translation>
    </message>
    <message>
        <source>Responses of the item, aligned at their start</source>
        <translation>Objektets svar, lagda med början i samma punkt</translation>
    </message>
    <message>
        <source>First moments of the responses</source>
        <translation>Svarens första ögonblick</translation>
    </message>
    <message>
        <source>Share explained by the first principal components</source>
        <translation>Andel som förklaras av de första principalkomponenterna</translation>
    </message>
    <message>
        <source>Responses reconstructed from the components kept</source>
        <translation>Svar rekonstruerade ur de behållna komponenterna</translation>
    </message>
    <message>
        <source>Residuals of the reconstruction</source>
        <translation>Rekonstruktionens residualer</translation>
    </message>
    <message>
        <source>Autocovariance of the residuals; dotted: white noise</source>
        <translation>Residualernas autokovarians; prickat: vitt brus</translation>
    </message>
    <message>
        <source>Power spectra of the residuals</source>
        <translation>Residualernas effektspektra</translation>
    </message>
    <message>
        <source>Average of the reconstructions</source>
        <translation>Medelvärde av rekonstruktionerna</translation>
    </message>
    <message>
        <source>Input of the model</source>
        <translation>Modellindata</translation>
    </message>
    <message>
        <source>Bayesian information criterion over the order</source>
        <translation>Bayesianskt informationskriterium över ordningen</translation>
    </message>
    <message>
        <source>Step response of the model</source>
        <translation>Modellens stegsvar</translation>
    </message>
    <message>
        <source>Template key %1 is %2; it needs %3.</source>
        <translation>Mallens nyckel %1 är %2; den behöver %3.</translation>
    </message>
    <message>
        <source>Template key %1 is unknown; the nearest known key is %2.</source>
        <translation>Mallens nyckel %1 är okänd; den närmaste kända nyckeln är %2.</translation>
    </message>
    <message>
        <source>Template key %1 names &quot;%2&quot; twice; name it once, where it is to stand.</source>
        <translation>Mallens nyckel %1 nämner &quot;%2&quot; två gånger; nämn det en gång, där det ska stå.</translation>
    </message>
    <message>
        <source>Template key sections leaves out &quot;%1&quot;, which every calibration certificate must have (ISO/IEC 17025, 7.8.2 and 7.8.4); add it.</source>
        <translation>Mallens nyckel sections utelämnar &quot;%1&quot;, som varje kalibreringsbevis måste ha (ISO/IEC 17025, 7.8.2 och 7.8.4); lägg till det.</translation>
    </message>
    <message>
        <source>Template key quantities leaves out &quot;%1&quot;, which every certificate states where it is determined; add it.</source>
        <translation>Mallens nyckel quantities utelämnar &quot;%1&quot;, som varje bevis anger där det är bestämt; lägg till det.</translation>
    </message>
    <message>
        <source>Template key sections has &quot;%1&quot; before &quot;key-results&quot;, which belong on the first page; put &quot;key-results&quot; before it, with at most &quot;administrative&quot; and &quot;item&quot; above.</source>
        <translation>Mallens nyckel sections har &quot;%1&quot; före &quot;key-results&quot;, som hör hemma på första sidan; ställ &quot;key-results&quot; före, med högst &quot;administrative&quot; och &quot;item&quot; ovanför.</translation>
    </message>
    <message>
        <source>Template key figures names %1, and sections has no &quot;figures&quot; where they could stand; add that section, or name no figures ([]).</source>
        <translation>Mallens nyckel figures nämner %1 figurer, och sections saknar &quot;figures&quot; där de kunde stå; lägg till det avsnittet, eller nämn inga figurer ([]).</translation>
    </message>
    <message>
        <source>There is no template &quot;%1&quot; (certificate.template); it needs one of %2, or a file that ends in .json.</source>
        <translation>Det finns ingen mall &quot;%1&quot; (certificate.template); den måste vara en av %2, eller en fil som slutar på .json.</translation>
    </message>
    <message>
        <source>The file %1 of the certificate&apos;s template cannot be read, or is larger than %2 KiB; put it there, or choose another template.</source>
        <translation>Filen %1 till bevisets mall kan inte läsas, eller är större än %2 KiB; lägg dit den, eller välj en annan mall.</translation>
    </message>
    <message>
        <source>The logo %1 is no PNG image of at most %2 x %2 pixels; make it smaller, or use an SVG.</source>
        <translation>Logotypen %1 är ingen PNG-bild på högst %2 x %2 bildpunkter; gör den mindre, eller använd en SVG.</translation>
    </message>
    <message>
        <source>The logo %1 is no SVG drawing that stands by itself; it must hold no links (href), document type, entities, scripts or style sheets: save it as a plain SVG.</source>
        <translation>Logotypen %1 är ingen SVG-teckning som står för sig själv; den får inte innehålla länkar (href), dokumenttyp, entiteter, skript eller formatmallar: spara den som vanlig SVG.</translation>
    </message>
    <message>
        <source>The logo %1 of the template %2 cannot be drawn; save it anew as PNG or plain SVG.</source>
        <translation>Logotypen %1 till mallen %2 kan inte ritas; spara den på nytt som PNG eller vanlig SVG.</translation>
    </message>
    <message>
        <source>%1 is not the file that was issued (the manifest of certificate %2 has another hash), so it is nobody&apos;s history; look with dyncal verify what was changed.</source>
        <translation>%1 är inte filen som utfärdades (manifestet för bevis %2 har en annan hash), så den är ingens historik; se med dyncal verify vad som har ändrats.</translation>
    </message>
    <message>
        <source>%1 holds results that the history is made from; write it under another name.</source>
        <translation>%1 innehåller resultat som historiken görs av; skriv den under ett annat namn.</translation>
    </message>
    <message>
        <source>%1 does not say when the calibration was: no day of calibration is stated, and the results were made at &quot;%2&quot;, which is no moment such as 2026-01-31T09:00:00Z; repeat the run.</source>
        <translation>%1 säger inte när kalibreringen var: ingen dag för kalibreringen är angiven, och resultaten gjordes ”%2”, som inte är en tidpunkt som 2026-01-31T09:00:00Z; upprepa körningen.</translation>
    </message>
    <message>
        <source>None of the results states the serial number of its sensor, so they are nobody&apos;s history; fill it in on the certificate and repeat the runs.</source>
        <translation>Inget av resultaten anger sin givares serienummer, så de är ingens historik; fyll i det på beviset och upprepa körningarna.</translation>
    </message>
    <message>
        <source>The results are of %1 sensors, and a history is of one; choose it by its serial number: %2.</source>
        <translation>Resultaten är av %1 givare, och en historik är av en; välj den med dess serienummer: %2.</translation>
    </message>
    <message>
        <source>None of the results is of a sensor with the serial number %1; there are results of %2.</source>
        <translation>Inget av resultaten är av en givare med serienumret %1; det finns resultat av %2.</translation>
    </message>
    <message>
        <source>%1 states no magnitude of a frequency response, so there is nothing to lay over; choose the results of a run that has one.</source>
        <translation>%1 anger inget belopp av ett frekvenssvar, så det finns inget att lägga över; välj resultaten av en körning som har ett.</translation>
    </message>
    <message>
        <source>%1: %V2</source>
        <translation>%1: %V2</translation>
    </message>
    <message>
        <source>Project %1 was written by a newer program: it has version %2, and this program reads up to version %3; open it with the newer program.</source>
        <translation>Projektet %1 skrevs av ett nyare program: det har version %2, och detta program läser till och med version %3; öppna det med det nyare programmet.</translation>
    </message>
    <message>
        <source>Project %1 has version %2, which no program writes (versions go from %3 to %4); take an unchanged copy of the project.</source>
        <translation>Projektet %1 har version %2, som inget program skriver (versionerna går från %3 till %4); ta en oförändrad kopia av projektet.</translation>
    </message>
    <message>
        <source>Project %1 was written by an older program, as version %2; saving it writes version %3, which that program cannot open. Save it under another name to keep the old one.</source>
        <translation>Projektet %1 skrevs av ett äldre program, som version %2; att spara det skriver version %3, som det programmet inte kan öppna. Spara det under ett annat namn för att behålla det gamla.</translation>
    </message>
    <message>
        <source>Project %1 belongs to the issued certificate %2, so it is read-only; save changes under another name and issue them as an amendment.</source>
        <translation>Projektet %1 hör till det utfärdade beviset %2, så det är skrivskyddat; spara ändringar under ett annat namn och utfärda dem som en ändring.</translation>
    </message>
    <message>
        <source>Project %1 is open in another program, so it is read-only here; save changes under another name, or open it again once it is closed there.</source>
        <translation>Projektet %1 är öppet i ett annat program, så det är skrivskyddat här; spara ändringar under ett annat namn, eller öppna det igen när det har stängts där.</translation>
    </message>
    <message>
        <source>Project %1 is held by %2 on %3 since %4, so it is read-only here; save changes under another name, or open it again once it is closed there.</source>
        <translation>Projektet %1 hålls av %2 på %3 sedan %4, så det är skrivskyddat här; spara ändringar under ett annat namn, eller öppna det igen när det har stängts där.</translation>
    </message>
    <message>
        <source>%1: %M1</source>
        <translation>%1: %M1</translation>
    </message>
    <message>
        <source>Not evaluated where the state follows from a pressure.</source>
        <translation>Utvärderas inte där tillståndet följer av ett tryck.</translation>
    </message>
    <message>
        <source>The document cannot be shown: its pages cannot be read; export it and open it in another program.</source>
        <translation>Dokumentet kan inte visas: dess sidor kan inte läsas; exportera det och öppna det i ett annat program.</translation>
    </message>
    <message>
        <source>Earlier calibrations</source>
        <translation>Tidigare kalibreringar</translation>
    </message>
    <message>
        <source>When the certificate is issued, the laboratory&apos;s certificates of this sensor that are in force are stated here.</source>
        <translation>När beviset utfärdas anges här laboratoriets gällande bevis för denna givare.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be read (%2), and the certificate is to state the sensor&apos;s history from it; give the rights to read it, or choose a template without the section &apos;history&apos;.</source>
        <translation>Mappen %1 kan inte läsas (%2), och beviset ska ange givarens historik från den; ge läsrättigheter, eller välj en mall utan avsnittet &apos;history&apos;.</translation>
    </message>
    <message>
        <source>The certificate is to state the sensor&apos;s history, and %1 cannot be read, so that the history might lack a certificate; mend or move that file, or choose a template without the section &apos;history&apos;.</source>
        <translation>Beviset ska ange givarens historik, och %1 kan inte läsas, så att historiken kan sakna ett bevis; laga eller flytta filen, eller välj en mall utan avsnittet &apos;history&apos;.</translation>
    </message>
    <message>
        <source>* outside the scope: the laboratory states no calibration and measurement capability (CMC) at this frequency.</source>
        <translation>* utanför omfattningen: laboratoriet anger ingen kalibrerings- och mätförmåga (CMC) vid denna frekvens.</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innanför</translation>
    </message>
    <message>
        <source>beyond the warning limits</source>
        <translation>utanför varningsgränserna</translation>
    </message>
    <message>
        <source>beyond the action limits</source>
        <translation>utanför åtgärdsgränserna</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Bevis</translation>
    </message>
    <message>
        <source>Control chart</source>
        <translation>Styrdiagram</translation>
    </message>
    <message>
        <source>%M1: it drifts by %M2, more than its U.</source>
        <translation>%M1: den driver med %M2, mer än dess U.</translation>
    </message>
    <message>
        <source>%M1: the drift of %M2 is within its U.</source>
        <translation>%M1: driften %M2 ligger inom dess U.</translation>
    </message>
    <message>
        <source>Magnitude at %1</source>
        <translation>Belopp vid %1</translation>
    </message>
    <message>
        <source>Phase at %1</source>
        <translation>Fas vid %1</translation>
    </message>
    <message>
        <source>What the laboratory&apos;s certificates of this sensor state that are in force, this one last. En compares a value with the one before: up to 1 they agree within their U. Control limits need five calibrations.</source>
        <translation>Vad laboratoriets gällande bevis för denna givare anger, detta sist. En jämför ett värde med det föregående: upp till 1 stämmer de överens inom sina U. Styrgränser kräver fem kalibreringar.</translation>
    </message>
    <message>
        <source>Calibrations of one laboratory share tube, references and method: what they share is in every U and cancels in the difference, so that En is smaller than it would be for independent results.</source>
        <translation>Kalibreringar i ett laboratorium delar rör, referenser och metod: det gemensamma ingår i varje U och tar ut sig i skillnaden, så att En blir mindre än för oberoende resultat.</translation>
    </message>
    <message>
        <source>%1 values of S(f), from %2 to %3, lie outside the frequencies that the laboratory states a capability (CMC) for; the certificate marks them as outside the scope.</source>
        <translation>%1 värden av S(f), från %2 till %3, ligger utanför de frekvenser som laboratoriet anger en mätförmåga (CMC) för; beviset märker dem som utanför omfattningen.</translation>
    </message>
    <message>
        <source>Pressure sensor</source>
        <translation>Tryckgivare</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Källa</translation>
    </message>
    <message>
        <source>Shot, 0 where it is of all</source>
        <translation>Skott, 0 där det gäller alla</translation>
    </message>
    <message>
        <source>Standard uncertainty</source>
        <translation>Standardosäkerhet</translation>
    </message>
    <message>
        <source>Contribution</source>
        <translation>Bidrag</translation>
    </message>
    <message>
        <source>Share of the variance</source>
        <translation>Andel av variansen</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Frihetsgrader</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Fördelning</translation>
    </message>
    <message>
        <source>Key in results.json</source>
        <translation>Nyckel i results.json</translation>
    </message>
    <message>
        <source>Both propagations agree: 1, or 0</source>
        <translation>Båda fortplantningarna stämmer överens: 1, annars 0</translation>
    </message>
    <message>
        <source>Values by Monte Carlo, with their intervals</source>
        <translation>Värden enligt Monte Carlo, med intervall</translation>
    </message>
    <message>
        <source>Budget of the uncertainty</source>
        <translation>Osäkerhetsbudget</translation>
    </message>
    <message>
        <source>Effective degrees of freedom</source>
        <translation>Effektiva frihetsgrader</translation>
    </message>
    <message>
        <source>Reported values, not rounded</source>
        <translation>Redovisade värden, ej avrundade</translation>
    </message>
    <message>
        <source>Complex response</source>
        <translation>Komplext svar</translation>
    </message>
    <message>
        <source>Of %1 rows %2 are withheld and have no value (NaN).</source>
        <translation>Av %1 rader hålls %2 inne och saknar värde (NaN).</translation>
    </message>
    <message>
        <source>Frequency response as complex numbers, not rounded</source>
        <translation>Frekvenssvar som komplexa tal, ej avrundat</translation>
    </message>
    <message>
        <source>The same at the limits of the band, its edges and the resonance</source>
        <translation>Detsamma vid bandets gränser, dess kanter och resonansen</translation>
    </message>
    <message>
        <source>Frequency response against the reference transducer, not rounded</source>
        <translation>Frekvenssvar mot referensgivaren, ej avrundat</translation>
    </message>
    <message>
        <source>A list has one text for each of the %1 values, or one for all.</source>
        <translation>En lista har en text för vart och ett av de %1 värdena, eller en för alla.</translation>
    </message>
    <message>
        <source>The quantities of a list have one number of values; the first has %1.</source>
        <translation>Storheterna i en lista har lika många värden; den första har %1.</translation>
    </message>
    <message>
        <source>A list has single blanks between its texts, and none at its ends.</source>
        <translation>En lista har enkla blanksteg mellan sina texter och inga i ändarna.</translation>
    </message>
    <message>
        <source>A unit is written as the D-SI does, without blanks, like \volt\pascal\tothe{-1}.</source>
        <translation>En enhet skrivs som i D-SI, utan blanksteg, till exempel \volt\pascal\tothe{-1}.</translation>
    </message>
    <message>
        <source>Evaluation of the uncertainty</source>
        <translation>Utvärdering av osäkerheten</translation>
    </message>
    <message>
        <source>Versions of the methods, stage by stage</source>
        <translation>Metodernas versioner, steg för steg</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>Calibration certificate</source>
        <translation>Kalibreringscertifikat</translation>
    </message>
    <message>
        <source>Least</source>
        <translation>Minsta</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Största</translation>
    </message>
    <message>
        <source>A release is written like v1.2.3.</source>
        <translation>En utgåva skrivs som v1.2.3.</translation>
    </message>
    <message>
        <source>An id belongs to one element only.</source>
        <translation>Ett id hör till ett enda element.</translation>
    </message>
    <message>
        <source>Every id is referred to by a refId, or left out.</source>
        <translation>Varje id hänvisas till av ett refId, eller utelämnas.</translation>
    </message>
    <message>
        <source>A refId names the id of an element of the document.</source>
        <translation>Ett refId anger id för ett element i dokumentet.</translation>
    </message>
    <message>
        <source>Every measurement result names the methods that were used.</source>
        <translation>Varje mätresultat anger de metoder som användes.</translation>
    </message>
    <message>
        <source>Every measurement result states the conditions that influenced it.</source>
        <translation>Varje mätresultat anger de förhållanden som påverkade det.</translation>
    </message>
    <message>
        <source>A language is named by its two letters of ISO 639-1.</source>
        <translation>Ett språk anges med sina två bokstäver enligt ISO 639-1.</translation>
    </message>
    <message>
        <source>A mandatory language is one of the used ones.</source>
        <translation>Ett obligatoriskt språk är ett av de använda.</translation>
    </message>
    <message>
        <source>The language of a text is one of the used ones.</source>
        <translation>En texts språk är ett av de använda.</translation>
    </message>
    <message>
        <source>A date is a day of the calendar like 2026-01-31.</source>
        <translation>Ett datum är en kalenderdag, till exempel 2026-01-31.</translation>
    </message>
    <message>
        <source>The calibration does not end before its begin (%1).</source>
        <translation>Kalibreringen slutar inte före sin början (%1).</translation>
    </message>
    <message>
        <source>A refType of one&apos;s own is declared in refTypeDefinitions, as a value.</source>
        <translation>En egen refType deklareras i refTypeDefinitions, som värde.</translation>
    </message>
    <message>
        <source>The document is valid by the XML schema of its version.</source>
        <translation>Dokumentet är giltigt enligt XML-schemat för sin version.</translation>
    </message>
    <message>
        <source>There is no XML schema of this version at %V1, or it is none; give a folder that has PTB&apos;s schemas by their addresses.</source>
        <translation>Det finns inget XML-schema för den här versionen på %V1, eller så är det inget; ange en mapp som har PTB:s scheman efter deras adresser.</translation>
    </message>
    <message>
        <source>The file is no well-formed XML; give a digital calibration certificate.</source>
        <translation>Filen är inte välformad XML; ange ett digitalt kalibreringscertifikat.</translation>
    </message>
    <message>
        <source>This is a draft and no certificate: it has no number, and what it says may change.</source>
        <translation>Detta är ett utkast och inget certifikat: det har inget nummer, och det som står i det kan ändras.</translation>
    </message>
    <message>
        <source>Not stated yet; what stands in its place says nothing:</source>
        <translation>Inte angivet än; det som står på dess plats säger ingenting:</translation>
    </message>
    <message>
        <source>No interval until the next calibration is recommended.</source>
        <translation>Inget intervall till nästa kalibrering rekommenderas.</translation>
    </message>
    <message>
        <source>Largest deviation allowed</source>
        <translation>Största tillåtna avvikelse</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Avvikelse</translation>
    </message>
    <message>
        <source>Probability of lying beyond the limit</source>
        <translation>Sannolikhet att ligga utanför gränsen</translation>
    </message>
    <message>
        <source>The file is no digital calibration certificate: its first element is another; give a DCC of version 3.</source>
        <translation>Filen är inget digitalt kalibreringscertifikat: dess första element är ett annat; ange ett DCC av version 3.</translation>
    </message>
    <message>
        <source>The certificate states no serial number of its item, or not which of its numbers that is.</source>
        <translation>Certifikatet anger inget serienummer för sitt kalibreringsobjekt, eller inte vilket av dess nummer som är det.</translation>
    </message>
    <message>
        <source>The certificate is of several items (%1), and it is not said which of them the results are of.</source>
        <translation>Certifikatet gäller flera objekt (%1), och det sägs inte vilket av dem resultaten gäller.</translation>
    </message>
    <message>
        <source>The list in line %1 is a response over frequency, but so is another, and which is meant is not guessed.</source>
        <translation>Listan på rad %1 är ett svar över frekvens, men det är en annan också, och vilken som avses gissas inte.</translation>
    </message>
    <message>
        <source>%1 rows of the response over frequency state no value (NaN).</source>
        <translation>%1 rader av svaret över frekvens anger inget värde (NaN).</translation>
    </message>
    <message>
        <source>Line %1, %2: &apos;%3&apos; has a comma; numbers of a certificate have a point as decimal mark, and which is meant is not guessed.</source>
        <translation>Rad %1, %2: ”%3” har ett komma; tal i ett certifikat har punkt som decimaltecken, och vad som avses gissas inte.</translation>
    </message>
    <message>
        <source>Line %1, %2: &apos;%3&apos; is no finite number, and one is needed.</source>
        <translation>Rad %1, %2: ”%3” är inget ändligt tal, och ett sådant behövs.</translation>
    </message>
    <message>
        <source>Line %1, %2: it has %3 entries for %4 values; one for all or one for each is needed.</source>
        <translation>Rad %1, %2: den har %3 poster för %4 värden; en för alla eller en för varje behövs.</translation>
    </message>
    <message>
        <source>Line %1, %2: &apos;%3&apos; is no unit that is known here; a unit of the D-SI, such as \volt\pascal\tothe{-1}, is needed.</source>
        <translation>Rad %1, %2: ”%3” är ingen enhet som är känd här; en enhet enligt D-SI, som \volt\pascal\tothe{-1}, behövs.</translation>
    </message>
    <message>
        <source>Line %1, %2: the units &apos;%3&apos; and &apos;%4&apos; stand in one list; values of one unit are needed.</source>
        <translation>Rad %1, %2: enheterna ”%3” och ”%4” står i en och samma lista; värden i en enhet behövs.</translation>
    </message>
    <message>
        <source>Line %1, %2: it has the element %3 more than once; one is needed.</source>
        <translation>Rad %1, %2: den har elementet %3 mer än en gång; ett behövs.</translation>
    </message>
    <message>
        <source>Line %1, %2: it lacks the element %3, without which it says nothing.</source>
        <translation>Rad %1, %2: den saknar elementet %3, och utan det säger den inget.</translation>
    </message>
    <message>
        <source>Line %1, %2: a value or its uncertainty is beyond 1e308 in %3, which nothing measured is.</source>
        <translation>Rad %1, %2: ett värde eller dess osäkerhet är bortom 1e308 i %3, och så stort är inget som mäts.</translation>
    </message>
    <message>
        <source>Line %1, %2: its unit, or whether it has an uncertainty, is not as in the entries before it; a list of one kind is needed.</source>
        <translation>Rad %1, %2: dess enhet, eller om den har en osäkerhet, är inte som i posterna före; en lista av ett slag behövs.</translation>
    </message>
    <message>
        <source>Line %1, %2: the list is empty, and values are needed.</source>
        <translation>Rad %1, %2: listan är tom, och värden behövs.</translation>
    </message>
    <message>
        <source>Line %1, %2: its phase is in %3; one in \radian or \degree is needed.</source>
        <translation>Rad %1, %2: dess fas är i %3; en i \radian eller \degree behövs.</translation>
    </message>
    <message>
        <source>Line %1, %2: value %3 is 0, so its phase and the uncertainty of it are not determined.</source>
        <translation>Rad %1, %2: värde %3 är 0, så dess fas och fasens osäkerhet är inte bestämda.</translation>
    </message>
    <message>
        <source>Line %1, %2: this form of a quantity is not understood; one of the D-SI&apos;s real, complex or constant values or lists of them is needed.</source>
        <translation>Rad %1, %2: den här formen av en storhet förstås inte; ett av D-SI:s reella, komplexa eller konstanta värden eller listor av dem behövs.</translation>
    </message>
    <message>
        <source>Line %1, %2: its %3 is below 0, which no uncertainty is.</source>
        <translation>Rad %1, %2: dess %3 är under 0, och det är ingen osäkerhet.</translation>
    </message>
    <message>
        <source>Line %1, %2: its %3 is not above 0, so the standard uncertainty does not follow.</source>
        <translation>Rad %1, %2: dess %3 är inte över 0, så standardosäkerheten följer inte.</translation>
    </message>
    <message>
        <source>Line %1, %2: this statement of the uncertainty is not understood, or is the second one; the quantity is not read without it.</source>
        <translation>Rad %1, %2: den här uppgiften om osäkerheten förstås inte, eller är den andra; storheten läses inte utan den.</translation>
    </message>
    <message>
        <source>Line %1, %2: the covariance is in %3, where the values ask for %4.</source>
        <translation>Rad %1, %2: kovariansen är i %3, där värdena kräver %4.</translation>
    </message>
    <message>
        <source>Line %1, %2: it has not two columns with two entries each, which both parts of a complex value ask for.</source>
        <translation>Rad %1, %2: den har inte två kolumner med två poster vardera, som de båda delarna av ett komplext värde kräver.</translation>
    </message>
    <message>
        <source>Line %1, %2: it is no covariance: not symmetric, negative on its diagonal, or correlated by more than 1.</source>
        <translation>Rad %1, %2: den är ingen kovarians: inte symmetrisk, negativ på diagonalen eller korrelerad med mer än 1.</translation>
    </message>
    <message>
        <source>The file is XML, but no digital calibration certificate (it holds &apos;%1&apos;); give one, or a table as CSV.</source>
        <translation>Filen är XML, men inget digitalt kalibreringscertifikat (den innehåller ”%1”); ange ett sådant, eller en tabell som CSV.</translation>
    </message>
    <message>
        <source>The digital calibration certificate is of version &apos;%1&apos; (schemaVersion), and versions 3.0 to 3.3 are read; ask its laboratory for one of them.</source>
        <translation>Det digitala kalibreringscertifikatet är av version ”%1” (schemaVersion), och versionerna 3.0 till 3.3 läses; be dess laboratorium om en av dem.</translation>
    </message>
    <message>
        <source>Line %1, %2: a relative uncertainty has no coverage factor, so it is not taken; the values beside it are read without uncertainty.</source>
        <translation>Rad %1, %2: en relativ osäkerhet har ingen täckningsfaktor, så den används inte; värdena bredvid läses utan osäkerhet.</translation>
    </message>
    <message>
        <source>The list in line %1 of the certificate has no frequencies in hertz, which a response over frequency needs.</source>
        <translation>Listan på rad %1 i certifikatet har inga frekvenser i hertz, vilket ett svar över frekvens behöver.</translation>
    </message>
    <message>
        <source>The list in line %1 of the certificate has several quantities in hertz (lines %2), and which of them are the frequencies is not guessed; its laboratory must mark them by a refType.</source>
        <translation>Listan på rad %1 i certifikatet har flera storheter i hertz (raderna %2), och vilka av dem som är frekvenserna gissas inte; dess laboratorium måste märka dem med en refType.</translation>
    </message>
    <message>
        <source>The list in line %1 of the certificate has no magnitudes in the unit of a sensitivity, such as V/Pa, V/N or V/(m/s2).</source>
        <translation>Listan på rad %1 i certifikatet har inga belopp i enheten för en känslighet, som V/Pa, V/N eller V/(m/s2).</translation>
    </message>
    <message>
        <source>The list in line %1 of the certificate has no magnitudes in %3, which are asked for.</source>
        <translation>Listan på rad %1 i certifikatet har inga belopp i %3, vilka efterfrågas.</translation>
    </message>
    <message>
        <source>The list in line %1 of the certificate has several quantities in the unit of a sensitivity (lines %2), and which of them is meant is not guessed; its laboratory must mark it by a refType.</source>
        <translation>Listan på rad %1 i certifikatet har flera storheter i enheten för en känslighet (raderna %2), och vilken av dem som avses gissas inte; dess laboratorium måste märka den med en refType.</translation>
    </message>
    <message>
        <source>The list in line %1 of the certificate has several angles (lines %2), and which of them are the phases is not guessed; its laboratory must mark them by a refType.</source>
        <translation>Listan på rad %1 i certifikatet har flera vinklar (raderna %2), och vilka av dem som är faserna gissas inte; dess laboratorium måste märka dem med en refType.</translation>
    </message>
    <message>
        <source>The list in line %1 of the certificate has %2 frequencies and, in line %3, %4 values; as many of each are needed.</source>
        <translation>Listan på rad %1 i certifikatet har %2 frekvenser och, på rad %3, %4 värden; lika många av varje behövs.</translation>
    </message>
    <message>
        <source>The frequencies in line %1 of the certificate are not all above 0; which rows are meant is not guessed.</source>
        <translation>Frekvenserna på rad %1 i certifikatet är inte alla över 0; vilka rader som avses gissas inte.</translation>
    </message>
    <message>
        <source>The list in line %1 of the certificate states no magnitude at any frequency (NaN only).</source>
        <translation>Listan på rad %1 i certifikatet anger inget belopp vid någon frekvens (bara NaN).</translation>
    </message>
    <message>
        <source>The XML file is not in UTF-8, nor does it say that it is in UTF-16 or ISO-8859-1, so its text is unknown; save it as UTF-8.</source>
        <translation>XML-filen är inte i UTF-8 och säger inte heller att den är i UTF-16 eller ISO-8859-1, så dess text är okänd; spara den som UTF-8.</translation>
    </message>
    <message>
        <source>The XML file has %1 bytes and %2 tags, more than the %3 bytes and %4 tags that a certificate may have; take out what is embedded in it.</source>
        <translation>XML-filen har %1 byte och %2 taggar, fler än de %3 byte och %4 taggar som ett certifikat får ha; ta bort det som är inbäddat i den.</translation>
    </message>
    <message>
        <source>Line %1 of the XML file is malformed (%2); restore the file as its laboratory sent it.</source>
        <translation>Rad %1 i XML-filen är felaktig (%2); återställ filen som dess laboratorium sände den.</translation>
    </message>
    <message>
        <source>The XML file has a document type (DOCTYPE), which may make it grow or fetch other files, and which no certificate needs; it is not read.</source>
        <translation>XML-filen har en dokumenttyp (DOCTYPE), som kan få den att växa eller hämta andra filer och som inget certifikat behöver; den läses inte.</translation>
    </message>
    <message>
        <source>The elements of the XML file are nested deeper than %1 levels, which no certificate needs; it is not read.</source>
        <translation>XML-filens element ligger i varandra djupare än %1 nivåer, vilket inget certifikat behöver; den läses inte.</translation>
    </message>
    <message>
        <source>The XML file has several elements that hold everything, where one is needed; restore the file as its laboratory sent it.</source>
        <translation>XML-filen har flera element som omfattar allt, där ett behövs; återställ filen som dess laboratorium sände den.</translation>
    </message>
    <message>
        <source>%1 does not say when the calibration was: its certificate has no day (endPerformanceDate) such as 2026-01-31; ask its laboratory.</source>
        <translation>%1 säger inte när kalibreringen gjordes: dess certifikat har ingen dag (endPerformanceDate) som 2026-01-31; fråga dess laboratorium.</translation>
    </message>
    <message>
        <source>%1 cannot be read; check the path and the rights of the file.</source>
        <translation>%1 kan inte läsas; kontrollera sökvägen och filens rättigheter.</translation>
    </message>
    <message>
        <source>The unit &apos;%1&apos; is none that a certificate can be read in; one such as V/Pa, pC/Pa or 1 is needed.</source>
        <translation>Enheten ”%1” är ingen som ett certifikat kan läsas i; en som V/Pa, pC/Pa eller 1 behövs.</translation>
    </message>
    <message>
        <source>This certificate for machines (DCC)</source>
        <translation>Detta bevis för maskiner (DCC)</translation>
    </message>
    <message>
        <source>All results, unrounded, with their budgets</source>
        <translation>Alla resultat, oavrundade, med sina budgetar</translation>
    </message>
    <message>
        <source>Every decision of the evaluation</source>
        <translation>Varje beslut i utvärderingen</translation>
    </message>
    <message>
        <source>The document was drawn, but what an archive asks of a PDF could not be added to it (%1); please report this.</source>
        <translation>Dokumentet ritades, men det som ett arkiv kräver av en PDF kunde inte läggas till (%1); rapportera gärna detta.</translation>
    </message>
    <message>
        <source>The PDF lacks %1, which an archive needs.</source>
        <translation>PDF-filen saknar %1, som ett arkiv behöver.</translation>
    </message>
    <message>
        <source>The PDF says two things of %1.</source>
        <translation>PDF-filen säger två olika saker om %1.</translation>
    </message>
    <message>
        <source>The file %1 inside the PDF lacks %2, or has a wrong one.</source>
        <translation>Filen %1 inuti PDF-filen saknar %2 eller har fel värde där.</translation>
    </message>
    <message>
        <source>The font %1 of the PDF is not embedded.</source>
        <translation>PDF-filens typsnitt %1 är inte inbäddat.</translation>
    </message>
    <message>
        <source>The PDF holds %1, which an archive may not hold.</source>
        <translation>PDF-filen innehåller %1, som ett arkiv inte får innehålla.</translation>
    </message>
    <message>
        <source>The PDF cannot be read (%1): it is damaged, encrypted or written in another form than certificates are; take an unchanged copy of it.</source>
        <translation>PDF-filen kan inte läsas (%1): den är skadad, krypterad eller skriven i en annan form än bevisens; använd en oförändrad kopia av den.</translation>
    </message>
    <message>
        <source>The file %1 inside certificate.pdf stands where %2 belongs, or is said to be something else.</source>
        <translation>Filen %1 inuti certificate.pdf står där %2 hör hemma, eller anges vara något annat.</translation>
    </message>
    <message>
        <source>%1 inside certificate.pdf is not the file %1 beside it.</source>
        <translation>%1 inuti certificate.pdf är inte filen %1 bredvid.</translation>
    </message>
    <message>
        <source>%1 is missing inside certificate.pdf.</source>
        <translation>%1 saknas inuti certificate.pdf.</translation>
    </message>
    <message>
        <source>certificate.pdf has a file inside that does not belong there: %1.</source>
        <translation>certificate.pdf innehåller en fil som inte hör dit: %1.</translation>
    </message>
    <message>
        <source>Say who signs the certificate by one of --key and --seal-command, or that nobody does by --unsigned.</source>
        <translation>Ange vem som undertecknar beviset med antingen --key eller --seal-command, eller med --unsigned att ingen gör det.</translation>
    </message>
    <message>
        <source>A time stamp (--tsa) is put over a signature, and --unsigned asks for none; leave one of them out.</source>
        <translation>En tidsstämpel (--tsa) sätts över en signatur, och --unsigned begär ingen; utelämna ett av dem.</translation>
    </message>
    <message>
        <source>--pin-fd gives the PIN or passphrase of a key; name the key by --key.</source>
        <translation>--pin-fd ger en nyckels PIN eller lösenfras; ange nyckeln med --key.</translation>
    </message>
    <message>
        <source>%1 is no moment (--at); write it in UTC as 2026-01-31T12:00:00Z, or a day as 2026-01-31.</source>
        <translation>%1 är ingen tidpunkt (--at); skriv den i UTC som 2026-01-31T12:00:00Z, eller en dag som 2026-01-31.</translation>
    </message>
    <message>
        <source>A single file that is not signed can be verified with the registry only; name it (--registry), or the folder of the certificate.</source>
        <translation>En enskild fil som inte är undertecknad kan bara kontrolleras mot registret; ange det (--registry), eller bevisets mapp.</translation>
    </message>
    <message>
        <source>issued, with an electronic signature in this file</source>
        <translation>utfärdat, elektroniskt signerat i denna fil</translation>
    </message>
    <message>
        <source>issued as an amendment, with an electronic signature in this file</source>
        <translation>utfärdat som ändring, elektroniskt signerat i denna fil</translation>
    </message>
    <message>
        <source>The signature is no detached CMS with one signer and the certificate of that signer: it was changed, or is of a kind that is not read here.</source>
        <translation>Signaturen är ingen fristående CMS med en undertecknare och dennes certifikat: den har ändrats, eller är av ett slag som inte läses här.</translation>
    </message>
    <message>
        <source>The signature rests on a hash that is not accepted: SHA-256, SHA-384 and SHA-512 are.</source>
        <translation>Signaturen vilar på ett hashvärde som inte godtas: SHA-256, SHA-384 och SHA-512 godtas.</translation>
    </message>
    <message>
        <source>What was signed is not what stands there now: it was changed.</source>
        <translation>Det som signerades är inte det som står där nu: det har ändrats.</translation>
    </message>
    <message>
        <source>The signature was not made by the key of the certificate beside it: one of both was changed.</source>
        <translation>Signaturen gjordes inte med nyckeln till certifikatet bredvid: ett av dem har ändrats.</translation>
    </message>
    <message>
        <source>The key of %1 does not sign; where it is one of a token, look whether the token is still there and unlocked.</source>
        <translation>Nyckeln för %1 signerar inte; hör den till en token, se efter om denna ännu sitter i och är upplåst.</translation>
    </message>
    <message>
        <source>%1 is no address of a time-stamping authority that can be asked: it must be http://HOST[:PORT]/PATH. Plain http is enough, because the time stamp is signed itself.</source>
        <translation>%1 är ingen adress till en tidsstämplingstjänst som kan frågas: den ska vara http://HOST[:PORT]/PATH. Vanlig http räcker, eftersom tidsstämpeln själv är signerad.</translation>
    </message>
    <message>
        <source>The passphrase does not open the key in %1; give the right one.</source>
        <translation>Lösenfrasen öppnar inte nyckeln i %1; ge den rätta.</translation>
    </message>
    <message>
        <source>%1 holds no private key together with its certificate; give a PKCS#12 file, or a PEM file with both.</source>
        <translation>%1 innehåller ingen privat nyckel tillsammans med dess certifikat; ge en PKCS#12-fil, eller en PEM-fil med båda.</translation>
    </message>
    <message>
        <source>The key file %1 cannot be read, is empty or has more than %2 bytes; give a PKCS#12 or PEM file that you may read.</source>
        <translation>Nyckelfilen %1 kan inte läsas, är tom eller har fler än %2 byte; ge en PKCS#12- eller PEM-fil som du får läsa.</translation>
    </message>
    <message>
        <source>The library of the token (%1) cannot be used through OpenSSL&apos;s engine pkcs11; install libengine-pkcs11-openssl and name the token&apos;s library by module-path in the URI or by PKCS11_MODULE_PATH.</source>
        <translation>Tokenens bibliotek (%1) kan inte användas genom OpenSSL:s engine pkcs11; installera libengine-pkcs11-openssl och ange tokenens bibliotek med module-path i URI:n eller med PKCS11_MODULE_PATH.</translation>
    </message>
    <message>
        <source>The token gives no private key for %1: the PIN is wrong, or there is no such token or object; look with `pkcs11-tool --list-objects` before you try again, because tokens lock after some wrong PINs.</source>
        <translation>Tokenen ger ingen privat nyckel för %1: PIN är fel, eller det finns ingen sådan token eller inget sådant objekt; se efter med `pkcs11-tool --list-objects` innan du försöker igen, eftersom en token låses efter några felaktiga PIN.</translation>
    </message>
    <message>
        <source>The token has no certificate under %1; write the key&apos;s certificate into it under the same id (pkcs11-tool --write-object FILE --type cert --id ID).</source>
        <translation>Tokenen har inget certifikat under %1; skriv nyckelns certifikat till den under samma id (pkcs11-tool --write-object FILE --type cert --id ID).</translation>
    </message>
    <message>
        <source>The PDF cannot be signed: it does not end with a cross-reference table of the classic kind; sign it as Dyncal wrote it.</source>
        <translation>PDF-filen kan inte signeras: den slutar inte med en korsreferenstabell av det klassiska slaget; signera den som Dyncal skrev den.</translation>
    </message>
    <message>
        <source>The PDF cannot be signed: it is encrypted; sign it as Dyncal wrote it.</source>
        <translation>PDF-filen kan inte signeras: den är krypterad; signera den som Dyncal skrev den.</translation>
    </message>
    <message>
        <source>The PDF cannot be signed: it has a signature already; sign it as Dyncal wrote it.</source>
        <translation>PDF-filen kan inte signeras: den har redan en signatur; signera den som Dyncal skrev den.</translation>
    </message>
    <message>
        <source>The PDF cannot be signed: it is damaged; sign it as Dyncal wrote it.</source>
        <translation>PDF-filen kan inte signeras: den är skadad; signera den som Dyncal skrev den.</translation>
    </message>
    <message>
        <source>The signature of the PDF ends at byte %1, and the file has %2: something was added behind it.</source>
        <translation>PDF-filens signatur slutar vid byte %1, och filen har %2: något har lagts till efter den.</translation>
    </message>
    <message>
        <source>The signature of the PDF covers %1 bytes, and the file has %2: it was cut off.</source>
        <translation>PDF-filens signatur omfattar %1 byte, och filen har %2: den har kortats av.</translation>
    </message>
    <message>
        <source>The signature has %1 bytes with its certificates and time stamp, and the PDF has room for %2; leave certificates out that are not needed.</source>
        <translation>Signaturen har %1 byte med sina certifikat och sin tidsstämpel, och PDF-filen har plats för %2; utelämna certifikat som inte behövs.</translation>
    </message>
    <message>
        <source>The signature of the PDF is damaged.</source>
        <translation>PDF-filens signatur är skadad.</translation>
    </message>
    <message>
        <source>The signature of the PDF, in bytes %1 to %2, is damaged.</source>
        <translation>PDF-filens signatur, i byte %1 till %2, är skadad.</translation>
    </message>
    <message>
        <source>Signed are the bytes 0 to %1 and %2 to %3 of the PDF.</source>
        <translation>Signerade är byte 0 till %1 och %2 till %3 av PDF-filen.</translation>
    </message>
    <message>
        <source>The seal command %1 did not give a signature: it must be startable, end with exit code 0 within %2 s and write at most %3 bytes; try it by itself.</source>
        <translation>Sigillkommandot %1 gav ingen signatur: det måste gå att starta, sluta med slutkod 0 inom %2 s och skriva högst %3 byte; pröva det för sig.</translation>
    </message>
    <message>
        <source>“%1” is no command to seal with: it needs a program, and quotes that are closed.</source>
        <translation>“%1” är inget kommando att signera med: det behöver ett program, och citattecken som är slutna.</translation>
    </message>
    <message>
        <source>The seal command %1 answered, but not with a signature over the hash that it was given; see its contract in docs/signatures.md.</source>
        <translation>Sigillkommandot %1 svarade, men inte med en signatur över det hashvärde som det fick; se dess villkor i docs/signatures.md.</translation>
    </message>
    <message>
        <source>No PIN or passphrase of 1 to %2 bytes in one line can be read from file descriptor %1 (--pin-fd); open it for reading, as in `--pin-fd 3 3&lt; FILE`.</source>
        <translation>Ingen PIN eller lösenfras på 1 till %2 byte på en rad kan läsas från fildeskriptor %1 (--pin-fd); öppna den för läsning, som i `--pin-fd 3 3&lt; FILE`.</translation>
    </message>
    <message>
        <source>%1 holds no certificate that could be trusted; give a file in PEM form, with -----BEGIN CERTIFICATE-----.</source>
        <translation>%1 innehåller inget certifikat att lita på; ge en fil i PEM-form, med -----BEGIN CERTIFICATE-----.</translation>
    </message>
    <message>
        <source>It is signed by “%1”, and whether that is the laboratory is not known: name the certificate that you trust by --trust CA.pem.</source>
        <translation>Det är signerat av “%1”, och om det är laboratoriet är inte känt: ange det certifikat som du litar på med --trust CA.pem.</translation>
    </message>
    <message>
        <source>It is signed by “%1”, behind whom none of the certificates of --trust stands.</source>
        <translation>Det är signerat av “%1”, bakom vilken inget av certifikaten i --trust står.</translation>
    </message>
    <message>
        <source>The certificate of “%1” is valid from %2 to %3.</source>
        <translation>Certifikatet för “%1” gäller från %2 till %3.</translation>
    </message>
    <message>
        <source>It was not valid when it signed, at %1.</source>
        <translation>Det gällde inte när det signerade, %1.</translation>
    </message>
    <message>
        <source>It is not valid at %1, and no time stamp shows that the signature was made while it was.</source>
        <translation>Det gäller inte %1, och ingen tidsstämpel visar att signaturen gjordes medan det gällde.</translation>
    </message>
    <message>
        <source>The certificate of “%1” is not for signatures (key usage).</source>
        <translation>Certifikatet för “%1” är inte till för signaturer (nyckelanvändning).</translation>
    </message>
    <message>
        <source>The certificate in %1 (%2) does not belong to the private key there; give the certificate that was made for this key.</source>
        <translation>Certifikatet i %1 (%2) hör inte till den privata nyckeln där; ge det certifikat som gjordes för denna nyckel.</translation>
    </message>
    <message>
        <source>The certificate of %1 is not for signatures: its key usage has neither digitalSignature nor nonRepudiation; take one that has.</source>
        <translation>Certifikatet för %1 är inte till för signaturer: dess nyckelanvändning har varken digitalSignature eller nonRepudiation; ta ett som har det.</translation>
    </message>
    <message>
        <source>The certificate of %1 is valid from %2 to %3 and not at %4, when it would sign; take one that is valid.</source>
        <translation>Certifikatet för %1 gäller från %2 till %3 och inte %4, då det skulle signera; ta ett som gäller.</translation>
    </message>
    <message>
        <source>The time-stamping authority answered, but not with a time stamp over this signature; look whether the address (--tsa) is that of an RFC 3161 service.</source>
        <translation>Tidsstämplingstjänsten svarade, men inte med en tidsstämpel över denna signatur; se efter om adressen (--tsa) är den till en RFC 3161-tjänst.</translation>
    </message>
    <message>
        <source>The time stamp is not over this signature, or was changed, and does not count.</source>
        <translation>Tidsstämpeln är inte över denna signatur, eller har ändrats, och räknas inte.</translation>
    </message>
    <message>
        <source>The time stamp (%1) is by an authority behind which none of the certificates of --trust stands, and does not count.</source>
        <translation>Tidsstämpeln (%1) är från en tjänst bakom vilken inget av certifikaten i --trust står, och räknas inte.</translation>
    </message>
    <message>
        <source>What stands in the element %1 is not what was signed: it was changed.</source>
        <translation>Det som står i elementet %1 är inte det som signerades: det har ändrats.</translation>
    </message>
    <message>
        <source>The XML signature was not made by the key of the certificate in it: one of both was changed.</source>
        <translation>XML-signaturen gjordes inte med nyckeln till certifikatet i den: ett av dem har ändrats.</translation>
    </message>
    <message>
        <source>It is no XML document that is read: it must be sound, without document type and entities, of at most %1 bytes.</source>
        <translation>Det är inget XML-dokument som läses: det måste vara helt, utan dokumenttyp och entiteter, på högst %1 byte.</translation>
    </message>
    <message>
        <source>The XML signature is damaged, or not of the one form that is accepted: over the whole document, once, as the last element of its root, with exclusive canonicalisation, SHA-256 and the signer&apos;s certificate.</source>
        <translation>XML-signaturen är skadad, eller inte av den enda form som godtas: över hela dokumentet, en gång, som rotens sista element, med exklusiv kanonisering, SHA-256 och undertecknarens certifikat.</translation>
    </message>
    <message>
        <source>The signature of %1 cannot be looked at: the file cannot be read, or has more than %2 bytes.</source>
        <translation>Signaturen på %1 kan inte ses efter: filen kan inte läsas, eller har fler än %2 byte.</translation>
    </message>
    <message>
        <source>%1 has no signature of its own.</source>
        <translation>%1 har ingen egen signatur.</translation>
    </message>
    <message>
        <source>Only %1 is signed, %2 is not.</source>
        <translation>Bara %1 är signerad, %2 är det inte.</translation>
    </message>
    <message>
        <source>The signature of %1 does not hold.</source>
        <translation>Signaturen på %1 håller inte.</translation>
    </message>
    <message>
        <source>The key in %1 has a passphrase, and none was given; give it by --pin-fd N, or in its field of the window.</source>
        <translation>Nyckeln i %1 har en lösenfras, och ingen gavs; ge den med --pin-fd N eller i dess fält i fönstret.</translation>
    </message>
    <message>
        <source>The token gives no private key for %1 without a PIN; give it by --pin-fd N, or in its field of the window.</source>
        <translation>Tokenen ger ingen privat nyckel för %1 utan PIN; ge den med --pin-fd N eller i dess fält i fönstret.</translation>
    </message>
    <message>
        <source>The URI of the token holds a PIN, which others could read in the list of processes; leave it out and give the PIN by --pin-fd N, or in its field of the window.</source>
        <translation>Tokenens URI innehåller en PIN, som andra kunde läsa i listan över processer; utelämna den och ge PIN med --pin-fd N eller i dess fält i fönstret.</translation>
    </message>
    <message>
        <source>Sensitivity coefficient</source>
        <translation>Känslighetskoefficient</translation>
    </message>
    <message>
        <source>%1, shot %2</source>
        <translation>%1, skott %2</translation>
    </message>
    <message>
        <source>The budgets of the single frequencies are left out, because there are more than %1.</source>
        <translation>De enskilda frekvensernas budgetar är utelämnade, eftersom de är fler än %1.</translation>
    </message>
    <message>
        <source>Budgets of the frequency response</source>
        <translation>Frekvenssvarets osäkerhetsbudgetar</translation>
    </message>
    <message>
        <source>Budgets of the frequency response against the reference transducer</source>
        <translation>Osäkerhetsbudgetar för frekvenssvaret mot referensgivaren</translation>
    </message>
    <message>
        <source>Electronic signature</source>
        <translation>Elektronisk signatur</translation>
    </message>
    <message>
        <source>When the certificate is issued, who signs it, when, and its number are stated here.</source>
        <translation>När beviset utfärdas står här vem som signerar det, när, och dess nummer.</translation>
    </message>
    <message>
        <source>This certificate was issued without an electronic signature.</source>
        <translation>Detta bevis utfärdades utan elektronisk signatur.</translation>
    </message>
    <message>
        <source>a service that signs for the laboratory; its name is in the signature</source>
        <translation>en tjänst som signerar för laboratoriet; dess namn står i signaturen</translation>
    </message>
    <message>
        <source>Signed by</source>
        <translation>Signerat av</translation>
    </message>
    <message>
        <source>Signed at (UTC)</source>
        <translation>Signerat (UTC)</translation>
    </message>
    <message>
        <source>Number of the certificate</source>
        <translation>Bevisets nummer</translation>
    </message>
    <message>
        <source>No pressure step is determined, as the laboratory chose not to evaluate the shock wave. No sensitivity in the unit of pressure can be stated.</source>
        <translation>Inget trycksteg är bestämt, eftersom laboratoriet har valt att inte utvärdera stötvågen. Ingen känslighet i tryckenhet kan anges.</translation>
    </message>
    <message>
        <source>Relative humidity</source>
        <translation>Relativ fuktighet</translation>
    </message>
    <message>
        <source>Least favourable frequency</source>
        <translation>Ogynnsammaste frekvens</translation>
    </message>
    <message>
        <source>No statement of conformity could be made; the section of that name has the reason.</source>
        <translation>Inget uttalande om överensstämmelse kunde göras; skälet står i avsnittet med den rubriken.</translation>
    </message>
    <message>
        <source>A statement of conformity is made in a section of its own.</source>
        <translation>Ett uttalande om överensstämmelse görs i ett eget avsnitt.</translation>
    </message>
    <message>
        <source>The results are traceable to the International System of Units (SI) through the reference standards that are listed with their certificates in the section &quot;Method&quot;.</source>
        <translation>Resultaten är spårbara till Internationella måttenhetssystemet (SI) genom de referenser som anges med sina kalibreringsbevis i avsnittet ”Metod”.</translation>
    </message>
    <message>
        <source>%1 trials: both agree for %2 of %3 values and rows</source>
        <translation>%1 försök: båda stämmer överens för %2 av %3 värden och rader</translation>
    </message>
    <message>
        <source>%1 trials: both agree for %2 of %3 values and rows; the draws of the model agree with %4 full refits</source>
        <translation>%1 försök: båda stämmer överens för %2 av %3 värden och rader; modellens dragningar stämmer med %4 fullständiga nyanpassningar</translation>
    </message>
    <message>
        <source>Comparison of GUM and Monte Carlo (JCGM 101)</source>
        <translation>Jämförelse mellan GUM och Monte Carlo (JCGM 101)</translation>
    </message>
    <message>
        <source>Results whose interval of %1 % by Monte Carlo reaches beyond the one that U gives; it is the one to use</source>
        <translation>Resultat vars %1 %-intervall enligt Monte Carlo når utanför det som U ger; det är det som ska användas</translation>
    </message>
    <message>
        <source>Lower end</source>
        <translation>Undre ände</translation>
    </message>
    <message>
        <source>Upper end</source>
        <translation>Övre ände</translation>
    </message>
    <message>
        <source>%1 %; in this noise the true model would reach %2 % on average</source>
        <translation>%1 %; i detta brus skulle den sanna modellen i medeltal nå %2 %</translation>
    </message>
    <message>
        <source>Uncertainties marked U (k = 2) are expanded uncertainties with the coverage factor k = 2, or with the larger one printed beside them, for a coverage probability of about 95 % (GUM, JCGM 100). Those of the sensitivity contain the pressure step, the shots, the noise, gain, linearity and mounting; those of the frequency response also the end of the records, the sampling, the front and a drift; those of frequencies and times the noise and the sample clock, and where they or an overshoot depend on the height of the ringing the front and the mounting. What was not stated counts with the usual range: gain 0.5 %, linearity and mounting 0.1 %, clock 50 ppm, a front of up to 100 ns. The budget of every value is in results.json. A value without an uncertainty beside it has none that is complete: it is no result, and has three significant digits; settings and readings are quoted with four at most, temperatures with five. Rise time, overshoot, settling time and band edges are those of the model, as far as records and model reach.</source>
        <translation>Osäkerheter märkta U (k = 2) är utvidgade osäkerheter med täckningsfaktorn k = 2, eller med den större som står bredvid, för en täckningssannolikhet på ungefär 95 % (GUM, JCGM 100). Känslighetens innehåller tryckstegets, skottens och brusets bidrag, förstärkning, linjäritet och montering; frekvenssvarets även registreringens slut, samplingen, fronten och en drift; frekvensers och tiders brus och samplingsklocka, och där de eller en översväng beror av svängningens höjd fronten och monteringen. Det som inte har angetts räknas med det vanliga intervallet: förstärkning 0,5 %, linjäritet och montering 0,1 %, klocka 50 ppm, en front på upp till 100 ns. Varje värdes budget finns i results.json. Ett värde utan osäkerhet bredvid sig har ingen som är fullständig: det är inget resultat och har tre värdesiffror; inställningar och avläsningar anges med högst fyra, temperaturer med fem. Stigtid, översväng, insvängningstid och bandgränser är modellens, så långt som registreringar och modell räcker.</translation>
    </message>
    <message>
        <source>Uncertainties marked U (k = 2) are expanded uncertainties with the coverage factor k = 2, or with the larger one printed beside them, for a coverage probability of about 95 % (GUM, JCGM 100). Those of the sensitivity contain the reference transducer&apos;s certificate, its chain and its level, the shots, the noise, gain, linearity and mounting; those of the frequency response also the noise of the reference, the end of the records, the sampling, a drift and, in the phase, the delay between the two; those of frequencies and times the noise and the sample clock, and where they or an overshoot depend on the height of the ringing the front and the mounting. What was not stated counts with the usual range: gain of either chain 0.5 %, linearity and mounting 0.1 %, clock 50 ppm, a delay of up to 0.5 µs. The budget of every value is in results.json. A value without an uncertainty beside it has none that is complete: it is no result, and has three significant digits; settings and readings are quoted with four at most, temperatures with five. Rise time, overshoot, settling time and band edges are those of the model, as far as records and model reach.</source>
        <translation>Osäkerheter märkta U (k = 2) är utvidgade osäkerheter med täckningsfaktorn k = 2, eller med den större som står bredvid, för en täckningssannolikhet på ungefär 95 % (GUM, JCGM 100). Känslighetens innehåller referensgivarens kalibreringsbevis, dess mätkedja och nivå, skotten, bruset, förstärkning, linjäritet och montering; frekvenssvarets även referensens brus, registreringarnas slut, samplingen, en drift och, i fasen, fördröjningen mellan de två; frekvensers och tiders brus och samplingsklocka, och där de eller en översväng beror av svängningens höjd fronten och monteringen. Det som inte har angetts räknas med det vanliga intervallet: vardera kedjans förstärkning 0,5 %, linjäritet och montering 0,1 %, klocka 50 ppm, en fördröjning på upp till 0,5 µs. Varje värdes budget finns i results.json. Ett värde utan osäkerhet bredvid sig har ingen som är fullständig: det är inget resultat och har tre värdesiffror; inställningar och avläsningar anges med högst fyra, temperaturer med fem. Stigtid, översväng, insvängningstid och bandgränser är modellens, så långt som registreringar och modell räcker.</translation>
    </message>
    <message>
        <source>Uncertainties marked U (k = 2) are expanded uncertainties with the coverage factor k = 2, or with the larger one printed beside them, for a coverage probability of about 95 % (GUM, JCGM 100). Those of the frequency response contain the noise of the recordings and of the level, the end of the records, the sampling, the front and a drift; those of frequencies and times the noise and the sample clock, and where they or an overshoot depend on the height of the ringing the front and the mounting. What was not stated counts with the usual range: mounting 0.1 %, clock 50 ppm, a front of up to 100 ns. The budget of every value is in results.json. A value without an uncertainty beside it has none that is complete: it is no result, and has three significant digits; settings and readings are quoted with four at most, temperatures with five. Rise time, overshoot, settling time and band edges are those of the model, as far as records and model reach.</source>
        <translation>Osäkerheter märkta U (k = 2) är utvidgade osäkerheter med täckningsfaktorn k = 2, eller med den större som står bredvid, för en täckningssannolikhet på ungefär 95 % (GUM, JCGM 100). Frekvenssvarets innehåller registreringarnas och nivåns brus, registreringens slut, samplingen, fronten och en drift; frekvensers och tiders brus och samplingsklocka, och där de eller en översväng beror av svängningens höjd fronten och monteringen. Det som inte har angetts räknas med det vanliga intervallet: montering 0,1 %, klocka 50 ppm, en front på upp till 100 ns. Varje värdes budget finns i results.json. Ett värde utan osäkerhet bredvid sig har ingen som är fullständig: det är inget resultat och har tre värdesiffror; inställningar och avläsningar anges med högst fyra, temperaturer med fem. Stigtid, översväng, insvängningstid och bandgränser är modellens, så långt som registreringar och modell räcker.</translation>
    </message>
    <message>
        <source>Uncertainties marked U (k = 2) are expanded uncertainties with the coverage factor k = 2, or with the larger one printed beside them, for a coverage probability of about 95 % (GUM, JCGM 100). They contain the noise of the recordings and, of frequencies, the sample clock, which counts with 50 ppm unless it was stated. A value without an uncertainty beside it has none that is complete: it is no result, and has three significant digits; settings and readings are quoted with four at most, temperatures with five.</source>
        <translation>Osäkerheter märkta U (k = 2) är utvidgade osäkerheter med täckningsfaktorn k = 2, eller med den större som står bredvid, för en täckningssannolikhet på ungefär 95 % (GUM, JCGM 100). De innehåller registreringarnas brus och, för frekvenser, samplingsklockan, som räknas med 50 ppm om den inte har angetts. Ett värde utan osäkerhet bredvid sig har ingen som är fullständig: det är inget resultat och har tre värdesiffror; inställningar och avläsningar anges med högst fyra, temperaturer med fem.</translation>
    </message>
    <message>
        <source>Signal to noise is the output step over the standard deviation of the noise before it. Rise time 10 % to 90 %; settling to within 5 % of the step; a dash where the record does not show it. These are read from single records, whose noise raises overshoot and settling time; those of the sensor are the key results. Values without an uncertainty have none that is known: they have three significant digits.</source>
        <translation>Signalbrusförhållandet är utsignalens steg dividerat med standardavvikelsen för bruset före steget. Stigtid 10 % till 90 %; insvängning till inom 5 % av steget; ett streck där registreringen inte visar den. Värdena är avlästa i enskilda registreringar, vars brus höjer översväng och insvängningstid; givarens egna står bland huvudresultaten. Värden utan osäkerhet har ingen som är känd: de har tre värdesiffror.</translation>
    </message>
    <message>
        <source>%M1: %L1 from %L2 on</source>
        <translation>%M1: %L1 från %L2</translation>
    </message>
    <message>
        <source>%M1: %L1 up to %L2</source>
        <translation>%M1: %L1 upp till %L2</translation>
    </message>
    <message>
        <source>%M1: %L1 from %L2 to %L3</source>
        <translation>%M1: %L1 från %L2 till %L3</translation>
    </message>
    <message>
        <source>%M1: certificate %V1</source>
        <translation>%M1: kalibreringsbevis %V1</translation>
    </message>
    <message>
        <source>%M1: certificate %V1, which ended on %2, before the measurement</source>
        <translation>%M1: kalibreringsbevis %V1, som gick ut %2, före mätningen</translation>
    </message>
    <message>
        <source>%M1: certificate %V1, valid until %2</source>
        <translation>%M1: kalibreringsbevis %V1, giltigt till och med %2</translation>
    </message>
    <message>
        <source>Reference standard</source>
        <translation>Referens</translation>
    </message>
    <message>
        <source>Magnitude of the frequency response</source>
        <translation>Frekvenssvarets belopp</translation>
    </message>
    <message>
        <source>Phase of the frequency response</source>
        <translation>Frekvenssvarets fas</translation>
    </message>
    <message>
        <source>initial pressure</source>
        <translation>begynnelsetryck</translation>
    </message>
    <message>
        <source>initial temperature</source>
        <translation>begynnelsetemperatur</translation>
    </message>
    <message>
        <source>ratio of the specific heats</source>
        <translation>kvot mellan de specifika värmekapaciteterna</translation>
    </message>
    <message>
        <source>molar mass of the gas</source>
        <translation>gasens molmassa</translation>
    </message>
    <message>
        <source>relative humidity</source>
        <translation>relativ fuktighet</translation>
    </message>
    <message>
        <source>share of carbon dioxide</source>
        <translation>andel koldioxid</translation>
    </message>
    <message>
        <source>shock velocity</source>
        <translation>stötvågens hastighet</translation>
    </message>
    <message>
        <source>distance along the tube</source>
        <translation>avstånd längs röret</translation>
    </message>
    <message>
        <source>time of arrival</source>
        <translation>ankomsttid</translation>
    </message>
    <message>
        <source>delay of a sensor</source>
        <translation>en givares fördröjning</translation>
    </message>
    <message>
        <source>pressure step, as a ratio</source>
        <translation>trycksteg, relativt</translation>
    </message>
    <message>
        <source>gain of the measuring chain</source>
        <translation>mätkedjans förstärkning</translation>
    </message>
    <message>
        <source>linearity of the measuring chain</source>
        <translation>mätkedjans linjäritet</translation>
    </message>
    <message>
        <source>mounting</source>
        <translation>montering</translation>
    </message>
    <message>
        <source>sample clock</source>
        <translation>samplingsklocka</translation>
    </message>
    <message>
        <source>gain of the reference&apos;s chain</source>
        <translation>förstärkning i referensens mätkedja</translation>
    </message>
    <message>
        <source>Certificate %1 was issued before, without a signature, and stays so; for one that is signed issue an amendment by --amends %1 --reason TEXT.</source>
        <translation>Bevis %1 utfärdades tidigare, utan signatur, och förblir så; för ett som är signerat, utfärda en ändring med --amends %1 --reason TEXT.</translation>
    </message>
    <message>
        <source>It has no signature, and without the registry (--registry) or the folder of its certificate nothing else shows whether it is as it was issued.</source>
        <translation>Den har ingen signatur, och utan registret (--registry) eller bevisets mapp visar inget annat om den är som den utfärdades.</translation>
    </message>
    <message>
        <source>The passphrase is right, but %1 is encrypted in an old way (RC2 or the like) that is not opened any more; convert it by `openssl pkcs12 -legacy -in OLD.p12 -nodes | openssl pkcs12 -export -out NEW.p12`.</source>
        <translation>Lösenfrasen stämmer, men %1 är krypterad på ett gammalt sätt (RC2 eller liknande) som inte längre öppnas; gör om den med `openssl pkcs12 -legacy -in OLD.p12 -nodes | openssl pkcs12 -export -out NEW.p12`.</translation>
    </message>
    <message>
        <source>The PDF cannot be signed: a text in it has %1, by which signatures are found; take it out of the certificate&apos;s texts.</source>
        <translation>PDF-filen kan inte signeras: en text i den innehåller %1, som signaturer hittas genom; ta bort det ur bevisets texter.</translation>
    </message>
    <message>
        <source>The signature that covers the PDF is not that of the one signature field in its form: the PDF was changed after it was signed, or signed in another way than a certificate is.</source>
        <translation>Signaturen som omfattar PDF-filen är inte den som hör till det enda signaturfältet i dess formulär: PDF-filen ändrades efter att den signerades, eller signerades på annat sätt än ett bevis.</translation>
    </message>
    <message>
        <source>The PDF has more than one signature or signature field, and a certificate has one: something was added to it after it was signed.</source>
        <translation>PDF-filen har mer än en signatur eller ett signaturfält, och ett bevis har en: något lades till efter att den signerades.</translation>
    </message>
    <message>
        <source>The PDF around its signature cannot be read: it is damaged, or written in another form than certificates are.</source>
        <translation>PDF-filen kring signaturen kan inte läsas: den är skadad, eller skriven i en annan form än bevis är.</translation>
    </message>
    <message>
        <source>The PIN or passphrase in file descriptor %1 (--pin-fd) has a byte that is zero, as a text in UTF-16 has many; write it in UTF-8, in one line of 1 to %2 bytes.</source>
        <translation>PIN-koden eller lösenfrasen i filbeskrivare %1 (--pin-fd) har en byte som är noll, som en text i UTF-16 har många av; skriv den i UTF-8, på en rad med 1 till %2 byte.</translation>
    </message>
    <message>
        <source>The certificate of “%1” rests on %2, which is too weak to show who signed.</source>
        <translation>Certifikatet för ”%1” vilar på %2, som är för svagt för att visa vem som signerade.</translation>
    </message>
    <message>
        <source>The key in %1 (%3) is none to sign certificates with; take an RSA key of %2 bits or more (not RSA-PSS), or one of the curves P-256, P-384 and P-521.</source>
        <translation>Nyckeln i %1 (%3) är ingen att signera bevis med; ta en RSA-nyckel på %2 bitar eller mer (inte RSA-PSS), eller en på någon av kurvorna P-256, P-384 och P-521.</translation>
    </message>
    <message>
        <source>The certificate of “%1” is not for signatures of documents (extended key usage): it is one of a server or of a time-stamping authority.</source>
        <translation>Certifikatet för ”%1” är inte till för signaturer av dokument (utökad nyckelanvändning): det är en servers eller en tidsstämplingstjänsts.</translation>
    </message>
    <message>
        <source>The signature states that it was made at %1, and its time stamp is of %2: more than a day lies between them.</source>
        <translation>Signaturen anger att den gjordes %1, och dess tidsstämpel är från %2: mer än ett dygn ligger emellan.</translation>
    </message>
    <message>
        <source>The time-stamping authority refused to stamp this signature (PKIStatus %1, %2); ask those who run it, or take another by --tsa.</source>
        <translation>Tidsstämplingstjänsten vägrade att stämpla signaturen (PKIStatus %1, %2); fråga dem som driver den, eller ta en annan med --tsa.</translation>
    </message>
    <message>
        <source>The time stamp (%1) does not count.</source>
        <translation>Tidsstämpeln (%1) räknas inte.</translation>
    </message>
    <message>
        <source>The XML document cannot be signed: it must be sound, without document type and entities, without comments in the text of an element, of at most %1 bytes and not signed yet.</source>
        <translation>XML-dokumentet kan inte signeras: det måste vara helt, utan dokumenttyp och entiteter, utan kommentarer i ett elements text, på högst %1 byte och ännu inte signerat.</translation>
    </message>
    <message>
        <source>It is no XML document that is read: it may have at most %1 elements in %2 levels, and each with those around it at most %3 attributes and namespaces.</source>
        <translation>Det är inget XML-dokument som läses: det får ha högst %1 element i %2 nivåer, och vart och ett med dem omkring högst %3 attribut och namnrymder.</translation>
    </message>
    <message>
        <source>A comment or processing instruction stands in the text of an element, where the signature may not cover it and other programs may read another value; Dyncal writes none.</source>
        <translation>En kommentar eller bearbetningsinstruktion står i ett elements text, där signaturen kanske inte omfattar den och andra program kan läsa ett annat värde; Dyncal skriver inga.</translation>
    </message>
    <message>
        <source>The XML document has a comment or processing instruction, which Dyncal does not write and the signature may not cover: it may be anybody&apos;s.</source>
        <translation>XML-dokumentet har en kommentar eller bearbetningsinstruktion, som Dyncal inte skriver och signaturen kanske inte omfattar: den kan vara vems som helst.</translation>
    </message>
    <message>
        <source>%1 is signed by “%2”, %3 by “%4”, with another certificate: they were not issued together.</source>
        <translation>%1 är signerad av ”%2”, %3 av ”%4”, med ett annat certifikat: de utfärdades inte tillsammans.</translation>
    </message>
    <message>
        <source>The result &apos;%1&apos; in line %2 is not known as sensitivity, natural frequency or damping ratio, or is not the only one that may be it.</source>
        <translation>Resultatet ’%1’ på rad %2 känns inte igen som känslighet, egenfrekvens eller dämpningskvot, eller är inte det enda som kan vara det.</translation>
    </message>
    <message>
        <source>The list in line %1 of the certificate has the frequency %2 Hz more than once, and which of its rows is meant is not guessed.</source>
        <translation>Listan på rad %1 i kalibreringsbeviset har frekvensen %2 Hz mer än en gång, och det gissas inte vilken av raderna som menas.</translation>
    </message>
    <message>
        <source>The list in line %1 of the certificate has the magnitude %3 at %2 Hz; one above 0 is needed, with the sign in the phase.</source>
        <translation>Listan på rad %1 i kalibreringsbeviset har beloppet %3 vid %2 Hz; det måste vara över 0, med tecknet i fasen.</translation>
    </message>
    <message>
        <source>The list in line %1 is a response over frequency, but that in line %2, which is not understood, may be the one that is meant, so it is not taken.</source>
        <translation>Listan på rad %1 är ett svar över frekvens, men den på rad %2, som inte förstås, kan vara den som menas, så den tas inte.</translation>
    </message>
    <message>
        <source>Line %1, %2: the element %3 stands among its text, so what belongs together in it is not known; text alone is needed.</source>
        <translation>Rad %1, %2: elementet %3 står mitt i texten, så det är inte känt vad i den som hör ihop; enbart text behövs.</translation>
    </message>
    <message>
        <source>Line %1, %2: the element is of another namespace than those of a certificate (https://ptb.de/dcc, https://ptb.de/si), so what it says is not known here.</source>
        <translation>Rad %1, %2: elementet hör till en annan namnrymd än kalibreringsbevisets (https://ptb.de/dcc, https://ptb.de/si), så det är inte känt vad det säger.</translation>
    </message>
    <message>
        <source>The quantity &apos;%1&apos; in line %2 is by its name or its refType no such value but one about it (an error, an uncertainty, a limit, a nominal value).</source>
        <translation>Storheten ’%1’ på rad %2 är enligt sitt namn eller sin refType inget sådant värde utan något om det (ett fel, en osäkerhet, en gräns, ett nominellt värde).</translation>
    </message>
    <message>
        <source>The list in line %1 of the certificate has a quantity (line %2) that is not understood and may be the frequencies, so no other is taken for them; its laboratory must correct it.</source>
        <translation>Listan på rad %1 i kalibreringsbeviset har en storhet (rad %2) som inte förstås och som kan vara frekvenserna, så ingen annan tas i deras ställe; dess laboratorium måste rätta det.</translation>
    </message>
    <message>
        <source>The list in line %1 of the certificate has a quantity (line %2) that is not understood and may be the magnitudes, so no other is taken for them; its laboratory must correct it.</source>
        <translation>Listan på rad %1 i kalibreringsbeviset har en storhet (rad %2) som inte förstås och som kan vara beloppen, så ingen annan tas i deras ställe; dess laboratorium måste rätta det.</translation>
    </message>
    <message>
        <source>The list in line %1 of the certificate has a quantity (line %2) that is not understood and may be the phases, so none are taken; its laboratory must correct it.</source>
        <translation>Listan på rad %1 i kalibreringsbeviset har en storhet (rad %2) som inte förstås och som kan vara faserna, så inga tas; dess laboratorium måste rätta det.</translation>
    </message>
    <message>
        <source>An uncertainty at %1 Hz is 0, which counts as unknown; that of each magnitude and of each phase must be stated, above 0.</source>
        <translation>En osäkerhet vid %1 Hz är 0, vilket räknas som okänd; varje belopps och varje fas osäkerhet måste anges, över 0.</translation>
    </message>
    <message>
        <source>The certificate has another list (line %1) that is not understood and may be the response; name the one that is meant by its id in quantity_id.</source>
        <translation>Kalibreringsbeviset har en annan lista (rad %1) som inte förstås och som kan vara svaret; ange den som menas med dess id i quantity_id.</translation>
    </message>
    <message>
        <source>comparison.model has an uncertainty of 0, which counts as unknown; u_sensitivity, u_f0_hz and u_zeta must be stated, above 0.</source>
        <translation>comparison.model har en osäkerhet på 0, vilket räknas som okänd; u_sensitivity, u_f0_hz och u_zeta måste anges, över 0.</translation>
    </message>
    <message>
        <source>%1 cannot be reached; look whether the address is right and the network is there, or leave the time stamp out.</source>
        <translation>%1 kan inte nås; se efter om adressen är rätt och nätet finns, eller utelämna tidsstämpeln.</translation>
    </message>
    <message>
        <source>%1 did not answer within %2 s; try again later, or leave the time stamp out.</source>
        <translation>%1 svarade inte inom %2 s; försök igen senare, eller utelämna tidsstämpeln.</translation>
    </message>
    <message>
        <source>%1 answered with more than %2 bytes, which no time stamp has; look whether the address is that of a time-stamping authority (RFC 3161), or leave the time stamp out.</source>
        <translation>%1 svarade med mer än %2 byte, vilket ingen tidsstämpel har; se efter om adressen är den till en tidsstämplingstjänst (RFC 3161), eller utelämna tidsstämpeln.</translation>
    </message>
    <message>
        <source>The connection to %1 broke off before the answer was whole; try again, or leave the time stamp out.</source>
        <translation>Förbindelsen med %1 bröts innan svaret var helt; försök igen, eller utelämna tidsstämpeln.</translation>
    </message>
    <message>
        <source>%1 answered (%2), but not with a whole time stamp; look whether the address is that of a time-stamping authority (RFC 3161), or leave the time stamp out.</source>
        <translation>%1 svarade (%2), men inte med en hel tidsstämpel; se efter om adressen är den till en tidsstämplingstjänst (RFC 3161), eller utelämna tidsstämpeln.</translation>
    </message>
    <message>
        <source>The certificate of %1 is one of a server or of a time-stamping authority (extended key usage), and not for signatures of documents; take one that is.</source>
        <translation>Certifikatet för %1 är ett för en server eller en tidsstämplingstjänst (utökad nyckelanvändning) och inte för signaturer på dokument; ta ett som är det.</translation>
    </message>
    <message>
        <source>how far the result moves when all data change by a part in 10^12.</source>
        <translation>hur långt resultatet flyttar sig när alla data ändras med en del på 10^12.</translation>
    </message>
    <message>
        <source>Poles and zeros of the model in the z-plane; poles: %1, zeros: %2</source>
        <translation>Modellens poler och nollställen i z-planet; poler: %1, nollställen: %2</translation>
    </message>
    <message>
        <source>Poles and zeros of the model in the z-plane; poles: %1, zeros: %2; further out than shown: %3</source>
        <translation>Modellens poler och nollställen i z-planet; poler: %1, nollställen: %2; utanför det visade området: %3</translation>
    </message>
    <message>
        <source>Frequency response, phase; measured: from the pressure at the reference transducer, model: from the item&apos;s own onset</source>
        <translation>Frekvenssvar, fas; mätt: från trycket vid referensgivaren, modell: från objektets egen start</translation>
    </message>
    <message>
        <source>The phase without a model counts from the pressure at the reference transducer, that of the model from the item&apos;s own onset: the two may differ in proportion to the frequency.</source>
        <translation>Fasen utan modell räknas från trycket vid referensgivaren, modellens från objektets egen start: de två kan skilja sig i proportion till frekvensen.</translation>
    </message>
    <message>
        <source>%1 of %2 checks deviate, the first in the step &quot;%M1&quot; (%M2: expected %3, found %4); do not calibrate with this installation before it is explained.</source>
        <translation>%1 av %2 kontroller avviker, den första i steget &quot;%M1&quot; (%M2: väntat %3, funnet %4); kalibrera inte med denna installation innan det är förklarat.</translation>
    </message>
    <message>
        <source>captures</source>
        <translation>registreringar</translation>
    </message>
    <message>
        <source>expected shock</source>
        <translation>väntad stötvåg</translation>
    </message>
    <message>
        <source>window</source>
        <translation>fönster</translation>
    </message>
    <message>
        <source>spectrum</source>
        <translation>spektrum</translation>
    </message>
    <message>
        <source>components</source>
        <translation>komponenter</translation>
    </message>
    <message>
        <source>model input</source>
        <translation>modellens indata</translation>
    </message>
    <message>
        <source>decomposition</source>
        <translation>uppdelning</translation>
    </message>
    <message>
        <source>model</source>
        <translation>modell</translation>
    </message>
    <message>
        <source>shock</source>
        <translation>stötvåg</translation>
    </message>
    <message>
        <source>reference transducer</source>
        <translation>referensgivare</translation>
    </message>
    <message>
        <source>response</source>
        <translation>svar</translation>
    </message>
    <message>
        <source>checks</source>
        <translation>kontroller</translation>
    </message>
    <message>
        <source>model assessment</source>
        <translation>bedömning av modellen</translation>
    </message>
    <message>
        <source>uncertainty</source>
        <translation>osäkerhet</translation>
    </message>
    <message>
        <source>comparison</source>
        <translation>jämförelse</translation>
    </message>
    <message>
        <source>evidence</source>
        <translation>underlag för ordningen</translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation>Monte Carlo</translation>
    </message>
    <message>
        <source>Monte Carlo of the chain</source>
        <translation>Monte Carlo för hela kedjan</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>läsning</translation>
    </message>
    <message>
        <source>correction</source>
        <translation>korrektion</translation>
    </message>
    <message>
        <source>certificate</source>
        <translation>bevis</translation>
    </message>
    <message>
        <source>coverage</source>
        <translation>täckning</translation>
    </message>
    <message>
        <source>The DCC names no country of the laboratory (it has ZZ): there is no code of ISO 3166-1, as SE, in its country field and none in its address; type it into the fields of the certificate or into the laboratory&apos;s card.</source>
        <translation>DCC anger inget land för laboratoriet (där står ZZ): varken dess landsfält eller dess adress har en kod enligt ISO 3166-1, som SE; skriv den i bevisets fält eller på laboratoriets kort.</translation>
    </message>
    <message>
        <source>The DCC names no country of the customer (it has ZZ): there is no code of ISO 3166-1, as SE, in its country field and none in its address; type it into the fields of the certificate or into the customer&apos;s card.</source>
        <translation>DCC anger inget land för kunden (där står ZZ): varken dess landsfält eller dess adress har en kod enligt ISO 3166-1, som SE; skriv den i bevisets fält eller på kundens kort.</translation>
    </message>
    <message>
        <source>A country is named by its two letters of ISO 3166-1; type the countries of laboratory and customer into the fields of the certificate.</source>
        <translation>Ett land anges med sina två bokstäver enligt ISO 3166-1; skriv laboratoriets och kundens land i bevisets fält.</translation>
    </message>
    <message>
        <source>There is no registry %1; name its file or server.</source>
        <translation>Det finns inget register %1; ange dess fil eller server.</translation>
    </message>
    <message>
        <source>Shot %1: the level of the reference transducer %2 moves by +-%3 % of its step over a band that is to be level; its step, and so the sensitivity, is wrong by as much or more. Look for a drift of its zero, an amplifier that lets no constant pressure through, or heat.</source>
        <translation>Skott %1: referensgivaren %2:s nivå rör sig ±%3 % av sitt steg över ett band som ska vara plant; dess steg, och därmed känsligheten, är fel med minst så mycket. Leta efter en nollpunkt som driver, en förstärkare som inte släpper igenom konstant tryck, eller värme.</translation>
    </message>
    <message>
        <source>Shot %1: the step of the reference transducer %2 is negative (%3), so that the phase is turned by 180 degrees; set its polarity to -1 if it is inverted.</source>
        <translation>Skott %1: referensgivaren %2:s steg är negativt (%3), så att fasen är vriden 180 grader; sätt dess polaritet till -1 om den är inverterad.</translation>
    </message>
    <message>
        <source>Shot %1: %2 samples in a row of the reference transducer %3 are equal and the extreme of the window; its record may be saturated there.</source>
        <translation>Skott %1: %2 samplingar i rad från referensgivaren %3 är lika och fönstrets extremvärde; dess registrering kan vara mättad där.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos;: the file states no unit, so its numbers are read as %2, as the name ends. Give the channel&apos;s unit if they are something else.</source>
        <translation>Kanal &apos;%1&apos;: filen anger ingen enhet, så talen läses som %2, som namnet slutar. Ange kanalens enhet om de är något annat.</translation>
    </message>
    <message>
        <source>Shot %1: before its start the record is not quiet: %2 before it, it moves by %3 % of the step (standard deviation), elsewhere by %4 %. What moves it is likely in the response, too, and may be taken for the sensor&apos;s own: a wave in the wall of the tube, a disturbance, or a record that begins behind its step.</source>
        <translation>Skott %1: registreringen är inte stilla före sin start: %2 före den rör den sig med %3 % av steget (standardavvikelse), på andra ställen med %4 %. Det som rör den finns troligen också i svaret och kan tas för givarens eget: en våg i rörets vägg, en störning, eller en registrering som börjar efter sitt steg.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: each value stands %3 times in a row, so the record was measured at %4 and written at %5; S(f), band edges and rise time have the repetition in them. Export it at the rate at which it was measured.</source>
        <translation>Skott %1, kanal %2: varje värde står %3 gånger i rad, så registreringen mättes med %4 och skrevs med %5; S(f), bandgränser och stigtid innehåller upprepningen. Exportera den med den samplingsfrekvens som den mättes med.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: between every %3 samples the others lie on straight lines, so the record was measured at %4 and written at %5; S(f), band edges and rise time have the interpolation in them. Export it at the rate at which it was measured.</source>
        <translation>Skott %1, kanal %2: mellan var %3:e sampel ligger de övriga på räta linjer, så registreringen mättes med %4 och skrevs med %5; S(f), bandgränser och stigtid innehåller interpolationen. Exportera den med den samplingsfrekvens som den mättes med.</translation>
    </message>
    <message>
        <source>The phase against the reference transducer differs from that of the sensor&apos;s own model as by a delay of %1 (U = %2, k = 2): the step seems to reach the transducer %3 after the sensor, and comparison.delay_s states %4. Check its sign and value, and the phases of the transducer.</source>
        <translation>Fasen mot referensgivaren skiljer sig från den som givarens egen modell har, som av en fördröjning på %1 (U = %2, k = 2): steget tycks nå referensgivaren %3 efter givaren, och comparison.delay_s anger %4. Kontrollera dess tecken och värde, och referensgivarens faser.</translation>
    </message>
    <message>
        <source>The file of %1 ends at %2, and the sensor is flat up to %3: less than a tenth of that is stated. Check that its frequencies are in Hz, or give a file that covers the band.</source>
        <translation>Filen för %1 slutar vid %2, och givaren är jämn upp till %3: mindre än en tiondel av det anges. Kontrollera att frekvenserna är i Hz, eller ange en fil som täcker bandet.</translation>
    </message>
    <message>
        <source>The file of %1 states a chain that is off by %2 % at %3, where the records show chain and sensor together within 10 % of flat (up to %4): S(f) would be off by what the file says. Check that its frequencies are in Hz and its magnitudes those of this chain.</source>
        <translation>Filen för %1 anger en mätkedja som är %2 % fel vid %3, där registreringarna visar kedja och givare tillsammans inom 10 % från jämn (upp till %4): S(f) skulle bli fel med det som filen säger. Kontrollera att frekvenserna är i Hz och att beloppen är den här kedjans.</translation>
    </message>
    <message>
        <source>The drift of %1 % behind the step dies out twice as fast as the sensor rings (time constant %2): a sensor or an amplifier whose gain depends on the level makes that of its own ringing, and then the sensitivity, S(f) and overshoot are wrong by up to as much. Compare shots of different levels, or with the static sensitivity.</source>
        <translation>Driften på %1 % efter steget dör ut dubbelt så snabbt som givaren ringer (tidskonstant %2): en givare eller förstärkare vars förstärkning beror på nivån gör sådant av sin egen ringning, och då är känsligheten, S(f) och översvängen fel med upp till lika mycket. Jämför skott av olika nivåer, eller med den statiska känsligheten.</translation>
    </message>
    <message>
        <source>p1 = %1 is typed, and the capture has recorded %2 in this shot: with that the pressure step would be %3 % different. The typed one is used; correct it, or leave it out (shock.p1_pa).</source>
        <translation>p1 = %1 är inskrivet, och filen har registrerat %2 i det här skottet: med det skulle trycksteget bli %3 % annorlunda. Det inskrivna används; rätta det, eller utelämna det (shock.p1_pa).</translation>
    </message>
    <message>
        <source>T1 = %1 is typed, and the capture has recorded %2 in this shot: with that the pressure step would be %3 % different. The typed one is used; correct it, or leave it out (shock.t1_k).</source>
        <translation>T1 = %1 är inskrivet, och filen har registrerat %2 i det här skottet: med det skulle trycksteget bli %3 % annorlunda. Det inskrivna används; rätta det, eller utelämna det (shock.t1_k).</translation>
    </message>
    <message>
        <source>Shot %1: before its start the record lies %2 % of the step away from the baseline that it is counted from; the step and the sensitivity are wrong by as much. Let the baseline be found, or place it just before the start.</source>
        <translation>Skott %1: före sin start ligger registreringen %2 % av steget från den baslinje som den räknas från; steget och känsligheten är fel med lika mycket. Låt baslinjen sökas, eller lägg den strax före starten.</translation>
    </message>
    <message>
        <source>Shot %1: at the typed start the record has left its baseline by %2 % of the step already: the response began before. Move the start, or let it be found.</source>
        <translation>Skott %1: vid den inskrivna starten har registreringen redan lämnat sin baslinje med %2 % av steget: svaret började tidigare. Flytta starten, eller låt den sökas.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: before the pressure the record drifts by %3 per ms; if it goes on so, the pressure at the end is off by %4, and its U there is %5. Take the drift off the recording, use an amplifier that does not drift, or correct a shorter stretch (--window).</source>
        <translation>Skott %1, kanal %2: före trycket driver registreringen med %3 per ms; fortsätter den så är trycket i slutet %4 fel, och dess U är där %5. Ta bort driften ur registreringen, använd en förstärkare som inte driver, eller korrigera ett kortare stycke (--window).</translation>
    </message>
    <message>
        <source>The records begin as those of a second-order sensor (%1, damping %2) behind a pressure that rises over %3 (u = %4), and no front is stated: state its duration, or look for a faster part of sensor and amplifier.</source>
        <translation>Registreringarna börjar som hos en givare av andra ordningen (%1, dämpning %2) bakom ett tryck som stiger under %3 (u = %4), och ingen front är angiven: ange dess varaktighet, eller leta efter en snabbare del i givare och förstärkare.</translation>
    </message>
    <message>
        <source>Without the first %1 of the records the main resonance has %2 % of frequency and %3 % of damping more, beyond what noise allows: the excitation lasts into them, as a hammer&apos;s contact does (leave that stretch out), or a faster part is missing in the model.</source>
        <translation>Utan registreringarnas första %1 har huvudresonansen %2 % högre frekvens och %3 % högre dämpning, mer än bruset tillåter: anslaget varar in i dem, som en hammares kontakt gör (utelämna den sträckan), eller så saknar modellen en snabbare del.</translation>
    </message>
    <message>
        <source>With p1 = %1 the shock implies a driver pressure of %2, a fifth or less of the %3 that are stated (all absolute): p1 is a gauge pressure or in another unit, or the driver gas is another; the step goes with p1.</source>
        <translation>Med p1 = %1 kräver stötvågen ett drivtryck på %2, högst en femtedel av de %3 som är angivna (alla absoluta): p1 är ett övertryck eller i en annan enhet, eller drivgasen är en annan; steget följer p1.</translation>
    </message>
    <message>
        <source>The resonance at %1 has no uncertainty, because the model was not refined: without it no resonance is a result. Take another order, or leave out of the window what is no free decay.</source>
        <translation>Resonansen vid %1 har ingen osäkerhet, eftersom modellen inte förfinades: utan den är ingen resonans ett resultat. Ta en annan ordning, eller lämna utanför fönstret det som inte är fritt avklingande.</translation>
    </message>
    <message>
        <source>%M1 at %1</source>
        <translation>%M1 vid %1</translation>
    </message>
    <message>
        <source>%M1: Monte Carlo gives U = %1, the law of propagation only %2: use Monte Carlo. The law gives too little for %3 of %4 values and rows; their intervals by Monte Carlo are in monte_carlo of results.json.</source>
        <translation>%M1: Monte Carlo ger U = %1, fortplantningslagen bara %2: använd Monte Carlo. Lagen ger för lite för %3 av %4 värden och rader; deras intervall enligt Monte Carlo står i monte_carlo i results.json.</translation>
    </message>
    <message>
        <source>%M1: Monte Carlo gives U = %1, the law of propagation only %2, for a front of any duration up to 100 ns; it is so for %3 of %4 values and rows. Nobody has stated how long the front lasts: state shock.front_duration_s, or take these intervals from monte_carlo of results.json.</source>
        <translation>%M1: Monte Carlo ger U = %1, fortplantningslagen bara %2, för en front av godtycklig varaktighet upp till 100 ns; så är det för %3 av %4 värden och rader. Ingen har angett hur länge fronten varar: ange shock.front_duration_s, eller ta dessa intervall från monte_carlo i results.json.</translation>
    </message>
    <message>
        <source>%M1: Monte Carlo gives U = %1, the law of propagation %2. The law gives more than is needed for %3 of %4 values and rows: what is stated is safe, Monte Carlo would state less.</source>
        <translation>%M1: Monte Carlo ger U = %1, fortplantningslagen %2. Lagen ger mer än vad som behövs för %3 av %4 värden och rader: det som anges är på den säkra sidan, Monte Carlo skulle ange mindre.</translation>
    </message>
    <message>
        <source>%M1: %1 refits of simulated records are %2 times as uncertain as the model&apos;s covariance has it, and %3 of that u apart: the stated uncertainties of the model&apos;s values do not hold. Choose a lower order, or record with less noise.</source>
        <translation>%M1: %1 nya anpassningar till simulerade registreringar är %2 gånger så osäkra som modellens kovarians anger, och skiljer sig med %3 av detta u: de angivna osäkerheterna för modellens värden håller inte. Välj en lägre ordning eller spela in med mindre brus.</translation>
    </message>
    <message>
        <source>attenuation along the tube</source>
        <translation>dämpning längs röret</translation>
    </message>
    <message>
        <source>noise of the level</source>
        <translation>nivåns brus</translation>
    </message>
    <message>
        <source>scatter of the shots</source>
        <translation>skottens spridning</translation>
    </message>
    <message>
        <source>scatter of the velocity</source>
        <translation>hastighetens spridning</translation>
    </message>
    <message>
        <source>response of the measuring chain</source>
        <translation>mätkedjans frekvenssvar</translation>
    </message>
    <message>
        <source>certificate of the reference transducer</source>
        <translation>referensgivarens bevis</translation>
    </message>
    <message>
        <source>%1 % of the variance of the sensitivity come from one source, %M1: to know it better is what makes the uncertainty smaller.</source>
        <translation>%1 % av känslighetens varians kommer från en källa, %M1: att känna den bättre är vad som gör osäkerheten mindre.</translation>
    </message>
    <message>
        <source>Shot %1: the record takes %2 from the typed start to a quarter of the step and just %3 from there to the half, so the response begins later; the model takes the quiet stretch for a part of it. Move the start, or let it be found.</source>
        <translation>Skott %1: registreringen behöver %2 från den inskrivna starten till en fjärdedel av steget och bara %3 därifrån till hälften, så svaret börjar senare; modellen tar den lugna sträckan för en del av det. Flytta starten, eller låt den sökas.</translation>
    </message>
    <message>
        <source>what the mounting may add to the level decides it</source>
        <translation>det som monteringen kan lägga till nivån avgör det</translation>
    </message>
    <message>
        <source>The calibration of the reference transducer begins at %1, and the level of the step lies below %2: its sensitivity may be another there by %3 %, as its rows show, which is in the uncertainty. Have it calibrated down to %2, or state the transducer as a model.</source>
        <translation>Referensgivarens kalibrering börjar vid %1, och stegets nivå ligger under %2: där kan känsligheten vara en annan med %3 %, som dess rader visar, vilket ingår i osäkerheten. Låt kalibrera den ned till %2, eller ange givaren som en modell.</translation>
    </message>
    <message>
        <source>The calibration of the reference transducer is one row at %1, and the level of the step lies below %2: what its sensitivity is there is not known, so the step has no uncertainty. Have it calibrated down to %2, or state the transducer as a model.</source>
        <translation>Referensgivarens kalibrering är en rad vid %1, och stegets nivå ligger under %2: vad känsligheten är där är inte känt, så steget har ingen osäkerhet. Låt kalibrera den ned till %2, eller ange givaren som en modell.</translation>
    </message>
    <message>
        <source>What the uncertainty of the sensitivity is made of</source>
        <translation>Vad känslighetens osäkerhet består av</translation>
    </message>
    <message>
        <source>Contribution (k = 1)</source>
        <translation>Bidrag (k = 1)</translation>
    </message>
    <message>
        <source>all others together</source>
        <translation>alla övriga tillsammans</translation>
    </message>
    <message>
        <source>U of the step is its expanded uncertainty with the coverage factor k of the same line, for a coverage probability of about %1 %: that of the reference transducer&apos;s certificate, its chain and the noise of its level. It is contained in the uncertainty of the sensitivity.</source>
        <translation>Stegets U är dess utvidgade osäkerhet med täckningsfaktorn k på samma rad, för en täckningssannolikhet på ungefär %1 %: osäkerheten hos referensgivarens kalibreringsbevis, hos dess mätkedja och bruset hos dess nivå. Den ingår i känslighetens osäkerhet.</translation>
    </message>
    <message>
        <source>U of the step is its expanded uncertainty with the coverage factor k of the same line, for a coverage probability of about %1 %. It follows from the uncertainties of the shock velocity, the initial pressure and temperature and the gas, and holds for an ideal shock tube. It is contained in the uncertainties of the sensitivity and of the magnitudes of the frequency response.</source>
        <translation>U för steget är dess utvidgade osäkerhet med täckningsfaktorn k på samma rad, för en täckningssannolikhet på ungefär %1 %. Den följer av osäkerheterna för stötvågens hastighet, begynnelsetrycket, begynnelsetemperaturen och gasen och gäller för ett idealt stötrör. Den ingår i osäkerheterna för känsligheten och för frekvenssvarets belopp.</translation>
    </message>
    <message>
        <source>The initial pressure is absolute: the item was under it before the step.</source>
        <translation>Begynnelsetrycket är absolut: givaren stod under det före steget.</translation>
    </message>
    <message>
        <source>Gas before the item</source>
        <translation>Gas framför givaren</translation>
    </message>
    <message>
        <source>%V1, ratio of specific heats %L2, molar mass %L3</source>
        <translation>%V1, kvot av specifika värmen %L2, molmassa %L3</translation>
    </message>
    <message>
        <source>one over the length of the shortest window</source>
        <translation>ett genom det kortaste fönstrets längd</translation>
    </message>
    <message>
        <source>where the noise begins to exceed 10 % of the magnitude</source>
        <translation>där bruset börjar överskrida 10 % av beloppet</translation>
    </message>
    <message>
        <source>0.4 of the lowest sample rate</source>
        <translation>0,4 av den lägsta samplingsfrekvensen</translation>
    </message>
    <message>
        <source>half the sample rate of the model</source>
        <translation>halva modellens samplingsfrekvens</translation>
    </message>
    <message>
        <source>where the calibration of the reference transducer ends</source>
        <translation>där referensgivarens kalibrering slutar</translation>
    </message>
    <message>
        <source>where the stated response of amplifier and converter ends</source>
        <translation>där det angivna svaret hos förstärkare och omvandlare slutar</translation>
    </message>
    <message>
        <source>The lower limit of the band is %M1, the upper limit %M2.</source>
        <translation>Bandets undre gräns är %M1, dess övre gräns %M2.</translation>
    </message>
    <message>
        <source>Frequencies are settings, without an uncertainty. The model&apos;s values have the digits of the wider of their uncertainty and the measured value&apos;s; they end at half the sample rate of the model. A dash means that the value, or its complete uncertainty, was not determined.</source>
        <translation>Frekvenser är inställningar, utan osäkerhet. Modellens värden har de siffror som den större av deras och det uppmätta värdets osäkerhet medger; de slutar vid modellens halva samplingsfrekvens. Ett streck betyder att värdet, eller dess fullständiga osäkerhet, inte har bestämts.</translation>
    </message>
    <message>
        <source>U = k u is the expanded uncertainty, u the complete standard uncertainty, for a coverage probability of about 95 % (GUM, JCGM 100). What it is made of stands in the section &quot;Results in detail&quot;.</source>
        <translation>U = k u är den utvidgade osäkerheten, u den fullständiga standardosäkerheten, för en täckningssannolikhet på ungefär 95 % (GUM, JCGM 100). Vad den består av står i avsnittet ”Resultat i detalj”.</translation>
    </message>
    <message>
        <source>Of those quantities whose interval by Monte Carlo stands in the section &quot;Results in detail&quot;, that interval is the one to use: it reaches beyond U to one side.</source>
        <translation>För de storheter vars intervall enligt Monte Carlo står i avsnittet ”Resultat i detalj” är det intervallet som ska användas: det når utanför U åt ett håll.</translation>
    </message>
    <message>
        <source>not divided out: frequency response, poles and what follows from them are of sensor and chain together</source>
        <translation>inte bortdelat: frekvenssvar, poler och vad som följer av dem är givarens och mätkedjans tillsammans</translation>
    </message>
    <message>
        <source>No certificate of a reference is named for %1, so the results are not traceable; state it in uncertainty.budget (&quot;certificate&quot;, &quot;due&quot;), of a reference transducer in comparison.certificate, of a chain in chain.certificate.</source>
        <translation>Inget certifikat för en referens är angivet för %1, så resultaten är inte spårbara; ange det i uncertainty.budget (&quot;certificate&quot;, &quot;due&quot;), för en referensgivare i comparison.certificate, för en mätkedja i chain.certificate.</translation>
    </message>
</context>
<context>
    <name>dyncal::ArrivalPanel</name>
    <message>
        <source>Arrival of the shock</source>
        <translation>Stötvågens ankomst</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Givare</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Change the arrival sensor</source>
        <translation>Ändra ankomstgivaren</translation>
    </message>
    <message>
        <source>Distance to end wall</source>
        <translation>Avstånd till ändvägg</translation>
    </message>
    <message>
        <source>u (distance)</source>
        <translation>u (avstånd)</translation>
    </message>
    <message>
        <source>Change u of the distance</source>
        <translation>Ändra u för avståndet</translation>
    </message>
    <message>
        <source>Arrival</source>
        <translation>Ankomst</translation>
    </message>
    <message>
        <source>u (arrival)</source>
        <translation>u (ankomst)</translation>
    </message>
    <message>
        <source>u (delay)</source>
        <translation>u (fördröjning)</translation>
    </message>
    <message>
        <source>Delay of the sensor</source>
        <translation>Givarens fördröjning</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>okänd</translation>
    </message>
    <message>
        <source>Change the delay</source>
        <translation>Ändra fördröjningen</translation>
    </message>
    <message>
        <source>Add a sensor</source>
        <translation>Lägg till en givare</translation>
    </message>
    <message>
        <source>Remove this sensor</source>
        <translation>Ta bort denna givare</translation>
    </message>
    <message>
        <source>Add an arrival sensor</source>
        <translation>Lägg till en ankomstgivare</translation>
    </message>
    <message>
        <source>Remove an arrival sensor</source>
        <translation>Ta bort en ankomstgivare</translation>
    </message>
    <message>
        <source>Move an arrival</source>
        <translation>Flytta en ankomst</translation>
    </message>
    <message>
        <source>Find the arrival</source>
        <translation>Sök ankomsten</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>arrival</source>
        <translation>ankomst</translation>
    </message>
</context>
<context>
    <name>dyncal::AutoBox</name>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>Ticked: the program&apos;s rule decides. Typing a value unticks it.</source>
        <translation>Ikryssad: programmets regel avgör. Ett inskrivet värde tar bort krysset.</translation>
    </message>
    <message>
        <source>%1: automatic</source>
        <translation>%1: automatiskt</translation>
    </message>
</context>
<context>
    <name>dyncal::Banner</name>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Återställ</translation>
    </message>
    <message>
        <source>L&amp;ocate recordings...</source>
        <translation>Leta &amp;upp registreringar...</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>Ån&amp;gra</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Kasta</translation>
    </message>
    <message>
        <source>&amp;Not now</source>
        <translation>&amp;Inte nu</translation>
    </message>
    <message>
        <source>It is offered again at the next start</source>
        <translation>Det erbjuds igen vid nästa start</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Stäng</translation>
    </message>
    <message>
        <source>Read a&amp;gain</source>
        <translation>Läs &amp;om</translation>
    </message>
</context>
<context>
    <name>dyncal::BatchModel</name>
    <message>
        <source>Sensor</source>
        <translation>Givare</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Läge</translation>
    </message>
    <message>
        <source>f₀ ± U</source>
        <translation>f₀ ± U</translation>
    </message>
    <message>
        <source>ζ ± U</source>
        <translation>ζ ± U</translation>
    </message>
    <message>
        <source>Sensitivity ± U</source>
        <translation>Känslighet ± U</translation>
    </message>
    <message>
        <source>Worst finding</source>
        <translation>Värsta iakttagelse</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Skäl</translation>
    </message>
</context>
<context>
    <name>dyncal::BatchPlanDialog</name>
    <message>
        <source>&amp;Every recording is a sensor of its own</source>
        <translation>&amp;Varje registrering är en egen givare</translation>
    </message>
    <message>
        <source>Plan a batch</source>
        <translation>Planera en sats</translation>
    </message>
    <message>
        <source>Every folder below the folder of recordings that holds recordings is a sensor. A recipe.json in it wins over the common recipe. The results go beside the plan.</source>
        <translation>Varje mapp under registreringarnas mapp som innehåller registreringar är en givare. En recipe.json i den gäller före det gemensamma receptet. Resultaten läggs bredvid planen.</translation>
    </message>
    <message>
        <source>Make the &amp;plan</source>
        <translation>Gör &amp;planen</translation>
    </message>
    <message>
        <source>&amp;Folder of recordings</source>
        <translation>Registreringarnas &amp;mapp</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>behövs</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>Registreringarnas mapp</translation>
    </message>
    <message>
        <source>&amp;Recipe</source>
        <translation>&amp;Recept</translation>
    </message>
    <message>
        <source>none: the defaults</source>
        <translation>inget: standardvärdena</translation>
    </message>
    <message>
        <source>Common recipe</source>
        <translation>Gemensamt recept</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>Profile of the laboratory</source>
        <translation>Laboratoriets profil</translation>
    </message>
    <message>
        <source>P&amp;lan</source>
        <translation>P&amp;lan</translation>
    </message>
    <message>
        <source>needed, outside the folder</source>
        <translation>behövs, utanför mappen</translation>
    </message>
    <message>
        <source>Plan to write</source>
        <translation>Plan att skriva</translation>
    </message>
    <message>
        <source>Plans (*.jsonl)</source>
        <translation>Planer (*.jsonl)</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Välj...</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>Välj: %1</translation>
    </message>
    <message>
        <source>Pr&amp;ofile of the laboratory</source>
        <translation>Lab&amp;oratoriets profil</translation>
    </message>
</context>
<context>
    <name>dyncal::BatchTable</name>
    <message>
        <source>Sensors of the batch</source>
        <translation>Satsens givare</translation>
    </message>
    <message>
        <source>Sensor, finding or reason</source>
        <translation>Givare, iakttagelse eller skäl</translation>
    </message>
    <message>
        <source>Show only sensors whose name, finding or reason holds this</source>
        <translation>Visa bara givare vars namn, iakttagelse eller skäl innehåller detta</translation>
    </message>
    <message>
        <source>Show only sensors of this state</source>
        <translation>Visa bara givare i detta läge</translation>
    </message>
    <message>
        <source>All states</source>
        <translation>Alla lägen</translation>
    </message>
</context>
<context>
    <name>dyncal::BatchWindow</name>
    <message>
        <source>The run was stopped; what is complete is kept.</source>
        <translation>Körningen stoppades; det som är klart är kvar.</translation>
    </message>
    <message>
        <source>The run has ended.</source>
        <translation>Körningen är slut.</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Sats</translation>
    </message>
    <message>
        <source>&amp;Open plan...</source>
        <translation>&amp;Öppna plan...</translation>
    </message>
    <message>
        <source>A plan made here or by dyncal batch plan</source>
        <translation>En plan som gjorts här eller med dyncal batch plan</translation>
    </message>
    <message>
        <source>&amp;New plan...</source>
        <translation>&amp;Ny plan...</translation>
    </message>
    <message>
        <source>List the sensors below a folder, with their recipe</source>
        <translation>Lista givarna under en mapp, med deras recept</translation>
    </message>
    <message>
        <source>Sensors at a &amp;time</source>
        <translation>Givare &amp;åt gången</translation>
    </message>
    <message>
        <source>How many sensors are computed at a time, each on one processor</source>
        <translation>Hur många givare som beräknas åt gången, var och en på en processor</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Kör</translation>
    </message>
    <message>
        <source>Compute what is not complete yet</source>
        <translation>Beräkna det som inte är klart än</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>St&amp;oppa</translation>
    </message>
    <message>
        <source>Stop in good order; what is complete is kept</source>
        <translation>Stoppa i god ordning; det som är klart är kvar</translation>
    </message>
    <message>
        <source>Open its recordings and recipe in the main window</source>
        <translation>Öppna dess registreringar och recept i huvudfönstret</translation>
    </message>
    <message>
        <source>also if sensors are &amp;missing</source>
        <translation>även om givare &amp;saknas</translation>
    </message>
    <message>
        <source>Write s&amp;ummary...</source>
        <translation>Skriv sa&amp;mmanställning...</translation>
    </message>
    <message>
        <source>One row for each sensor, in the order of the plan, as CSV</source>
        <translation>En rad för varje givare, i planens ordning, som CSV</translation>
    </message>
    <message>
        <source>Progress of the batch</source>
        <translation>Satsens förlopp</translation>
    </message>
    <message>
        <source>Open plan</source>
        <translation>Öppna plan</translation>
    </message>
    <message>
        <source>Plans (*.jsonl)</source>
        <translation>Planer (*.jsonl)</translation>
    </message>
    <message>
        <source>The plan is made.</source>
        <translation>Planen är gjord.</translation>
    </message>
    <message>
        <source>The sensors are being listed, and their recordings read for their hashes.</source>
        <translation>Givarna listas, och deras registreringar läses för hashvärdena.</translation>
    </message>
    <message>
        <source>The run is being stopped.</source>
        <translation>Körningen stoppas.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Stoppat.</translation>
    </message>
    <message>
        <source>Summary to write</source>
        <translation>Sammanställning att skriva</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Skrivet: %1</translation>
    </message>
    <message>
        <source>No plan is open.</source>
        <translation>Ingen plan är öppen.</translation>
    </message>
    <message>
        <source>O&amp;pen sensor</source>
        <translation>Öppna &amp;givare</translation>
    </message>
</context>
<context>
    <name>dyncal::CalendarButton</name>
    <message>
        <source>Choose the day in a calendar</source>
        <translation>Välj dagen i en kalender</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>I dag</translation>
    </message>
    <message>
        <source>No date</source>
        <translation>Inget datum</translation>
    </message>
</context>
<context>
    <name>dyncal::CandidateCard</name>
    <message>
        <source>Choose this order</source>
        <translation>Välj denna ordning</translation>
    </message>
    <message>
        <source>n = %1</source>
        <translation>n = %1</translation>
    </message>
    <message>
        <source>, adopted</source>
        <translation>, antagen</translation>
    </message>
    <message>
        <source>, chosen</source>
        <translation>, vald</translation>
    </message>
    <message>
        <source>Choose order %1</source>
        <translation>Välj ordning %1</translation>
    </message>
    <message>
        <source>Take order %1 out of the comparison</source>
        <translation>Ta ordning %1 ur jämförelsen</translation>
    </message>
    <message>
        <source>Draw order %1 in the plots</source>
        <translation>Rita ordning %1 i diagrammen</translation>
    </message>
    <message>
        <source>draw</source>
        <translation>rita</translation>
    </message>
    <message>
        <source>At most %1 are drawn at once.</source>
        <translation>Högst %1 ritas samtidigt.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Anmärkning</translation>
    </message>
    <message>
        <source>Kept with the order in the project; shown in the comparison</source>
        <translation>Sparas med ordningen i projektet; visas i jämförelsen</translation>
    </message>
    <message>
        <source>Note on order %1</source>
        <translation>Anmärkning till ordning %1</translation>
    </message>
</context>
<context>
    <name>dyncal::CandidateCards</name>
    <message>
        <source>Pinned orders</source>
        <translation>Fästa ordningar</translation>
    </message>
    <message>
        <source>Space pins the order on show, to compare it with others; Enter adopts it.</source>
        <translation>Blanksteg fäster den visade ordningen för jämförelse med andra; Retur antar den.</translation>
    </message>
</context>
<context>
    <name>dyncal::CandidateTable</name>
    <message>
        <source>Comparison of the pinned orders</source>
        <translation>Jämförelse av de fästa ordningarna</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordning</translation>
    </message>
    <message>
        <source>FIT</source>
        <translation>FIT</translation>
    </message>
    <message>
        <source>Attainable</source>
        <translation>Uppnåeligt</translation>
    </message>
    <message>
        <source>f₀</source>
        <translation>f₀</translation>
    </message>
    <message>
        <source>ζ</source>
        <translation>ζ</translation>
    </message>
    <message>
        <source>Unstable</source>
        <translation>Instabila</translation>
    </message>
    <message>
        <source>Nyquist</source>
        <translation>Nyquist</translation>
    </message>
    <message>
        <source>White, p</source>
        <translation>Vit, p</translation>
    </message>
    <message>
        <source>BIC</source>
        <translation>BIC</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Anmärkning</translation>
    </message>
    <message>
        <source>adopted</source>
        <translation>antagen</translation>
    </message>
    <message>
        <source>adopted, </source>
        <translation>antagen, </translation>
    </message>
</context>
<context>
    <name>dyncal::CapabilityPanel</name>
    <message>
        <source>Least U of the laboratory (CMC)</source>
        <translation>Laboratoriets minsta U (CMC)</translation>
    </message>
    <message>
        <source>Entries of the CMC</source>
        <translation>CMC:ns poster</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Storhet</translation>
    </message>
    <message>
        <source>Counted in</source>
        <translation>Räknas i</translation>
    </message>
    <message>
        <source>percent of the value</source>
        <translation>procent av värdet</translation>
    </message>
    <message>
        <source>the value&apos;s unit</source>
        <translation>värdets enhet</translation>
    </message>
    <message>
        <source>Least U</source>
        <translation>Minsta U</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Från</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Till</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>behövs</translation>
    </message>
    <message>
        <source>any</source>
        <translation>alla</translation>
    </message>
    <message>
        <source>Add an entry of the CMC</source>
        <translation>Lägg till en post i CMC</translation>
    </message>
    <message>
        <source>Change an entry of the CMC</source>
        <translation>Ändra en post i CMC</translation>
    </message>
    <message>
        <source>Remove an entry of the CMC</source>
        <translation>Ta bort en post ur CMC</translation>
    </message>
</context>
<context>
    <name>dyncal::CaptureImport</name>
    <message>
        <source>Add recordings</source>
        <translation>Lägg till registreringar</translation>
    </message>
    <message>
        <source>Change the import settings</source>
        <translation>Ändra importinställningarna</translation>
    </message>
    <message>
        <source>Reading recordings</source>
        <translation>Läser registreringar</translation>
    </message>
    <message numerus="yes">
        <source>%n shot(s) read</source>
        <translation>
            <numerusform>%n skott läst</numerusform>
            <numerusform>%n skott lästa</numerusform>
        </translation>
    </message>
    <message>
        <source>Read recordings again</source>
        <translation>Läs om registreringarna</translation>
    </message>
</context>
<context>
    <name>dyncal::CapturesPage</name>
    <message>
        <source>Captures</source>
        <translation>Registreringar</translation>
    </message>
    <message>
        <source>Add the recordings of one sensor and say what each channel is.</source>
        <translation>Lägg till registreringarna av en givare och ange vad varje kanal är.</translation>
    </message>
    <message>
        <source>Recordings: %1</source>
        <translation>Registreringar: %1</translation>
    </message>
    <message>
        <source>Shots</source>
        <translation>Skott</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Skott</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivå</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Frekvens</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Sampel</translation>
    </message>
    <message>
        <source>DUT unit</source>
        <translation>DUT-enhet</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>Add captures...</source>
        <translation>Lägg till registreringar...</translation>
    </message>
    <message>
        <source>Remove selected shot</source>
        <translation>Ta bort valt skott</translation>
    </message>
    <message>
        <source>Channel roles (all shots)</source>
        <translation>Kanalroller (alla skott)</translation>
    </message>
    <message>
        <source>Sensor under test</source>
        <translation>Givare under provning</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Enhet</translation>
    </message>
    <message>
        <source>Change the DUT&apos;s unit</source>
        <translation>Ändra DUT:s enhet</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Change the DUT&apos;s factor</source>
        <translation>Ändra DUT:s faktor</translation>
    </message>
    <message>
        <source>Inverted polarity</source>
        <translation>Inverterad polaritet</translation>
    </message>
    <message>
        <source>Change the DUT&apos;s polarity</source>
        <translation>Ändra DUT:s polaritet</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Tryck</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>som registrerat</translation>
    </message>
    <message>
        <source>gauge</source>
        <translation>övertryck</translation>
    </message>
    <message>
        <source>absolute</source>
        <translation>absolut</translation>
    </message>
    <message>
        <source>Change gauge or absolute</source>
        <translation>Ändra övertryck eller absolut</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>Samplingsfrekvens</translation>
    </message>
    <message>
        <source>Change the sample rate</source>
        <translation>Ändra samplingsfrekvensen</translation>
    </message>
    <message>
        <source>no DUT</source>
        <translation>ingen DUT</translation>
    </message>
    <message>
        <source>Excluded: %1</source>
        <translation>Uteslutet: %1</translation>
    </message>
    <message>
        <source>Level of shot %1</source>
        <translation>Nivå för skott %1</translation>
    </message>
    <message>
        <source>Role of channel %1</source>
        <translation>Roll för kanal %1</translation>
    </message>
    <message>
        <source>Change the role of %1</source>
        <translation>Ändra rollen för %1</translation>
    </message>
    <message>
        <source>Exclude shot %1</source>
        <translation>Uteslut skott %1</translation>
    </message>
    <message>
        <source>Why is this shot not used? The certificate prints the reason.</source>
        <translation>Varför används inte detta skott? Skälet skrivs ut i kalibreringsbeviset.</translation>
    </message>
    <message>
        <source>Use shot %1</source>
        <translation>Använd skott %1</translation>
    </message>
    <message>
        <source>Change the level of shot %1</source>
        <translation>Ändra nivån för skott %1</translation>
    </message>
    <message>
        <source>Remove shot %1</source>
        <translation>Ta bort skott %1</translation>
    </message>
    <message>
        <source>Import settings...</source>
        <translation>Importinställningar...</translation>
    </message>
    <message>
        <source> (reading the recordings: %1 %)</source>
        <translation> (läser registreringarna: %1 %)</translation>
    </message>
    <message>
        <source>Why is the rate in the file wrong? The results record the reason.</source>
        <translation>Varför är filens frekvens fel? Skälet följer med resultaten.</translation>
    </message>
    <message>
        <source>Tag by step height</source>
        <translation>Märk efter steghöjd</translation>
    </message>
    <message>
        <source>Low, medium and high by the step that each shot&apos;s sensor read.</source>
        <translation>Låg, medel och hög efter det steg som varje skotts givare visade.</translation>
    </message>
    <message>
        <source>Tag shots by step height</source>
        <translation>Märk skotten efter steghöjd</translation>
    </message>
    <message>
        <source>shot %1: invalid</source>
        <translation>skott %1: ogiltigt</translation>
    </message>
    <message>
        <source>shot %1: saturated</source>
        <translation>skott %1: mättat</translation>
    </message>
</context>
<context>
    <name>dyncal::CardsTab</name>
    <message>
        <source>Laboratories</source>
        <translation>Laboratorier</translation>
    </message>
    <message>
        <source>Customers</source>
        <translation>Kunder</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Givare</translation>
    </message>
    <message>
        <source>Reference instruments</source>
        <translation>Referensinstrument</translation>
    </message>
    <message>
        <source>Which cards</source>
        <translation>Vilka kort</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Sök</translation>
    </message>
    <message>
        <source>Show only cards that hold this text</source>
        <translation>Visa bara kort som innehåller denna text</translation>
    </message>
    <message>
        <source>Cards</source>
        <translation>Kort</translation>
    </message>
    <message>
        <source>&amp;Add card</source>
        <translation>&amp;Lägg till kort</translation>
    </message>
    <message>
        <source>&amp;Keep changes...</source>
        <translation>&amp;Behåll ändringar...</translation>
    </message>
    <message>
        <source>Put what was typed into the registry, with a reason</source>
        <translation>För in det som skrevs i registret, med ett skäl</translation>
    </message>
    <message>
        <source>&amp;Import...</source>
        <translation>&amp;Importera...</translation>
    </message>
    <message>
        <source>Take cards from a CSV file with a column &quot;name&quot;</source>
        <translation>Ta in kort från en CSV-fil med en kolumn ”name”</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportera...</translation>
    </message>
    <message>
        <source>Write these cards as CSV</source>
        <translation>Skriv dessa kort som CSV</translation>
    </message>
    <message>
        <source>The changes could not be written to a temporary file: %1.</source>
        <translation>Ändringarna kunde inte skrivas till en tillfällig fil: %1.</translation>
    </message>
    <message>
        <source>Cards to take</source>
        <translation>Kort att ta in</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabeller (*.csv)</translation>
    </message>
    <message>
        <source>Change cards</source>
        <translation>Ändra kort</translation>
    </message>
    <message>
        <source>Why, for the audit trail:</source>
        <translation>Varför, för händelseloggen:</translation>
    </message>
    <message>
        <source>The cards are kept.</source>
        <translation>Korten är sparade.</translation>
    </message>
    <message>
        <source>Cards to write</source>
        <translation>Kort att skriva</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Skrivet: %1</translation>
    </message>
    <message>
        <source>%1 could not be written: %2.</source>
        <translation>%1 kunde inte skrivas: %2.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Namn</translation>
    </message>
    <message>
        <source>Quantity of the budget</source>
        <translation>Storhet i budgeten</translation>
    </message>
    <message>
        <source>Its certificate</source>
        <translation>Dess bevis</translation>
    </message>
    <message>
        <source>Due for calibration</source>
        <translation>Kalibreras senast</translation>
    </message>
</context>
<context>
    <name>dyncal::CertificatePage</name>
    <message>
        <source>Laboratory and customer</source>
        <translation>Laboratorium och kund</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Givare</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Kalibreringsbevis</translation>
    </message>
    <message>
        <source>Fill in what is not measured, then export the certificate.</source>
        <translation>Fyll i det som inte mäts och exportera sedan kalibreringsbeviset.</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>Export certificate PDF...</source>
        <translation>Exportera kalibreringsbevis som PDF...</translation>
    </message>
    <message>
        <source>Checklist</source>
        <translation>Checklista</translation>
    </message>
    <message>
        <source>Fill in the certificate</source>
        <translation>Fyll i kalibreringsbeviset</translation>
    </message>
    <message>
        <source>● All required fields are filled in.</source>
        <translation>● Alla obligatoriska fält är ifyllda.</translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) that block</source>
        <translation>
            <numerusform>%n iakttagelse som blockerar</numerusform>
            <numerusform>%n iakttagelser som blockerar</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n caution(s).</source>
        <translation>
            <numerusform>%n varning.</numerusform>
            <numerusform>%n varningar.</numerusform>
        </translation>
    </message>
    <message>
        <source>■ This is not a date. Write it as 2026-01-31.</source>
        <translation>■ Detta är inget datum. Skriv det som 2026-01-31.</translation>
    </message>
    <message numerus="yes">
        <source>■ %n required field(s) to be filled in: %1.</source>
        <translation>
            <numerusform>■ %n obligatoriskt fält att fylla i: %1.</numerusform>
            <numerusform>■ %n obligatoriska fält att fylla i: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>YYYY-MM-DD</source>
        <translation>ÅÅÅÅ-MM-DD</translation>
    </message>
    <message>
        <source>Template of the certificate</source>
        <translation>Bevisets mall</translation>
    </message>
    <message>
        <source>Templates (*.json);;All files (*)</source>
        <translation>Mallar (*.json);;Alla filer (*)</translation>
    </message>
    <message>
        <source>Two letters of ISO 3166-1, for the DCC; not printed</source>
        <translation>Två bokstäver enligt ISO 3166-1, för DCC; skrivs inte ut</translation>
    </message>
    <message>
        <source>■ This is no country. Write its two letters of ISO 3166-1, as SE.</source>
        <translation>■ Detta är inget land. Skriv dess två bokstäver enligt ISO 3166-1, som SE.</translation>
    </message>
    <message>
        <source>e.g. SE</source>
        <translation>t.ex. SE</translation>
    </message>
</context>
<context>
    <name>dyncal::CertificatesTab</name>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Läge</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Givare</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Kund</translation>
    </message>
    <message>
        <source>Issued (UTC)</source>
        <translation>Utfärdat (UTC)</translation>
    </message>
    <message>
        <source>Issued by</source>
        <translation>Utfärdat av</translation>
    </message>
    <message>
        <source>Reviewed by</source>
        <translation>Granskat av</translation>
    </message>
    <message>
        <source>Amends</source>
        <translation>Ändrar</translation>
    </message>
    <message>
        <source>Replaced by</source>
        <translation>Ersatt av</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Skäl</translation>
    </message>
    <message>
        <source>Certificates</source>
        <translation>Bevis</translation>
    </message>
    <message>
        <source>&amp;Withdraw...</source>
        <translation>&amp;Återkalla...</translation>
    </message>
    <message>
        <source>The laboratory does not stand by this certificate any more; its files stay</source>
        <translation>Laboratoriet står inte längre för detta bevis; filerna blir kvar</translation>
    </message>
    <message>
        <source>&amp;Give up number...</source>
        <translation>&amp;Ge upp nummer...</translation>
    </message>
    <message>
        <source>A reserved number that will not be issued; it is never given again</source>
        <translation>Ett reserverat nummer som inte kommer att utfärdas; det ges aldrig igen</translation>
    </message>
    <message>
        <source>Withdraw certificate %1</source>
        <translation>Återkalla bevis %1</translation>
    </message>
    <message>
        <source>Certificate %1 is withdrawn.</source>
        <translation>Bevis %1 är återkallat.</translation>
    </message>
    <message>
        <source>Give up number %1</source>
        <translation>Ge upp nummer %1</translation>
    </message>
    <message>
        <source>Number %1 is void.</source>
        <translation>Nummer %1 är ogiltigt.</translation>
    </message>
    <message>
        <source>Why, for the audit trail:</source>
        <translation>Varför, för händelseloggen:</translation>
    </message>
</context>
<context>
    <name>dyncal::ChecksPage</name>
    <message>
        <source>Checks</source>
        <translation>Kontroller</translation>
    </message>
    <message>
        <source>What is known in two independent ways is compared, within its combined uncertainty.</source>
        <translation>Det som är känt på två oberoende vägar jämförs, inom sin sammanlagda osäkerhet.</translation>
    </message>
    <message>
        <source>Comparisons</source>
        <translation>Jämförelser</translation>
    </message>
    <message>
        <source>Two ways contradict each other from 3.6 combined standard uncertainties on. &quot;Smallest fault seen&quot; is found in nine of ten cases; what is smaller may pass unseen. A comparison that could not be made proves nothing.</source>
        <translation>Två vägar motsäger varandra från 3,6 sammanlagda standardosäkerheter. &quot;Minsta synliga fel&quot; upptäcks i nio fall av tio; det som är mindre kan passera obemärkt. En jämförelse som inte kunde göras bevisar ingenting.</translation>
    </message>
</context>
<context>
    <name>dyncal::ComparisonPage</name>
    <message>
        <source>Comparison</source>
        <translation>Jämförelse</translation>
    </message>
    <message>
        <source>A transducer of known sensitivity beside the sensor gives S(f) without the shock; where both ways are known, they check each other.</source>
        <translation>En givare med känd känslighet bredvid givaren ger S(f) utan stötvågen; där båda vägarna är kända kontrollerar de varandra.</translation>
    </message>
    <message>
        <source>Magnitude against the reference transducer and against the pressure step</source>
        <translation>Belopp mot referensgivaren och mot trycksteget</translation>
    </message>
    <message>
        <source>Eₙ of the two over frequency</source>
        <translation>De tvås Eₙ över frekvens</translation>
    </message>
    <message>
        <source>Step and reference transducer</source>
        <translation>Steg och referensgivare</translation>
    </message>
    <message>
        <source>Reference transducer</source>
        <translation>Referensgivare</translation>
    </message>
    <message>
        <source>Its sensitivity</source>
        <translation>Dess känslighet</translation>
    </message>
    <message>
        <source>Amplifier and converter</source>
        <translation>Förstärkare och omvandlare</translation>
    </message>
    <message>
        <source>Both magnitudes less their mean</source>
        <translation>Båda beloppen minus deras medelvärde</translation>
    </message>
    <message>
        <source>Values of other calibrations</source>
        <translation>Värden från andra kalibreringar</translation>
    </message>
</context>
<context>
    <name>dyncal::ComponentsPage</name>
    <message>
        <source>PCA</source>
        <translation>PCA</translation>
    </message>
    <message>
        <source>Separate what the shots share from what they do not.</source>
        <translation>Skilj det som skotten har gemensamt från det de inte har.</translation>
    </message>
    <message>
        <source>Reconstruction of the shots</source>
        <translation>Rekonstruktion av skotten</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Residualer</translation>
    </message>
    <message>
        <source>Autocovariance of the residuals</source>
        <translation>Residualernas autokovarians</translation>
    </message>
    <message>
        <source>Spectrum of the residuals</source>
        <translation>Residualernas spektrum</translation>
    </message>
    <message>
        <source>Residuals of every shot</source>
        <translation>Residualer för varje skott</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Komponenter</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Behållna</translation>
    </message>
    <message>
        <source>Keep %1 components</source>
        <translation>Behåll %1 komponenter</translation>
    </message>
    <message>
        <source>Take away the mean over the shots first</source>
        <translation>Dra först bort medelvärdet över skotten</translation>
    </message>
    <message>
        <source>Centre the shots</source>
        <translation>Centrera skotten</translation>
    </message>
    <message>
        <source>First explains</source>
        <translation>Första förklarar</translation>
    </message>
    <message>
        <source>Lags</source>
        <translation>Tidsförskjutningar</translation>
    </message>
    <message>
        <source>Change the lags</source>
        <translation>Ändra tidsförskjutningarna</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Konfidensgrad</translation>
    </message>
    <message>
        <source>Change the confidence</source>
        <translation>Ändra konfidensgraden</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Skott</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Lags outside</source>
        <translation>Utanför gräns</translation>
    </message>
    <message>
        <source>White, p</source>
        <translation>Vit, p</translation>
    </message>
    <message>
        <source>Top peak</source>
        <translation>Högsta topp</translation>
    </message>
    <message>
        <source>– (one shot)</source>
        <translation>– (ett skott)</translation>
    </message>
    <message>
        <source>Left by the first components</source>
        <translation>Kvar efter de första komponenterna</translation>
    </message>
</context>
<context>
    <name>dyncal::ConditionsPanel</name>
    <message>
        <source>Change %1</source>
        <translation>Ändra %1</translation>
    </message>
    <message>
        <source>Gas before the shot</source>
        <translation>Gas före skottet</translation>
    </message>
    <message>
        <source>p1, absolute</source>
        <translation>p1, absolut</translation>
    </message>
    <message>
        <source>T1</source>
        <translation>T1</translation>
    </message>
    <message>
        <source>T4 (driver)</source>
        <translation>T4 (drivgas)</translation>
    </message>
    <message>
        <source>Driven gas</source>
        <translation>Gas i lågtrycksdelen</translation>
    </message>
    <message>
        <source>Change the driven gas</source>
        <translation>Ändra gasen i lågtrycksdelen</translation>
    </message>
    <message>
        <source>Heat capacity varies with temperature</source>
        <translation>Värmekapaciteten varierar med temperaturen</translation>
    </message>
    <message>
        <source>Change the heat capacity</source>
        <translation>Ändra värmekapaciteten</translation>
    </message>
    <message>
        <source>Relative humidity</source>
        <translation>Relativ fuktighet</translation>
    </message>
    <message>
        <source>CO₂</source>
        <translation>CO₂</translation>
    </message>
    <message>
        <source>Change the CO₂ of the air</source>
        <translation>Ändra luftens CO₂</translation>
    </message>
    <message>
        <source>Driver gas</source>
        <translation>Drivgas</translation>
    </message>
    <message>
        <source>Change the driver gas</source>
        <translation>Ändra drivgasen</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>Rör</translation>
    </message>
    <message>
        <source>Driven section</source>
        <translation>Lågtrycksdel</translation>
    </message>
    <message>
        <source>Driver section</source>
        <translation>Högtrycksdel</translation>
    </message>
    <message>
        <source>Inner diameter</source>
        <translation>Innerdiameter</translation>
    </message>
    <message>
        <source>Guard before the plateau&apos;s end</source>
        <translation>Marginal före platåns slut</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>Change the guard</source>
        <translation>Ändra marginalen</translation>
    </message>
    <message>
        <source>Change the range of the attenuation</source>
        <translation>Ändra dämpningens område</translation>
    </message>
    <message>
        <source>Attenuation, at least</source>
        <translation>Dämpning, minst</translation>
    </message>
    <message>
        <source>Attenuation, at most</source>
        <translation>Dämpning, högst</translation>
    </message>
    <message>
        <source>Duration of the front</source>
        <translation>Frontens varaktighet</translation>
    </message>
    <message>
        <source>Change the duration of the front</source>
        <translation>Ändra frontens varaktighet</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>inte angiven</translation>
    </message>
    <message>
        <source>u (duration of the front)</source>
        <translation>u (frontens varaktighet)</translation>
    </message>
</context>
<context>
    <name>dyncal::CorrectionForm</name>
    <message>
        <source>none yet</source>
        <translation>inga ännu</translation>
    </message>
    <message>
        <source>Calibration of the sensor</source>
        <translation>Givarens kalibrering</translation>
    </message>
    <message>
        <source>Taken from</source>
        <translation>Tas från</translation>
    </message>
    <message>
        <source>the open project</source>
        <translation>det öppna projektet</translation>
    </message>
    <message>
        <source>a results.json</source>
        <translation>en results.json</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Choose a results.json...</source>
        <translation>Välj en results.json...</translation>
    </message>
    <message>
        <source>Recordings to correct</source>
        <translation>Registreringar att korrigera</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Filer</translation>
    </message>
    <message>
        <source>Choose recordings...</source>
        <translation>Välj registreringar...</translation>
    </message>
    <message>
        <source>Channel of the sensor</source>
        <translation>Givarens kanal</translation>
    </message>
    <message>
        <source>Read them as the recordings of the project</source>
        <translation>Läs dem som projektets registreringar</translation>
    </message>
    <message>
        <source>With the import settings of the open project: columns, units, scale, gain</source>
        <translation>Med det öppna projektets importinställningar: kolumner, enheter, skala, förstärkning</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtret</translation>
    </message>
    <message>
        <source>Band up to</source>
        <translation>Band upp till</translation>
    </message>
    <message>
        <source>the widest possible</source>
        <translation>bredast möjliga</translation>
    </message>
    <message>
        <source>Nothing beyond</source>
        <translation>Inget bortom</translation>
    </message>
    <message>
        <source>1.5 times the band</source>
        <translation>1,5 gånger bandet</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Fördröjning</translation>
    </message>
    <message>
        <source>the shortest</source>
        <translation>den kortaste</translation>
    </message>
    <message>
        <source>Low-pass</source>
        <translation>Lågpass</translation>
    </message>
    <message>
        <source>Gaussian, no phase</source>
        <translation>gaussiskt, utan fas</translation>
    </message>
    <message>
        <source>two equal poles</source>
        <translation>två lika poler</translation>
    </message>
    <message>
        <source>Stretches of the recording</source>
        <translation>Sträckor av registreringen</translation>
    </message>
    <message>
        <source>Corrected from</source>
        <translation>Korrigeras från</translation>
    </message>
    <message>
        <source>its begin</source>
        <translation>dess början</translation>
    </message>
    <message>
        <source>Corrected to</source>
        <translation>Korrigeras till</translation>
    </message>
    <message>
        <source>its end</source>
        <translation>dess slut</translation>
    </message>
    <message>
        <source>No pressure from</source>
        <translation>Utan tryck från</translation>
    </message>
    <message>
        <source>No pressure to</source>
        <translation>Utan tryck till</translation>
    </message>
    <message>
        <source>before the start</source>
        <translation>före starten</translation>
    </message>
    <message>
        <source>Beyond the band at most</source>
        <translation>Bortom bandet högst</translation>
    </message>
    <message>
        <source>from the recording</source>
        <translation>ur registreringen</translation>
    </message>
    <message>
        <source>the run on show</source>
        <translation>den visade körningen</translation>
    </message>
    <message>
        <source>as the recordings say</source>
        <translation>som registreringarna anger</translation>
    </message>
</context>
<context>
    <name>dyncal::CorrectionView</name>
    <message>
        <source>Filter: the pressure from 0 to %1, nothing of it beyond %2; delay %3 (%4 samples of %5), which the times are without; gain %6 at 0 Hz; noise is amplified up to %7 times.</source>
        <translation>Filter: trycket från 0 till %1, inget av det bortom %2; fördröjning %3 (%4 sampel av %5), som tiderna är utan; förstärkning %6 vid 0 Hz; brus förstärks upp till %7 gånger.</translation>
    </message>
    <message>
        <source>Recorded signal</source>
        <translation>Registrerad signal</translation>
    </message>
    <message>
        <source>Pressure behind the recording</source>
        <translation>Trycket bakom registreringen</translation>
    </message>
    <message>
        <source>Corrected shots</source>
        <translation>Korrigerade skott</translation>
    </message>
    <message>
        <source>Findings of recordings and calibration</source>
        <translation>Iakttagelser om registreringar och kalibrering</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Skott</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Largest pressure</source>
        <translation>Största tryck</translation>
    </message>
    <message>
        <source>U (95 %)</source>
        <translation>U (95 %)</translation>
    </message>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Vid</translation>
    </message>
    <message>
        <source>u by noise</source>
        <translation>u av brus</translation>
    </message>
    <message>
        <source>Bound beyond the band</source>
        <translation>Gräns bortom bandet</translation>
    </message>
    <message>
        <source>Level without pressure</source>
        <translation>Nivå utan tryck</translation>
    </message>
    <message>
        <source>▲ The calibration has cautions, which hold for the correction too: %1.</source>
        <translation>▲ Kalibreringen har varningar, som gäller även för korrektionen: %1.</translation>
    </message>
</context>
<context>
    <name>dyncal::CorrectionWindow</name>
    <message>
        <source>Correct a recording</source>
        <translation>Korrigera en registrering</translation>
    </message>
    <message>
        <source>Progress of the correction</source>
        <translation>Hur långt korrektionen har kommit</translation>
    </message>
    <message>
        <source>C&amp;orrect</source>
        <translation>K&amp;orrigera</translation>
    </message>
    <message>
        <source>&amp;Save...</source>
        <translation>S&amp;para...</translation>
    </message>
    <message>
        <source>Pressure, filter and calibration as CSV, JSON, MAT and Python, into a folder</source>
        <translation>Tryck, filter och kalibrering som CSV, JSON, MAT och Python, i en mapp</translation>
    </message>
    <message>
        <source>Results of the sensor&apos;s calibration</source>
        <translation>Resultat av givarens kalibrering</translation>
    </message>
    <message>
        <source>Results (results.json *.json);;All files (*)</source>
        <translation>Resultat (results.json *.json);;Alla filer (*)</translation>
    </message>
    <message>
        <source>Recordings to correct</source>
        <translation>Registreringar att korrigera</translation>
    </message>
    <message>
        <source>Save the correction into a folder</source>
        <translation>Spara korrektionen i en mapp</translation>
    </message>
    <message>
        <source>What is on show is of earlier settings; press Correct.</source>
        <translation>Det som visas hör till tidigare inställningar; tryck på Korrigera.</translation>
    </message>
    <message>
        <source>Choose the calibration of the sensor and a recording of it, then press Correct.</source>
        <translation>Välj givarens kalibrering och en registrering från den, och tryck sedan på Korrigera.</translation>
    </message>
    <message>
        <source>The recordings are being opened.</source>
        <translation>Registreringarna öppnas.</translation>
    </message>
    <message>
        <source>The recordings are being corrected.</source>
        <translation>Registreringarna korrigeras.</translation>
    </message>
    <message>
        <source>The correction is being written.</source>
        <translation>Korrektionen skrivs.</translation>
    </message>
    <message>
        <source>Stopped; nothing was changed.</source>
        <translation>Stoppat; ingenting ändrades.</translation>
    </message>
    <message>
        <source>Nothing was corrected: the recordings do not hold the pressure, as the findings say.</source>
        <translation>Ingenting korrigerades: registreringarna innehåller inte trycket, som iakttagelserna säger.</translation>
    </message>
    <message>
        <source>Corrected: the pressure is relative to that before it, with its band of 95 %.</source>
        <translation>Korrigerat: trycket är relativt det före, med sitt band för 95 %.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Skrivet: %1</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Avbryt</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Stäng</translation>
    </message>
    <message>
        <source>Of earlier settings: press Correct to compute it again.</source>
        <translation>Från tidigare inställningar: tryck på Korrigera för att beräkna det igen.</translation>
    </message>
</context>
<context>
    <name>dyncal::CorrelationPanel</name>
    <message>
        <source>%1 with %2: r = %3</source>
        <translation>%1 med %2: r = %3</translation>
    </message>
    <message>
        <source>Inputs that err together</source>
        <translation>Storheter vars fel följs åt</translation>
    </message>
    <message>
        <source>Correlations of the budget</source>
        <translation>Korrelationer i budgeten</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Storhet</translation>
    </message>
    <message>
        <source>Goes along with</source>
        <translation>Följer</translation>
    </message>
    <message>
        <source>Correlation r</source>
        <translation>Korrelation r</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>krävs</translation>
    </message>
    <message>
        <source>Add a correlation</source>
        <translation>Lägg till en korrelation</translation>
    </message>
    <message>
        <source>Change a correlation</source>
        <translation>Ändra en korrelation</translation>
    </message>
    <message>
        <source>Remove a correlation</source>
        <translation>Ta bort en korrelation</translation>
    </message>
</context>
<context>
    <name>dyncal::CursorTable</name>
    <message>
        <source>Values at the cursors</source>
        <translation>Värden vid markörerna</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurva</translation>
    </message>
    <message>
        <source>A (key 1)</source>
        <translation>A (tangent 1)</translation>
    </message>
    <message>
        <source>B (key 2)</source>
        <translation>B (tangent 2)</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
</context>
<context>
    <name>dyncal::DccPanel</name>
    <message>
        <source>What a reader of the DCC would miss</source>
        <translation>Vad en läsare av DCC skulle sakna</translation>
    </message>
    <message>
        <source>dcc.xml says the same as the certificate, for machines; this is what its rules find missing</source>
        <translation>dcc.xml säger detsamma som beviset, för maskiner; detta är vad dess regler saknar</translation>
    </message>
    <message>
        <source>Fill in: %1</source>
        <translation>Fyll i: %1</translation>
    </message>
    <message>
        <source>To its field of the form</source>
        <translation>Till dess fält i formuläret</translation>
    </message>
    <message>
        <source>There is no DCC yet: it states a frequency response, and none was computed.</source>
        <translation>Det finns inget DCC ännu: det anger ett frekvenssvar, och inget har beräknats.</translation>
    </message>
    <message>
        <source>Nothing: all rules hold that are known of a DCC.</source>
        <translation>Inget: alla kända regler för ett DCC är uppfyllda.</translation>
    </message>
</context>
<context>
    <name>dyncal::DccRemarks</name>
    <message>
        <source>%1: none is known, and a DCC must have one. Type its two letters.</source>
        <translation>%1: inget är känt, och ett DCC måste ha ett. Skriv dess två bokstäver.</translation>
    </message>
    <message>
        <source>%1 Found: %2.</source>
        <translation>%1 Funnet: %2.</translation>
    </message>
</context>
<context>
    <name>dyncal::DecisionPanel</name>
    <message>
        <source>Statement of conformity</source>
        <translation>Uttalande om överensstämmelse</translation>
    </message>
    <message>
        <source>Decision rule</source>
        <translation>Beslutsregel</translation>
    </message>
    <message>
        <source>no statement</source>
        <translation>inget uttalande</translation>
    </message>
    <message>
        <source>simple acceptance</source>
        <translation>enkel acceptans</translation>
    </message>
    <message>
        <source>guard band of U</source>
        <translation>skyddsband på U</translation>
    </message>
    <message>
        <source>largest risk</source>
        <translation>största risk</translation>
    </message>
    <message>
        <source>Magnitude within ±</source>
        <translation>Belopp inom ±</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Från</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Till</translation>
    </message>
    <message>
        <source>Largest risk</source>
        <translation>Största risk</translation>
    </message>
    <message>
        <source>Change the decision rule</source>
        <translation>Ändra beslutsregeln</translation>
    </message>
    <message>
        <source>Change the claim</source>
        <translation>Ändra påståendet</translation>
    </message>
    <message>
        <source>Change the largest risk</source>
        <translation>Ändra den största risken</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>dyncal::EarlierPanel</name>
    <message>
        <source>Lay over...</source>
        <translation>Lägg över...</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Earlier result</source>
        <translation>Tidigare resultat</translation>
    </message>
    <message>
        <source>Earlier, %1</source>
        <translation>Tidigare, %1</translation>
    </message>
    <message>
        <source>Sensor %1, %2</source>
        <translation>Givare %1, %2</translation>
    </message>
    <message>
        <source>%1: in %2, which this result is not; it is not drawn.</source>
        <translation>%1: i %2, vilket detta resultat inte är; det ritas inte.</translation>
    </message>
    <message>
        <source>%1: no frequency is stated with U by both.</source>
        <translation>%1: ingen frekvens anges med U av båda.</translation>
    </message>
    <message>
        <source>A results.json of an earlier run, or a digital calibration certificate (DCC) of any laboratory: its S(f) is drawn beside this one, and nothing is changed by it</source>
        <translation>En results.json från en tidigare körning, eller ett digitalt kalibreringscertifikat (DCC) från vilket laboratorium som helst: dess S(f) ritas bredvid detta, och inget ändras av det</translation>
    </message>
    <message>
        <source>Certificate %1, %2</source>
        <translation>Certifikat %1, %2</translation>
    </message>
    <message>
        <source>Results and certificates (*.json *.xml);;All files (*)</source>
        <translation>Resultat och certifikat (*.json *.xml);;Alla filer (*)</translation>
    </message>
    <message>
        <source>Not taken from the certificate:</source>
        <translation>Inte hämtat från certifikatet:</translation>
    </message>
    <message>
        <source>%1: %2 of %3 rows agree within U; the largest |Eₙ| is %4, at %5. What both share, tube, references and method, is in both U: an |Eₙ| below 1 does not show that nothing changed.</source>
        <translation>%1: %2 av %3 rader stämmer överens inom U; det största |Eₙ| är %4, vid %5. Vad båda delar, rör, referenser och metod, finns i båda U: ett |Eₙ| under 1 visar inte att inget har ändrats.</translation>
    </message>
</context>
<context>
    <name>dyncal::EntryList</name>
    <message>
        <source>Add this entry</source>
        <translation>Lägg till posten</translation>
    </message>
    <message>
        <source>Replace the selected entry</source>
        <translation>Ersätt den valda posten</translation>
    </message>
    <message>
        <source>Remove the selected entry</source>
        <translation>Ta bort den valda posten</translation>
    </message>
</context>
<context>
    <name>dyncal::ExportActions</name>
    <message>
        <source>Written: %1</source>
        <translation>Skrivet: %1</translation>
    </message>
    <message>
        <source>Written: %1 (results.json and recipe.json alone, because of what blocks)</source>
        <translation>Skrivet: %1 (endast results.json och recipe.json, på grund av det som blockerar)</translation>
    </message>
    <message>
        <source>Results are still being written to %1; wait until they are, or press Cancel.</source>
        <translation>Resultaten skrivs fortfarande till %1; vänta tills det är klart eller tryck Avbryt.</translation>
    </message>
    <message>
        <source>Export results into a folder</source>
        <translation>Exportera resultat till en mapp</translation>
    </message>
    <message>
        <source>Export certificate</source>
        <translation>Exportera kalibreringsbevis</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF-dokument (*.pdf)</translation>
    </message>
    <message>
        <source>Export the model into a folder</source>
        <translation>Exportera modellen till en mapp</translation>
    </message>
    <message>
        <source>Model written to %1</source>
        <translation>Modellen skrevs till %1</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Skriver %1</translation>
    </message>
</context>
<context>
    <name>dyncal::FieldLabels</name>
    <message>
        <source>Country of the laboratory</source>
        <translation>Laboratoriets land</translation>
    </message>
    <message>
        <source>Country of the customer</source>
        <translation>Kundens land</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Anmärkningar</translation>
    </message>
</context>
<context>
    <name>dyncal::FileActions</name>
    <message>
        <source>The recordings are still being read for their hashes, which the project keeps; try again in a moment.</source>
        <translation>Registreringarna läses fortfarande för att beräkna kontrollsummorna som projektet sparar; försök igen om en stund.</translation>
    </message>
    <message>
        <source>Recordings (%1)</source>
        <translation>Registreringar (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alla filer (*)</translation>
    </message>
    <message>
        <source>Dyncal projects (*.%1)</source>
        <translation>Dyncal-projekt (*.%1)</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Namnlöst</translation>
    </message>
    <message>
        <source>Open captures</source>
        <translation>Öppna registreringar</translation>
    </message>
    <message>
        <source>Making the example</source>
        <translation>Skapar exemplet</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Öppna projekt</translation>
    </message>
    <message>
        <source>Opening project</source>
        <translation>Öppnar projekt</translation>
    </message>
    <message>
        <source>Project opened</source>
        <translation>Projektet har öppnats</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Spara projekt</translation>
    </message>
    <message>
        <source>Project saved</source>
        <translation>Projektet har sparats</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Avbrutet</translation>
    </message>
    <message>
        <source>The example is open</source>
        <translation>Exemplet är öppnat</translation>
    </message>
    <message>
        <source>Restoring work</source>
        <translation>Återställer arbete</translation>
    </message>
    <message>
        <source>Work restored; it is not saved yet</source>
        <translation>Arbetet är återställt; det är inte sparat än</translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation>Mapp med registreringarna</translation>
    </message>
    <message>
        <source>There is no calibration that a profile could be used for; open recordings or a project first.</source>
        <translation>Det finns ingen kalibrering som en profil kan användas för; öppna först registreringar eller ett projekt.</translation>
    </message>
    <message>
        <source>Use profile of the laboratory</source>
        <translation>Använd laboratoriets profil</translation>
    </message>
    <message>
        <source>Profiles (*.json)</source>
        <translation>Profiler (*.json)</translation>
    </message>
    <message>
        <source>Profile in use: %1, version %2</source>
        <translation>Profil som används: %1, version %2</translation>
    </message>
    <message>
        <source>Opening the sensor</source>
        <translation>Öppnar givaren</translation>
    </message>
    <message>
        <source>The sensor is open</source>
        <translation>Givaren är öppen</translation>
    </message>
</context>
<context>
    <name>dyncal::FindingsPanel</name>
    <message>
        <source>Findings</source>
        <translation>Iakttagelser</translation>
    </message>
    <message>
        <source>Accepted: %1</source>
        <translation>Godtagen: %1</translation>
    </message>
    <message>
        <source>No findings.</source>
        <translation>Inga iakttagelser.</translation>
    </message>
    <message>
        <source>Give a reason...</source>
        <translation>Ange ett skäl...</translation>
    </message>
    <message>
        <source>Click, or press Enter, to go to where it is settled</source>
        <translation>Klicka, eller tryck Enter, för att gå dit där det avgörs</translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n upplysning</numerusform>
            <numerusform>%n upplysningar</numerusform>
        </translation>
    </message>
    <message>
        <source>Click, or press Enter, to open or fold what is only good to know</source>
        <translation>Klicka, eller tryck Enter, för att öppna eller fälla ihop det som bara är bra att veta</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Visa</translation>
    </message>
    <message>
        <source>Go to %1, where this is settled</source>
        <translation>Gå till %1, där detta avgörs</translation>
    </message>
    <message>
        <source>Use the result in spite of this; the certificate prints the reason</source>
        <translation>Använd resultatet trots detta; kalibreringsbeviset skriver ut motiveringen</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Fäll ihop</translation>
    </message>
    <message>
        <source>Each shot</source>
        <translation>Varje skott</translation>
    </message>
    <message>
        <source>Show what is said of every shot, or fold it</source>
        <translation>Visa vad som sägs om varje skott, eller fäll ihop det</translation>
    </message>
</context>
<context>
    <name>dyncal::FirstTripletsBar</name>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Compute the rest (F9)</source>
        <translation>Beräkna resten (F9)</translation>
    </message>
    <message>
        <source>Singular values computed</source>
        <translation>Beräknade singulärvärden</translation>
    </message>
    <message>
        <source>Stop computing; the first singular values stay</source>
        <translation>Sluta beräkna; de första singulärvärdena blir kvar</translation>
    </message>
    <message>
        <source>Order %1 needs all %2 singular values, which are being computed.</source>
        <translation>Ordning %1 kräver alla %2 singulärvärden, som håller på att beräknas.</translation>
    </message>
    <message>
        <source>Order %1 needs all %2 singular values, whose computation was cancelled.</source>
        <translation>Ordning %1 kräver alla %2 singulärvärden, vars beräkning avbröts.</translation>
    </message>
    <message>
        <source>First %1 of %2 singular values.</source>
        <translation>De första %1 av %2 singulärvärden.</translation>
    </message>
    <message>
        <source>The rest follows; everything here is of the first ones.</source>
        <translation>Resten följer; allt här gäller de första.</translation>
    </message>
    <message>
        <source>The rest was cancelled; reports and exports need it.</source>
        <translation>Resten avbröts; rapporter och export kräver den.</translation>
    </message>
</context>
<context>
    <name>dyncal::GasEdit</name>
    <message>
        <source>dry air</source>
        <translation>torr luft</translation>
    </message>
    <message>
        <source>humid air</source>
        <translation>fuktig luft</translation>
    </message>
    <message>
        <source>other, typed</source>
        <translation>annan, angiven</translation>
    </message>
    <message>
        <source>γ</source>
        <translation>γ</translation>
    </message>
    <message>
        <source>Molar mass</source>
        <translation>Molmassa</translation>
    </message>
    <message>
        <source>Source of the constants: %1</source>
        <translation>Konstanternas källa: %1</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>som registrerad</translation>
    </message>
</context>
<context>
    <name>dyncal::GoToField</name>
    <message>
        <source>Go to</source>
        <translation>Gå till</translation>
    </message>
    <message>
        <source>Go to, in %1</source>
        <translation>Gå till, i %1</translation>
    </message>
    <message>
        <source>There is no curve to go to.</source>
        <translation>Det finns ingen kurva att gå till.</translation>
    </message>
    <message>
        <source>Nothing is shown at %1: the curves reach from %2 to %3.</source>
        <translation>Ingenting visas vid %1: kurvorna går från %2 till %3.</translation>
    </message>
</context>
<context>
    <name>dyncal::HistoryTab</name>
    <message>
        <source>&amp;Results in</source>
        <translation>&amp;Resultat i</translation>
    </message>
    <message>
        <source>The folder of issued certificates, of results, or any folder above such</source>
        <translation>Mappen med utfärdade bevis, med resultat, eller någon mapp ovanför sådana</translation>
    </message>
    <message>
        <source>C&amp;hoose...</source>
        <translation>Väl&amp;j...</translation>
    </message>
    <message>
        <source>&amp;Sensor</source>
        <translation>&amp;Givare</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Serienummer</translation>
    </message>
    <message>
        <source>&amp;Quantity</source>
        <translation>St&amp;orhet</translation>
    </message>
    <message>
        <source>S(f) &amp;at, in Hz</source>
        <translation>S(f) vi&amp;d, i Hz</translation>
    </message>
    <message>
        <source>1000; 10000</source>
        <translation>1000; 10000</translation>
    </message>
    <message>
        <source>Frequencies of which magnitude and phase are followed; the nearest row within 3 % serves</source>
        <translation>Frekvenser vars belopp och fas följs; närmaste rad inom 3 % tjänar</translation>
    </message>
    <message>
        <source>Sa&amp;ve table...</source>
        <translation>Spara &amp;tabell...</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>Dag</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Bevis</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Värde</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>Control chart</source>
        <translation>Styrdiagram</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Anmärkning</translation>
    </message>
    <message>
        <source>Calibrations of the sensor</source>
        <translation>Givarens kalibreringar</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Choose a folder with results of calibrations that state the serial number of the sensor.</source>
        <translation>Välj en mapp med resultat av kalibreringar som anger givarens serienummer.</translation>
    </message>
    <message>
        <source>Folder with results</source>
        <translation>Mapp med resultat</translation>
    </message>
    <message>
        <source>Save table</source>
        <translation>Spara tabell</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabeller (*.csv)</translation>
    </message>
    <message>
        <source>The history is in %1.</source>
        <translation>Historiken finns i %1.</translation>
    </message>
    <message>
        <source>Eₙ</source>
        <translation>Eₙ</translation>
    </message>
</context>
<context>
    <name>dyncal::ImportChannelTable</name>
    <message>
        <source>Channels of the file</source>
        <translation>Filens kanaler</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Roll</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Enhet</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Sampel</translation>
    </message>
    <message>
        <source>Role of channel %1</source>
        <translation>Roll för kanal %1</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Förstärkning</translation>
    </message>
    <message>
        <source>Sensitivity / (mV/kPa)</source>
        <translation>Känslighet / (mV/kPa)</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Omvänd</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Tryck</translation>
    </message>
    <message>
        <source>Unit of channel %1</source>
        <translation>Enhet för kanal %1</translation>
    </message>
    <message>
        <source>Factor on channel %1</source>
        <translation>Faktor på kanal %1</translation>
    </message>
    <message>
        <source>Gain of channel %1</source>
        <translation>Förstärkning för kanal %1</translation>
    </message>
    <message>
        <source>Sensitivity of channel %1</source>
        <translation>Känslighet för kanal %1</translation>
    </message>
    <message>
        <source>Inverted polarity of channel %1</source>
        <translation>Omvänd polaritet för kanal %1</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>som registrerat</translation>
    </message>
    <message>
        <source>gauge</source>
        <translation>övertryck</translation>
    </message>
    <message>
        <source>absolute</source>
        <translation>absolut</translation>
    </message>
    <message>
        <source>Gauge or absolute, channel %1</source>
        <translation>Övertryck eller absolut, kanal %1</translation>
    </message>
    <message>
        <source>may be: %1</source>
        <translation>kan vara: %1</translation>
    </message>
    <message>
        <source>unit not known</source>
        <translation>okänd enhet</translation>
    </message>
    <message>
        <source>unit %1 is not converted</source>
        <translation>enheten %1 räknas inte om</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Kurva</translation>
    </message>
    <message>
        <source>Looks like</source>
        <translation>Ser ut som</translation>
    </message>
    <message>
        <source>Trace of channel %1</source>
        <translation>Kurva för kanal %1</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>ej angiven</translation>
    </message>
    <message>
        <source>%1, shot %2</source>
        <translation>%1, skott %2</translation>
    </message>
</context>
<context>
    <name>dyncal::ImportDatasetTree</name>
    <message>
        <source>one value</source>
        <translation>ett värde</translation>
    </message>
    <message>
        <source>Datasets of the file</source>
        <translation>Filens dataset</translation>
    </message>
    <message>
        <source>Dataset</source>
        <translation>Dataset</translation>
    </message>
    <message>
        <source>Read as</source>
        <translation>Läses som</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Attributes</source>
        <translation>Attribut</translation>
    </message>
    <message>
        <source>group</source>
        <translation>grupp</translation>
    </message>
    <message>
        <source>What %1 is read as</source>
        <translation>Vad %1 läses som</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>läses inte</translation>
    </message>
</context>
<context>
    <name>dyncal::ImportDialog</name>
    <message>
        <source>Import %1</source>
        <translation>Importera %1</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatiskt</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>Remember as profile</source>
        <translation>Spara som profil</translation>
    </message>
    <message>
        <source>Name of the profile</source>
        <translation>Profilens namn</translation>
    </message>
    <message numerus="yes">
        <source>Import %n file(s)</source>
        <translation>
            <numerusform>Importera %n fil</numerusform>
            <numerusform>Importera %n filer</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>for all files</source>
        <translation>för alla filer</translation>
    </message>
    <message>
        <source>for this file</source>
        <translation>för denna fil</translation>
    </message>
    <message>
        <source>These settings hold</source>
        <translation>Inställningarna gäller</translation>
    </message>
    <message>
        <source>Take the proposed roles</source>
        <translation>Ta de föreslagna rollerna</translation>
    </message>
    <message>
        <source>Proposed from step and noise of the records: look at the traces</source>
        <translation>Föreslagna utifrån registreringarnas steg och brus: se på kurvorna</translation>
    </message>
</context>
<context>
    <name>dyncal::ImportPreviewTable</name>
    <message>
        <source>First rows of the file</source>
        <translation>Filens första rader</translation>
    </message>
    <message>
        <source>%1 (time)</source>
        <translation>%1 (tid)</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>saknas</translation>
    </message>
    <message>
        <source>No number under these settings</source>
        <translation>Inget tal med dessa inställningar</translation>
    </message>
    <message>
        <source>%1 (shot %2)</source>
        <translation>%1 (skott %2)</translation>
    </message>
    <message>
        <source>%1 (left out)</source>
        <translation>%1 (utelämnad)</translation>
    </message>
</context>
<context>
    <name>dyncal::ImportRateRow</name>
    <message>
        <source>Why the file is wrong</source>
        <translation>Varför filen har fel</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>Samplingsfrekvens</translation>
    </message>
    <message>
        <source>the time column is right, the header is not</source>
        <translation>tidskolumnen stämmer, inte huvudet</translation>
    </message>
    <message>
        <source>the header is right, the time column is not</source>
        <translation>huvudet stämmer, inte tidskolumnen</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>ej angiven</translation>
    </message>
    <message>
        <source>Use the time column: %1</source>
        <translation>Använd tidskolumnen: %1</translation>
    </message>
    <message>
        <source>Use the header: %1</source>
        <translation>Använd huvudet: %1</translation>
    </message>
    <message>
        <source>as typed</source>
        <translation>som inskrivet</translation>
    </message>
    <message>
        <source>from the time column: %1</source>
        <translation>från tidskolumnen: %1</translation>
    </message>
    <message>
        <source>the file states %1</source>
        <translation>filen anger %1</translation>
    </message>
</context>
<context>
    <name>dyncal::ImportTextBox</name>
    <message>
        <source>comma</source>
        <translation>komma</translation>
    </message>
    <message>
        <source>point</source>
        <translation>punkt</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>tabb</translation>
    </message>
    <message>
        <source>blanks</source>
        <translation>blanksteg</translation>
    </message>
    <message>
        <source>Text table</source>
        <translation>Texttabell</translation>
    </message>
    <message>
        <source>Separator</source>
        <translation>Skiljetecken</translation>
    </message>
    <message>
        <source>Decimal mark</source>
        <translation>Decimaltecken</translation>
    </message>
    <message>
        <source>Header rows</source>
        <translation>Huvudrader</translation>
    </message>
    <message>
        <source>Time from</source>
        <translation>Tid från</translation>
    </message>
    <message>
        <source>comma ,</source>
        <translation>komma ,</translation>
    </message>
    <message>
        <source>semicolon ;</source>
        <translation>semikolon ;</translation>
    </message>
    <message>
        <source>bar |</source>
        <translation>streck |</translation>
    </message>
    <message>
        <source>point .</source>
        <translation>punkt .</translation>
    </message>
    <message>
        <source>automatic: %1</source>
        <translation>automatiskt: %1</translation>
    </message>
    <message>
        <source>%1 rows looked at, unreadable cells: %2. Text: %3.</source>
        <translation>%1 rader lästa på prov, oläsbara celler: %2. Text: %3.</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatiskt</translation>
    </message>
    <message>
        <source>no column: the rate is given</source>
        <translation>ingen kolumn: frekvensen anges</translation>
    </message>
    <message>
        <source>column %1: %2</source>
        <translation>kolumn %1: %2</translation>
    </message>
    <message>
        <source>Each column is a shot of one sensor</source>
        <translation>Varje kolumn är ett skott med samma givare</translation>
    </message>
    <message>
        <source>The columns are records of the same sensor, shot after shot; else they are channels that were recorded together</source>
        <translation>Kolumnerna är registreringar från samma givare, skott efter skott; annars är de kanaler som registrerades tillsammans</translation>
    </message>
</context>
<context>
    <name>dyncal::IntervalEdit</name>
    <message>
        <source>%1: begin</source>
        <translation>%1: början</translation>
    </message>
    <message>
        <source>%1: end</source>
        <translation>%1: slut</translation>
    </message>
    <message>
        <source>Not taken yet: the begin (above) must lie before the end (below).</source>
        <translation>Ännu inte taget: början (överst) måste ligga före slutet (nederst).</translation>
    </message>
</context>
<context>
    <name>dyncal::IssueDialog</name>
    <message>
        <source>&amp;Folder of certificates</source>
        <translation>&amp;Mapp för bevis</translation>
    </message>
    <message>
        <source>&amp;Registry</source>
        <translation>&amp;Register</translation>
    </message>
    <message>
        <source>Issued &amp;by</source>
        <translation>Utfärdat &amp;av</translation>
    </message>
    <message>
        <source>Re&amp;viewed by</source>
        <translation>&amp;Granskat av</translation>
    </message>
    <message>
        <source>Issue certificate</source>
        <translation>Utfärda bevis</translation>
    </message>
    <message>
        <source>It gets a folder with the certificate&apos;s number</source>
        <translation>Den får en mapp med bevisets nummer</translation>
    </message>
    <message>
        <source>that of this user</source>
        <translation>denna användares</translation>
    </message>
    <message>
        <source>&amp;What changed</source>
        <translation>&amp;Vad som ändrats</translation>
    </message>
    <message>
        <source>Printed on the amendment, beside the number that it replaces</source>
        <translation>Trycks på ändringen, bredvid numret som den ersätter</translation>
    </message>
    <message>
        <source>What keeps it from being issued</source>
        <translation>Vad som hindrar att det utfärdas</translation>
    </message>
    <message>
        <source>The certificate is being issued</source>
        <translation>Beviset utfärdas</translation>
    </message>
    <message>
        <source>&amp;Choose...</source>
        <translation>&amp;Välj...</translation>
    </message>
    <message>
        <source>&amp;Issue</source>
        <translation>&amp;Utfärda</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Stäng</translation>
    </message>
    <message>
        <source>Nothing keeps it from being issued.</source>
        <translation>Inget hindrar att det utfärdas.</translation>
    </message>
    <message>
        <source>This job is a draft: it has no certificate in this registry.</source>
        <translation>Detta jobb är ett utkast: det har inget bevis i detta register.</translation>
    </message>
    <message>
        <source>These recordings have certificate %1. It is not changed any more: issue an amendment, which has a number of its own and says what it replaces and why.</source>
        <translation>Dessa inspelningar har bevis %1. Det ändras inte mer: utfärda en ändring, som har ett eget nummer och säger vad den ersätter och varför.</translation>
    </message>
    <message>
        <source>Folder of certificates</source>
        <translation>Mapp för bevis</translation>
    </message>
    <message>
        <source>The project is computed once more and its certificate written.</source>
        <translation>Projektet beräknas en gång till och dess bevis skrivs.</translation>
    </message>
    <message>
        <source>No certificate was issued. %1</source>
        <translation>Inget bevis utfärdades. %1</translation>
    </message>
    <message>
        <source>Certificate %1 is issued, not signed: %2</source>
        <translation>Bevis %1 är utfärdat, inte signerat: %2</translation>
    </message>
    <message>
        <source>Name the folder of certificates.</source>
        <translation>Ange mappen för bevis.</translation>
    </message>
    <message>
        <source>Say what changed, for the amendment.</source>
        <translation>Säg vad som ändrats, för ändringen.</translation>
    </message>
    <message>
        <source>Certificate %1 is issued and signed by %2: %3</source>
        <translation>Bevis %1 är utfärdat och signerat av %2: %3</translation>
    </message>
    <message>
        <source>Certificate %1 is issued, signed by %2 and time stamped by %3: %4</source>
        <translation>Bevis %1 är utfärdat, signerat av %2 och tidsstämplat av %3: %4</translation>
    </message>
</context>
<context>
    <name>dyncal::KeptResultsView</name>
    <message>
        <source>Kept results of %1</source>
        <translation>Sparade resultat för %1</translation>
    </message>
    <message>
        <source>These are the results as they stood when the project was saved (%1). The recordings are missing, so nothing can be computed, changed or exported.</source>
        <translation>Detta är resultaten så som de stod när projektet sparades (%1). Registreringarna saknas, så ingenting kan beräknas, ändras eller exporteras.</translation>
    </message>
</context>
<context>
    <name>dyncal::KnownPanel</name>
    <message>
        <source>Values of other calibrations</source>
        <translation>Värden från andra kalibreringar</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Namn</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Bevis</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frekvens</translation>
    </message>
    <message>
        <source>static</source>
        <translation>statiskt</translation>
    </message>
    <message>
        <source>Unit of the value</source>
        <translation>Värdets enhet</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Värde</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>behövs</translation>
    </message>
    <message>
        <source>Add a value of another calibration</source>
        <translation>Lägg till ett värde från en annan kalibrering</translation>
    </message>
    <message>
        <source>Change a value of another calibration</source>
        <translation>Ändra ett värde från en annan kalibrering</translation>
    </message>
    <message>
        <source>Remove a value of another calibration</source>
        <translation>Ta bort ett värde från en annan kalibrering</translation>
    </message>
</context>
<context>
    <name>dyncal::MainMenus</name>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Redigera</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Ångra</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Gör om</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Arkiv</translation>
    </message>
    <message>
        <source>Open &amp;captures...</source>
        <translation>Öppna &amp;registreringar...</translation>
    </message>
    <message>
        <source>Open &amp;example</source>
        <translation>Öppna &amp;exempel</translation>
    </message>
    <message>
        <source>&amp;Open project...</source>
        <translation>&amp;Öppna projekt...</translation>
    </message>
    <message>
        <source>&amp;Recent</source>
        <translation>Se&amp;naste</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Spara</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Spara s&amp;om...</translation>
    </message>
    <message>
        <source>Export &amp;results...</source>
        <translation>Exportera res&amp;ultat...</translation>
    </message>
    <message>
        <source>Export &amp;model...</source>
        <translation>Exportera &amp;modell...</translation>
    </message>
    <message>
        <source>Export cer&amp;tificate...</source>
        <translation>Exportera kali&amp;breringsbevis...</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Avsluta</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Inget ännu</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Visa</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Återställ layout</translation>
    </message>
    <message>
        <source>&amp;Stage</source>
        <translation>Ar&amp;betssteg</translation>
    </message>
    <message>
        <source>Compute &amp;again</source>
        <translation>&amp;Beräkna igen</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Språk</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hjälp</translation>
    </message>
    <message>
        <source>&amp;Keyboard and mouse</source>
        <translation>&amp;Tangentbord och mus</translation>
    </message>
    <message>
        <source>&amp;About Dyncal</source>
        <translation>&amp;Om Dyncal</translation>
    </message>
    <message>
        <source>Tool bar</source>
        <translation>Verktygsfält</translation>
    </message>
    <message>
        <source>&amp;Previous stage</source>
        <translation>&amp;Föregående steg</translation>
    </message>
    <message>
        <source>&amp;Next stage</source>
        <translation>&amp;Nästa steg</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Färger</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Ljust</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Mörkt</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>&amp;Hög kontrast</translation>
    </message>
    <message>
        <source>Save all p&amp;lots...</source>
        <translation>Spara alla d&amp;iagram...</translation>
    </message>
    <message>
        <source>Use pro&amp;file of the laboratory...</source>
        <translation>Använd laboratoriets pro&amp;fil...</translation>
    </message>
    <message>
        <source>&amp;Self-test...</source>
        <translation>&amp;Självtest...</translation>
    </message>
    <message>
        <source>Correct a recordi&amp;ng...</source>
        <translation>&amp;Korrigera en registrering...</translation>
    </message>
    <message>
        <source>&amp;Batch...</source>
        <translation>Sa&amp;ts...</translation>
    </message>
    <message>
        <source>&amp;Issue certificate...</source>
        <translation>&amp;Utfärda bevis...</translation>
    </message>
    <message>
        <source>Re&amp;gistry...</source>
        <translation>Re&amp;gister...</translation>
    </message>
</context>
<context>
    <name>dyncal::MainWindow</name>
    <message>
        <source>Stages</source>
        <translation>Arbetssteg</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Iakttagelser</translation>
    </message>
    <message>
        <source>Findings (%1)</source>
        <translation>Iakttagelser (%1)</translation>
    </message>
    <message>
        <source>Files that could not be read</source>
        <translation>Filer som inte kunde läsas</translation>
    </message>
    <message>
        <source>What next</source>
        <translation>Vad härnäst</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1 (skrivskyddat)</translation>
    </message>
</context>
<context>
    <name>dyncal::ModelInputPage</name>
    <message>
        <source>Model input</source>
        <translation>Modellindata</translation>
    </message>
    <message>
        <source>Choose the rate, the stretch and how the step is treated.</source>
        <translation>Välj samplingsfrekvens, avsnitt och hur steget behandlas.</translation>
    </message>
    <message>
        <source>What the identification gets</source>
        <translation>Det som identifieringen får</translation>
    </message>
    <message>
        <source>Treatment</source>
        <translation>Behandling</translation>
    </message>
    <message>
        <source>Response is</source>
        <translation>Svaret är</translation>
    </message>
    <message>
        <source>a step, its pole deflated</source>
        <translation>ett steg, vars pol avlägsnas</translation>
    </message>
    <message>
        <source>a step, fed as impulse (thesis)</source>
        <translation>ett steg, matat som impuls (examensarbetet)</translation>
    </message>
    <message>
        <source>a step, differenced</source>
        <translation>ett steg, differensbildat</translation>
    </message>
    <message>
        <source>an impulse response</source>
        <translation>ett impulssvar</translation>
    </message>
    <message>
        <source>Change the treatment</source>
        <translation>Ändra behandlingen</translation>
    </message>
    <message>
        <source>Shots are</source>
        <translation>Skotten är</translation>
    </message>
    <message>
        <source>combined by default rule</source>
        <translation>sammanvägda enligt standardregeln</translation>
    </message>
    <message>
        <source>stacked</source>
        <translation>staplade</translation>
    </message>
    <message>
        <source>averaged after PCA</source>
        <translation>medelvärdesbildade efter PCA</translation>
    </message>
    <message>
        <source>Change how shots are combined</source>
        <translation>Ändra hur skotten sammanvägs</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Sampling</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Frekvens</translation>
    </message>
    <message>
        <source>Change the model rate</source>
        <translation>Ändra modellens samplingsfrekvens</translation>
    </message>
    <message>
        <source>Per period</source>
        <translation>Per period</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Sampel</translation>
    </message>
    <message>
        <source>Change the number of samples</source>
        <translation>Ändra antalet sampel</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Startförskjutning</translation>
    </message>
    <message>
        <source>Change the offset</source>
        <translation>Ändra startförskjutningen</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Avsnitt</translation>
    </message>
    <message>
        <source>Lost before</source>
        <translation>Förlorat före</translation>
    </message>
    <message>
        <source>%1 % of the ringing</source>
        <translation>%1 % av utsvängningen</translation>
    </message>
    <message>
        <source>– (no resonance)</source>
        <translation>– (ingen resonans)</translation>
    </message>
    <message>
        <source>● comfortable</source>
        <translation>● gott och väl</translation>
    </message>
    <message>
        <source>■ too few: the resonance is aliased</source>
        <translation>■ för få: resonansen viks</translation>
    </message>
    <message>
        <source>▲ sparse: damping is uncertain</source>
        <translation>▲ glest: dämpningen är osäker</translation>
    </message>
    <message>
        <source>▲ enough, more is better</source>
        <translation>▲ tillräckligt, fler är bättre</translation>
    </message>
</context>
<context>
    <name>dyncal::ModelPage</name>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Judge the model of the chosen order against the data.</source>
        <translation>Bedöm modellen av vald ordning mot data.</translation>
    </message>
    <message>
        <source>Data and model</source>
        <translation>Data och modell</translation>
    </message>
    <message>
        <source>Error of the model</source>
        <translation>Modellens fel</translation>
    </message>
    <message>
        <source>Magnitude of the frequency response</source>
        <translation>Frekvenssvarets belopp</translation>
    </message>
    <message>
        <source>Phase of the frequency response</source>
        <translation>Frekvenssvarets fas</translation>
    </message>
    <message>
        <source>Poles and zeros</source>
        <translation>Poler och nollställen</translation>
    </message>
    <message>
        <source>Poles</source>
        <translation>Poler</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordning</translation>
    </message>
    <message>
        <source>FIT</source>
        <translation>FIT</translation>
    </message>
    <message>
        <source>Per series</source>
        <translation>Per serie</translation>
    </message>
    <message>
        <source>FIT, thesis</source>
        <translation>FIT, examensarbetet</translation>
    </message>
    <message>
        <source>Characteristics</source>
        <translation>Egenskaper</translation>
    </message>
    <message>
        <source>Rise 10–90 %</source>
        <translation>Stigtid 10–90 %</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Översväng</translation>
    </message>
    <message>
        <source>Settling ±5 %</source>
        <translation>Insvängning ±5 %</translation>
    </message>
    <message>
        <source>Flat ±5 % to</source>
        <translation>Plan ±5 % till</translation>
    </message>
    <message>
        <source>Flat ±10 % to</source>
        <translation>Plan ±10 % till</translation>
    </message>
    <message>
        <source>−3 dB at</source>
        <translation>−3 dB vid</translation>
    </message>
    <message>
        <source>Usable band</source>
        <translation>Användbart område</translation>
    </message>
    <message>
        <source>Shot %1</source>
        <translation>Skott %1</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>Medelvärde</translation>
    </message>
    <message>
        <source>%1 % (one sample late)</source>
        <translation>%1 % (ett sampel sent)</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 till %2</translation>
    </message>
    <message>
        <source>Residual autocorrelation</source>
        <translation>Residualens autokorrelation</translation>
    </message>
    <message>
        <source>Resonance and plateau of each shot and level</source>
        <translation>Resonans och platå för varje skott och nivå</translation>
    </message>
    <message>
        <source>Second-order sensor</source>
        <translation>Givare av andra ordningen</translation>
    </message>
    <message>
        <source>Modes taken out of the model</source>
        <translation>Moder borttagna ur modellen</translation>
    </message>
    <message>
        <source>Poles, trend and other tables</source>
        <translation>Poler, trend och andra tabeller</translation>
    </message>
    <message>
        <source>Pole map</source>
        <translation>Polkarta</translation>
    </message>
    <message>
        <source>Shots, levels</source>
        <translation>Skott, nivåer</translation>
    </message>
    <message>
        <source>2nd order</source>
        <translation>2:a ordningen</translation>
    </message>
    <message>
        <source>Not the sensor</source>
        <translation>Inte givaren</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Visas</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alla</translation>
    </message>
    <message>
        <source>Draw the pinned orders</source>
        <translation>Rita de fästa ordningarna</translation>
    </message>
    <message>
        <source>Draw the 2nd-order sensor</source>
        <translation>Rita givaren av 2:a ordningen</translation>
    </message>
    <message>
        <source>Noise in u</source>
        <translation>Brus i u</translation>
    </message>
    <message>
        <source>%1, ζ %2, FIT %3 %%4</source>
        <translation>%1, ζ %2, FIT %3 %%4</translation>
    </message>
    <message>
        <source>: does not describe the data</source>
        <translation>: beskriver inte data</translation>
    </message>
    <message>
        <source>Uncertainties of the poles, comparison of the shots and second-order sensor: not yet.</source>
        <translation>Polernas osäkerheter, jämförelsen av skotten och andra ordningens givare: ännu inte.</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>ännu inte</translation>
    </message>
</context>
<context>
    <name>dyncal::NeededNumbers</name>
    <message>
        <source>needed</source>
        <translation>behövs</translation>
    </message>
    <message>
        <source>This value is needed as long as the others stand; it stays as it was.</source>
        <translation>Värdet behövs så länge de andra står kvar; det förblir som det var.</translation>
    </message>
    <message>
        <source>Not used yet; still needed: %1.</source>
        <translation>Används inte än; behövs ännu: %1.</translation>
    </message>
</context>
<context>
    <name>dyncal::NextBar</name>
    <message>
        <source>What next, and key results</source>
        <translation>Vad härnäst, och huvudresultat</translation>
    </message>
    <message>
        <source>Everything else that a certificate still lacks</source>
        <translation>Allt annat som ett kalibreringsbevis ännu saknar</translation>
    </message>
    <message>
        <source>Go to where this is settled</source>
        <translation>Gå dit där detta avgörs</translation>
    </message>
    <message>
        <source>What next:</source>
        <translation>Vad härnäst:</translation>
    </message>
    <message>
        <source>Nothing is missing: the certificate can be exported.</source>
        <translation>Ingenting saknas: kalibreringsbeviset kan exporteras.</translation>
    </message>
    <message>
        <source>What next: open captures.</source>
        <translation>Vad härnäst: öppna registreringar.</translation>
    </message>
    <message>
        <source>Out of date.</source>
        <translation>Inaktuellt.</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n till</numerusform>
            <numerusform>%n till</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dyncal::NuisanceList</name>
    <message>
        <source>shot %1: %2</source>
        <translation>skott %1: %2</translation>
    </message>
    <message>
        <source>not taken out of any shot</source>
        <translation>inte borttagen ur något skott</translation>
    </message>
    <message>
        <source>Oscillations left out</source>
        <translation>Utelämnade svängningar</translation>
    </message>
    <message>
        <source>Leave in again</source>
        <translation>Ta med igen</translation>
    </message>
    <message>
        <source>Leave the selected oscillation in again</source>
        <translation>Ta med den valda svängningen igen</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Kandidater</translation>
    </message>
    <message>
        <source>Frequency of the oscillation</source>
        <translation>Svängningens frekvens</translation>
    </message>
    <message>
        <source>Shot where the frequency was read</source>
        <translation>Skott där frekvensen avlästes</translation>
    </message>
    <message>
        <source>Kind of oscillation</source>
        <translation>Slag av svängning</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Skäl</translation>
    </message>
    <message>
        <source>Leave out of the model</source>
        <translation>Utelämna ur modellen</translation>
    </message>
    <message>
        <source>Leave the oscillation out of the model</source>
        <translation>Utelämna svängningen ur modellen</translation>
    </message>
    <message>
        <source>gas in the tube: moves with the shot</source>
        <translation>gas i röret: flyttar sig med skottet</translation>
    </message>
    <message>
        <source>anything else</source>
        <translation>något annat</translation>
    </message>
    <message>
        <source>needed, is printed</source>
        <translation>krävs, trycks</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Från</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frekvens</translation>
    </message>
    <message>
        <source>In shot</source>
        <translation>I skott</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Slag</translation>
    </message>
    <message>
        <source>marked or typed</source>
        <translation>märkt eller angiven</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>topp</translation>
    </message>
</context>
<context>
    <name>dyncal::OptionalEdit</name>
    <message>
        <source>not known</source>
        <translation>inte känt</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>registrerat</translation>
    </message>
    <message>
        <source>This value is the recording&apos;s</source>
        <translation>Värdet är registreringens</translation>
    </message>
    <message>
        <source>%1: use recorded</source>
        <translation>%1: använd det registrerade</translation>
    </message>
    <message>
        <source>Use recorded: %1</source>
        <translation>Använd det registrerade: %1</translation>
    </message>
    <message>
        <source>%1 is outside %2 to %3.</source>
        <translation>%1 ligger utanför %2 till %3.</translation>
    </message>
</context>
<context>
    <name>dyncal::OrderInspector</name>
    <message>
        <source>Order</source>
        <translation>Ordning</translation>
    </message>
    <message>
        <source>Order: automatic</source>
        <translation>Ordning: automatisk</translation>
    </message>
    <message>
        <source>Use suggestion</source>
        <translation>Använd förslaget</translation>
    </message>
    <message>
        <source>Model on show</source>
        <translation>Visad modell</translation>
    </message>
    <message>
        <source>FIT</source>
        <translation>FIT</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Språng</translation>
    </message>
    <message>
        <source>Over orders</source>
        <translation>Över ordningarna</translation>
    </message>
    <message>
        <source>Poles</source>
        <translation>Poler</translation>
    </message>
    <message>
        <source>Adopt</source>
        <translation>Anta</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Skäl</translation>
    </message>
    <message>
        <source>Why the suggested order</source>
        <translation>Varför den föreslagna ordningen</translation>
    </message>
    <message>
        <source>Stable within</source>
        <translation>Stabil inom</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frekvens</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpning</translation>
    </message>
    <message>
        <source>Change the tolerance of stable frequencies</source>
        <translation>Ändra toleransen för stabila frekvenser</translation>
    </message>
    <message>
        <source>Change the tolerance of stable damping</source>
        <translation>Ändra toleransen för stabil dämpning</translation>
    </message>
    <message>
        <source>Decomposition</source>
        <translation>Uppdelning</translation>
    </message>
    <message>
        <source>Orders offered</source>
        <translation>Ordningar att välja bland</translation>
    </message>
    <message>
        <source>Change the orders offered</source>
        <translation>Ändra ordningarna att välja bland</translation>
    </message>
    <message>
        <source>Hankel rows</source>
        <translation>Hankelrader</translation>
    </message>
    <message>
        <source>Change the Hankel rows</source>
        <translation>Ändra Hankelraderna</translation>
    </message>
    <message>
        <source>Refine the poles (least squares)</source>
        <translation>Förfina polerna (minsta kvadrat)</translation>
    </message>
    <message>
        <source>Refine the poles</source>
        <translation>Förfina polerna</translation>
    </message>
    <message>
        <source>Suggested: order %1. %2</source>
        <translation>Föreslagen: ordning %1. %2</translation>
    </message>
    <message>
        <source>No suggestion yet.</source>
        <translation>Inget förslag ännu.</translation>
    </message>
    <message>
        <source>Being gathered.</source>
        <translation>Samlas in.</translation>
    </message>
    <message>
        <source>%1, damping %2</source>
        <translation>%1, dämpning %2</translation>
    </message>
    <message>
        <source>%1 unstable, %2 at Nyquist</source>
        <translation>%1 instabila, %2 vid Nyquist</translation>
    </message>
    <message>
        <source>factor %1 to the next</source>
        <translation>faktor %1 till nästa</translation>
    </message>
    <message>
        <source>There is no model yet.</source>
        <translation>Det finns ännu ingen modell.</translation>
    </message>
    <message>
        <source>Adopt order %1 (Enter)</source>
        <translation>Anta ordning %1 (Retur)</translation>
    </message>
    <message>
        <source>This order is adopted.</source>
        <translation>Denna ordning är antagen.</translation>
    </message>
    <message>
        <source>Note on order %1: %2</source>
        <translation>Anmärkning till ordning %1: %2</translation>
    </message>
    <message>
        <source>%1, ζ %2 (orders %3 to %4)</source>
        <translation>%1, ζ %2 (ordning %3 till %4)</translation>
    </message>
    <message>
        <source>Natural frequency</source>
        <translation>Egenfrekvens</translation>
    </message>
    <message>
        <source>%1, damping %2; no resonance</source>
        <translation>%1, dämpning %2; ingen resonans</translation>
    </message>
    <message>
        <source>Else</source>
        <translation>Annars</translation>
    </message>
</context>
<context>
    <name>dyncal::OrderPage</name>
    <message>
        <source>Order</source>
        <translation>Modellordning</translation>
    </message>
    <message>
        <source>Drag the cut, click a value or use the arrow keys. Everything follows.</source>
        <translation>Dra i snittet, klicka på ett värde eller använd piltangenterna. Allt följer med.</translation>
    </message>
    <message>
        <source>Singular values</source>
        <translation>Singulärvärden</translation>
    </message>
    <message>
        <source>Data and model</source>
        <translation>Data och modell</translation>
    </message>
    <message>
        <source>Frequency response of the model</source>
        <translation>Modellens frekvenssvar</translation>
    </message>
    <message>
        <source>Poles and zeros</source>
        <translation>Poler och nollställen</translation>
    </message>
    <message>
        <source>Order %1</source>
        <translation>Ordning %1</translation>
    </message>
    <message>
        <source>order</source>
        <translation>ordning</translation>
    </message>
    <message>
        <source>Stabilisation of poles over the order</source>
        <translation>Polernas stabilisering över ordningen</translation>
    </message>
    <message>
        <source>FIT and criteria over the order</source>
        <translation>FIT och kriterier över ordningen</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Fäst</translation>
    </message>
    <message>
        <source>Pin or unpin the order on show (Space)</source>
        <translation>Fäst eller lossa den visade ordningen (blanksteg)</translation>
    </message>
    <message>
        <source>Propose</source>
        <translation>Föreslå</translation>
    </message>
    <message>
        <source>Pin the suggested order, the one that keeps its pairs, and a high one</source>
        <translation>Fäst den föreslagna ordningen, den som behåller sina par och en hög</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabell</translation>
    </message>
    <message>
        <source>Compare the pinned orders in a table</source>
        <translation>Jämför de fästa ordningarna i en tabell</translation>
    </message>
    <message>
        <source>Difference to adopted</source>
        <translation>Skillnad mot den antagna</translation>
    </message>
    <message>
        <source>Adopt order %1</source>
        <translation>Anta ordning %1</translation>
    </message>
    <message>
        <source>Unpin order %1</source>
        <translation>Lossa ordning %1</translation>
    </message>
    <message>
        <source>Pin order %1</source>
        <translation>Fäst ordning %1</translation>
    </message>
    <message>
        <source>Pin the proposed orders</source>
        <translation>Fäst de föreslagna ordningarna</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Lossa</translation>
    </message>
    <message>
        <source>Note on order %1</source>
        <translation>Anmärkning till ordning %1</translation>
    </message>
    <message>
        <source>Singular values: the first %1 of %2</source>
        <translation>Singulärvärden: de första %1 av %2</translation>
    </message>
</context>
<context>
    <name>dyncal::OverviewStrip</name>
    <message>
        <source>Overview of the recording</source>
        <translation>Översikt av registreringen</translation>
    </message>
    <message>
        <source>The whole recording. Drag the box to move the view, its edges to zoom; double click shows everything.</source>
        <translation>Hela registreringen. Dra i rutan för att flytta vyn, i dess kanter för att zooma; dubbelklicka för att visa allt.</translation>
    </message>
</context>
<context>
    <name>dyncal::PlotExportActions</name>
    <message numerus="yes">
        <source>Stopped, because the settings changed: %n plot(s) written to %1</source>
        <translation>
            <numerusform>Avbrutet, eftersom inställningarna ändrades: %n diagram skrivet till %1</numerusform>
            <numerusform>Avbrutet, eftersom inställningarna ändrades: %n diagram skrivna till %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Plots are still being written; wait until they are.</source>
        <translation>Diagram skrivs fortfarande; vänta tills det är klart.</translation>
    </message>
    <message>
        <source>The results are still being computed; try again in a moment.</source>
        <translation>Resultaten beräknas fortfarande; försök igen om ett ögonblick.</translation>
    </message>
    <message>
        <source>There is no curve in this plot.</source>
        <translation>Det finns ingen kurva i det här diagrammet.</translation>
    </message>
    <message>
        <source>This plot is not written, because it is not what the settings give: %1</source>
        <translation>Det här diagrammet skrivs inte, eftersom det inte är vad inställningarna ger: %1</translation>
    </message>
    <message>
        <source>Export plot</source>
        <translation>Exportera diagram</translation>
    </message>
    <message>
        <source>Vector image (*.svg);;Image (*.png);;PDF (*.pdf);;Data (*.csv)</source>
        <translation>Vektorbild (*.svg);;Bild (*.png);;PDF (*.pdf);;Data (*.csv)</translation>
    </message>
    <message>
        <source>A plot cannot be written as %1; choose a name that ends in .svg, .png, .pdf or .csv.</source>
        <translation>Ett diagram kan inte skrivas som %1; välj ett namn som slutar på .svg, .png, .pdf eller .csv.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Skrivet: %1</translation>
    </message>
    <message>
        <source>Save all plots into a folder</source>
        <translation>Spara alla diagram i en mapp</translation>
    </message>
    <message numerus="yes">
        <source>%n plot(s) written to %1</source>
        <translation>
            <numerusform>%n diagram skrivet till %1</numerusform>
            <numerusform>%n diagram skrivna till %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dyncal::PlotWidget</name>
    <message>
        <source>Copy image</source>
        <translation>Kopiera bild</translation>
    </message>
    <message>
        <source>Copy data</source>
        <translation>Kopiera data</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exportera...</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassa</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Rutnät</translation>
    </message>
    <message>
        <source>Go to...</source>
        <translation>Gå till...</translation>
    </message>
    <message>
        <source>Values at the cursors</source>
        <translation>Värden vid markörerna</translation>
    </message>
</context>
<context>
    <name>dyncal::PreviewPanel</name>
    <message>
        <source>Size of the preview</source>
        <translation>Förhandsvisningens storlek</translation>
    </message>
    <message>
        <source>Page width</source>
        <translation>Sidbredd</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>The document follows when the results are computed.</source>
        <translation>Dokumentet visas när resultaten är beräknade.</translation>
    </message>
    <message>
        <source>The document is being drawn...</source>
        <translation>Dokumentet ritas...</translation>
    </message>
    <message>
        <source>Page %1 of %2, as it would be exported now</source>
        <translation>Sida %1 av %2, så som det skulle exporteras nu</translation>
    </message>
</context>
<context>
    <name>dyncal::ProblemPanel</name>
    <message>
        <source>Files that could not be read</source>
        <translation>Filer som inte kunde läsas</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>What is wrong, and what to do</source>
        <translation>Vad som är fel och vad som kan göras</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Försök igen</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Kopiera allt</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Stäng</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) could not be read. All others are open.</source>
        <translation>
            <numerusform>%n fil kunde inte läsas. Alla andra är öppna.</numerusform>
            <numerusform>%n filer kunde inte läsas. Alla andra är öppna.</numerusform>
        </translation>
    </message>
    <message>
        <source>Import settings...</source>
        <translation>Importinställningar...</translation>
    </message>
    <message>
        <source>Import settings of %1</source>
        <translation>Importinställningar för %1</translation>
    </message>
</context>
<context>
    <name>dyncal::ProgramCall</name>
    <message>
        <source>The command was ended from outside or crashed; what is complete is kept, run it again.</source>
        <translation>Kommandot avslutades utifrån eller kraschade; det som är färdigt är kvar, kör det igen.</translation>
    </message>
    <message>
        <source>%1 could not be started; check that it is there and may be executed.</source>
        <translation>%1 kunde inte startas; kontrollera att det finns och får köras.</translation>
    </message>
</context>
<context>
    <name>dyncal::QuantityEdit</name>
    <message>
        <source>%1 is outside %2 to %3.</source>
        <translation>%1 ligger utanför %2 till %3.</translation>
    </message>
</context>
<context>
    <name>dyncal::ReferencePanel</name>
    <message>
        <source>Compare with a reference transducer</source>
        <translation>Jämför med en referensgivare</translation>
    </message>
    <message>
        <source>S(f) is stated against</source>
        <translation>S(f) anges mot</translation>
    </message>
    <message>
        <source>the computed pressure step</source>
        <translation>det beräknade trycksteget</translation>
    </message>
    <message>
        <source>the reference transducer</source>
        <translation>referensgivaren</translation>
    </message>
    <message>
        <source>the static sensitivity</source>
        <translation>den statiska känsligheten</translation>
    </message>
    <message>
        <source>a step of 1</source>
        <translation>ett steg på 1</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Choose the channel of the reference</source>
        <translation>Välj referensens kanal</translation>
    </message>
    <message>
        <source>Unit of its sensitivity</source>
        <translation>Känslighetens enhet</translation>
    </message>
    <message>
        <source>First say what the reference transducer is: choose the file with its sensitivity, or type all values of the second-order sensor.</source>
        <translation>Ange först vad referensgivaren är: välj filen med dess känslighet, eller skriv in alla värden för givaren av andra ordningen.</translation>
    </message>
    <message>
        <source>Shot %1 has no channel of a reference transducer; give one the role %2 on the page Captures, or choose the channel.</source>
        <translation>Skott %1 har ingen kanal från en referensgivare; ge en kanal rollen %2 på sidan Registreringar, eller välj kanalen.</translation>
    </message>
    <message>
        <source>Compare with nothing</source>
        <translation>Jämför inte</translation>
    </message>
    <message>
        <source>S(f) can be stated against the reference transducer once the comparison is switched on.</source>
        <translation>S(f) kan anges mot referensgivaren när jämförelsen har slagits på.</translation>
    </message>
    <message>
        <source>Change what S(f) is stated against</source>
        <translation>Ändra vad S(f) anges mot</translation>
    </message>
    <message>
        <source>by its role: %1</source>
        <translation>efter rollen: %1</translation>
    </message>
    <message>
        <source>Its channel is recorded in %1, so that its sensitivity is in %2; change the unit of the channel in the import settings, where that is wrong.</source>
        <translation>Dess kanal är registrerad i %1, så att känsligheten är i %2; ändra kanalens enhet i importinställningarna om den är fel.</translation>
    </message>
    <message>
        <source>Change the unit of the reference</source>
        <translation>Ändra referensens enhet</translation>
    </message>
    <message>
        <source>Or a second-order sensor, all u at k = 1</source>
        <translation>Eller en givare av andra ordningen, alla u med k = 1</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Känslighet</translation>
    </message>
    <message>
        <source>u of the sensitivity</source>
        <translation>Känslighetens u</translation>
    </message>
    <message>
        <source>Resonance f₀</source>
        <translation>Resonans f₀</translation>
    </message>
    <message>
        <source>u of f₀</source>
        <translation>u för f₀</translation>
    </message>
    <message>
        <source>Damping ζ</source>
        <translation>Dämpning ζ</translation>
    </message>
    <message>
        <source>u of ζ</source>
        <translation>u för ζ</translation>
    </message>
    <message>
        <source>Use no second-order sensor</source>
        <translation>Använd ingen givare av andra ordningen</translation>
    </message>
    <message>
        <source>Describe the reference transducer</source>
        <translation>Beskriv referensgivaren</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Ändra %1</translation>
    </message>
    <message>
        <source>Its place</source>
        <translation>Dess plats</translation>
    </message>
    <message>
        <source>Delay behind the sensor</source>
        <translation>Fördröjning efter givaren</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>u of the delay</source>
        <translation>Fördröjningens u</translation>
    </message>
    <message>
        <source>within ±0.5 µs</source>
        <translation>inom ±0,5 µs</translation>
    </message>
    <message>
        <source>Correlation with the step</source>
        <translation>Korrelation med steget</translation>
    </message>
</context>
<context>
    <name>dyncal::RegistryRows</name>
    <message>
        <source>reserved</source>
        <translation>reserverat</translation>
    </message>
    <message>
        <source>issued</source>
        <translation>utfärdat</translation>
    </message>
    <message>
        <source>issued as an amendment</source>
        <translation>utfärdat som ändring</translation>
    </message>
    <message>
        <source>replaced</source>
        <translation>ersatt</translation>
    </message>
    <message>
        <source>withdrawn</source>
        <translation>återkallat</translation>
    </message>
    <message>
        <source>void</source>
        <translation>ogiltigt</translation>
    </message>
    <message>
        <source>● valid</source>
        <translation>● giltig</translation>
    </message>
    <message>
        <source>▲ valid, not signed</source>
        <translation>▲ giltig, inte signerad</translation>
    </message>
    <message>
        <source>■ changed</source>
        <translation>■ ändrad</translation>
    </message>
    <message>
        <source>■ missing</source>
        <translation>■ saknas</translation>
    </message>
    <message>
        <source>■ unreadable</source>
        <translation>■ oläslig</translation>
    </message>
    <message>
        <source>certificate</source>
        <translation>bevis</translation>
    </message>
    <message>
        <source>registry</source>
        <translation>register</translation>
    </message>
    <message>
        <source>project</source>
        <translation>projekt</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>inspelning</translation>
    </message>
    <message>
        <source>file</source>
        <translation>fil</translation>
    </message>
    <message>
        <source>▲ unknown signer</source>
        <translation>▲ okänd undertecknare</translation>
    </message>
    <message>
        <source>▲ expired</source>
        <translation>▲ utgången</translation>
    </message>
    <message>
        <source>laboratory</source>
        <translation>laboratorium</translation>
    </message>
    <message>
        <source>customer</source>
        <translation>kund</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>givare</translation>
    </message>
    <message>
        <source>reference instrument</source>
        <translation>referensinstrument</translation>
    </message>
    <message>
        <source>added</source>
        <translation>tillagt</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>ändrat</translation>
    </message>
</context>
<context>
    <name>dyncal::RegistryWindow</name>
    <message>
        <source>Registry</source>
        <translation>Register</translation>
    </message>
    <message>
        <source>&amp;Registry</source>
        <translation>&amp;Register</translation>
    </message>
    <message>
        <source>that of this user</source>
        <translation>denna användares</translation>
    </message>
    <message>
        <source>A file, or postgresql://USER@HOST:PORT/DATABASE of the laboratory&apos;s server</source>
        <translation>En fil, eller postgresql://USER@HOST:PORT/DATABASE på laboratoriets server</translation>
    </message>
    <message>
        <source>&amp;Choose...</source>
        <translation>&amp;Välj...</translation>
    </message>
    <message>
        <source>Re&amp;fresh</source>
        <translation>&amp;Uppdatera</translation>
    </message>
    <message>
        <source>The registry is being read or changed</source>
        <translation>Registret läses eller ändras</translation>
    </message>
    <message>
        <source>Certificates</source>
        <translation>Bevis</translation>
    </message>
    <message>
        <source>Audit trail</source>
        <translation>Händelselogg</translation>
    </message>
    <message>
        <source>Cards</source>
        <translation>Kort</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Verifiera</translation>
    </message>
    <message>
        <source>Registries (*.sqlite);;All files (*)</source>
        <translation>Register (*.sqlite);;Alla filer (*)</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historik</translation>
    </message>
</context>
<context>
    <name>dyncal::RowsView</name>
    <message>
        <source>Show only rows that hold this text</source>
        <translation>Visa bara rader som innehåller denna text</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Sök</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 av %2</translation>
    </message>
</context>
<context>
    <name>dyncal::SelfTestDialog</name>
    <message>
        <source>Checks</source>
        <translation>Kontroller</translation>
    </message>
    <message>
        <source>Self-test of the installation</source>
        <translation>Självtest av installationen</translation>
    </message>
    <message>
        <source>Progress of the self-test</source>
        <translation>Självtestets förlopp</translation>
    </message>
    <message>
        <source>&amp;Test again</source>
        <translation>&amp;Testa igen</translation>
    </message>
    <message>
        <source>&amp;Save report...</source>
        <translation>&amp;Spara rapport...</translation>
    </message>
    <message>
        <source>selftest.pdf and selftest.json, into a folder</source>
        <translation>selftest.pdf och selftest.json, i en mapp</translation>
    </message>
    <message>
        <source>Every step of the method is being compared with what is known of it. This takes some seconds.</source>
        <translation>Varje steg i metoden jämförs med det som är känt om det. Det tar några sekunder.</translation>
    </message>
    <message>
        <source>The self-test was stopped; nothing is known of this installation.</source>
        <translation>Självtestet stoppades; inget är känt om denna installation.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Avbryt</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Stäng</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>stämmer</translation>
    </message>
    <message>
        <source>deviates</source>
        <translation>avviker</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Utfall</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Vad</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Väntat</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Funnet</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerans</translation>
    </message>
    <message>
        <source>Known from</source>
        <translation>Känt ur</translation>
    </message>
    <message>
        <source>How far the result moves when all data change by a part in 10^12</source>
        <translation>Hur långt resultatet flyttar sig när alla data ändras med en del på 10^12</translation>
    </message>
    <message>
        <source>Save the report of the self-test into a folder</source>
        <translation>Spara självtestets rapport i en mapp</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Skrivet: %1</translation>
    </message>
    <message>
        <source>Change for 10⁻¹²</source>
        <translation>Ändring för 10⁻¹²</translation>
    </message>
</context>
<context>
    <name>dyncal::ShockPage</name>
    <message>
        <source>Reference step</source>
        <translation>Referenssteg</translation>
    </message>
    <message>
        <source>Gas state and shock velocity, or a typed step, give the pressure that the sensor saw.</source>
        <translation>Gastillstånd och stötvågens hastighet, eller ett inmatat steg, ger det tryck som givaren utsattes för.</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referens</translation>
    </message>
    <message>
        <source>Compute the step from the shock</source>
        <translation>Beräkna steget ur stötvågen</translation>
    </message>
    <message>
        <source>Pressure step, typed</source>
        <translation>Trycksteg, inmatat</translation>
    </message>
    <message>
        <source>Velocity, typed</source>
        <translation>Hastighet, inmatad</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>beräknat</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>uppmätt</translation>
    </message>
    <message>
        <source>not determined</source>
        <translation>inte bestämt</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Storhet</translation>
    </message>
    <message>
        <source>Shot %1</source>
        <translation>Skott %1</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Skott</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Känslighet</translation>
    </message>
    <message>
        <source>Waves in the tube over distance and time</source>
        <translation>Vågor i röret över avstånd och tid</translation>
    </message>
    <message>
        <source>Arrival of the shock at a sensor</source>
        <translation>Stötvågens ankomst till en givare</translation>
    </message>
    <message>
        <source>States</source>
        <translation>Tillstånd</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Uppmätt</translation>
    </message>
    <message>
        <source>Arrivals</source>
        <translation>Ankomster</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Osäkerhet</translation>
    </message>
    <message>
        <source>Budget of the shot</source>
        <translation>Skottets budget</translation>
    </message>
    <message>
        <source>Peaks and gas</source>
        <translation>Toppar och gas</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Visa</translation>
    </message>
    <message>
        <source>Shot %1 %2</source>
        <translation>Skott %1 %2</translation>
    </message>
    <message>
        <source>Sensitivity: %1, mean over the shots.</source>
        <translation>Känslighet: %1, medelvärde över skotten.</translation>
    </message>
    <message>
        <source>Sensitivity: not determined. %1</source>
        <translation>Känslighet: inte bestämd. %1</translation>
    </message>
    <message>
        <source>Drift to the settle band</source>
        <translation>Drift till slutnivåns band</translation>
    </message>
    <message>
        <source>Change %1 of shot %2</source>
        <translation>Ändra %1 för skott %2</translation>
    </message>
</context>
<context>
    <name>dyncal::ShotChips</name>
    <message>
        <source>Shot %1: %2</source>
        <translation>Skott %1: %2</translation>
    </message>
    <message>
        <source>Shot %1 is excluded: %2</source>
        <translation>Skott %1 är uteslutet: %2</translation>
    </message>
    <message>
        <source>%1 shots</source>
        <translation>%1 skott</translation>
    </message>
</context>
<context>
    <name>dyncal::SigningChoice</name>
    <message>
        <source>Name the file of the key that signs.</source>
        <translation>Ange filen med nyckeln som signerar.</translation>
    </message>
    <message>
        <source>There is no key file %1; choose another.</source>
        <translation>Det finns ingen nyckelfil %1; välj en annan.</translation>
    </message>
    <message>
        <source>Name the key of the token that signs, as pkcs11:token=NAME;object=LABEL.</source>
        <translation>Ange nyckeln i den token som signerar, som pkcs11:token=NAMN;object=ETIKETT.</translation>
    </message>
    <message>
        <source>Name the command of the service that signs.</source>
        <translation>Ange kommandot för tjänsten som signerar.</translation>
    </message>
</context>
<context>
    <name>dyncal::SigningPanel</name>
    <message>
        <source>Signature</source>
        <translation>Signatur</translation>
    </message>
    <message>
        <source>C&amp;hoose...</source>
        <translation>Väl&amp;j...</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ingen</translation>
    </message>
    <message>
        <source>Key file (PKCS#12 or PEM)</source>
        <translation>Nyckelfil (PKCS#12 eller PEM)</translation>
    </message>
    <message>
        <source>Token (PKCS#11)</source>
        <translation>Token (PKCS#11)</translation>
    </message>
    <message>
        <source>Seal service (a command)</source>
        <translation>Sigilltjänst (ett kommando)</translation>
    </message>
    <message>
        <source>&amp;Signed by</source>
        <translation>&amp;Signeras med</translation>
    </message>
    <message>
        <source>&amp;Key file</source>
        <translation>&amp;Nyckelfil</translation>
    </message>
    <message>
        <source>Key of the &amp;token</source>
        <translation>Nyckel i &amp;token</translation>
    </message>
    <message>
        <source>Co&amp;mmand</source>
        <translation>Komman&amp;do</translation>
    </message>
    <message>
        <source>Time stamp &amp;authority</source>
        <translation>T&amp;idsstämplingstjänst</translation>
    </message>
    <message>
        <source>Who signs PDF and DCC, so that others can tell whose they are, unchanged</source>
        <translation>Vem som signerar PDF och DCC, så att andra kan se vems de är, oförändrade</translation>
    </message>
    <message>
        <source>The private key together with its certificate</source>
        <translation>Den privata nyckeln tillsammans med dess certifikat</translation>
    </message>
    <message>
        <source>RFC 7512; the token&apos;s library by module-path=FILE in it, else by PKCS11_MODULE_PATH</source>
        <translation>RFC 7512; tokenens bibliotek med module-path=FIL i den, annars med PKCS11_MODULE_PATH</translation>
    </message>
    <message>
        <source>It gets the SHA-256 to be signed and answers with a CMS (docs/signatures.md)</source>
        <translation>Det får den SHA-256 som ska signeras och svarar med en CMS (docs/signatures.md)</translation>
    </message>
    <message>
        <source>Goes to the program that signs, and is kept nowhere</source>
        <translation>Går till programmet som signerar och sparas ingenstans</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>http://HOST/PATH of an authority that stamps the time of the signature (RFC 3161)</source>
        <translation>http://VÄRD/SÖKVÄG till en tjänst som stämplar signaturens tid (RFC 3161)</translation>
    </message>
    <message>
        <source>&amp;PIN</source>
        <translation>&amp;PIN</translation>
    </message>
    <message>
        <source>&amp;Passphrase</source>
        <translation>&amp;Lösenfras</translation>
    </message>
    <message>
        <source>Key that signs</source>
        <translation>Nyckel som signerar</translation>
    </message>
    <message>
        <source>Keys (*.p12 *.pfx *.pem);;All files (*)</source>
        <translation>Nycklar (*.p12 *.pfx *.pem);;Alla filer (*)</translation>
    </message>
</context>
<context>
    <name>dyncal::SourceNotice</name>
    <message numerus="yes">
        <source>%n more file(s) likewise.</source>
        <translation>
            <numerusform>Detsamma gäller %n fil till.</numerusform>
            <numerusform>Detsamma gäller %n filer till.</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation>Mapp med registreringarna</translation>
    </message>
</context>
<context>
    <name>dyncal::SourcePanel</name>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Choose a file...</source>
        <translation>Välj en fil...</translation>
    </message>
    <message>
        <source>Use no file</source>
        <translation>Använd ingen fil</translation>
    </message>
    <message>
        <source>List in the certificate</source>
        <translation>Lista i certifikatet</translation>
    </message>
    <message>
        <source>Response over frequency</source>
        <translation>Svar över frekvens</translation>
    </message>
    <message>
        <source>Tables and certificates (*.csv *.txt *.xml);;All files (*)</source>
        <translation>Tabeller och certifikat (*.csv *.txt *.xml);;Alla filer (*)</translation>
    </message>
    <message>
        <source>Choose %1</source>
        <translation>Välj %1</translation>
    </message>
    <message>
        <source>Choose the list in the certificate</source>
        <translation>Välj listan i certifikatet</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>to be chosen</source>
        <translation>att välja</translation>
    </message>
    <message>
        <source>the only one</source>
        <translation>den enda</translation>
    </message>
    <message>
        <source>Certificate number</source>
        <translation>Bevisets nummer</translation>
    </message>
    <message>
        <source>Change the number of the certificate</source>
        <translation>Ändra bevisets nummer</translation>
    </message>
</context>
<context>
    <name>dyncal::SpectrumPage</name>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Power spectral density</source>
        <translation>Effektspektraltäthet</translation>
    </message>
    <message>
        <source>Resonances</source>
        <translation>Resonanser</translation>
    </message>
    <message>
        <source>Resonance</source>
        <translation>Resonans</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Källa</translation>
    </message>
    <message>
        <source>search in the spectrum</source>
        <translation>sök i spektrumet</translation>
    </message>
    <message>
        <source>given by me</source>
        <translation>angiven av mig</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frekvens</translation>
    </message>
    <message>
        <source>Search from</source>
        <translation>Sök från</translation>
    </message>
    <message>
        <source>Search to</source>
        <translation>Sök till</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>ingen gräns</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Skattning</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Metod</translation>
    </message>
    <message>
        <source>periodogram</source>
        <translation>periodogram</translation>
    </message>
    <message>
        <source>Welch average</source>
        <translation>Welch-medelvärde</translation>
    </message>
    <message>
        <source>Change the spectrum&apos;s method</source>
        <translation>Ändra spektrumets metod</translation>
    </message>
    <message>
        <source>Taper</source>
        <translation>Fönsterfunktion</translation>
    </message>
    <message>
        <source>rectangular</source>
        <translation>rektangulär</translation>
    </message>
    <message>
        <source>Hann</source>
        <translation>Hann</translation>
    </message>
    <message>
        <source>Change the taper</source>
        <translation>Ändra fönsterfunktionen</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Dra bort</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>inget</translation>
    </message>
    <message>
        <source>the mean</source>
        <translation>medelvärdet</translation>
    </message>
    <message>
        <source>a straight line</source>
        <translation>en rät linje</translation>
    </message>
    <message>
        <source>Change what is taken away</source>
        <translation>Ändra vad som dras bort</translation>
    </message>
    <message>
        <source>Change where the resonance comes from</source>
        <translation>Ändra varifrån resonansen kommer</translation>
    </message>
    <message>
        <source>Change the search band</source>
        <translation>Ändra sökbandet</translation>
    </message>
    <message>
        <source>Give the resonance</source>
        <translation>Ange resonansen</translation>
    </message>
    <message>
        <source>Above background</source>
        <translation>Över bakgrunden</translation>
    </message>
    <message>
        <source>Q</source>
        <translation>Q</translation>
    </message>
    <message>
        <source>Shot %1</source>
        <translation>Skott %1</translation>
    </message>
    <message>
        <source>Confirm the resonance. With &quot;given by me&quot; a click on a peak takes it; else the click marks an oscillation that is not the sensor&apos;s.</source>
        <translation>Bekräfta resonansen. Med &quot;angiven av mig&quot; tas en topp genom att klicka på den; annars märker klicket en svängning som inte är givarens.</translation>
    </message>
    <message>
        <source>Not the sensor</source>
        <translation>Inte givaren</translation>
    </message>
    <message>
        <source>Leave an oscillation out of the model</source>
        <translation>Utelämna en svängning ur modellen</translation>
    </message>
    <message>
        <source>Leave an oscillation in the model</source>
        <translation>Ta med en svängning i modellen</translation>
    </message>
</context>
<context>
    <name>dyncal::StageList</name>
    <message>
        <source>Stages</source>
        <translation>Arbetssteg</translation>
    </message>
    <message>
        <source>Stage %1: %2, %3 (%4)</source>
        <translation>Steg %1: %2, %3 (%4)</translation>
    </message>
</context>
<context>
    <name>dyncal::StagePage</name>
    <message>
        <source>Nothing to show yet</source>
        <translation>Inget att visa än</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Ångra</translation>
    </message>
    <message>
        <source>Takes the last change back (Ctrl+Z)</source>
        <translation>Tar tillbaka den senaste ändringen (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Ångra: %1</translation>
    </message>
    <message>
        <source>As before the last change: %1</source>
        <translation>Som före den senaste ändringen: %1</translation>
    </message>
    <message>
        <source>These long curves are being drawn.</source>
        <translation>De här långa kurvorna ritas just nu.</translation>
    </message>
</context>
<context>
    <name>dyncal::StartPage</name>
    <message>
        <source>Dynamic calibration of pressure sensors</source>
        <translation>Dynamisk kalibrering av tryckgivare</translation>
    </message>
    <message>
        <source>Open captures...</source>
        <translation>Öppna registreringar...</translation>
    </message>
    <message>
        <source>The recordings of one sensor: one or more shots from a shock tube</source>
        <translation>Registreringarna av en givare: ett eller flera skott från ett stötrör</translation>
    </message>
    <message>
        <source>Open example (3 shots)</source>
        <translation>Öppna exempel (3 skott)</translation>
    </message>
    <message>
        <source>A simulated sensor with a resonance at 2.33 MHz, to try every stage on</source>
        <translation>En simulerad givare med en resonans vid 2,33 MHz, att prova varje arbetssteg på</translation>
    </message>
    <message>
        <source>Open project...</source>
        <translation>Öppna projekt...</translation>
    </message>
    <message>
        <source>Go on with a calibration saved earlier</source>
        <translation>Fortsätt med en tidigare sparad kalibrering</translation>
    </message>
    <message>
        <source>Or drop recordings, a folder or a project here.</source>
        <translation>Eller släpp registreringar, en mapp eller ett projekt här.</translation>
    </message>
</context>
<context>
    <name>dyncal::StatedPanel</name>
    <message>
        <source>%1: u = %2</source>
        <translation>%1: u = %2</translation>
    </message>
    <message>
        <source>%1, certificate %2</source>
        <translation>%1, certifikat %2</translation>
    </message>
    <message>
        <source>%1, due %2</source>
        <translation>%1, gäller till %2</translation>
    </message>
    <message>
        <source>Stated u and their references</source>
        <translation>Angivna u och deras referenser</translation>
    </message>
    <message>
        <source>Stated u of the budget</source>
        <translation>Budgetens angivna u</translation>
    </message>
    <message>
        <source>Add a stated u</source>
        <translation>Lägg till ett angivet u</translation>
    </message>
    <message>
        <source>Change a stated u</source>
        <translation>Ändra ett angivet u</translation>
    </message>
    <message>
        <source>Remove a stated u</source>
        <translation>Ta bort ett angivet u</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Ingång</translation>
    </message>
    <message>
        <source>The input of the budget that this u is of</source>
        <translation>Budgetens ingång som detta u gäller</translation>
    </message>
    <message>
        <source>Standard uncertainty u</source>
        <translation>Standardosäkerhet u</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>behövs</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Fördelning</translation>
    </message>
    <message>
        <source>The shape that the Monte Carlo draws from</source>
        <translation>Formen som Monte Carlo drar ur</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Frihetsgrader</translation>
    </message>
    <message>
        <source>Certificate of the reference</source>
        <translation>Referensens certifikat</translation>
    </message>
    <message>
        <source>Number of the certificate that this u is taken from; it makes the result traceable</source>
        <translation>Numret på certifikatet som detta u är hämtat ur; det gör resultatet spårbart</translation>
    </message>
    <message>
        <source>Due date of the reference</source>
        <translation>Referensen gäller till</translation>
    </message>
    <message>
        <source>The day until which the reference&apos;s calibration holds</source>
        <translation>Dagen till vilken referensens kalibrering gäller</translation>
    </message>
    <message>
        <source>YYYY-MM-DD</source>
        <translation>ÅÅÅÅ-MM-DD</translation>
    </message>
</context>
<context>
    <name>dyncal::StretchList</name>
    <message>
        <source>Shot %1</source>
        <translation>Skott %1</translation>
    </message>
    <message>
        <source>Shots %1</source>
        <translation>Skott %1</translation>
    </message>
    <message>
        <source>%1: %2 to %3</source>
        <translation>%1: %2 till %3</translation>
    </message>
    <message>
        <source>Exclude a stretch</source>
        <translation>Utelämna en sträcka</translation>
    </message>
    <message>
        <source>Leave in again</source>
        <translation>Ta med igen</translation>
    </message>
    <message>
        <source>Mark a stretch to be left out of the fit</source>
        <translation>Markera en sträcka som ska utelämnas ur anpassningen</translation>
    </message>
    <message>
        <source>Stretches left out of the fit</source>
        <translation>Sträckor utelämnade ur anpassningen</translation>
    </message>
    <message>
        <source>Begin of the stretch</source>
        <translation>Sträckans början</translation>
    </message>
    <message>
        <source>End of the stretch</source>
        <translation>Sträckans slut</translation>
    </message>
    <message>
        <source>Shots of the stretch</source>
        <translation>Sträckans skott</translation>
    </message>
    <message>
        <source>Reason for leaving the stretch out</source>
        <translation>Skäl till att sträckan utelämnas</translation>
    </message>
    <message>
        <source>What the stretch selected needs</source>
        <translation>Vad den valda sträckan saknar</translation>
    </message>
    <message>
        <source>Leave the selected stretch in again</source>
        <translation>Ta med den valda sträckan igen</translation>
    </message>
    <message>
        <source>Then drag over it in a plot; Shift and drag do the same at any time</source>
        <translation>Dra sedan över den i ett diagram; Skift och dra gör detsamma när som helst</translation>
    </message>
    <message>
        <source>needed, is printed</source>
        <translation>krävs, trycks</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Början</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Slut</translation>
    </message>
    <message>
        <source>In</source>
        <translation>I</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Skäl</translation>
    </message>
    <message>
        <source>Everything in the window is fitted.</source>
        <translation>Allt i fönstret anpassas.</translation>
    </message>
</context>
<context>
    <name>dyncal::StretchMarking</name>
    <message>
        <source>Not applied: type a reason.</source>
        <translation>Tillämpas inte: skriv ett skäl.</translation>
    </message>
    <message>
        <source>Not applied: the end must lie behind the begin.</source>
        <translation>Tillämpas inte: slutet måste ligga efter början.</translation>
    </message>
    <message>
        <source>Not applied: the window reaches from 0 to %1.</source>
        <translation>Tillämpas inte: fönstret sträcker sig från 0 till %1.</translation>
    </message>
    <message>
        <source>Leave a stretch out</source>
        <translation>Utelämna en sträcka</translation>
    </message>
    <message>
        <source>Change a stretch left out</source>
        <translation>Ändra en utelämnad sträcka</translation>
    </message>
    <message>
        <source>Leave a stretch in again</source>
        <translation>Ta med en sträcka igen</translation>
    </message>
    <message>
        <source>Move a stretch left out</source>
        <translation>Flytta en utelämnad sträcka</translation>
    </message>
    <message>
        <source>Not applied.</source>
        <translation>Tillämpas inte.</translation>
    </message>
    <message>
        <source>Not used: shot %1 is excluded.</source>
        <translation>Används inte: skott %1 är uteslutet.</translation>
    </message>
    <message>
        <source>All shots</source>
        <translation>Alla skott</translation>
    </message>
    <message>
        <source>Shot %1 %2</source>
        <translation>Skott %1 %2</translation>
    </message>
    <message>
        <source>shot %1: no reason yet</source>
        <translation>skott %1: inget skäl ännu</translation>
    </message>
    <message>
        <source>shot %1: left out</source>
        <translation>skott %1: utelämnad</translation>
    </message>
</context>
<context>
    <name>dyncal::TemplatePanel</name>
    <message>
        <source>Template</source>
        <translation>Mall</translation>
    </message>
    <message>
        <source>Choose a template&apos;s file...</source>
        <translation>Välj en malls fil...</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Språk</translation>
    </message>
    <message>
        <source>Change the certificate&apos;s template</source>
        <translation>Ändra kalibreringsbevisets mall</translation>
    </message>
    <message>
        <source>Change the certificate&apos;s language</source>
        <translation>Ändra kalibreringsbevisets språk</translation>
    </message>
    <message>
        <source>Choose %1</source>
        <translation>Välj %1</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>The certificate of an accredited laboratory.</source>
        <translation>Beviset från ett ackrediterat laboratorium.</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Fullständig</translation>
    </message>
    <message>
        <source>With all figures of the method.</source>
        <translation>Med metodens alla figurer.</translation>
    </message>
    <message>
        <source>Short</source>
        <translation>Kort</translation>
    </message>
    <message>
        <source>Without shots, model and figures.</source>
        <translation>Utan skott, modell och figurer.</translation>
    </message>
    <message>
        <source>Research</source>
        <translation>Forskning</translation>
    </message>
    <message>
        <source>With every figure there is.</source>
        <translation>Med alla figurer som finns.</translation>
    </message>
</context>
<context>
    <name>dyncal::TrailTab</name>
    <message>
        <source>Entry</source>
        <translation>Post</translation>
    </message>
    <message>
        <source>Time (UTC)</source>
        <translation>Tid (UTC)</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Vem</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Vad</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Om</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Skäl</translation>
    </message>
    <message>
        <source>Audit trail</source>
        <translation>Händelselogg</translation>
    </message>
    <message>
        <source>The entry that is selected, before and after</source>
        <translation>Den valda posten, före och efter</translation>
    </message>
    <message>
        <source>Select an entry to see what it changed.</source>
        <translation>Välj en post för att se vad den ändrade.</translation>
    </message>
    <message>
        <source>Program: %1</source>
        <translation>Program: %1</translation>
    </message>
    <message>
        <source>SHA-256: %1</source>
        <translation>SHA-256: %1</translation>
    </message>
    <message>
        <source>Before:</source>
        <translation>Före:</translation>
    </message>
    <message>
        <source>After:</source>
        <translation>Efter:</translation>
    </message>
</context>
<context>
    <name>dyncal::TubeModeChoice</name>
    <message>
        <source>Tube modes: computed, not identified</source>
        <translation>Rörmoder: beräknade, inte identifierade</translation>
    </message>
    <message>
        <source>Ticks</source>
        <translation>Märken</translation>
    </message>
    <message>
        <source>Where the tube may ring by its dimensions and the gas: computed, not identified. (m,n) across the tube, 5.1 its wall, 5.2 its gas before the burst, a5 and mix along it behind the shocks.</source>
        <translation>Där röret kan svänga enligt sina mått och gasen: beräknat, inte identifierat. (m,n) tvärs röret, 5.1 dess vägg, 5.2 dess gas före membranbrottet, a5 och bland. längs det bakom stötvågorna.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ingen</translation>
    </message>
    <message>
        <source>of shot %1</source>
        <translation>för skott %1</translation>
    </message>
</context>
<context>
    <name>dyncal::UncertaintyPage</name>
    <message>
        <source>Uncertainty</source>
        <translation>Osäkerhet</translation>
    </message>
    <message>
        <source>The budget of every value that is stated, and what would make its uncertainty smaller.</source>
        <translation>Mätosäkerhetsbudgeten för varje värde som anges, och vad som skulle minska dess osäkerhet.</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Budget</translation>
    </message>
    <message>
        <source>All values</source>
        <translation>Alla värden</translation>
    </message>
    <message>
        <source>More shots</source>
        <translation>Fler skott</translation>
    </message>
    <message>
        <source>Magnitude of the frequency response with its uncertainty</source>
        <translation>Frekvenssvarets belopp med dess osäkerhet</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Storhet</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frekvens</translation>
    </message>
    <message>
        <source>Wanted uncertainty</source>
        <translation>Önskad osäkerhet</translation>
    </message>
    <message>
        <source>U, wanted</source>
        <translation>U, önskat</translation>
    </message>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>What if: %1</source>
        <translation>Prövas: %1</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Ingång</translation>
    </message>
    <message>
        <source>Shots</source>
        <translation>Skott</translation>
    </message>
</context>
<context>
    <name>dyncal::VerifyTab</name>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Slag</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Utfall</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Läge</translation>
    </message>
    <message>
        <source>First difference, or remarks</source>
        <translation>Första skillnad, eller anmärkningar</translation>
    </message>
    <message>
        <source>What was verified</source>
        <translation>Vad som verifierats</translation>
    </message>
    <message>
        <source>&amp;Folder...</source>
        <translation>&amp;Mapp...</translation>
    </message>
    <message>
        <source>The folder of a certificate, or one above several</source>
        <translation>Mappen för ett bevis, eller en ovanför flera</translation>
    </message>
    <message>
        <source>F&amp;iles...</source>
        <translation>F&amp;iler...</translation>
    </message>
    <message>
        <source>Certificates, results, projects, recordings or a registry</source>
        <translation>Bevis, resultat, projekt, inspelningar eller ett register</translation>
    </message>
    <message>
        <source>Folder to verify</source>
        <translation>Mapp att verifiera</translation>
    </message>
    <message>
        <source>Files to verify</source>
        <translation>Filer att verifiera</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alla filer (*)</translation>
    </message>
    <message>
        <source>Signed by</source>
        <translation>Signerat av</translation>
    </message>
    <message>
        <source>Signed at</source>
        <translation>Signerat den</translation>
    </message>
    <message>
        <source>Time stamp</source>
        <translation>Tidsstämpel</translation>
    </message>
    <message>
        <source>&amp;Trusted certificates</source>
        <translation>&amp;Betrodda certifikat</translation>
    </message>
    <message>
        <source>none: every signer is unknown</source>
        <translation>inga: varje undertecknare är okänd</translation>
    </message>
    <message>
        <source>A PEM file with certificates of authorities or signers that you know to be genuine</source>
        <translation>En PEM-fil med certifikat för utfärdare eller undertecknare som du vet är äkta</translation>
    </message>
    <message>
        <source>C&amp;hoose...</source>
        <translation>Väl&amp;j...</translation>
    </message>
    <message>
        <source>Valid &amp;on</source>
        <translation>&amp;Giltigt den</translation>
    </message>
    <message>
        <source>today</source>
        <translation>i dag</translation>
    </message>
    <message>
        <source>The day on which the signer&apos;s certificate must be valid, as 2026-01-31; a time stamp stands for an earlier one</source>
        <translation>Dagen då undertecknarens certifikat måste gälla, som 2026-01-31; en tidsstämpel står för en tidigare</translation>
    </message>
    <message>
        <source>Trusted certificates</source>
        <translation>Betrodda certifikat</translation>
    </message>
    <message>
        <source>Certificates (*.pem *.crt *.cer);;All files (*)</source>
        <translation>Certifikat (*.pem *.crt *.cer);;Alla filer (*)</translation>
    </message>
    <message numerus="yes">
        <source>■ %n changed, missing or unreadable</source>
        <translation>
            <numerusform>■ %n ändrad, saknad eller oläslig</numerusform>
            <numerusform>■ %n ändrade, saknade eller oläsliga</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>▲ %n unchanged, but not signed, or by a signer that is not known or expired</source>
        <translation>
            <numerusform>▲ %n oförändrad, men inte signerad, eller av en undertecknare som är okänd eller vars certifikat gått ut</numerusform>
            <numerusform>▲ %n oförändrade, men inte signerade, eller av en undertecknare som är okänd eller vars certifikat gått ut</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>● %n valid</source>
        <translation>
            <numerusform>● %n giltig</numerusform>
            <numerusform>● %n giltiga</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dyncal::WhatIfPanel</name>
    <message>
        <source>What if</source>
        <translation>Pröva</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Ingång</translation>
    </message>
    <message>
        <source>u, tried</source>
        <translation>u, prövat</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>som det är</translation>
    </message>
    <message>
        <source>u as it is</source>
        <translation>u som det är</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>Överta</translation>
    </message>
    <message>
        <source>State what is tried in the recipe&apos;s uncertainty budget</source>
        <translation>Ange det prövade i receptets mätosäkerhetsbudget</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Återställ</translation>
    </message>
    <message>
        <source>Drop what is tried; the recipe stays as it is</source>
        <translation>Släpp det prövade; receptet förblir som det är</translation>
    </message>
    <message>
        <source>Type another u, or choose a row of the budget: every U follows, the recipe stays as it is.</source>
        <translation>Skriv ett annat u, eller välj en rad i budgeten: varje U följer med, receptet förblir som det är.</translation>
    </message>
    <message>
        <source>Every U is shown as it would be; the recipe is as before.</source>
        <translation>Varje U visas som det skulle bli; receptet är som förut.</translation>
    </message>
    <message>
        <source>Tried only; the budget of the recipe cannot state: %1.</source>
        <translation>Bara prövat; receptets budget kan inte ange: %1.</translation>
    </message>
    <message>
        <source>Change the uncertainty budget</source>
        <translation>Ändra mätosäkerhetsbudgeten</translation>
    </message>
</context>
<context>
    <name>dyncal::WindowPage</name>
    <message>
        <source>Window</source>
        <translation>Fönster</translation>
    </message>
    <message>
        <source>Drag the bands and lines. All shots are aligned on their own start.</source>
        <translation>Dra i banden och linjerna. Alla skott är inpassade efter sin egen start.</translation>
    </message>
    <message>
        <source>Response, remapped, with the bands</source>
        <translation>Svar, omskalat, med banden</translation>
    </message>
    <message>
        <source>First stretch of the response</source>
        <translation>Svarets första avsnitt</translation>
    </message>
    <message>
        <source>Levels and step of every shot</source>
        <translation>Nivåer och steg för varje skott</translation>
    </message>
    <message>
        <source>Baseline, after the start</source>
        <translation>Baslinje, efter starten</translation>
    </message>
    <message>
        <source>Subtract the baseline</source>
        <translation>Dra ifrån baslinjen</translation>
    </message>
    <message>
        <source>Baseline</source>
        <translation>Baslinje</translation>
    </message>
    <message>
        <source>Change the baseline</source>
        <translation>Ändra baslinjen</translation>
    </message>
    <message>
        <source>Window, after the start</source>
        <translation>Fönster, efter starten</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Slut</translation>
    </message>
    <message>
        <source>Change the window&apos;s end</source>
        <translation>Ändra fönstrets slut</translation>
    </message>
    <message>
        <source>End with the computed plateau</source>
        <translation>Sluta med den beräknade platån</translation>
    </message>
    <message>
        <source>End with the plateau</source>
        <translation>Sluta med platån</translation>
    </message>
    <message>
        <source>Settle</source>
        <translation>Slutnivå</translation>
    </message>
    <message>
        <source>Change the settle band</source>
        <translation>Ändra slutnivåbandet</translation>
    </message>
    <message>
        <source>Remap to 0..1</source>
        <translation>Skala om till 0..1</translation>
    </message>
    <message>
        <source>Remap</source>
        <translation>Skala om</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Längd</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Upplösning</translation>
    </message>
    <message>
        <source>Values of</source>
        <translation>Värden för</translation>
    </message>
    <message>
        <source>What is automatic may differ from shot to shot</source>
        <translation>Det som är automatiskt kan skilja sig mellan skotten</translation>
    </message>
    <message>
        <source>Start, on the record&apos;s own axis</source>
        <translation>Start, på registreringens egen axel</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Move the baseline</source>
        <translation>Flytta baslinjen</translation>
    </message>
    <message>
        <source>Move the settle band</source>
        <translation>Flytta slutnivåbandet</translation>
    </message>
    <message>
        <source>Move the window&apos;s end</source>
        <translation>Flytta fönstrets slut</translation>
    </message>
    <message>
        <source>Move the start</source>
        <translation>Flytta starten</translation>
    </message>
    <message>
        <source>Detect the start</source>
        <translation>Detektera starten</translation>
    </message>
    <message>
        <source>Change the start</source>
        <translation>Ändra starten</translation>
    </message>
    <message>
        <source>baseline</source>
        <translation>baslinje</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>slutnivå</translation>
    </message>
    <message>
        <source>start</source>
        <translation>start</translation>
    </message>
    <message>
        <source>end</source>
        <translation>slut</translation>
    </message>
    <message>
        <source>Shot %1 %2</source>
        <translation>Skott %1 %2</translation>
    </message>
    <message>
        <source>%1, %2 samples</source>
        <translation>%1, %2 sampel</translation>
    </message>
    <message>
        <source>%1 (1 / length)</source>
        <translation>%1 (1 / längd)</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Skott</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>Slutnivå</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>SNR</source>
        <translation>SNR</translation>
    </message>
    <message>
        <source>Rise 10–90 %</source>
        <translation>Stigtid 10–90 %</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Översväng</translation>
    </message>
    <message>
        <source>Settling ±5 %</source>
        <translation>Insvängning ±5 %</translation>
    </message>
    <message>
        <source>plateau over (computed)</source>
        <translation>platån slut (beräknat)</translation>
    </message>
    <message>
        <source>Left out of the fit, after the start</source>
        <translation>Utelämnat ur anpassningen, efter starten</translation>
    </message>
    <message>
        <source>End of</source>
        <translation>Slut för</translation>
    </message>
    <message>
        <source>all shots</source>
        <translation>alla skott</translation>
    </message>
    <message>
        <source>each shot by itself</source>
        <translation>varje skott för sig</translation>
    </message>
    <message>
        <source>Give each shot an end of its own</source>
        <translation>Ge varje skott ett eget slut</translation>
    </message>
    <message>
        <source>Give all shots one end</source>
        <translation>Ge alla skott ett gemensamt slut</translation>
    </message>
    <message>
        <source>end of shot %1</source>
        <translation>slut för skott %1</translation>
    </message>
</context>
<context>
    <name>dyncal::WorkRecovery</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>%1 days</source>
        <translation>%1 dagar</translation>
    </message>
    <message>
        <source>an unsaved project</source>
        <translation>ett osparat projekt</translation>
    </message>
    <message>
        <source>the example</source>
        <translation>exemplet</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 och %n till</numerusform>
            <numerusform>%1 och %n till</numerusform>
        </translation>
    </message>
    <message>
        <source>The recovered work on %1 is discarded.</source>
        <translation>Det räddade arbetet med %1 är kastat.</translation>
    </message>
    <message>
        <source>Work of a stopped program could not be read: %1 It is kept as %2.</source>
        <translation>Arbete från ett stoppat program kunde inte läsas: %1 Det finns kvar som %2.</translation>
    </message>
    <message>
        <source>Recovered work on %1 from %2 (%3 before stop).</source>
        <translation>Räddat arbete med %1 från %2 (%3 före stoppet).</translation>
    </message>
    <message>
        <source>The project was saved after that, at %1.</source>
        <translation>Projektet sparades efter det, %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n more after this one.</source>
        <translation>
            <numerusform>%n till efter detta.</numerusform>
            <numerusform>%n till efter detta.</numerusform>
        </translation>
    </message>
    <message>
        <source>It is kept, but could not be opened now: %1</source>
        <translation>Det finns kvar men kunde inte öppnas nu: %1</translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation>Mapp med registreringarna</translation>
    </message>
    <message>
        <source>Not auto-saved: %1</source>
        <translation>Inte sparat automatiskt: %1</translation>
    </message>
    <message>
        <source>Auto-saved %1</source>
        <translation>Sparat automatiskt %1</translation>
    </message>
</context>
<context>
    <name>dyncal::WorkStatus</name>
    <message>
        <source>Computing</source>
        <translation>Beräknar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Cancel the work under way</source>
        <translation>Avbryt pågående arbete</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Förlopp</translation>
    </message>
</context>
</TS>
