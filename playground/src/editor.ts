// The editor: CodeMirror, with what the module says of the program as marks, colours, proposals and hovers.

import { acceptCompletion, autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap, type Completion, type CompletionContext, type CompletionResult, snippetCompletion } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab, toggleComment } from "@codemirror/commands";
import { bracketMatching, indentUnit } from "@codemirror/language";
import { type Diagnostic, lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { EditorState, RangeSetBuilder, StateEffect, StateField } from "@codemirror/state";
import { crosshairCursor, Decoration, type DecorationSet, drawSelection, EditorView, highlightActiveLine, hoverTooltip, keymap, lineNumbers, rectangularSelection, type Tooltip } from "@codemirror/view";
import type { Hover, Mark, Marks, Proposals } from "./answers.js";
import { markdown } from "./markdown.js";

export interface Asked {
  /** The text is another one, because somebody typed. */
  changed(): void;
  complete(at: number, asked: boolean): Promise<Proposals>;
  describe(about: string): Promise<string | null>;
  hover(at: number): Promise<Hover | null>;
  solve(): void;
}

/** The policy of the page lets styles with this in; no markup of anybody else gets into the page. */
const NONCE = "editor";

const painted = StateEffect.define<DecorationSet>();

/** Colours of tokens; they move with the text until the next ones come. */
const colours = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(value, transaction) {
    for (const effect of transaction.effects) if (effect.is(painted)) return effect.value;
    return value.map(transaction.changes);
  },
  provide: (field) => EditorView.decorations.from(field),
});

const classes = new Map<string, Decoration>();

function classOf(name: string): Decoration {
  const known = classes.get(name);
  if (known !== undefined) return known;
  const made = Decoration.mark({ class: `tok-${name}` });
  classes.set(name, made);
  return made;
}

