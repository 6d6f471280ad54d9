"""Other libraries, beside the kernels."""
