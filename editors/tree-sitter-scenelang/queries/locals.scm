; Made by `./x grammars` from the table of tokens.

[
  (quantified)
  (count)
  (predicate)
] @local.scope

(binding variable: (identifier) @local.definition)
(parameter name: (identifier) @local.definition)

(identifier) @local.reference
