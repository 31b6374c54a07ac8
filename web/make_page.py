"""Puts the page's parts into one HTML file: make_page.py PAGE.html PAGE.css PAGE.js MODULE.wasm OUT.html"""

import base64
import gzip
import sys
from pathlib import Path

page, css, js, wasm, out = map(Path, sys.argv[1:])
module = base64.b64encode(gzip.compress(wasm.read_bytes(), 9, mtime=0)).decode()
text = page.read_text(encoding="utf-8")
for mark, part in (("CSS", css.read_text(encoding="utf-8")), ("MODULE", module), ("JS", js.read_text(encoding="utf-8"))):
    before, found, after = text.partition(f"@{mark}@")
    if not found:
        sys.exit(f"{page}: there is no @{mark}@")
    text = before + part + after
out.parent.mkdir(parents=True, exist_ok=True)
out.write_text(text, encoding="utf-8")
