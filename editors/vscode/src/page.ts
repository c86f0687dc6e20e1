// The page of the preview: one script that came with the extension, and leave for nothing else.

export interface Parts {
  /** Where the script is, as the panel may load it. */
  readonly script: string;
  readonly nonce: string;
}

export function page({ script, nonce }: Parts): string {
  // Only the script that bears the nonce runs. Pictures: the plan where there is no 3D, and the textures of models.
  const policy = `default-src 'none'; script-src 'nonce-${nonce}'; img-src data: blob:; connect-src blob: data:`;
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Preview</title>
</head>
<body>
<main id="scenelang"></main>
<script nonce="${nonce}" src="${script}"></script>
</body>
</html>
`;
}
