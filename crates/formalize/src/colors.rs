//! Which colours are known by name: those of CSS, and what people say about furniture; and `#rrggbb`.

/// The names that the furniture library has a value for; a test holds them against it.
const NAMES: &str = "
aliceblue antiquewhite aquamarine azure bisque blanchedalmond blueviolet burlywood cadetblue chartreuse
chocolate coral cornflowerblue cornsilk darkcyan darkgoldenrod darkkhaki darkmagenta darkolivegreen darkorchid
darksalmon darkseagreen darkslateblue darkslategray darkturquoise darkviolet deeppink dimgray dodgerblue
floralwhite gainsboro ghostwhite goldenrod greenyellow honeydew indianred ivory khaki lavender lavenderblush
lawngreen lemonchiffon lightblue lightcoral lightcyan lightgoldenrodyellow lightgray lightgreen lightpink
lightsalmon lightseagreen lightskyblue lightslategray lightsteelblue lightyellow linen mediumaquamarine
mediumblue mediumorchid mediumpurple mediumseagreen mediumslateblue mediumspringgreen mediumturquoise
mediumvioletred midnightblue mintcream mistyrose moccasin navajowhite oldlace olivedrab orchid palegoldenrod
palegreen paleturquoise palevioletred papayawhip peachpuff peru plum powderblue rebeccapurple rosybrown
saddlebrown salmon sandybrown seagreen seashell sienna skyblue slateblue slategray snow springgreen steelblue
tan thistle tomato wheat whitesmoke yellowgreen aqua beige black blue brown cyan darkblue darkgray darkgreen
darkred fuchsia gold gray green lime magenta orange pink purple red silver violet white yellow amber
anthracite apricot aubergine blond blonde bluegray blush bordeaux bottlegreen brickred burgundy burntorange
camel caramel cerulean champagne charcoal cinnamon clay cobalt coffee copper cream crimson darkbrown
darkorange deepskyblue denim ebony ecru eggplant eggshell emerald espresso fern firebrick flax forestgreen
ginger graphite grassgreen greengray honey hotpink indigo jade lemon lightbrown lilac limegreen mahogany
maroon mauve midnight mint mocha moss mossgreen mustard natural navy navyblue nougat ocher ochre offwhite
olive orangered oxblood peach pearl petrol pistachio platinum prussianblue rose rosegold royalblue ruby russet
rust sage sand sapphire scarlet stone taupe teal terracotta turquoise umber vanilla wine
";

/// A colour as the language writes it: "dark green" is "darkgreen"; `None`: no colour that it knows.
pub fn known(words: &str) -> Option<String> {
    let joined: String = words.trim().to_lowercase().split([' ', '-', '_']).collect();
    let joined = joined.replace("grey", "gray");
    let hex = joined
        .strip_prefix('#')
        .is_some_and(|digits| matches!(digits.len(), 3 | 6) && digits.chars().all(|c| c.is_ascii_hexdigit()));
    (hex || !joined.is_empty() && NAMES.split_whitespace().any(|name| name == joined)).then_some(joined)
}

/// The colour that words come nearest to: "soft yellow" is light yellow, "bright red" is red.
pub fn nearest(words: &str) -> Option<String> {
    const LIGHTER: [&str; 6] = ["soft", "pale", "pastel", "light", "dusty", "powder"];
    const DARKER: [&str; 2] = ["deep", "dark"];
    let all = words.split_whitespace().collect::<Vec<_>>();
    let (from, base) = (0..all.len()).find_map(|from| Some((from, known(&all[from..].join(" "))?)))?;
    let is_said = |shades: &[&str]| all[..from].iter().any(|word| shades.contains(word));
    let shade = match () {
        () if is_said(&LIGHTER) => "light",
        () if is_said(&DARKER) => "dark",
        () => "",
    };
    Some(known(&format!("{shade}{base}")).unwrap_or(base))
}

/// Colours that people call by another's name, first that name.
const FAMILIES: [(&str, &str); 10] = [
    ("blue", "navy denim cobalt sapphire midnight indigo cerulean petrol azure teal turquoise cyan aqua"),
    ("green", "sage olive emerald jade moss mint forest fern pistachio lime teal grass chartreuse"),
    ("red", "burgundy crimson maroon ruby scarlet bordeaux oxblood brick tomato russet"),
    ("pink", "blush rose salmon fuchsia magenta peach"),
    ("yellow", "mustard gold ochre ocher lemon amber honey"),
    ("orange", "terracotta rust coral apricot peach copper"),
    ("purple", "violet mauve lilac lavender plum aubergine eggplant orchid magenta indigo"),
    ("brown", "chocolate coffee umber sienna chestnut mocha caramel saddle"),
    ("gray", "charcoal slate anthracite graphite silver platinum"),
    ("black", "ebony charcoal anthracite"),
];

/// Whether a colour is a shade of another: navy is of blue.
pub fn is_shade(color: &str, of: &str) -> bool {
    let others = FAMILIES.iter().find(|(name, _)| *name == of).map_or("", |(_, others)| others);
    color.contains(of) || others.split(' ').any(|other| !other.is_empty() && color.contains(other))
}

#[cfg(test)]
mod tests {
    use super::{known, nearest};

    #[test]
    fn words_come_near_a_color() {
        let cases = [
            ("soft yellow", Some("lightyellow")),
            ("bright red", Some("red")),
            ("deep blue", Some("darkblue")),
            ("pale teal", Some("teal")),
            ("warm", None),
        ];
        for (words, expected) in cases {
            assert_eq!(nearest(words).as_deref(), expected, "{words}");
        }
    }

    #[test]
    fn names_and_numbers() {
        let cases = [
            ("red", Some("red")),
            ("Dark Green", Some("darkgreen")),
            ("light-grey", Some("lightgray")),
            ("#a0B1c2", Some("#a0b1c2")),
            ("#abc", Some("#abc")),
            ("#abcd", None),
            ("Off-White", Some("offwhite")),
            ("brushed gold", None),
            ("", None),
            ("warm", None),
        ];
        for (words, expected) in cases {
            assert_eq!(known(words).as_deref(), expected, "{words}");
        }
    }

    #[test]
    fn the_furniture_library_has_the_same() {
        let table = include_str!("../../assets/src/colors.txt").lines();
        let theirs = table.filter(|l| !l.starts_with('#')).filter_map(|line| line.split_whitespace().next());
        assert!(theirs.eq(super::NAMES.split_whitespace()));
    }
}
