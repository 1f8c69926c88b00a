<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>CaptureText</name>
    <message>
        <source>Low</source>
        <translation>Niedrig</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>High</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>DUT</source>
        <translation>Prüfling</translation>
    </message>
    <message>
        <source>Driven side</source>
        <translation>Wand Niederdruckteil</translation>
    </message>
    <message>
        <source>Driver</source>
        <translation>Hochdruckteil</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Andere</translation>
    </message>
</context>
<context>
    <name>Plots</name>
    <message>
        <source>Residual autocorrelation; dotted: white noise</source>
        <translation>Autokorrelation des Residuums; gepunktet: weißes Rauschen</translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation>Autokorrelation</translation>
    </message>
    <message>
        <source>Autocorrelation of data minus model with the bounds of white noise.</source>
        <translation>Autokorrelation von Daten minus Modell mit den Grenzen weißen Rauschens.</translation>
    </message>
    <message>
        <source>2nd-order sensor</source>
        <translation>Aufnehmer 2. Ordnung</translation>
    </message>
    <message>
        <source>shock</source>
        <translation>Stoßwelle</translation>
    </message>
    <message>
        <source>reflected</source>
        <translation>reflektierte</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Kontaktfläche</translation>
    </message>
    <message>
        <source>its echo</source>
        <translation>deren Echo</translation>
    </message>
    <message>
        <source>expansion head</source>
        <translation>Kopf der Verdünnungswelle</translation>
    </message>
    <message>
        <source>expansion tail</source>
        <translation>Ende der Verdünnungswelle</translation>
    </message>
    <message>
        <source>plateau</source>
        <translation>Plateau</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>gesehen</translation>
    </message>
    <message>
        <source>end wall</source>
        <translation>Endwand</translation>
    </message>
    <message>
        <source>mix</source>
        <comment>tube mode</comment>
        <translation>Gemisch</translation>
    </message>
    <message>
        <source>Waves in the tube, shot %1</source>
        <translation>Wellen im Rohr, Schuss %1</translation>
    </message>
    <message>
        <source>Distance from the diaphragm</source>
        <translation>Abstand von der Membran</translation>
    </message>
    <message>
        <source>No diagram: the tube&apos;s lengths or the velocity are unknown.</source>
        <translation>Kein Diagramm: Die Längen des Rohrs oder die Geschwindigkeit sind unbekannt.</translation>
    </message>
    <message>
        <source>diaphragm</source>
        <translation>Membran</translation>
    </message>
    <message>
        <source>Waves in the tube; the plateau at the end wall lasts %1.</source>
        <translation>Wellen im Rohr; das Plateau an der Endwand dauert %1.</translation>
    </message>
    <message>
        <source>Arrival at %1, shot %2</source>
        <translation>Ankunft bei %1, Schuss %2</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>before</source>
        <translation>davor</translation>
    </message>
    <message>
        <source>50 %</source>
        <translation>50 %</translation>
    </message>
    <message>
        <source>behind the shock</source>
        <translation>hinter der Stoßwelle</translation>
    </message>
    <message>
        <source>driver gas (computed)</source>
        <translation>Treibergas (berechnet)</translation>
    </message>
    <message>
        <source>plateau ends (computed)</source>
        <translation>Plateau endet (berechnet)</translation>
    </message>
    <message>
        <source> – tube modes computed</source>
        <translation> – Rohrmoden berechnet</translation>
    </message>
    <message>
        <source>Pressure behind the recording</source>
        <translation>Druck hinter der Aufzeichnung</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>%1, upper end of 95 %</source>
        <translation>%1, oberes Ende von 95 %</translation>
    </message>
    <message>
        <source>%1, lower end of 95 %</source>
        <translation>%1, unteres Ende von 95 %</translation>
    </message>
    <message>
        <source>Pressure up to %1 with its band of 95 %; recordings: %2.</source>
        <translation>Druck bis %1 mit seinem Band von 95 %; Aufzeichnungen: %2.</translation>
    </message>
    <message>
        <source>Order %1</source>
        <translation>Ordnung %1</translation>
    </message>
    <message>
        <source>Magnitude against the reference transducer; the pressure step is not known well enough to compare.</source>
        <translation>Betrag gegen den Referenzaufnehmer; der Drucksprung ist für einen Vergleich nicht gut genug bekannt.</translation>
    </message>
    <message>
        <source>Magnitude against the reference transducer and against the pressure step; these differ by %1 on the mean.</source>
        <translation>Betrag gegen den Referenzaufnehmer und gegen den Drucksprung; im Mittel unterscheiden sich diese um %1.</translation>
    </message>
    <message>
        <source>Pressure step</source>
        <translation>Drucksprung</translation>
    </message>
    <message>
        <source>Reference transducer</source>
        <translation>Referenzaufnehmer</translation>
    </message>
    <message>
        <source>%1, ± U</source>
        <translation>%1, ± U</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Magnitude against reference transducer and pressure step</source>
        <translation>Betrag gegen Referenzaufnehmer und Drucksprung</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Both magnitudes less their mean</source>
        <translation>Beide Beträge abzüglich ihres Mittels</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Step less transducer, over the U of the difference</source>
        <translation>Sprung abzüglich Aufnehmer, durch U der Differenz</translation>
    </message>
    <message>
        <source>Eₙ</source>
        <translation>Eₙ</translation>
    </message>
    <message>
        <source>Eₙ over frequency; beyond ±1 at %1 of %2 frequencies.</source>
        <translation>Eₙ über der Frequenz; jenseits ±1 bei %1 von %2 Frequenzen.</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>f stable</source>
        <translation>f stabil</translation>
    </message>
    <message>
        <source>f, ζ stable</source>
        <translation>f, ζ stabil</translation>
    </message>
    <message>
        <source>Unstable</source>
        <translation>Instabil</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>order %1</source>
        <translation>Ordnung %1</translation>
    </message>
    <message>
        <source>Stabilisation: poles of all orders</source>
        <translation>Stabilisierung: Pole aller Ordnungen</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>No order has an oscillating pole.</source>
        <translation>Keine Ordnung hat einen schwingenden Pol.</translation>
    </message>
    <message>
        <source>Poles of orders 1 to %1: %2, of which stable: %3. f stable: the frequency was there at the order before; f, ζ stable: the damping ratio, too; new: neither; behind them the mean spectrum.</source>
        <translation>Pole der Ordnungen 1 bis %1: %2, davon stabil: %3. f stabil: Die Frequenz gab es schon bei der Ordnung davor; f, ζ stabil: den Dämpfungsgrad auch; neu: keines von beiden; dahinter das mittlere Spektrum.</translation>
    </message>
    <message>
        <source>FIT and criteria over the order</source>
        <translation>FIT und Kriterien über der Ordnung</translation>
    </message>
    <message>
        <source>FIT</source>
        <translation>FIT</translation>
    </message>
    <message>
        <source>BIC</source>
        <translation>BIC</translation>
    </message>
    <message>
        <source>Left-out error</source>
        <translation>Fehler des ausgelassenen Schusses</translation>
    </message>
    <message>
        <source>attainable %1 %</source>
        <translation>erreichbar %1 %</translation>
    </message>
    <message>
        <source>FIT, error of each shot by the poles of the others, and information criterion (BIC) of every order; order %1 is chosen.</source>
        <translation>FIT, Fehler jedes Schusses mit den Polen der anderen und Informationskriterium (BIC) jeder Ordnung; gewählt ist Ordnung %1.</translation>
    </message>
    <message>
        <source>Suggested: %1</source>
        <translation>Vorgeschlagen: %1</translation>
    </message>
    <message>
        <source>Model input</source>
        <translation>Modelleingang</translation>
    </message>
    <message>
        <source>Full rate</source>
        <translation>Volle Rate</translation>
    </message>
    <message>
        <source>Model input; samples in each series: %1.</source>
        <translation>Modelleingang; Abtastwerte in jeder Reihe: %1.</translation>
    </message>
    <message>
        <source>Singular values</source>
        <translation>Singulärwerte</translation>
    </message>
    <message>
        <source>Singular value</source>
        <translation>Singulärwert</translation>
    </message>
    <message>
        <source>Belongs to the step</source>
        <translation>Gehört zum Sprung</translation>
    </message>
    <message>
        <source>Noise: median to 95 %</source>
        <translation>Rauschen: Median bis 95 %</translation>
    </message>
    <message>
        <source>Singular values: %1; suggested order: %2.</source>
        <translation>Singulärwerte: %1; vorgeschlagene Ordnung: %2.</translation>
    </message>
    <message>
        <source>Bayesian information criterion</source>
        <translation>Bayessches Informationskriterium</translation>
    </message>
    <message>
        <source>BIC of orders 1 to %1; the smallest is best.</source>
        <translation>BIC der Ordnungen 1 bis %1; das kleinste ist das beste.</translation>
    </message>
    <message>
        <source>The BIC could not be formed for these data.</source>
        <translation>Das BIC konnte für diese Daten nicht gebildet werden.</translation>
    </message>
    <message>
        <source>Non-parametric</source>
        <translation>Nichtparametrisch</translation>
    </message>
    <message>
        <source>Magnitude of the frequency response; its expanded uncertainty is not known.</source>
        <translation>Betrag des Frequenzgangs; seine erweiterte Messunsicherheit ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Magnitude of the frequency response; U is %1 to %2 of it.</source>
        <translation>Betrag des Frequenzgangs; U ist %1 bis %2 davon.</translation>
    </message>
    <message>
        <source>Frequency response with its expanded uncertainty U</source>
        <translation>Frequenzgang mit seiner erweiterten Messunsicherheit U</translation>
    </message>
    <message>
        <source>± U</source>
        <translation>± U</translation>
    </message>
    <message>
        <source>U, relative</source>
        <translation>U, relativ</translation>
    </message>
    <message>
        <source>U, what if</source>
        <translation>U, was wäre wenn</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>budget</source>
        <translation>Budget</translation>
    </message>
    <message>
        <source>Explained by the first components</source>
        <translation>Durch die ersten Komponenten erklärt</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Komponenten</translation>
    </message>
    <message>
        <source>Explained, cumulative</source>
        <translation>Erklärt, aufsummiert</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>One shot only: there are no components to compare.</source>
        <translation>Nur ein Schuss: Es gibt keine Komponenten zu vergleichen.</translation>
    </message>
    <message>
        <source>The first component explains %1 %.</source>
        <translation>Die erste Komponente erklärt %1 %.</translation>
    </message>
    <message>
        <source>Left by the first components</source>
        <translation>Von den ersten Komponenten übrig gelassen</translation>
    </message>
    <message>
        <source>Not explained</source>
        <translation>Nicht erklärt</translation>
    </message>
    <message>
        <source>5 %</source>
        <translation>5 %</translation>
    </message>
    <message>
        <source>The first component leaves %1 %.</source>
        <translation>Die erste Komponente lässt %1 % übrig.</translation>
    </message>
    <message>
        <source>Reconstructed; components kept: %1</source>
        <translation>Rekonstruiert; behaltene Komponenten: %1</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Residuen</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Residuum</translation>
    </message>
    <message>
        <source>What the components leave of each shot.</source>
        <translation>Was die Komponenten von jedem Schuss übrig lassen.</translation>
    </message>
    <message>
        <source>Autocovariance; dotted: white noise</source>
        <translation>Autokovarianz; gepunktet: weißes Rauschen</translation>
    </message>
    <message>
        <source>Lag</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Autocovariance, normalised</source>
        <translation>Autokovarianz, normiert</translation>
    </message>
    <message>
        <source>Autocovariance of the residuals with the bounds of white noise.</source>
        <translation>Autokovarianz der Residuen mit den Grenzen weißen Rauschens.</translation>
    </message>
    <message>
        <source>Power spectrum of the residuals</source>
        <translation>Leistungsspektrum der Residuen</translation>
    </message>
    <message>
        <source>Power spectra of the residuals; the strongest maximum of each shot is marked.</source>
        <translation>Leistungsspektren der Residuen; das stärkste Maximum jedes Schusses ist markiert.</translation>
    </message>
    <message>
        <source>Average of the reconstructions</source>
        <translation>Mittel der Rekonstruktionen</translation>
    </message>
    <message>
        <source>low</source>
        <translation>niedrig</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>mittel</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Shot %1</source>
        <translation>Schuss %1</translation>
    </message>
    <message>
        <source>All values</source>
        <translation>Alle Werte</translation>
    </message>
    <message>
        <source>Power spectral density</source>
        <translation>Leistungsdichte</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Response, remapped</source>
        <translation>Antwort, normiert</translation>
    </message>
    <message>
        <source>Response in %1</source>
        <translation>Antwort in %1</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Model of order %1</source>
        <translation>Modell der Ordnung %1</translation>
    </message>
    <message>
        <source>Poles of the sensor</source>
        <translation>Pole des Aufnehmers</translation>
    </message>
    <message>
        <source>Pole of the step</source>
        <translation>Pol des Sprungs</translation>
    </message>
    <message>
        <source>Unstable poles</source>
        <translation>Instabile Pole</translation>
    </message>
    <message>
        <source>Poles at the Nyquist frequency</source>
        <translation>Pole bei der Nyquist-Frequenz</translation>
    </message>
    <message>
        <source>Other poles</source>
        <translation>Andere Pole</translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation>untere Grenze</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>obere Grenze</translation>
    </message>
    <message>
        <source>± 2u</source>
        <translation>± 2u</translation>
    </message>
    <message>
        <source>Non-parametric values withheld: %1 of %2; results and findings say why.</source>
        <translation>Nichtparametrische Werte zurückgehalten: %1 von %2; Ergebnisse und Befunde sagen, warum.</translation>
    </message>
    <message>
        <source>Data and model of order %1: diverges</source>
        <translation>Daten und Modell der Ordnung %1: divergiert</translation>
    </message>
    <message>
        <source>Data and model of order %1</source>
        <translation>Daten und Modell der Ordnung %1</translation>
    </message>
    <message>
        <source>Data and model of order %1; the fit is %2 %.</source>
        <translation>Daten und Modell der Ordnung %1; die Anpassung ist %2 %.</translation>
    </message>
    <message>
        <source>Data minus model</source>
        <translation>Daten minus Modell</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Poles and zeros, order %1</source>
        <translation>Pole und Nullstellen, Ordnung %1</translation>
    </message>
    <message>
        <source>Real part</source>
        <translation>Realteil</translation>
    </message>
    <message>
        <source>Imaginary part</source>
        <translation>Imaginärteil</translation>
    </message>
    <message>
        <source>Zeros</source>
        <translation>Nullstellen</translation>
    </message>
    <message>
        <source>poles: %1, zeros: %2</source>
        <translation>Pole: %1, Nullstellen: %2</translation>
    </message>
    <message>
        <source>further out than shown: %1</source>
        <translation>weiter außen als gezeigt: %1</translation>
    </message>
    <message>
        <source>Frequency response, magnitude</source>
        <translation>Frequenzgang, Betrag</translation>
    </message>
    <message>
        <source>Magnitude of the frequency response; usable from %1 to %2.</source>
        <translation>Betrag des Frequenzgangs; brauchbar von %1 bis %2.</translation>
    </message>
    <message>
        <source>Frequency response, phase</source>
        <translation>Frequenzgang, Phase</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Phase of the frequency response, output over input, lag negative.</source>
        <translation>Phase des Frequenzgangs, Ausgang gegen Eingang, Verzögerung negativ.</translation>
    </message>
    <message>
        <source>Step response of the model</source>
        <translation>Sprungantwort des Modells</translation>
    </message>
    <message>
        <source>Step response of the model: diverges</source>
        <translation>Sprungantwort des Modells: divergiert</translation>
    </message>
    <message>
        <source>This calibration</source>
        <translation>Diese Kalibrierung</translation>
    </message>
    <message>
        <source>Other calibrations</source>
        <translation>Andere Kalibrierungen</translation>
    </message>
    <message>
        <source>static</source>
        <translation>statisch</translation>
    </message>
    <message>
        <source>S(f) beside %1 values of other calibrations; %2 agree within U.</source>
        <translation>S(f) neben %1 Werten anderer Kalibrierungen; %2 stimmen innerhalb U überein.</translation>
    </message>
    <message>
        <source>Magnitude and values of other calibrations</source>
        <translation>Betrag und Werte anderer Kalibrierungen</translation>
    </message>
    <message>
        <source>Less the sensitivity at the onset</source>
        <translation>Abzüglich der Empfindlichkeit beim Einsatz</translation>
    </message>
    <message>
        <source>Sensor under test</source>
        <translation>Kalibriergegenstand</translation>
    </message>
    <message>
        <source>Side wall, driven section</source>
        <translation>Seitenwand, Niederdruckteil</translation>
    </message>
    <message>
        <source>Driver section</source>
        <translation>Hochdruckteil</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>Other channel</source>
        <translation>Anderer Kanal</translation>
    </message>
    <message>
        <source>%1; recordings: %2.</source>
        <translation>%1; Aufzeichnungen: %2.</translation>
    </message>
    <message>
        <source>Responses, aligned at the start</source>
        <translation>Antworten, am Beginn ausgerichtet</translation>
    </message>
    <message>
        <source>Responses aligned at the start; shots: %1.</source>
        <translation>Am Beginn ausgerichtete Antworten; Schüsse: %1.</translation>
    </message>
    <message>
        <source>Start of the responses</source>
        <translation>Beginn der Antworten</translation>
    </message>
    <message>
        <source>The first moments of the responses; shots: %1.</source>
        <translation>Die ersten Augenblicke der Antworten; Schüsse: %1.</translation>
    </message>
    <message>
        <source>Power spectrum</source>
        <translation>Leistungsspektrum</translation>
    </message>
    <message>
        <source>Power spectrum; no resonance found.</source>
        <translation>Leistungsspektrum; keine Resonanz gefunden.</translation>
    </message>
    <message>
        <source>Power spectrum; main resonance at %1.</source>
        <translation>Leistungsspektrum; Hauptresonanz bei %1.</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>warning limit</source>
        <translation>Warngrenze</translation>
    </message>
    <message>
        <source>action limit</source>
        <translation>Eingriffsgrenze</translation>
    </message>
    <message>
        <source>Year</source>
        <translation>Jahr</translation>
    </message>
    <message>
        <source>Calibrations</source>
        <translation>Kalibrierungen</translation>
    </message>
    <message>
        <source>Conspicuous</source>
        <translation>Auffällig</translation>
    </message>
    <message>
        <source>%1 of a sensor over time, with U; %2 of %3 calibrations are conspicuous.</source>
        <translation>%1 eines Aufnehmers über der Zeit, mit U; %2 von %3 Kalibrierungen sind auffällig.</translation>
    </message>
    <message>
        <source>final value</source>
        <translation>Endwert</translation>
    </message>
    <message>
        <source>final value + overshoot</source>
        <translation>Endwert + Überschwingen</translation>
    </message>
    <message>
        <source>Model, from its own onset</source>
        <translation>Modell, ab eigenem Einsatz</translation>
    </message>
