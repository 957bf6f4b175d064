"""The version of the package. A test compares it with build/Version.props, which is that of the project."""

__version__ = "0.1.0"
