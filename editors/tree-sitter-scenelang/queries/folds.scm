; Made by `./x grammars` from the table of tokens.

[
  (statement)
  (block_comment)
] @fold