</context>
<context>
    <name>RecipeLabel</name>
    <message>
        <source>components kept</source>
        <translation>behaltene Komponenten</translation>
    </message>
    <message>
        <source>subtract the mean</source>
        <translation>Mittel abziehen</translation>
    </message>
    <message>
        <source>lags</source>
        <translation>Verschiebungen</translation>
    </message>
    <message>
        <source>confidence of the bound</source>
        <translation>Konfidenz der Grenze</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>No. %1</source>
        <translation>Nr. %1</translation>
    </message>
    <message>
        <source>no number yet</source>
        <translation>noch keine Nummer</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>Computed %1</source>
        <translation>Berechnet %1</translation>
    </message>
    <message>
        <source>Issued, not signed</source>
        <translation>Ausgestellt, nicht signiert</translation>
    </message>
    <message>
        <source>Draft, not valid as a certificate</source>
        <translation>Entwurf, nicht als Kalibrierschein gültig</translation>
    </message>
    <message>
        <source>DRAFT</source>
        <translation>ENTWURF</translation>
    </message>
    <message>
        <source>To be filled in before issue: %1.</source>
        <translation>Vor der Ausstellung auszufüllen: %1.</translation>
    </message>
    <message>
        <source>Figure %1. %2.</source>
        <translation>Abbildung %1. %2.</translation>
    </message>
    <message>
        <source>End of the certificate</source>
        <translation>Ende des Kalibrierscheins</translation>
    </message>
    <message>
        <source>End of the report</source>
        <translation>Ende des Berichts</translation>
    </message>
    <message>
        <source>Issued, with an electronic signature</source>
        <translation>Ausgestellt, mit elektronischer Signatur</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>gas in the tube</source>
        <translation>Gas im Rohr</translation>
    </message>
    <message>
        <source>other</source>
        <translation>andere</translation>
    </message>
    <message>
        <source>Oscillations that are not the sensor&apos;s, left out of the model</source>
        <translation>Schwingungen, die nicht die des Aufnehmers sind und im Modell weggelassen wurden</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Schuss</translation>
    </message>
    <message>
        <source>Undamped frequency</source>
        <translation>Unge­dämpfte Frequenz</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>Dämpfungs­grad</translation>
    </message>
    <message>
        <source>Size, of the plateau</source>
        <translation>Größe, bezogen auf das Plateau</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>What leaving them out has changed, at the same order</source>
        <translation>Was das Weglassen bei gleicher Ordnung geändert hat</translation>
    </message>
    <message>
        <source>Oscillations</source>
        <translation>Schwin­gungen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Residual, rms of the plateau</source>
        <translation>Residuum, Effektivwert, bezogen auf das Plateau</translation>
    </message>
    <message>
        <source>Plateau gain</source>
        <translation>Plateauwert</translation>
    </message>
    <message>
        <source>left in</source>
        <translation>belassen</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>The oscillations above were fitted in each shot together with the sensor. Poles and all results are those of the sensor without them; the fit counts them.</source>
        <translation>Die obigen Schwingungen wurden in jedem Schuss zusammen mit dem Aufnehmer angepasst. Pole und alle Ergebnisse sind die des Aufnehmers ohne sie; die Anpassung zählt sie mit.</translation>
    </message>
    <message>
        <source>Stretches of the records that were not fitted</source>
        <translation>Abschnitte der Aufzeichnungen, die nicht angepasst wurden</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Times behind the start of the response. These stretches take no part in the model, the fit and its uncertainties; in the response without a model they are filled by the model.</source>
        <translation>Zeiten hinter dem Beginn der Antwort. Diese Abschnitte gehen in das Modell, die Anpassung und deren Unsicherheiten nicht ein; im Frequenzgang ohne Modell sind sie durch das Modell gefüllt.</translation>
    </message>
    <message>
        <source>static</source>
        <translation>statisch</translation>
    </message>
    <message>
        <source>%V1, certificate %V2</source>
        <translation>%V1, Kalibrierschein %V2</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>nicht verglichen</translation>
    </message>
    <message>
        <source>agrees, joined</source>
        <translation>stimmt überein, zusammen­geführt</translation>
    </message>
    <message>
        <source>differs, not joined</source>
        <translation>weicht ab, nicht zusammen­geführt</translation>
    </message>
    <message>
        <source>Values of other calibrations of the item, beside those of this one</source>
        <translation>Werte anderer Kalibrierungen des Kalibriergegenstands neben denen dieser Kalibrierung</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrie­rung</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Its value</source>
        <translation>Deren Wert</translation>
    </message>
    <message>
        <source>This calibration</source>
        <translation>Diese Kalibrie­rung</translation>
    </message>
    <message>
        <source>En</source>
        <translation>En</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>%1: %V2</source>
        <translation>%1: %V2</translation>
    </message>
    <message>
        <source>static: %V1</source>
        <translation>statisch: %V1</translation>
    </message>
    <message>
        <source>Response to a pressure step; the pole of the step is removed before the realisation, so that the model describes the sensor alone.</source>
        <translation>Antwort auf einen Drucksprung; der Pol des Sprungs wird vor der Realisierung entfernt, sodass das Modell allein den Aufnehmer beschreibt.</translation>
    </message>
    <message>
        <source>Response to a pressure step, realised as if it were an impulse response; the model contains the pole of the step.</source>
        <translation>Antwort auf einen Drucksprung, realisiert, als wäre sie eine Impulsantwort; das Modell enthält den Pol des Sprungs.</translation>
    </message>
    <message>
        <source>First difference of the response to a pressure step, realised as an impulse response.</source>
        <translation>Erste Differenz der Antwort auf einen Drucksprung, als Impulsantwort realisiert.</translation>
    </message>
    <message>
        <source>Free decay, realised as an impulse response.</source>
        <translation>Freies Abklingen, als Impulsantwort realisiert.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>to be filled in</source>
        <translation>auszufüllen</translation>
    </message>
    <message>
        <source>orders %1 to %2: frequency %3 %, damping ratio %4 % (half of the range)</source>
        <translation>Ordnungen %1 bis %2: Frequenz %3 %, Dämpfungsgrad %4 % (halbe Spannweite)</translation>
    </message>
    <message>
        <source>Reason for the model order</source>
        <translation>Begründung der Modellordnung</translation>
    </message>
    <message>
        <source>Variation of the resonance over the orders</source>
        <translation>Schwankung der Resonanz über die Ordnungen</translation>
    </message>
    <message>
        <source>Shots combined</source>
        <translation>Zusammenfassung der Schüsse</translation>
    </message>
    <message>
        <source>stacked, each with its own amplitude (%1 series)</source>
        <translation>gemeinsam, jeder mit eigener Amplitude (%1 Reihen)</translation>
    </message>
    <message>
        <source>average of the reconstructions from principal components</source>
        <translation>Mittel der Rekonstruktionen aus Hauptkomponenten</translation>
    </message>
    <message>
        <source>Sample rate of the model</source>
        <translation>Abtastrate des Modells</translation>
    </message>
    <message>
        <source>Samples per series</source>
        <translation>Abtastwerte je Reihe</translation>
    </message>
    <message>
        <source>Start of the model input after the onset</source>
        <translation>Beginn des Modelleingangs nach dem Einsatz</translation>
    </message>
    <message>
        <source>Reference transducer, channel</source>
        <translation>Referenzaufnehmer, Kanal</translation>
    </message>
    <message>
        <source>Sensitivity of the reference transducer</source>
        <translation>Empfindlichkeit des Referenzaufnehmers</translation>
    </message>
    <message>
        <source>second-order sensor, as stated by the laboratory: sensitivity %L1, natural frequency %L2, damping ratio %L3</source>
        <translation>Aufnehmer zweiter Ordnung, nach Angabe des Laboratoriums: Empfindlichkeit %L1, Eigenfrequenz %L2, Dämpfungsgrad %L3</translation>
    </message>
    <message>
        <source>file with SHA-256 %1</source>
        <translation>Datei mit SHA-256 %1</translation>
    </message>
    <message>
        <source>Check by the second way: the sensitivity against the computed pressure step less that against the reference transducer is %1 %, with an expanded uncertainty of %2 % (k = 2).</source>
        <translation>Prüfung auf dem zweiten Weg: Die Empfindlichkeit gegen den berechneten Drucksprung abzüglich der gegen den Referenzaufnehmer ist %1 %, mit einer erweiterten Messunsicherheit von %2 % (k = 2).</translation>
    </message>
    <message>
        <source>not determined (no model)</source>
        <translation>nicht bestimmt (kein Modell)</translation>
    </message>
    <message>
        <source>not determined (the model does not oscillate)</source>
        <translation>nicht bestimmt (das Modell schwingt nicht)</translation>
    </message>
    <message>
        <source>Undamped natural frequency</source>
        <translation>Ungedämpfte Eigenfrequenz</translation>
    </message>
    <message>
        <source>Quality factor</source>
        <translation>Gütefaktor</translation>
    </message>
    <message>
        <source>Resonance frequency (largest magnitude)</source>
        <translation>Resonanzfrequenz (größter Betrag)</translation>
    </message>
    <message>
        <source>Magnitude at the resonance over the level at the onset</source>
        <translation>Betrag bei der Resonanz, bezogen auf den Pegel beim Einsatz</translation>
    </message>
    <message>
        <source>withheld (see the frequency response)</source>
        <translation>zurückgehalten (siehe Frequenzgang)</translation>
    </message>
    <message>
        <source>Magnitude at the resonance, from the records</source>
        <translation>Betrag bei der Resonanz, aus den Aufzeichnungen</translation>
    </message>
    <message>
        <source>Magnitude within 5 % up to</source>
        <translation>Betrag innerhalb 5 % bis</translation>
    </message>
    <message>
        <source>Magnitude within 10 % up to</source>
        <translation>Betrag innerhalb 10 % bis</translation>
    </message>
    <message>
        <source>Magnitude above -3 dB up to</source>
        <translation>Betrag über -3 dB bis</translation>
    </message>
    <message>
        <source>Rise time, 10 % to 90 %</source>
        <translation>Anstiegszeit, 10 % bis 90 %</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Über­schwingen</translation>
    </message>
    <message>
        <source>Settling time, within 5 %</source>
        <translation>Einschwingzeit, auf 5 %</translation>
    </message>
    <message>
        <source>Key results</source>
        <translation>Hauptergebnisse</translation>
    </message>
    <message>
        <source>Certificate of dynamic calibration</source>
        <translation>Kalibrierschein über eine dynamische Kalibrierung</translation>
    </message>
    <message>
        <source>Certificate of the normalised dynamic response</source>
        <translation>Kalibrierschein über die normierte dynamische Antwort</translation>
    </message>
    <message>
        <source>Certificate of natural frequency and damping</source>
        <translation>Kalibrierschein über Eigenfrequenz und Dämpfung</translation>
    </message>
    <message>
        <source>The sensitivity S(f) is the complex ratio of the item&apos;s output to the change of pressure at the sensor&apos;s face in the side wall of a shock tube; phase of output over input, lag negative, relative to the sensor&apos;s own onset.</source>
        <translation>Die Empfindlichkeit S(f) ist das komplexe Verhältnis des Ausgangs des Kalibriergegenstands zur Druckänderung an der Stirnfläche des Aufnehmers in der Seitenwand eines Stoßrohrs; Phase des Ausgangs gegen den Eingang, Verzögerung negativ, bezogen auf den eigenen Einsatz des Aufnehmers.</translation>
    </message>
    <message>
        <source>The sensitivity S(f) is the complex ratio of the item&apos;s output to the change of pressure at the sensor&apos;s face in the end-wall plane of a shock tube; phase of output over input, lag negative, relative to the sensor&apos;s own onset.</source>
        <translation>Die Empfindlichkeit S(f) ist das komplexe Verhältnis des Ausgangs des Kalibriergegenstands zur Druckänderung an der Stirnfläche des Aufnehmers in der Ebene der Endwand eines Stoßrohrs; Phase des Ausgangs gegen den Eingang, Verzögerung negativ, bezogen auf den eigenen Einsatz des Aufnehmers.</translation>
    </message>
    <message>
        <source>The sensitivity S(f) is the complex ratio of the item&apos;s output to the change of pressure at the sensor&apos;s face; phase of output over input, lag negative, relative to the sensor&apos;s own onset.</source>
        <translation>Die Empfindlichkeit S(f) ist das komplexe Verhältnis des Ausgangs des Kalibriergegenstands zur Druckänderung an der Stirnfläche des Aufnehmers; Phase des Ausgangs gegen den Eingang, Verzögerung negativ, bezogen auf den eigenen Einsatz des Aufnehmers.</translation>
    </message>
    <message>
        <source>The sensitivity S(f) is the complex ratio of the item&apos;s output to the change of pressure at the sensor&apos;s face, found by comparison with a reference transducer that the same change reached; phase of output over pressure, lag negative.</source>
        <translation>Die Empfindlichkeit S(f) ist das komplexe Verhältnis des Ausgangs des Kalibriergegenstands zur Druckänderung an der Stirnfläche des Aufnehmers, gefunden durch Vergleich mit einem Referenzaufnehmer, den dieselbe Änderung erreichte; Phase des Ausgangs gegen den Druck, Verzögerung negativ.</translation>
    </message>
    <message>
        <source>The normalised response N(f) is the complex ratio of the item&apos;s output to a step, relative to the level at the onset of that step; phase of output over input, lag negative, relative to the sensor&apos;s own onset.</source>
        <translation>Die normierte Antwort N(f) ist das komplexe Verhältnis des Ausgangs des Kalibriergegenstands zu einem Sprung, bezogen auf den Pegel beim Einsatz dieses Sprungs; Phase des Ausgangs gegen den Eingang, Verzögerung negativ, bezogen auf den eigenen Einsatz des Aufnehmers.</translation>
    </message>
    <message>
        <source>The item decayed freely after an excitation that was not measured. Its undamped natural frequencies and damping ratios are determined; the ratio of its output to what excited it is not.</source>
        <translation>Der Kalibriergegenstand klang nach einer Anregung, die nicht gemessen wurde, frei ab. Bestimmt sind seine ungedämpften Eigenfrequenzen und Dämpfungsgrade; das Verhältnis seines Ausgangs zu dem, was ihn anregte, ist es nicht.</translation>
    </message>
    <message>
        <source>The pressure step of each shot follows from the shock wave and the initial state of the gas, unless the section &quot;Conditions&quot; says that it was stated.</source>
        <translation>Der Drucksprung jedes Schusses folgt aus der Stoßwelle und dem Anfangszustand des Gases, sofern der Abschnitt „Bedingungen“ nicht sagt, dass er angegeben wurde.</translation>
    </message>
    <message>
        <source>The pressure step of each shot was stated by the operator. It was not computed, and its uncertainty is not known.</source>
        <translation>Der Drucksprung jedes Schusses wurde vom Bearbeiter angegeben. Er wurde nicht berechnet, und seine Unsicherheit ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The pressure step of each shot is what the reference transducer saw: the settled level of its output over its sensitivity at the lowest frequency of its calibration.</source>
        <translation>Der Drucksprung jedes Schusses ist das, was der Referenzaufnehmer sah: der Beharrungswert seines Ausgangs, geteilt durch seine Empfindlichkeit bei der tiefsten Frequenz seiner Kalibrierung.</translation>
    </message>
    <message>
        <source>The size of the step is not known: no sensitivity is stated, and all magnitudes are relative.</source>
        <translation>Die Größe des Sprungs ist nicht bekannt: Es wird keine Empfindlichkeit angegeben, und alle Beträge sind relativ.</translation>
    </message>
    <message>
        <source>Signal to noise is the largest deflection over the standard deviation of the noise before it. No uncertainty is known of the deflection: it has three significant digits.</source>
        <translation>Der Rauschabstand ist der größte Ausschlag, bezogen auf die Standardabweichung des Rauschens davor. Vom Ausschlag ist keine Unsicherheit bekannt: Er hat drei signifikante Stellen.</translation>
    </message>
    <message>
        <source>not determined (no level at the onset)</source>
        <translation>nicht bestimmt (kein Pegel beim Einsatz)</translation>
    </message>
    <message>
        <source>not determined (no pressure step)</source>
        <translation>nicht bestimmt (kein Drucksprung)</translation>
    </message>
    <message>
        <source>Sensitivity at the onset of the step, low level</source>
        <translation>Empfindlichkeit beim Einsatz des Sprungs, niedrige Stufe</translation>
    </message>
    <message>
        <source>Sensitivity at the onset of the step, medium level</source>
        <translation>Empfindlichkeit beim Einsatz des Sprungs, mittlere Stufe</translation>
    </message>
    <message>
        <source>Sensitivity at the onset of the step, high level</source>
        <translation>Empfindlichkeit beim Einsatz des Sprungs, hohe Stufe</translation>
    </message>
    <message>
        <source>Sensitivity at the onset of the step</source>
        <translation>Empfindlichkeit beim Einsatz des Sprungs</translation>
    </message>
    <message>
        <source>Sensitivity at the onset of the step, mean of the shots</source>
        <translation>Empfindlichkeit beim Einsatz des Sprungs, Mittel der Schüsse</translation>
    </message>
    <message>
        <source>Sensitivity at the onset of the step, mean of the shots, which do not agree</source>
        <translation>Empfindlichkeit beim Einsatz des Sprungs, Mittel der Schüsse, die nicht übereinstimmen</translation>
    </message>
    <message>
        <source>Change of the sensitivity with the step</source>
        <translation>Änderung der Empfindlichkeit mit dem Sprung</translation>
    </message>
    <message>
        <source>Drift of shot %1 behind the step, from the onset to %2 after it (no part of the sensitivity)</source>
        <translation>Drift von Schuss %1 hinter dem Sprung, vom Einsatz bis %2 danach (kein Teil der Empfindlichkeit)</translation>
    </message>
    <message>
        <source>The shots do not agree: the sensitivity is stated for each level, and no mean of all shots.</source>
        <translation>Die Schüsse stimmen nicht überein: Die Empfindlichkeit ist für jede Stufe angegeben, und kein Mittel aller Schüsse.</translation>
    </message>
    <message>
        <source>not determined</source>
        <translation>nicht bestimmt</translation>
    </message>
    <message>
        <source>the magnitude of the response lies within ±%1 % of its value at low frequency, from %2 to %3</source>
        <translation>der Betrag des Frequenzgangs liegt innerhalb von ±%1 % seines Werts bei tiefer Frequenz, von %2 bis %3</translation>
    </message>
    <message>
        <source>simple acceptance (ILAC-G8): the deviation is at most the limit; a deviation at the limit lies beyond it with a probability of up to 50 %</source>
        <translation>einfache Annahme (ILAC-G8): Die Abweichung ist höchstens gleich der Grenze; eine Abweichung an der Grenze liegt mit einer Wahrscheinlichkeit von bis zu 50 % jenseits davon</translation>
    </message>
    <message>
        <source>guard band w = U (ILAC-G8): the deviation is at most the limit less its expanded uncertainty U</source>
        <translation>Schutzband w = U (ILAC-G8): Die Abweichung ist höchstens gleich der Grenze abzüglich ihrer erweiterten Messunsicherheit U</translation>
    </message>
    <message>
        <source>specific risk (JCGM 106): the probability that the deviation lies beyond the limit is at most %1 % at every frequency</source>
        <translation>spezifisches Risiko (JCGM 106): Die Wahrscheinlichkeit, dass die Abweichung jenseits der Grenze liegt, ist bei jeder Frequenz höchstens %1 %</translation>
    </message>
    <message>
        <source>conforms</source>
        <translation>konform</translation>
    </message>
    <message>
        <source>does not conform</source>
        <translation>nicht konform</translation>
    </message>
    <message>
        <source>at %1 the deviation is %2; it lies beyond the limit with a probability of %3 %</source>
        <translation>bei %1 ist die Abweichung %2; sie liegt mit einer Wahrscheinlichkeit von %3 % jenseits der Grenze</translation>
    </message>
    <message>
        <source>Statement of conformity</source>
        <translation>Konformitätsaussage</translation>
    </message>
    <message>
        <source>Claim</source>
        <translation>Spezifikation</translation>
    </message>
    <message>
        <source>Decision rule</source>
        <translation>Entscheidungsregel</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Worst frequency</source>
        <translation>Ungünstigste Frequenz</translation>
    </message>
    <message>
        <source>Judged at %1 frequencies, no two neighbours farther apart than a third of an octave. The deviation is that of the response, as measured without a model, from its value at the onset of the step: what both share, as the pressure step and the gain of the chain, cancels in it and is not part of its uncertainty.</source>
        <translation>Beurteilt bei %1 Frequenzen, von denen keine zwei Nachbarn weiter als eine Terz auseinanderliegen. Die Abweichung ist die des ohne Modell gemessenen Frequenzgangs von seinem Wert beim Einsatz des Sprungs: Was beiden gemeinsam ist, wie der Drucksprung und die Verstärkung der Messkette, hebt sich in ihr auf und gehört nicht zu ihrer Unsicherheit.</translation>
    </message>
    <message>
        <source>not determined (not recorded)</source>
        <translation>nicht bestimmt (nicht aufgezeichnet)</translation>
    </message>
    <message>
        <source>of the reference</source>
        <translation>des Referenzaufnehmers</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>angegeben</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>berechnet</translation>
    </message>
    <message>
        <source>Pressure steps</source>
        <translation>Drucksprünge</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Initial pressure</source>
        <translation>Anfangs­druck</translation>
    </message>
    <message>
        <source>Initial temperature</source>
        <translation>Anfangs­temperatur</translation>
    </message>
    <message>
        <source>Shock velocity</source>
        <translation>Geschwindig­keit der Stoß­welle</translation>
    </message>
    <message>
        <source>Mach number</source>
        <translation>Mach-Zahl</translation>
    </message>
    <message>
        <source>Pressure step</source>
        <translation>Druck­sprung</translation>
    </message>
    <message>
        <source>Step is</source>
        <translation>Sprung ist</translation>
    </message>
    <message>
        <source>U of the step</source>
        <translation>U des Sprungs</translation>
    </message>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>Plateau</source>
        <translation>Plateau</translation>
    </message>
    <message>
        <source>The pressure step is not determined for every shot: neither a step nor a shock velocity with initial pressure and temperature was given. A sensitivity in the unit of pressure cannot be stated for those shots.</source>
        <translation>Der Drucksprung ist nicht für jeden Schuss bestimmt: Weder ein Sprung noch eine Geschwindigkeit der Stoßwelle mit Anfangsdruck und Anfangstemperatur wurde angegeben. Für diese Schüsse kann keine Empfindlichkeit in der Einheit des Drucks angegeben werden.</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>Ambient temperature</source>
        <translation>Umgebungstemperatur</translation>
    </message>
    <message>
        <source>Ambient pressure</source>
        <translation>Umgebungsdruck</translation>
    </message>
    <message>
        <source>No pressure step is determined: neither a step nor a shock velocity with initial pressure and temperature was given. No sensitivity in the unit of pressure can be stated.</source>
        <translation>Kein Drucksprung ist bestimmt: Weder ein Sprung noch eine Geschwindigkeit der Stoßwelle mit Anfangsdruck und Anfangstemperatur wurde angegeben. Es kann keine Empfindlichkeit in der Einheit des Drucks angegeben werden.</translation>
    </message>
    <message>
        <source>lower limit %L1</source>
        <translation>untere Grenze %L1</translation>
    </message>
    <message>
        <source>edge 5 %: %L1</source>
        <translation>Bandkante 5 %: %L1</translation>
    </message>
    <message>
        <source>edge 10 %: %L1</source>
        <translation>Bandkante 10 %: %L1</translation>
    </message>
    <message>
        <source>edge -3 dB: %L1</source>
        <translation>Bandkante -3 dB: %L1</translation>
    </message>
    <message>
        <source>resonance %L1</source>
        <translation>Resonanz %L1</translation>
    </message>
    <message>
        <source>compared at %L1</source>
        <translation>verglichen bei %L1</translation>
    </message>
    <message>
        <source>upper limit %L1</source>
        <translation>obere Grenze %L1</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Model, magnitude</source>
        <translation>Modell, Betrag</translation>
    </message>
    <message>
        <source>Model, phase</source>
        <translation>Modell, Phase</translation>
    </message>
    <message>
        <source>Normalised response over frequency: from the responses without a model, and from the model</source>
        <translation>Normierte Antwort über der Frequenz: aus den Antworten ohne Modell und aus dem Modell</translation>
    </message>
    <message>
        <source>Sensitivity over frequency: from the responses without a model, and from the model</source>
        <translation>Empfindlichkeit über der Frequenz: aus den Antworten ohne Modell und aus dem Modell</translation>
    </message>
    <message>
        <source>Beside the frequencies asked for, the table always has the limits of the band and, where they are known and lie between these, the model&apos;s band edges and resonance. What stands in these lines was computed at exactly these frequencies, as in all others.</source>
        <translation>Neben den verlangten Frequenzen enthält die Tabelle stets die Grenzen des Bandes und, wo sie bekannt sind und dazwischen liegen, die Bandkanten und die Resonanz des Modells. Was in diesen Zeilen steht, wurde wie in allen anderen bei genau diesen Frequenzen berechnet.</translation>
    </message>
    <message>
        <source>A value of another calibration stands in the table of this one, under its name, only where both agree within their expanded uncertainties (absolute En at most 1); below the band it is compared with the sensitivity at the onset of the step. It is no result of this calibration; the line &quot;compared at&quot; of its frequency is.</source>
        <translation>Ein Wert einer anderen Kalibrierung steht in der Tabelle dieser Kalibrierung, unter deren Namen, nur dort, wo beide innerhalb ihrer erweiterten Messunsicherheiten übereinstimmen (Betrag von En höchstens 1); unterhalb des Bandes wird er mit der Empfindlichkeit beim Einsatz des Sprungs verglichen. Er ist kein Ergebnis dieser Kalibrierung; die Zeile „verglichen bei“ seiner Frequenz ist es.</translation>
    </message>
    <message>
        <source>The values without a model are ratios of the item&apos;s record to that of the reference transducer, times its sensitivity; outside the frequencies of its calibration there are none. Where what sampling or the end of the records may change exceeds both the uncertainty of the noise and 2 % of the magnitude, none is stated.</source>
        <translation>Die Werte ohne Modell sind Verhältnisse der Aufzeichnung des Kalibriergegenstands zu der des Referenzaufnehmers, mal dessen Empfindlichkeit; außerhalb der Frequenzen seiner Kalibrierung gibt es keine. Wo das, was die Abtastung oder das Ende der Aufzeichnungen ändern kann, sowohl die Unsicherheit des Rauschens als auch 2 % des Betrags übersteigt, wird kein Wert angegeben.</translation>
    </message>
    <message>
        <source>The values without a model take nothing from it but the zero of time and, where there are any, the drift and what was taken out of the records. Where what sampling or the end of the records may change exceeds both the uncertainty of the noise and 2 % of the magnitude, none is stated; for the sampling it is assumed that above half the sample rate the response is nowhere stronger than just below.</source>
        <translation>Die Werte ohne Modell übernehmen von ihm nichts als den Nullpunkt der Zeit und, wo es sie gibt, die Drift und das, was aus den Aufzeichnungen herausgenommen wurde. Wo das, was die Abtastung oder das Ende der Aufzeichnungen ändern kann, sowohl die Unsicherheit des Rauschens als auch 2 % des Betrags übersteigt, wird kein Wert angegeben; für die Abtastung ist angenommen, dass die Antwort oberhalb der halben Abtastrate nirgends stärker ist als knapp darunter.</translation>
    </message>
    <message>
        <source>The pressure rises over %1 at the sensor, standard uncertainty %2. The values without a model are divided by what an even rise takes off, and its uncertainty is part of theirs; the model is that behind it.</source>
        <translation>Der Druck steigt am Aufnehmer über %1 an, Standardunsicherheit %2. Die Werte ohne Modell sind durch das geteilt, was ein gleichmäßiger Anstieg wegnimmt, und dessen Unsicherheit ist Teil der ihren; das Modell ist das hinter diesem Anstieg.</translation>
    </message>
    <message>
        <source>Of the %1 frequencies asked for, %2 lie outside these limits and have no line.</source>
        <translation>Von den %1 verlangten Frequenzen liegen %2 außerhalb dieser Grenzen und haben keine Zeile.</translation>
    </message>
    <message>
        <source>The magnitude is relative to the level at the onset of the step.</source>
        <translation>Der Betrag ist auf den Pegel beim Einsatz des Sprungs bezogen.</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Frequenzgang</translation>
    </message>
    <message>
        <source>A free decay has no frequency response: what excited the item was not measured.</source>
        <translation>Ein freies Abklingen hat keinen Frequenzgang: Was den Kalibriergegenstand anregte, wurde nicht gemessen.</translation>
    </message>
    <message>
        <source>The frequency response could not be determined.</source>
        <translation>Der Frequenzgang konnte nicht bestimmt werden.</translation>
    </message>
    <message>
        <source>Lower frequency limit</source>
        <translation>Untere Frequenzgrenze</translation>
    </message>
    <message>
        <source>Upper frequency limit</source>
        <translation>Obere Frequenzgrenze</translation>
    </message>
    <message>
        <source>Profile of the laboratory</source>
        <translation>Profil des Laboratoriums</translation>
    </message>
    <message>
        <source>%V1, version %V2 (SHA-256 %V3)</source>
        <translation>%V1, Version %V2 (SHA-256 %V3)</translation>
    </message>
    <message>
        <source>Set otherwise than in the profile</source>
        <translation>Anders eingestellt als im Profil</translation>
    </message>
    <message>
        <source>Response of amplifier and converter</source>
        <translation>Antwort von Verstärker und Wandler</translation>
    </message>
    <message>
        <source>divided out of S(f), file with SHA-256 %1; poles and what follows from them are of sensor and chain together</source>
        <translation>aus S(f) herausgeteilt, Datei mit SHA-256 %1; Pole und was aus ihnen folgt sind die von Aufnehmer und Messkette zusammen</translation>
    </message>
    <message>
        <source>divided out of S(f), certificate %V1, file with SHA-256 %V2; poles and what follows from them are of sensor and chain together</source>
        <translation>aus S(f) herausgeteilt, Kalibrierschein %V1, Datei mit SHA-256 %V2; Pole und was aus ihnen folgt sind die von Aufnehmer und Messkette zusammen</translation>
    </message>
    <message>
        <source>Least U of the laboratory (CMC), below which none is stated</source>
        <translation>Kleinste angebbare Messunsicherheit U des Laboratoriums (CMC), unter der keine angegeben wird</translation>
    </message>
    <message>
        <source>no statement: the response was measured from %1 to %2 only</source>
        <translation>keine Aussage: Die Antwort wurde nur von %1 bis %2 gemessen</translation>
    </message>
    <message>
        <source>no statement: at %1 no value with a complete uncertainty is stated</source>
        <translation>keine Aussage: Bei %1 ist kein Wert mit vollständiger Unsicherheit angegeben</translation>
    </message>
    <message>
        <source>no statement: between %1 and %2 the response has no value; a third of an octave is the widest step</source>
        <translation>keine Aussage: Zwischen %1 und %2 hat die Antwort keinen Wert; eine Terz ist der größte Schritt</translation>
    </message>
    <message>
        <source>no statement: no response over frequency, or its level at low frequency, is known</source>
        <translation>keine Aussage: Keine Antwort über der Frequenz, oder ihr Pegel bei tiefer Frequenz, ist bekannt</translation>
    </message>
    <message>
        <source>no statement: every judged row is accepted, but between them, at %1, the model deviates by %2 %; ask for rows there (response.frequencies)</source>
        <translation>keine Aussage: Jede beurteilte Zeile ist angenommen, aber dazwischen, bei %1, weicht das Modell um %2 % ab; dort Zeilen verlangen (response.frequencies)</translation>
    </message>
    <message>
        <source>Recordings of the item calibrated</source>
        <translation>Aufzeichnungen des Kalibriergegenstands</translation>
    </message>
    <message>
        <source>Recordings of the sensors in the wall of the driven section</source>
        <translation>Aufzeichnungen der Aufnehmer in der Wand des Niederdruckteils</translation>
    </message>
    <message>
        <source>Recordings of the sensor in the driver section</source>
        <translation>Aufzeichnungen des Aufnehmers im Hochdruckteil</translation>
    </message>
    <message>
        <source>Responses of the item, aligned at their start</source>
        <translation>Antworten des Kalibriergegenstands, an ihrem Beginn ausgerichtet</translation>
    </message>
    <message>
        <source>First moments of the responses</source>
        <translation>Erste Augenblicke der Antworten</translation>
    </message>
    <message>
        <source>Power spectra of the responses</source>
        <translation>Leistungsspektren der Antworten</translation>
    </message>
    <message>
        <source>Share explained by the first principal components</source>
        <translation>Durch die ersten Hauptkomponenten erklärter Anteil</translation>
    </message>
    <message>
        <source>Responses reconstructed from the components kept</source>
        <translation>Aus den behaltenen Komponenten rekonstruierte Antworten</translation>
    </message>
    <message>
        <source>Residuals of the reconstruction</source>
        <translation>Residuen der Rekonstruktion</translation>
    </message>
    <message>
        <source>Autocovariance of the residuals; dotted: white noise</source>
        <translation>Autokovarianz der Residuen; gepunktet: weißes Rauschen</translation>
    </message>
    <message>
        <source>Power spectra of the residuals</source>
        <translation>Leistungsspektren der Residuen</translation>
    </message>
    <message>
        <source>Average of the reconstructions</source>
        <translation>Mittel der Rekonstruktionen</translation>
    </message>
    <message>
        <source>Input of the model</source>
        <translation>Eingang des Modells</translation>
    </message>
    <message>
        <source>Singular values of the Hankel matrix</source>
        <translation>Singulärwerte der Hankel-Matrix</translation>
    </message>
    <message>
        <source>Bayesian information criterion over the order</source>
        <translation>Bayessches Informationskriterium über der Ordnung</translation>
    </message>
    <message>
        <source>Responses and model</source>
        <translation>Antworten und Modell</translation>
    </message>
    <message>
        <source>Responses minus model</source>
        <translation>Antworten minus Modell</translation>
    </message>
    <message>
        <source>Step response of the model</source>
        <translation>Sprungantwort des Modells</translation>
    </message>
    <message>
        <source>Frequency response, magnitude</source>
        <translation>Frequenzgang, Betrag</translation>
    </message>
    <message>
        <source>Frequency response, phase</source>
        <translation>Frequenzgang, Phase</translation>
    </message>
    <message>
        <source>Magnitude against the reference transducer and against the pressure step, less the mean of both</source>
        <translation>Betrag gegen den Referenzaufnehmer und gegen den Drucksprung, abzüglich des Mittels beider</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Abbildungen</translation>
    </message>
    <message>
        <source>low</source>
        <translation>niedrig</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>mittel</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>Replaces</source>
        <translation>Ersetzt</translation>
    </message>
    <message>
        <source>certificate %V1, which is no longer valid; what changed: %V2</source>
        <translation>Kalibrierschein %V1, der nicht mehr gültig ist; was geändert wurde: %V2</translation>
    </message>
    <message>
        <source>Issue</source>
        <translation>Ausstellung</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>issued, not signed</source>
        <translation>ausgestellt, nicht signiert</translation>
    </message>
    <message>
        <source>issued as an amendment, not signed</source>
        <translation>ausgestellt als Änderung, nicht signiert</translation>
    </message>
    <message>
        <source>Audit trail before issuing (SHA-256)</source>
        <translation>Änderungsprotokoll vor der Ausstellung (SHA-256)</translation>
    </message>
    <message>
        <source>SHA-256 of results.json</source>
        <translation>SHA-256 von results.json</translation>
    </message>
    <message>
        <source>dyncal verify holds this page, the files beside it and the laboratory&apos;s registry against each other.</source>
        <translation>dyncal verify prüft diese Seite, die Dateien daneben und das Register des Laboratoriums gegeneinander.</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>Abtast­rate</translation>
    </message>
    <message>
        <source>Largest deflection</source>
        <translation>Größter Aus­schlag</translation>
    </message>
    <message>
        <source>Output step</source>
        <translation>Sprung am Ausgang</translation>
    </message>
    <message>
        <source>Signal to noise</source>
        <translation>Rausch­abstand</translation>
    </message>
    <message>
        <source>Rise time</source>
        <translation>Anstiegs­zeit</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>Einschwing­zeit</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Empfind­lichkeit</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>Aufnehmer</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Sprung</translation>
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
        <source>Poles of the model (a conjugate pair is one line)</source>
        <translation>Pole des Modells (ein konjugiertes Paar ist eine Zeile)</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>z-plane</source>
        <translation>z-Ebene</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>Results in detail</source>
        <translation>Ergebnisse im Einzelnen</translation>
    </message>
    <message>
        <source>Shots</source>
        <translation>Schüsse</translation>
    </message>
    <message>
        <source>No shot could be evaluated; see the remarks.</source>
        <translation>Kein Schuss konnte ausgewertet werden; siehe die Bemerkungen.</translation>
    </message>
    <message>
        <source>Measured responses, shot by shot</source>
        <translation>Gemessene Antworten, Schuss für Schuss</translation>
    </message>
    <message>
        <source>Model of the sensor</source>
        <translation>Modell des Aufnehmers</translation>
    </message>
    <message>
        <source>No model could be determined; see the remarks.</source>
        <translation>Es konnte kein Modell bestimmt werden; siehe die Bemerkungen.</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>%1 (as suggested from the data)</source>
        <translation>%1 (wie aus den Daten vorgeschlagen)</translation>
    </message>
    <message>
        <source>%1 (chosen by the operator)</source>
        <translation>%1 (vom Bearbeiter gewählt)</translation>
    </message>
    <message>
        <source>Fit as in the listing (lagged)</source>
        <translation>Anpassung wie im Programm der Vorlage (verzögert)</translation>
    </message>
    <message>
        <source>The model has a pole outside the unit circle: its simulation diverges.</source>
        <translation>Das Modell hat einen Pol außerhalb des Einheitskreises: Seine Simulation divergiert.</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>Not among the results, because no value with a complete uncertainty is known of them</source>
        <translation>Nicht unter den Ergebnissen, weil kein Wert mit vollständiger Unsicherheit davon bekannt ist</translation>
    </message>
    <message>
        <source>What is known</source>
        <translation>Was bekannt ist</translation>
    </message>
    <message>
        <source>no complete uncertainty</source>
        <translation>keine vollständige Unsicherheit</translation>
    </message>
    <message>
        <source>no complete uncertainty:</source>
        <translation>keine vollständige Unsicherheit:</translation>
    </message>
    <message>
        <source>agree</source>
        <translation>stimmen überein</translation>
    </message>
    <message>
        <source>%1 contradict each other</source>
        <translation>%1 wider­sprechen einander</translation>
    </message>
    <message>
        <source>No quantity was known in two independent ways.</source>
        <translation>Keine Größe war auf zwei unabhängigen Wegen bekannt.</translation>
    </message>
    <message>
        <source>Independent ways to one quantity, compared within the combined uncertainty of their difference (contradiction from 3.6 u on)</source>
        <translation>Unabhängige Wege zu einer Größe, verglichen innerhalb der kombinierten Unsicherheit ihrer Differenz (Widerspruch ab 3,6 u)</translation>
    </message>
    <message>
        <source>One way</source>
        <translation>Ein Weg</translation>
    </message>
    <message>
        <source>Other way</source>
        <translation>Anderer Weg</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Largest difference, u</source>
        <translation>Größte Diffe­renz, u</translation>
    </message>
    <message>
        <source>Fault seen in 90 %</source>
        <translation>Fehler erkannt in 90 %</translation>
    </message>
    <message>
        <source>%V1 (not a date; write it as 2026-01-31)</source>
        <translation>%V1 (kein Datum; in der Form 2026-01-31 angeben)</translation>
    </message>
    <message>
        <source>Shot %1 was excluded. Reason: %V2.</source>
        <translation>Schuss %1 wurde ausgeschlossen. Grund: %V2.</translation>
    </message>
    <message>
        <source>Laboratory and customer</source>
        <translation>Laboratorium und Auftraggeber</translation>
    </message>
    <message>
        <source>Certificate number</source>
        <translation>Nummer des Kalibrierscheins</translation>
    </message>
    <message>
        <source>Laboratory</source>
        <translation>Laboratorium</translation>
    </message>
    <message>
        <source>Address of the laboratory</source>
        <translation>Anschrift des Laboratoriums</translation>
    </message>
    <message>
        <source>Place of calibration</source>
        <translation>Ort der Kalibrierung</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Auftraggeber</translation>
    </message>
    <message>
        <source>Address of the customer</source>
        <translation>Anschrift des Auftraggebers</translation>
    </message>
    <message>
        <source>Date of receipt</source>
        <translation>Datum des Eingangs</translation>
    </message>
    <message>
        <source>Date of calibration</source>
        <translation>Datum der Kalibrierung</translation>
    </message>
    <message>
        <source>Date of issue</source>
        <translation>Datum der Ausstellung</translation>
    </message>
    <message>
        <source>Calibrated by</source>
        <translation>Kalibriert durch</translation>
    </message>
    <message>
        <source>Approved by</source>
        <translation>Freigegeben durch</translation>
    </message>
    <message>
        <source>not yet approved</source>
        <translation>noch nicht freigegeben</translation>
    </message>
    <message>
        <source>Item calibrated</source>
        <translation>Kalibriergegenstand</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>Hersteller</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Description and condition</source>
        <translation>Beschreibung und Zustand</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>Findings on the quality of the data</source>
        <translation>Befunde zur Güte der Daten</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Schwere</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>Accepted because</source>
        <translation>Ange­nommen, weil</translation>
    </message>
    <message>
        <source>blocking</source>
        <translation>sperrend</translation>
    </message>
    <message>
        <source>caution</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Records and software</source>
        <translation>Aufzeichnungen und Software</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>Dyncal %V1, build %V2</source>
        <translation>Dyncal %V1, Build %V2</translation>
    </message>
    <message>
        <source>Computed</source>
        <translation>Berechnet</translation>
    </message>
    <message>
        <source>Recordings evaluated</source>
        <translation>Ausgewertete Aufzeichnungen</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>SHA-256 of the file</source>
        <translation>SHA-256 der Datei</translation>
    </message>
    <message>
        <source>Statements</source>
        <translation>Erklärungen</translation>
    </message>
    <message>
        <source>The results relate only to the item calibrated.</source>
        <translation>Die Ergebnisse beziehen sich nur auf den Kalibriergegenstand.</translation>
    </message>
    <message>
        <source>This document shall not be reproduced except in full without the written approval of the laboratory.</source>
        <translation>Dieses Dokument darf ohne schriftliche Genehmigung des Laboratoriums nur vollständig und unverändert weiterverbreitet werden.</translation>
    </message>
    <message>
        <source>No statement of conformity is made.</source>
        <translation>Eine Konformitätsaussage wird nicht getroffen.</translation>
    </message>
    <message>
        <source>The software does not know how the measuring equipment is traceable; this draft makes no statement of metrological traceability.</source>
        <translation>Die Software weiß nicht, wie die Messmittel rückgeführt sind; dieser Entwurf macht keine Aussage über die metrologische Rückführbarkeit.</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Geschwin­digkeit</translation>
    </message>
    <message>
        <source>Travel time</source>
        <translation>Laufzeit</translation>
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
        <translation>Druck im Hochdruckteil</translation>
    </message>
    <message>
        <source>Sensitivity, shot against shots</source>
        <translation>Empfind­lichkeit, Schuss gegen Schüsse</translation>
    </message>
    <message>
        <source>Order of the levels</source>
        <translation>Reihen­folge der Stufen</translation>
    </message>
    <message>
        <source>typed</source>
        <translation>eingegeben</translation>
    </message>
    <message>
        <source>counters</source>
        <translation>Zähler</translation>
    </message>
    <message>
        <source>arrivals</source>
        <translation>Ankünfte</translation>
    </message>
    <message>
        <source>this arrival</source>
        <translation>diese Ankunft</translation>
    </message>
    <message>
        <source>other arrivals</source>
        <translation>andere Ankünfte</translation>
    </message>
    <message>
        <source>velocity over speed of sound</source>
        <translation>Geschwindig­keit über Schall­geschwin­digkeit</translation>
    </message>
    <message>
        <source>ratio of the steps</source>
        <translation>Verhältnis der Sprünge</translation>
    </message>
    <message>
        <source>ratio of the velocities</source>
        <translation>Verhältnis der Geschwin­digkeiten</translation>
    </message>
    <message>
        <source>side sensor</source>
        <translation>Aufnehmer in der Seiten­wand</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>aufgezeichnet</translation>
    </message>
    <message>
        <source>sensor card</source>
        <translation>Datenkarte des Auf­nehmers</translation>
    </message>
    <message>
        <source>this calibration</source>
        <translation>diese Kalibrie­rung</translation>
    </message>
    <message>
        <source>this shot</source>
        <translation>dieser Schuss</translation>
    </message>
    <message>
        <source>other shots</source>
        <translation>andere Schüsse</translation>
    </message>
    <message>
        <source>names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Sprünge</translation>
    </message>
    <message>
        <source>One of the two ways gives no value here.</source>
        <translation>Einer der beiden Wege ergibt hier keinen Wert.</translation>
    </message>
    <message>
        <source>It needs two shots at least whose sensitivities are known.</source>
        <translation>Nötig sind mindestens zwei Schüsse, deren Empfindlichkeiten bekannt sind.</translation>
    </message>
    <message>
        <source>It needs shots of two levels whose steps are known.</source>
        <translation>Nötig sind Schüsse zweier Stufen, deren Sprünge bekannt sind.</translation>
    </message>
    <message>
        <source>The card of the sensor states its sensitivity in %1, this calibration gives it in %2: one of the two units is wrong, and the values are not compared. Check import.unit and the card.</source>
        <translation>Die Datenkarte des Aufnehmers nennt seine Empfindlichkeit in %1, diese Kalibrierung ergibt sie in %2: Eine der beiden Einheiten ist falsch, und die Werte werden nicht verglichen. import.unit und die Datenkarte prüfen.</translation>
    </message>
    <message>
        <source>No arrival sensor with a distance marks the shock.</source>
        <translation>Kein Ankunftsaufnehmer mit einem Abstand erfasst die Stoßwelle.</translation>
    </message>
    <message>
        <source>It needs three places; there are two.</source>
        <translation>Nötig sind drei Orte; es gibt zwei.</translation>
    </message>
    <message>
        <source>The reflected shock is not seen to pass the sensor again.</source>
        <translation>Der erneute Durchgang der reflektierten Stoßwelle am Aufnehmer ist nicht zu sehen.</translation>
    </message>
    <message>
        <source>The plateau behind the reflected shock is too short at the sensor to be read.</source>
        <translation>Das Plateau hinter der reflektierten Stoßwelle ist am Aufnehmer zu kurz zum Ablesen.</translation>
    </message>
    <message>
        <source>No sensor in the end wall marks the reflection.</source>
        <translation>Kein Aufnehmer in der Endwand erfasst die Reflexion.</translation>
    </message>
    <message>
        <source>The channel is no pressure: its unit or the sensor&apos;s sensitivity is not stated.</source>
        <translation>Der Kanal ist kein Druck: Seine Einheit oder die Empfindlichkeit des Aufnehmers ist nicht angegeben.</translation>
    </message>
    <message>
        <source>The state of the shock follows from the driver pressure.</source>
        <translation>Der Zustand der Stoßwelle folgt aus dem Druck im Hochdruckteil.</translation>
    </message>
    <message>
        <source>The driver pressure or its temperature is not recorded.</source>
        <translation>Der Druck im Hochdruckteil oder seine Temperatur ist nicht aufgezeichnet.</translation>
    </message>
    <message>
        <source>The velocity of the shock is not known.</source>
        <translation>Die Geschwindigkeit der Stoßwelle ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The sensitivity is not determined.</source>
        <translation>Die Empfindlichkeit ist nicht bestimmt.</translation>
    </message>
    <message>
        <source>The uncertainty of the pressure step is not known.</source>
        <translation>Die Unsicherheit des Drucksprungs ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The card of the sensor states no sensitivity in the unit of the calibration.</source>
        <translation>Die Datenkarte des Aufnehmers nennt keine Empfindlichkeit in der Einheit der Kalibrierung.</translation>
    </message>
    <message>
        <source>The velocity stated for this shot is %1, the arrivals give %2: they differ by %3 times their combined uncertainty. Check what was typed, the distances and the sample rate.</source>
        <translation>Die für diesen Schuss angegebene Geschwindigkeit ist %1, die Ankünfte ergeben %2: Sie unterscheiden sich um das %3-Fache ihrer kombinierten Unsicherheit. Das Eingegebene, die Abstände und die Abtastrate prüfen.</translation>
    </message>
    <message>
        <source>The ratio of the reflected to the incident step at &apos;%4&apos; belongs to Mach %1, the velocity over the speed of sound is Mach %2: they differ by %3 times their combined uncertainty. The ratio needs no clock and no sensitivity; check sample rate, distances, gas and temperature.</source>
        <translation>Das Verhältnis des reflektierten zum einlaufenden Sprung bei „%4“ gehört zu Mach %1, die Geschwindigkeit über der Schallgeschwindigkeit ist Mach %2: Sie unterscheiden sich um das %3-Fache ihrer kombinierten Unsicherheit. Das Verhältnis braucht weder Takt noch Empfindlichkeit; Abtastrate, Abstände, Gas und Temperatur prüfen.</translation>
    </message>
    <message>
        <source>The ratio of the velocities of the incident and the reflected shock at &apos;%4&apos; belongs to Mach %1, the velocity over the speed of sound is Mach %2: they differ by %3 times their combined uncertainty. The ratio needs no clock; check sample rate, distances, gas and temperature.</source>
        <translation>Das Verhältnis der Geschwindigkeiten der einlaufenden und der reflektierten Stoßwelle bei „%4“ gehört zu Mach %1, die Geschwindigkeit über der Schallgeschwindigkeit ist Mach %2: Sie unterscheiden sich um das %3-Fache ihrer kombinierten Unsicherheit. Das Verhältnis braucht keinen Takt; Abtastrate, Abstände, Gas und Temperatur prüfen.</translation>
    </message>
    <message>
        <source>The pressure behind the shock rises by %1 at &apos;%4&apos; and should by %2: they differ by %3 times their combined uncertainty. Check p1, the velocity, and unit and sensitivity of the sensor.</source>
        <translation>Der Druck hinter der Stoßwelle steigt bei „%4“ um %1 und sollte um %2 steigen: Sie unterscheiden sich um das %3-Fache ihrer kombinierten Unsicherheit. p1, die Geschwindigkeit sowie Einheit und Empfindlichkeit des Aufnehmers prüfen.</translation>
    </message>
    <message>
        <source>The pressure behind the reflected shock is %1 above p1 at &apos;%4&apos; and should be %2: they differ by %3 times their combined uncertainty. Check p1, the velocity, and unit and sensitivity of the sensor.</source>
        <translation>Der Druck hinter der reflektierten Stoßwelle liegt bei „%4“ um %1 über p1 und sollte um %2 darüber liegen: Sie unterscheiden sich um das %3-Fache ihrer kombinierten Unsicherheit. p1, die Geschwindigkeit sowie Einheit und Empfindlichkeit des Aufnehmers prüfen.</translation>
    </message>
    <message>
        <source>The typed pressure step of this shot is %1, the velocity gives %2: they differ by %3 times their combined uncertainty. Check what was typed.</source>
        <translation>Der eingegebene Drucksprung dieses Schusses ist %1, die Geschwindigkeit ergibt %2: Sie unterscheiden sich um das %3-Fache ihrer kombinierten Unsicherheit. Das Eingegebene prüfen.</translation>
    </message>
    <message>
        <source>The sensitivity of this shot is %1, the card of the sensor states %2: they differ by %3 times their combined uncertainty. Check scale and unit of the recording, p1 and the card.</source>
        <translation>Die Empfindlichkeit dieses Schusses ist %1, die Datenkarte des Aufnehmers nennt %2: Sie unterscheiden sich um das %3-Fache ihrer kombinierten Unsicherheit. Skalierung und Einheit der Aufzeichnung, p1 und die Datenkarte prüfen.</translation>
    </message>
    <message>
        <source>Beside what other findings say, all %1 comparisons together leave a chi-square of %2, which happens by chance in %3 % of calibrations: look at the largest differences, and at the causes named.</source>
        <translation>Neben dem, was andere Befunde sagen, ergeben alle %1 Vergleiche zusammen ein Chi-Quadrat von %2, was durch Zufall in %3 % der Kalibrierungen vorkommt: die größten Differenzen und die genannten Ursachen ansehen.</translation>
    </message>
    <message>
        <source>No comparison contradicts alone, but all %1 together leave a chi-square of %2, which happens by chance in %3 % of calibrations, and no single fault explains it: look at the largest differences.</source>
        <translation>Kein Vergleich widerspricht allein, aber alle %1 zusammen ergeben ein Chi-Quadrat von %2, was durch Zufall in %3 % der Kalibrierungen vorkommt, und kein einzelner Fehler erklärt es: die größten Differenzen ansehen.</translation>
    </message>
    <message>
        <source>No comparison contradicts alone, but all %1 together leave a chi-square of %2, which happens by chance in %3 % of calibrations: look at the largest differences, and at the causes named.</source>
        <translation>Kein Vergleich widerspricht allein, aber alle %1 zusammen ergeben ein Chi-Quadrat von %2, was durch Zufall in %3 % der Kalibrierungen vorkommt: die größten Differenzen und die genannten Ursachen ansehen.</translation>
    </message>
    <message>
        <source>The levels named for the shots are not in the order of their pressure steps: check which recording belongs to which shot (import.levels).</source>
        <translation>Die für die Schüsse genannten Stufen liegen nicht in der Reihenfolge ihrer Drucksprünge: prüfen, welche Aufzeichnung zu welchem Schuss gehört (import.levels).</translation>
    </message>
    <message>
        <source>Shot %1 has %2 samples in its window, too few to be reduced %3 times to the rate of the other shots; set window.end_s or exclude a shot.</source>
        <translation>Schuss %1 hat %2 Abtastwerte in seinem Fenster, zu wenige, um %3-fach auf die Rate der anderen Schüsse verringert zu werden; window.end_s setzen oder einen Schuss ausschließen.</translation>
    </message>
    <message>
        <source>The first principal component explains %1 % (limit %2 %). Shot %3 carries %4 % of the remainder.</source>
        <translation>Die erste Hauptkomponente erklärt %1 % (Grenze %2 %). Schuss %3 trägt %4 % des Rests.</translation>
    </message>
    <message>
        <source>Stopped on request.</source>
        <translation>Auf Verlangen angehalten.</translation>
    </message>
    <message>
        <source>No shot is included.</source>
        <translation>Kein Schuss ist eingeschlossen.</translation>
    </message>
    <message>
        <source>The settings of the principal components make no sense: components %1 and residual lags %2 must be at least 1, the confidence %3 between 0 and 1.</source>
        <translation>Die Einstellungen der Hauptkomponenten ergeben keinen Sinn: Komponenten %1 und Verschiebungen des Residuums %2 müssen mindestens 1 sein, die Konfidenz %3 zwischen 0 und 1.</translation>
    </message>
    <message>
        <source>Shot %1: %2 % of the resonance at %3 is left in the residual, because its arrival differs from the others&apos; by %4 of a sample; aligned, %5 % are left. The average of the shots loses some of its ringing by this, stacked shots do not.</source>
        <translation>Schuss %1: %2 % der Resonanz bei %3 bleiben im Residuum, weil seine Ankunft um %4 eines Abtastwerts von der der anderen abweicht; ausgerichtet bleiben %5 %. Das Mittel der Schüsse verliert dadurch etwas von seinem Nachschwingen, gemeinsam angepasste Schüsse nicht.</translation>
    </message>
    <message>
        <source>Shot %1: %2 % of the resonance at %3 is left in the residual; its amplitude or its time varies between the shots.</source>
        <translation>Schuss %1: %2 % der Resonanz bei %3 bleiben im Residuum; ihre Amplitude oder ihre Zeit schwankt zwischen den Schüssen.</translation>
    </message>
    <message>
        <source>Shot %1: the residual is not white, %2 % of the lags lie outside the confidence band.</source>
        <translation>Schuss %1: Das Residuum ist nicht weiß, %2 % der Verschiebungen liegen außerhalb des Konfidenzbands.</translation>
    </message>
    <message>
        <source>Shot %1 holds %2 % of the energy of all residuals; look at it before using the average.</source>
        <translation>Schuss %1 enthält %2 % der Energie aller Residuen; ihn ansehen, bevor das Mittel verwendet wird.</translation>
    </message>
    <message>
        <source>The shots are recorded in different units, so their sensitivities are not averaged; give one unit for all (import.unit).</source>
        <translation>Die Schüsse sind in verschiedenen Einheiten aufgezeichnet, daher werden ihre Empfindlichkeiten nicht gemittelt; eine Einheit für alle angeben (import.unit).</translation>
    </message>
    <message>
        <source>not determined (a free decay has no step)</source>
        <translation>nicht bestimmt (ein freies Abklingen hat keinen Sprung)</translation>
    </message>
    <message>
        <source>not determined (the model diverges)</source>
        <translation>nicht bestimmt (das Modell divergiert)</translation>
    </message>
    <message>
        <source>not determined (the level of the step is not known)</source>
        <translation>nicht bestimmt (der Pegel des Sprungs ist nicht bekannt)</translation>
    </message>
    <message>
        <source>not determined (outside the range of the model)</source>
        <translation>nicht bestimmt (außerhalb des Bereichs des Modells)</translation>
    </message>
    <message>
        <source>below %1 (two samples)</source>
        <translation>unter %1 (zwei Abtastwerte)</translation>
    </message>
    <message>
        <source>above %1 (the window ends there)</source>
        <translation>über %1 (das Fenster endet dort)</translation>
    </message>
    <message>
        <source>not determined (the window ends before the top)</source>
        <translation>nicht bestimmt (das Fenster endet vor dem Scheitel)</translation>
    </message>
    <message>
        <source>above %1 (the band of the response ends there)</source>
        <translation>über %1 (das Band der Antwort endet dort)</translation>
    </message>
    <message>
        <source>below %1 (the band of the response begins there)</source>
        <translation>unter %1 (das Band der Antwort beginnt dort)</translation>
    </message>
    <message>
        <source>The file of %1 states a response from %2 to %3, the records have one from %4 to %5: nothing in common, so no S(f) can be stated. Give a file that covers the band.</source>
        <translation>Die Datei von %1 gibt eine Antwort von %2 bis %3 an, die Aufzeichnungen haben eine von %4 bis %5: nichts gemeinsam, daher kann kein S(f) angegeben werden. Eine Datei angeben, die das Band abdeckt.</translation>
    </message>
    <message>
        <source>The file of %1 has no row between %2 and %3: the response rests on a straight line there, and what that misses is in no uncertainty. Have the rows between calibrated, or give the reason why there is nothing between them.</source>
        <translation>Die Datei von %1 hat keine Zeile zwischen %2 und %3: Die Antwort beruht dort auf einer Geraden, und was diese verfehlt, steckt in keiner Unsicherheit. Die Zeilen dazwischen kalibrieren lassen oder den Grund angeben, warum dazwischen nichts ist.</translation>
    </message>
    <message>
        <source>At %1 the response taken from the data directly differs by %2 % from the model, more than noise allows: the model misses something there.</source>
        <translation>Bei %1 weicht die direkt aus den Daten genommene Antwort um %2 % vom Modell ab, mehr als das Rauschen erlaubt: Dem Modell fehlt dort etwas.</translation>
    </message>
    <message>
        <source>The response taken from the data is withheld at %1 of %2 frequencies, from %3 to %4: what the end of the record cuts off may change it there by more than its noise and 2 %. Use a longer window, or only what the model says there.</source>
        <translation>Die direkt aus den Daten genommene Antwort wird bei %1 von %2 Frequenzen zurückgehalten, von %3 bis %4: Was das Ende der Aufzeichnung abschneidet, kann sie dort um mehr als ihr Rauschen und 2 % ändern. Ein längeres Fenster verwenden oder dort nur, was das Modell sagt.</translation>
    </message>
    <message>
        <source>The response taken from the data is withheld at %1 of %2 frequencies, from %3 to %4: the sampling may change it there by more than its noise and 2 %. Record at a higher rate, or use only what the model says there.</source>
        <translation>Die direkt aus den Daten genommene Antwort wird bei %1 von %2 Frequenzen zurückgehalten, von %3 bis %4: Die Abtastung kann sie dort um mehr als ihr Rauschen und 2 % ändern. Mit höherer Rate aufzeichnen oder dort nur verwenden, was das Modell sagt.</translation>
    </message>
    <message>
        <source>The response taken from the data is withheld at %1 of %2 frequencies, from %3 to %4: the reference transducer was not calibrated there, and nothing is extrapolated.</source>
        <translation>Die direkt aus den Daten genommene Antwort wird bei %1 von %2 Frequenzen zurückgehalten, von %3 bis %4: Der Referenzaufnehmer wurde dort nicht kalibriert, und nichts wird extrapoliert.</translation>
    </message>
    <message>
        <source>The response taken from the data is withheld at %1 of %2 frequencies, from %3 to %4: the response of the chain (chain.source) is not stated there, and nothing is extrapolated.</source>
        <translation>Die direkt aus den Daten genommene Antwort wird bei %1 von %2 Frequenzen zurückgehalten, von %3 bis %4: Die Antwort der Messkette (chain.source) ist dort nicht angegeben, und nichts wird extrapoliert.</translation>
    </message>
    <message>
        <source>The shortest window, %1, resolves steps of %2, but the response is asked for from %3: below %2 it is not measured. Lengthen the window or take these frequencies out of response.frequencies_hz.</source>
        <translation>Das kürzeste Fenster, %1, löst Schritte von %2 auf, aber die Antwort ist ab %3 verlangt: Unter %2 wird sie nicht gemessen. Das Fenster verlängern oder diese Frequenzen aus response.frequencies_hz nehmen.</translation>
    </message>
    <message>
        <source>The step is that of a reference transducer, not of the shock.</source>
        <translation>Der Sprung ist der eines Referenzaufnehmers, nicht der Stoßwelle.</translation>
    </message>
    <message>
        <source>The sensitivities of the shots, from %1 to %2 % about their mean, differ by more than their uncertainties explain; shot %3 is the odd one. Their scatter serves as the uncertainty of the mean; look at that shot, its step and its level, or state one value per level.</source>
        <translation>Die Empfindlichkeiten der Schüsse, von %1 bis %2 % um ihr Mittel, unterscheiden sich um mehr, als ihre Unsicherheiten erklären; Schuss %3 fällt heraus. Ihre Streuung dient als Unsicherheit des Mittels; diesen Schuss, seinen Sprung und seinen Pegel ansehen oder einen Wert je Stufe angeben.</translation>
    </message>
    <message>
        <source>The sensitivities of the shots, from %1 to %2 % about their mean, differ by more than 1 % each would explain (their own uncertainties are not known); shot %3 is the odd one. Look at that shot, its step and its level, or state one value per level.</source>
        <translation>Die Empfindlichkeiten der Schüsse, von %1 bis %2 % um ihr Mittel, unterscheiden sich um mehr, als je 1 % erklären würde (ihre eigenen Unsicherheiten sind nicht bekannt); Schuss %3 fällt heraus. Diesen Schuss, seinen Sprung und seinen Pegel ansehen oder einen Wert je Stufe angeben.</translation>
    </message>
    <message>
        <source>The blocks of trials do not fit together: one begins with trial %1, expected is %2; merge blocks of one calibration, in their order.</source>
        <translation>Die Blöcke von Versuchen passen nicht zusammen: Einer beginnt mit Versuch %1, erwartet ist %2; Blöcke einer Kalibrierung in ihrer Reihenfolge zusammenführen.</translation>
    </message>
    <message>
        <source>%1 of %2 records made as the model gives them, with the noise of the shots, could not be fitted again: the values of the model may be far more uncertain than is stated. Choose a lower order, or record with less noise.</source>
        <translation>%1 von %2 Aufzeichnungen, wie das Modell sie ergibt, mit dem Rauschen der Schüsse, konnten nicht neu angepasst werden: Die Werte des Modells sind vielleicht weit unsicherer als angegeben. Eine niedrigere Ordnung wählen oder mit weniger Rauschen aufzeichnen.</translation>
    </message>
    <message>
        <source>Not enough memory for this calibration; shorten the window or the model input.</source>
        <translation>Der Speicher reicht für diese Kalibrierung nicht; das Fenster oder den Modelleingang verkürzen.</translation>
    </message>
    <message>
        <source>Internal error: %1. Please report it with the recipe.</source>
        <translation>Interner Fehler: %1. Bitte mit dem Rezept melden.</translation>
    </message>
    <message>
        <source>response.reference is &quot;transducer&quot;, but comparison.enabled is false; switch the comparison on and say what the reference transducer is.</source>
        <translation>response.reference ist &quot;transducer&quot;, aber comparison.enabled ist false; den Vergleich einschalten und sagen, was der Referenzaufnehmer ist.</translation>
    </message>
    <message>
        <source>A comparison with a reference transducer needs the response to a step; with input.treatment &quot;impulse&quot; switch comparison.enabled off.</source>
        <translation>Ein Vergleich mit einem Referenzaufnehmer braucht die Antwort auf einen Sprung; bei input.treatment &quot;impulse&quot; comparison.enabled ausschalten.</translation>
    </message>
    <message>
        <source>There is no decomposition yet that orders could be taken from.</source>
        <translation>Es gibt noch keine Zerlegung, aus der Ordnungen genommen werden könnten.</translation>
    </message>
    <message>
        <source>%1 orders were asked for; compare at most %2 at once.</source>
        <translation>%1 Ordnungen wurden verlangt; höchstens %2 zugleich vergleichen.</translation>
    </message>
    <message>
        <source>The uncertainty of &apos;%1&apos; in uncertainty.budget is used for nothing: what is known of the attenuation is the range shock.attenuation_per_m.</source>
        <translation>Die Unsicherheit von „%1“ in uncertainty.budget wird für nichts verwendet: Was von der Abschwächung bekannt ist, ist der Bereich shock.attenuation_per_m.</translation>
    </message>
    <message>
        <source>The uncertainty of &apos;%1&apos; in uncertainty.budget is used for nothing; the nearest quantity that counts is &apos;%2&apos;.</source>
        <translation>Die Unsicherheit von „%1“ in uncertainty.budget wird für nichts verwendet; die nächstliegende Größe, die zählt, ist „%2“.</translation>
    </message>
    <message>
        <source>The correlation of &apos;%1&apos; with &apos;%2&apos; in uncertainty.correlations is used for nothing: it needs two quantities whose u stands in uncertainty.budget.</source>
        <translation>Die Korrelation von „%1“ mit „%2“ in uncertainty.correlations wird für nichts verwendet: Sie braucht zwei Größen, deren u in uncertainty.budget steht.</translation>
    </message>
    <message>
        <source>The model holds poles of the tube&apos;s gas: %1 (in brackets the peak that moves with the sound speed, shot by shot). Leave that oscillation out of the model, or it is certified as the sensor&apos;s.</source>
        <translation>Das Modell enthält Pole des Gases im Rohr: %1 (in Klammern das Maximum, das mit der Schallgeschwindigkeit wandert, Schuss für Schuss). Diese Schwingung aus dem Modell weglassen, sonst wird sie als die des Aufnehmers bescheinigt.</translation>
    </message>
    <message>
        <source>Poles within 3 % of a computed resonance of the tube: %1. If they are not the sensor&apos;s, leave that oscillation out of the model.</source>
        <translation>Pole innerhalb 3 % einer berechneten Resonanz des Rohrs: %1. Sind sie nicht die des Aufnehmers, diese Schwingung aus dem Modell weglassen.</translation>
    </message>
    <message>
        <source>The shots do not share the pole at %1 (their scatter would be chance in %2 % of cases; the limit is 1 %). Its uncertainty is the scatter between them; state one value per level.</source>
        <translation>Die Schüsse haben den Pol bei %1 nicht gemeinsam (ihre Streuung wäre in %2 % der Fälle Zufall; die Grenze ist 1 %). Seine Unsicherheit ist die Streuung zwischen ihnen; einen Wert je Stufe angeben.</translation>
    </message>
    <message>
        <source>The shots do not share the pole at %1 (their scatter would be chance in %2 % of cases; the limit is 1 %); their main resonances lie at %3 to %4. Its uncertainty is the scatter between them; state one value per level.</source>
        <translation>Die Schüsse haben den Pol bei %1 nicht gemeinsam (ihre Streuung wäre in %2 % der Fälle Zufall; die Grenze ist 1 %); ihre Hauptresonanzen liegen bei %3 bis %4. Seine Unsicherheit ist die Streuung zwischen ihnen; einen Wert je Stufe angeben.</translation>
    </message>
    <message>
        <source>Without the first %1 of the records the main resonance has %2 % of frequency and %3 % of damping more, beyond what noise allows: the pressure does not rise at once (state the duration of the front), or a faster part is missing in the model.</source>
        <translation>Ohne die ersten %1 der Aufzeichnungen hat die Hauptresonanz %2 % mehr Frequenz und %3 % mehr Dämpfung, über das hinaus, was das Rauschen erlaubt: Der Druck steigt nicht auf einmal an (die Dauer der Front angeben), oder ein schnellerer Teil fehlt im Modell.</translation>
    </message>
    <message>
        <source>Model order %1 is not possible: the Hankel matrix of %2 rows serves orders 1 to %3; choose one of them, or a longer model input.</source>
        <translation>Modellordnung %1 ist nicht möglich: Die Hankel-Matrix mit %2 Zeilen dient den Ordnungen 1 bis %3; eine davon wählen oder einen längeren Modelleingang.</translation>
    </message>
    <message>
        <source>The Hankel matrix was decomposed for another treatment of the response than the model&apos;s; compute the decomposition again.</source>
        <translation>Die Hankel-Matrix wurde für eine andere Behandlung der Antwort zerlegt als die des Modells; die Zerlegung neu berechnen.</translation>
    </message>
    <message>
        <source>Use order %1</source>
        <translation>Ordnung %1 verwenden</translation>
    </message>
    <message>
        <source>Order %1 splits an oscillating pair (singular values %1 and %2 are %3 and %4). Order %2 keeps it.</source>
        <translation>Ordnung %1 trennt ein schwingendes Paar (Singulärwerte %1 und %2 sind %3 und %4). Ordnung %2 behält es.</translation>
    </message>
    <message>
        <source>Order %1 has states at the noise level: singular value %1 is %3, noise alone reaches %4. Order %2 is the highest above it.</source>
        <translation>Ordnung %1 hat Zustände auf der Höhe des Rauschens: Singulärwert %1 ist %3, Rauschen allein erreicht %4. Ordnung %2 ist die höchste darüber.</translation>
    </message>
    <message>
        <source>Order %1 has states at the noise level: singular value %1 is %3, noise alone reaches %4. No value is above it: the response holds nothing that could be identified.</source>
        <translation>Ordnung %1 hat Zustände auf der Höhe des Rauschens: Singulärwert %1 ist %3, Rauschen allein erreicht %4. Kein Wert liegt darüber: Die Antwort enthält nichts, was sich identifizieren ließe.</translation>
    </message>
    <message>
        <source>The model of order %1 is unstable: poles that grow, at %2, the largest of magnitude %3 (at most 1). It is not reportable; choose another order.</source>
        <translation>Das Modell der Ordnung %1 ist instabil: wachsende Pole bei %2, der größte mit dem Betrag %3 (höchstens 1). Es kann nicht berichtet werden; eine andere Ordnung wählen.</translation>
    </message>
    <message>
        <source>Poles at the Nyquist frequency, %1: %2. Dynamics there come from sampling, not from the sensor; a lower order or a higher model rate is without them.</source>
        <translation>Pole bei der Nyquist-Frequenz, %1: %2. Dynamik dort kommt von der Abtastung, nicht vom Aufnehmer; eine niedrigere Ordnung oder eine höhere Modellrate ist ohne sie.</translation>
    </message>
    <message>
        <source>The pole at z = %1 is the step itself.</source>
        <translation>Der Pol bei z = %1 ist der Sprung selbst.</translation>
    </message>
    <message>
        <source>The response is treated as a free decay but stays at a level: a pole at z = %1. Treat it as a step, or the step becomes a part of the sensor.</source>
        <translation>Die Antwort wird als freies Abklingen behandelt, bleibt aber auf einem Pegel: ein Pol bei z = %1. Als Sprung behandeln, sonst wird der Sprung ein Teil des Aufnehmers.</translation>
    </message>
    <message>
        <source>Treat as a step</source>
        <translation>Als Sprung behandeln</translation>
    </message>
    <message>
        <source>Poles nearly cancelled by zeros: %1 (%2). A lower order may do.</source>
        <translation>Pole, die durch Nullstellen fast aufgehoben sind: %1 (%2). Eine niedrigere Ordnung genügt vielleicht.</translation>
    </message>
    <message>
        <source>FIT is %1 % where the noise allows %2 %: the model misses part of the response. Choose a higher order; the error shows what is missing.</source>
        <translation>FIT ist %1 %, wo das Rauschen %2 % erlaubt: Dem Modell fehlt ein Teil der Antwort. Eine höhere Ordnung wählen; der Fehler zeigt, was fehlt.</translation>
    </message>
    <message>
        <source>FIT %1 % is above the %2 % that the noise allows: order %3 also fits noise.</source>
        <translation>FIT %1 % liegt über den %2 %, die das Rauschen erlaubt: Ordnung %3 passt auch Rauschen an.</translation>
    </message>
    <message>
        <source>The spectrum&apos;s resonance at %1 is not in the model, whose nearest lies at %2 (2 % apart at most). Choose another order or model rate.</source>
        <translation>Die Resonanz des Spektrums bei %1 ist nicht im Modell, dessen nächste bei %2 liegt (höchstens 2 % Abstand). Eine andere Ordnung oder Modellrate wählen.</translation>
    </message>
    <message>
        <source>The spectrum&apos;s resonance at %1 is not in the model, which has none. Choose a higher order.</source>
        <translation>Die Resonanz des Spektrums bei %1 ist nicht im Modell, das keine hat. Eine höhere Ordnung wählen.</translation>
    </message>
    <message>
        <source>The model starts at %1 % of the step instead of 0: a fast part of the response is missing; raise the model rate or the order.</source>
        <translation>Das Modell beginnt bei %1 % des Sprungs statt bei 0: Ein schneller Teil der Antwort fehlt; die Modellrate oder die Ordnung anheben.</translation>
    </message>
    <message>
        <source>Behind the step the response drifts by %1 % until the end of the model input, with a time constant of about %2: slower than the sensor, so no part of its step (heat of the gas, an AC coupling). The sensitivity is that of the level at the onset, before the drift.</source>
        <translation>Hinter dem Sprung driftet die Antwort um %1 % bis zum Ende des Modelleingangs, mit einer Zeitkonstante von etwa %2: langsamer als der Aufnehmer, also kein Teil seines Sprungs (Wärme des Gases, eine Wechselspannungskopplung). Die Empfindlichkeit ist die des Pegels beim Einsatz, vor der Drift.</translation>
    </message>
    <message>
        <source>A part of the response with a time constant of %1 may be the sensor&apos;s own or a drift (heat of the gas, an AC coupling): it is less than ten times slower than the rest. It counts as the sensor&apos;s own; as a drift it would change the sensitivity by %2 %. Compare with a shot of another step, or with the static sensitivity.</source>
        <translation>Ein Teil der Antwort mit einer Zeitkonstante von %1 ist vielleicht dem Aufnehmer eigen oder eine Drift (Wärme des Gases, eine Wechselspannungskopplung): Er ist weniger als zehnmal langsamer als der Rest. Er zählt als dem Aufnehmer eigen; als Drift würde er die Empfindlichkeit um %2 % ändern. Mit einem Schuss anderen Sprungs oder mit der statischen Empfindlichkeit vergleichen.</translation>
    </message>
    <message>
        <source>A part of the response with a time constant of about %1 has not ended within the model input, and the model could not be refined, so that it is unknown whether it is a drift (heat of the gas, an AC coupling). The sensitivity is that of the level to which the model tends, an extrapolation. Choose another order, or let the model be refined.</source>
        <translation>Ein Teil der Antwort mit einer Zeitkonstante von etwa %1 ist innerhalb des Modelleingangs nicht zu Ende, und das Modell konnte nicht verfeinert werden, sodass unbekannt ist, ob er eine Drift ist (Wärme des Gases, eine Wechselspannungskopplung). Die Empfindlichkeit ist die des Pegels, dem das Modell zustrebt, eine Extrapolation. Eine andere Ordnung wählen oder das Modell verfeinern lassen.</translation>
    </message>
    <message>
        <source>Shot %1: the window of %2 holds %3 periods of the mode %4; below 2 it cannot be told from the plateau and stays in the response.</source>
        <translation>Schuss %1: Das Fenster von %2 enthält %3 Perioden der Mode %4; unter 2 lässt sie sich nicht vom Plateau unterscheiden und bleibt in der Antwort.</translation>
    </message>
    <message>
        <source>Shot %1: the mode %2 lies above 0.4 of the sample rate of %3; it stays in the response.</source>
        <translation>Schuss %1: Die Mode %2 liegt über dem 0,4-Fachen der Abtastrate von %3; sie bleibt in der Antwort.</translation>
    </message>
    <message>
        <source>Shot %1: no oscillation near %2 stands out of the noise; nothing is taken out there.</source>
        <translation>Schuss %1: Keine Schwingung nahe %2 hebt sich aus dem Rauschen; dort wird nichts herausgenommen.</translation>
    </message>
    <message>
        <source>Shot %1: the mode %2 has a frequency for the shots 1 to %3 only; it stays in the response of this one.</source>
        <translation>Schuss %1: Die Mode %2 hat nur für die Schüsse 1 bis %3 eine Frequenz; sie bleibt in der Antwort dieses Schusses.</translation>
    </message>
    <message>
        <source>The mode %1 was read in shot %2, of which no sound speed is known: it is looked for at that frequency in every shot. Read it in another shot, or give one frequency per shot.</source>
        <translation>Die Mode %1 wurde in Schuss %2 abgelesen, von dem keine Schallgeschwindigkeit bekannt ist: Sie wird in jedem Schuss bei dieser Frequenz gesucht. Sie in einem anderen Schuss ablesen oder je Schuss eine Frequenz angeben.</translation>
    </message>
    <message>
        <source>The average of the shots has no tube modes of its own, as each shot has its own sound speed: nothing is taken out. Combine the shots as &quot;stacked&quot;.</source>
        <translation>Das Mittel der Schüsse hat keine eigenen Rohrmoden, da jeder Schuss seine eigene Schallgeschwindigkeit hat: Nichts wird herausgenommen. Die Schüsse als &quot;stacked&quot; zusammenfassen.</translation>
    </message>
    <message>
        <source>A second-order sensor (damping ratio %1) describes the records better than order %2, by their BIC: of a response damped that much the realised poles tell little.</source>
        <translation>Ein Aufnehmer zweiter Ordnung (Dämpfungsgrad %1) beschreibt die Aufzeichnungen nach ihrem BIC besser als Ordnung %2: Von einer so gedämpften Antwort sagen die realisierten Pole wenig.</translation>
    </message>
    <message>
        <source>A second-order sensor (%1, damping %2) does not describe the response: FIT %3 % against %4 % of the model.</source>
        <translation>Ein Aufnehmer zweiter Ordnung (%1, Dämpfung %2) beschreibt die Antwort nicht: FIT %3 % gegen %4 % des Modells.</translation>
    </message>
    <message>
        <source>Shot %1: FIT is %2 % with the model, but %3 % with the poles of the other shots alone. The shots do not share their poles: look at that shot; if nothing is wrong with it the sensor is not linear.</source>
        <translation>Schuss %1: FIT ist mit dem Modell %2 %, mit den Polen der anderen Schüsse allein aber %3 %. Die Schüsse haben ihre Pole nicht gemeinsam: diesen Schuss ansehen; ist mit ihm alles in Ordnung, ist der Aufnehmer nicht linear.</translation>
    </message>
    <message>
        <source>Singular values above the noise floor: %1.</source>
        <translation>Singulärwerte über dem Rauschen: %1.</translation>
    </message>
    <message>
        <source>Singular value %1 is %2 times the next one; above the noise floor lie %3.</source>
        <translation>Singulärwert %1 ist das %2-Fache des nächsten; über dem Rauschen liegen %3.</translation>
    </message>
    <message>
        <source>Order %1 splits an oscillating pair; order %2 keeps it.</source>
        <translation>Ordnung %1 trennt ein schwingendes Paar; Ordnung %2 behält es.</translation>
    </message>
    <message>
        <source>Order %1 splits no oscillating pair.</source>
        <translation>Ordnung %1 trennt kein schwingendes Paar.</translation>
    </message>
    <message>
        <source>The pole at %1 with damping ratio %2 is stable from order %3 to %4; the ranges are those over these orders.</source>
        <translation>Der Pol bei %1 mit dem Dämpfungsgrad %2 ist von Ordnung %3 bis %4 stabil; die Spannen sind die über diese Ordnungen.</translation>
    </message>
    <message>
        <source>Poles of the other shots describe a shot best at order %1: they leave %2 % of it.</source>
        <translation>Pole der anderen Schüsse beschreiben einen Schuss bei Ordnung %1 am besten: Sie lassen %2 % davon übrig.</translation>
    </message>
    <message>
        <source>Poles of the other shots leave %1 % of a shot at order %2; the least, %3 %, at order %4.</source>
        <translation>Pole der anderen Schüsse lassen bei Ordnung %2 %1 % eines Schusses übrig; am wenigsten, %3 %, bei Ordnung %4.</translation>
    </message>
    <message>
        <source>Order %1 is the lowest whose FIT (%2 %) reaches 98 % of the attainable %3 % with neither an unstable nor a Nyquist pole.</source>
        <translation>Ordnung %1 ist die niedrigste, deren FIT (%2 %) 98 % der erreichbaren %3 % erreicht, ohne instabilen Pol und ohne Nyquist-Pol.</translation>
    </message>
    <message>
        <source>No order up to %1 reaches 98 % of the attainable FIT of %2 % with neither an unstable nor a Nyquist pole.</source>
        <translation>Keine Ordnung bis %1 erreicht 98 % des erreichbaren FIT von %2 % ohne instabilen Pol und ohne Nyquist-Pol.</translation>
    </message>
    <message>
        <source>Model input: a rate of %1 cannot represent the resonance at %2, which would appear at %3; choose more than %4.</source>
        <translation>Modelleingang: Eine Rate von %1 kann die Resonanz bei %2 nicht darstellen, die bei %3 erschiene; mehr als %4 wählen.</translation>
    </message>
    <message>
        <source>%1 samples per period of the resonance; damping will be uncertain, 4 or more are better.</source>
        <translation>%1 Abtastwerte je Periode der Resonanz; die Dämpfung wird unsicher, 4 oder mehr sind besser.</translation>
    </message>
    <message>
        <source>%1 samples per period of the resonance.</source>
        <translation>%1 Abtastwerte je Periode der Resonanz.</translation>
    </message>
    <message>
        <source>The model input starts %1 behind the onset, inside the anti-alias filter; %2 is needed, or damping and order come out wrong.</source>
        <translation>Der Modelleingang beginnt %1 hinter dem Einsatz, innerhalb des Anti-Alias-Filters; nötig ist %2, sonst werden Dämpfung und Ordnung falsch.</translation>
    </message>
    <message>
        <source>Model input: shot %1 is recorded at %2, below the model rate of %3; choose at most %2.</source>
        <translation>Modelleingang: Schuss %1 ist mit %2 aufgezeichnet, unter der Modellrate von %3; höchstens %2 wählen.</translation>
    </message>
    <message>
        <source>Model input: shot %1 offers %2 samples before its window ends, %3 are asked for; lengthen the window or ask for fewer samples.</source>
        <translation>Modelleingang: Schuss %1 bietet %2 Abtastwerte, bevor sein Fenster endet, %3 sind verlangt; das Fenster verlängern oder weniger Abtastwerte verlangen.</translation>
    </message>
    <message>
        <source>Model input: shot %1 has %2 samples before the input starts, the anti-alias filter needs %3; start later or raise the model rate.</source>
        <translation>Modelleingang: Schuss %1 hat %2 Abtastwerte, bevor der Eingang beginnt, das Anti-Alias-Filter braucht %3; später beginnen oder die Modellrate anheben.</translation>
    </message>
    <message>
        <source>The step is treated as an impulse response (thesis method): one extra order models the step itself.</source>
        <translation>Der Sprung wird als Impulsantwort behandelt (Verfahren der Dissertation): Eine zusätzliche Ordnung bildet den Sprung selbst ab.</translation>
    </message>
    <message>
        <source>A copy of the step, %1 of it, follows after %2: an echo. The model and the response use the records up to %3 after the start; look for what reflects the shock.</source>
        <translation>Eine Kopie des Sprungs, %1 davon, folgt nach %2: ein Echo. Modell und Antwort verwenden die Aufzeichnungen bis %3 nach dem Beginn; nach dem suchen, was die Stoßwelle reflektiert.</translation>
    </message>
    <message>
        <source>A copy of the step, %1 of it, follows after %2: an echo, and the end of the window that was set lies behind it. Poles, damping and response contain it; end the window before it.</source>
        <translation>Eine Kopie des Sprungs, %1 davon, folgt nach %2: ein Echo, und das gesetzte Ende des Fensters liegt dahinter. Pole, Dämpfung und Antwort enthalten es; das Fenster davor enden lassen.</translation>
    </message>
    <message>
        <source>window.exclude_stretches: %1 to %2 of shot %3 must begin before it ends and touch its window, which reaches from its start to %4.</source>
        <translation>window.exclude_stretches: %1 bis %2 von Schuss %3 muss beginnen, bevor es endet, und sein Fenster berühren, das von seinem Beginn bis %4 reicht.</translation>
    </message>
    <message>
        <source>Shot %1: %2 to %3 behind the start is left out of the fit: %4</source>
        <translation>Schuss %1: %2 bis %3 hinter dem Beginn bleibt aus der Anpassung: %4</translation>
    </message>
    <message>
        <source>Shot %1: only %2 of the %3 samples of the model input are free of stretches left out; at least half are needed. Mark less, or exclude the shot.</source>
        <translation>Schuss %1: Nur %2 der %3 Abtastwerte des Modelleingangs sind frei von ausgelassenen Abschnitten; nötig ist mindestens die Hälfte. Weniger markieren oder den Schuss ausschließen.</translation>
    </message>
    <message>
        <source>The average of the shots is formed before the fit: the stretches to be left out are in it. Combine the shots as &quot;stacked&quot;.</source>
        <translation>Das Mittel der Schüsse wird vor der Anpassung gebildet: Die auszulassenden Abschnitte sind darin. Die Schüsse als &quot;stacked&quot; zusammenfassen.</translation>
    </message>
    <message>
        <source>Hankel matrix: %1 rows do not fit a model input of %2 samples; choose 2 to %3.</source>
        <translation>Hankel-Matrix: %1 Zeilen passen nicht zu einem Modelleingang von %2 Abtastwerten; 2 bis %3 wählen.</translation>
    </message>
    <message>
        <source>Order %1 has the smallest BIC on the pre-whitened response: order %2 is %3 higher, order %4 is %5 higher.</source>
        <translation>Ordnung %1 hat das kleinste BIC der vorgeweißten Antwort: Ordnung %2 liegt um %3 höher, Ordnung %4 um %5.</translation>
    </message>
    <message>
        <source>Order %1 has the smallest BIC on the pre-whitened response among orders 1 to %2.</source>
        <translation>Ordnung %1 hat das kleinste BIC der vorgeweißten Antwort unter den Ordnungen 1 bis %2.</translation>
    </message>
    <message>
        <source>No clear gap between the singular values: none above the noise is more than %1 times the next. Compare candidates.</source>
        <translation>Keine klare Lücke zwischen den Singulärwerten: Keiner über dem Rauschen ist mehr als das %1-Fache des nächsten. Kandidaten vergleichen.</translation>
    </message>
    <message>
        <source>The certificate has %1 lists over frequency; name the one that is meant by its id in quantity_id.</source>
        <translation>Der Kalibrierschein hat %1 Listen über der Frequenz; die gemeinte durch ihre id in quantity_id nennen.</translation>
    </message>
    <message>
        <source>The certificate has no list with the id &apos;%1&apos; of quantity_id, or several.</source>
        <translation>Der Kalibrierschein hat keine Liste mit der id „%1“ von quantity_id, oder mehrere.</translation>
    </message>
    <message>
        <source>The list of the certificate needs frequencies, magnitudes in %1 and perhaps phases, as many of each, with expanded uncertainties and their coverage factors.</source>
        <translation>Die Liste des Kalibrierscheins braucht Frequenzen, Beträge in %1 und vielleicht Phasen, von jedem gleich viele, mit erweiterten Messunsicherheiten und ihren Erweiterungsfaktoren.</translation>
    </message>
    <message>
        <source>A comparison needs the reference transducer&apos;s sensitivity from one place: give comparison.source or comparison.model, not both and not neither.</source>
        <translation>Ein Vergleich braucht die Empfindlichkeit des Referenzaufnehmers von einer Stelle: comparison.source oder comparison.model angeben, nicht beide und nicht keines.</translation>
    </message>
    <message>
        <source>Shot %1 has no channel of a reference transducer beside the sensor; give one the role &apos;reference&apos; (import.channels), name it in comparison.channel, or switch the comparison off.</source>
        <translation>Schuss %1 hat neben dem Aufnehmer keinen Kanal eines Referenzaufnehmers; einem die Rolle &apos;reference&apos; geben (import.channels), ihn in comparison.channel nennen oder den Vergleich ausschalten.</translation>
    </message>
    <message>
        <source>The reference transducer&apos;s channel %1 is recorded in %2, but comparison.unit is %3; they must belong together, such as V and V/Pa.</source>
        <translation>Der Kanal %1 des Referenzaufnehmers ist in %2 aufgezeichnet, aber comparison.unit ist %3; sie müssen zusammengehören, wie V und V/Pa.</translation>
    </message>
    <message>
        <source>The first line of the table has semicolons; the columns are parted by commas, and the numbers have a decimal point and no decimal comma.</source>
        <translation>Die erste Zeile der Tabelle hat Semikolons; die Spalten sind durch Kommas getrennt, und die Zahlen haben einen Dezimalpunkt und kein Dezimalkomma.</translation>
    </message>
    <message>
        <source>The table names the column &apos;%1&apos; twice, so that its values are not known; leave one of the two out.</source>
        <translation>Die Tabelle nennt die Spalte „%1“ zweimal, sodass deren Werte nicht bekannt sind; eine der beiden weglassen.</translation>
    </message>
    <message>
        <source>The table has a column &apos;%1&apos;; it may have frequency_hz, magnitude, u_magnitude, phase_rad, u_phase_rad and dof.</source>
        <translation>Die Tabelle hat eine Spalte „%1“; sie darf frequency_hz, magnitude, u_magnitude, phase_rad, u_phase_rad und dof haben.</translation>
    </message>
    <message>
        <source>The table has no column &apos;%1&apos;; its first line must name the columns.</source>
        <translation>Die Tabelle hat keine Spalte „%1“; ihre erste Zeile muss die Spalten nennen.</translation>
    </message>
    <message>
        <source>Line %1 of the table has %2 values for %3 columns; they are parted by commas, and the numbers have a decimal point and no decimal comma.</source>
        <translation>Zeile %1 der Tabelle hat %2 Werte für %3 Spalten; diese sind durch Kommas getrennt, und die Zahlen haben einen Dezimalpunkt und kein Dezimalkomma.</translation>
    </message>
    <message>
        <source>Line %1 of the table has &apos;%2&apos; for %3, which is no number with a decimal point.</source>
        <translation>Zeile %1 der Tabelle hat „%2“ für %3, was keine Zahl mit Dezimalpunkt ist.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; of chain.source begins with the magnitude %2 at %3 Hz; it needs the ratio to the gain at low frequency, which begins with 1. Divide its magnitudes by that gain, which belongs into the channel&apos;s scale, or begin the table at a lower frequency.</source>
        <translation>Die Datei „%1“ von chain.source beginnt mit dem Betrag %2 bei %3 Hz; nötig ist das Verhältnis zur Verstärkung bei tiefer Frequenz, das mit 1 beginnt. Ihre Beträge durch diese Verstärkung teilen, die in die Skalierung des Kanals gehört, oder die Tabelle bei tieferer Frequenz beginnen lassen.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; of chain.source begins with the phase %2 rad at %3 Hz; it needs one that begins near 0. Take whole turns off, and half a turn into the polarity of the channel; or begin the table at a lower frequency.</source>
        <translation>Die Datei „%1“ von chain.source beginnt mit der Phase %2 rad bei %3 Hz; nötig ist eine, die nahe 0 beginnt. Ganze Umläufe abziehen und einen halben in die Polarität des Kanals nehmen; oder die Tabelle bei tieferer Frequenz beginnen lassen.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; of chain.source has one row; it needs the frequencies of the response, for nothing is extrapolated.</source>
        <translation>Die Datei „%1“ von chain.source hat eine Zeile; nötig sind die Frequenzen der Antwort, denn nichts wird extrapoliert.</translation>
    </message>
    <message>
        <source>a frequency above that of the row before, and above 0</source>
        <translation>eine Frequenz über der der vorigen Zeile und über 0</translation>
    </message>
    <message>
        <source>a magnitude above 0</source>
        <translation>ein Betrag über 0</translation>
    </message>
    <message>
        <source>an uncertainty of the magnitude that is not negative</source>
        <translation>eine Unsicherheit des Betrags, die nicht negativ ist</translation>
    </message>
    <message>
        <source>a phase with its uncertainty in all rows, or in none</source>
        <translation>eine Phase mit ihrer Unsicherheit in allen Zeilen oder in keiner</translation>
    </message>
    <message>
        <source>a phase within half a turn of that of the row before: take the jumps of whole turns out</source>
        <translation>eine Phase innerhalb eines halben Umlaufs von der der vorigen Zeile: die Sprünge um ganze Umläufe herausnehmen</translation>
    </message>
    <message>
        <source>degrees of freedom above 0</source>
        <translation>Freiheitsgrade über 0</translation>
    </message>
    <message>
        <source>The table has no rows.</source>
        <translation>Die Tabelle hat keine Zeilen.</translation>
    </message>
    <message>
        <source>Row %1 of the table, at %2 Hz, needs %3.</source>
        <translation>Zeile %1 der Tabelle, bei %2 Hz, braucht %3.</translation>
    </message>
    <message>
        <source>comparison.model needs sensitivity, f0_hz and zeta above 0, and no uncertainty below 0.</source>
        <translation>comparison.model braucht sensitivity, f0_hz und zeta über 0 und keine Unsicherheit unter 0.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; of %2.source could not be read; it is looked for from the folder of the recipe, or of the profile that names it. Put it there, or give its whole path.</source>
        <translation>Die Datei „%1“ von %2.source konnte nicht gelesen werden; sie wird vom Ordner des Rezepts aus gesucht oder von dem des Profils, das sie nennt. Sie dorthin legen oder ihren ganzen Pfad angeben.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; has the hash %2, but %3.sha256 demands %4: it was changed, or it is another file. Restore it, or state the new hash.</source>
        <translation>Die Datei „%1“ hat die Prüfsumme %2, aber %3.sha256 verlangt %4: Sie wurde geändert, oder es ist eine andere Datei. Sie wiederherstellen oder die neue Prüfsumme angeben.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; of %2.source cannot be used. %M1</source>
        <translation>Die Datei „%1“ von %2.source ist nicht verwendbar. %M1</translation>
    </message>
    <message>
        <source>The gas &apos;%1&apos; has no heat capacity over temperature; choose air, n2, he, ar or co2, or a constant heat capacity.</source>
        <translation>Das Gas „%1“ hat keine Wärmekapazität über der Temperatur; air, n2, he, ar oder co2 wählen oder eine konstante Wärmekapazität.</translation>
    </message>
    <message>
        <source>The gas &apos;%1&apos; is not known; it must be air, humid-air, n2, he, ar, co2 or custom.</source>
        <translation>Das Gas „%1“ ist nicht bekannt; es muss air, humid-air, n2, he, ar, co2 oder custom sein.</translation>
    </message>
    <message>
        <source>Moist air (Cramer): the %1 is %2 %5, and the formula holds from %3 to %4 %5; choose the gas &apos;air&apos; or another value.</source>
        <translation>Feuchte Luft (Cramer): %1 ist %2 %5, und die Formel gilt von %3 bis %4 %5; das Gas &apos;air&apos; oder einen anderen Wert wählen.</translation>
    </message>
    <message>
        <source>Use %1 K</source>
        <translation>%1 K verwenden</translation>
    </message>
    <message>
        <source>The gas has a ratio of specific heats of %1; it must be above 1 and at most %2 (air: 1.402).</source>
        <translation>Das Gas hat ein Verhältnis der Wärmekapazitäten von %1; es muss über 1 liegen und höchstens %2 sein (Luft: 1,402).</translation>
    </message>
    <message>
        <source>The gas has a molar mass of %1 kg/mol; it must lie between %2 and %3 kg/mol (air: 0.028966), so check whether it was typed in g/mol.</source>
        <translation>Das Gas hat eine molare Masse von %1 kg/mol; sie muss zwischen %2 und %3 kg/mol liegen (Luft: 0,028966), also prüfen, ob sie in g/mol eingegeben wurde.</translation>
    </message>
    <message>
        <source>%1 = %2 K? Temperatures are in kelvin here: %2 degrees Celsius are %3 K.</source>
        <translation>%1 = %2 K? Temperaturen sind hier in Kelvin: %2 Grad Celsius sind %3 K.</translation>
    </message>
    <message>
        <source>%1 = %2 K is outside the range of %3 K to %4 K; enter the temperature of the gas in kelvin.</source>
        <translation>%1 = %2 K liegt außerhalb des Bereichs von %3 K bis %4 K; die Temperatur des Gases in Kelvin eingeben.</translation>
    </message>
    <message>
        <source>p1 = %1 Pa: the pressure in the driven section is absolute here and must be above 0; add the ambient pressure to a gauge reading.</source>
        <translation>p1 = %1 Pa: Der Druck im Niederdruckteil ist hier absolut und muss über 0 liegen; zu einem Überdruck den Umgebungsdruck addieren.</translation>
    </message>
    <message>
        <source>Computed Mach number %1 (velocity %2 m/s); a shock needs more than 1: check sample rate, distance, arrival times and T1.</source>
        <translation>Berechnete Mach-Zahl %1 (Geschwindigkeit %2 m/s); eine Stoßwelle braucht mehr als 1: Abtastrate, Abstand, Ankunftszeiten und T1 prüfen.</translation>
    </message>
    <message>
        <source>No driver pressure can produce a shock of Mach %1 with this driver gas at %2 K; check the velocity, T4 and the driver gas.</source>
        <translation>Kein Druck im Hochdruckteil kann mit diesem Treibergas bei %2 K eine Stoßwelle von Mach %1 erzeugen; die Geschwindigkeit, T4 und das Treibergas prüfen.</translation>
    </message>
    <message>
        <source>The pressure ratio p2/p1 is %1; a shock needs more than 1: check both pressures and whether they are absolute.</source>
        <translation>Das Druckverhältnis p2/p1 ist %1; eine Stoßwelle braucht mehr als 1: beide Drücke prüfen, und ob sie absolut sind.</translation>
    </message>
    <message>
        <source>The driver pressure p4 = %1 Pa does not exceed p1 = %2 Pa; both are absolute here: add the ambient pressure to a gauge reading.</source>
        <translation>Der Druck im Hochdruckteil p4 = %1 Pa übersteigt p1 = %2 Pa nicht; beide sind hier absolut: zu einem Überdruck den Umgebungsdruck addieren.</translation>
    </message>
    <message>
        <source>The uncertainty of %1 is not stated; add &apos;%2&apos; to uncertainty.budget of the recipe.</source>
        <translation>Die Unsicherheit von %1 ist nicht angegeben; „%2“ zu uncertainty.budget des Rezepts hinzufügen.</translation>
    </message>
    <message>
        <source>Peak %1 follows the sound speed of the gas (slope %2, u %3; of a sensor 0): a tube mode, to be left out of the model.</source>
        <translation>Maximum %1 folgt der Schallgeschwindigkeit des Gases (Steigung %2, u %3; bei einem Aufnehmer 0): eine Rohrmode, die aus dem Modell wegzulassen ist.</translation>
    </message>
    <message>
        <source>Peak %1 follows the sound speed of the gas (slope %2, u %3; of a sensor 0): a tube mode, to be left out of the model. The nearest computed is %4.</source>
        <translation>Maximum %1 folgt der Schallgeschwindigkeit des Gases (Steigung %2, u %3; bei einem Aufnehmer 0): eine Rohrmode, die aus dem Modell wegzulassen ist. Die nächste berechnete ist %4.</translation>
    </message>
    <message>
        <source>The arrivals from &apos;%1&apos; to &apos;%2&apos; give a velocity of %3 m/s; the shock must run towards the end wall: check channels, distances and arrivals.</source>
        <translation>Die Ankünfte von „%1“ bis „%2“ ergeben eine Geschwindigkeit von %3 m/s; die Stoßwelle muss zur Endwand laufen: Kanäle, Abstände und Ankünfte prüfen.</translation>
    </message>
    <message>
        <source>A velocity needs arrivals at two places at least; there are %1.</source>
        <translation>Eine Geschwindigkeit braucht Ankünfte an mindestens zwei Orten; es gibt %1.</translation>
    </message>
    <message>
        <source>A counter reads %1 s from %2 m to %3 m before the end wall; the time must be above 0 and the first distance the larger one.</source>
        <translation>Ein Zähler zeigt %1 s von %2 m bis %3 m vor der Endwand; die Zeit muss über 0 liegen und der erste Abstand der größere sein.</translation>
    </message>
    <message>
        <source>There is no counter reading.</source>
        <translation>Es gibt keine Ablesung eines Zählers.</translation>
    </message>
    <message>
        <source>Shot %1: the uncertainty of the step could not be checked by Monte Carlo (%M1); what the law of propagation gives may be wrong.</source>
        <translation>Schuss %1: Die Unsicherheit des Sprungs konnte nicht durch Monte Carlo geprüft werden (%M1); was das Fortpflanzungsgesetz ergibt, ist vielleicht falsch.</translation>
    </message>
    <message>
        <source>The gas constants recorded in the capture give a speed of sound of %1 in the driven gas, the gas that it names gives %2: with that the pressure step would be %3 % different. The constants are used; choose the driven gas.</source>
        <translation>Die in der Aufzeichnung genannten Gaskonstanten ergeben eine Schallgeschwindigkeit von %1 im Gas des Niederdruckteils, das dort genannte Gas ergibt %2: Damit wäre der Drucksprung um %3 % anders. Verwendet werden die Konstanten; das Gas des Niederdruckteils wählen.</translation>
    </message>
    <message>
        <source>With the humidity typed the driven gas has a speed of sound of %1, with the one recorded in the capture %2: with that the pressure step would be %3 % different. The typed one is used; correct it (shock.relative_humidity, 0 to 1), or leave it out.</source>
        <translation>Mit der eingegebenen Feuchte hat das Gas des Niederdruckteils eine Schallgeschwindigkeit von %1, mit der in der Aufzeichnung genannten %2: Damit wäre der Drucksprung um %3 % anders. Verwendet wird die eingegebene; sie berichtigen (shock.relative_humidity, 0 bis 1) oder weglassen.</translation>
    </message>
    <message>
        <source>The chosen driven gas has a speed of sound of %1, air of the known humidity %2: with that the pressure step would be %3 % different. The chosen gas is used; choose humid air or the recorded gas if that is what was in the tube.</source>
        <translation>Das gewählte Gas des Niederdruckteils hat eine Schallgeschwindigkeit von %1, Luft der bekannten Feuchte %2: Damit wäre der Drucksprung um %3 % anders. Verwendet wird das gewählte Gas; feuchte Luft oder das aufgezeichnete Gas wählen, wenn das im Rohr war.</translation>
    </message>
    <message>
        <source>The chosen driven gas has a speed of sound of %1, the gas constants recorded in the capture give %2: with that the pressure step would be %3 % different. The chosen gas is used; check which one was in the tube.</source>
        <translation>Das gewählte Gas des Niederdruckteils hat eine Schallgeschwindigkeit von %1, die in der Aufzeichnung genannten Gaskonstanten ergeben %2: Damit wäre der Drucksprung um %3 % anders. Verwendet wird das gewählte Gas; prüfen, welches im Rohr war.</translation>
    </message>
    <message>
        <source>The chosen driven gas has a speed of sound of %1, the gas named in the capture %2: with that the pressure step would be %3 % different. The chosen gas is used; check which one was in the tube.</source>
        <translation>Das gewählte Gas des Niederdruckteils hat eine Schallgeschwindigkeit von %1, das in der Aufzeichnung genannte Gas %2: Damit wäre der Drucksprung um %3 % anders. Verwendet wird das gewählte Gas; prüfen, welches im Rohr war.</translation>
    </message>
    <message>
        <source>Such a shock needs a driver pressure of %1, more than the %2 that this tube can have had (three times the recorded one at most, and shock.largest_driver_pressure_pa): check sample rate, distances, gases and temperature.</source>
        <translation>Eine solche Stoßwelle braucht einen Druck im Hochdruckteil von %1, mehr als die %2, die dieses Rohr gehabt haben kann (höchstens das Dreifache des aufgezeichneten und shock.largest_driver_pressure_pa): Abtastrate, Abstände, Gase und Temperatur prüfen.</translation>
    </message>
    <message>
        <source>The distance alone makes the velocity uncertain by %1 %, which gives %2 % on the pressure step (factor %3).</source>
        <translation>Der Abstand allein macht die Geschwindigkeit um %1 % unsicher, was %2 % am Drucksprung ergibt (Faktor %3).</translation>
    </message>
    <message>
        <source>Velocity uncertainty %1 % gives %2 % on the pressure step (factor %3); the budget says where it comes from.</source>
        <translation>Eine Unsicherheit der Geschwindigkeit von %1 % ergibt %2 % am Drucksprung (Faktor %3); das Budget sagt, woher sie kommt.</translation>
    </message>
    <message>
        <source>The DUT marks the arrival at the end wall by its detected start, which its own delay makes late: a microsecond is %1 % of the velocity and %2 % of the step. Use two side sensors, or a model of each shot instead of the average.</source>
        <translation>Der Prüfling erfasst die Ankunft an der Endwand durch seinen erkannten Beginn, den seine eigene Verzögerung verspätet: Eine Mikrosekunde sind %1 % der Geschwindigkeit und %2 % des Sprungs. Zwei Aufnehmer in der Seitenwand verwenden oder ein Modell je Schuss anstelle des Mittels.</translation>
    </message>
    <message>
        <source>The arrivals scatter about their line more than their stated uncertainties allow (chi-square %1, degrees of freedom %2): check distances, delays and arrivals, or let the velocity change along the tube.</source>
        <translation>Die Ankünfte streuen um ihre Gerade mehr, als ihre angegebenen Unsicherheiten erlauben (Chi-Quadrat %1, Freiheitsgrade %2): Abstände, Verzögerungen und Ankünfte prüfen oder die Geschwindigkeit sich längs des Rohrs ändern lassen.</translation>
    </message>
    <message>
        <source>The arrivals show a velocity that falls by %1 % per metre along the tube, outside the range of %2 to %3 % per metre that is assumed (shock.attenuation_per_m): widen the range if the tube does that, else check distances, delays and arrivals.</source>
        <translation>Die Ankünfte zeigen eine Geschwindigkeit, die längs des Rohrs um %1 % je Meter fällt, außerhalb des angenommenen Bereichs von %2 bis %3 % je Meter (shock.attenuation_per_m): den Bereich erweitern, wenn das Rohr das tut, sonst Abstände, Verzögerungen und Ankünfte prüfen.</translation>
    </message>
    <message>
        <source>The velocity is Mach %1; a shock in this tube reaches Mach %2 at most (shock.largest_mach): check sample rate, distances, gas and temperature.</source>
        <translation>Die Geschwindigkeit ist Mach %1; eine Stoßwelle in diesem Rohr erreicht höchstens Mach %2 (shock.largest_mach): Abtastrate, Abstände, Gas und Temperatur prüfen.</translation>
    </message>
    <message>
        <source>The velocity %1 is typed once and serves all %2 shots: type one for each shot, or none where it is measured.</source>
        <translation>Die Geschwindigkeit %1 ist einmal eingegeben und dient allen %2 Schüssen: für jeden Schuss eine eingeben, oder keine, wo sie gemessen ist.</translation>
    </message>
    <message>
        <source>The pressure step %1 is typed once and serves all %2 shots: type one for each shot, or none where it is computed.</source>
        <translation>Der Drucksprung %1 ist einmal eingegeben und dient allen %2 Schüssen: für jeden Schuss einen eingeben, oder keinen, wo er berechnet ist.</translation>
    </message>
    <message>
        <source>One arrival time, %1, is typed for a sensor and serves all %2 shots: type one for each shot, or none where the record shows it.</source>
        <translation>Eine Ankunftszeit, %1, ist für einen Aufnehmer eingegeben und dient allen %2 Schüssen: für jeden Schuss eine eingeben, oder keine, wo die Aufzeichnung sie zeigt.</translation>
    </message>
    <message>
        <source>The pressure %1 is typed once, and the state of all %2 shots follows from it: take the velocity, which is measured in each shot.</source>
        <translation>Der Druck %1 ist einmal eingegeben, und der Zustand aller %2 Schüsse folgt aus ihm: die Geschwindigkeit nehmen, die in jedem Schuss gemessen ist.</translation>
    </message>
    <message>
        <source>Driver pressure %1 is %2 % below the %3 that the shock implies (both absolute): usual for a finite opening time.</source>
        <translation>Der Druck im Hochdruckteil %1 liegt %2 % unter den %3, die die Stoßwelle verlangt (beide absolut): üblich bei endlicher Öffnungszeit.</translation>
    </message>
    <message>
        <source>Driver pressure %1 is %2 % above the %3 that the shock implies (both absolute): check whether the recorded value is right.</source>
        <translation>Der Druck im Hochdruckteil %1 liegt %2 % über den %3, die die Stoßwelle verlangt (beide absolut): prüfen, ob der aufgezeichnete Wert stimmt.</translation>
    </message>
    <message>
        <source>p1 = %1 Pa? Pressures are in pascals here: %1 %2 are %3 Pa, about ambient.</source>
        <translation>p1 = %1 Pa? Drücke sind hier in Pascal: %1 %2 sind %3 Pa, etwa der Umgebungsdruck.</translation>
    </message>
    <message>
        <source>Use %1 Pa</source>
        <translation>%1 Pa verwenden</translation>
    </message>
    <message>
        <source>The reflected shock&apos;s return from the contact surface reaches the end wall %1 after the step (computed).</source>
        <translation>Die Rückkehr der reflektierten Stoßwelle von der Kontaktfläche erreicht die Endwand %1 nach dem Sprung (berechnet).</translation>
    </message>
    <message>
        <source>The expansion reflected at the driver&apos;s end reaches the end wall %1 after the step (computed), before the contact surface&apos;s wave: a longer driver section would help.</source>
        <translation>Die am Ende des Hochdruckteils reflektierte Verdünnungswelle erreicht die Endwand %1 nach dem Sprung (berechnet), vor der Welle der Kontaktfläche: Ein längerer Hochdruckteil würde helfen.</translation>
    </message>
    <message>
        <source>The reflected shock passes the DUT %1 after the step (computed).</source>
        <translation>Die reflektierte Stoßwelle läuft %1 nach dem Sprung am Prüfling vorbei (berechnet).</translation>
    </message>
    <message>
        <source>The recipe lists %1 values for %2 shots; give one number or null per shot (%3).</source>
        <translation>Das Rezept nennt %1 Werte für %2 Schüsse; eine Zahl oder null je Schuss angeben (%3).</translation>
    </message>
    <message>
        <source>The typed pressure step is %1 Pa; it must be a number other than 0.</source>
        <translation>Der eingegebene Drucksprung ist %1 Pa; er muss eine Zahl ungleich 0 sein.</translation>
    </message>
    <message>
        <source>The arrival sensor &apos;%1&apos; has a distance to the end wall of %2 m; it must be above 0.</source>
        <translation>Der Ankunftsaufnehmer „%1“ hat einen Abstand von der Endwand von %2 m; er muss über 0 liegen.</translation>
    </message>
    <message>
        <source>The arrival sensor &apos;%1&apos; lists %2 arrivals for %3 shots; give one time or null per shot (shock.arrival_sensors[].arrival_s).</source>
        <translation>Der Ankunftsaufnehmer „%1“ nennt %2 Ankünfte für %3 Schüsse; eine Zeit oder null je Schuss angeben (shock.arrival_sensors[].arrival_s).</translation>
    </message>
    <message>
        <source>The DUT&apos;s position is &apos;%1&apos;; it must be &apos;end-wall&apos; or &apos;side-wall&apos;.</source>
        <translation>Die Lage des Prüflings ist „%1“; sie muss &apos;end-wall&apos; oder &apos;side-wall&apos; sein.</translation>
    </message>
    <message>
        <source>Shot %1: the step reads %2; %3 is expected. Is the unit %4? Set import.unit.</source>
        <translation>Schuss %1: Der Sprung zeigt %2; erwartet ist %3. Ist die Einheit %4? import.unit setzen.</translation>
    </message>
    <message>
        <source>Shot %1: the step reads %2; %3 is expected. Check the unit and the scale.</source>
        <translation>Schuss %1: Der Sprung zeigt %2; erwartet ist %3. Einheit und Skalierung prüfen.</translation>
    </message>
    <message>
        <source>The pressure step is not determined: the pressure p1 in the driven section is not recorded; enter p1 or the step itself.</source>
        <translation>Der Drucksprung ist nicht bestimmt: Der Druck p1 im Niederdruckteil ist nicht aufgezeichnet; p1 oder den Sprung selbst eingeben.</translation>
    </message>
    <message>
        <source>The pressure step is not determined: the temperature T1 in the driven section is not recorded; enter T1 or the step itself.</source>
        <translation>Der Drucksprung ist nicht bestimmt: Die Temperatur T1 im Niederdruckteil ist nicht aufgezeichnet; T1 oder den Sprung selbst eingeben.</translation>
    </message>
    <message>
        <source>The gas reaches %1 K, and the variable heat capacity holds from %2 K to %3 K; choose a constant one or another gas.</source>
        <translation>Das Gas erreicht %1 K, und die veränderliche Wärmekapazität gilt von %2 K bis %3 K; eine konstante oder ein anderes Gas wählen.</translation>
    </message>
    <message>
        <source>Shot %1: the step reaches &apos;%2&apos; %3 before &apos;%4&apos;, which the shock passes first. The two channels look swapped; exchange their roles in import.channels, for one file in import.files.</source>
        <translation>Schuss %1: Der Sprung erreicht „%2“ %3 vor „%4“, an dem die Stoßwelle zuerst vorbeiläuft. Die beiden Kanäle sehen vertauscht aus; ihre Rollen in import.channels tauschen, für eine Datei in import.files.</translation>
    </message>
    <message>
        <source>The pressure step is not determined: the shock velocity is unknown, because the distance from the side sensor to the end wall is not recorded; enter the distance, the velocity or the step itself.</source>
        <translation>Der Drucksprung ist nicht bestimmt: Die Geschwindigkeit der Stoßwelle ist unbekannt, weil der Abstand vom Aufnehmer in der Seitenwand zur Endwand nicht aufgezeichnet ist; den Abstand, die Geschwindigkeit oder den Sprung selbst eingeben.</translation>
    </message>
    <message>
        <source>The pressure step is not determined: the shock velocity is unknown, because no channel marks the passing of the shock; enter the velocity or the step itself.</source>
        <translation>Der Drucksprung ist nicht bestimmt: Die Geschwindigkeit der Stoßwelle ist unbekannt, weil kein Kanal den Durchgang der Stoßwelle erfasst; die Geschwindigkeit oder den Sprung selbst eingeben.</translation>
    </message>
    <message>
        <source>The pressure step is not determined: the shock velocity is unknown, because no arrival is found in the channel &apos;%1&apos;; enter the velocity or the step itself.</source>
        <translation>Der Drucksprung ist nicht bestimmt: Die Geschwindigkeit der Stoßwelle ist unbekannt, weil im Kanal „%1“ keine Ankunft gefunden wird; die Geschwindigkeit oder den Sprung selbst eingeben.</translation>
    </message>
    <message>
        <source>The pressure step is not determined: the shock velocity is unknown, because the arrival at the DUT is not known; enter the velocity or the step itself.</source>
        <translation>Der Drucksprung ist nicht bestimmt: Die Geschwindigkeit der Stoßwelle ist unbekannt, weil die Ankunft am Prüfling nicht bekannt ist; die Geschwindigkeit oder den Sprung selbst eingeben.</translation>
    </message>
    <message>
        <source>The pressure step is not determined: the shock velocity is unknown, because a DUT in the side wall needs two arrival sensors; enter the velocity or the step itself.</source>
        <translation>Der Drucksprung ist nicht bestimmt: Die Geschwindigkeit der Stoßwelle ist unbekannt, weil ein Prüfling in der Seitenwand zwei Ankunftsaufnehmer braucht; die Geschwindigkeit oder den Sprung selbst eingeben.</translation>
    </message>
    <message>
        <source>The shock reaches &apos;%1&apos; %2 after &apos;%3&apos;, which is farther down the tube: check whether the two channels are swapped (CAP-010), and their distances.</source>
        <translation>Die Stoßwelle erreicht „%1“ %2 nach „%3“, der weiter hinten im Rohr liegt: prüfen, ob die beiden Kanäle vertauscht sind (CAP-010), und ihre Abstände.</translation>
    </message>
    <message>
        <source>Exchange &apos;%1&apos; and &apos;%2&apos;</source>
        <translation>„%1“ und „%2“ tauschen</translation>
    </message>
    <message>
        <source>Shot %1, channel %2 stands still at %3 for %4 % of the response window, the longest time from %5 on, although its baseline shows noise: it was cut off or stuck. The shot cannot be used: exclude it.</source>
        <translation>Schuss %1, Kanal %2 steht bei %3 für %4 % des Antwortfensters still, am längsten ab %5, obwohl seine Nulllinie Rauschen zeigt: Er war abgeschnitten oder hing fest. Der Schuss ist nicht verwendbar: ihn ausschließen.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2 stands still at %3 from %4 on, although its baseline shows noise: it froze during the response, so the end of the plateau cannot be found. Exclude the shot, or set window.end_s before that time if the record up to there can be trusted.</source>
        <translation>Schuss %1, Kanal %2 steht ab %4 bei %3 still, obwohl seine Nulllinie Rauschen zeigt: Er fror während der Antwort ein, daher ist das Ende des Plateaus nicht zu finden. Den Schuss ausschließen oder window.end_s vor diese Zeit setzen, wenn der Aufzeichnung bis dahin zu trauen ist.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2 stands still at %3 for %4 from %5 on, soon behind the response window, although its baseline shows noise: it was cut off or stuck there; look whether the response before can be trusted.</source>
        <translation>Schuss %1, Kanal %2 steht ab %5 für %4 bei %3 still, bald hinter dem Antwortfenster, obwohl seine Nulllinie Rauschen zeigt: Er war dort abgeschnitten oder hing fest; prüfen, ob der Antwort davor zu trauen ist.</translation>
    </message>
    <message>
        <source>Shot %1: %2 samples in a row at %3 are equal and the extreme of the window; the record may be saturated there.</source>
        <translation>Schuss %1: %2 Abtastwerte in Folge bei %3 sind gleich und das Extrem des Fensters; die Aufzeichnung ist dort vielleicht übersteuert.</translation>
    </message>
    <message>
        <source>Shot %1: the step is negative (%2); set import.polarity to -1 if the sensor is inverted.</source>
        <translation>Schuss %1: Der Sprung ist negativ (%2); import.polarity auf -1 setzen, wenn der Aufnehmer umgepolt ist.</translation>
    </message>
    <message>
        <source>Shot %1: the settling level still drifts %2 % of the step per ms; the level depends by +-%3 % on where the settle band lies.</source>
        <translation>Schuss %1: Der Beharrungswert driftet noch um %2 % des Sprungs je ms; der Pegel hängt um +-%3 % davon ab, wo der Beharrungsbereich liegt.</translation>
    </message>
    <message>
        <source>Move the end to %1</source>
        <translation>Das Ende auf %1 verschieben</translation>
    </message>
    <message>
        <source>Move the end of shot %1 to %2</source>
        <translation>Das Ende von Schuss %1 auf %2 verschieben</translation>
    </message>
    <message>
        <source>Shot %1: the window ends %2 after the computed end of the plateau, %3 behind the start; move window.end_s.</source>
        <translation>Schuss %1: Das Fenster endet %2 nach dem berechneten Ende des Plateaus, %3 hinter dem Beginn; window.end_s verschieben.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: invalid samples (%3, from sample %4 to %5) at %6, inside the response window or its baseline; exclude the shot or set import.interpolate_invalid.</source>
        <translation>Schuss %1, Kanal %2: ungültige Abtastwerte (%3, von Abtastwert %4 bis %5) bei %6, innerhalb des Antwortfensters oder seiner Nulllinie; den Schuss ausschließen oder import.interpolate_invalid setzen.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2 is saturated for %3 (%4 samples) at %5, from %6 on, inside the response window or its baseline; the shot cannot be used: exclude it.</source>
        <translation>Schuss %1, Kanal %2 ist ab %6 für %3 (%4 Abtastwerte) bei %5 übersteuert, innerhalb des Antwortfensters oder seiner Nulllinie; der Schuss ist nicht verwendbar: ihn ausschließen.</translation>
    </message>
    <message>
        <source>Shot %1: the step uses %2 codes of the converter; quantisation limits the result.</source>
        <translation>Schuss %1: Der Sprung nutzt %2 Stufen des Wandlers; die Quantisierung begrenzt das Ergebnis.</translation>
    </message>
    <message>
        <source>Shot %1: the baseline drifts %2 % of the step per ms, +-%3 % over the band.</source>
        <translation>Schuss %1: Die Nulllinie driftet um %2 % des Sprungs je ms, +-%3 % über den Bereich.</translation>
    </message>
    <message>
        <source>Shot %1: SNR %2 dB; even a perfect model would score a FIT of about %3 %.</source>
        <translation>Schuss %1: SNR %2 dB; selbst ein vollkommenes Modell käme auf einen FIT von etwa %3 %.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: no step found, because the record&apos;s values are not there or too large to compute with; check the channel&apos;s unit and factor, or exclude the shot.</source>
        <translation>Schuss %1, Kanal %2: kein Sprung gefunden, weil die Werte der Aufzeichnung fehlen oder zum Rechnen zu groß sind; Einheit und Faktor des Kanals prüfen oder den Schuss ausschließen.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: no step found. The largest change is %3, and more than %4 is needed, %5 times the noise of %6: set window.start by hand or exclude the shot.</source>
        <translation>Schuss %1, Kanal %2: kein Sprung gefunden. Die größte Änderung ist %3, und mehr als %4 ist nötig, das %5-Fache des Rauschens von %6: window.start von Hand setzen oder den Schuss ausschließen.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: no step found. The largest change is %3, and more than %4 is needed, %5 times the %6 that the record drifts in the same time: set window.start by hand or exclude the shot.</source>
        <translation>Schuss %1, Kanal %2: kein Sprung gefunden. Die größte Änderung ist %3, und mehr als %4 ist nötig, das %5-Fache der %6, um die die Aufzeichnung in derselben Zeit driftet: window.start von Hand setzen oder den Schuss ausschließen.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: the start cannot be detected, because the record moves or holds no numbers from sample %3 (%4) on and at least %5 quiet samples are needed before. Set window.start by hand.</source>
        <translation>Schuss %1, Kanal %2: Der Beginn ist nicht zu erkennen, weil sich die Aufzeichnung ab Abtastwert %3 (%4) bewegt oder keine Zahlen enthält und davor mindestens %5 ruhige Abtastwerte nötig sind. window.start von Hand setzen.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: the start cannot be detected in %3 samples, at least %4 are needed. Set window.start by hand.</source>
        <translation>Schuss %1, Kanal %2: Der Beginn ist in %3 Abtastwerten nicht zu erkennen, nötig sind mindestens %4. window.start von Hand setzen.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: there are no valid samples to find a start in; exclude the shot.</source>
        <translation>Schuss %1, Kanal %2: Es gibt keine gültigen Abtastwerte, in denen ein Beginn zu finden wäre; den Schuss ausschließen.</translation>
    </message>
    <message>
        <source>Shot %1: the window is to end with the computed plateau, but there are no shock data to compute it from; give them or a time for window.end_s.</source>
        <translation>Schuss %1: Das Fenster soll mit dem berechneten Plateau enden, aber es gibt keine Daten der Stoßwelle, um es zu berechnen; sie angeben oder eine Zeit für window.end_s.</translation>
    </message>
    <message>
        <source>Shot %1: the settle band %2 to %3 must lie within the window, 0 to %4 behind the start; move window.settle_s or window.end_s.</source>
        <translation>Schuss %1: Der Beharrungsbereich %2 bis %3 muss innerhalb des Fensters liegen, 0 bis %4 hinter dem Beginn; window.settle_s oder window.end_s verschieben.</translation>
    </message>
    <message>
        <source>Shot %1: the baseline %2 to %3 leaves the record, which reaches from %4 to %5 relative to the start; move window.baseline_s.</source>
        <translation>Schuss %1: Die Nulllinie %2 bis %3 verlässt die Aufzeichnung, die von %4 bis %5 relativ zum Beginn reicht; window.baseline_s verschieben.</translation>
    </message>
    <message>
        <source>Shot %1: the baseline has %2 samples and needs at least %3; choose another window.baseline_s, or null to subtract nothing.</source>
        <translation>Schuss %1: Die Nulllinie hat %2 Abtastwerte und braucht mindestens %3; eine andere window.baseline_s wählen, oder null, um nichts abzuziehen.</translation>
    </message>
    <message>
        <source>Shot %1: the baseline %2 to %3 overlaps the response, which begins at 0; move window.baseline_s or window.end_s.</source>
        <translation>Schuss %1: Die Nulllinie %2 bis %3 überlappt die Antwort, die bei 0 beginnt; window.baseline_s oder window.end_s verschieben.</translation>
    </message>
    <message>
        <source>Shot %1 ends %2 behind its start, before the window&apos;s end at %3; set window.end_s to %2 at most or exclude the shot.</source>
        <translation>Schuss %1 endet %2 hinter seinem Beginn, vor dem Ende des Fensters bei %3; window.end_s auf höchstens %2 setzen oder den Schuss ausschließen.</translation>
    </message>
    <message>
        <source>Shot %1: the window has %2 samples and needs at least %3; set window.end_s.</source>
        <translation>Schuss %1: Das Fenster hat %2 Abtastwerte und braucht mindestens %3; window.end_s setzen.</translation>
    </message>
    <message>
        <source>A power spectrum needs at least %1 valid samples at a known rate; there are %2 samples at %3.</source>
        <translation>Ein Leistungsspektrum braucht mindestens %1 gültige Abtastwerte bei bekannter Rate; es gibt %2 Abtastwerte bei %3.</translation>
    </message>
    <message>
        <source>The power spectrum exceeds the range of numbers: the largest value is %1; check the scale of the channel.</source>
        <translation>Das Leistungsspektrum übersteigt den Bereich der Zahlen: Der größte Wert ist %1; die Skalierung des Kanals prüfen.</translation>
    </message>
    <message>
        <source>window.start lists %1 times for %2 shots; give one time or one per shot.</source>
        <translation>window.start nennt %1 Zeiten für %2 Schüsse; eine Zeit angeben oder eine je Schuss.</translation>
    </message>
    <message>
        <source>The band %1 to %2 in the window settings must begin before it ends.</source>
        <translation>Der Bereich %1 bis %2 in den Einstellungen des Fensters muss beginnen, bevor er endet.</translation>
    </message>
    <message>
        <source>window.end_s lists %1 ends for %2 shots; give one end or one per shot.</source>
        <translation>window.end_s nennt %1 Enden für %2 Schüsse; ein Ende angeben oder eines je Schuss.</translation>
    </message>
    <message>
        <source>A time in the window settings is not a finite number.</source>
        <translation>Eine Zeit in den Einstellungen des Fensters ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>Shot %1: the record of channel %2, from %3 to %4, does not hold the baseline and the response of channel %5; record both over the same time, or shorten the window.</source>
        <translation>Schuss %1: Die Aufzeichnung von Kanal %2, von %3 bis %4, enthält Nulllinie und Antwort von Kanal %5 nicht; beide über dieselbe Zeit aufzeichnen oder das Fenster verkürzen.</translation>
    </message>
    <message>
        <source>Shot %1 has no DUT channel; choose which channel is the sensor under test (import.channels).</source>
        <translation>Schuss %1 hat keinen Kanal des Prüflings; wählen, welcher Kanal der Prüfling ist (import.channels).</translation>
    </message>
    <message>
        <source>Shot %1: the sample rate of channel %2 is unknown; give import.sample_rate_hz.</source>
        <translation>Schuss %1: Die Abtastrate von Kanal %2 ist unbekannt; import.sample_rate_hz angeben.</translation>
    </message>
    <message>
        <source>Shot %1: window.start %2 lies outside the record, which reaches from %3 to %4.</source>
        <translation>Schuss %1: window.start %2 liegt außerhalb der Aufzeichnung, die von %3 bis %4 reicht.</translation>
    </message>
    <message>
        <source>Shot %1: the record moves before the response, its baseline is not at rest; the shot is not used. Exclude it, or set window.start and window.baseline_s by hand.</source>
        <translation>Schuss %1: Die Aufzeichnung bewegt sich vor der Antwort, ihre Nulllinie ist nicht in Ruhe; der Schuss wird nicht verwendet. Ihn ausschließen oder window.start und window.baseline_s von Hand setzen.</translation>
    </message>
    <message>
        <source>Shot %1: whether there is a step cannot be told, because the record&apos;s values are not there or too large to compute with; check the channel&apos;s unit and factor, or exclude the shot.</source>
        <translation>Schuss %1: Ob es einen Sprung gibt, ist nicht zu sagen, weil die Werte der Aufzeichnung fehlen oder zum Rechnen zu groß sind; Einheit und Faktor des Kanals prüfen oder den Schuss ausschließen.</translation>
    </message>
    <message>
        <source>Shot %1: no step between baseline and settle band; it is %2, and %3 would be needed to tell it from noise. Check window.start or exclude the shot.</source>
        <translation>Schuss %1: kein Sprung zwischen Nulllinie und Beharrungsbereich; er ist %2, und %3 wären nötig, um ihn vom Rauschen zu unterscheiden. window.start prüfen oder den Schuss ausschließen.</translation>
    </message>
    <message>
        <source>No resonance found below %1.</source>
        <translation>Keine Resonanz unter %1 gefunden.</translation>
    </message>
    <message>
        <source>The resonance differs between shots: %1 to %2, a spread of %3 %.</source>
        <translation>Die Resonanz ist von Schuss zu Schuss verschieden: %1 bis %2, eine Spanne von %3 %.</translation>
    </message>
    <message>
        <source>S(f) is not stated per pressure</source>
        <translation>S(f) ist nicht je Druck angegeben</translation>
    </message>
    <message>
        <source>its unit %1 is none of %2, in which S(f) is</source>
        <translation>seine Einheit %1 ist keine von %2, in denen S(f) steht</translation>
    </message>
    <message>
        <source>its expanded uncertainty is not below its value</source>
        <translation>seine erweiterte Messunsicherheit liegt nicht unter seinem Wert</translation>
    </message>
    <message>
        <source>the response drifts as behind an AC coupling, so below the band it is not known</source>
        <translation>die Antwort driftet wie hinter einer Wechselspannungskopplung, daher ist sie unterhalb des Bandes nicht bekannt</translation>
    </message>
    <message>
        <source>%1 is above the band, which ends at %2</source>
        <translation>%1 liegt über dem Band, das bei %2 endet</translation>
    </message>
    <message>
        <source>the sensitivity has no complete uncertainty</source>
        <translation>die Empfindlichkeit hat keine vollständige Unsicherheit</translation>
    </message>
    <message>
        <source>S(f) is withheld at %1</source>
        <translation>S(f) wird bei %1 zurückgehalten</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>%M1 states %1, this calibration %2: they differ by %3 %, En = %4, more than both expanded uncertainties, and are not joined to one curve. Check unit, range, gas and mounting of either; the one that is wrong is not known.</source>
        <translation>%M1 nennt %1, diese Kalibrierung %2: Sie unterscheiden sich um %3 %, En = %4, mehr als beide erweiterten Messunsicherheiten, und werden nicht zu einer Kurve zusammengeführt. Einheit, Bereich, Gas und Einbau beider prüfen; welche falsch ist, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>%M1 of response.known cannot be compared with this calibration: %M2. Correct it, or leave it out.</source>
        <translation>%M1 von response.known lässt sich mit dieser Kalibrierung nicht vergleichen: %M2. Es berichtigen oder weglassen.</translation>
    </message>
    <message>
        <source>the model was not refined</source>
        <translation>das Modell wurde nicht verfeinert</translation>
    </message>
    <message>
        <source>an oscillation below 1 % of the step decides it, which may be the mount&apos;s</source>
        <translation>eine Schwingung unter 1 % des Sprungs entscheidet darüber, vielleicht die der Halterung</translation>
    </message>
    <message>
        <source>a part of it is not known</source>
        <translation>ein Teil davon ist nicht bekannt</translation>
    </message>
    <message>
        <source>The sensitivity against the computed pressure step differs by %1 % from that against the reference transducer, more than both uncertainties allow (U = %2 %, k = 2). Check the transducer&apos;s certificate, unit and chain, and gas, temperature and distances of the step.</source>
        <translation>Die Empfindlichkeit gegen den berechneten Drucksprung weicht um %1 % von der gegen den Referenzaufnehmer ab, mehr als beide Unsicherheiten erlauben (U = %2 %, k = 2). Kalibrierschein, Einheit und Messkette des Aufnehmers sowie Gas, Temperatur und Abstände des Sprungs prüfen.</translation>
    </message>
    <message>
        <source>that of the pressure step or of a level is not known</source>
        <translation>die des Drucksprungs oder eines Pegels ist nicht bekannt</translation>
    </message>
    <message>
        <source>The sensitivity has no complete uncertainty: that of the level at the onset is not known. Refine the model, or choose an order whose level is known.</source>
        <translation>Die Empfindlichkeit hat keine vollständige Unsicherheit: Die des Pegels beim Einsatz ist nicht bekannt. Das Modell verfeinern oder eine Ordnung wählen, deren Pegel bekannt ist.</translation>
    </message>
    <message>
        <source>The sensitivity has no complete uncertainty (%M1). State what is missing in uncertainty.budget or in the capture; without it no sensitivity is a result.</source>
        <translation>Die Empfindlichkeit hat keine vollständige Unsicherheit (%M1). Das Fehlende in uncertainty.budget oder in der Aufzeichnung angeben; ohne es ist keine Empfindlichkeit ein Ergebnis.</translation>
    </message>
    <message>
        <source>The document cannot be drawn: the program found nothing to draw on; start it anew.</source>
        <translation>Das Dokument lässt sich nicht zeichnen: Das Programm fand nichts, worauf zu zeichnen wäre; es neu starten.</translation>
    </message>
    <message>
        <source>The logo %1 of the template %2 cannot be drawn; save it anew as PNG or plain SVG.</source>
        <translation>Das Logo %1 der Vorlage %2 lässt sich nicht zeichnen; es neu als PNG oder einfaches SVG speichern.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos;: the recipe states a sensitivity of %2, the card of the sensor %3, which is %4 % different. The recipe&apos;s is used; correct it, or the card.</source>
        <translation>Kanal „%1“: Das Rezept nennt eine Empfindlichkeit von %2, die Datenkarte des Aufnehmers %3, was um %4 % abweicht. Verwendet wird die des Rezepts; sie oder die Datenkarte berichtigen.</translation>
    </message>
    <message>
        <source>Shot %1 is of the sensor %2, shot %3 of the sensor %4: a calibration is of one sensor. Take the shots of the other one out, or correct the captures.</source>
        <translation>Schuss %1 ist vom Aufnehmer %2, Schuss %3 vom Aufnehmer %4: Eine Kalibrierung gilt einem Aufnehmer. Die Schüsse des anderen herausnehmen oder die Aufzeichnungen berichtigen.</translation>
    </message>
    <message>
        <source>Recipe %1 names a channel &apos;%2&apos; that no shot has; the channels are %3.</source>
        <translation>Das Rezept nennt in %1 einen Kanal „%2“, den kein Schuss hat; die Kanäle sind %3.</translation>
    </message>
    <message>
        <source>Recipe import.shots names shot %1; the shots are 1 to %2.</source>
        <translation>Das Rezept nennt in import.shots den Schuss %1; die Schüsse sind 1 bis %2.</translation>
    </message>
    <message>
        <source>Recipe import.shots names shot %1 twice.</source>
        <translation>Das Rezept nennt in import.shots den Schuss %1 zweimal.</translation>
    </message>
    <message>
        <source>Recipe import.files names &apos;%1&apos;, which is none of the inputs; these are %2.</source>
        <translation>Das Rezept nennt in import.files „%1“, das keine der Eingaben ist; diese sind %2.</translation>
    </message>
    <message>
        <source>Recipe import.levels has %1 entries for %2 shots; give one for each shot.</source>
        <translation>Das Rezept hat in import.levels %1 Einträge für %2 Schüsse; für jeden Schuss einen angeben.</translation>
    </message>
    <message>
        <source>Recipe import.exclude names shot %1; the shots are 1 to %2.</source>
        <translation>Das Rezept nennt in import.exclude den Schuss %1; die Schüsse sind 1 bis %2.</translation>
    </message>
    <message>
        <source>All %1 shots are excluded; include at least one to calibrate.</source>
        <translation>Alle %1 Schüsse sind ausgeschlossen; mindestens einen einschließen, um zu kalibrieren.</translation>
    </message>
    <message>
        <source>%1 changed since it was opened; open it again, or take an unchanged copy.</source>
        <translation>%1 wurde geändert, seit sie geöffnet wurde; neu öffnen oder eine unveränderte Kopie nehmen.</translation>
    </message>
    <message>
        <source>%1 is damaged: the samples of shot %2, channel &apos;%3&apos; are not those that were recorded (their SHA-256 differs from the one in the file); take an unchanged copy.</source>
        <translation>%1 ist beschädigt: Die Abtastwerte von Schuss %2, Kanal „%3“, sind nicht die aufgezeichneten (ihr SHA-256 weicht von dem in der Datei ab); eine unveränderte Kopie nehmen.</translation>
    </message>
    <message>
        <source>%1: the samples of shot %2, channel &apos;%3&apos; cannot be read any more; check the drive or the network, or copy the file again.</source>
        <translation>%1: Die Abtastwerte von Schuss %2, Kanal „%3“, sind nicht mehr lesbar; Laufwerk oder Netz prüfen oder die Datei neu kopieren.</translation>
    </message>
    <message>
        <source>%1 and %2 hold identical data; a shot counted twice makes the scatter look smaller than it is. Take one of them out.</source>
        <translation>%1 und %2 enthalten gleiche Daten; ein doppelt gezählter Schuss lässt die Streuung kleiner aussehen, als sie ist. Einen davon herausnehmen.</translation>
    </message>
    <message>
        <source>%1 was changed, moved or removed while it was in use, or can no longer be read, so nothing was made of it; leave it where it is and start again, or take an unchanged copy.</source>
        <translation>%1 wurde während der Benutzung geändert, verschoben oder entfernt oder ist nicht mehr lesbar, daher wurde nichts daraus gemacht; an ihrem Platz lassen und neu beginnen oder eine unveränderte Kopie nehmen.</translation>
    </message>
    <message>
        <source>%1 changed since it was imported. The results are of the new data and cannot be certified in this project.</source>
        <translation>%1 wurde geändert, seit sie eingelesen wurde. Die Ergebnisse sind die der neuen Daten und können in diesem Projekt nicht bescheinigt werden.</translation>
    </message>
    <message>
        <source>Shot %1, channel &apos;%2&apos;: the samples cannot be read any more, because the file changed or is out of reach; open it again.</source>
        <translation>Schuss %1, Kanal „%2“: Die Abtastwerte sind nicht mehr lesbar, weil die Datei geändert wurde oder nicht erreichbar ist; sie ist neu zu öffnen.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos; of shot %2 has no samples. Check the file and the role.</source>
        <translation>Kanal „%1“ von Schuss %2 hat keine Abtastwerte. Datei und Rolle prüfen.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos; of shot %2 has no valid sample: none of its %3 samples is a number. Check the file and the role.</source>
        <translation>Kanal „%1“ von Schuss %2 hat keinen gültigen Abtastwert: Keiner seiner %3 Abtastwerte ist eine Zahl. Datei und Rolle prüfen.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos; of shot %2 is flat: all %3 samples are %4. Check cable and role.</source>
        <translation>Kanal „%1“ von Schuss %2 ist konstant: Alle %3 Abtastwerte sind %4. Kabel und Rolle prüfen.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos; of shot %2 is flat: all its valid samples (%3) are %4. Check cable and role.</source>
        <translation>Kanal „%1“ von Schuss %2 ist konstant: Alle seine gültigen Abtastwerte (%3) sind %4. Kabel und Rolle prüfen.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos; of shot %2 has a single valid sample, %4, which is no record. Check the file and the role.</source>
        <translation>Kanal „%1“ von Schuss %2 hat einen einzigen gültigen Abtastwert, %4, was keine Aufzeichnung ist. Datei und Rolle prüfen.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos; of shot %2 is flat: its standard deviation is %3 codes of the converter (%4 is the limit). Check cable and role.</source>
        <translation>Kanal „%1“ von Schuss %2 ist konstant: Seine Standardabweichung ist %3 Stufen des Wandlers (%4 ist die Grenze). Kabel und Rolle prüfen.</translation>
    </message>
    <message>
        <source>Shot %1, %2: %3 invalid samples from %4 on (samples %5 to %6). Inside the response window they block the shot; exclude it or set import.interpolate_invalid.</source>
        <translation>Schuss %1, %2: %3 ungültige Abtastwerte ab %4 (Abtastwerte %5 bis %6). Innerhalb des Antwortfensters sperren sie den Schuss; ihn ausschließen oder import.interpolate_invalid setzen.</translation>
    </message>
    <message>
        <source>Shot %1, %2 is saturated for %3 at %4, from %5 on. Inside the response window that blocks the shot; use a wider range.</source>
        <translation>Schuss %1, %2 ist ab %5 für %3 bei %4 übersteuert. Innerhalb des Antwortfensters sperrt das den Schuss; einen größeren Messbereich verwenden.</translation>
    </message>
    <message>
        <source>Shot %1, %2 looks cut off for %3 at %4, from %5 on. More than 20 % of the response window like that blocks the shot; use a wider range.</source>
        <translation>Schuss %1, %2 sieht ab %5 für %3 bei %4 abgeschnitten aus. Mehr als 20 % des Antwortfensters in dieser Art sperren den Schuss; einen größeren Messbereich verwenden.</translation>
    </message>
    <message>
        <source>Shot %1%2 and shot %3%4 hold identical data; a shot counted twice makes the scatter look smaller than it is. Exclude one of them.</source>
        <translation>Schuss %1%2 und Schuss %3%4 enthalten gleiche Daten; ein doppelt gezählter Schuss lässt die Streuung kleiner aussehen, als sie ist. Einen davon ausschließen.</translation>
    </message>
    <message>
        <source>One shot: PCA is skipped and repeatability cannot be evaluated.</source>
        <translation>Ein Schuss: Die Hauptkomponentenanalyse entfällt, und die Wiederholbarkeit kann nicht beurteilt werden.</translation>
    </message>
    <message>
        <source>Shots have different sample rates (%1). For PCA they are brought to %2; the model input resamples each from its own rate.</source>
        <translation>Die Schüsse haben verschiedene Abtastraten (%1). Für die Hauptkomponentenanalyse werden sie auf %2 gebracht; der Modelleingang rechnet jeden von seiner eigenen Rate um.</translation>
    </message>
    <message>
        <source>Shots have different lengths (%1); what all of them have is used.</source>
        <translation>Die Schüsse haben verschiedene Längen (%1); verwendet wird, was alle haben.</translation>
    </message>
    <message>
        <source>Shot %1 has no DUT channel. Choose which channel is the sensor under test (import.channels in the recipe).</source>
        <translation>Schuss %1 hat keinen Kanal des Prüflings. Wählen, welcher Kanal der Prüfling ist (import.channels im Rezept).</translation>
    </message>
    <message>
        <source>Shot %1, channel &apos;%2&apos;: the file states no sample rate and has no time column; give import.sample_rate_hz in the recipe.</source>
        <translation>Schuss %1, Kanal „%2“: Die Datei nennt keine Abtastrate und hat keine Zeitspalte; import.sample_rate_hz angeben.</translation>
    </message>
    <message>
        <source>Shot %1, channel &apos;%2&apos;: the file gives a sample rate of %3 (an interval of %4), and recordings have %5 to %6. Correct the times or the rate in the file, or give import.sample_rate_hz and import.sample_rate_reason.</source>
        <translation>Schuss %1, Kanal „%2“: Die Datei nennt eine Abtastrate von %3 (ein Intervall von %4), und Aufzeichnungen haben %5 bis %6. Die Zeiten oder die Rate in der Datei berichtigen oder import.sample_rate_hz und import.sample_rate_reason angeben.</translation>
    </message>
    <message>
        <source>Shot %1, channel &apos;%2&apos;: import.sample_rate_hz is %3 (an interval of %4), and recordings have %5 to %6. Correct the key.</source>
        <translation>Schuss %1, Kanal „%2“: import.sample_rate_hz ist %3 (ein Intervall von %4), und Aufzeichnungen haben %5 bis %6. Den Schlüssel berichtigen.</translation>
    </message>
    <message>
        <source>Shot %1, channel &apos;%2&apos;: the file states %3 but import.sample_rate_hz is %4. Leave the key out, or say in import.sample_rate_reason why the file is wrong.</source>
        <translation>Schuss %1, Kanal „%2“: Die Datei nennt %3, aber import.sample_rate_hz ist %4. Den Schlüssel weglassen oder in import.sample_rate_reason sagen, warum die Datei falsch ist.</translation>
    </message>
    <message>
        <source>The recipe&apos;s sample rate of %1 replaces the %2 that the files state.</source>
        <translation>Die Abtastrate %1 des Rezepts ersetzt die der Dateien, %2.</translation>
    </message>
    <message>
        <source>The recipe&apos;s sample rate of %1 replaces the %2 that the files state; reason: %3.</source>
        <translation>Die Abtastrate %1 des Rezepts ersetzt die der Dateien, %2; Grund: %3.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos;: the recipe reads the numbers as %2, the file states %3, and no scale converts them: leave out the unit, or give the scale that belongs to it.</source>
        <translation>Kanal „%1“: Das Rezept liest die Zahlen als %2, die Datei nennt %3, und keine Skalierung rechnet sie um: Die Einheit weglassen oder die Skalierung angeben, die zu ihr gehört.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos;: the recipe reads the numbers as %2, with a factor of %4 in place of the file&apos;s %3.</source>
        <translation>Kanal „%1“: Das Rezept liest die Zahlen als %2, mit dem Faktor %4 anstelle von %3 der Datei.</translation>
    </message>
    <message>
        <source>Shot %1, channel &apos;%2&apos; is a pressure already (%3), so it cannot have a sensitivity; leave out the sensitivity or give its unit, e.g. V.</source>
        <translation>Schuss %1, Kanal „%2“ ist schon ein Druck (%3), daher kann er keine Empfindlichkeit haben; die Empfindlichkeit weglassen oder seine Einheit angeben, z. B. V.</translation>
    </message>
    <message>
        <source>Shot %1, channel &apos;%2&apos;: the unit &quot;%3&quot; is not known, so it cannot be divided by a sensitivity per pascal; the units known are V, mV, uV, kV, A, C, W and 1. Give one of them as the channel&apos;s unit, with the scale that it needs.</source>
        <translation>Schuss %1, Kanal „%2“: Die Einheit „%3“ ist nicht bekannt, daher kann nicht durch eine Empfindlichkeit je Pascal geteilt werden; bekannt sind V, mV, uV, kV, A, C, W und 1. Eine davon als Einheit des Kanals angeben, mit der Skalierung, die sie braucht.</translation>
    </message>
    <message>
        <source>Shot %1, %2: %3 invalid samples were interpolated.</source>
        <translation>Schuss %1, %2: %3 ungültige Abtastwerte wurden interpoliert.</translation>
    </message>
    <message>
        <source>%1 is no longer where it was opened: it was moved or removed, or its drive is gone. Put it back and read it again, or locate it; nothing is exported before.</source>
        <translation>%1 ist nicht mehr dort, wo sie geöffnet wurde: Sie wurde verschoben oder entfernt, oder ihr Laufwerk fehlt. Sie zurückstellen und neu lesen oder ihren Ort angeben; vorher wird nichts exportiert.</translation>
    </message>
    <message>
        <source>%1 was changed after it was opened, so what is shown may no longer be what it holds. Read it again; nothing is exported before.</source>
        <translation>%1 wurde nach dem Öffnen geändert, daher ist das Gezeigte vielleicht nicht mehr das, was sie enthält. Neu lesen; vorher wird nichts exportiert.</translation>
    </message>
    <message>
        <source>A file of the folder was left out. %M1</source>
        <translation>Eine Datei des Ordners wurde weggelassen. %M1</translation>
    </message>
    <message>
        <source>%1 of the inputs cannot be read:</source>
        <translation>%1 der Eingaben sind nicht lesbar:</translation>
    </message>
    <message>
        <source>No recording was found in the inputs; readable are: %1.</source>
        <translation>In den Eingaben wurde keine Aufzeichnung gefunden; lesbar sind: %1.</translation>
    </message>
    <message>
        <source>%1 could not be read, and there is not enough memory to tell whether the file is at fault; close other programs or raise the memory limit.</source>
        <translation>%1 konnte nicht gelesen werden, und der Speicher reicht nicht, um zu sagen, ob es an der Datei liegt; andere Programme schließen oder die Speichergrenze anheben.</translation>
    </message>
    <message>
        <source>%1 were taken as the channels of one recording, as name, time, rate and length agree. Set channel_files to &quot;apart&quot; in the recipe&apos;s import section if they are not.</source>
        <translation>%1 wurden als die Kanäle einer Aufzeichnung genommen, da Name, Zeit, Rate und Länge übereinstimmen. channel_files im Abschnitt import des Rezepts auf &quot;apart&quot; setzen, wenn sie es nicht sind.</translation>
    </message>
    <message>
        <source>%1 uses the comma as separator and as decimal mark, so its numbers cannot be told apart; save it again with tabs as separator.</source>
        <translation>%1 verwendet das Komma als Trennzeichen und als Dezimalzeichen, daher sind die Zahlen nicht zu unterscheiden; neu speichern, mit Tabulator als Trennzeichen.</translation>
    </message>
    <message>
        <source>%1 ends before its first row of samples, so it is likely an incomplete copy; copy it again.</source>
        <translation>%1 endet vor der ersten Zeile mit Abtastwerten, ist also wahrscheinlich eine unvollständige Kopie; neu kopieren.</translation>
    </message>
    <message>
        <source>%1 is no recording over time: its values lie along &quot;%2&quot; (X_Dimension, X_Unit_Label), and Time in s, ms, us or ns is needed.</source>
        <translation>%1 ist keine Aufzeichnung über der Zeit: Die Werte liegen entlang „%2“ (X_Dimension, X_Unit_Label), und Time in s, ms, us oder ns ist nötig.</translation>
    </message>
    <message>
        <source>%1, line %2: the line of column names does not have the channels that the header declares; the file is damaged.</source>
        <translation>%1, Zeile %2: Die Zeile der Spaltennamen hat nicht die Kanäle, die der Kopf nennt; die Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>%1: behind segment %2 a header without rows of samples follows, so the file is likely an incomplete copy.</source>
        <translation>%1: Hinter Segment %2 folgt ein Kopf ohne Zeilen mit Abtastwerten, daher ist die Datei wahrscheinlich eine unvollständige Kopie.</translation>
    </message>
    <message>
        <source>Reading %1 was cancelled.</source>
        <translation>Das Lesen von %1 wurde abgebrochen.</translation>
    </message>
    <message>
        <source>%1 claims %2 channels in all its segments, which is more than it can hold; the file is damaged.</source>
        <translation>%1 nennt %2 Kanäle in allen Segmenten, mehr als hineinpassen; die Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>%1 is no LabVIEW measurement file: it does not begin with &quot;LabVIEW Measurement&quot;.</source>
        <translation>%1 ist keine LabVIEW-Messdatei: Sie beginnt nicht mit &quot;LabVIEW Measurement&quot;.</translation>
    </message>
    <message>
        <source>%1: Delta_X of channel %2 is %3, but its X values are not uniform or step by %4 on average; state the sample rate in the recipe&apos;s import section if it is known.</source>
        <translation>%1: Delta_X von Kanal %2 ist %3, aber die X-Werte sind nicht gleichmäßig oder schreiten im Mittel um %4 fort; die Abtastrate im Abschnitt import des Rezepts angeben, falls sie bekannt ist.</translation>
    </message>
    <message>
        <source>%1: Delta_X of channel %2 is printed with so few digits that its sample rate of %3 is known to %4 % only, so it was not taken; state sample_rate_hz in the recipe&apos;s import section.</source>
        <translation>%1: Delta_X von Kanal %2 ist mit so wenigen Stellen geschrieben, dass seine Abtastrate von %3 nur auf %4 % bekannt ist, daher wurde sie nicht übernommen; sample_rate_hz im Abschnitt import des Rezepts angeben.</translation>
    </message>
    <message>
        <source>%1: the sample rate of channel %2, %3, is known to %4 % only, as Delta_X is printed with few digits; state sample_rate_hz in the recipe&apos;s import section if you know it better.</source>
        <translation>%1: Die Abtastrate von Kanal %2, %3, ist nur auf %4 % bekannt, da Delta_X mit wenigen Stellen geschrieben ist; sample_rate_hz im Abschnitt import des Rezepts angeben, falls sie besser bekannt ist.</translation>
    </message>
    <message>
        <source>%1: the header declares %2 channels, but %3 columns have names; the last ones were not read.</source>
        <translation>%1: Der Kopf nennt %2 Kanäle, aber %3 Spalten haben Namen; die letzten wurden nicht gelesen.</translation>
    </message>
    <message>
        <source>%1: %2 of %3 channels have no samples and were left out.</source>
        <translation>%1: %2 von %3 Kanälen haben keine Abtastwerte und wurden weggelassen.</translation>
    </message>
    <message>
        <source>%1: channel %2 has %3 samples where its header declares %4, so blocks were appended and are read as one record. If each is a shot of its own, save with one header per segment.</source>
        <translation>%1: Kanal %2 hat %3 Abtastwerte, wo der Kopf %4 nennt, also wurden Blöcke angehängt und als eine Aufzeichnung gelesen. Ist jeder ein eigener Schuss, mit einem Kopf je Segment speichern.</translation>
    </message>
    <message>
        <source>%1: channel %2 has %3 samples where its header declares %4; if it has fewer, the file may be an incomplete copy.</source>
        <translation>%1: Kanal %2 hat %3 Abtastwerte, wo der Kopf %4 nennt; sind es weniger, ist die Datei vielleicht eine unvollständige Kopie.</translation>
    </message>
    <message>
        <source>%1 ends within line %2, so it is likely an incomplete copy; that line was left out.</source>
        <translation>%1 endet innerhalb von Zeile %2, ist also wahrscheinlich eine unvollständige Kopie; diese Zeile wurde weggelassen.</translation>
    </message>
    <message>
        <source>%1 ends without a line end; if the copy is incomplete, the last number in line %2 may lack digits.</source>
        <translation>%1 endet ohne Zeilenende; ist die Kopie unvollständig, können der letzten Zahl in Zeile %2 Ziffern fehlen.</translation>
    </message>
    <message>
        <source>%1 is no recording over time: its first column, &quot;%2&quot;, holds frequencies. If it holds samples, say so under columns in the recipe&apos;s import section.</source>
        <translation>%1 ist keine Aufzeichnung über der Zeit: Die erste Spalte, „%2“, enthält Frequenzen. Enthält sie Abtastwerte, das unter columns im Abschnitt import des Rezepts sagen.</translation>
    </message>
    <message>
        <source>%1: line %2 of the header (&quot;%3&quot;) means %4, but line %5 (&quot;%6&quot;) means %7. Which one is right? State sample_rate_hz in the recipe&apos;s import section.</source>
        <translation>%1: Zeile %2 des Kopfs („%3“) bedeutet %4, aber Zeile %5 („%6“) bedeutet %7. Welche ist richtig? sample_rate_hz im Abschnitt import des Rezepts angeben.</translation>
    </message>
    <message>
        <source>%1: line %2 of the header (&quot;%3&quot;) means %4, but the column of times steps at %5. Which one is right? State sample_rate_hz in the recipe&apos;s import section; to go against the times, name only the columns of samples there, too.</source>
        <translation>%1: Zeile %2 des Kopfs („%3“) bedeutet %4, aber die Zeitspalte schreitet um %5 fort. Welche ist richtig? sample_rate_hz im Abschnitt import des Rezepts angeben; um gegen die Zeiten zu entscheiden, dort auch nur die Spalten der Abtastwerte nennen.</translation>
    </message>
    <message>
        <source>%1: the recipe states a sample rate of %2, but the column of times steps at %3. Which one is right? Take sample_rate_hz out of the recipe, or say in sample_rate_reason why the times are wrong.</source>
        <translation>%1: Das Rezept nennt eine Abtastrate von %2, aber die Zeitspalte schreitet um %3 fort. Welche ist richtig? sample_rate_hz aus dem Rezept nehmen oder in sample_rate_reason sagen, warum die Zeiten falsch sind.</translation>
    </message>
    <message>
        <source>%1: the stated sample rate is %2, but the times, which have no unit, step by %3: that fits neither in s nor in ms, us or ns. Correct the rate, or name only the columns of samples in the recipe&apos;s import section.</source>
        <translation>%1: Die angegebene Abtastrate ist %2, aber die Zeiten, die keine Einheit haben, schreiten um %3 fort: Das passt weder in s noch in ms, us oder ns. Die Rate berichtigen oder im Abschnitt import des Rezepts nur die Spalten der Abtastwerte nennen.</translation>
    </message>
    <message>
        <source>%1: column &quot;%2&quot; holds other times than column &quot;%3&quot;, and one shot has one sample rate. Save each with its samples in a file of its own, or name the columns of one of them, time included, in the recipe&apos;s import section.</source>
        <translation>%1: Spalte „%2“ enthält andere Zeiten als Spalte „%3“, und ein Schuss hat eine Abtastrate. Jede mit ihren Abtastwerten in einer eigenen Datei speichern oder im Abschnitt import des Rezepts die Spalten der einen nennen, die Zeit eingeschlossen.</translation>
    </message>
    <message>
        <source>%1: the times drift: line %2 is %3 steps off a straight line from the first time to the last (allowed is %4), so no one sample rate is that of all samples. Record anew, or name only the columns of samples and give the sample rate in the recipe&apos;s import section.</source>
        <translation>%1: Die Zeiten driften: Zeile %2 liegt %3 Schritte neben der Geraden von der ersten zur letzten Zeit (erlaubt sind %4), daher gilt keine einzelne Abtastrate für alle Abtastwerte. Neu aufzeichnen oder im Abschnitt import des Rezepts nur die Spalten der Abtastwerte nennen und die Abtastrate angeben.</translation>
    </message>
    <message>
        <source>%1: the times are not uniform: line %2 follows its predecessor by %3, others by %4 (allowed is 1 %). Record anew, or name only the columns of samples and give the sample rate in the recipe&apos;s import section.</source>
        <translation>%1: Die Zeiten sind nicht gleichmäßig: Zeile %2 folgt der vorigen um %3, andere um %4 (erlaubt ist 1 %). Neu aufzeichnen oder im Abschnitt import des Rezepts nur die Spalten der Abtastwerte nennen und die Abtastrate angeben.</translation>
    </message>
    <message>
        <source>%1: the unit &quot;%2&quot; of the column of times is unknown; write s, ms, us or ns.</source>
        <translation>%1: Die Einheit „%2“ der Zeitspalte ist unbekannt; s, ms, us oder ns schreiben.</translation>
    </message>
    <message>
        <source>%1: line %2 of the header (&quot;%3&quot;) means %4, but recipe and column of times agree on %5, which was taken.</source>
        <translation>%1: Zeile %2 des Kopfs („%3“) bedeutet %4, aber Rezept und Zeitspalte stimmen in %5 überein, was genommen wurde.</translation>
    </message>
    <message>
        <source>%1: line %2 of the header (&quot;%3&quot;) has no unit; in Hz or s it means %4, which was taken as the sample rate.</source>
        <translation>%1: Zeile %2 des Kopfs („%3“) hat keine Einheit; in Hz oder s bedeutet sie %4, was als Abtastrate genommen wurde.</translation>
    </message>
    <message>
        <source>%1: the recipe&apos;s sample rate of %2 was taken although the file&apos;s column of times steps at %3.</source>
        <translation>%1: Die Abtastrate %2 des Rezepts wurde genommen, obwohl die Zeitspalte der Datei um %3 fortschreitet.</translation>
    </message>
    <message>
        <source>%1: column &quot;%2&quot; only counts the rows, so the sample rate is unknown; state sample_rate_hz in the recipe&apos;s import section.</source>
        <translation>%1: Spalte „%2“ zählt nur die Zeilen, daher ist die Abtastrate unbekannt; sample_rate_hz im Abschnitt import des Rezepts angeben.</translation>
    </message>
    <message>
        <source>%1: column &quot;%2&quot; steps by %3 without a unit, so the sample rate is unknown; state sample_rate_hz in the recipe&apos;s import section.</source>
        <translation>%1: Spalte „%2“ schreitet ohne Einheit um %3 fort, daher ist die Abtastrate unbekannt; sample_rate_hz im Abschnitt import des Rezepts angeben.</translation>
    </message>
    <message>
        <source>%1: column &quot;%2&quot; has no unit; its numbers were taken as seconds, which makes the sample rate %3. If that is wrong, write the unit into the title.</source>
        <translation>%1: Spalte „%2“ hat keine Einheit; ihre Zahlen wurden als Sekunden genommen, was die Abtastrate %3 ergibt. Ist das falsch, die Einheit in den Titel schreiben.</translation>
    </message>
    <message>
        <source>%1: the recipe leaves the column of times out, but at line %2 it is not uniform; if samples are missing there, all behind them is shifted.</source>
        <translation>%1: Das Rezept lässt die Zeitspalte aus, aber in Zeile %2 ist sie nicht gleichmäßig; fehlen dort Abtastwerte, ist alles dahinter verschoben.</translation>
    </message>
    <message>
        <source>%1: column &quot;%2&quot; rises from row to row like times, but neither title nor unit says so; it was read as samples. If it holds times, name it time under columns in the recipe&apos;s import section.</source>
        <translation>%1: Spalte „%2“ steigt von Zeile zu Zeile wie Zeiten, aber weder Titel noch Einheit sagen das; sie wurde als Abtastwerte gelesen. Enthält sie Zeiten, sie unter columns im Abschnitt import des Rezepts time nennen.</translation>
    </message>
    <message>
        <source>%1: the header names %2 columns but the rows have %3 cells, so the comma seems to be both separator and decimal mark; export with another separator, or state separator and decimal in the recipe&apos;s import section.</source>
        <translation>%1: Der Kopf nennt %2 Spalten, aber die Zeilen haben %3 Zellen, das Komma scheint also Trennzeichen und Dezimalzeichen zu sein; mit anderem Trennzeichen exportieren oder separator und decimal im Abschnitt import des Rezepts angeben.</translation>
    </message>
    <message>
        <source>%1: line %2 is a row of %3 numbers like the data, but other text follows it; it was taken as header. Set skip_rows in the recipe&apos;s import section to be certain.</source>
        <translation>%1: Zeile %2 ist eine Zeile mit %3 Zahlen wie die Daten, aber anderer Text folgt; sie wurde als Kopf genommen. skip_rows im Abschnitt import des Rezepts setzen, um sicher zu sein.</translation>
    </message>
    <message>
        <source>%1: line %2 has %3 cells above %4 columns, so the columns are numbered, not named.</source>
        <translation>%1: Zeile %2 hat %3 Zellen über %4 Spalten, daher sind die Spalten nummeriert und nicht benannt.</translation>
    </message>
    <message>
        <source>%1 has no column %2 for %3; it has the columns 0 to %4. Change columns in the recipe&apos;s import section.</source>
        <translation>%1 hat keine Spalte %2 für %3; vorhanden sind die Spalten 0 bis %4. columns im Abschnitt import des Rezepts ändern.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; can be read in two ways; the comma was taken as %3. Set decimal and separator in the recipe&apos;s import section to be certain.</source>
        <translation>%1: „%2“ kann auf zwei Arten gelesen werden; das Komma wurde als %3 genommen. decimal und separator im Abschnitt import des Rezepts setzen, um sicher zu sein.</translation>
    </message>
    <message>
        <source>%1 begins like a header of %2 samples at %3, but has %4 lines, so it is likely an incomplete copy. Copy it again, or set skip_rows in the recipe&apos;s import section.</source>
        <translation>%1 beginnt wie ein Kopf von %2 Abtastwerten bei %3, hat aber %4 Zeilen, ist also wahrscheinlich eine unvollständige Kopie. Neu kopieren oder skip_rows im Abschnitt import des Rezepts setzen.</translation>
    </message>
    <message>
        <source>%1: the first %2 lines were taken as header, as they count the %3 lines behind: the sample rate is %4.</source>
        <translation>%1: Die ersten %2 Zeilen wurden als Kopf genommen, da sie die %3 Zeilen dahinter zählen: Die Abtastrate ist %4.</translation>
    </message>
    <message>
        <source>Channel %1 has no samples.</source>
        <translation>Kanal %1 hat keine Abtastwerte.</translation>
    </message>
    <message>
        <source>Channel %1 has values of the type %2, no samples.</source>
        <translation>Kanal %1 hat Werte des Typs %2, keine Abtastwerte.</translation>
    </message>
    <message>
        <source>Channel %1 is no recording over time: its values lie along &quot;%2&quot; (wf_xunit_string, wf_xname), and s, ms, us or ns is needed.</source>
        <translation>Kanal %1 ist keine Aufzeichnung über der Zeit: Seine Werte liegen entlang „%2“ (wf_xunit_string, wf_xname), und s, ms, us oder ns ist nötig.</translation>
    </message>
    <message>
        <source>%1: channel %2 holds counts of the converter and no scale; state scale and unit, or its values mean nothing.</source>
        <translation>%1: Kanal %2 enthält Zählwerte des Wandlers und keine Skalierung; Skalierung und Einheit angeben, sonst bedeuten seine Werte nichts.</translation>
    </message>
    <message>
        <source>%1: a channel was left out. %M1</source>
        <translation>%1: Ein Kanal wurde weggelassen. %M1</translation>
    </message>
    <message>
        <source>%1 has no channel that can be read. %M1</source>
        <translation>%1 hat keinen lesbaren Kanal. %M1</translation>
    </message>
    <message>
        <source>%1 holds no data; it is likely an incomplete copy or a recording that never began.</source>
        <translation>%1 enthält keine Daten; wahrscheinlich eine unvollständige Kopie oder eine Aufzeichnung, die nie begann.</translation>
    </message>
    <message>
        <source>%1 is of the TDMS version %2, which this program does not know; it was read like version 4713.</source>
        <translation>%1 hat die TDMS-Version %2, die dieses Programm nicht kennt; gelesen wurde wie Version 4713.</translation>
    </message>
    <message>
        <source>%M1 What stands before was read.</source>
        <translation>%M1 Was davor steht, wurde gelesen.</translation>
    </message>
    <message>
        <source>%1 was not closed by the program that wrote it, or its end is missing; all values that are there were read.</source>
        <translation>%1 wurde von dem Programm, das sie schrieb, nicht geschlossen, oder ihr Ende fehlt; alle vorhandenen Werte wurden gelesen.</translation>
    </message>
    <message>
        <source>%1 is incomplete: channel %2 has %3 of %4 samples. All values that are there were read; copy the file again if the original is whole.</source>
        <translation>%1 ist unvollständig: Kanal %2 hat %3 von %4 Abtastwerten. Alle vorhandenen Werte wurden gelesen; die Datei neu kopieren, wenn das Original vollständig ist.</translation>
    </message>
    <message>
        <source>%1: channel %2 states no time between samples (wf_increment); give import.sample_rate_hz in the recipe.</source>
        <translation>%1: Kanal %2 nennt keine Zeit zwischen den Abtastwerten (wf_increment); import.sample_rate_hz im Rezept angeben.</translation>
    </message>
    <message>
        <source>%1 says that its recording was not completed; check that the records are whole.</source>
        <translation>%1 sagt, dass die Aufzeichnung nicht abgeschlossen wurde; prüfen, ob die Aufzeichnungen vollständig sind.</translation>
    </message>
    <message>
        <source>%1: %2 groups with thinned-out copies of the records were left out.</source>
        <translation>%1: %2 Gruppen mit ausgedünnten Kopien der Aufzeichnungen wurden weggelassen.</translation>
    </message>
    <message>
        <source>%1: each of its %2 logged intervals was taken as a shot; exclude those that are none.</source>
        <translation>%1: Jedes der %2 aufgezeichneten Intervalle wurde als Schuss genommen; die ausschließen, die keine sind.</translation>
    </message>
    <message>
        <source>%1: the group &quot;%2&quot; was left out because its channels are not those of the other groups, of which each is a shot.</source>
        <translation>%1: Die Gruppe „%2“ wurde weggelassen, weil ihre Kanäle nicht die der anderen Gruppen sind, von denen jede ein Schuss ist.</translation>
    </message>
    <message>
        <source>%1: the sample rate is stated as %2, but %3 steps by %4, which fits it in no unit of time, so the rate is unknown. Which one is right? State it in the recipe&apos;s import section.</source>
        <translation>%1: Die Abtastrate ist als %2 angegeben, aber %3 schreitet um %4 fort, was in keiner Zeiteinheit dazu passt, daher ist die Rate unbekannt. Welche ist richtig? Sie im Abschnitt import des Rezepts angeben.</translation>
    </message>
    <message>
        <source>%1: the times in %2 are not uniform (allowed is 1 % of a step, and half a step in all), so the sample rate is unknown; state it in the recipe&apos;s import section if it is known.</source>
        <translation>%1: Die Zeiten in %2 sind nicht gleichmäßig (erlaubt sind 1 % eines Schritts und ein halber Schritt insgesamt), daher ist die Abtastrate unbekannt; sie im Abschnitt import des Rezepts angeben, falls sie bekannt ist.</translation>
    </message>
    <message>
        <source>%1: %2 has no unit and was taken as seconds, which makes the sample rate %3; state the rate in the recipe&apos;s import section if it is another.</source>
        <translation>%1: %2 hat keine Einheit und wurde als Sekunden gelesen, was die Abtastrate %3 ergibt; die Rate im Abschnitt import des Rezepts angeben, falls sie eine andere ist.</translation>
    </message>
    <message>
        <source>%1: %2 increases uniformly by %3 and was taken as the times, but its unit is said nowhere. State the sample rate in the recipe&apos;s import section: %4 if they are seconds, %5 if milliseconds, %6 if microseconds.</source>
        <translation>%1: %2 steigt gleichmäßig um %3 und wurde als die Zeiten genommen, aber die Einheit ist nirgends genannt. Die Abtastrate im Abschnitt import des Rezepts angeben: %4, wenn es Sekunden sind, %5 bei Millisekunden, %6 bei Mikrosekunden.</translation>
    </message>
    <message>
        <source>%1: %2 = %3 and %4 = %5 contradict each other (%6 and %7), so the sample rate is unknown; state it in the recipe&apos;s import section.</source>
        <translation>%1: %2 = %3 und %4 = %5 widersprechen einander (%6 und %7), daher ist die Abtastrate unbekannt; sie im Abschnitt import des Rezepts angeben.</translation>
    </message>
    <message>
        <source>%1: the times in %2 step by %3 and those in %4 by %5, which fits no sample rate in common, so it is unknown; state it in the recipe&apos;s import section.</source>
        <translation>%1: Die Zeiten in %2 schreiten um %3 fort und die in %4 um %5, was zu keiner gemeinsamen Abtastrate passt, daher ist sie unbekannt; sie im Abschnitt import des Rezepts angeben.</translation>
    </message>
    <message>
        <source>%1 was written as a stream without its length; it was read up to its end (%2 samples per channel), which nothing confirms.</source>
        <translation>%1 wurde als Strom ohne Länge geschrieben; gelesen wurde bis zum Ende (%2 Abtastwerte je Kanal), was nichts bestätigt.</translation>
    </message>
    <message>
        <source>%1 ends after %2 of the %3 samples per channel that it declares, or within one; it is likely an incomplete copy.</source>
        <translation>%1 endet nach %2 der %3 angekündigten Abtastwerte je Kanal, oder innerhalb eines davon; es ist wahrscheinlich eine unvollständige Kopie.</translation>
    </message>
    <message>
        <source>%1 states %2 samples per second, but its bytes per second mean %3; state the sample rate in the recipe&apos;s import section if it is known.</source>
        <translation>%1 nennt %2 Abtastwerte je Sekunde, aber die Bytes je Sekunde bedeuten %3; die Abtastrate im Abschnitt import des Rezepts angeben, falls sie bekannt ist.</translation>
    </message>
    <message>
        <source>%1 describes samples that are in %2, which cannot be opened; put both files into one folder.</source>
        <translation>%1 beschreibt Abtastwerte in %2, die sich nicht öffnen lässt; beide Dateien in einen Ordner legen.</translation>
    </message>
    <message>
        <source>%2 does not hold the samples that %1 describes; copy both files again, from the same recording.</source>
        <translation>%2 enthält nicht die Abtastwerte, die %1 beschreibt; beide Dateien neu kopieren, aus derselben Aufzeichnung.</translation>
    </message>
    <message>
        <source>%1 states a sampling interval of %2 s, but a record from end to end that means %3 s, so the rate is unknown; state it in the recipe&apos;s import section.</source>
        <translation>%1 nennt ein Abtastintervall von %2 s, aber Anfang und Ende der Aufzeichnung bedeuten %3 s, daher ist die Rate unbekannt; sie im Abschnitt import des Rezepts angeben.</translation>
    </message>
    <message>
        <source>%1 holds only the samples of a Rohde &amp; Schwarz recording; open %2, which describes them.</source>
        <translation>%1 enthält nur die Abtastwerte einer Aufzeichnung von Rohde &amp; Schwarz; %2 öffnen, die sie beschreibt.</translation>
    </message>
    <message>
        <source>%1: %2 states scale and offset in two ways that differ; correct the attributes.</source>
        <translation>%1: %2 nennt Skalierung und Versatz auf zwei Arten, die sich unterscheiden; die Attribute berichtigen.</translation>
    </message>
    <message>
        <source>%1: scale, offset or poly of channel %2 is not a number; without it the counts have no unit.</source>
        <translation>%1: Skalierung, Versatz oder Polynom von Kanal %2 ist keine Zahl; ohne sie haben die Zählwerte keine Einheit.</translation>
    </message>
    <message>
        <source>%1: %2 marks missing samples by the value %3; such samples are read as they are, so look whether there are any.</source>
        <translation>%1: %2 kennzeichnet fehlende Abtastwerte durch den Wert %3; solche Abtastwerte werden gelesen, wie sie sind; nachsehen, ob es welche gibt.</translation>
    </message>
    <message>
        <source>%1 is an HDF5 file without a dataset of samples (one-dimensional numbers, or a table of at most 64 columns).</source>
        <translation>%1 ist eine HDF5-Datei ohne Datensatz von Abtastwerten (eindimensionale Zahlen oder eine Tabelle mit höchstens 64 Spalten).</translation>
    </message>
    <message>
        <source>%1 holds times, but no samples that belong to them (%2); if one of these is a record, name it in import.channels.</source>
        <translation>%1 enthält Zeiten, aber keine Abtastwerte, die zu ihnen gehören (%2); ist eines davon eine Aufzeichnung, sie in import.channels nennen.</translation>
    </message>
    <message>
        <source>%1 has none of the datasets that import.channels names; it has %2.</source>
        <translation>%1 hat keinen der Datensätze, die import.channels nennt; vorhanden sind %2.</translation>
    </message>
    <message>
        <source>%1: %2 is of another length or kind than the channels and was left out; name the channels to have it.</source>
        <translation>%1: %2 hat eine andere Länge oder Art als die Kanäle und wurde weggelassen; die Kanäle nennen, um es zu haben.</translation>
    </message>
    <message>
        <source>%1: %2 links that lead to other files or places, or cannot be opened, were not followed.</source>
        <translation>%1: %2 Verweise, die zu anderen Dateien oder Orten führen oder sich nicht öffnen lassen, wurden nicht verfolgt.</translation>
    </message>
    <message>
        <source>%1: %2 has the sample rate stated twice, as %3 and as %4; give the right one.</source>
        <translation>%1: Für %2 ist die Abtastrate zweimal angegeben, als %3 und als %4; die richtige angeben.</translation>
    </message>
    <message>
        <source>%1: the times in %2 do not rise by equal steps, so the sample rate of %3 is unknown; state it, or resample the record.</source>
        <translation>%1: Die Zeiten in %2 steigen nicht in gleichen Schritten, daher ist die Abtastrate von %3 unbekannt; sie angeben oder die Aufzeichnung umrechnen.</translation>
    </message>
    <message>
        <source>%1: %2 states %3, but the times in %4 give %5; give the right sample rate.</source>
        <translation>%1: %2 nennt %3, aber die Zeiten in %4 ergeben %5; die richtige Abtastrate angeben.</translation>
    </message>
    <message>
        <source>%1 is part of a structure or a cell.</source>
        <translation>%1 ist Teil einer Struktur oder einer Zelle.</translation>
    </message>
    <message>
        <source>%1 (%2) is no full matrix of real numbers.</source>
        <translation>%1 (%2) ist keine vollständige Matrix reeller Zahlen.</translation>
    </message>
    <message>
        <source>%1: %2 is no matrix of numbers (a structure, cell, text or the like) and was left out.</source>
        <translation>%1: %2 ist keine Matrix von Zahlen (eine Struktur, Zelle, Text oder Ähnliches) und wurde weggelassen.</translation>
    </message>
    <message>
        <source>%1 changed since it was written: what it says of channel &apos;%2&apos; of shot %3 is not what was recorded. The results are of the changed capture and cannot be certified; take an unchanged copy.</source>
        <translation>%1 wurde geändert, seit sie geschrieben wurde: Was sie über Kanal „%2“ von Schuss %3 sagt, ist nicht das Aufgezeichnete. Die Ergebnisse sind die der geänderten Aufzeichnung und können nicht bescheinigt werden; eine unveränderte Kopie nehmen.</translation>
    </message>
    <message>
        <source>%1 changed since it was written: what it says of shot %2 (%3) is not what was recorded. The results are of the changed capture and cannot be certified; take an unchanged copy.</source>
        <translation>%1 wurde geändert, seit sie geschrieben wurde: Was sie über Schuss %2 sagt (%3), ist nicht das Aufgezeichnete. Die Ergebnisse sind die der geänderten Aufzeichnung und können nicht bescheinigt werden; eine unveränderte Kopie nehmen.</translation>
    </message>
    <message>
        <source>%1 changed since it was written: what it says in %2 is not what was recorded. The results are of the changed capture and cannot be certified; take an unchanged copy.</source>
        <translation>%1 wurde geändert, seit sie geschrieben wurde: Was sie in %2 sagt, ist nicht das Aufgezeichnete. Die Ergebnisse sind die der geänderten Aufzeichnung und können nicht bescheinigt werden; eine unveränderte Kopie nehmen.</translation>
    </message>
    <message>
        <source>%1 changed since it was written: the hashes it states of itself contradict each other, so that nothing in it can be certified; take an unchanged copy.</source>
        <translation>%1 wurde geändert, seit sie geschrieben wurde: Die Prüfsummen, die sie über sich selbst nennt, widersprechen einander, sodass nichts darin bescheinigt werden kann; eine unveränderte Kopie nehmen.</translation>
    </message>
    <message>
        <source>%1 changed since it was written in %2 further places; take an unchanged copy.</source>
        <translation>%1 wurde an %2 weiteren Stellen geändert, seit sie geschrieben wurde; eine unveränderte Kopie nehmen.</translation>
    </message>
    <message>
        <source>%1 is damaged: it states the hashes of a capture, but its attribute format does not say that it is one; take an unchanged copy.</source>
        <translation>%1 ist beschädigt: Sie nennt die Prüfsummen einer Aufzeichnung, aber ihr Attribut format sagt nicht, dass sie eine ist; eine unveränderte Kopie nehmen.</translation>
    </message>
    <message>
        <source>%1 is an HDF5 file but no capture: its root lacks the attribute format = &quot;dyncal-capture&quot;. Export the recording as LVM or CSV, or write it in the capture layout.</source>
        <translation>%1 ist eine HDF5-Datei, aber keine Aufzeichnung: In ihrer Wurzel fehlt das Attribut format = &quot;dyncal-capture&quot;. Die Aufzeichnung als LVM oder CSV exportieren oder in der Form einer Aufzeichnung schreiben.</translation>
    </message>
    <message>
        <source>%1 has capture layout version %2; this program reads version 1. Use a newer version of the program.</source>
        <translation>%1 hat die Version %2 der Aufzeichnungsform; dieses Programm liest Version 1. Eine neuere Version des Programms verwenden.</translation>
    </message>
    <message>
        <source>%1 was written by a newer version (capture layout 1.%2); what this version does not know was left out.</source>
        <translation>%1 wurde von einer neueren Version geschrieben (Aufzeichnungsform 1.%2); was diese Version nicht kennt, wurde weggelassen.</translation>
    </message>
    <message>
        <source>%1 holds no shots; a capture has at least one group in /shots.</source>
        <translation>%1 enthält keine Schüsse; eine Aufzeichnung hat mindestens eine Gruppe in /shots.</translation>
    </message>
    <message>
        <source>%1: shot %2 cannot be opened; the file is damaged, or its shots lie in other files.</source>
        <translation>%1: Schuss %2 lässt sich nicht öffnen; die Datei ist beschädigt, oder ihre Schüsse liegen in anderen Dateien.</translation>
    </message>
    <message>
        <source>%1: shot %2 has no channels of its own; a shot holds its samples in its group channels.</source>
        <translation>%1: Schuss %2 hat keine eigenen Kanäle; ein Schuss hält seine Abtastwerte in seiner Gruppe channels.</translation>
    </message>
    <message>
        <source>%1: %2 has more than 1024 attributes, which no capture has; the file is damaged.</source>
        <translation>%1: %2 hat mehr als 1024 Attribute, was keine Aufzeichnung hat; die Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>%1: channel %2 is no dataset of samples.</source>
        <translation>%1: Kanal %2 ist kein Datensatz von Abtastwerten.</translation>
    </message>
    <message>
        <source>%1: the samples of channel %2 are stored in a type for which the SHA-256 in the file was not checked.</source>
        <translation>%1: Die Abtastwerte von Kanal %2 sind in einem Typ gespeichert, für den der SHA-256 in der Datei nicht geprüft wurde.</translation>
    </message>
    <message>
        <source>%1 states no sample rate and has no column of times; give the sample rate.</source>
        <translation>%1 nennt keine Abtastrate und hat keine Zeitspalte; die Abtastrate angeben.</translation>
    </message>
    <message>
        <source>%1 is a LabVIEW measurement, which says itself how it is to be read; import it as lvm.</source>
        <translation>%1 ist eine LabVIEW-Messung, die selbst sagt, wie sie zu lesen ist; als lvm einlesen.</translation>
    </message>
    <message>
        <source>%1 states a sampling interval of %2 s for channel %3, which cannot be; state the sample rate in the recipe&apos;s import section if it is known.</source>
        <translation>%1 nennt ein Abtastintervall von %2 s für Kanal %3, was nicht sein kann; die Abtastrate im Abschnitt import des Rezepts angeben, falls sie bekannt ist.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; was left out, because it is no sampled signal (%3).</source>
        <translation>%1: „%2“ wurde weggelassen, weil es kein abgetastetes Signal ist (%3).</translation>
    </message>
    <message>
        <source>%1 ends before its first sample, so it is likely an incomplete copy; copy it again.</source>
        <translation>%1 endet vor dem ersten Abtastwert, ist also wahrscheinlich eine unvollständige Kopie; neu kopieren.</translation>
    </message>
    <message>
        <source>%1 ends after %3 of the %4 samples of channel %2 that its header declares, so it is likely an incomplete copy; copy it again.</source>
        <translation>%1 endet nach %3 der %4 Abtastwerte von Kanal %2, die der Kopf nennt, ist also wahrscheinlich eine unvollständige Kopie; neu kopieren.</translation>
    </message>
    <message>
        <source>%1 is damaged: its header states %2 as %3, which cannot be; copy the file again.</source>
        <translation>%1 ist beschädigt: Der Kopf nennt %2 als %3, was nicht sein kann; die Datei neu kopieren.</translation>
    </message>
    <message>
        <source>%1 is a recording of kind %2, which this version does not read; save it as CSV.</source>
        <translation>%1 ist eine Aufzeichnung der Art %2, die diese Version nicht liest; als CSV speichern.</translation>
    </message>
    <message>
        <source>%1 holds nothing that is a sampled signal; save the recorded channel itself.</source>
        <translation>%1 enthält nichts, was ein abgetastetes Signal ist; den aufgezeichneten Kanal selbst speichern.</translation>
    </message>
    <message>
        <source>The quantity %1 = %2 has a standard uncertainty of %3 with %4 degrees of freedom; the first two must be finite, the uncertainty 0 or above, the degrees above 0.</source>
        <translation>Die Größe %1 = %2 hat eine Standardunsicherheit von %3 mit %4 Freiheitsgraden; die ersten beiden müssen endlich sein, die Unsicherheit 0 oder darüber, die Freiheitsgrade über 0.</translation>
    </message>
    <message>
        <source>The quantity %1 is there twice in an uncertainty budget; join the two contributions to one.</source>
        <translation>Die Größe %1 steht zweimal in einem Unsicherheitsbudget; die beiden Beiträge zu einem zusammenfassen.</translation>
    </message>
    <message>
        <source>Monte Carlo with %1 trials; it must be 0 (adaptive) or between %2 and %3.</source>
        <translation>Monte Carlo mit %1 Versuchen; es muss 0 (adaptiv) sein oder zwischen %2 und %3 liegen.</translation>
    </message>
    <message>
        <source>The coverage probability is %1; it must lie between 0 and 1.</source>
        <translation>Die Überdeckungswahrscheinlichkeit ist %1; sie muss zwischen 0 und 1 liegen.</translation>
    </message>
    <message>
        <source>The result is not a finite number.</source>
        <translation>Das Ergebnis ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>Monte Carlo: %1 of %2 trials leave the range of the relations (%M1); the stated uncertainties are too large for the value.</source>
        <translation>Monte Carlo: %1 von %2 Versuchen verlassen den Gültigkeitsbereich der Beziehungen (%M1); die angegebenen Unsicherheiten sind für den Wert zu groß.</translation>
    </message>
    <message>
        <source>Not evaluated where the state follows from a pressure.</source>
        <translation>Nicht ausgewertet, wo der Zustand aus einem Druck folgt.</translation>
    </message>
    <message>
        <source>There is not enough memory to draw the certificate and the plots, and nothing was written; close other programs or raise the memory limit.</source>
        <translation>Der Speicher reicht nicht, um den Kalibrierschein und die Diagramme zu zeichnen, und nichts wurde geschrieben; schließen Sie andere Programme oder erhöhen Sie die Speichergrenze.</translation>
    </message>
    <message>
        <source>Earlier calibrations</source>
        <translation>Frühere Kalibrierungen</translation>
    </message>
    <message>
        <source>When the certificate is issued, the laboratory&apos;s certificates of this sensor that are in force are stated here.</source>
        <translation>Bei der Ausstellung werden hier die gültigen Kalibrierscheine des Laboratoriums für diesen Aufnehmer angegeben.</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innerhalb</translation>
    </message>
    <message>
        <source>beyond the warning limits</source>
        <translation>außerhalb der Warngrenzen</translation>
    </message>
    <message>
        <source>beyond the action limits</source>
        <translation>außerhalb der Eingriffsgrenzen</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Kalibrierschein</translation>
    </message>
    <message>
        <source>Control chart</source>
        <translation>Regelkarte</translation>
    </message>
    <message>
        <source>%M1: it drifts by %M2, more than its U.</source>
        <translation>%M1: Drift von %M2, mehr als ihr U.</translation>
    </message>
    <message>
        <source>%M1: the drift of %M2 is within its U.</source>
        <translation>%M1: die Drift von %M2 liegt innerhalb ihres U.</translation>
    </message>
    <message>
        <source>Magnitude at %1</source>
        <translation>Betrag bei %1</translation>
    </message>
    <message>
        <source>Phase at %1</source>
        <translation>Phase bei %1</translation>
    </message>
    <message>
        <source>What the laboratory&apos;s certificates of this sensor state that are in force, this one last. En compares a value with the one before: up to 1 they agree within their U. Control limits need five calibrations.</source>
        <translation>Was die gültigen Kalibrierscheine des Laboratoriums für diesen Aufnehmer angeben, dieser zuletzt. En vergleicht einen Wert mit dem vorhergehenden: bis 1 stimmen sie innerhalb ihrer U überein. Regelgrenzen erfordern fünf Kalibrierungen.</translation>
    </message>
    <message>
        <source>Calibrations of one laboratory share tube, references and method: what they share is in every U and cancels in the difference, so that En is smaller than it would be for independent results.</source>
        <translation>Kalibrierungen eines Laboratoriums teilen Rohr, Referenzen und Verfahren: das Gemeinsame steckt in jedem U und hebt sich in der Differenz auf, sodass En kleiner ist als bei unabhängigen Ergebnissen.</translation>
    </message>
    <message>
        <source>* outside the scope: the laboratory states no calibration and measurement capability (CMC) at this frequency.</source>
        <translation>* außerhalb des Geltungsbereichs: Das Laboratorium gibt bei dieser Frequenz keine Kalibrier- und Messmöglichkeit (CMC) an.</translation>
    </message>
    <message>
        <source>%1 values of S(f), from %2 to %3, lie outside the frequencies that the laboratory states a capability (CMC) for; the certificate marks them as outside the scope.</source>
        <translation>%1 Werte von S(f), von %2 bis %3, liegen außerhalb der Frequenzen, für die das Laboratorium eine Messfähigkeit (CMC) angibt; der Kalibrierschein kennzeichnet sie als außerhalb des Geltungsbereichs.</translation>
    </message>
    <message>
        <source>Pressure sensor</source>
        <translation>Druckaufnehmer</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Shot, 0 where it is of all</source>
        <translation>Schuss, 0 wo es alle betrifft</translation>
    </message>
    <message>
        <source>Standard uncertainty</source>
        <translation>Standardmessunsicherheit</translation>
    </message>
    <message>
        <source>Contribution</source>
        <translation>Beitrag</translation>
    </message>
    <message>
        <source>Share of the variance</source>
        <translation>Anteil an der Varianz</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Freiheitsgrade</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>Key in results.json</source>
        <translation>Schlüssel in results.json</translation>
    </message>
    <message>
        <source>Both propagations agree: 1, or 0</source>
        <translation>Beide Fortpflanzungen stimmen überein: 1, sonst 0</translation>
    </message>
    <message>
        <source>Values by Monte Carlo, with their intervals</source>
        <translation>Werte nach Monte Carlo, mit ihren Intervallen</translation>
    </message>
    <message>
        <source>Budget of the uncertainty</source>
        <translation>Messunsicherheitsbudget</translation>
    </message>
    <message>
        <source>Effective degrees of freedom</source>
        <translation>Effektive Freiheitsgrade</translation>
    </message>
    <message>
        <source>Reported values, not rounded</source>
        <translation>Angegebene Werte, nicht gerundet</translation>
    </message>
    <message>
        <source>Complex response</source>
        <translation>Komplexer Frequenzgang</translation>
    </message>
    <message>
        <source>Of %1 rows %2 are withheld and have no value (NaN).</source>
        <translation>Von %1 Zeilen werden %2 zurückgehalten und haben keinen Wert (NaN).</translation>
    </message>
    <message>
        <source>Frequency response as complex numbers, not rounded</source>
        <translation>Frequenzgang als komplexe Zahlen, nicht gerundet</translation>
    </message>
    <message>
        <source>The same at the limits of the band, its edges and the resonance</source>
        <translation>Dasselbe an den Grenzen des Bandes, seinen Kanten und der Resonanz</translation>
    </message>
    <message>
        <source>Frequency response against the reference transducer, not rounded</source>
        <translation>Frequenzgang gegen den Referenzaufnehmer, nicht gerundet</translation>
    </message>
    <message>
        <source>Evaluation of the uncertainty</source>
        <translation>Ermittlung der Messunsicherheit</translation>
    </message>
    <message>
        <source>Versions of the methods, stage by stage</source>
        <translation>Versionen der Verfahren, Schritt für Schritt</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Calibration certificate</source>
        <translation>Kalibrierschein</translation>
    </message>
    <message>
        <source>Least</source>
        <translation>Kleinster Wert</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größter Wert</translation>
    </message>
    <message>
        <source>This is a draft and no certificate: it has no number, and what it says may change.</source>
        <translation>Dies ist ein Entwurf und kein Kalibrierschein: Er hat keine Nummer, und sein Inhalt kann sich ändern.</translation>
    </message>
    <message>
        <source>Not stated yet; what stands in its place says nothing:</source>
        <translation>Noch nicht angegeben; was an seiner Stelle steht, besagt nichts:</translation>
    </message>
    <message>
        <source>No interval until the next calibration is recommended.</source>
        <translation>Ein Intervall bis zur nächsten Kalibrierung wird nicht empfohlen.</translation>
    </message>
    <message>
        <source>Largest deviation allowed</source>
        <translation>Größte zulässige Abweichung</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Probability of lying beyond the limit</source>
        <translation>Wahrscheinlichkeit, außerhalb der Grenze zu liegen</translation>
    </message>
    <message>
        <source>The unit &apos;%1&apos; is none that a certificate can be read in; one such as V/Pa, pC/Pa or 1 is needed.</source>
        <translation>Die Einheit „%1“ ist keine, in der ein Kalibrierschein gelesen werden kann; eine wie V/Pa, pC/Pa oder 1 wird benötigt.</translation>
    </message>
    <message>
        <source>This certificate for machines (DCC)</source>
        <translation>Dieser Kalibrierschein für Maschinen (DCC)</translation>
    </message>
    <message>
        <source>All results, unrounded, with their budgets</source>
        <translation>Alle Ergebnisse, ungerundet, mit ihren Budgets</translation>
    </message>
    <message>
        <source>Every decision of the evaluation</source>
        <translation>Jede Entscheidung der Auswertung</translation>
    </message>
    <message>
        <source>issued, with an electronic signature in this file</source>
        <translation>ausgestellt, mit elektronischer Signatur in dieser Datei</translation>
    </message>
    <message>
        <source>issued as an amendment, with an electronic signature in this file</source>
        <translation>ausgestellt als Änderung, mit elektronischer Signatur in dieser Datei</translation>
    </message>
    <message>
        <source>Sensitivity coefficient</source>
        <translation>Empfindlichkeitskoeffizient</translation>
    </message>
    <message>
        <source>%1, shot %2</source>
        <translation>%1, Schuss %2</translation>
    </message>
    <message>
        <source>The budgets of the single frequencies are left out, because there are more than %1.</source>
        <translation>Die Budgets der einzelnen Frequenzen sind weggelassen, weil es mehr als %1 sind.</translation>
    </message>
    <message>
        <source>Budgets of the frequency response</source>
        <translation>Messunsicherheitsbudgets des Frequenzgangs</translation>
    </message>
    <message>
        <source>Budgets of the frequency response against the reference transducer</source>
        <translation>Messunsicherheitsbudgets des Frequenzgangs gegen den Referenzaufnehmer</translation>
    </message>
    <message>
        <source>Electronic signature</source>
        <translation>Elektronische Signatur</translation>
    </message>
    <message>
        <source>When the certificate is issued, who signs it, when, and its number are stated here.</source>
        <translation>Wenn der Kalibrierschein ausgestellt wird, steht hier, wer ihn signiert, wann, und seine Nummer.</translation>
    </message>
    <message>
        <source>This certificate was issued without an electronic signature.</source>
        <translation>Dieser Kalibrierschein wurde ohne elektronische Signatur ausgestellt.</translation>
    </message>
    <message>
        <source>a service that signs for the laboratory; its name is in the signature</source>
        <translation>ein Dienst, der für das Laboratorium signiert; sein Name steht in der Signatur</translation>
    </message>
    <message>
        <source>Signed by</source>
        <translation>Signiert von</translation>
    </message>
    <message>
        <source>Signed at (UTC)</source>
        <translation>Signiert (UTC)</translation>
    </message>
    <message>
        <source>Number of the certificate</source>
        <translation>Nummer des Kalibrierscheins</translation>
    </message>
    <message>
        <source>No pressure step is determined, as the laboratory chose not to evaluate the shock wave. No sensitivity in the unit of pressure can be stated.</source>
        <translation>Kein Drucksprung ist bestimmt, da das Laboratorium die Stoßwelle nicht auswerten wollte. Es kann keine Empfindlichkeit in der Einheit des Drucks angegeben werden.</translation>
    </message>
    <message>
        <source>Relative humidity</source>
        <translation>Relative Feuchte</translation>
    </message>
    <message>
        <source>Least favourable frequency</source>
        <translation>Ungünstigste Frequenz</translation>
    </message>
    <message>
        <source>No statement of conformity could be made; the section of that name has the reason.</source>
        <translation>Eine Konformitätsaussage konnte nicht getroffen werden; der Grund steht im Abschnitt dieses Namens.</translation>
    </message>
    <message>
        <source>A statement of conformity is made in a section of its own.</source>
        <translation>Eine Konformitätsaussage wird in einem eigenen Abschnitt getroffen.</translation>
    </message>
    <message>
        <source>The results are traceable to the International System of Units (SI) through the reference standards that are listed with their certificates in the section &quot;Method&quot;.</source>
        <translation>Die Ergebnisse sind über die im Abschnitt „Verfahren“ mit ihren Kalibrierscheinen genannten Bezugsnormale auf das Internationale Einheitensystem (SI) rückgeführt.</translation>
    </message>
    <message>
        <source>%1 trials: both agree for %2 of %3 values and rows</source>
        <translation>%1 Versuche: Beide stimmen für %2 von %3 Werten und Zeilen überein</translation>
    </message>
    <message>
        <source>%1 trials: both agree for %2 of %3 values and rows; the draws of the model agree with %4 full refits</source>
        <translation>%1 Versuche: Beide stimmen für %2 von %3 Werten und Zeilen überein; die Ziehungen des Modells stimmen mit %4 vollständigen Neuanpassungen überein</translation>
    </message>
    <message>
        <source>Comparison of GUM and Monte Carlo (JCGM 101)</source>
        <translation>Vergleich von GUM und Monte Carlo (JCGM 101)</translation>
    </message>
    <message>
        <source>Results whose interval of %1 % by Monte Carlo reaches beyond the one that U gives; it is the one to use</source>
        <translation>Ergebnisse, deren %1-%-Intervall nach Monte Carlo über das hinausreicht, das U ergibt; es ist das zu verwendende</translation>
    </message>
    <message>
        <source>Lower end</source>
        <translation>Unteres Ende</translation>
    </message>
    <message>
        <source>Upper end</source>
        <translation>Oberes Ende</translation>
    </message>
    <message>
        <source>%1 %; in this noise the true model would reach %2 % on average</source>
        <translation>%1 %; bei diesem Rauschen würde das wahre Modell im Mittel %2 % erreichen</translation>
    </message>
    <message>
        <source>Uncertainties marked U (k = 2) are expanded uncertainties with the coverage factor k = 2, or with the larger one printed beside them, for a coverage probability of about 95 % (GUM, JCGM 100). Those of the sensitivity contain the pressure step, the shots, the noise, gain, linearity and mounting; those of the frequency response also the end of the records, the sampling, the front and a drift; those of frequencies and times the noise and the sample clock, and where they or an overshoot depend on the height of the ringing the front and the mounting. What was not stated counts with the usual range: gain 0.5 %, linearity and mounting 0.1 %, clock 50 ppm, a front of up to 100 ns. The budget of every value is in results.json. A value without an uncertainty beside it has none that is complete: it is no result, and has three significant digits; settings and readings are quoted with four at most, temperatures with five. Rise time, overshoot, settling time and band edges are those of the model, as far as records and model reach.</source>
        <translation>Mit U (k = 2) bezeichnete Unsicherheiten sind erweiterte Messunsicherheiten mit dem Erweiterungsfaktor k = 2, oder mit dem größeren, der daneben steht, für eine Überdeckungswahrscheinlichkeit von etwa 95 % (GUM, JCGM 100). Die der Empfindlichkeit enthalten den Drucksprung, die Schüsse, das Rauschen, Verstärkung, Linearität und Einbau; die des Frequenzgangs außerdem das Ende der Aufzeichnungen, die Abtastung, die Front und eine Drift; die von Frequenzen und Zeiten das Rauschen und den Abtasttakt und, wo sie oder ein Überschwingen von der Höhe der Schwingung abhängen, die Front und den Einbau. Für nicht angegebene Größen gilt die übliche Spanne: Verstärkung 0,5 %, Linearität und Einbau 0,1 %, Takt 50 ppm, eine Front von bis zu 100 ns. Das Budget jedes Werts steht in results.json. Ein Wert ohne Unsicherheit daneben hat keine vollständige: Er ist kein Ergebnis und hat drei signifikante Stellen; Einstellungen und Ablesungen stehen mit höchstens vier, Temperaturen mit fünf. Anstiegszeit, Überschwingen, Einschwingzeit und Bandkanten sind die des Modells, soweit Aufzeichnungen und Modell reichen.</translation>
    </message>
    <message>
        <source>Uncertainties marked U (k = 2) are expanded uncertainties with the coverage factor k = 2, or with the larger one printed beside them, for a coverage probability of about 95 % (GUM, JCGM 100). Those of the sensitivity contain the reference transducer&apos;s certificate, its chain and its level, the shots, the noise, gain, linearity and mounting; those of the frequency response also the noise of the reference, the end of the records, the sampling, a drift and, in the phase, the delay between the two; those of frequencies and times the noise and the sample clock, and where they or an overshoot depend on the height of the ringing the front and the mounting. What was not stated counts with the usual range: gain of either chain 0.5 %, linearity and mounting 0.1 %, clock 50 ppm, a delay of up to 0.5 µs. The budget of every value is in results.json. A value without an uncertainty beside it has none that is complete: it is no result, and has three significant digits; settings and readings are quoted with four at most, temperatures with five. Rise time, overshoot, settling time and band edges are those of the model, as far as records and model reach.</source>
        <translation>Mit U (k = 2) bezeichnete Unsicherheiten sind erweiterte Messunsicherheiten mit dem Erweiterungsfaktor k = 2, oder mit dem größeren, der daneben steht, für eine Überdeckungswahrscheinlichkeit von etwa 95 % (GUM, JCGM 100). Die der Empfindlichkeit enthalten den Kalibrierschein des Referenzaufnehmers, seine Messkette und seinen Pegel, die Schüsse, das Rauschen, Verstärkung, Linearität und Einbau; die des Frequenzgangs außerdem das Rauschen der Referenz, das Ende der Aufzeichnungen, die Abtastung, eine Drift und, in der Phase, die Verzögerung zwischen beiden; die von Frequenzen und Zeiten das Rauschen und den Abtasttakt und, wo sie oder ein Überschwingen von der Höhe der Schwingung abhängen, die Front und den Einbau. Für nicht angegebene Größen gilt die übliche Spanne: Verstärkung jeder der beiden Messketten 0,5 %, Linearität und Einbau 0,1 %, Takt 50 ppm, eine Verzögerung von bis zu 0,5 µs. Das Budget jedes Werts steht in results.json. Ein Wert ohne Unsicherheit daneben hat keine vollständige: Er ist kein Ergebnis und hat drei signifikante Stellen; Einstellungen und Ablesungen stehen mit höchstens vier, Temperaturen mit fünf. Anstiegszeit, Überschwingen, Einschwingzeit und Bandkanten sind die des Modells, soweit Aufzeichnungen und Modell reichen.</translation>
    </message>
    <message>
        <source>Uncertainties marked U (k = 2) are expanded uncertainties with the coverage factor k = 2, or with the larger one printed beside them, for a coverage probability of about 95 % (GUM, JCGM 100). Those of the frequency response contain the noise of the recordings and of the level, the end of the records, the sampling, the front and a drift; those of frequencies and times the noise and the sample clock, and where they or an overshoot depend on the height of the ringing the front and the mounting. What was not stated counts with the usual range: mounting 0.1 %, clock 50 ppm, a front of up to 100 ns. The budget of every value is in results.json. A value without an uncertainty beside it has none that is complete: it is no result, and has three significant digits; settings and readings are quoted with four at most, temperatures with five. Rise time, overshoot, settling time and band edges are those of the model, as far as records and model reach.</source>
        <translation>Mit U (k = 2) bezeichnete Unsicherheiten sind erweiterte Messunsicherheiten mit dem Erweiterungsfaktor k = 2, oder mit dem größeren, der daneben steht, für eine Überdeckungswahrscheinlichkeit von etwa 95 % (GUM, JCGM 100). Die des Frequenzgangs enthalten das Rauschen der Aufzeichnungen und des Pegels, das Ende der Aufzeichnungen, die Abtastung, die Front und eine Drift; die von Frequenzen und Zeiten das Rauschen und den Abtasttakt und, wo sie oder ein Überschwingen von der Höhe der Schwingung abhängen, die Front und den Einbau. Für nicht angegebene Größen gilt die übliche Spanne: Einbau 0,1 %, Takt 50 ppm, eine Front von bis zu 100 ns. Das Budget jedes Werts steht in results.json. Ein Wert ohne Unsicherheit daneben hat keine vollständige: Er ist kein Ergebnis und hat drei signifikante Stellen; Einstellungen und Ablesungen stehen mit höchstens vier, Temperaturen mit fünf. Anstiegszeit, Überschwingen, Einschwingzeit und Bandkanten sind die des Modells, soweit Aufzeichnungen und Modell reichen.</translation>
    </message>
    <message>
        <source>Uncertainties marked U (k = 2) are expanded uncertainties with the coverage factor k = 2, or with the larger one printed beside them, for a coverage probability of about 95 % (GUM, JCGM 100). They contain the noise of the recordings and, of frequencies, the sample clock, which counts with 50 ppm unless it was stated. A value without an uncertainty beside it has none that is complete: it is no result, and has three significant digits; settings and readings are quoted with four at most, temperatures with five.</source>
        <translation>Mit U (k = 2) bezeichnete Unsicherheiten sind erweiterte Messunsicherheiten mit dem Erweiterungsfaktor k = 2, oder mit dem größeren, der daneben steht, für eine Überdeckungswahrscheinlichkeit von etwa 95 % (GUM, JCGM 100). Sie enthalten das Rauschen der Aufzeichnungen und, bei Frequenzen, den Abtasttakt, der mit 50 ppm zählt, wenn er nicht angegeben wurde. Ein Wert ohne Unsicherheit daneben hat keine vollständige: Er ist kein Ergebnis und hat drei signifikante Stellen; Einstellungen und Ablesungen stehen mit höchstens vier, Temperaturen mit fünf.</translation>
    </message>
    <message>
        <source>Signal to noise is the output step over the standard deviation of the noise before it. Rise time 10 % to 90 %; settling to within 5 % of the step; a dash where the record does not show it. These are read from single records, whose noise raises overshoot and settling time; those of the sensor are the key results. Values without an uncertainty have none that is known: they have three significant digits.</source>
        <translation>Der Rauschabstand ist der Sprung am Ausgang, bezogen auf die Standardabweichung des Rauschens davor. Anstiegszeit 10 % bis 90 %; Einschwingen auf 5 % des Sprungs; ein Strich, wo die Aufzeichnung sie nicht zeigt. Diese Werte sind aus einzelnen Aufzeichnungen abgelesen, deren Rauschen Überschwingen und Einschwingzeit erhöht; die des Aufnehmers stehen unter den Hauptergebnissen. Werte ohne Unsicherheit haben keine, die bekannt wäre: Sie haben drei signifikante Stellen.</translation>
    </message>
    <message>
        <source>%M1: %L1 from %L2 on</source>
        <translation>%M1: %L1 ab %L2</translation>
    </message>
    <message>
        <source>%M1: %L1 up to %L2</source>
        <translation>%M1: %L1 bis %L2</translation>
    </message>
    <message>
        <source>%M1: %L1 from %L2 to %L3</source>
        <translation>%M1: %L1 von %L2 bis %L3</translation>
    </message>
    <message>
        <source>%M1: certificate %V1</source>
        <translation>%M1: Kalibrierschein %V1</translation>
    </message>
    <message>
        <source>%M1: certificate %V1, which ended on %2, before the measurement</source>
        <translation>%M1: Kalibrierschein %V1, der am %2 endete, vor der Messung</translation>
    </message>
    <message>
        <source>%M1: certificate %V1, valid until %2</source>
        <translation>%M1: Kalibrierschein %V1, gültig bis %2</translation>
    </message>
    <message>
        <source>Reference standard</source>
        <translation>Bezugsnormal</translation>
    </message>
    <message>
        <source>Magnitude of the frequency response</source>
        <translation>Betrag des Frequenzgangs</translation>
    </message>
    <message>
        <source>Phase of the frequency response</source>
        <translation>Phase des Frequenzgangs</translation>
    </message>
    <message>
        <source>initial pressure</source>
        <translation>Anfangsdruck</translation>
    </message>
    <message>
        <source>initial temperature</source>
        <translation>Anfangstemperatur</translation>
    </message>
    <message>
        <source>ratio of the specific heats</source>
        <translation>Verhältnis der spezifischen Wärmekapazitäten</translation>
    </message>
    <message>
        <source>molar mass of the gas</source>
        <translation>molare Masse des Gases</translation>
    </message>
    <message>
        <source>relative humidity</source>
        <translation>relative Feuchte</translation>
    </message>
    <message>
        <source>share of carbon dioxide</source>
        <translation>Anteil von Kohlendioxid</translation>
    </message>
    <message>
        <source>shock velocity</source>
        <translation>Geschwindigkeit der Stoßwelle</translation>
    </message>
    <message>
        <source>distance along the tube</source>
        <translation>Abstand längs des Rohrs</translation>
    </message>
    <message>
        <source>time of arrival</source>
        <translation>Ankunftszeit</translation>
    </message>
    <message>
        <source>delay of a sensor</source>
        <translation>Verzögerung eines Aufnehmers</translation>
    </message>
    <message>
        <source>pressure step, as a ratio</source>
        <translation>Drucksprung, relativ</translation>
    </message>
    <message>
        <source>gain of the measuring chain</source>
        <translation>Verstärkung der Messkette</translation>
    </message>
    <message>
        <source>linearity of the measuring chain</source>
        <translation>Linearität der Messkette</translation>
    </message>
    <message>
        <source>mounting</source>
        <translation>Einbau</translation>
    </message>
    <message>
        <source>sample clock</source>
        <translation>Abtasttakt</translation>
    </message>
    <message>
        <source>gain of the reference&apos;s chain</source>
        <translation>Verstärkung der Messkette der Referenz</translation>
    </message>
    <message>
        <source>An uncertainty at %1 Hz is 0, which counts as unknown; that of each magnitude and of each phase must be stated, above 0.</source>
        <translation>Eine Unsicherheit bei %1 Hz ist 0, was als unbekannt gilt; die jedes Betrags und jeder Phase muss angegeben sein, über 0.</translation>
    </message>
    <message>
        <source>The certificate has another list (line %1) that is not understood and may be the response; name the one that is meant by its id in quantity_id.</source>
        <translation>Der Kalibrierschein hat eine weitere Liste (Zeile %1), die nicht verstanden wird und der Frequenzgang sein kann; die gemeinte durch ihre id in quantity_id nennen.</translation>
    </message>
    <message>
        <source>comparison.model has an uncertainty of 0, which counts as unknown; u_sensitivity, u_f0_hz and u_zeta must be stated, above 0.</source>
        <translation>comparison.model hat eine Unsicherheit von 0, was als unbekannt gilt; u_sensitivity, u_f0_hz und u_zeta müssen angegeben sein, über 0.</translation>
    </message>
    <message>
        <source>Poles and zeros of the model in the z-plane; poles: %1, zeros: %2</source>
        <translation>Pole und Nullstellen des Modells in der z-Ebene; Pole: %1, Nullstellen: %2</translation>
    </message>
    <message>
        <source>Poles and zeros of the model in the z-plane; poles: %1, zeros: %2; further out than shown: %3</source>
        <translation>Pole und Nullstellen des Modells in der z-Ebene; Pole: %1, Nullstellen: %2; weiter außen als gezeigt: %3</translation>
    </message>
    <message>
        <source>Frequency response, phase; measured: from the pressure at the reference transducer, model: from the item&apos;s own onset</source>
        <translation>Frequenzgang, Phase; gemessen: ab dem Druck am Referenzaufnehmer, Modell: ab dem eigenen Einsatz des Kalibriergegenstands</translation>
    </message>
    <message>
        <source>The phase without a model counts from the pressure at the reference transducer, that of the model from the item&apos;s own onset: the two may differ in proportion to the frequency.</source>
        <translation>Die Phase ohne Modell zählt ab dem Druck am Referenzaufnehmer, die des Modells ab dem eigenen Einsatz des Kalibriergegenstands: Beide können sich proportional zur Frequenz unterscheiden.</translation>
    </message>
    <message>
        <source>captures</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>expected shock</source>
        <translation>erwartete Stoßwelle</translation>
    </message>
    <message>
        <source>window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>components</source>
        <translation>Komponenten</translation>
    </message>
    <message>
        <source>model input</source>
        <translation>Eingang des Modells</translation>
    </message>
    <message>
        <source>decomposition</source>
        <translation>Zerlegung</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>shock</source>
        <translation>Stoßwelle</translation>
    </message>
    <message>
        <source>reference transducer</source>
        <translation>Referenzaufnehmer</translation>
    </message>
    <message>
        <source>response</source>
        <translation>Frequenzgang</translation>
    </message>
    <message>
        <source>checks</source>
        <translation>Vergleiche</translation>
    </message>
    <message>
        <source>model assessment</source>
        <translation>Beurteilung des Modells</translation>
    </message>
    <message>
        <source>uncertainty</source>
        <translation>Unsicherheit</translation>
    </message>
    <message>
        <source>comparison</source>
        <translation>Vergleichskalibrierung</translation>
    </message>
    <message>
        <source>evidence</source>
        <translation>Belege zur Ordnung</translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation>Monte Carlo</translation>
    </message>
    <message>
        <source>Monte Carlo of the chain</source>
        <translation>Monte Carlo der Kette</translation>
    </message>
    <message>
        <source>Shot %1: the level of the reference transducer %2 moves by +-%3 % of its step over a band that is to be level; its step, and so the sensitivity, is wrong by as much or more. Look for a drift of its zero, an amplifier that lets no constant pressure through, or heat.</source>
        <translation>Schuss %1: Der Pegel des Referenzaufnehmers %2 bewegt sich um ±%3 % seines Sprungs über einem Bereich, der eben sein soll; sein Sprung und damit die Empfindlichkeit ist um mindestens so viel falsch. Zu suchen ist ein wandernder Nullpunkt, ein Verstärker, der keinen konstanten Druck durchlässt, oder Wärme.</translation>
    </message>
    <message>
        <source>Shot %1: the step of the reference transducer %2 is negative (%3), so that the phase is turned by 180 degrees; set its polarity to -1 if it is inverted.</source>
        <translation>Schuss %1: Der Sprung des Referenzaufnehmers %2 ist negativ (%3), sodass die Phase um 180 Grad gedreht ist; seine Polarität ist auf -1 zu setzen, wenn er invertiert ist.</translation>
    </message>
    <message>
        <source>Shot %1: %2 samples in a row of the reference transducer %3 are equal and the extreme of the window; its record may be saturated there.</source>
        <translation>Schuss %1: %2 Abtastwerte des Referenzaufnehmers %3 in Folge sind gleich und das Extrem des Fensters; seine Aufzeichnung kann dort gesättigt sein.</translation>
    </message>
    <message>
        <source>Shot %1: before its start the record is not quiet: %2 before it, it moves by %3 % of the step (standard deviation), elsewhere by %4 %. What moves it is likely in the response, too, and may be taken for the sensor&apos;s own: a wave in the wall of the tube, a disturbance, or a record that begins behind its step.</source>
        <translation>Schuss %1: Vor seinem Beginn ist die Aufzeichnung nicht in Ruhe: %2 davor bewegt sie sich um %3 % des Sprungs (Standardabweichung), sonst um %4 %. Was sie bewegt, ist wahrscheinlich auch in der Antwort und kann für Eigenes des Aufnehmers gehalten werden: eine Welle in der Rohrwand, eine Störung oder eine Aufzeichnung, die nach ihrem Sprung beginnt.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: each value stands %3 times in a row, so the record was measured at %4 and written at %5; S(f), band edges and rise time have the repetition in them. Export it at the rate at which it was measured.</source>
        <translation>Schuss %1, Kanal %2: Jeder Wert steht %3-mal hintereinander, die Aufzeichnung wurde also mit %4 gemessen und mit %5 geschrieben; S(f), Bandgrenzen und Anstiegszeit enthalten die Wiederholung. Exportieren Sie sie mit der Rate, mit der sie gemessen wurde.</translation>
    </message>
    <message>
        <source>Shot %1, channel %2: between every %3 samples the others lie on straight lines, so the record was measured at %4 and written at %5; S(f), band edges and rise time have the interpolation in them. Export it at the rate at which it was measured.</source>
        <translation>Schuss %1, Kanal %2: Zwischen je %3 Abtastwerten liegen die übrigen auf Geraden, die Aufzeichnung wurde also mit %4 gemessen und mit %5 geschrieben; S(f), Bandgrenzen und Anstiegszeit enthalten die Interpolation. Exportieren Sie sie mit der Rate, mit der sie gemessen wurde.</translation>
    </message>
    <message>
        <source>The phase against the reference transducer differs from that of the sensor&apos;s own model as by a delay of %1 (U = %2, k = 2): the step seems to reach the transducer %3 after the sensor, and comparison.delay_s states %4. Check its sign and value, and the phases of the transducer.</source>
        <translation>Die Phase gegen den Referenzaufnehmer weicht von der des eigenen Modells des Aufnehmers ab wie durch eine Verzögerung von %1 (U = %2, k = 2): Der Sprung scheint den Referenzaufnehmer %3 nach dem Aufnehmer zu erreichen, und comparison.delay_s nennt %4. Prüfen Sie Vorzeichen und Wert sowie die Phasen des Referenzaufnehmers.</translation>
    </message>
    <message>
        <source>Channel &apos;%1&apos;: the file states no unit, so its numbers are read as %2, as the name ends. Give the channel&apos;s unit if they are something else.</source>
        <translation>Kanal &apos;%1&apos;: Die Datei nennt keine Einheit, daher werden die Zahlen als %2 gelesen, wie der Name endet. Geben Sie die Einheit des Kanals an, wenn es etwas anderes ist.</translation>
    </message>
    <message>
        <source>The file of %1 ends at %2, and the sensor is flat up to %3: less than a tenth of that is stated. Check that its frequencies are in Hz, or give a file that covers the band.</source>
        <translation>Die Datei von %1 endet bei %2, und der Aufnehmer ist bis %3 eben: Weniger als ein Zehntel davon ist angegeben. Prüfen Sie, ob ihre Frequenzen in Hz sind, oder geben Sie eine Datei an, die das Band abdeckt.</translation>
    </message>
    <message>
        <source>The file of %1 states a chain that is off by %2 % at %3, where the records show chain and sensor together within 10 % of flat (up to %4): S(f) would be off by what the file says. Check that its frequencies are in Hz and its magnitudes those of this chain.</source>
        <translation>Die Datei von %1 nennt eine Messkette, die bei %3 um %2 % abweicht, wo die Aufzeichnungen Kette und Aufnehmer zusammen innerhalb von 10 % eben zeigen (bis %4): S(f) wäre um das falsch, was die Datei sagt. Prüfen Sie, ob ihre Frequenzen in Hz und ihre Beträge die dieser Kette sind.</translation>
    </message>
    <message>
        <source>The drift of %1 % behind the step dies out twice as fast as the sensor rings (time constant %2): a sensor or an amplifier whose gain depends on the level makes that of its own ringing, and then the sensitivity, S(f) and overshoot are wrong by up to as much. Compare shots of different levels, or with the static sensitivity.</source>
        <translation>Die Drift von %1 % nach dem Sprung klingt doppelt so schnell ab wie der Aufnehmer schwingt (Zeitkonstante %2): Ein Aufnehmer oder Verstärker, dessen Verstärkung vom Pegel abhängt, macht das aus seinem eigenen Schwingen, und dann sind Empfindlichkeit, S(f) und Überschwingen um bis zu ebenso viel falsch. Vergleichen Sie Schüsse verschiedener Pegel, oder mit der statischen Empfindlichkeit.</translation>
    </message>
    <message>
        <source>p1 = %1 is typed, and the capture has recorded %2 in this shot: with that the pressure step would be %3 % different. The typed one is used; correct it, or leave it out (shock.p1_pa).</source>
        <translation>p1 = %1 ist eingetippt, und die Datei hat in diesem Schuss %2 aufgezeichnet: Damit wäre der Drucksprung um %3 % anders. Der eingetippte Wert gilt; berichtigen Sie ihn oder lassen Sie ihn weg (shock.p1_pa).</translation>
    </message>
    <message>
        <source>T1 = %1 is typed, and the capture has recorded %2 in this shot: with that the pressure step would be %3 % different. The typed one is used; correct it, or leave it out (shock.t1_k).</source>
        <translation>T1 = %1 ist eingetippt, und die Datei hat in diesem Schuss %2 aufgezeichnet: Damit wäre der Drucksprung um %3 % anders. Der eingetippte Wert gilt; berichtigen Sie ihn oder lassen Sie ihn weg (shock.t1_k).</translation>
    </message>
    <message>
        <source>Shot %1: before its start the record lies %2 % of the step away from the baseline that it is counted from; the step and the sensitivity are wrong by as much. Let the baseline be found, or place it just before the start.</source>
        <translation>Schuss %1: Vor ihrem Beginn liegt die Aufzeichnung %2 % des Sprungs von der Grundlinie entfernt, von der aus sie gezählt wird; Sprung und Empfindlichkeit sind um ebenso viel falsch. Lassen Sie die Grundlinie suchen, oder legen Sie sie kurz vor den Beginn.</translation>
    </message>
    <message>
        <source>Shot %1: at the typed start the record has left its baseline by %2 % of the step already: the response began before. Move the start, or let it be found.</source>
        <translation>Schuss %1: Am eingetippten Beginn hat die Aufzeichnung ihre Grundlinie schon um %2 % des Sprungs verlassen: Die Antwort begann vorher. Verschieben Sie den Beginn, oder lassen Sie ihn suchen.</translation>
    </message>
    <message>
        <source>The records begin as those of a second-order sensor (%1, damping %2) behind a pressure that rises over %3 (u = %4), and no front is stated: state its duration, or look for a faster part of sensor and amplifier.</source>
        <translation>Die Aufzeichnungen beginnen wie die eines Aufnehmers zweiter Ordnung (%1, Dämpfung %2) hinter einem Druck, der über %3 (u = %4) ansteigt, und keine Front ist angegeben: ihre Dauer angeben oder nach einem schnelleren Teil von Aufnehmer und Verstärker suchen.</translation>
    </message>
    <message>
        <source>Without the first %1 of the records the main resonance has %2 % of frequency and %3 % of damping more, beyond what noise allows: the excitation lasts into them, as a hammer&apos;s contact does (leave that stretch out), or a faster part is missing in the model.</source>
        <translation>Ohne die ersten %1 der Aufzeichnungen hat die Hauptresonanz %2 % mehr Frequenz und %3 % mehr Dämpfung, über das hinaus, was das Rauschen erlaubt: Die Anregung dauert bis in sie hinein, wie die Berührung eines Hammers (diesen Abschnitt auslassen), oder ein schnellerer Teil fehlt im Modell.</translation>
    </message>
    <message>
        <source>With p1 = %1 the shock implies a driver pressure of %2, a fifth or less of the %3 that are stated (all absolute): p1 is a gauge pressure or in another unit, or the driver gas is another; the step goes with p1.</source>
        <translation>Mit p1 = %1 verlangt der Stoß einen Treiberdruck von %2, höchstens ein Fünftel der angegebenen %3 (alle absolut): p1 ist ein Überdruck oder in einer anderen Einheit, oder das Treibergas ist ein anderes; der Sprung geht mit p1.</translation>
    </message>
    <message>
        <source>The resonance at %1 has no uncertainty, because the model was not refined: without it no resonance is a result. Take another order, or leave out of the window what is no free decay.</source>
        <translation>Die Resonanz bei %1 hat keine Unsicherheit, weil das Modell nicht verfeinert wurde: Ohne sie ist keine Resonanz ein Ergebnis. Eine andere Ordnung nehmen oder aus dem Fenster lassen, was kein freies Abklingen ist.</translation>
    </message>
    <message>
        <source>%M1 at %1</source>
        <translation>%M1 bei %1</translation>
    </message>
    <message>
        <source>%M1: Monte Carlo gives U = %1, the law of propagation only %2: use Monte Carlo. The law gives too little for %3 of %4 values and rows; their intervals by Monte Carlo are in monte_carlo of results.json.</source>
        <translation>%M1: Monte Carlo ergibt U = %1, das Fortpflanzungsgesetz nur %2: Monte Carlo verwenden. Das Gesetz gibt für %3 von %4 Werten und Zeilen zu wenig; ihre Intervalle nach Monte Carlo stehen in monte_carlo von results.json.</translation>
    </message>
    <message>
        <source>%M1: Monte Carlo gives U = %1, the law of propagation only %2, for a front of any duration up to 100 ns; it is so for %3 of %4 values and rows. Nobody has stated how long the front lasts: state shock.front_duration_s, or take these intervals from monte_carlo of results.json.</source>
        <translation>%M1: Monte Carlo ergibt U = %1, das Fortpflanzungsgesetz nur %2, für eine Front beliebiger Dauer bis 100 ns; so ist es bei %3 von %4 Werten und Zeilen. Niemand hat angegeben, wie lange die Front dauert: shock.front_duration_s angeben oder diese Intervalle aus monte_carlo von results.json nehmen.</translation>
    </message>
    <message>
        <source>%M1: Monte Carlo gives U = %1, the law of propagation %2. The law gives more than is needed for %3 of %4 values and rows: what is stated is safe, Monte Carlo would state less.</source>
        <translation>%M1: Monte Carlo ergibt U = %1, das Fortpflanzungsgesetz %2. Das Gesetz gibt für %3 von %4 Werten und Zeilen mehr als nötig: Das Angegebene ist sicher, Monte Carlo würde weniger angeben.</translation>
    </message>
    <message>
        <source>%M1: %1 refits of simulated records are %2 times as uncertain as the model&apos;s covariance has it, and %3 of that u apart: the stated uncertainties of the model&apos;s values do not hold. Choose a lower order, or record with less noise.</source>
        <translation>%M1: %1 Neuanpassungen simulierter Aufzeichnungen sind das %2-Fache so unsicher, wie die Kovarianz des Modells es hat, und um das %3-Fache dieses u entfernt: Die angegebenen Unsicherheiten der Werte des Modells gelten nicht. Eine niedrigere Ordnung wählen oder mit weniger Rauschen aufzeichnen.</translation>
    </message>
    <message>
        <source>attenuation along the tube</source>
        <translation>Dämpfung entlang des Rohrs</translation>
    </message>
    <message>
        <source>noise of the level</source>
        <translation>Rauschen des Pegels</translation>
    </message>
    <message>
        <source>scatter of the shots</source>
        <translation>Streuung der Schüsse</translation>
    </message>
    <message>
        <source>scatter of the velocity</source>
        <translation>Streuung der Geschwindigkeit</translation>
    </message>
    <message>
        <source>response of the measuring chain</source>
        <translation>Frequenzgang der Messkette</translation>
    </message>
    <message>
        <source>certificate of the reference transducer</source>
        <translation>Kalibrierschein des Referenzaufnehmers</translation>
    </message>
    <message>
        <source>%1 % of the variance of the sensitivity come from one source, %M1: to know it better is what makes the uncertainty smaller.</source>
        <translation>%1 % der Varianz der Empfindlichkeit kommen aus einer Quelle, %M1: Sie besser zu kennen, verkleinert die Unsicherheit.</translation>
    </message>
    <message>
        <source>Shot %1: the record takes %2 from the typed start to a quarter of the step and just %3 from there to the half, so the response begins later; the model takes the quiet stretch for a part of it. Move the start, or let it be found.</source>
        <translation>Schuss %1: Vom eingetippten Beginn bis zu einem Viertel des Sprungs braucht die Aufzeichnung %2 und von dort bis zur Hälfte nur %3, also beginnt die Antwort später; das Modell nimmt das ruhige Stück für einen Teil von ihr. Verschieben Sie den Beginn, oder lassen Sie ihn suchen.</translation>
    </message>
    <message>
        <source>what the mounting may add to the level decides it</source>
        <translation>was der Einbau zum Pegel beitragen kann, entscheidet darüber</translation>
    </message>
    <message>
        <source>The calibration of the reference transducer begins at %1, and the level of the step lies below %2: its sensitivity may be another there by %3 %, as its rows show, which is in the uncertainty. Have it calibrated down to %2, or state the transducer as a model.</source>
        <translation>Die Kalibrierung des Referenzaufnehmers beginnt bei %1, und der Pegel des Sprungs liegt unter %2: Dort kann seine Empfindlichkeit um %3 % anders sein, wie seine Zeilen zeigen, was in der Unsicherheit enthalten ist. Lassen Sie ihn bis %2 hinab kalibrieren, oder geben Sie den Aufnehmer als Modell an.</translation>
    </message>
    <message>
        <source>The calibration of the reference transducer is one row at %1, and the level of the step lies below %2: what its sensitivity is there is not known, so the step has no uncertainty. Have it calibrated down to %2, or state the transducer as a model.</source>
        <translation>Die Kalibrierung des Referenzaufnehmers ist eine Zeile bei %1, und der Pegel des Sprungs liegt unter %2: Was seine Empfindlichkeit dort ist, ist nicht bekannt, also hat der Sprung keine Unsicherheit. Lassen Sie ihn bis %2 hinab kalibrieren, oder geben Sie den Aufnehmer als Modell an.</translation>
    </message>
    <message>
        <source>What the uncertainty of the sensitivity is made of</source>
        <translation>Woraus die Unsicherheit der Empfindlichkeit besteht</translation>
    </message>
    <message>
        <source>Contribution (k = 1)</source>
        <translation>Beitrag (k = 1)</translation>
    </message>
    <message>
        <source>all others together</source>
        <translation>alle übrigen zusammen</translation>
    </message>
    <message>
        <source>U of the step is its expanded uncertainty with the coverage factor k of the same line, for a coverage probability of about %1 %: that of the reference transducer&apos;s certificate, its chain and the noise of its level. It is contained in the uncertainty of the sensitivity.</source>
        <translation>U des Sprungs ist seine erweiterte Messunsicherheit mit dem Erweiterungsfaktor k derselben Zeile, für eine Überdeckungswahrscheinlichkeit von etwa %1 %: die des Kalibrierscheins des Referenzaufnehmers, seiner Messkette und des Rauschens seines Pegels. Sie ist in der Unsicherheit der Empfindlichkeit enthalten.</translation>
    </message>
    <message>
        <source>U of the step is its expanded uncertainty with the coverage factor k of the same line, for a coverage probability of about %1 %. It follows from the uncertainties of the shock velocity, the initial pressure and temperature and the gas, and holds for an ideal shock tube. It is contained in the uncertainties of the sensitivity and of the magnitudes of the frequency response.</source>
        <translation>U des Sprungs ist seine erweiterte Messunsicherheit mit dem Erweiterungsfaktor k derselben Zeile, für eine Überdeckungswahrscheinlichkeit von etwa %1 %. Sie folgt aus den Unsicherheiten der Geschwindigkeit der Stoßwelle, des Anfangsdrucks, der Anfangstemperatur und des Gases und gilt für ein ideales Stoßrohr. Sie ist in den Unsicherheiten der Empfindlichkeit und der Beträge des Frequenzgangs enthalten.</translation>
    </message>
    <message>
        <source>The initial pressure is absolute: the item was under it before the step.</source>
        <translation>Der Anfangsdruck ist absolut: Der Gegenstand stand vor dem Sprung unter ihm.</translation>
    </message>
    <message>
        <source>Gas before the item</source>
        <translation>Gas vor dem Gegenstand</translation>
    </message>
    <message>
        <source>%V1, ratio of specific heats %L2, molar mass %L3</source>
        <translation>%V1, Verhältnis der spezifischen Wärmen %L2, molare Masse %L3</translation>
    </message>
    <message>
        <source>one over the length of the shortest window</source>
        <translation>eins durch die Länge des kürzesten Fensters</translation>
    </message>
    <message>
        <source>where the noise begins to exceed 10 % of the magnitude</source>
        <translation>wo das Rauschen 10 % des Betrags zu überschreiten beginnt</translation>
    </message>
    <message>
        <source>0.4 of the lowest sample rate</source>
        <translation>0,4 der niedrigsten Abtastrate</translation>
    </message>
    <message>
        <source>half the sample rate of the model</source>
        <translation>die halbe Abtastrate des Modells</translation>
    </message>
    <message>
        <source>where the calibration of the reference transducer ends</source>
        <translation>wo die Kalibrierung des Referenzaufnehmers endet</translation>
    </message>
    <message>
        <source>where the stated response of amplifier and converter ends</source>
        <translation>wo der angegebene Frequenzgang von Verstärker und Wandler endet</translation>
    </message>
    <message>
        <source>The lower limit of the band is %M1, the upper limit %M2.</source>
        <translation>Die untere Grenze des Bands ist %M1, die obere %M2.</translation>
    </message>
    <message>
        <source>Frequencies are settings, without an uncertainty. The model&apos;s values have the digits of the wider of their uncertainty and the measured value&apos;s; they end at half the sample rate of the model. A dash means that the value, or its complete uncertainty, was not determined.</source>
        <translation>Frequenzen sind Einstellungen ohne Unsicherheit. Die Werte des Modells haben die Stellen der größeren aus ihrer Unsicherheit und der des gemessenen Werts; sie enden bei der halben Abtastrate des Modells. Ein Strich bedeutet, dass der Wert oder seine vollständige Unsicherheit nicht bestimmt wurde.</translation>
    </message>
    <message>
        <source>U = k u is the expanded uncertainty, u the complete standard uncertainty, for a coverage probability of about 95 % (GUM, JCGM 100). What it is made of stands in the section &quot;Results in detail&quot;.</source>
        <translation>U = k u ist die erweiterte Messunsicherheit, u die vollständige Standardunsicherheit, für eine Überdeckungswahrscheinlichkeit von etwa 95 % (GUM, JCGM 100). Woraus sie besteht, steht im Abschnitt „Ergebnisse im Einzelnen“.</translation>
    </message>
    <message>
        <source>Of those quantities whose interval by Monte Carlo stands in the section &quot;Results in detail&quot;, that interval is the one to use: it reaches beyond U to one side.</source>
        <translation>Für die Größen, deren Intervall nach Monte Carlo im Abschnitt „Ergebnisse im Einzelnen“ steht, ist dieses Intervall zu verwenden: Es reicht nach einer Seite über U hinaus.</translation>
    </message>
    <message>
        <source>not divided out: frequency response, poles and what follows from them are of sensor and chain together</source>
        <translation>nicht herausgeteilt: Frequenzgang, Pole und was aus ihnen folgt, sind die von Aufnehmer und Kette zusammen</translation>
    </message>
</context>
</TS>
