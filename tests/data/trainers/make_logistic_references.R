# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the tables and reference fits that tests/trainers/logistic_irls compares with:
#   Rscript make_logistic_references.R FOLDER_WITH_uci_arff_AND_libsvm
# writes, into this folder, logistic_NAME.csv (features, then label 0/1) and logistic_NAME_glm.csv
# (what glm found: one line a coefficient, NA where aliased, then the deviances and AIC).
# Made with R 4.2.2.
options(digits = 17)
source_folder <- commandArgs(trailingOnly = TRUE)[1]

read_arff <- function(name) {
  lines <- readLines(file.path(source_folder, "uci_arff", name))
  rows <- lines[(grep("^@data", lines, ignore.case = TRUE) + 1):length(lines)]
  rows <- rows[nzchar(rows) & !startsWith(rows, "%")]
  read.csv(text = rows, header = FALSE, na.strings = "?", strip.white = TRUE)
}

# A table is written with 17 digits and read back, so that R fits exactly what the tests read.
make <- function(name, features, label) {
  colnames(features) <- paste0("x", seq_len(ncol(features)) - 1)
  table <- cbind(features, label = as.integer(label))
  path <- paste0("logistic_", name, ".csv")
  text <- vapply(table, function(column) sprintf("%.17g", column), character(nrow(table)))
  writeLines(c(paste(colnames(table), collapse = ","), apply(text, 1, paste, collapse = ",")), path)
  table <- read.csv(path)
  # glm's rank tolerance shrinks with epsilon, so what is aliased is found with the default.
  aliased <- is.na(coef(glm(label ~ ., data = table, family = binomial())))
  kept <- table[, !colnames(table) %in% names(aliased)[aliased]]
  fit <- glm(label ~ ., data = kept, family = binomial(),
             control = glm.control(epsilon = 1e-15, maxit = 100))
  estimates <- errors <- setNames(rep(NA_real_, length(aliased)), names(aliased))
  estimates[names(coef(fit))] <- coef(fit)
  errors[names(coef(fit))] <- summary(fit)$coefficients[, 2]
  lines <- c("term,estimate,standard_error",
             sprintf("%s,%.17g,%.17g", names(estimates), estimates, errors),
             sprintf("deviance,%.17g,NA", fit$deviance),
             sprintf("null_deviance,%.17g,NA", fit$null.deviance),
             sprintf("aic,%.17g,NA", fit$aic))
  writeLines(lines, paste0("logistic_", name, "_glm.csv"))
  cat(name, nrow(table), "rows", fit$iter, "iterations, converged", fit$converged, "\n")
}

iris <- read_arff("iris.arff")
iris <- iris[grepl("versicolor|virginica", iris[, 5]), ]
make("iris", iris[, 1:4], grepl("virginica", iris[, 5]))

breast <- na.omit(read_arff("breast.w.arff"))
make("breast_w", breast[, 1:9], breast[, 10] == "malignant")

heart_lines <- strsplit(readLines(file.path(source_folder, "libsvm", "heart_scale")), " ")
heart <- matrix(0, length(heart_lines), 13)
for (i in seq_along(heart_lines)) {
  for (entry in heart_lines[[i]][-1]) {
    pair <- as.numeric(strsplit(entry, ":")[[1]])
    heart[i, pair[1]] <- pair[2]
  }
}
make("heart", as.data.frame(heart), sapply(heart_lines, function(words) words[1] == "+1"))

set.seed(1)
n <- 400
draw <- function(score) runif(length(score)) < 1 / (1 + exp(-score))

# Two features that differ by one part in ten thousand, and one close to a sum of two others.
z <- matrix(rnorm(n * 4), n)
collinear <- data.frame(z[, 1], z[, 1] + 1e-4 * rnorm(n), z[, 2], z[, 3],
                        z[, 2] + z[, 3] + 1e-3 * z[, 4])
make("collinear", collinear, draw(0.3 + z[, 1] - 0.5 * z[, 2] + z[, 3]))

# Features from 1e-9 to 1e9 with means far from zero, hence weights over eighteen decades.
z <- matrix(rnorm(n * 5), n)
scale <- 10^c(-9, -4, 0, 4, 9)
make("decades", as.data.frame(sweep(z + 3, 2, scale, "*")), draw(z %*% c(1, -1, 0.5, 0.2, -2) - 0.4))

# A copy, a constant and an exact sum: glm leaves their coefficients NA.
z <- matrix(round(rnorm(n * 3) * 64) / 64, n)
make("aliased", data.frame(z[, 1], z[, 2], z[, 1], 5, z[, 3], z[, 1] + z[, 3]),
     draw(z %*% c(1, -0.7, 0.4)))
