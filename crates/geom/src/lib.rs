//! Angles, planar poses, covariance ellipses and affine sets: the geometry under the filters.
