// Written by `cargo xtask bless book` from the tables of the compiler: classes of highlight.js and what has them.
const plmPatterns = [
    ["", "\\.\\s*[A-Za-z_]\\w*"],
    ["number", "\\b\\d[\\d_]*(?:\\.\\d[\\d_]*)?(?:[eE][+-]?\\d+)?"],
    ["built_in", "\\b(?:abs|acos|asin|atan|atan2|clamp|cos|count|cross|derivative|disc|dot|drawn|exp|floor|hollow_cylinder|is_open|is_sticking|ln|max|min|mod|norm|plate|rate|reaction|rod|section_area|section_moment|sign|sin|smooth_table|sphere|sqrt|table|tan|thin_cylinder|thin_sphere|to_absolute|to_relative|turn)\\b(?=\\s*\\()"],
    ["keyword", "\\b(?:across|allow|and|at|body|choice|code|constraint|crate|discrete|domain|else|emit|for|formulation|friction|from|function|given|gravity|ground|if|impacts|in|input|joint|let|locked|node|not|observe|on|optional|or|output|pair|param|part|parts|picture|points|port|pub|rate|repeat|require|stabilisation|start|state|step|then|through|unilateral|use|when|within)\\b"],
    ["", "\\b[A-Za-z_]\\w*(?:\\.[A-Za-z_]\\w*|\\s*\\[[^\\]]*\\])*(?=\\s*:(?!:))"],
    ["title", "\\b[a-z_]\\w*(?=\\s+[A-Za-z_]\\w*(?:\\s*\\[[^\\]]*\\])*\\s*\\()"],
    ["literal", "\\b(?:pi|t)\\b"],
    ["string", "\\b(?:GPa|Hz|J|K|L|MPa|N|Pa|W|ampere|bar|cP|cm|deg|degree|gram|h|henry|kN|kPa|kW|kg|km|m|min|mm|ms|ohm|rad|rev|s|tonne|um|volt)\\b"],
    ["title", "\\b[A-Z]\\w*(?=\\s*\\{)"],
];
