// The two tokens that no regular expression finds: comments, which nest, and the characters of a string, among which
// `//` and `/*` begin no comment.

#include "tree_sitter/parser.h"

// In the order of `externals` in grammar.js. The last one stands in no rule: where it is valid, all are, because
// tree-sitter looks for a way out of an error.
enum Token { BLOCK_COMMENT, CHARACTERS, ERROR_SENTINEL };

void *tree_sitter_scenelang_external_scanner_create(void) {
  return NULL;
}

void tree_sitter_scenelang_external_scanner_destroy(void *payload) {
  (void)payload;
}

unsigned tree_sitter_scenelang_external_scanner_serialize(void *payload, char *buffer) {
  (void)payload;
  (void)buffer;
  return 0;
}

void tree_sitter_scenelang_external_scanner_deserialize(void *payload, const char *buffer, unsigned length) {
  (void)payload;
  (void)buffer;
  (void)length;
}

static bool is_blank(int32_t c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f';
}

static bool scan_characters(TSLexer *lexer) {
  bool any = false;
  while (!lexer->eof(lexer)) {
    int32_t c = lexer->lookahead;
    if (c == '"' || c == '\\' || c == '\r' || c == '\n') {
      break;
    }
    lexer->advance(lexer, false);
    any = true;
  }
  lexer->result_symbol = CHARACTERS;
  return any;
}

static bool scan_block_comment(TSLexer *lexer) {
  while (is_blank(lexer->lookahead)) {
    lexer->advance(lexer, true);
  }
  if (lexer->lookahead != '/') {
    return false;
  }
  lexer->advance(lexer, false);
  if (lexer->lookahead != '*') {
    return false;
  }
  lexer->advance(lexer, false);
  for (unsigned depth = 1; depth > 0;) {
    if (lexer->eof(lexer)) {
      return false;
    }
    int32_t c = lexer->lookahead;
    lexer->advance(lexer, false);
    if (c == '*' && lexer->lookahead == '/') {
      lexer->advance(lexer, false);
      depth--;
    } else if (c == '/' && lexer->lookahead == '*') {
      lexer->advance(lexer, false);
      depth++;
    }
  }
  lexer->result_symbol = BLOCK_COMMENT;
  return true;
}

bool tree_sitter_scenelang_external_scanner_scan(void *payload, TSLexer *lexer, const bool *valid) {
  (void)payload;
  if (valid[CHARACTERS] && !valid[ERROR_SENTINEL]) {
    return scan_characters(lexer);
  }
  return scan_block_comment(lexer);
}
