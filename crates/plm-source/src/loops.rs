//! Revolutions, intervals and charts of loops between steps.

use std::fmt::Write as _;

use plm_compiler::lowered::Turns;

use crate::plan::Plan;
use crate::source::CAUSES;
use crate::template::indented;

const CALM: &str = include_str!("c/calm.c.txt");
const CHANGE: &str = include_str!("c/change.c.txt");
const BEST: &str = include_str!("c/best.c.txt");
const ITERATED: &str = include_str!("c/iterated.c.txt");
const ITERATED_CHECK: &str = include_str!("c/iterated_check.c.txt");
const ITERATED_UPDATE: &str = include_str!("c/iterated_update.c.txt");
const ITERATED_PROBE: &str = include_str!("c/iterated_probe.c.txt");

/// Reduces angles that have turned far, where a mechanism counts revolutions.
pub(crate) fn unwind(plan: &Plan) -> String {
    let counts = plan.lowered.turns.iter().enumerate();
    counts.map(|(count, turns)| unwind_count(plan, count, turns)).collect()
}

/// Reduces the angles of one count.
fn unwind_count(plan: &Plan, count: usize, turns: &Turns) -> String {
    let (prefix, first_angle) = (&plan.name, 2 * (plan.counts.coordinates + 1));
    let first_iterated = first_angle + 3 * plan.counts.angles + plan.counts.determinants;
    // A tree stays in its first chart.
    let in_state = turns.in_state.get(..plan.counts.charts).unwrap_or(&turns.in_state);
    let first = in_state.iter().map(|places| {
        let own = places.first().map(|place| format!("x[{place}]"));
        let remembered = turns.remembered.first().filter(|_| plan.is_loops());
        let of_memory = || remembered.map(|k| format!("self->memory[{}]", first_angle + 3 * k));
        own.or_else(of_memory).unwrap_or_else(|| "PLM_C(0.0)".to_owned())
    });
    let angle = in_chart(&first.collect::<Vec<_>>());
    let less = |place: &str| format!("{place} = {prefix}_less({place}, due);\n");
    let of_chart = |places: &[usize]| -> String {
        let interval = |place: usize| plan.is_loops() && place < plan.counts.coordinates;
        let all = places.iter().map(|&place| {
            let last = interval(place).then(|| less(&format!("self->memory[{}]", 2 * place)));
            format!("{}{}", less(&format!("x[{place}]")), last.unwrap_or_default())
        });
        all.collect()
    };
    let mut inner = String::new();
    if in_state.windows(2).all(|pair| pair[0] == pair[1]) {
        inner.push_str(&of_chart(in_state.first().map_or(&[], Vec::as_slice)));
    } else {
        for (chart, places) in in_state.iter().enumerate().filter(|(_, places)| !places.is_empty()) {
            let _ = write!(inner, "if (self->chart == {chart}) {{\n{}}}\n", indented(&of_chart(places), 4));
        }
    }
    let remembered = turns.remembered.iter().map(|k| first_angle + 3 * k);
    let iterated = turns.iterated.iter().map(|k| first_iterated + 3 * k);
    for place in remembered.chain(iterated).filter(|_| plan.is_loops()) {
        inner.push_str(&less(&format!("self->memory[{place}]")));
    }
    let _ = writeln!(inner, "self->turns[{count}] = self->turns[{count}] + due;");
    format!(
        "{{\n    const int32_t due = {prefix}_due({angle});\n    if (due != 0) {{\n{}    }}\n}}\n",
        indented(&inner, 8)
    )
}

/// One of several texts by the present chart.
fn in_chart(texts: &[String]) -> String {
    let Some((last, before)) = texts.split_last() else { return "PLM_C(0.0)".to_owned() };
    if before.iter().all(|text| text == last) {
        return last.clone();
    }
    let mut all = String::new();
    for (chart, text) in before.iter().enumerate() {
        let _ = write!(all, "(self->chart == {chart}) ? {text} : ");
    }
    format!("({all}{last})")
}

/// Are all angles of a tree near?
pub(crate) fn near(plan: &Plan) -> String {
    let first = plan.lowered.turns.iter().filter_map(|turns| turns.in_state.first()?.first());
    let near: Vec<String> = first.map(|place| format!("({}_due(x[{place}]) == 0)", plan.name)).collect();
    if near.is_empty() { "1".to_owned() } else { near.join(" && ") }
}

