//! Plots as SVG: lines over a range, and points.

use std::fmt::Write;

/// Width and height of a plot, and what is left for its labels: left, right, top, bottom.
const SIZE: [f64; 2] = [640.0, 360.0];
const ROOM: [f64; 4] = [56.0, 190.0, 36.0, 46.0];
/// Colours that differ in lightness, too.
const COLOURS: [&str; 6] = ["#0b5394", "#cc4125", "#6aa84f", "#8e7cc3", "#e69138", "#666666"];

/// A line, or points where it is not joined.
pub(super) struct Series {
    pub name: String,
    pub points: Vec<[f64; 2]>,
    pub joined: bool,
}

/// A chart of points over two axes.
pub(super) struct Plot<'a> {
    pub title: &'a str,
    /// Labels of x and y.
    pub axes: [&'a str; 2],
    /// The ranges of x and y.
    pub ranges: [[f64; 2]; 2],
    /// How many steps the axes are divided into.
    pub steps: [usize; 2],
    pub series: Vec<Series>,
}

impl Plot<'_> {
    /// Where a point is drawn.
    fn at(&self, point: [f64; 2]) -> [f64; 2] {
        let share = |i: usize| (point[i] - self.ranges[i][0]) / (self.ranges[i][1] - self.ranges[i][0]);
        let [left, right, top, bottom] = ROOM;
        [left + share(0) * (SIZE[0] - left - right), SIZE[1] - bottom - share(1) * (SIZE[1] - top - bottom)]
    }

    /// The text of the file.
    pub fn svg(&self) -> String {
        let [w, h] = SIZE;
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {w} {h}\" font-family=\"sans-serif\" font-size=\"12\">\n\
             <title>{0}</title>\n<rect width=\"{w}\" height=\"{h}\" fill=\"#ffffff\"/>\n\
             <text x=\"{1}\" y=\"20\" font-size=\"14\" font-weight=\"bold\">{0}</text>\n",
            escaped(self.title),
            ROOM[0]
        );
        self.grid(&mut out);
        for (i, series) in self.series.iter().enumerate() {
            self.series(&mut out, i, series);
        }
        out + "</svg>\n"
    }

    fn grid(&self, out: &mut String) {
        let [[x0, x1], [y0, y1]] = self.ranges;
        let value = |lo: f64, hi: f64, step: usize, of: usize| lo + (hi - lo) * step as f64 / of.max(1) as f64;
        for step in 0..=self.steps[1] {
            let y = value(y0, y1, step, self.steps[1]);
            let ([a, b], [c, _]) = (self.at([x0, y]), self.at([x1, y]));
            let _ = writeln!(out, "<path d=\"M{a:.1} {b:.1}H{c:.1}\" stroke=\"#dddddd\"/>");
            let _ = writeln!(
                out,
                "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
                a - 6.0,
                b + 4.0,
                label(y)
            );
        }
        for step in 0..=self.steps[0] {
            let x = value(x0, x1, step, self.steps[0]);
            let [a, b] = self.at([x, y0]);
            let _ =
                writeln!(out, "<text x=\"{a:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>", b + 16.0, label(x));
        }
        let [a, b] = self.at([(x0 + x1) / 2.0, y0]);
        let _ = writeln!(
            out,
            "<text x=\"{a:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
            b + 36.0,
            escaped(self.axes[0])
        );
        let [_, c] = self.at([x0, (y0 + y1) / 2.0]);
        let _ = writeln!(
            out,
            "<text x=\"14\" y=\"{c:.1}\" text-anchor=\"middle\" transform=\"rotate(-90 14 {c:.1})\">{}</text>",
            escaped(self.axes[1])
        );
    }

    fn series(&self, out: &mut String, i: usize, series: &Series) {
        let colour = COLOURS[i % COLOURS.len()];
        let points: Vec<[f64; 2]> = series.points.iter().map(|point| self.at(*point)).collect();
        if series.joined {
            let path: Vec<String> = points.iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
            let _ = writeln!(
                out,
                "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\"/>",
                path.join(" ")
            );
        }
        for [x, y] in &points {
            let _ = writeln!(out, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3\" fill=\"{colour}\"/>");
        }
        let (x, y) = (SIZE[0] - ROOM[1] + 14.0, ROOM[2] + 10.0 + 20.0 * i as f64);
        let _ = writeln!(out, "<circle cx=\"{x:.1}\" cy=\"{:.1}\" r=\"4\" fill=\"{colour}\"/>", y - 4.0);
        let _ = writeln!(out, "<text x=\"{:.1}\" y=\"{y:.1}\">{}</text>", x + 10.0, escaped(&series.name));
    }
}

/// A number without needless digits.
fn label(x: f64) -> String {
    let rounded = (x * 100.0).round() / 100.0;
    rounded.to_string()
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_where_they_belong_and_names_are_escaped() {
        let series = vec![Series { name: "a<b".to_owned(), points: vec![[0.0, 0.0], [5.0, 100.0]], joined: true }];
        let plot = Plot { title: "t & u", axes: ["x", "y"], ranges: [[0.0, 5.0], [0.0, 100.0]], steps: [5, 4], series };
        let svg = plot.svg();
        assert!(svg.contains("<polyline points=\"56.0,314.0 450.0,36.0\""), "{svg}");
        assert!(svg.contains("a&lt;b") && svg.contains("t &amp; u"), "{svg}");
        assert_eq!(svg.matches("<circle").count(), 3, "two points, one entry of the legend");
    }
}
