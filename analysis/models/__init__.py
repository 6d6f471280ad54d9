"""CPUs that were not measured but modelled, by llvm-mca."""