/// Words of the template of loops that have other words in them.
pub(crate) fn words(plan: &Plan, has_iterated: bool) -> Vec<(&'static str, String)> {
    if !plan.is_loops() {
        return Vec::new();
    }
    let change = format!("{}{}", flattest(plan), CHANGE);
    let choose = match plan.counts.charts {
        1 => ["", ""],
        _ => ["    chart = @p@_best(self, t, q, v, &other);\n", BEST],
    };
    let [choose, best] = choose.map(str::to_owned);
    let calm = if has_iterated {
        "    (void)self;\n    (void)t;\n    (void)x;\n    return 0;\n".to_owned()
    } else {
        calm(plan)
    };
    let of_iterated = |text: &str| if has_iterated { text.to_owned() } else { String::new() };
    let first = 2 * (plan.counts.coordinates + 1) + 3 * plan.counts.angles + plan.counts.determinants;
    vec![
        ("calm", calm),
        ("narrowed", of_iterated(ITERATED)),
        ("change", change),
        ("choose", choose),
        ("best", best),
        ("check_iterated", of_iterated(ITERATED_CHECK)),
        ("update_iterated", of_iterated(ITERATED_UPDATE)),
        ("probe", of_iterated(ITERATED_PROBE)),
        ("turned", turned(plan)),
        ("first_iterated", first.to_string()),
    ]
}

/// Is a state within its intervals?
fn calm(plan: &Plan) -> String {
    let loose = if plan.lowered.loops.as_ref().is_some_and(|loops| loops.is_loose) {
        let first =
            plan.lowered.turns.iter().filter(|turns| turns.in_state.iter().any(|places| !places.is_empty()));
        first
            .map(|turns| {
                let angles: Vec<String> = turns
                    .in_state
                    .iter()
                    .map(|places| {
                        places.first().map_or("PLM_C(0.0)".to_owned(), |place| format!("x[{place}]"))
                    })
                    .collect();
                format!("    if (@p@_due({}) != 0) {{\n        return 0;\n    }}\n", in_chart(&angles))
            })
            .collect::<Vec<_>>()
            .concat()
    } else {
        String::new()
    };
    CALM.replace("@loose@", &loose)
}

/// By chart, how far the angles that its loops give have turned.
fn turned(plan: &Plan) -> String {
    let first = 2 * (plan.counts.coordinates + 1);
    let mut text = String::new();
    for (chart, of) in plan.lowered.charts.iter().enumerate().filter(|(_, of)| !of.found.is_empty()) {
        let _ = writeln!(text, "    if (chart == {chart}) {{\n        plm_real turned;");
        for k in of.found.iter().map(|found| first + 3 * found) {
            let _ = writeln!(
                text,
                "        turned = plm_abs(after[{k}] - before[{k}]);\n        most = (turned > most) ? turned : most;"
            );
        }
        text.push_str("    }\n");
    }
    if text.is_empty() {
        text.push_str("    (void)before;\n    (void)after;\n    (void)chart;\n");
    }
    text
}

/// A function that names the part which closes the loop that is nearest to flat.
fn flattest(plan: &Plan) -> String {
    let (first, after) =
        (2 * (plan.counts.coordinates + 1) + 3 * plan.counts.angles, CAUSES.len() + plan.counts.guards);
    let mut text = "/* The part that closes the loop of a chart with the smallest determinant. */\n\
        static int @p@_flattest(int chart, const plm_real memory[@memory@])\n{\n    \
        plm_real least = PLM_INFINITY;\n    int part = 0, k, first = 0, count = 0;\n"
        .to_owned();
    let mut begin = after;
    for (chart, of) in plan.lowered.charts.iter().enumerate() {
        let count = of.closing.len().min(plan.counts.determinants);
        let _ = writeln!(
            text,
            "    if (chart == {chart}) {{\n        first = {begin};\n        count = {count};\n    }}"
        );
        begin += of.closing.len();
    }
    let _ = write!(
        text,
        "    for (k = 0; k < count; k++) {{\n        const plm_real size = plm_abs(memory[{first} + k]);\n        \
         if (!(least < size)) {{\n            least = size;\n            part = first + k;\n        }}\n    }}\n    return part;\n}}\n\n"
    );
    text
}
