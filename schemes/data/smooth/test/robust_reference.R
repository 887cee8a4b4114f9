# Makes the values of robust_test.cpp: R's loess, lowess and bisquare steps on the data of reference_data() there.
# Run by: Rscript robust_reference.R (here R 4.2.2).
i <- 0:29
x <- (20 * i + (i * 7919) %% 13) / 20
y <- x * x / 40 + ((i * i * 7919) %% 101) / 100 + ifelse(i %% 6 == 2, 8, 0)
w <- 1 + (i * 5) %% 3
at <- c(1, 3, 9, 15, 22, 30)
show <- function(name, fit) cat(name, formatC(fit[at], digits = 15, format = "g"), "\n")
exact <- loess.control(surface = "direct", iterations = 4)
for (degree in 0:2) {
  show(paste("loess", degree), predict(loess(y ~ x, span = 0.5, degree = degree, family = "symmetric", control = exact), x))
}
show("weighted, one fit", predict(loess(y ~ x, weights = w, span = 0.5, degree = 1, control = exact), x))
show("lowess", lowess(x, y, f = 0.5, iter = 3, delta = 0)$y)
