// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

namespace handcraft::experiments {

/// The parts of the grasp-point report, with {named} places as fmt::format fills them. What is
/// filled in is escaped by the caller.

inline constexpr std::string_view kHeaderTemplate = R"html(<header>
<p class="kicker">Handcraft · grasp-point evaluation</p>
<h1>{model}</h1>
<p class="lead">Judged on {images} of <em>{data}</em>, every pixel scored by the runtime. {verdict}</p>
</header>
)html";

inline constexpr std::string_view kTileTemplate =
    R"html(<div class="tile"><span class="name">{name}</span><span class="value">{value}</span><span class="range">{range}</span></div>
)html";

inline constexpr std::string_view kFiguresTemplate = R"html(<h2>By class</h2>
<p class="note">Brackets hold 95 % intervals, from resampling whole images. Don’t-care pixels are shown and not counted.</p>
<div class="scroll"><table>
<thead><tr><th>Class</th><th class="number">Images</th><th class="number">Without<br>best pixel</th><th class="number">Best pixels<br>good / counted</th><th class="number">Don’t<br>care</th><th class="number">Best-pixel<br>accuracy</th><th class="number">Pixel<br>accuracy</th><th class="number">ROC area</th><th class="number">Log-loss</th><th class="number">Brier</th></tr></thead>
<tbody>
{rows}</tbody></table></div>
)html";

inline constexpr std::string_view kFiguresRowTemplate =
    R"html(<tr{row_class}><th scope="row">{name}</th><td class="number">{images}</td><td class="number">{silent}</td><td class="number">{good} / {counted}</td><td class="number">{dont_care}</td><td class="number">{best}<span class="range">{best_range}</span></td><td class="number">{accuracy}<span class="range">{accuracy_range}</span></td><td class="number">{auc}<span class="range">{auc_range}</span></td><td class="number">{log_loss}<span class="range">{log_loss_range}</span></td><td class="number">{brier}<span class="range">{brier_range}</span></td></tr>
)html";

inline constexpr std::string_view kConfusionTemplate = R"html(<table class="confusion">
<thead><tr><th></th><th scope="col">called good<br>(above {threshold})</th><th scope="col">called bad</th></tr></thead>
<tbody>
<tr><th class="side" scope="row">labelled good</th>{true_positive}{false_negative}</tr>
<tr><th class="side" scope="row">labelled bad</th>{false_positive}{true_negative}</tr>
</tbody></table>
)html";

inline constexpr std::string_view kPixelCardsTemplate =
    R"html(<figure class="card"><h3>Confusion matrix</h3>
{confusion}<figcaption>Counts, and their share of the row with its 95 % interval.</figcaption></figure>
<figure class="card"><h3>Confusion matrix, strict</h3>
{strict_confusion}<figcaption>At the probability that best pixels must exceed.</figcaption></figure>
<figure class="card"><h3>ROC curve, area {auc}</h3>
{roc}<figcaption>Band: 95 % over images, up and down. The dashed line is guessing.</figcaption></figure>
<figure class="card"><h3>Precision and recall, average precision {average_precision}</h3>
{precision_recall}<figcaption>Band: 95 % over images, up and down. Guessing gives the share of good pixels, one half here.</figcaption></figure>
<figure class="card"><h3>Reliability, Brier score {brier}</h3>
{reliability}<figcaption>Bars: 95 % over images. On the dashed line a probability means what it says, were good and bad pixels equally common.</figcaption></figure>
)html";

inline constexpr std::string_view kPlotsTemplate = R"html(<h2>Pixel by pixel</h2>
<p class="note">{pixels} labelled pixels, as many good as bad in each image that has both.</p>
<div class="plots">
{cards}<figure class="card"><h3>Probabilities of good and bad pixels</h3>
{histogram}<figcaption><span class="key first"></span>labelled good&ensp; <span class="key second"></span>labelled bad</figcaption></figure>
</div>
)html";

inline constexpr std::string_view kGalleryTemplate = R"html(<h2>Image by image</h2>
<p class="note">Large: the probability of a grasp point, warm, and the best pixels, numbered. Small, left: the labels, green good, blue don’t care. Right: around the best pixel, each best pixel ringed green on good, red on bad, blue on don’t-care ground.{shown}</p>
<div class="gallery">
{cards}</div>
)html";

inline constexpr std::string_view kPictureTemplate = R"html(<figure class="card">
<img class="overlay" alt="Probability map and best pixels of {name}" src="{overlay}">
<div class="pair"><img alt="Labels of {name}" src="{mask}">{close_up}</div>
<figcaption><strong>{name}</strong> · {class}<br>{verdict}</figcaption>
</figure>
)html";

inline constexpr std::string_view kCloseUpTemplate =
    R"html(<img alt="Close-up of the best pixels of {name}" src="{close_up}">)html";

inline constexpr std::string_view kModelTemplate = R"html(<h2>The model</h2>
<dl>
{facts}</dl>
)html";

inline constexpr std::string_view kMethodTemplate = R"html(<h2>How it was measured</h2>
<dl>
<dt>Best-pixel accuracy</dt><dd>In each image the up to {best_pixels} pixels of highest probability, each above {min_probability}{suppression}, over the whole image. Those on good ground, out of those on good or bad ground, all images together. An image with fewer such pixels counts with those it has.</dd>
<dt>Pixel figures</dt><dd>Up to {half} good and as many bad pixels drawn from each image. A pixel is called good above probability {threshold}.</dd>
<dt>Intervals</dt><dd>95 %, percentile bootstrap over images, {resamples} resamples: pixels of one image are alike, images are what varies. Where all images agree on 0 % or 100 %, the Wilson interval for that many images; none for a single image.</dd>
<dt>Seed</dt><dd>{seed}</dd>
<dt>Data fingerprint</dt><dd><code>{fingerprint}</code></dd>
</dl>
<footer>This page stands alone: no script, nothing loaded from elsewhere.</footer>
)html";

}  // namespace handcraft::experiments
