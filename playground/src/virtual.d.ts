// What build.mjs puts in: the worker's script, and the examples with their layouts.
declare module "virtual:worker" {
  const script: string;
  export default script;
}
declare module "virtual:examples" {
  const examples: readonly { readonly name: string; readonly text: string; readonly layout: string | null }[];
  export default examples;
}
declare module "*.css" {
  const text: string;
  export default text;
}