const look = EditorView.theme({
  "&": { height: "100%", color: "var(--ink)", backgroundColor: "var(--panel)", fontSize: "13px" },
  "&.cm-focused": { outline: "none" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.55" },
  ".cm-content": { caretColor: "var(--ink)", padding: "10px 0" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  ".cm-gutters": { backgroundColor: "var(--panel)", color: "var(--soft)", border: "0" },
  ".cm-activeLine": { backgroundColor: "color-mix(in srgb, var(--accent) 6%, transparent)" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground": { backgroundColor: "color-mix(in srgb, var(--accent) 24%, transparent)" },
  ".cm-matchingBracket, &.cm-focused .cm-matchingBracket": { backgroundColor: "color-mix(in srgb, var(--accent) 18%, transparent)" },
  ".cm-tooltip": { backgroundColor: "var(--panel)", color: "var(--ink)", border: "1px solid var(--line)", borderRadius: "8px", boxShadow: "var(--shadow)", maxWidth: "560px" },
  ".cm-tooltip.cm-tooltip-autocomplete > ul > li[aria-selected]": { backgroundColor: "var(--accent-wash)", color: "var(--ink)" },
  ".cm-diagnostic": { whiteSpace: "pre-wrap" },
  ".cm-panels": { backgroundColor: "var(--raised)", color: "var(--ink)" },
});

export class Editor {
  readonly view: EditorView;

  constructor(
    parent: HTMLElement,
    private readonly asked: Asked,
  ) {
    this.view = new EditorView({ parent, state: this.state("") });
  }

  get text(): string {
    return this.view.state.doc.toString();
  }

  /** Shows another program, which cannot be undone. */
  open(text: string): void {
    this.view.setState(this.state(text));
  }

  /** Puts another text in, as an edit. */
  replace(from: number, to: number, text: string): void {
    this.view.dispatch({ changes: { from, to, insert: text } });
  }

  select(from: number, to: number): void {
    const end = this.view.state.doc.length;
    const range = { anchor: Math.min(from, end), head: Math.min(to, end) };
    this.view.dispatch({ selection: range, effects: EditorView.scrollIntoView(range.anchor, { y: "center" }) });
    this.view.focus();
  }

  /** Shows what is said of the text; it must be about the text that is shown. */
  mark({ tokens, types }: Marks, marks: readonly Mark[]): void {
    const { state } = this.view;
    const builder = new RangeSetBuilder<Decoration>();
    for (let at = 0; at + 3 < tokens.length; at += 4) {
      const [from, to, type] = [tokens[at] ?? 0, tokens[at + 1] ?? 0, types[tokens[at + 2] ?? 0]];
      if (from < to && to <= state.doc.length && type !== undefined) builder.add(from, to, classOf(type));
    }
    this.view.dispatch({ effects: painted.of(builder.finish()) });
    const shown = marks.flatMap((mark): Diagnostic[] => {
      if (mark.range === null) return [];
      const from = Math.min(mark.range[0], state.doc.length);
      const to = Math.min(mark.range[1], state.doc.length);
      return [{ from, to, severity: mark.severity, source: mark.code, message: mark.message, ...(mark.unused ? { markClass: "unused" } : {}) }];
    });
    this.view.dispatch(setDiagnostics(this.view.state, shown));
  }

  private state(doc: string): EditorState {
    const { asked } = this;
    return EditorState.create({
      doc,
      extensions: [
        EditorView.cspNonce.of(NONCE),
        lineNumbers(),
        lintGutter(),
        history(),
        drawSelection(),
        rectangularSelection(),
        crosshairCursor(),
        highlightActiveLine(),
        highlightSelectionMatches(),
        bracketMatching(),
        closeBrackets(),
        indentUnit.of("  "),
        EditorState.languageData.of(() => [{ commentTokens: { line: "//" }, closeBrackets: { brackets: ["(", "[", "{", '"'] } }]),
        autocompletion({ override: [(context) => complete(context, asked)] }),
        hoverTooltip((_, at) => hover(at, asked), { hoverTime: 250 }),
        colours,
        look,
        EditorView.contentAttributes.of({ "aria-label": "Program", spellcheck: "false", autocapitalize: "off" }),
        EditorView.updateListener.of((update) => {
          if (update.docChanged) asked.changed();
        }),
        keymap.of([
          { key: "Mod-Enter", run: () => (asked.solve(), true) },
          { key: "Mod-/", run: toggleComment },
          { key: "Tab", run: acceptCompletion },
          ...closeBracketsKeymap,
          ...defaultKeymap,
          ...searchKeymap,
          ...historyKeymap,
          ...completionKeymap,
          ...lintKeymap,
          indentWithTab,
        ]),
      ],
    });
  }
}

async function complete(context: CompletionContext, asked: Asked): Promise<CompletionResult | null> {
  const before = context.matchBefore(/[\p{L}\p{N}_@.":-]/u);
  if (!context.explicit && before === null) return null;
  const found = await asked.complete(context.pos, context.explicit).catch(() => null);
  if (found === null || context.aborted || found.list.length === 0) return null;
  const options = found.list.map(({ label, sort, detail, snippet, rank, about }): Completion => {
    const shown: Completion = { label, type: sort, boost: -rank };
    if (detail !== "") shown.detail = detail;
    if (about !== null) shown.info = async () => markdown((await asked.describe(about).catch(() => null)) ?? "");
    // The module writes `$1`, CodeMirror wants braces.
    const wanted = snippet?.replace(/\$(\d+)/g, "${$1}");
    return wanted === undefined ? shown : snippetCompletion(wanted.replace(/\$\{(\d+):([^}]*)\}/g, "${$1:$2}"), shown);
  });
  return { from: found.from, to: found.to, options, validFor: /^[\p{L}\p{N}_]*$/u };
}

async function hover(at: number, asked: Asked): Promise<Tooltip | null> {
  const found = await asked.hover(at).catch(() => null);
  if (found === null) return null;
  const [pos, end] = found.range;
  return { pos, end, above: true, create: () => ({ dom: markdown(found.text) }) };
}
