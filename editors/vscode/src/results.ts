// What an export has written, and how each of it is looked at. Knows nothing of the editor.

export interface Result {
  /** How it is called in a list. */
  readonly label: string;
  /** Its name in the folder. */
  readonly file: string;
  /** Where it is opened: in the editor, by the program that the system has for it, or as a folder. */
  readonly where: "editor" | "outside" | "folder";
}

const KINDS: readonly (readonly [test: RegExp, label: string, where: Result["where"]])[] = [
  [/^picture\.png$/, "Picture", "editor"],
  [/^plan\.png$/, "Floor Plan", "editor"],
  [/^preview\.html$/, "Page with the Room", "outside"],
  [/\.glb$/, "GLB", "outside"],
  [/^unity$/, "Unity Project", "folder"],
];

/** What of these files one would open, the picture first. */
export function results(names: readonly string[]): Result[] {
  return KINDS.flatMap(([test, label, where]) => names.filter((name) => test.test(name)).map((file) => ({ label, file, where })));
}
