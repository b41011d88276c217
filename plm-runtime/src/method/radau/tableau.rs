//! Coefficients of Radau IIA with three stages, and the transformation that splits its linear systems.
//!
//! Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, table IV.5.6 for the method, IV.8 and their
//! program RADAU5 for the rest. T^-1 A^-1 T has the blocks gamma and \[alpha, -beta; beta, alpha\].

const ROOT_6: f64 = 2.449_489_742_783_178;

/// Abscissae.
pub(super) const C: [f64; 3] = [(4.0 - ROOT_6) / 10.0, (4.0 + ROOT_6) / 10.0, 1.0];

/// The real eigenvalue of A^-1.
pub(super) const GAMMA: f64 = 3.637_834_252_744_496;
/// The complex pair, alpha +- i beta.
pub(super) const ALPHA: f64 = 2.681_082_873_627_752;
pub(super) const BETA: f64 = 3.050_430_199_247_410_5;

/// Columns: the real eigenvector, real and negative imaginary part of the complex one.
pub(super) const T: [[f64; 3]; 3] = [
    [9.123_239_487_089_294e-2, -1.412_552_950_209_542e-1, -3.002_919_410_514_742_4e-2],
    [2.417_179_327_071_07e-1, 2.041_293_522_937_999_4e-1, 3.829_421_127_572_619e-1],
    [9.660_481_826_150_93e-1, 1.0, 0.0],
];
/// T^-1.
pub(super) const T_INVERSE: [[f64; 3]; 3] = [
    [4.325_579_890_063_155, 3.391_992_518_158_098_4e-1, 5.417_705_399_358_749e-1],
    [-4.178_718_591_551_905, -3.276_828_207_610_624e-1, 4.766_235_545_005_504_4e-1],
    [-5.028_726_349_457_868e-1, 2.571_926_949_855_605, -5.960_392_048_282_249e-1],
];

/// Weights of the stages in the error estimate, of order 3 (the same, eq. (8.17)), with gamma put outside.
pub(super) const ERROR: [f64; 3] = [-(13.0 + 7.0 * ROOT_6) / 3.0, (-13.0 + 7.0 * ROOT_6) / 3.0, -1.0 / 3.0];
