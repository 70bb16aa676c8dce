//! Detection of report headings in languages other than English.
//!
//! CAD programs write headings in the language of their user interface. Only English headings are
//! supported. Other languages are detected by words that do not occur in English reports.

/// Languages, with their headings of mass properties in SolidWorks, Creo, Inventor, NX and CATIA.
const LANGUAGES: [(&str, &str); 13] = [
    (
        "German",
        "masse, masseneigenschaften, massenschwerpunkt, schwerpunkt, trägheitsmoment, \
         trägheitstensor, trägheitshauptachsen, hauptträgheit, dichte, volumen, oberfläche, \
         massenträgheit",
    ),
    (
        "French",
        "masse, propriétés de masse, centre de masse, centre de gravité, moments d'inertie, \
         moments d’inertie, tenseur d'inertie, masse volumique, densité, axes principaux, \
         superficie",
    ),
    (
        "Spanish",
        "masa, propiedades de masa, propiedades físicas, centro de masa, centro de gravedad, \
         momentos de inercia, tensor de inercia, densidad, volumen, área de superficie",
    ),
    (
        "Italian",
        "massa, proprietà di massa, centro di massa, baricentro, momenti di inerzia, \
         momenti d'inerzia, tensore di inerzia, densità, area superficiale",
    ),
    (
        "Portuguese",
        "massa, propriedades de massa, centro de massa, centro de gravidade, \
         momentos de inércia, tensor de inércia, densidade, área de superfície",
    ),
    (
        "Dutch",
        "massa, massa-eigenschappen, massamiddelpunt, zwaartepunt, traagheidsmoment, \
         dichtheid",
    ),
    ("Polish", "masa, środek masy, środek ciężkości, momenty bezwładności, gęstość, objętość"),
    ("Czech", "hmotnost, těžiště, momenty setrvačnosti, hustota, objem"),
    ("Russian", "масса, центр масс, центр тяжести, моменты инерции, плотность, объем, объём"),
    ("Turkish", "kütle, ağırlık merkezi, kütle merkezi, atalet moment, yoğunluk, hacim"),
    ("Korean", "질량, 무게 중심, 관성 모멘트, 관성모멘트, 밀도, 부피"),
    ("Japanese", "質量, 重心, 慣性モーメント, 慣性テンソル, 慣性主軸, 密度, 体積, 表面積, 質量特性"),
    (
        "Chinese",
        "质量, 質量, 质心, 質心, 重心, 惯性, 慣性矩, 慣性張量, 转动惯量, 轉動慣量, 密度, 体积, 體積, 表面积, 表面積, 惯性主轴",
    ),
];

/// List of supported headings, for users who translate a report.
pub(crate) const KNOWN: &str = "Mass, Volume, Surface area, Density, Center of mass (or of gravity, centroid), Moments of \
     inertia … at the center of mass (or origin, coordinate system), Principal axes and moments of inertia";

/// Returns the language of foreign headings in a text, and one of them.
pub(crate) fn foreign(text: &str) -> Option<(&'static str, &'static str)> {
    let lower = text.to_lowercase();
    let stands = |word: &str| {
        // Whole words only, in languages with blanks between words: "masse" does not match
        // "massen".
        lower.match_indices(word).any(|(at, _)| {
            let letter = |c: char| c.is_alphabetic() && c.is_ascii();
            let before = lower[..at].chars().next_back();
            let after = lower[at + word.len()..].chars().next();
            !before.is_some_and(letter) && (word.len() > 5 || !after.is_some_and(letter))
        })
    };
    let found = LANGUAGES.map(|(language, words)| {
        let there: Vec<&str> = words.split(", ").filter(|word| stands(word)).collect();
        (there.len(), language, there.into_iter().max_by_key(|word| word.chars().count()))
    });
    let (count, language, longest) = found.into_iter().rev().max_by_key(|(count, ..)| *count)?;
    longest.filter(|_| count > 0).map(|word| (language, word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn languages_are_told_by_their_headings() {
        for (text, language) in [
            ("Masse = 1.2 Gramm\nMassenschwerpunkt: ( Millimeter )\nTrägheitsmomente", "German"),
            ("Masse = 1.2 grammes\nCentre de masse: ( millimètres )\nMoments d'inertie", "French"),
            ("Masa = 1.2 gramos\nCentro de masa: ( milímetros )\nMomentos de inercia", "Spanish"),
            ("Massa = 1.2 grammi\nCentro di massa: ( millimetri )\nMomenti di inerzia", "Italian"),
            ("Massa = 1.2 gramas\nCentro de massa: ( milímetros )\nMomentos de inércia", "Portuguese"),
            ("质量 = 1.2 克\n重心: ( 毫米 )\n惯性张量", "Chinese"),
            ("質量 = 1.2 グラム\n重心: ( ミリメートル )\n慣性モーメント", "Japanese"),
            ("Масса = 1.2\nЦентр масс\nМоменты инерции", "Russian"),
        ] {
            assert_eq!(foreign(text).map(|(language, _)| language), Some(language), "{text}");
        }
        for text in ["", "Mass = 2 kg\nMassless parts\nCenter of mass\nVolume, density, Moments of inertia"] {
            assert_eq!(foreign(text), None);
        }
    }
}
