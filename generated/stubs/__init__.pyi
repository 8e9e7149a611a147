"""What type checkers are told of the kernels. Made by `chasles emit`; not to be edited."""
