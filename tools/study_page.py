"""The study as one page that needs no other file: its text with tables and plots, and pictures to compare by a slider."""

import base64
import html
import re
from dataclasses import dataclass
from pathlib import Path

STYLE = """
body { font: 16px/1.5 sans-serif; max-width: 1100px; margin: 2em auto; padding: 0 1em; color: #222; background: #fff }
table { border-collapse: collapse; font-size: 13px; display: block; overflow-x: auto }
td, th { border: 1px solid #ccc; padding: .3em .6em; text-align: left; vertical-align: top }
img { max-width: 100%; height: auto }
figure[role=img] { overflow-x: auto }  /* their letters are small as it is */
figure { margin: 2em 0 }
figcaption { margin-top: .4em }
.pair { position: relative; display: grid; width: fit-content; max-width: 100% }
.pair > img { grid-area: 1 / 1; display: block; width: 640px }
.pair > img:nth-of-type(2) { clip-path: inset(0 0 0 var(--cut, 50%)) }
.pair > i { position: absolute; top: 0; bottom: 0; left: var(--cut, 50%); border-left: 2px solid #fff;
            mix-blend-mode: difference; pointer-events: none }
.pair > span { position: absolute; top: .4em; padding: 0 .4em; background: #0009; color: #fff; font-size: 13px }
.pair > span:nth-of-type(1) { left: .4em }
.pair > span:nth-of-type(2) { right: .4em }
.pair > input { position: absolute; inset: 0; width: 100%; height: 100%; margin: 0; opacity: 0; cursor: ew-resize }
.pair:focus-within { outline: 2px solid #0072b2 }
"""

SCRIPT = """
for (const slider of document.querySelectorAll('.pair > input'))
  slider.addEventListener('input', () => slider.parentElement.style.setProperty('--cut', slider.value + '%'));
"""


@dataclass(frozen=True)
class Pair:
    """Two pictures of one size: what is on the left and on the right, what to see, and the PNG files."""
    left: str
    right: str
    caption: str
    left_file: Path
    right_file: Path


def data_url(file):
    return "data:image/png;base64," + base64.b64encode(Path(file).read_bytes()).decode()


def figure(pair):
    left, right = html.escape(pair.left), html.escape(pair.right)
    return (f"<figure><div class='pair'><img src='{data_url(pair.left_file)}' alt='{left}'>"
            f"<img src='{data_url(pair.right_file)}' alt='{right}'><i></i><span>{left}</span><span>{right}</span>"
            f"<input type='range' min='0' max='100' step='0.1' value='50' aria-label='{left} or {right}'></div>"
            f"<figcaption>{html.escape(pair.caption)}</figcaption></figure>")


def inline_plots(text, folder):
    """SVG files that the text shows become part of it."""
    def replacement(match):
        plot = (folder / match[2]).read_text()
        # gnuplot names its parts alike in every plot; one page can't hold a name twice.
        prefix = Path(match[2]).stem
        plot = re.sub(r"^<\?xml.*?\?>\s*(<!DOCTYPE.*?>)?", "", plot, flags=re.S)
        plot = re.sub(r"\bid=(['\"])", rf"id=\1{prefix}-", plot)
        plot = re.sub(r"(href=['\"]|url\(['\"]?)#", rf"\1#{prefix}-", plot)
        return f"<figure role='img' aria-label='{html.escape(match[1], quote=True)}'>{plot}</figure>"
    return re.sub(r"<img alt=\"([^\"]*)\" src=\"([^\"/]+\.svg)\" />", replacement, text)


def page(text, folder, pairs):
    """HTML of a Markdown text whose plots are files in a folder."""
    import markdown  # only the page needs it, the study doesn't

    body = inline_plots(markdown.markdown(text, extensions=["tables"]), folder)
    title = html.escape(text.splitlines()[0].lstrip("# "))
    compared = "".join(figure(pair) for pair in pairs)
    return (f"<!DOCTYPE html>\n<html lang='en'><meta charset='utf-8'><meta name='viewport' content='width=device-width'>"
            f"<title>{title}</title><style>{STYLE}</style>\n{body}\n<h2>Side by side</h2>"
            f"<p>Drag across a picture, or use the arrow keys.</p>{compared}<script>{SCRIPT}</script></html>\n")
