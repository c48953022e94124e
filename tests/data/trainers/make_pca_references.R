# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the references that tests/trainers/pca compares with:
#   Rscript make_pca_references.R
# reads logistic_NAME.csv of this folder (the label left out) and writes pca_NAME_SCALING.csv: what
# prcomp found, one line a component: its standard deviation, then its entries, of which the largest
# in magnitude is made positive. SCALING is none, or standard (scale. = TRUE). Made with R 4.2.2.
options(digits = 17)
for (name in c("iris", "heart", "decades")) {
  table <- read.csv(paste0("logistic_", name, ".csv"))
  features <- as.matrix(table[, colnames(table) != "label"])
  for (scaling in c("none", "standard")) {
    fit <- prcomp(features, scale. = scaling == "standard")
    lines <- vapply(seq_along(fit$sdev), function(k) {
      vector <- fit$rotation[, k]
      vector <- vector * sign(vector[which.max(abs(vector))])
      paste(sprintf("%.17g", c(fit$sdev[k], vector)), collapse = ",")
    }, "")
    writeLines(lines, paste0("pca_", name, "_", scaling, ".csv"))
  }
}
