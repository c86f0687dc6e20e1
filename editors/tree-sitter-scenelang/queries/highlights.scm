; Made by `./x grammars` from the table of tokens.

(number) @number
(string) @string
[(line_comment) (block_comment)] @comment
(documentation) @comment.documentation
(type) @type.builtin
(constructor) @function.builtin
[(truth) (objects)] @constant.builtin
(identifier) @variable
(property) @variable.member
(parameter name: (identifier) @variable.parameter)
(binding variable: (identifier) @variable.parameter)
(predicate name: (identifier) @function)
(call function: (identifier) @function.call)
(unit) @type
(escape) @string.escape
(import path: (string) @string.special.path)

((property) @property
  (#any-of? @property
    "area"
    "bottom"
    "category"
    "ceiling"
    "center"
    "color"
    "dimensions"
    "features"
    "floor"
    "floorColor"
    "floorMaterial"
    "front"
    "material"
    "max"
    "min"
    "pos"
    "right"
    "role"
    "rot"
    "scale"
    "size"
    "surface"
    "top"
    "up"
    "vertices"
    "wallColor"
    "wallMaterial"
    "x"
    "y"
    "z"))

((call function: (identifier) @function.builtin)
  (#any-of? @function.builtin
    "above"
    "abs"
    "againstWall"
    "aligned"
    "angle"
    "armchairsAt"
    "around"
    "backToWall"
    "balanced"
    "bedSet"
    "behind"
    "below"
    "beside"
    "between"
    "ceilingMounted"
    "centeredIn"
    "clear"
    "collides"
    "connects"
    "cos"
    "counterSet"
    "cross"
    "deskSet"
    "diningSet"
    "displayRow"
    "distance"
    "dot"
    "facing"
    "far"
    "gap"
    "inCorner"
    "inFrontOf"
    "inRow"
    "inside"
    "kitchenRun"
    "leftOf"
    "length"
    "looksAt"
    "looksAtFrom"
    "max"
    "min"
    "near"
    "normalize"
    "on"
    "onFloor"
    "oneOf"
    "opening"
    "opens"
    "oppositeWays"
    "over"
    "parallel"
    "polygon"
    "rackAisles"
    "rand"
    "reachable"
    "receptionSet"
    "restsOn"
    "rightOf"
    "rot"
    "rowsBefore"
    "sameWay"
    "screenBefore"
    "seatingGroup"
    "seenLeftOf"
    "seenRightOf"
    "sin"
    "slides"
    "sliding"
    "sqrt"
    "under"
    "vec3"
    "visible"
    "walkDistance"
    "wallMounted"
    "wardBay"
    "within"))

[
  "@req"
] @attribute

[
  "object"
  "entity"
  "region"
  "assert"
  "allowCollide"
  "allowOutside"
  "prefer"
  "weight"
  "allowFloat"
  "predicate"
  "import"
  "forall"
  "exists"
  "count"
  "in"
  "where"
] @keyword

[
  "and"
  "or"
  "not"
  "implies"
] @keyword.operator

[
  "&&"
  "∧"
  "||"
  "∨"
  "!"
  "¬"
  "<-"
  "←"
  ":="
  "="
  "=="
  "!="
  "≠"
  "<"
  "<="
  "≤"
  ">"
  ">="
  "≥"
  "+"
  "-"
  "*"
  "/"
  ".."
] @operator

[
  "("
  ")"
  "["
  "]"
] @punctuation.bracket

[
  "."
  ","
  ":"
  ";"
] @punctuation.delimiter
