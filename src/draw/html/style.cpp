#include "draw/html/style.hpp"

#include <string_view>

#include "draw/style.hpp"

namespace brdfplot::plot {

namespace {

constexpr std::string_view base = R"css(
:root{color-scheme:light dark;--page:#fff;--text:#1a1a1a;--soft:#555;--line:#d8d8d8;--panel:#f6f7f9;--link:#0b57a4}
*{box-sizing:border-box}
html{scroll-behavior:smooth;-webkit-text-size-adjust:100%}
body{margin:0;background:var(--page);color:var(--text);line-height:1.55;
font-family:"Helvetica Neue",Helvetica,Arial,"DejaVu Sans",sans-serif}
a{color:var(--link)}
sub,sup{font-size:.72em;line-height:0;white-space:nowrap}
.layout{display:grid;grid-template-columns:minmax(13rem,17rem) minmax(0,1fr);gap:2.5rem;max-width:75rem;margin:0 auto;
padding:0 1.5rem}
header,main,footer{grid-column:2;max-width:48rem;width:100%}
header h1{font-size:1.9rem;line-height:1.2;margin:2.2rem 0 1rem}
header{margin-bottom:-2rem}
.toc{grid-column:1;grid-row:1/span 3;position:sticky;top:0;align-self:start;max-height:100vh;overflow:auto;
padding:2.2rem 0 2rem;font-size:.875rem;line-height:1.4}
.toc summary{font-weight:bold;cursor:pointer;padding:.25rem 0}
.toc ol{list-style:none;margin:0;padding:0}
.toc ol ol{padding-left:.75rem;border-left:1px solid var(--line);margin:.2rem 0 .7rem}
.toc a{color:inherit;text-decoration:none;display:block;padding:.18rem 0;overflow-wrap:anywhere}
.toc a:hover,.toc a:focus{text-decoration:underline}
.toc>details>ol>li>a{font-weight:600}
.toc .number{color:var(--soft)}
h2{font-size:1.4rem;line-height:1.25;margin:2.5rem 0 .5rem;padding-top:.5rem;border-top:1px solid var(--line)}
figure{margin:1.5rem 0 2.5rem;scroll-margin-top:1rem}
figure svg{display:block;width:100%;height:auto}
figcaption{font-size:.925rem;margin:.5rem 0;overflow-wrap:anywhere}
.tools{display:flex;flex-wrap:wrap;gap:.3rem 1rem;font-size:.85rem;color:var(--soft);align-items:baseline}
details.config{font-size:.85rem;margin-top:.3rem}
details.config summary{cursor:pointer;color:var(--soft)}
button{font:inherit;color:inherit;background:var(--panel);border:1px solid var(--line);border-radius:4px;padding:.1rem .6rem;
cursor:pointer}
details.rows summary{cursor:pointer;color:var(--soft);font-size:.85rem;padding:.4rem 0}
.bp-entry[role]{cursor:pointer}
.bp-faint{opacity:.35}
.bp-off{display:none}
.bp-mark{fill:none;stroke:var(--text);stroke-width:1.5;pointer-events:none}
.tip{position:fixed;z-index:1;pointer-events:none;background:var(--page);color:var(--text);border:1px solid var(--soft);
border-radius:4px;padding:.25rem .5rem;font-size:.8rem;line-height:1.4;font-variant-numeric:tabular-nums;
box-shadow:0 1px 5px #0004}
.large{width:fit-content;max-width:98vw;max-height:98vh;padding:.6rem;overflow:auto;background:var(--page);
color:var(--text);border:1px solid var(--line);border-radius:6px}
.large::backdrop{background:#0009}
.large button{display:block;margin:0 0 .4rem auto}
.large svg{display:block;width:auto;height:auto;min-width:40rem;max-width:none;
inline-size:min(95vw,max(62rem,calc((98vh - 4.5rem)*var(--aspect,1.4))))}
#references li{font-size:.925rem;margin:.35rem 0;overflow-wrap:anywhere}
pre{background:var(--panel);border:1px solid var(--line);border-radius:4px;padding:.75rem;overflow:auto;max-height:28rem;
white-space:pre-wrap;overflow-wrap:anywhere;
font:.8rem/1.45 ui-monospace,"SFMono-Regular",Menlo,Consolas,"DejaVu Sans Mono",monospace}
.scroll{overflow-x:auto}
.scroll:focus-visible,.bp-entry:focus-visible{outline:2px solid var(--link)}
table{border-collapse:collapse;font-size:.875rem;font-variant-numeric:tabular-nums;min-width:100%}
th,td{padding:.35rem .7rem;text-align:left;vertical-align:top;border-bottom:1px solid var(--line)}
th{border-bottom:2px solid var(--soft);white-space:nowrap}
th.num,td.num{text-align:right;white-space:nowrap}
footer{border-top:1px solid var(--line);color:var(--soft);font-size:.85rem;padding:1rem 0 2.5rem;overflow-wrap:anywhere}
)css";

constexpr std::string_view narrow = R"css(
@media (max-width:60rem){
.layout{display:block;padding:0 1rem;max-width:50rem}
header{margin-bottom:0}
header h1{font-size:1.5rem;margin-top:1.2rem}
.toc{position:static;max-height:none;padding:.6rem .8rem;margin:1rem 0;background:var(--panel);
border:1px solid var(--line);border-radius:4px}
.toc a{padding:.3rem 0}
h2{font-size:1.25rem}
}
@media screen and (max-width:36rem){
table{font-size:.72rem}
th,td{padding:.25rem .15rem;overflow-wrap:break-word}
th,th.num{white-space:normal;vertical-align:bottom}
details.rows table{font-size:.6rem}
}
)css";

constexpr std::string_view print = R"css(
@media print{
body{font-size:10pt}
.layout{display:block;max-width:none;padding:0}
header,main,footer{max-width:none}
.toc,.tools,details.config,.tip,.bp-mark{display:none}
figure{break-inside:avoid;margin:.8rem 0 1.4rem}
figure svg{max-width:17cm;max-height:21cm;margin:0 auto}
figure.table{break-inside:auto}
tr{break-inside:avoid}
thead{display:table-header-group}
.scroll{overflow:visible}
h2{break-after:avoid}
a{color:inherit;text-decoration:none}
}
)css";

} // namespace

void append_page_style(std::string& css) {
  css += base;
  css += narrow;
  css += "@media screen and (prefers-color-scheme:dark){:root{--page:#16181c;--text:#e8e8e8;--soft:#a9aeb8;"
         "--line:#363a43;--panel:#1f2228;--link:#8cc0f5;\n";
  append_dark_variables(css);
  css += "}}\n";
  css += print;
}

} // namespace brdfplot::plot
